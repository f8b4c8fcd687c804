//! Axes of charts. Written here because the chart crate at hand cannot draw hollow points (an outline in another
//! colour than the fill), and because charts then share font, line widths and label places with the drawings.

use crate::elevation::INK;
use crate::sheet::{Anchor, Area, HAIR, MARGIN, MEDIUM, Pen, SMALL, Sheet, Spot, Style, WIDTH, font};
use crate::ticks::Ticks;
use crate::words::four_digits;

#[derive(Debug, Clone, PartialEq)]
pub struct Axis<'a> {
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
    pub fn round(name: &'a str, ticks: Ticks) -> Axis<'a> {
        Axis { name, range: ticks.range(), ticks, logarithmic: false }
    }
    /// Exactly from `low` to `high`, both above zero, by their logarithms; ticks at 1, 2 and 5, or at powers of ten alone where
    /// there are many.
    pub fn logarithmic(name: &'a str, low: f64, high: f64) -> Axis<'a> {
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
    /// A value as it stands at the axis.
    pub fn words(&self, value: f64) -> String {
        if self.logarithmic { four_digits(value) } else { self.ticks.words(value) }
    }
    /// Exactly from `low` to `high`, with about `count` steps.
    pub fn exact(name: &'a str, low: f64, high: f64, count: usize) -> Axis<'a> {
        let ticks = Ticks::over(low, high, count);
        // Without width there is nothing to be exact about.
        let inside = ticks.inside(low, high);
        if high > low && inside.values.len() > 1 {
            Axis { name, range: [low, high], ticks: inside, logarithmic: false }
        } else {
            Axis::round(name, ticks)
        }
    }
}

/// The plane of a chart on the sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct Axes {
    /// Where the curves are.
    pub area: Area,
    x: Span,
    y: Span,
}

/// Range of an axis and how it is divided.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Span {
    range: [f64; 2],
    logarithmic: bool,
}

impl Span {
    fn of(axis: &Axis) -> Span {
        Span { range: axis.range, logarithmic: axis.logarithmic }
    }
    /// Share of the way along the axis.
    fn share(self, value: f64) -> f64 {
        let [low, high] = self.range;
        if self.logarithmic { (value / low).ln() / (high / low).ln() } else { (value - low) / (high - low) }
    }
}

/// Which words stand beside the frame of a chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Words {
    /// Values and name below.
    pub x: bool,
    /// Values to the left.
    pub y: bool,
    /// Where the name to the left stands, if it does.
    pub y_name: Option<f64>,
}

impl Axes {
    /// Draws frame, grid, ticks and names below `top`. Returns the axes and the y below their name.
    pub fn draw(sheet: &mut Sheet, top: f64, height: f64, x: &Axis, y: &Axis) -> (Axes, f64) {
        let widest = Axes::widest(y);
        Axes::panel(sheet, [top, height], [x, y], Some(widest), true)
    }

    /// Width of the widest word along an axis.
    pub fn widest(y: &Axis) -> f64 {
        let wide = |v: &f64| font::width(&y.words(*v), SMALL, Style::default().weight);
        y.ticks.values.iter().map(wide).fold(0.0, f64::max)
    }

    /// The same for one of several panels, whose words to the left take `widest`; words along x only where it is the lowest.
    pub fn panel(
        sheet: &mut Sheet,
        [top, height]: [f64; 2],
        [x, y]: [&Axis; 2],
        widest: Option<f64>,
        lowest: bool,
    ) -> (Axes, f64) {
        let widest = widest.unwrap_or_else(|| Axes::widest(y));
        let area = Area {
            left: MARGIN + 24.0 + widest + 8.0,
            right: WIDTH - MARGIN - 16.0,
            top: top + 6.0,
            bottom: top + 6.0 + height,
        };
        let axes = Axes::within(sheet, area, x, y, Words { x: lowest, y: true, y_name: Some(MARGIN + 12.0) });
        (axes, area.bottom + if lowest { 50.0 } else { 8.0 })
    }

    /// Draws frame, grid, ticks and words around an area.
    pub fn within(sheet: &mut Sheet, area: Area, x: &Axis, y: &Axis, words: Words) -> Axes {
        let small = Style { size: SMALL, ..Style::default() };
        let axes = Axes { area, x: Span::of(x), y: Span::of(y) };
        sheet.open("axes");
        for &v in &x.ticks.values {
            let [at, _] = axes.spot(v, y.range[0]);
            sheet.line([at, area.top], [at, area.bottom], Pen::line("#d8d8d8", HAIR));
            sheet.line([at, area.bottom], [at, area.bottom + 5.0], Pen::line(INK, 0.9));
            if words.x {
                sheet.text([at, area.bottom + 19.0], &x.words(v), small.anchored(Anchor::Middle));
            }
        }
        for &v in &y.ticks.values {
            let [_, at] = axes.spot(x.range[0], v);
            sheet.line([area.left, at], [area.right, at], Pen::line("#d8d8d8", HAIR));
            sheet.line([area.left - 5.0, at], [area.left, at], Pen::line(INK, 0.9));
            if words.y {
                sheet.text([area.left - 8.0, at + 4.4], &y.words(v), small.anchored(Anchor::End));
            }
        }
        sheet.rectangle(area, Pen::line(INK, 0.9));
        let name = Style::default().anchored(Anchor::Middle);
        if words.x {
            sheet.text([0.5 * (area.left + area.right), area.bottom + 40.0], x.name, name);
        }
        if let Some(left) = words.y_name {
            sheet.text_upwards([left, 0.5 * (area.top + area.bottom)], y.name, name);
        }
        sheet.close();
        axes
    }
    /// Where a value is drawn.
    pub fn spot(&self, x: f64, y: f64) -> Spot {
        let Area { left, right, top, bottom } = self.area;
        [left + self.x.share(x) * (right - left), bottom - self.y.share(y) * (bottom - top)]
    }
}

/// Marks of points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// A filled circle.
    Full,
    /// An open circle.
    Hollow,
    /// A larger ring around a mark.
    Ring,
}

impl Mark {
    pub fn draw(self, sheet: &mut Sheet, at: Spot, colour: &str) {
        match self {
            Mark::Full => sheet.circle(at, 3.6, Pen::shape(colour, colour, MEDIUM).class("point")),
            Mark::Hollow => sheet.circle(at, 3.6, Pen::shape("white", colour, 1.5).class("point hollow")),
            Mark::Ring => sheet.circle(at, 8.0, Pen::line(INK, MEDIUM).class("marked")),
        }
    }
}

/// One entry of a chart's key: a line, a mark, or both, and its words.
pub struct Entry<'a> {
    /// Line colour and dashes.
    pub line: Option<(&'a str, &'a str)>,
    /// Mark and colour.
    pub mark: Option<(Mark, &'a str)>,
    /// What it means.
    pub text: &'a str,
}

/// A row of entries; returns the y below it.
pub fn key(sheet: &mut Sheet, top: f64, entries: &[Entry]) -> f64 {
    let style = Style { size: SMALL, ..Style::default() };
    let (mut x, mut y) = (MARGIN, top + 14.0);
    sheet.open("key");
    for entry in entries {
        let wide = 42.0 + font::width(entry.text, style.size, style.weight);
        if x > MARGIN && x + wide > WIDTH - MARGIN {
            x = MARGIN;
            y += 18.0;
        }
        if let Some((colour, dashes)) = entry.line {
            sheet.line([x + 2.0, y - 4.0], [x + 32.0, y - 4.0], Pen::line(colour, 1.8).dashed(dashes));
        }
        if let Some((mark, colour)) = entry.mark {
            mark.draw(sheet, [x + 17.0, y - 4.0], colour);
        }
        sheet.text([x + 38.0, y], entry.text, style);
        x += wide + 18.0;
    }
    sheet.close();
    y + 8.0
}
