//! Drop-outs: a channel that holds one value while its neighbours answer the train.

use super::judge::Judge;
use crate::Recording;
use crate::signal::{Loaded, Smooth, least_count, range};

/// Samples that are held at least.
const SAMPLES: usize = 20;
/// What at least half of the other channels move meanwhile, as a share of their ranges: an axle passes.
const OTHERS: f64 = 0.6;
/// A channel with fewer least counts than these in its range holds values by rounding.
const COUNTS: f64 = 10.0;
/// Distance from the level before the train, or jump at an end of the stretch, as a share of the range.
const AWAY: f64 = 0.2;

pub(super) fn examine(run: &mut Recording, channel: usize, smooth: &Smooth, loaded: Loaded, judge: &mut Judge) {
    let Some(own) = &smooth[channel] else { return };
    let values = &run.channels[channel].values;
    let whole = range(own);
    let count = least_count(own);
    if whole <= COUNTS * count {
        return;
    }
    let level = loaded.level(own);
    let Some([first, last]) = longest(values, loaded) else { return };
    if last - first + 1 < SAMPLES {
        return;
    }
    let jump = |a: usize, b: usize| (values[a] - values[b]).abs() > AWAY * whole;
    let jumps = (first > 0 && jump(first - 1, first)) || (last + 1 < values.len() && jump(last, last + 1));
    let away = (values[first] - level).abs() > AWAY * whole;
    let others = smooth.iter().enumerate().filter(|(k, _)| *k != channel && run.channels[*k].used());
    let others: Vec<&Vec<f64>> = others.filter_map(|(_, other)| other.as_ref()).collect();
    let moved = others.iter().filter(|other| range(&other[first..=last]) > OTHERS * range(other)).count();
    if (away || jumps) && moved > 0 && 2 * moved >= others.len() {
        let unit = run.channels[channel].unit;
        let message = format!(
            "it holds {} over {} samples to {:.4} s while others answer the train",
            unit.words(values[first]),
            last - first + 1,
            run.times[last]
        );
        let help = "see whether the sensor reached its end stop or lost its contact";
        judge.fault(run, Some(channel), "R043", Some([first, last]), [&message, help]);
    }
}

/// Longest stretch of one and the same value under the train.
fn longest(values: &[f64], loaded: Loaded) -> Option<[usize; 2]> {
    let mut best: Option<[usize; 2]> = None;
    let mut first = loaded.on[0];
    for k in loaded.on[0]..=loaded.on[1].min(values.len().saturating_sub(1)) {
        if values[k] != values[first] {
            first = k;
        }
        if best.is_none_or(|[a, b]| b - a < k - first) {
            best = Some([first, k]);
        }
    }
    best
}
