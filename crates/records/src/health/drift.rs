//! Drift: a level that wanders while nothing loads the span.

use super::judge::{Judge, Spot};
use crate::Run;
use crate::signal::{Loaded, least_count, line, range};

/// Standard errors that a slope must exceed to be one.
const SURE: f64 = 5.0;
/// Samples of a quiet start whose slope is looked at.
const SAMPLES: usize = 20;

pub(super) fn examine(run: &mut Run, channel: usize, smooth: &[f64], loaded: Loaded, judge: &mut Judge) {
    let n = run.times.len();
    let record = &run.channels[channel];
    let unit = record.unit;
    let Some(values) = crate::signal::bridged(&record.values) else { return };
    if loaded.quiet < SAMPLES {
        return;
    }
    // Two least counts may be rounding.
    let limit = (judge.scrutiny.limits.drift * range(smooth)).max(2.0 * least_count(smooth));
    let [start, slope, error] = line(&run.times[..loaded.quiet], &values[..loaded.quiet]);
    let duration = run.times[n - 1] - run.times[0];
    let slopes = (slope * duration).abs() > limit && slope.abs() > SURE * error;
    let (share, how) = if n - loaded.after >= SAMPLES {
        let [end, ..] = line(&run.times[loaded.after..], &values[loaded.after..]);
        if (end - start).abs() <= limit {
            return;
        }
        let how = format!("{} before the train and {} after it", unit.words(start), unit.words(end));
        (end - start, how)
    } else if slopes {
        let how = format!("by {} in a second before the train", unit.words(slope));
        (slope * duration, how)
    } else {
        return;
    };
    let percent = 100.0 * (share / range(smooth).max(f64::MIN_POSITIVE)).abs();
    let message = format!("it drifts or does not come back: {how}, {percent:.0} % of its range over the run");
    let help = "see to temperature and amplifier; or accept R041, say why, and take the drift off with detrend";
    judge.fault(run, channel, "R041", Spot::over(0, n - 1), &message, help);
}
