//! Headings of panels: a name in bold and words about it.

use crate::sheet::{Sheet, Spot, Style};

/// A name, and words about it where there are to be any.
pub(crate) type Heading = (String, Option<String>);

/// Height of a line.
pub(crate) const HEADING: f64 = 17.0;

/// Name and words, these beside the name where there is room up to `right` and below it otherwise; `at` is where the last line
/// begins.
pub(crate) fn heading(sheet: &mut Sheet, at: Spot, right: f64, told: &Heading) {
    let (name, words) = (&told.0, told.1.as_deref().unwrap_or_default());
    if heading_lines(at[0], right, told) == 1.0 {
        sheet.text(at, name, Style::bold());
        sheet.text([at[0] + name_width(name), at[1]], words, Style::grey());
    } else {
        sheet.text([at[0], at[1] - HEADING], name, Style::bold());
        let shown = Style::small().shortened(words, right - at[0], str::to_owned).unwrap_or_default();
        sheet.text(at, &shown, Style::grey());
    }
}

/// How many lines a heading needs.
pub(crate) fn heading_lines(left: f64, right: f64, (name, words): &Heading) -> f64 {
    let fits = |words: &String| left + name_width(name) + Style::small().width(words) <= right;
    if words.as_ref().is_none_or(fits) { 1.0 } else { 2.0 }
}

/// Width of a name with the gap beside it.
fn name_width(name: &str) -> f64 {
    Style::bold().width(name) + 14.0
}
