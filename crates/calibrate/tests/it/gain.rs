//! Amplitudes from whole histories under a gain of the model: intervals hold the truth whatever the count of samples.

use crate::common::Function;
use calibrate::misfit::{Compare, Misfit, Scaling, Weights};
use calibrate::posterior::draw::{even, normal};
use calibrate::posterior::{self, Likelihood, Marginal, ModelError};
use calibrate::{Basis, Channel, Evaluator, Parameter, Problem, Serial, Unwatched};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// Standard deviation of the model's gain.
const GAIN: f64 = 0.1;
/// Standard deviation of one value; the largest value at an amplitude of one is one.
const NOISE: f64 = 0.3;

/// A wave that fades in and out, as long as the record.
fn wave(length: usize) -> Vec<f64> {
    let t = |k: usize| (k as f64 + 0.5) / length as f64;
    (0..length).map(|k| (std::f64::consts::PI * t(k)).sin() * (9.0 * t(k)).cos()).collect()
}

/// Noise of variance one whose neighbours are correlated by `next`.
fn noise(length: usize, next: f64, rng: &mut ChaCha8Rng) -> Vec<f64> {
    let mut value = normal(rng);
    let mut step = || {
        let now = value;
        value = next * value + (1.0 - next * next).sqrt() * normal(rng);
        now
    };
    (0..length).map(|_| step()).collect()
}

fn of(record: Vec<f64>, correlated_over: Option<f64>, model_error: ModelError) -> Marginal {
    let length = record.len();
    let channel = Channel { uncertainty: Some(NOISE), correlated_over, ..Channel::history("crown", "mm", record) };
    let misfit = Misfit {
        compare: Compare::Histories,
        scaling: Scaling::Uncertainty,
        weights: Weights::Equal,
        ..Misfit::default()
    };
    let problem = Problem::new(vec![Parameter::new("a", "", 1.0, 0.5, 1.5)], vec![channel], misfit).unwrap();
    let shape = wave(length);
    let model =
        Function { channels: 1, length, values: |x: &[f64]| vec![shape.iter().map(|s| x[0] * s).collect::<Vec<_>>()] };
    let mut watch = Unwatched;
    let mut evaluator = Evaluator::without_log(&problem, &model, &Serial, &mut watch);
    let basis = Basis::at(&mut evaluator, &problem.start()).unwrap();
    let settings = posterior::Settings {
        likelihood: Likelihood { model_error, block: None, common_gain: 0.0 },
        particles: 40,
        moves: 2,
        walkers: 20,
        effective_samples: 300.0,
        steps: 100,
        ..posterior::Settings::default()
    };
    posterior::sample(&mut evaluator, &basis, &settings).unwrap().parameters.remove(0)
}

/// How many of `seeds` intervals hold the truth, and their mean width over that of the exact ones.
fn coverage(length: usize, next: f64, seeds: u64, told: impl Fn(&[f64]) -> Option<f64>) -> (usize, f64) {
    let shape = wave(length);
    let squares: f64 = shape.iter().map(|s| s * s).sum();
    let (mut held, mut widths) = (0, 0.0);
    for seed in 0..seeds {
        let mut rng = ChaCha8Rng::seed_from_u64(seed + 1000 * length as u64);
        let truth = 0.5 + even(&mut rng);
        let gain = 1.0 + GAIN * normal(&mut rng);
        let errors: Vec<f64> = noise(length, next, &mut rng).iter().map(|e| NOISE * e).collect();
        let record = shape.iter().zip(&errors).map(|(s, e)| truth * gain * s + e).collect();
        let [low, high] = of(record, told(&errors), ModelError::Known(GAIN)).summary.interval_95;
        held += usize::from(low <= truth && truth <= high);
        let over = (1.0 + next) / (1.0 - next);
        let exact = 3.92 * (GAIN.powi(2) * truth * truth + NOISE.powi(2) * over / squares).sqrt();
        widths += (high - low) / exact / seeds as f64;
    }
    (held, widths)
}

#[test]
fn an_amplitude_is_not_pulled_down_by_the_noise_of_its_record() {
    for length in [12, 500, 5000] {
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let errors = noise(length, 0.0, &mut rng);
        let record: Vec<f64> = wave(length).iter().zip(errors).map(|(s, e)| s + NOISE * e).collect();
        let squares: f64 = wave(length).iter().map(|s| s * s).sum();
        for model_error in [ModelError::Known(GAIN), ModelError::Sought(GAIN)] {
            let found = of(record.clone(), None, model_error);
            // The record tells the amplitude to this; a gain about one moves the mean by its square.
            let told = NOISE / squares.sqrt();
            let away = (found.summary.mean - 1.0).abs();
            assert!(away < 3.0 * told + 4.0 * GAIN * GAIN, "{length}: {found:?}");
            let [low, high] = found.summary.interval_95;
            assert!(low < 1.0 && 1.0 < high, "{length}: {found:?}");
        }
    }
}

#[test]
fn amplitudes_of_long_and_short_records_are_held_by_95_per_cent_of_the_intervals() {
    // Of n trials of 0.95 three standard deviations are 3 sqrt(0.0475 n): 6.5 of 100, 3.6 of 30.
    for (length, seeds, least) in [(12, 100, 89), (500, 100, 89), (5000, 30, 25)] {
        let (held, width) = coverage(length, 0.0, seeds, |_| None);
        assert!(held >= least, "{length}: {held} of {seeds}");
        // Ranges cut the longest intervals.
        assert!((0.7..1.25).contains(&width), "{length}: {width}");
    }
}

#[test]
fn samples_of_a_slow_record_do_not_count_as_independent() {
    // Neighbours correlated by 0.9: nineteen values tell as much as one.
    for (length, seeds, least) in [(500, 100, 89), (5000, 20, 17)] {
        for told in [|_: &[f64]| Some(19.0), |errors: &[f64]| Some(calibrate::channel::correlated_over(errors))] {
            let (held, width) = coverage(length, 0.9, seeds, told);
            assert!(held >= least, "{length}: {held} of {seeds}");
            assert!((0.7..1.25).contains(&width), "{length}: {width}");
        }
    }
}
