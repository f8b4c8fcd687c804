//! Samples that are missing in one channel.

use super::judge::{Judge, LONGEST_GAP};
use crate::signal::bridged;
use crate::{Done, Recording};
use findings::words::{counted, verb};

/// First and last sample of every stretch without values.
fn stretches(values: &[f64]) -> Vec<[usize; 2]> {
    let mut stretches: Vec<[usize; 2]> = Vec::new();
    for k in (0..values.len()).filter(|k| !values[*k].is_finite()) {
        match stretches.last_mut() {
            Some(last) if last[1] + 1 == k => last[1] = k,
            _ => stretches.push([k, k]),
        }
    }
    stretches
}

/// Leaves a channel out whose longest stretch without values is too long to bridge.
pub(super) fn examine(run: &mut Recording, channel: usize, judge: &mut Judge) {
    let stretches = stretches(&run.channels[channel].values);
    let n = run.times.len();
    let Some(worst) = stretches.iter().copied().max_by_key(|[first, last]| last - first) else { return };
    let count: usize = stretches.iter().map(|[first, last]| last - first + 1).sum();
    let length = worst[1] - worst[0] + 1;
    if count == n {
        let message = "it has no value at all";
        judge.fault(run, Some(channel), "R040", Some([0, n - 1]), [message, "see whether the sensor was connected"]);
    } else if length > LONGEST_GAP {
        let message = format!(
            "{} in a row {} missing ({count} of {n} in all), more than {LONGEST_GAP} that may be bridged",
            counted(length, "sample"),
            verb(length, "is", "are")
        );
        let help = "cut the file, mend the cells, or accept R036 and say why the gap does not matter";
        judge.fault(run, Some(channel), "R036", Some([worst[0], worst[1]]), [&message, help]);
    }
}

/// Bridges what is missing in the channels that are used.
pub(super) fn bridge(run: &mut Recording, judge: &mut Judge) {
    for channel in run.channels.iter_mut().filter(|channel| channel.used()) {
        let stretches = stretches(&channel.values);
        let count: usize = stretches.iter().map(|[first, last]| last - first + 1).sum();
        if count == 0 {
            continue;
        }
        let Some(values) = bridged(&channel.values) else { continue };
        channel.values = values;
        let first = stretches.first().map_or(0.0, |[first, _]| run.times[*first]);
        let what = format!(
            "{} in {} bridged by straight lines, first at {first:.4} s",
            counted(count, "missing sample"),
            counted(stretches.len(), "place")
        );
        judge.done.push(Done::new(&run.name, channel.title(), what));
    }
}
