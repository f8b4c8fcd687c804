//! Measures that are repeated.

use crate::args::Bench;
use crate::clock::Clock;
use crate::failure::Failure;
use crate::results;
use assess::analysis::AnalysisError;

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
) -> Result<Repeated<T>, Failure> {
    let once = || -> Result<(f64, T), Failure> {
        let clock = Clock::start();
        let found = measure().map_err(|error| results::not_set_up(&error))?;
        Ok((clock.seconds(), found))
    };
    let (first, mut last) = once()?;
    let mut seconds = vec![first];
    for _ in 1..arguments.repeats {
        let (more, found) = once()?;
        seconds.push(more);
        last = found;
    }
    seconds.sort_by(f64::total_cmp);
    Ok(Repeated { least: seconds[0], middle: seconds[seconds.len() / 2], last })
}
