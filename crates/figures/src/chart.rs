//! Axes of charts. Written here because the chart crate at hand cannot draw hollow points (an outline in another
//! colour than the fill), and because charts then share font, line widths and label places with the drawings.

use crate::elevation::INK;
use crate::sheet::{Anchor, Area, HAIR, MARGIN, MEDIUM, Pen, SMALL, Sheet, Spot, Style, WIDTH, font};
use crate::ticks::Ticks;

/// One axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis<'a> {
    /// What it measures, with its unit.
    pub name: &'a str,
    /// First and last value.
    pub range: [f64; 2],
    /// Ticks within the range.
    pub ticks: Ticks,
}

impl<'a> Axis<'a> {
    /// From the first to the last tick.
    pub fn round(name: &'a str, ticks: Ticks) -> Axis<'a> {
        Axis { name, range: ticks.range(), ticks }
    }
    /// Exactly from `low` to `high`, with about `count` steps.
    pub fn exact(name: &'a str, low: f64, high: f64, count: usize) -> Axis<'a> {
        let ticks = Ticks::over(low, high, count);
        // Without width there is nothing to be exact about.
        let inside = ticks.inside(low, high);
        if high > low && inside.values.len() > 1 {
            Axis { name, range: [low, high], ticks: inside }
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
    x: [f64; 2],
    y: [f64; 2],
}

impl Axes {
    /// Draws frame, grid, ticks and names below `top`. Returns the axes and the y below their name.
    pub fn draw(sheet: &mut Sheet, top: f64, height: f64, x: &Axis, y: &Axis) -> (Axes, f64) {
        let widest = Axes::widest(y);
        Axes::panel(sheet, top, height, x, y, Some(widest), true)
    }

    /// Width of the widest word along an axis.
    pub fn widest(y: &Axis) -> f64 {
        let wide = |v: &f64| font::width(&y.ticks.words(*v), SMALL, Style::default().weight);
        y.ticks.values.iter().map(wide).fold(0.0, f64::max)
    }

    /// The same for one of several panels, whose words to the left take `widest`; words along x only where it is the lowest.
    pub fn panel(
        sheet: &mut Sheet,
        top: f64,
        height: f64,
        x: &Axis,
        y: &Axis,
        widest: Option<f64>,
        lowest: bool,
    ) -> (Axes, f64) {
        let small = Style { size: SMALL, ..Style::default() };
        let widest = widest.unwrap_or_else(|| Axes::widest(y));
        let area = Area {
            left: MARGIN + 24.0 + widest + 8.0,
            right: WIDTH - MARGIN - 16.0,
            top: top + 6.0,
            bottom: top + 6.0 + height,
        };
        let axes = Axes { area, x: x.range, y: y.range };
        sheet.open("axes");
        for &v in &x.ticks.values {
            let [at, _] = axes.spot(v, axes.y[0]);
            sheet.line([at, area.top], [at, area.bottom], Pen::line("#d8d8d8", HAIR));
            sheet.line([at, area.bottom], [at, area.bottom + 5.0], Pen::line(INK, 0.9));
            if lowest {
                sheet.text([at, area.bottom + 19.0], &x.ticks.words(v), small.anchored(Anchor::Middle));
            }
        }
        for &v in &y.ticks.values {
            let [_, at] = axes.spot(axes.x[0], v);
            sheet.line([area.left, at], [area.right, at], Pen::line("#d8d8d8", HAIR));
            sheet.line([area.left - 5.0, at], [area.left, at], Pen::line(INK, 0.9));
            sheet.text([area.left - 8.0, at + 4.4], &y.ticks.words(v), small.anchored(Anchor::End));
        }
        sheet.rectangle(area, Pen::line(INK, 0.9));
        let name = Style::default().anchored(Anchor::Middle);
        if lowest {
            sheet.text([0.5 * (area.left + area.right), area.bottom + 40.0], x.name, name);
        }
        sheet.text_upwards([MARGIN + 12.0, 0.5 * (area.top + area.bottom)], y.name, name);
        sheet.close();
        (axes, area.bottom + if lowest { 50.0 } else { 8.0 })
    }
    /// Where a value is drawn.
    pub fn spot(&self, x: f64, y: f64) -> Spot {
        let share = |v: f64, r: [f64; 2]| (v - r[0]) / (r[1] - r[0]);
        let Area { left, right, top, bottom } = self.area;
        [left + share(x, self.x) * (right - left), bottom - share(y, self.y) * (bottom - top)]
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
    /// Draws it.
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
