//! Records over time, and influence lines: one panel below the other.

use crate::chart::{Axis, Chart, Mark, Panel, PanelPoint, ZERO};
use crate::elevation::INK;
use crate::sheet::place::Room;
use crate::sheet::{HAIR, Pen, Style};
use crate::ticks::Ticks;
use crate::words;
use outcome::passage::{Passage, SensorRecord};

/// Height of a panel.
const HEIGHT: f64 = 92.0;
/// Most panels on a sheet; tables have all channels.
const MOST: usize = 12;
/// Colour of curves.
const CURVE: &str = "#0b5394";

/// The records of the sensors: every channel over time, its peak marked; none without a record.
pub fn records(passage: &Passage) -> Option<String> {
    let end = *passage.times.last()?;
    let second = format!(
        "{} at {} km/h, {}; self-weight taken off; {} positions",
        passage.train,
        words::three_digits(3.6 * passage.speed),
        passage.analysis,
        passage.times.len()
    );
    let x = Axis::exact("time since the first axle stood at the start [s]", 0.0, end.max(1e-6), 8);
    let curves = passage.channels.iter().map(|channel| (channel, &channel.values));
    let mut chart = stacked((x, &passage.times), curves, &[], |time| format!("at {time:.3} s"))?;
    if passage.channels.len() > MOST {
        chart.words.push(format!("{} more channels are in channels.csv.", passage.channels.len() - MOST));
    }
    Some(chart.draw("records", &passage.bridge, &second))
}

/// Every channel over the place of a single axle.
pub(super) fn influence_lines(passage: &Passage) -> Option<String> {
    let influence = passage.influence.as_ref()?;
    let (first, last) = (*influence.positions.first()?, *influence.positions.last()?);
    let second = format!(
        "Influence lines: one axle of {} kN on {} of width, moved over the bridge; self-weight taken off",
        words::three_digits(influence.force / 1e3),
        words::metres(passage.effective_width)
    );
    let x = Axis::exact("place of the axle, from the left springing of the first span [m]", first, last, 9);
    let curves = passage.channels.iter().zip(&influence.values);
    let place = |x: f64| format!("at {x:.2} m").replace('-', "−");
    let springings: Vec<f64> = passage.mesh.springings.iter().flatten().map(|point| point[0]).collect();
    let mut chart = stacked((x, &influence.positions), curves, &springings, place)?;
    if !springings.is_empty() {
        chart.words.push("Dashed: the springings of the spans.".to_owned());
    }
    Some(chart.draw("influence", &passage.bridge, &second))
}

/// Panels over one axis, each in its unit; none without a curve.
fn stacked<'a>(
    (x, places): (Axis<'a>, &[f64]),
    curves: impl Iterator<Item = (&'a SensorRecord, &'a Vec<f64>)>,
    marks: &[f64],
    at: impl Fn(f64) -> String,
) -> Option<Chart<'a>> {
    let mut chart = Chart { height: HEIGHT, heading: 16.0, ..Chart::default() };
    for (k, (channel, values)) in curves.take(MOST).enumerate() {
        let (scale, unit) = (channel.quantity.scale(), channel.quantity.unit());
        let values: Vec<f64> = values.iter().map(|value| scale * value).collect();
        let mut panel = Panel::new(x.clone(), Axis::round(unit, ticks(&values)));
        panel.heading.0 = channel.name.clone();
        panel.level(0.0, ZERO);
        for mark in marks.iter().filter(|mark| x.holds(**mark)) {
            panel.upright(*mark, Pen::line("#8a8a8a", HAIR).dashed("4 3"));
        }
        panel.clip("record", format!("panel-{k}"));
        panel.record(places, &values, Pen::line(CURVE, 1.1).class("curve"));
        panel.close();
        // The value of largest size, the first of equals.
        let size = |k: &usize| values[*k].abs();
        let peak = (0..values.len()).reduce(|best, k| if size(&k) > size(&best) { k } else { best });
        if let Some(peak) = peak.filter(|peak| values[*peak] != 0.0) {
            mark(&mut panel, [places[peak], values[peak]], unit, at(places[peak]));
        }
        chart.panels.push(panel);
    }
    (!chart.panels.is_empty()).then_some(chart)
}

/// Ticks that cover a curve and zero, with room for the words at its peak.
fn ticks(values: &[f64]) -> Ticks {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    let (low, high) = (finite().fold(0.0, f64::min), finite().fold(0.0, f64::max));
    let room = 0.12 * (high - low);
    let low = if -low > high { low - room } else { low };
    let high = if high >= -low && high > 0.0 { high + room } else { high };
    // A record of nothing is not blown up to look like one of something.
    if high - low < 1e-9 { Ticks::over(-1.0, 1.0, 2) } else { Ticks::over(low, high, 3) }
}

/// A peak with its words.
fn mark(panel: &mut Panel, at: PanelPoint, unit: &str, place: String) {
    panel.mark(at, Mark::Hollow, INK);
    let text = format!("{} {unit} {place}", words::three_digits(at[1]).replace('-', "−"));
    let up = if at[1] > 0.0 { -0.4 } else { 0.4 };
    panel.add(move |sheet, axes| {
        let spot = axes.spot(at);
        let side = if spot[0] > 0.5 * (axes.area.left + axes.area.right) { -0.9 } else { 0.9 };
        let room = Room { area: axes.area.grown(-3.0), towards: [side, up], clear: 7.0 };
        sheet.label(spot, &text, Style::on_drawing(), room);
    });
}
