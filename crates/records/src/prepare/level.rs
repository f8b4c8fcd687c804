//! What is zero, and drift taken off.

use crate::health::smooth;
use crate::signal::{Loaded, least_count, line, loaded, median, noise, range};
use crate::{Recording, Series};

/// What is taken as zero.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Zero {
    /// The median of the quiet start, before the first axle is felt.
    #[default]
    QuietStart,
    /// The median between two times [s].
    Between([f64; 2]),
    /// Records are taken as they are.
    AsRecorded,
}

/// Which drift is taken off.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Detrend {
    /// None.
    #[default]
    None,
    /// The straight line from the quiet start to the quiet end, which the train does not tilt.
    QuietEnds,
    /// The straight line of least squares through the whole record; the train's own answer tilts it a little.
    LeastSquares,
}

fn state(run: &Recording) -> Loaded {
    loaded(run, &smooth(run))
}

pub(super) fn zero(run: &mut Recording, zero: Zero, log: &mut Series) {
    let samples = match zero {
        Zero::AsRecorded => return kept(run, log),
        Zero::QuietStart => 0..state(run).quiet,
        Zero::Between([from, to]) => {
            let first = run.times.partition_point(|time| *time < from);
            first..run.times.partition_point(|time| *time <= to).max(first)
        }
    };
    if samples.is_empty() {
        let message = "there is no quiet start to take as zero; the level is as recorded".to_owned();
        log.could_not(
            run,
            "R060",
            message,
            "name times between which nothing loads the span, or cut the file less closely",
        );
        return;
    }
    let span = [run.times[samples.start], run.times[samples.end - 1]];
    for channel in run.channels.iter_mut().filter(|channel| channel.used()) {
        let level = median(&mut channel.values[samples.clone()].to_vec());
        channel.values.iter_mut().for_each(|value| *value -= level);
        let what = format!(
            "set to zero: {} taken off, the median of {} samples from {:.3} s to {:.3} s",
            channel.unit.words(level),
            samples.len(),
            span[0],
            span[1]
        );
        log.did(&run.name, &channel.title(), what);
    }
}

/// Share of a channel's range from which a level before the train is not small beside what a peak is read to.
const KEPT: f64 = 0.02;

/// Names the levels that stay in records taken as they are: each is a part of its channel's peak, and temperature moves all of them at once.
fn kept(run: &Recording, log: &mut Series) {
    let quiet = state(run).quiet;
    if quiet == 0 {
        return;
    }
    for channel in run.channels.iter().filter(|channel| channel.used()) {
        let values = &channel.values[..quiet];
        let level = median(&mut values.to_vec());
        // Standard deviation of a median of normal noise, three times.
        let chance = 3.0 * 1.25 * noise(values) / (quiet as f64).sqrt();
        let whole = range(&channel.values);
        if level.abs() > (KEPT * whole).max(chance).max(2.0 * least_count(values)) {
            let message = format!(
                "its level before the train is {}, {:.0} % of its range, and stays in every value",
                channel.unit.words(level),
                100.0 * level.abs() / whole
            );
            let help = "take the level before the train as zero, unless it belongs to the response";
            log.warn(run, &channel.title(), "R067", message, help);
        }
    }
}

pub(super) fn detrend(run: &mut Recording, detrend: Detrend, log: &mut Series) {
    if detrend == Detrend::None {
        return;
    }
    let n = run.times.len();
    let ends = state(run);
    if detrend == Detrend::QuietEnds && (ends.quiet == 0 || ends.after >= n) {
        let message = "there is no quiet start and end to draw a line between; no drift was taken off".to_owned();
        log.could_not(run, "R061", message, "record longer, or ask for a line of least squares");
        return;
    }
    let through = match detrend {
        Detrend::QuietEnds => "through the quiet start and end",
        _ => "of least squares through the whole record",
    };
    let times = run.times.clone();
    let mean = |from: usize, to: usize| times[from..to].iter().sum::<f64>() / (to - from) as f64;
    for channel in run.channels.iter_mut().filter(|channel| channel.used()) {
        let [time, value, slope] = if detrend == Detrend::QuietEnds {
            let start = median(&mut channel.values[..ends.quiet].to_vec());
            let end = median(&mut channel.values[ends.after..].to_vec());
            let [t0, t1] = [mean(0, ends.quiet), mean(ends.after, n)];
            [t0, start, (end - start) / (t1 - t0)]
        } else {
            let [value, slope, _] = line(&times, &channel.values);
            [mean(0, n), value, slope]
        };
        for (at, entry) in times.iter().zip(&mut channel.values) {
            *entry -= value + slope * (at - time);
        }
        let slope = channel.unit.words(slope);
        let what = format!("drift taken off: a straight line {through}, {slope} in a second");
        log.did(&run.name, &channel.title(), what);
    }
}
