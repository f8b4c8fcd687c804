//! A gain that all channels share: what only scales the records is no better known than the gain, what shapes them is.

use crate::common::{Function, Histories, with};
use calibrate::linearised::{Left, Linearised};
use calibrate::misfit::{Compare, Misfit, Scaling, Weights};
use calibrate::posterior::draw::{even, normal};
use calibrate::posterior::{self, Likelihood, ModelError, Posterior};
use calibrate::search::jacobian::STEP;
use calibrate::search::modern;
use calibrate::{Channel, Parameter, Problem};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

const LENGTH: usize = 12;
/// Standard deviation of the gain.
const GAIN: f64 = 0.1;
/// Standard deviation of one value; the largest are about one.
const NOISE: f64 = 0.01;

/// Two channels: a flexibility scales both, and a ratio shapes them.
fn scaled(x: &[f64]) -> Vec<Vec<f64>> {
    let t = |k: usize| (k as f64 + 0.5) / LENGTH as f64;
    let shape = |k: usize| (std::f64::consts::PI * t(k)).sin();
    let ratio = x.get(1).copied().unwrap_or(0.5);
    let one = (0..LENGTH).map(|k| x[0] * (shape(k) + ratio * (6.0 * t(k)).cos())).collect();
    let two = (0..LENGTH).map(|k| -x[0] * (0.5 + ratio) * shape(k)).collect();
    vec![one, two]
}

/// The same with a third channel that no parameter moves.
fn with_a_known_channel(x: &[f64]) -> Vec<Vec<f64>> {
    let mut all = scaled(x);
    all.push(scaled(&[1.0]).remove(0));
    all
}

fn parameters(count: usize) -> Vec<Parameter> {
    ["flexibility", "ratio"][..count].iter().map(|name| Parameter::new(name, "", 0.9, 0.4, 2.0)).collect()
}

fn problem(parameters: Vec<Parameter>, records: Vec<Vec<f64>>) -> Problem {
    let channel = |(k, history): (usize, Vec<f64>)| Channel {
        uncertainty: Some(NOISE),
        ..Channel::history(&format!("c{k}"), "", history)
    };
    let misfit = Misfit {
        compare: Compare::Histories,
        scaling: Scaling::Uncertainty,
        weights: Weights::Equal,
        ..Misfit::default()
    };
    Problem::new(parameters, records.into_iter().enumerate().map(channel).collect(), misfit).unwrap()
}

fn likelihood(common_gain: f64) -> Likelihood {
    Likelihood { model_error: ModelError::None, block: None, common_gain }
}

/// What both roads leave of a problem: the straight line about the best fit, and the samples.
fn left(problem: &Problem, values: Histories, common_gain: f64) -> (Left, Posterior) {
    let model = Function { channels: problem.channels().len(), length: LENGTH, values };
    with(problem, &model, |evaluator, basis| {
        let settings = modern::Settings { starts: 1, ..modern::Settings::default() };
        let point = modern::search(evaluator, basis, &settings).found.unwrap().point();
        let line = Linearised::at(evaluator, basis, &point, STEP).unwrap();
        let left = line.left(problem, &likelihood(common_gain), 1);
        let settings = posterior::Settings {
            likelihood: likelihood(common_gain),
            particles: 60,
            moves: 3,
            walkers: 20,
            effective_samples: 1000.0,
            steps: 400,
            ..posterior::Settings::default()
        };
        (left, posterior::sample(evaluator, basis, &settings).unwrap())
    })
}

/// Ends of 95 % of a density over a range, by sums over even cells.
fn ends(range: [f64; 2], density: impl Fn(f64) -> f64) -> [f64; 2] {
    let cells = 100_000;
    let at = |k: usize| range[0] + (range[1] - range[0]) * (k as f64 + 0.5) / f64::from(cells);
    let total: f64 = (0..cells as usize).map(|k| density(at(k))).sum();
    [0.025, 0.975].map(|share| {
        let mut sum = 0.0;
        at((0..cells as usize)
            .find(|k| {
                sum += density(at(*k));
                sum >= share * total
            })
            .unwrap())
    })
}

#[test]
fn what_scales_every_channel_has_the_interval_of_the_gain() {
    let problem = problem(parameters(1), scaled(&[1.0]));
    let (line, sampled) = left(&problem, scaled, GAIN);
    // The straight line: a normal distribution about the best fit with the gain's deviation.
    let [low, high] = line.parameters[0].interval_95;
    assert!((line.parameters[0].standard_deviation - GAIN).abs() < 0.02 * GAIN, "chance of 20,000 draws: {line:?}");
    assert!((low - 0.804).abs() < 0.008 && (high - 1.196).abs() < 0.008, "{line:?}");
    // The samples: with a record of one and a response of a, records less model have the variance of the gain times a².
    let density = |a: f64| (-0.5 * ((a - 1.0) / (GAIN * a)).powi(2)).exp() / a;
    let exact = ends([0.4, 2.0], density);
    let found = sampled.parameters[0].summary.interval_95;
    // Quantiles of 1000 effective samples: their standard deviation is a tenth of the distribution's.
    assert!((found[0] - exact[0]).abs() < 0.03 && (found[1] - exact[1]).abs() < 0.03, "{found:?} {exact:?}");
    for (told, gain, words) in [
        (line.told[0], line.common_gain.clone(), &line.words),
        (sampled.parameters[0].identifiable, sampled.common_gain.clone(), &sampled.words),
    ] {
        // The interval is a quarter of the range, and yet the records do not tell the parameter from the gain.
        let gain = gain.unwrap();
        assert!(!told && gain.shares[0] > 0.95 && (gain.standard_deviation / GAIN - 1.0).abs() < 0.1, "{gain:?}");
        assert!((gain.slopes[0] + 1.0).abs() < 0.1, "a gain of 10 % is a flexibility of 10 % less: {gain:?}");
        assert!(words.iter().any(|line| line.starts_with("flexibility is not told apart from a gain")), "{words:?}");
    }
}

#[test]
fn what_shapes_the_channels_is_told_though_their_size_is_not() {
    let problem = problem(parameters(2), scaled(&[1.0, 0.7]));
    let (line, sampled) = left(&problem, scaled, GAIN);
    let marginals = &sampled.parameters;
    assert_eq!(line.told, [false, true], "{line:?}");
    assert_eq!([marginals[0].identifiable, marginals[1].identifiable], [false, true], "{marginals:?}");
    // The gain takes next to nothing from what is told by shape: the interval is that of known loads.
    let (known, _) = left(&problem, scaled, 0.0);
    for (found, known) in [
        (line.parameters[1].standard_deviation, known.parameters[1].standard_deviation),
        (marginals[1].summary.standard_deviation, known.parameters[1].standard_deviation),
    ] {
        assert!((found / known - 1.0).abs() < 0.1, "{found} {known}");
    }
    assert!(line.parameters[0].standard_deviation > 10.0 * known.parameters[0].standard_deviation, "{known:?}");
}

#[test]
fn a_channel_that_no_parameter_moves_tells_the_gain() {
    let truth = [1.0, 0.7];
    let records = with_a_known_channel(&truth).iter().map(|row| row.iter().map(|u| 1.15 * u).collect()).collect();
    let problem = problem(parameters(2), records);
    let (line, sampled) = left(&problem, with_a_known_channel, GAIN);
    for gain in [line.common_gain, sampled.common_gain] {
        let gain = gain.unwrap();
        assert!((gain.mean - 1.15).abs() < 0.02 && gain.standard_deviation < 0.2 * GAIN, "{gain:?}");
        assert!(gain.shares.iter().all(|share| *share < 0.1), "{gain:?}");
    }
    assert_eq!(line.told, [true, true]);
    let summary = sampled.parameters[0].summary;
    assert!(summary.interval_95[0] < 1.0 && 1.0 < summary.interval_95[1], "{summary:?}");
}

#[test]
fn loads_that_count_as_exact_are_said_to() {
    let problem = problem(parameters(1), scaled(&[1.0]));
    let (line, sampled) = left(&problem, scaled, 0.0);
    assert!(line.told[0] && sampled.parameters[0].identifiable);
    for (gain, words) in [(line.common_gain, line.words), (sampled.common_gain, sampled.words)] {
        assert!(gain.is_none() && words.iter().any(|line| line.contains("count as exact")), "{words:?}");
    }
}

#[test]
fn a_hundred_twins_under_common_gains_are_held() {
    // By road and parameter.
    let (mut held, mut held_without) = ([[0; 2]; 2], 0);
    for seed in 0..100 {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let truth = [0.4 + 1.6 * even(&mut rng), 0.4 + 1.6 * even(&mut rng)];
        let gain = 1.0 + GAIN * normal(&mut rng);
        let mut records = scaled(&truth);
        records.iter_mut().flatten().for_each(|value| *value = gain * *value + NOISE * normal(&mut rng));
        let problem = problem(parameters(2), records);
        let (line, sampled) = left(&problem, scaled, GAIN);
        for k in 0..2 {
            let intervals = [line.parameters[k].interval_95, sampled.parameters[k].summary.interval_95];
            for (road, [low, high]) in intervals.into_iter().enumerate() {
                held[road][k] += usize::from(low <= truth[k] && truth[k] <= high);
            }
        }
        let [low, high] = left(&problem, scaled, 0.0).0.parameters[0].interval_95;
        held_without += usize::from(low <= truth[0] && truth[0] <= high);
    }
    // Of 100 trials of 0.95, fewer than 90 hold with a chance of 1.2 %, all of them with one of 0.6 %.
    assert!(held.iter().flatten().all(|held| (90..=99).contains(held)), "{held:?}");
    assert!(held_without < 50, "{held_without} of 100 with loads that count as exact");
}
