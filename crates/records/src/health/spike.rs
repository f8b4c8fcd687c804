//! Spikes: samples that leave their neighbours and come back at once.

use super::judge::Judge;
use crate::signal::{Loaded, Smooth, bridged, least_count, noise, quantile, range};
use crate::{Done, Recording};
use findings::words::counted;

/// A spike leaves its neighbours by this share of the channel's range; smaller ones change no peak that matters.
const OF_RANGE: f64 = 0.1;
/// And by this many deviations of the noise: of a million normal samples none does.
const OF_NOISE: f64 = 8.0;
/// And by this many least counts.
const OF_COUNT: f64 = 5.0;
/// And by this multiple of what 95 of 100 samples under the train keep to, so that sharp true peaks are none.
const OF_OTHERS: f64 = 6.0;
/// Spikes that are named one by one.
const NAMED: usize = 20;
/// Most spikes that are taken out of one channel; a channel with more has a loose contact.
const MOST: usize = 5;

/// Takes spikes out of a channel, or leaves the channel out where there are too many.
pub(super) fn examine(run: &mut Recording, channel: usize, smooth: &Smooth, loaded: Loaded, judge: &mut Judge) {
    let Some(smooth) = &smooth[channel] else { return };
    let record = &run.channels[channel];
    let unit = record.unit;
    let Some(values) = bridged(&record.values) else { return };
    let off = |k: usize| (values[k] - smooth[k]).abs();
    let mut under_train: Vec<f64> = (loaded.on[0]..=loaded.on[1].min(values.len() - 1)).map(off).collect();
    let limits = [
        OF_RANGE * range(smooth),
        OF_NOISE * noise(&values),
        OF_COUNT * least_count(smooth),
        OF_OTHERS * quantile(&mut under_train, 0.95),
    ];
    let limit = limits.into_iter().fold(0.0, f64::max);
    if limit <= 0.0 {
        return;
    }
    // The outermost three have too few neighbours on one side: they must leave the next sample inwards and the straight line
    // through the next two, so that a record that is cut on a slope ends in no spike.
    let n = values.len();
    let inwards = |k: usize, a: usize, b: usize| {
        let line = 2.0 * values[a] - values[b];
        (values[k] - values[a]).abs().min((values[k] - line).abs())
    };
    let far = |k: usize| match k {
        0..3 => inwards(k, k + 1, k + 2),
        _ if k + 3 >= n => inwards(k, k - 1, k - 2),
        _ => off(k),
    };
    let spikes: Vec<usize> = (0..n).filter(|k| record.values[*k].is_finite() && far(*k) > limit).collect();
    if spikes.is_empty() {
        return;
    }
    if spikes.len() > MOST {
        let message = format!("{} samples stand off their neighbours by more than {}", spikes.len(), unit.words(limit));
        let help = "see to the sensor's contacts, or accept R042 and say why: its spikes are then taken out";
        judge.fault(run, Some(channel), "R042", Some([spikes[0]; 2]), [&message, help]);
        if !run.channels[channel].used() {
            return;
        }
    }
    for &k in spikes.iter().take(NAMED) {
        let message = format!(
            "a spike of {} among neighbours of {}; the sample is taken out",
            unit.words(values[k]),
            unit.words(smooth[k])
        );
        judge.warn(run, Some(channel), "R042", Some([k; 2]), [&message, "see whether the sensor was touched"]);
    }
    if spikes.len() > NAMED {
        let spot = Some([spikes[NAMED], spikes[spikes.len() - 1]]);
        let message = format!("{}, all taken out", counted(spikes.len() - NAMED, "more spike"));
        judge.warn(run, Some(channel), "R042", spot, [&message, "see to the sensor's contacts"]);
    }
    let title = run.channels[channel].title();
    judge.done.push(Done::new(&run.name, title, format!("{} taken out", counted(spikes.len(), "spike"))));
    for k in spikes {
        run.channels[channel].values[k] = f64::NAN;
    }
}
