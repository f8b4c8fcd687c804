//! Channels that do not move.

use super::judge::Judge;
use crate::Recording;
use crate::signal::{Loaded, Smooth, least_count, range};

/// A channel that moves under the train no more than this multiple of what it moves before it is dead: the extremes of a
/// longer stretch of mere noise are wider, but hardly by half.
const NO_MORE_THAN_BEFORE: f64 = 1.5;
/// A channel with less than this share of its expected peak is dead.
const OF_EXPECTED: f64 = 0.02;

pub(super) fn examine(run: &mut Recording, channel: usize, smooth: &Smooth, loaded: Loaded, judge: &mut Judge) {
    let Some(smooth) = &smooth[channel] else { return };
    let record = &run.channels[channel];
    let unit = record.unit;
    let moves = range(smooth);
    let finite: Vec<f64> = record.values.iter().copied().filter(|value| value.is_finite()).collect();
    let count = least_count(&finite);
    let before = if loaded.quiet >= 20 { range(&smooth[..loaded.quiet]) } else { 0.0 };
    let expected = judge.expected(record).map(f64::abs);
    let all = Some([0, run.times.len().saturating_sub(1)]);
    let why = if range(&finite) == 0.0 {
        format!("it stands at {} throughout", unit.words(finite.first().copied().unwrap_or(0.0)))
    } else if moves <= 2.0 * count && range(&finite) <= 4.0 * count {
        format!("it moves by {}, no more than a few of its least counts of {}", unit.words(moves), unit.words(count))
    } else if before > 0.0 && moves <= NO_MORE_THAN_BEFORE * before {
        format!("it moves by {} under the train and by {} before it", unit.words(moves), unit.words(before))
    } else if let Some(peak) = expected.filter(|peak| moves < OF_EXPECTED * peak && moves > peak / 200.0) {
        format!("it moves by {} where a peak of {} is expected", unit.words(moves), unit.words(peak))
    } else {
        return;
    };
    judge.fault(run, Some(channel), "R040", all, [&why, "see whether the sensor was connected and its range fits"]);
}
