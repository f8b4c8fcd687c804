//! Drift: a level that wanders while nothing loads the span.

use super::judge::Judge;
use crate::Recording;
use crate::signal::{Loaded, Smooth, least_count, line, range};

/// Standard errors that a slope must exceed to be one.
const SURE: f64 = 5.0;
/// Samples of a quiet start whose slope is looked at.
const SAMPLES: usize = 20;
/// Drift over the run, as a share of the channel's range, from which a channel is left out. A tenth is the norm that a good
/// calibration reaches, so that such a drift would be taken for the bridge.
const SHARE: f64 = 0.1;

pub(super) fn examine(run: &mut Recording, channel: usize, smooth: &Smooth, loaded: Loaded, judge: &mut Judge) {
    let Some(smooth) = &smooth[channel] else { return };
    let n = run.times.len();
    let record = &run.channels[channel];
    let unit = record.unit;
    let Some(values) = crate::signal::bridged(&record.values) else { return };
    if loaded.quiet < SAMPLES {
        return;
    }
    // Two least counts may be rounding.
    let limit = (SHARE * range(smooth)).max(2.0 * least_count(smooth));
    let [start, slope, error] = line(&run.times[..loaded.quiet], &values[..loaded.quiet]);
    let duration = run.times[n - 1] - run.times[0];
    let whole = range(smooth).max(f64::MIN_POSITIVE);
    let (share, how) = if n - loaded.after >= SAMPLES {
        let [end, end_slope, _] = line(&run.times[loaded.after..], &values[loaded.after..]);
        if (end - start).abs() <= limit {
            return;
        }
        let how = format!("{} before the train and {} after it", unit.words(start), unit.words(end));
        // What drifts does so before and after the train too: the slope there, each by the cube of its length as in a common
        // line, is nearer to the difference's than to none. What jumps meanwhile is the bridge's, or a sensor's that slipped.
        let weights = [loaded.quiet, n - loaded.after].map(|count| (count as f64).powi(3));
        let common = (weights[0] * slope + weights[1] * end_slope) / (weights[0] + weights[1]);
        if common * duration / (end - start) < 0.5 {
            let percent = 100.0 * (end - start).abs() / whole;
            let message = format!(
                "it does not come back: {how}, {percent:.0} % of its range, but does not drift while nothing passes"
            );
            let help = "see whether joints slid under the train, or the sensor slipped; a second run tells";
            judge.warn(run, Some(channel), "R046", Some([loaded.quiet - 1, loaded.after]), [&message, help]);
            return;
        }
        (end - start, how)
    } else if (slope * duration).abs() > limit && slope.abs() > SURE * error {
        (slope * duration, format!("by {} in a second before the train", unit.words(slope)))
    } else {
        return;
    };
    let percent = 100.0 * share.abs() / whole;
    let message = format!("it drifts: {how}, {percent:.0} % of its range over the run");
    let help = "see to temperature and amplifier; or accept R041, say why, and take the drift off with detrend";
    judge.fault(run, Some(channel), "R041", Some([0, n - 1]), [&message, help]);
}
