//! Intervals of the straight line, against closed forms and against the posterior.

use crate::common::{Function, five_model, five_parameters, five_problem, least_squares, with};
use calibrate::identify::identify;
use calibrate::linearised::{Left, Linearised};
use calibrate::misfit::{Misfit, Weights};
use calibrate::posterior::{self, Likelihood, ModelError};
use calibrate::search::jacobian::STEP;
use calibrate::{Channel, Parameter, Problem};

const EXACT: Likelihood = Likelihood { model_error: ModelError::None, block: None, common_gain: 0.0 };

#[test]
fn one_parameter_has_its_normal_cut_off_at_the_range() {
    let one = |measured: f64, at: f64| -> Left {
        let parameters = vec![Parameter::new("a", "", 0.5, 0.0, 1.0)];
        let channel = Channel { uncertainty: Some(0.1), ..Channel::peak("one", "", measured) };
        let misfit = Misfit { weights: Weights::Equal, ..Misfit::default() };
        let problem = Problem::new(parameters, vec![channel], misfit).unwrap();
        let model = Function { channels: 1, length: 1, values: |x: &[f64]| vec![vec![x[0]]] };
        with(&problem, &model, |evaluator, basis| {
            let line = Linearised::at(evaluator, basis, &[at], STEP).unwrap();
            line.left(&problem, &EXACT, 1)
        })
    };
    // Inside: the normal of the noise.
    let inside = one(0.5, 0.5);
    let [low, high] = inside.parameters[0].interval_95;
    assert!((low - 0.304).abs() < 0.006 && (high - 0.696).abs() < 0.006, "{inside:?}");
    assert!((inside.parameters[0].standard_deviation - 0.1).abs() < 0.002 && inside.told[0], "{inside:?}");
    // A record one deviation beyond the range, the search on the bound: of what is left above one, Phi(-1) = 0.158655, 95 % lie
    // above the normal's quantile at 0.05 * 0.158655, 2.4129 deviations below the record.
    let outside = one(1.1, 1.0);
    let [low, high] = outside.parameters[0].interval_95;
    assert!(high == 1.0 && (low - (1.1 - 0.24129)).abs() < 0.004, "{outside:?}");
    assert!(!outside.told[0] && outside.words.iter().any(|line| line.contains("ends on a bound")), "{outside:?}");
}

#[test]
fn a_sum_is_told_and_its_parts_fill_their_ranges() {
    let range = |name: &str| Parameter::new(name, "", 0.5, 0.0, 1.0);
    let problem = least_squares(vec![range("a"), range("b")], &[100.0]);
    let sum = |x: &[f64]| vec![vec![100.0 * (x[0] + x[1])]];
    with(&problem, &Function { channels: 1, length: 1, values: sum }, |evaluator, basis| {
        let line = Linearised::at(evaluator, basis, &[0.5, 0.5], STEP).unwrap();
        let left = line.left(&problem, &EXACT, 1);
        assert!(left.correlation[0][1] < -0.99 && left.told == [false, false], "{left:?}");
        // Even between the bounds, along the line on which the sum is one.
        assert!((left.parameters[0].standard_deviation - 12.0_f64.sqrt().recip()).abs() < 0.01, "{left:?}");
    });
}

#[test]
fn the_straight_line_says_what_the_posterior_says_and_asks_for_nothing_more() {
    let truth = [1.2, 0.8, 1.1, 0.7, 1.3];
    let mut channels: Vec<Channel> = five_problem(&truth, Misfit::default()).channels().to_vec();
    for channel in &mut channels {
        channel.uncertainty = Some(0.01 * channel.measured_peak().unwrap().abs());
    }
    let problem = Problem::new(five_parameters(), channels, Misfit::default()).unwrap();
    with(&problem, &five_model(), |evaluator, basis| {
        identify(evaluator, basis, &truth, STEP).unwrap();
        let before = evaluator.computed;
        let line = Linearised::at(evaluator, basis, &truth, STEP).unwrap();
        assert!(evaluator.computed - before <= 1, "the point itself");
        let likelihood = Likelihood { model_error: ModelError::Sought(0.02), block: None, common_gain: 0.0 };
        let left = line.left(&problem, &likelihood, 1);
        let sampling = posterior::Settings {
            likelihood,
            effective_samples: 2000.0,
            steps: 2000,
            ..posterior::Settings::default()
        };
        let whole = posterior::sample(evaluator, basis, &sampling).unwrap();
        for (k, marginal) in whole.parameters.iter().enumerate() {
            let (line, whole) = (left.parameters[k], marginal.summary);
            // The model is curved: a tenth of a deviation and of an interval are what the line may miss here.
            assert!((line.mean - whole.mean).abs() < 0.25 * whole.standard_deviation, "{k}: {line:?} {whole:?}");
            let ratio = line.standard_deviation / whole.standard_deviation;
            assert!((0.8..1.25).contains(&ratio), "{k}: {line:?} {whole:?}");
        }
        let sweeps = line.sweeps(&problem, &basis.held, &basis.start, 11);
        assert_eq!(sweeps.len(), 5);
        // Records of the model itself: at the truth the norm is nothing, and every parameter shows.
        assert!(sweeps.iter().all(|sweep| sweep.range() > 0.05 && sweep.error_range(0) > 0.0), "{sweeps:?}");
    });
}

#[test]
fn channels_without_an_uncertainty_are_named() {
    let problem = five_problem(&[1.0; 5], Misfit::default());
    with(&problem, &five_model(), |evaluator, basis| {
        let line = Linearised::at(evaluator, basis, &[1.0; 5], STEP).unwrap();
        let left = line.left(&problem, &Likelihood::default(), 1);
        assert!(left.words[0].starts_with("No uncertainty is stated for crown, pier"), "{:?}", left.words);
        assert!(left.parameters.iter().all(|summary| summary.standard_deviation > 0.0));
    });
}

#[test]
fn a_posterior_that_a_bound_cuts_off_does_not_tell_its_parameter() {
    let parameters = vec![Parameter::new("a", "", 0.5, 0.0, 1.0)];
    let channel = Channel { uncertainty: Some(0.05), ..Channel::peak("one", "", 1.05) };
    let misfit = Misfit { weights: Weights::Equal, ..Misfit::default() };
    let problem = Problem::new(parameters, vec![channel], misfit).unwrap();
    let model = Function { channels: 1, length: 1, values: |x: &[f64]| vec![vec![x[0]]] };
    with(&problem, &model, |evaluator, basis| {
        let likelihood = Likelihood { model_error: ModelError::None, block: None, common_gain: 0.0 };
        let settings = posterior::Settings { likelihood, effective_samples: 500.0, ..posterior::Settings::default() };
        let found = posterior::sample(evaluator, basis, &settings).unwrap();
        assert_eq!(found.parameters[0].summary.interval_95[1], 1.0, "{found:?}");
        assert!(!found.parameters[0].identifiable, "{found:?}");
        assert!(found.words.iter().any(|line| line.contains("ends on a bound")), "{:?}", found.words);
    });
}
