//! One zero of the clock for all runs: by a reference history, or by the times at which axles pass a sensor.

use super::pace;
use super::resample::at_times;
use crate::series::title;
use crate::{Recording, Series};

/// What the clock's zero is.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Align {
    /// As recorded.
    #[default]
    AsRecorded,
    /// One channel is shifted until it fits a reference best, and all channels of its run with it.
    Reference(Reference),
    /// One channel is shifted until its answers fall on the times at which axles pass its sensor.
    Axles {
        /// Channel.
        name: String,
        /// Its line.
        line: String,
        /// Times at which axles stand over the sensor [s].
        times: Vec<f64>,
        /// Time in which an axle is felt before and after [s]: half a span over the speed.
        felt: f64,
        /// Speed for which these times hold [m/s]: a run of another speed is compared at its own. None where they hold for all.
        speed: Option<f64>,
    },
}

/// A history that a channel is compared with.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Reference {
    /// Channel.
    pub name: String,
    /// Its line; where it is empty, the first line of that name that is used.
    pub line: String,
    /// Times [s], ascending.
    pub times: Vec<f64>,
    /// Values [SI].
    pub values: Vec<f64>,
    /// Speed for which these times hold [m/s]: a run of another speed is compared at its own. None where they hold for all.
    pub speed: Option<f64>,
}

impl Reference {
    /// The same for a train that goes so many times as fast: the clock's zero stays.
    pub(super) fn faster(&self, ratio: f64) -> Reference {
        Reference { times: self.times.iter().map(|time| time / ratio).collect(), ..self.clone() }
    }
}

/// A correlation below this does not say where the train is.
const WEAK: f64 = 0.5;
/// Samples that the first, coarse search compares.
const COARSE: usize = 3000;

pub(super) fn align(run: &mut Recording, align: &Align, log: &mut Series) {
    let (reference, by) = match align {
        Align::AsRecorded => return,
        Align::Reference(reference) => (reference.clone(), "to the reference".to_owned()),
        Align::Axles { name, line, times, felt, speed } => {
            let Some(comb) = comb(times, *felt) else {
                let message = "axle times are finite, ascending numbers and an axle is felt for some time; not aligned"
                    .to_owned();
                log.could_not(run, "R065", message, "name times at which axles pass the sensor");
                return;
            };
            let (name, line, speed) = (name.clone(), line.clone(), *speed);
            let reference = Reference { name, line, times: comb.0, values: comb.1, speed };
            (reference, format!("to the passing of {}", findings::words::counted(times.len(), "axle")))
        }
    };
    let title = title(&reference.name, &reference.line);
    let sound = reference.times.len() == reference.values.len()
        && reference.times.len() >= 2
        && reference.times.windows(2).all(|pair| pair[1] > pair[0])
        && reference.values.iter().all(|value| value.is_finite());
    let any = || run.used().find(|channel| channel.name == reference.name && reference.line.is_empty());
    let channel = run.channel(&reference.name, &reference.line).filter(|channel| channel.used()).or_else(any);
    let Some(channel) = channel.filter(|channel| sound && channel.values.len() >= 2) else {
        let message =
            format!("`{title}` is not used in this run, or its reference is no ascending history; not aligned");
        log.could_not(run, "R065", message, "align by a channel that is used");
        return;
    };
    // A comb has no sign: it is laid on the channel's larger side.
    let sign = match align {
        Align::Axles { .. } => channel.peak().map_or(1.0, |k| channel.values[k].signum()),
        _ => 1.0,
    };
    let measured: Vec<f64> = channel.values.iter().map(|value| sign * value).collect();
    let own =
        run.speed.zip(reference.speed).map(|(own, of)| own / of).filter(|ratio| ratio.is_finite() && *ratio > 0.0);
    let reference = own.map_or_else(|| reference.clone(), |ratio| reference.faster(ratio));
    let (shift, correlation) = best_shift(&run.times, &measured, &reference, COARSE);
    pace::judge(run, &measured, &reference, correlation, log);
    if !(correlation >= WEAK) {
        let message = format!("`{title}` correlates with its reference by no more than {correlation:.2}; not aligned");
        log.could_not(run, "R065", message, "see whether the reference is of this train");
        return;
    }
    run.times.iter_mut().for_each(|time| *time += shift);
    run.time_step_shown = 0.0;
    log.did(
        &run.name,
        "",
        format!("clock shifted by {shift:+.5} s, which fits {title} {by} best (correlation {correlation:.4})"),
    );
}

/// Triangles over the axles' times.
fn comb(axles: &[f64], felt: f64) -> Option<(Vec<f64>, Vec<f64>)> {
    let sound = felt > 0.0 && axles.iter().all(|time| time.is_finite()) && axles.windows(2).all(|p| p[1] >= p[0]);
    let (first, last) = (*axles.first().filter(|_| sound)?, *axles.last()?);
    let step = felt / 16.0;
    let samples = ((last - first + 2.0 * felt) / step).ceil() + 1.0;
    if !(samples < 1e7) {
        return None;
    }
    let times: Vec<f64> = (0..samples as usize).map(|k| first - felt + k as f64 * step).collect();
    let mut values = vec![0.0; times.len()];
    for axle in axles {
        let from = times.partition_point(|time| *time < axle - felt);
        for k in from..times.partition_point(|time| *time <= axle + felt) {
            values[k] += 1.0 - (times[k] - axle).abs() / felt;
        }
    }
    Some((times, values))
}

/// The shift of the clock [s] at which a history fits a reference best, and the correlation there. The search looks at every
/// overlap of the two on a coarse clock, then narrows the best one down.
pub(super) fn best_shift(times: &[f64], values: &[f64], reference: &Reference, samples: usize) -> (f64, f64) {
    let (first, last) = (times[0], times[times.len() - 1]);
    let [begin, end] = [reference.times[0], reference.times[reference.times.len() - 1]];
    let step = ((last - first).max(end - begin) / samples as f64).max(f64::MIN_POSITIVE);
    let grid = |from: f64, to: f64| -> Vec<f64> {
        (0..=((to - from) / step).floor() as usize).map(|k| from + k as f64 * step).collect()
    };
    let coarse = |times: &[f64], values: &[f64], grid: &[f64]| at_times(times, values, grid);
    let (mine_at, theirs_at) = (grid(first, last), grid(begin, end));
    let mine = coarse(times, values, &mine_at);
    let theirs = coarse(&reference.times, &reference.values, &theirs_at);
    let (n, m) = (mine.len() as isize, theirs.len() as isize);
    // mine[k] falls on theirs[k + lag]; the shift is then begin + lag·step - first.
    let product = |lag: isize| -> f64 {
        let from = 0.max(-lag);
        (from..n.min(m - lag).max(from)).map(|k| mine[k as usize] * theirs[(k + lag) as usize]).sum()
    };
    let best = (1 - n..m).map(|lag| (lag, product(lag))).reduce(|a, b| if b.1 > a.1 { b } else { a });
    let centre = begin - first + best.map_or(0, |(lag, _)| lag) as f64 * step;
    let fit = |shift: f64| correlation(times, values, reference, shift);
    let shift = golden(centre - 2.0 * step, centre + 2.0 * step, |shift| fit(shift)[0]);
    let [product, mine, theirs] = fit(shift);
    (shift, product / (mine * theirs).sqrt().max(f64::MIN_POSITIVE))
}

/// Products over the samples that fall within the reference: mine by theirs, mine by mine, theirs by theirs.
fn correlation(times: &[f64], values: &[f64], reference: &Reference, shift: f64) -> [f64; 3] {
    let [begin, end] = [reference.times[0], reference.times[reference.times.len() - 1]];
    let from = times.partition_point(|time| time + shift < begin);
    let to = times.partition_point(|time| time + shift <= end).max(from);
    let at: Vec<f64> = times[from..to].iter().map(|time| time + shift).collect();
    let theirs = at_times(&reference.times, &reference.values, &at);
    values[from..to].iter().zip(&theirs).fold([0.0; 3], |[ab, aa, bb], (a, b)| [ab + a * b, aa + a * a, bb + b * b])
}

/// The place of a maximum between two ends, by the golden section.
pub(super) fn golden(low: f64, high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (low, high);
    let (mut c, mut d) = (b - ratio * (b - a), a + ratio * (b - a));
    let (mut fc, mut fd) = (f(c), f(d));
    // Thirty sections are a millionth of the coarse step.
    for _ in 0..30 {
        if fc >= fd {
            (b, d, fd) = (d, c, fc);
            c = b - ratio * (b - a);
            fc = f(c);
        } else {
            (a, c, fc) = (c, d, fd);
            d = a + ratio * (b - a);
            fd = f(d);
        }
    }
    0.5 * (a + b)
}
