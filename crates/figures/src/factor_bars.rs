//! Factors on loads as bars, with a line where the factor is one.

use crate::chart::Axis;
use crate::elevation::INK;
use crate::sheet::{Anchor, Area, HAIR, MARGIN, MEDIUM, Pen, Sheet, Style, WIDTH};

/// Of bars that reach the line.
pub(crate) const ENOUGH: &str = "#1f5fa8";
/// Of bars that do not.
pub(crate) const SHORT: &str = "#a02020";
const ROW: f64 = 20.0;
/// Longest label; what is longer is cut.
const LONGEST: usize = 44;

/// A bar.
pub(crate) struct Bar<'a> {
    /// What it is of.
    pub label: &'a str,
    /// Its factor.
    pub factor: f64,
    /// A larger factor by another method, drawn as an outline.
    pub beyond: Option<f64>,
}

/// The bars from top to bottom as SVG, under title and second line, with words below; none without bars.
pub(crate) fn factor_bars(name: &str, titles: [&str; 2], axis: &str, bars: &[Bar<'_>], words: &str) -> Option<String> {
    if bars.is_empty() {
        return None;
    }
    let most = bars.iter().map(|b| b.beyond.unwrap_or(b.factor).max(b.factor)).fold(1.0, f64::max);
    let (mut sheet, top) = Sheet::titled(name, titles[0], titles[1]);
    let small = Style::small();
    let short = |label: &str| match label.chars().count() > LONGEST {
        true => label.chars().take(LONGEST - 1).chain(['…']).collect(),
        false => label.to_owned(),
    };
    let names = bars.iter().map(|b| small.width(&short(b.label))).fold(60.0, f64::max);
    let area = Area {
        left: MARGIN + names + 10.0,
        right: WIDTH - MARGIN - 46.0,
        top: top + 8.0,
        bottom: top + 8.0 + ROW * bars.len() as f64 + 8.0,
    };
    let axis = Axis::exact(axis, 0.0, 1.05 * most, 7);
    let x = |value: f64| area.left + (area.right - area.left) * value / axis.range[1];
    sheet.open("axes");
    for &value in &axis.ticks.values {
        sheet.line([x(value), area.top], [x(value), area.bottom], Pen::line("#d8d8d8", HAIR));
        sheet.text([x(value), area.bottom + 16.0], &axis.words(value), small.anchored(Anchor::Middle));
    }
    sheet.close();
    for (k, Bar { label, factor, beyond }) in bars.iter().enumerate() {
        let middle = area.top + 4.0 + ROW * (k as f64 + 0.5);
        let colour = if *factor < 1.0 { SHORT } else { ENOUGH };
        if let Some(beyond) = beyond.filter(|beyond| beyond > factor) {
            let outline = Area { left: x(*factor), right: x(beyond), top: middle - 6.0, bottom: middle + 6.0 };
            sheet.rectangle(outline, Pen::shape("none", colour, HAIR).class("rigid"));
        }
        let bar = Area { left: area.left, right: x(*factor), top: middle - 6.0, bottom: middle + 6.0 };
        sheet.rectangle(bar, Pen::shape(colour, "none", 0.0).class("vehicle"));
        sheet.text([area.left - 8.0, middle + 4.4], &short(label), small.anchored(Anchor::End));
    }
    sheet.line([x(1.0), area.top - 4.0], [x(1.0), area.bottom], Pen::line(INK, MEDIUM).dashed("5 4").class("one"));
    // Numbers stand on the line where they meet it.
    for (k, bar) in bars.iter().enumerate() {
        let foot = area.top + 4.0 + ROW * (k as f64 + 0.5) + 4.4;
        sheet.text([x(bar.factor) + 6.0, foot], &format!("{:.3}", bar.factor), Style { halo: true, ..small });
    }
    sheet.line([area.left, area.top], [area.left, area.bottom], Pen::line(INK, 0.9));
    let middle = 0.5 * (area.left + area.right);
    sheet.text([middle, area.bottom + 36.0], axis.name, Style::default().anchored(Anchor::Middle));
    let bottom = sheet.paragraph(MARGIN, area.bottom + 56.0, WIDTH - 2.0 * MARGIN, words, small);
    Some(sheet.finish(bottom + 4.0))
}

/// Factors of named cases, in their order.
pub fn case_factors(bridge: &str, cases: &[(String, f64)]) -> Option<String> {
    let bars: Vec<Bar<'_>> =
        cases.iter().map(|(name, factor)| Bar { label: name, factor: *factor, beyond: None }).collect();
    let words = "right of the dashed line a case is carried with its own factors; cases without a factor are in the table alone";
    factor_bars("cases", [bridge, "Factor on the loads of each named case"], "factor on loads [–]", &bars, words)
}
