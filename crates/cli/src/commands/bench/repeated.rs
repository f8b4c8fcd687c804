//! Measures that are repeated.

use crate::args::Bench;
use assess::analysis::AnalysisError;
use extrados::Refusal;
use std::time::Instant;

/// What was measured often.
pub(super) struct Repeated<T> {
    /// The least time is the method's, the middle one the machine's [s].
    pub(super) least: f64,
    pub(super) middle: f64,
    pub(super) last: T,
}

/// Repeats a measure.
pub(super) fn repeated<T>(
    arguments: &Bench,
    measure: impl Fn() -> Result<T, AnalysisError>,
) -> Result<Repeated<T>, Refusal> {
    let mut seconds = Vec::new();
    let mut once = || -> Result<T, Refusal> {
        let (found, taken) = timed(&measure);
        seconds.push(taken);
        Ok(found?)
    };
    let mut last = once()?;
    for _ in 1..arguments.repeats {
        last = once()?;
    }
    let [least, middle] = least_and_middle(&mut seconds);
    Ok(Repeated { least, middle, last })
}

/// The least and the middle one of some times [s].
pub(super) fn least_and_middle(seconds: &mut [f64]) -> [f64; 2] {
    seconds.sort_by(f64::total_cmp);
    [seconds[0], seconds[seconds.len() / 2]]
}

/// What some work gives, and how long it takes [s].
pub(super) fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let clock = Instant::now();
    let found = work();
    (found, clock.elapsed().as_secs_f64())
}
