//! Low pass: Butterworth of second order, run forward and backward, so that nothing is moved in time.

use crate::{Recording, Series};
use std::f64::consts::{PI, SQRT_2};

/// A section of second order: `y = b0 x + b1 x' + b2 x'' - a1 y' - a2 y''`.
#[derive(Debug, Clone, Copy)]
struct Section {
    b: [f64; 3],
    a: [f64; 2],
}

/// Butterworth by the bilinear transform, for a cutoff in parts of the sampling rate. Two passes halve the power of one pass
/// again; each is set wider by (√2 - 1)^(-1/4) = 1.25, so that the two together reach 0.707 at the cutoff.
fn section(cutoff: f64) -> Section {
    let w = (PI * cutoff).tan() / (SQRT_2 - 1.0).powf(0.25);
    let scale = 1.0 / (1.0 + SQRT_2 * w + w * w);
    let b0 = w * w * scale;
    Section { b: [b0, 2.0 * b0, b0], a: [2.0 * (w * w - 1.0) * scale, (1.0 - SQRT_2 * w + w * w) * scale] }
}

/// Width of the band of a flat spectrum that holds as much noise as the low pass lets through [Hz]: the integral of the square of
/// 1/(1 + (√2 - 1) r⁴) over the frequency, r its ratio to the cutoff.
pub fn noise_bandwidth(cutoff: f64) -> f64 {
    // The integral of 1/(1 + x⁴)² from zero on is 3π/(8√2).
    cutoff * 3.0 * PI / (8.0 * SQRT_2) / (SQRT_2 - 1.0).powf(0.25)
}

/// One pass in place, starting as if the first value had stood for ever.
fn pass(section: Section, values: &mut [f64]) {
    let Section { b, a } = section;
    let first = values.first().copied().unwrap_or(0.0);
    let mut second = (b[2] - a[1]) * first;
    let mut state = (b[1] - a[0]) * first + second;
    for value in values {
        let x = *value;
        let y = b[0] * x + state;
        state = b[1] * x - a[0] * y + second;
        second = b[2] * x - a[1] * y;
        *value = y;
    }
}

/// Forward and backward, the ends carried on by point reflection.
fn both_ways(section: Section, values: &[f64], pad: usize) -> Vec<f64> {
    let n = values.len();
    let pad = pad.min(n.saturating_sub(1));
    let (first, last) = (values[0], values[n - 1]);
    let mut long: Vec<f64> = (1..=pad).rev().map(|k| 2.0 * first - values[k]).collect();
    long.extend_from_slice(values);
    long.extend((1..=pad).map(|k| 2.0 * last - values[n - 1 - k]));
    pass(section, &mut long);
    long.reverse();
    pass(section, &mut long);
    long.reverse();
    long[pad..pad + n].to_vec()
}

/// Filters every used channel of a run with a regular clock.
pub(super) fn low_pass(run: &mut Recording, cutoff: f64, why: &str, log: &mut Series) {
    let rate = 1.0 / run.interval().max(f64::MIN_POSITIVE);
    if !(cutoff > 0.0 && cutoff < 0.5 * rate) {
        let message = format!("a low pass at {cutoff} Hz does not fit a rate of {rate:.4} Hz; nothing was filtered");
        log.could_not(run, "R062", message, "name a frequency between 0 and half the rate");
        return;
    }
    let section = section(cutoff / rate);
    // Three periods of the cutoff: what the ends are carried on by has died away to a millionth by then.
    let pad = (3.0 * rate / cutoff).ceil().min(1e7) as usize;
    for channel in run.channels.iter_mut().filter(|channel| channel.used() && !channel.values.is_empty()) {
        let before = channel.peak().map_or(0.0, |k| channel.values[k]);
        channel.values = both_ways(section, &channel.values, pad);
        let after = channel.peak().map_or(0.0, |k| channel.values[k]);
        channel.decimals = None;
        let peak = format!("from {} to {}", channel.unit.words(before), channel.unit.words(after));
        let what = format!(
            "low pass at {cutoff} Hz (Butterworth of second order, forward and backward, 0.707 there){why}; the peak goes {peak}"
        );
        log.did(&run.name, &channel.title(), what);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Amplitude and shift of a sine after filtering, from its projections on sine and cosine over whole periods.
    fn answer(frequency: f64, cutoff: f64) -> [f64; 2] {
        let (rate, n) = (200.0, 4000);
        let phase = |k: usize| 2.0 * PI * frequency * k as f64 / rate;
        let values: Vec<f64> = (0..n).map(|k| phase(k).sin()).collect();
        let out = both_ways(section(cutoff / rate), &values, 60);
        let middle = 1000..3000;
        let project = |f: fn(f64) -> f64| middle.clone().map(|k| out[k] * f(phase(k))).sum::<f64>() / 1000.0;
        [project(f64::sin), project(f64::cos)]
    }

    #[test]
    fn the_cutoff_is_where_the_amplitude_is_root_half_and_nothing_is_moved() {
        for (frequency, expected) in [(20.0, 0.5_f64.sqrt()), (1.0, 1.0)] {
            let [amplitude, moved] = answer(frequency, 20.0);
            // The amplitude at 1 Hz is 1/(1 + (√2 - 1)·20^-4), within 3e-6 of one.
            assert!((amplitude - expected).abs() < 1e-5, "{frequency}: {amplitude}");
            assert!(moved.abs() < 1e-9, "{frequency}: {moved}");
        }
        // Analytically 1/(1 + (√2 - 1) r^4), r the ratio of the tangents: tan(0.3π)/tan(0.1π).
        let ratio = (0.3 * PI).tan() / (0.1 * PI).tan();
        let expected = 1.0 / (1.0 + (SQRT_2 - 1.0) * ratio.powi(4));
        assert!((answer(60.0, 20.0)[0] - expected).abs() < 1e-9);
    }

    #[test]
    fn the_noise_that_is_let_through_is_that_of_its_band() {
        // By sums over the analytic answer up to twenty times the cutoff; the rest is below 1e-8 of it.
        let (cutoff, step) = (10.0, 0.01);
        let power = |k: i32| (1.0 + (SQRT_2 - 1.0) * (f64::from(k) * step / cutoff).powi(4)).powi(-2);
        let sum: f64 = (0..20_000).map(power).sum::<f64>() - 0.5;
        assert!((noise_bandwidth(cutoff) / (sum * step) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn a_constant_and_a_straight_line_stay_what_they_are() {
        let line: Vec<f64> = (0..500).map(|k| 3.0 + 0.01 * f64::from(k)).collect();
        let out = both_ways(section(0.05), &line, 60);
        let worst = line.iter().zip(&out).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // What is left at the ends is the start of a pass, damped over the 60 samples that were carried on.
        assert!(worst < 1e-4, "{worst}");
        let still = both_ways(section(0.05), &[2.0; 50], 60);
        assert!(still.iter().all(|value| (value - 2.0).abs() < 1e-12));
    }
}
