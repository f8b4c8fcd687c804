//! Measured and computed histories over one another, channel below channel (railway paper, Figs. 11 to 13).

use super::style::{MEASURED, START, UPDATED};
use super::words::{second_line, signed};
use crate::chart::{Axis, Chart, Entry, HEADING, Panel, ZERO};
use crate::sheet::Pen;
use crate::ticks::Ticks;
use crate::words::three_digits;
use outcome::update::{Histories, Update};

/// Height of a panel: six fill a page.
const HEIGHT: f64 = 112.0;
/// Most panels on a sheet.
const MOST: usize = 10;

/// Every channel over time, measured, of the start model and of the updated one. None without a history.
pub(super) fn histories(update: &Update) -> Option<String> {
    let (first, last) = (*update.times.first()?, *update.times.last()?);
    let x = Axis::exact("time since the first axle stood at the start [s]", first, last.max(first + 1e-6), 8);
    let drawn: Vec<usize> =
        (0..update.channels.len()).filter(|k| curves(&update.channels[*k]).next().is_some()).collect();
    let shown = &drawn[..drawn.len().min(MOST)];
    let mut chart = Chart { height: HEIGHT, heading: HEADING, ..Chart::default() };
    for (place, &k) in shown.iter().enumerate() {
        let channel = &update.channels[k];
        let mut panel = Panel::new(x.clone(), upright(channel));
        panel.heading = (channel.name.clone(), Some(words(update, k)));
        panel.level(0.0, ZERO);
        panel.clip("history", format!("panel-{place}"));
        for (values, pen) in curves(channel) {
            panel.record(&update.times, values, pen);
        }
        panel.close();
        chart.panels.push(panel);
    }
    if chart.panels.is_empty() {
        return None;
    }
    let there = KINDS.iter().filter(|(of, ..)| shown.iter().any(|k| !of(&update.channels[*k]).is_empty()));
    chart.key = there.map(|(_, pen, text)| Entry::line((pen.stroke, pen.dashes), *text)).collect();
    if drawn.len() > MOST {
        chart.words.push(format!("{} more channels are in the tables.", drawn.len() - MOST));
    }
    let what = format!("Records and model under the train {}; self-weight taken off", update.train);
    Some(chart.draw("histories", &update.bridge, &second_line(update, &what)))
}

/// The curves of a channel, how they are drawn, and what they are; the record lowest.
type Kind = (fn(&Histories) -> &[f64], Pen<'static>, &'static str);
const KINDS: [Kind; 3] = [
    (|channel| &channel.measured, Pen::line(MEASURED, 1.9).class("measured"), "record"),
    (|channel| &channel.start, Pen::line(START, 1.0).dashed("6 3").class("start"), "start model"),
    (|channel| &channel.updated, Pen::line(UPDATED, 1.1).class("updated"), "updated model"),
];

/// The curves of a channel that are there.
fn curves(channel: &Histories) -> impl Iterator<Item = (&[f64], Pen<'static>)> {
    let all = KINDS.into_iter().map(|(of, pen, _)| (of(channel), pen));
    all.filter(|(values, _)| values.iter().any(|value| value.is_finite()))
}

/// From below all curves and zero to above them.
fn upright(channel: &Histories) -> Axis<'static> {
    let finite = || curves(channel).flat_map(|(values, _)| values).copied().filter(|value| value.is_finite());
    let (low, high) = (finite().fold(0.0, f64::min), finite().fold(0.0, f64::max));
    let room = 0.06 * (high - low);
    // A record of nothing is not blown up to look like one of something.
    if room < 1e-9 {
        Axis::round(channel.quantity.unit(), Ticks::over(-1.0, 1.0, 2))
    } else {
        Axis::exact(channel.quantity.unit(), low - room, high + room, 5)
    }
}

fn words(update: &Update, k: usize) -> String {
    let channel = &update.channels[k];
    if let Some(why) = &channel.left_out {
        return format!("left out: {why}");
    }
    let measured = update.problem.channels().get(k).and_then(|channel| channel.measured_peak());
    let before = update.basis.as_ref().and_then(|basis| basis.start.channels.get(k)).map(|one| one.peak);
    let after = update.found().and_then(|found| found.channels.get(k)).map(|one| one.model_peak);
    let Some(measured) = measured else { return String::new() };
    let mut words = format!("peak of the record {} {}", three_digits(measured), channel.quantity.unit());
    for (name, peak) in [("start model", before), ("updated", after)] {
        let error = peak.map(|peak| (peak - measured) / measured).filter(|error| error.is_finite());
        words += &error.map_or(String::new(), |error| format!("; {name} {} %", signed(100.0 * error, 1)));
    }
    words
}
