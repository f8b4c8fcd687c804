//! Synthetic records: exact histories as a logger would have written them, labelled synthetic.

use crate::{Channel, Recording, Unit};
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;

/// An exact history.
#[derive(Debug, Clone, PartialEq)]
pub struct Exact {
    /// Channel.
    pub name: String,
    /// Its line; empty where none is named.
    pub line: String,
    /// Unit of the cells.
    pub unit: Unit,
    /// Values at the times of the run [SI].
    pub values: Vec<f64>,
    /// Step to which values are rounded [SI]; 0 leaves every digit.
    pub least_count: f64,
    /// Standard deviation of normal noise, added before rounding [SI].
    pub deviation: f64,
}

/// What is done to exact histories beside the noise of each.
#[derive(Debug, Clone, PartialEq)]
pub struct Noise {
    /// Sampling rate [Hz]; None keeps the exact times. Values between exact ones lie on straight lines.
    pub rate: Option<f64>,
    /// Seed: the same one gives the same record.
    pub seed: u64,
    /// What made the histories, for the label: "railway-arch, parameters of Table 6".
    pub origin: String,
}

/// A run as a logger would have written it. Its values are those that [`read`](crate::read) gets from the written file, to the
/// last bit, and it says that it is synthetic and how it was made. `times` [s] are those of the exact values.
///
/// Every channel draws from a generator of its own, so that one more channel changes no other.
pub fn synthesise(name: &str, speed: Option<f64>, times: &[f64], exact: &[Exact], noise: &Noise) -> Recording {
    let rate = noise.rate.filter(|rate| *rate > 0.0 && rate.is_finite());
    let clock = clock(times, rate);
    let histories = exact.iter().enumerate();
    let channels = histories.map(|(k, history)| channel(k, history, times, &clock, noise.seed)).collect();
    Recording {
        name: name.to_owned(),
        speed,
        synthetic: Some(label(exact, rate, noise)),
        notes: Vec::new(),
        lines: vec![0; clock.len()],
        times: clock,
        time_step_shown: 0.0,
        channels,
    }
}

/// Times k/rate from the first exact time to the last; a record of more than fifty million samples ends there.
fn clock(times: &[f64], rate: Option<f64>) -> Vec<f64> {
    let (Some(rate), Some(first), Some(last)) = (rate, times.first(), times.last()) else { return times.to_vec() };
    let samples = (((last - first) * rate * (1.0 + 1e-12)).floor() + 1.0).clamp(0.0, 5e7);
    (0..samples as usize).map(|k| first + k as f64 / rate).collect()
}

fn channel(index: usize, history: &Exact, times: &[f64], clock: &[f64], seed: u64) -> Channel {
    // Streams of one seed do not overlap.
    let mut generator = Pcg64::new(u128::from(seed), index as u128);
    let unit = history.unit;
    let step = unit.of_si(history.least_count);
    let decimals = decimals(step);
    let rounds = history.least_count > 0.0 && step.is_finite();
    let value = |at: f64| -> f64 {
        let mut value = interpolated(times, &history.values, at);
        if history.deviation > 0.0 {
            let normal: f64 = StandardNormal.sample(&mut generator);
            value += history.deviation * normal;
        }
        if !rounds || !value.is_finite() {
            // The value of the cell that will be printed.
            return unit.to_si(unit.of_si(value));
        }
        let count = (value / history.least_count).round();
        // The cell is printed with its decimals and read again: what is in memory is what stands in the file.
        let cell = format!("{:.decimals$}", count * step);
        unit.to_si(cell.parse::<f64>().unwrap_or(f64::NAN)) + 0.0
    };
    Channel {
        name: history.name.clone(),
        line: history.line.clone(),
        unit,
        column: index + 2,
        values: clock.iter().copied().map(value).collect(),
        decimals: rounds.then_some(decimals),
        left_out: None,
    }
}

/// Decimals that show every multiple of a step: 2 of 0.05, 1 of 0.5.
fn decimals(step: f64) -> usize {
    let whole = |digits: &usize| {
        let scaled = step * 10.0_f64.powi(*digits as i32);
        (scaled - scaled.round()).abs() < 1e-6 * scaled.abs() && scaled.round() != 0.0
    };
    (0..12).find(whole).unwrap_or(12)
}

fn interpolated(times: &[f64], values: &[f64], at: f64) -> f64 {
    let k = times.partition_point(|time| *time < at);
    match (k.checked_sub(1).and_then(|k| values.get(k)), values.get(k)) {
        (_, Some(value)) if times.get(k) == Some(&at) => *value,
        (Some(before), Some(after)) => {
            let share = (at - times[k - 1]) / (times[k] - times[k - 1]);
            before + share * (after - before)
        }
        (None, Some(first)) => *first,
        (Some(last), None) => *last,
        (None, None) => f64::NAN,
    }
}

fn label(exact: &[Exact], rate: Option<f64>, noise: &Noise) -> String {
    let mut kinds: Vec<String> = Vec::new();
    for history in exact {
        let step = if history.least_count > 0.0 {
            format!("rounded to {} {}", shown(history.unit.of_si(history.least_count)), history.unit.symbol)
        } else {
            format!("{} not rounded", history.unit.symbol)
        };
        let normal = if history.deviation > 0.0 {
            format!(" after normal noise of {} {}", shown(history.unit.of_si(history.deviation)), history.unit.symbol)
        } else {
            String::new()
        };
        let kind = step + &normal;
        if !kinds.contains(&kind) {
            kinds.push(kind);
        }
    }
    let clock = rate.map_or("at the times computed".to_owned(), |rate| format!("at {rate} Hz"));
    let origin = if noise.origin.is_empty() { String::new() } else { format!(" from {}", noise.origin) };
    format!("computed{origin}, not measured; {clock}; {}; seed {}", kinds.join("; "), noise.seed)
        .replace(['\n', '\r'], " ")
}

/// A number as somebody would have written it: twelve digits, so that 5e-8 is 0.05 microstrain and no more.
fn shown(number: f64) -> f64 {
    format!("{number:.11e}").parse().unwrap_or(number)
}
