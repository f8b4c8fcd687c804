//! Keys: rows of signs and what they mean.

use super::Mark;
use crate::sheet::{MARGIN, Pen, Sheet, Spot, Style, WIDTH};
use std::borrow::Cow;

/// How a key is set out.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Key {
    /// Class of its group.
    pub class: &'static str,
    /// From the top to the foot of the first row.
    pub above: f64,
    /// From the left end of a sign to its words.
    pub words: f64,
    /// What a sign takes beside its words, and the least gap to the next one.
    pub wide: f64,
    /// See above.
    pub gap: f64,
    /// From the foot of the last row to what follows.
    pub below: f64,
}

impl Key {
    /// Of charts.
    pub(crate) const CHART: Key = Key { class: "key", above: 14.0, words: 38.0, wide: 42.0, gap: 18.0, below: 8.0 };
    /// Of elevations.
    pub(crate) const ELEVATION: Key = Key { class: "key", above: 12.0, words: 26.0, wide: 30.0, gap: 18.0, below: 6.0 };

    /// Draws rows of entries; `sign` draws one whose left end lies at a spot on the foot of its row. Returns the y below.
    pub(crate) fn draw<T>(
        &self,
        sheet: &mut Sheet,
        top: f64,
        entries: impl IntoIterator<Item = (T, impl AsRef<str>)>,
        sign: impl Fn(&mut Sheet, Spot, T),
    ) -> f64 {
        let style = Style::small();
        let [mut x, mut y] = [MARGIN, top + self.above];
        sheet.open(self.class);
        for (what, words) in entries {
            let wide = self.wide + style.width(words.as_ref());
            if x > MARGIN && x + wide > WIDTH - MARGIN {
                [x, y] = [MARGIN, y + 18.0];
            }
            sign(sheet, [x, y], what);
            sheet.text([x + self.words, y], words.as_ref(), style);
            x += wide + self.gap;
        }
        sheet.close();
        y + self.below
    }
}

/// One entry of a chart's key: a line, a mark, or both, and its words.
pub(crate) struct Entry<'a> {
    line: Option<Pen<'a>>,
    mark: Option<(Mark, &'a str)>,
    text: Cow<'a, str>,
    there: bool,
}

impl<'a> Entry<'a> {
    /// A line by its colour and dashes.
    pub(crate) fn line((colour, dashes): (&'a str, &'a str), text: impl Into<Cow<'a, str>>) -> Entry<'a> {
        Entry { line: Some(Pen::line(colour, 1.8).dashed(dashes)), mark: None, text: text.into(), there: true }
    }
    /// A mark in a colour.
    pub(crate) fn mark(mark: Mark, colour: &'a str, text: impl Into<Cow<'a, str>>) -> Entry<'a> {
        Entry { line: None, mark: Some((mark, colour)), text: text.into(), there: true }
    }
    /// The same where there is something that it stands for.
    pub(crate) fn when(self, there: bool) -> Entry<'a> {
        Entry { there, ..self }
    }
    /// The same on its line.
    pub(crate) fn marked(self, mark: Mark, colour: &'a str) -> Entry<'a> {
        Entry { mark: Some((mark, colour)), ..self }
    }
}

/// The key of a chart; returns the y below it.
pub(crate) fn key(sheet: &mut Sheet, top: f64, entries: &[Entry]) -> f64 {
    let there = entries.iter().filter(|entry| entry.there).map(|entry| (entry, &entry.text));
    Key::CHART.draw(sheet, top, there, |sheet, [x, y], entry| {
        if let Some(pen) = entry.line {
            sheet.line([x + 2.0, y - 4.0], [x + 32.0, y - 4.0], pen);
        }
        if let Some((mark, colour)) = entry.mark {
            mark.draw(sheet, [x + 17.0, y - 4.0], colour);
        }
    })
}
