//! Measured and computed histories over one another, channel below channel (railway paper, Figs. 11 to 13).

use super::{HEADING_LINE, MEASURED, START, UPDATED, heading, heading_lines, percent, second_line};
use crate::chart::{Axes, Axis, Entry, key};
use crate::sheet::{HAIR, MARGIN, Pen, Sheet, Spot, WIDTH};
use crate::thinned::thinned;
use crate::ticks::Ticks;
use crate::words::three_digits;
use outcome::update::{Histories, Update};

/// Height of a panel: six fill a page.
const HEIGHT: f64 = 112.0;
/// Most panels on a sheet.
const MOST: usize = 10;

/// Every channel over time, measured, of the start model and of the updated one. None without a history.
pub fn histories(update: &Update) -> Option<String> {
    let (first, last) = (*update.times.first()?, *update.times.last()?);
    let drawn: Vec<usize> =
        (0..update.channels.len()).filter(|k| curves(&update.channels[*k]).next().is_some()).collect();
    let shown = &drawn[..drawn.len().min(MOST)];
    if shown.is_empty() {
        return None;
    }
    let mut sheet = Sheet::new("histories");
    let what = format!("Records and model under the train {}; self-weight taken off", update.train);
    let mut y = sheet.title(&update.bridge, &second_line(update, &what));
    let x = Axis::exact("time since the first axle stood at the start [s]", first, last.max(first + 1e-6), 8);
    let ups: Vec<Axis> = shown.iter().map(|k| upright(&update.channels[*k])).collect();
    let widest = ups.iter().map(Axes::widest).fold(0.0, f64::max);
    let (left, right) = (MARGIN + 24.0 + widest + 8.0, WIDTH - MARGIN);
    for (place, (k, up)) in shown.iter().zip(ups).enumerate() {
        let channel = &update.channels[*k];
        let about = words(update, *k);
        y += HEADING_LINE * heading_lines(left, right, &channel.name, &about);
        heading(&mut sheet, [left, y - 1.0], right, &channel.name, &about);
        let lowest = place + 1 == shown.len();
        let (axes, below) = Axes::panel(&mut sheet, [y, HEIGHT], [&x, &up], Some(widest), lowest);
        let ends = x.range.map(|x| axes.spot(x, 0.0));
        sheet.line(ends[0], ends[1], Pen::line("#8a8a8a", HAIR + 0.2));
        sheet.open_clipped("history", &format!("panel-{place}"), axes.area);
        for (values, pen) in curves(channel) {
            let spots: Vec<Spot> = update.times.iter().zip(values).map(|(x, value)| axes.spot(*x, *value)).collect();
            for piece in spots.split(|spot| !spot[1].is_finite()) {
                sheet.polyline(&thinned(piece), pen);
            }
        }
        sheet.close();
        y = below;
    }
    let any = |of: &dyn Fn(&Histories) -> &Vec<f64>| shown.iter().any(|k| !of(&update.channels[*k]).is_empty());
    let mut entries = Vec::new();
    let mut entry = |line, text, there: bool| {
        if there {
            entries.push(Entry { line: Some(line), mark: None, text });
        }
    };
    entry((MEASURED, ""), "record", any(&|channel| &channel.measured));
    entry((START, DASHES), "start model", any(&|channel| &channel.start));
    entry((UPDATED, ""), "updated model", any(&|channel| &channel.updated));
    let mut bottom = key(&mut sheet, y, &entries);
    if drawn.len() > MOST {
        bottom = sheet.caption(bottom, &format!("{} more channels are in the tables.", drawn.len() - MOST));
    }
    Some(sheet.finish(bottom))
}

const DASHES: &str = "6 3";

/// The curves of a channel that are there, the record lowest.
fn curves(channel: &Histories) -> impl Iterator<Item = (&[f64], Pen<'static>)> {
    let all = [
        (&channel.measured, Pen::line(MEASURED, 1.9).class("measured")),
        (&channel.start, Pen::line(START, 1.0).dashed(DASHES).class("start")),
        (&channel.updated, Pen::line(UPDATED, 1.1).class("updated")),
    ];
    all.into_iter()
        .filter(|(values, _)| values.iter().any(|value| value.is_finite()))
        .map(|(v, pen)| (v.as_slice(), pen))
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
        words += &error.map_or(String::new(), |error| format!("; {name} {}", percent(error)));
    }
    words
}
