//! Regular clocks.

use crate::{Recording, Series};

/// No record is made longer than this many samples.
const MOST: f64 = 5e7;

/// Values at other times, on straight lines between samples.
pub(super) fn at_times(times: &[f64], values: &[f64], wanted: &[f64]) -> Vec<f64> {
    let mut k = 0;
    let last = times.len() - 1;
    wanted
        .iter()
        .map(|time| {
            while k + 1 < last && times[k + 1] <= *time {
                k += 1;
            }
            if last == 0 || *time <= times[0] {
                return values[0];
            }
            let share = (time - times[k]) / (times[k + 1] - times[k]);
            if share >= 1.0 { values[k + 1] } else { values[k] + share * (values[k + 1] - values[k]) }
        })
        .collect()
}

/// Gives a run whose steps differ a clock of its own mean step.
pub(super) fn regular(run: &mut Recording, log: &mut Series) {
    let interval = run.interval();
    let tolerance = 1e-3 * interval + run.time_step_shown;
    if run.times.windows(2).all(|pair| (pair[1] - pair[0] - interval).abs() <= tolerance) {
        return;
    }
    let mut steps: Vec<f64> = run.times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let usual = crate::signal::median(&mut steps);
    onto(run, 1.0 / usual.max(f64::MIN_POSITIVE), "its steps differed", log);
}

/// Gives a run a clock of that rate [Hz].
pub(super) fn to_rate(run: &mut Recording, rate: f64, log: &mut Series) {
    if !(rate > 0.0 && rate.is_finite()) {
        let message = format!("{rate} Hz is no rate; the clock is as recorded");
        log.could_not(run, "R063", message, "name a rate above 0, such as 200");
        return;
    }
    onto(run, rate, "as asked", log);
}

fn onto(run: &mut Recording, rate: f64, why: &str, log: &mut Series) {
    let (Some(&first), Some(&last)) = (run.times.first(), run.times.last()) else { return };
    let samples = ((last - first) * rate * (1.0 + 1e-12)).floor() + 1.0;
    if !(samples < MOST) {
        let message = format!("a rate of {rate:.4} Hz would make {samples:.0} samples; the clock is as recorded");
        log.could_not(run, "R063", message, "name a lower rate");
        return;
    }
    let before = run.times.len();
    let wanted: Vec<f64> = (0..samples as usize).map(|k| first + k as f64 / rate).collect();
    for channel in run.channels.iter_mut().filter(|channel| !channel.values.is_empty()) {
        channel.values = at_times(&run.times, &channel.values, &wanted);
        channel.decimals = None;
    }
    run.lines = vec![0; wanted.len()];
    run.time_step_shown = 0.0;
    run.times = wanted;
    let what = format!(
        "resampled to {rate:.4} Hz on straight lines between samples, {why}: {before} samples became {}",
        run.times.len()
    );
    log.did(&run.name, "", what);
}
