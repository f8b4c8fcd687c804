//! Records over time, and influence lines: one panel below the other.

use crate::chart::{Axes, Axis, Mark};
use crate::elevation::INK;
use crate::sheet::place::Room;
use crate::sheet::{HAIR, MARGIN, Pen, Sheet, Spot, Style, font::Weight};
use crate::thinned::thinned;
use crate::ticks::Ticks;
use crate::words;
use outcome::passage::{Passage, SensorRecord};

/// Height of a panel.
const HEIGHT: f64 = 92.0;
/// Most panels on a sheet; tables have all channels.
const MOST: usize = 12;
/// Colour of curves.
const CURVE: &str = "#0b5394";

/// Every channel over time, its peak marked; none without a record.
pub fn records(passage: &Passage) -> Option<String> {
    let end = *passage.times.last()?;
    let mut sheet = Sheet::new("records");
    let second = format!(
        "{} at {} km/h, {}; self-weight taken off; {} positions",
        passage.train,
        words::three_digits(3.6 * passage.speed),
        passage.analysis,
        passage.times.len()
    );
    let top = sheet.title(&passage.bridge, &second);
    let x = Axis::exact("time since the first axle stood at the start [s]", 0.0, end.max(1e-6), 8);
    let curves: Vec<Curve> = passage.channels.iter().map(|channel| Curve::of(channel, &channel.values)).collect();
    let bottom = stacked(&mut sheet, top, (&x, &passage.times), &curves, &[], |time| format!("at {time:.3} s"))?;
    let left_out = passage.channels.len().saturating_sub(MOST);
    let bottom = match left_out {
        0 => bottom,
        more => sheet.caption(bottom, &format!("{more} more channels are in channels.csv.")),
    };
    Some(sheet.finish(bottom))
}

/// Every channel over the place of a single axle.
pub fn influence_lines(passage: &Passage) -> Option<String> {
    let influence = passage.influence.as_ref()?;
    let (first, last) = (*influence.positions.first()?, *influence.positions.last()?);
    let mut sheet = Sheet::new("influence");
    let second = format!(
        "Influence lines: one axle of {} kN on {} of width, moved over the bridge; self-weight taken off",
        words::three_digits(influence.force / 1e3),
        words::metres(passage.effective_width)
    );
    let top = sheet.title(&passage.bridge, &second);
    let x = Axis::exact("place of the axle, from the left springing of the first span [m]", first, last, 9);
    let pairs = passage.channels.iter().zip(&influence.values);
    let curves: Vec<Curve> = pairs.map(|(channel, values)| Curve::of(channel, values)).collect();
    let place = |x: f64| format!("at {x:.2} m").replace('-', "−");
    let springings: Vec<f64> = passage.mesh.springings.iter().flatten().map(|point| point[0]).collect();
    let bottom = stacked(&mut sheet, top, (&x, &influence.positions), &curves, &springings, place)?;
    let bottom =
        if springings.is_empty() { bottom } else { sheet.caption(bottom, "Dashed: the springings of the spans.") };
    Some(sheet.finish(bottom))
}

/// A curve in its unit.
struct Curve<'a> {
    name: &'a str,
    unit: &'static str,
    values: Vec<f64>,
}

impl<'a> Curve<'a> {
    fn of(channel: &'a SensorRecord, values: &[f64]) -> Curve<'a> {
        let scale = channel.quantity.scale();
        let values = values.iter().map(|value| scale * value).collect();
        Curve { name: &channel.name, unit: channel.quantity.unit(), values }
    }

    /// Index of the value of largest size.
    fn peak(&self) -> Option<usize> {
        let size = |k: &usize| self.values[*k].abs();
        (0..self.values.len()).reduce(|best, k| if size(&k) > size(&best) { k } else { best })
    }

    /// Ticks that cover the curve and zero, with room for the words at its peak.
    fn ticks(&self) -> Ticks {
        let finite = || self.values.iter().copied().filter(|value| value.is_finite());
        let (low, high) = (finite().fold(0.0, f64::min), finite().fold(0.0, f64::max));
        let room = 0.12 * (high - low);
        let low = if -low > high { low - room } else { low };
        let high = if high >= -low && high > 0.0 { high + room } else { high };
        // A record of nothing is not blown up to look like one of something.
        if high - low < 1e-9 { Ticks::over(-1.0, 1.0, 2) } else { Ticks::over(low, high, 3) }
    }
}

/// Panels over one axis; returns the y below them.
fn stacked(
    sheet: &mut Sheet,
    top: f64,
    (x, places): (&Axis, &[f64]),
    curves: &[Curve],
    marks: &[f64],
    at: impl Fn(f64) -> String,
) -> Option<f64> {
    let shown = &curves[..curves.len().min(MOST)];
    let ticks: Vec<Ticks> = shown.iter().map(Curve::ticks).collect();
    let widest = shown
        .iter()
        .zip(&ticks)
        .map(|(curve, ticks)| Axes::widest(&Axis::round(curve.unit, ticks.clone())))
        .fold(0.0, f64::max);
    let mut y = top;
    for (k, (curve, ticks)) in shown.iter().zip(&ticks).enumerate() {
        let lowest = k + 1 == shown.len();
        let heading = Style { weight: Weight::Bold, ..Style::default() };
        y += 16.0;
        sheet.text([MARGIN + 24.0 + widest + 8.0, y - 1.0], curve.name, heading);
        let up = Axis::round(curve.unit, ticks.clone());
        let (axes, below) = Axes::panel(sheet, [y, HEIGHT], [x, &up], Some(widest), lowest);
        let spots: Vec<Spot> = places.iter().zip(&curve.values).map(|(x, value)| axes.spot(*x, *value)).collect();
        let spots = thinned(&spots);
        zero(sheet, &axes, x);
        for mark in marks.iter().filter(|mark| (x.range[0]..=x.range[1]).contains(*mark)) {
            let at = axes.spot(*mark, 0.0)[0];
            sheet.line([at, axes.area.top], [at, axes.area.bottom], Pen::line("#8a8a8a", HAIR).dashed("4 3"));
        }
        sheet.open_clipped("record", &format!("panel-{k}"), axes.area);
        sheet.polyline(&spots, Pen::line(CURVE, 1.1).class("curve"));
        sheet.close();
        sheet.avoid_line(&spots);
        if let Some(peak) = curve.peak().filter(|peak| curve.values[*peak] != 0.0) {
            mark(sheet, &axes, places[peak], curve, peak, &at);
        }
        y = below;
    }
    (!shown.is_empty()).then_some(y)
}

/// The line of zero, darker than the grid.
fn zero(sheet: &mut Sheet, axes: &Axes, x: &Axis) {
    let ends = x.range.map(|x| axes.spot(x, 0.0));
    sheet.line(ends[0], ends[1], Pen::line("#8a8a8a", HAIR + 0.2));
}

fn mark(sheet: &mut Sheet, axes: &Axes, place: f64, curve: &Curve, peak: usize, at: impl Fn(f64) -> String) {
    let spot = axes.spot(place, curve.values[peak]);
    Mark::Hollow.draw(sheet, spot, INK);
    let value = words::three_digits(curve.values[peak]).replace('-', "−");
    let text = format!("{value} {} {}", curve.unit, at(place));
    let up = if curve.values[peak] > 0.0 { -0.4 } else { 0.4 };
    let side = if spot[0] > 0.5 * (axes.area.left + axes.area.right) { -0.9 } else { 0.9 };
    let room = Room { area: axes.area.grown(-3.0), towards: [side, up], clear: 7.0 };
    sheet.label(spot, &text, Style::on_drawing(), room);
}
