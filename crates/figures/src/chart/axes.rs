//! Axes of charts. Written here because the chart crate at hand cannot draw hollow points (an outline in another
//! colour than the fill), and because charts then share font, line widths and label places with the drawings.

use crate::elevation::INK;
use crate::sheet::{Anchor, Area, HAIR, MARGIN, Pen, Sheet, Spot, Style};
use crate::ticks::Ticks;
use crate::words::four_digits;

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Axis<'a> {
    /// What it measures, with its unit.
    pub name: &'a str,
    /// First and last value.
    pub range: [f64; 2],
    /// Ticks within the range.
    pub ticks: Ticks,
    /// Whether equal ratios are equal lengths.
    pub logarithmic: bool,
}

impl<'a> Axis<'a> {
    /// From the first to the last tick.
    pub(crate) fn round(name: &'a str, ticks: Ticks) -> Axis<'a> {
        Axis { name, range: ticks.range(), ticks, logarithmic: false }
    }
    /// From `low` to `high` without a word.
    pub(crate) const fn blank(low: f64, high: f64) -> Axis<'a> {
        Axis { name: "", range: [low, high], ticks: Ticks { values: Vec::new(), decimals: 0 }, logarithmic: false }
    }
    /// Exactly from `low` to `high`, both above zero, by their logarithms; ticks at 1, 2 and 5, or at powers of ten alone where
    /// there are many.
    pub(crate) fn logarithmic(name: &'a str, low: f64, high: f64) -> Axis<'a> {
        if !(low > 0.0 && high > low && high.is_finite()) {
            return Axis::exact(name, low, high, 5);
        }
        let leads: &[f64] = if high / low < 1e3 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let powers = low.log10().floor() as i32..=high.log10().ceil() as i32;
        let values = powers.flat_map(|power| leads.iter().map(move |lead| lead * 10f64.powi(power)));
        let slack = 1.0 + 1e-9;
        let values: Vec<f64> = values.filter(|v| *v >= low / slack && *v <= high * slack).collect();
        Axis { name, range: [low, high], ticks: Ticks { values, decimals: 0 }, logarithmic: true }
    }
    /// Exactly from `low` to `high`, with about `count` steps.
    pub(crate) fn exact(name: &'a str, low: f64, high: f64, count: usize) -> Axis<'a> {
        let ticks = Ticks::over(low, high, count);
        // Without width there is nothing to be exact about.
        let inside = ticks.inside(low, high);
        if high > low && inside.values.len() > 1 {
            Axis { name, range: [low, high], ticks: inside, logarithmic: false }
        } else {
            Axis::round(name, ticks)
        }
    }
    /// A value as it stands at the axis.
    pub(crate) fn words(&self, value: f64) -> String {
        if self.logarithmic { four_digits(value) } else { self.ticks.words(value) }
    }
    /// Width of its widest word.
    pub(crate) fn widest(&self) -> f64 {
        let wide = |v: &f64| Style::small().width(&self.words(*v));
        self.ticks.values.iter().map(wide).fold(0.0, f64::max)
    }
    /// Whether a value lies on it.
    pub(crate) fn holds(&self, value: f64) -> bool {
        (self.range[0]..=self.range[1]).contains(&value)
    }
    /// Share of the way along the axis.
    pub(crate) fn share(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        if self.logarithmic { (value / low).ln() / (high / low).ln() } else { (value - low) / (high - low) }
    }
}

/// The plane of a chart on the sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Axes<'a> {
    /// Where the curves are.
    pub area: Area,
    pub x: &'a Axis<'a>,
    pub y: &'a Axis<'a>,
}

/// How far below the frame the name of an axis stands.
pub(crate) const NAME: f64 = 40.0;

impl<'a> Axes<'a> {
    /// The left edge of a plane beside words of a width.
    pub(crate) fn left(widest: f64) -> f64 {
        MARGIN + 24.0 + widest + 8.0
    }
    /// Of one axis, which lies below an area; its name stands so far below the frame.
    pub(crate) fn across(sheet: &mut Sheet, area: Area, x: &'a Axis<'a>, name: f64) -> Axes<'a> {
        static BLANK: Axis = Axis::blank(0.0, 1.0);
        let axes = Axes { area, x, y: &BLANK };
        axes.draw(sheet, Some(name), None);
        axes
    }

    /// Draws frame, grid and ticks; values below the frame with the name so far below it, and values to its left, of the widest of
    /// which the name keeps clear.
    pub(crate) fn draw(&self, sheet: &mut Sheet, below: Option<f64>, widest: Option<f64>) {
        let small = Style::small();
        let Axes { area, x, y } = *self;
        sheet.open("axes");
        for &v in &x.ticks.values {
            let [at, _] = self.spot([v, y.range[0]]);
            sheet.line([at, area.top], [at, area.bottom], Pen::line("#d8d8d8", HAIR));
            sheet.line([at, area.bottom], [at, area.bottom + 5.0], Pen::line(INK, 0.9));
            if below.is_some() {
                sheet.text([at, area.bottom + 19.0], &x.words(v), small.anchored(Anchor::Middle));
            }
        }
        for &v in &y.ticks.values {
            let [_, at] = self.spot([x.range[0], v]);
            sheet.line([area.left, at], [area.right, at], Pen::line("#d8d8d8", HAIR));
            sheet.line([area.left - 5.0, at], [area.left, at], Pen::line(INK, 0.9));
            if widest.is_some() {
                sheet.text([area.left - 8.0, at + 4.4], &y.words(v), small.anchored(Anchor::End));
            }
        }
        sheet.rectangle(area, Pen::line(INK, 0.9));
        let name = Style::default().anchored(Anchor::Middle);
        if let Some(below) = below {
            sheet.text([0.5 * (area.left + area.right), area.bottom + below], x.name, name);
        }
        if let Some(widest) = widest {
            sheet.text_upwards([area.left - widest - 20.0, 0.5 * (area.top + area.bottom)], y.name, name);
        }
        sheet.close();
    }
    /// Where a value of the axis below is drawn.
    pub(crate) fn x(&self, value: f64) -> f64 {
        self.area.left + self.x.share(value) * (self.area.right - self.area.left)
    }
    /// Where a place of the plane is drawn.
    pub(crate) fn spot(&self, [x, y]: [f64; 2]) -> Spot {
        let Area { top, bottom, .. } = self.area;
        [self.x(x), bottom - self.y.share(y) * (bottom - top)]
    }
    /// Where places of the plane are drawn.
    pub(crate) fn spots(&self, places: &[[f64; 2]]) -> Vec<Spot> {
        places.iter().map(|place| self.spot(*place)).collect()
    }
}
