//! Functions with known minima (benchmarks: upd.testfunctions).

use crate::common::{Function, least_squares, minima, with};
use calibrate::posterior::{self, Likelihood, ModelError};
use calibrate::search::{gradient, hierarchical, modern, referee};
use calibrate::{Parameter, Start};

fn parameter(name: &str, start: f64, lower: f64, upper: f64) -> Parameter {
    Parameter::new(name, "", start, lower, upper)
}

/// Rosenbrock's valley as least squares; a peak is taken in the measured sense, so that a channel is the residual itself.
fn rosenbrock(x: &[f64]) -> Vec<Vec<f64>> {
    vec![vec![10.0 * (x[1] - x[0] * x[0])], vec![1.0 - x[0]]]
}

fn himmelblau(x: &[f64]) -> Vec<Vec<f64>> {
    vec![vec![x[0] * x[0] + x[1]], vec![x[0] + x[1] * x[1]]]
}

#[test]
fn every_search_finds_the_end_of_rosenbrocks_valley() {
    let problem = least_squares(vec![parameter("x", -1.2, -2.0, 2.0), parameter("y", 1.0, -1.0, 3.0)], &[0.0, 0.0]);
    let model = Function { channels: 2, length: 1, values: rosenbrock };
    with(&problem, &model, |evaluator, basis| {
        let settings = modern::Settings { starts: 3, ..modern::Settings::default() };
        let found = modern::search(evaluator, basis, &settings);
        assert_eq!(found.status, modern::Status::Converged, "{found:?}");
        // The function's minimum is 0 at (1, 1), 1e-8 asked; the residuals are polynomials, differences cost rounding.
        let found = found.found.unwrap();
        assert!(found.norm < 1e-8 && found.point().iter().all(|x| (x - 1.0).abs() < 1e-6), "{found:?}");
        assert!(found.parameters.iter().all(|parameter| parameter.converged && !parameter.at_bound));

        let downhill = gradient::search(evaluator, basis, Start::Stated, 500).found.unwrap();
        assert!(downhill.norm < 1e-4, "{downhill:?}");
        assert!(downhill.evaluations > found.evaluations / 3, "least squares is the cheaper per start");

        let referee = referee::search(evaluator, basis, 1, referee::GENERATIONS);
        // The distribution ends a ten-thousandth of the ranges wide.
        assert!(referee.found.as_ref().unwrap().norm < 1e-3, "{referee:?}");
    });
}

#[test]
fn many_starts_find_all_four_zeros_of_himmelblaus_function() {
    let range = |name| parameter(name, 0.0, -5.0, 5.0);
    let problem = least_squares(vec![range("x"), range("y")], &[11.0, 7.0]);
    let model = Function { channels: 2, length: 1, values: himmelblau };
    with(&problem, &model, |evaluator, basis| {
        let settings = modern::Settings { starts: 24, ..modern::Settings::default() };
        let outcome = modern::search(evaluator, basis, &settings);
        let minima = minima(problem.parameters(), &outcome).into_iter();
        let zeros: Vec<&Vec<f64>> = minima.filter(|run| run.norm < 1e-8).map(|run| &run.end).collect();
        for (x, y) in [(3.0, 2.0), (-2.805_118, 3.131_312), (-3.779_310, -3.283_186), (3.584_428, -1.848_126)] {
            // The published zeros have six digits.
            assert!(zeros.iter().any(|z| (z[0] - x).abs() < 1e-5 && (z[1] - y).abs() < 1e-5), "{x} {y}: {zeros:?}");
        }
        assert_eq!(zeros.len(), 4);
    });
}

#[test]
fn a_minimum_outside_the_range_ends_on_the_bound_and_is_not_converged() {
    let problem = least_squares(vec![parameter("x", 0.5, 0.0, 0.8), parameter("y", 0.5, 0.0, 2.0)], &[1.0, 1.0]);
    let model = Function { channels: 2, length: 1, values: |x: &[f64]| vec![vec![x[0]], vec![x[1]]] };
    with(&problem, &model, |evaluator, basis| {
        for found in [
            modern::search(evaluator, basis, &modern::Settings::default()).found.unwrap(),
            gradient::search(evaluator, basis, Start::Means, 200).found.unwrap(),
        ] {
            assert_eq!(found.parameters[0].value, 0.8);
            assert!(found.parameters[0].at_bound && !found.parameters[0].converged);
            assert!((found.parameters[1].value - 1.0).abs() < 1e-6 && found.parameters[1].converged);
        }
    });
}

#[test]
fn a_model_that_fails_in_places_is_searched_around_them() {
    use calibrate::{Evaluation, Failure, Forward, Request, Response};
    struct Fails;
    impl Forward for Fails {
        fn evaluate(&self, x: &[f64], _: &Request) -> Evaluation {
            if x[0] + x[1] > 2.5 {
                return Err(Failure::new("not-converged", "too soft"));
            }
            Ok(Response { values: vec![vec![x[0]], vec![x[1]]], derivatives: Vec::new() })
        }
        fn length(&self, _: usize) -> usize {
            1
        }
    }
    let problem = least_squares(vec![parameter("x", 0.5, 0.0, 2.0), parameter("y", 0.5, 0.0, 2.0)], &[1.0, 1.0]);
    with(&problem, &Fails, |evaluator, basis| {
        let found = modern::search(evaluator, basis, &modern::Settings::default()).found.unwrap();
        assert!(found.norm < 1e-8, "{found:?}");
        let referee = referee::search(evaluator, basis, 1, referee::GENERATIONS).found.unwrap();
        assert!(referee.norm < 1e-3, "{referee:?}");
    });
}

#[test]
fn one_parameter_alone_and_more_parameters_than_channels_are_searched_too() {
    for n in [1, 3] {
        let parameters = (0..n).map(|k| parameter(&format!("p{k}"), 0.5, 0.0, 1.0)).collect();
        let problem = least_squares(parameters, &[0.3 * n as f64]);
        let model = Function { channels: 1, length: 1, values: |x: &[f64]| vec![vec![x.iter().sum()]] };
        with(&problem, &model, |evaluator, basis| {
            for found in [
                modern::search(evaluator, basis, &modern::Settings::default()).found,
                gradient::search(evaluator, basis, Start::Stated, 100).found,
                referee::search(evaluator, basis, 1, referee::GENERATIONS).found,
                hierarchical::search(evaluator, basis, &hierarchical::Settings::default()).found,
            ] {
                // Sums of tenths stand on the grid; the referee's distribution ends a ten-thousandth wide.
                assert!(found.as_ref().unwrap().norm < 1e-3, "{n}: {found:?}");
            }
            let settings = posterior::Settings {
                likelihood: Likelihood { model_error: ModelError::Known(0.1), block: None, common_gain: 0.0 },
                particles: 50,
                effective_samples: 300.0,
                ..posterior::Settings::default()
            };
            let found = posterior::sample(evaluator, basis, &settings).unwrap();
            assert_eq!(found.status, posterior::Status::Completed, "{n}");
            // An uncertainty of one beside a range of one: nothing is told.
            assert!(found.parameters.iter().all(|marginal| !marginal.identifiable) && found.words.len() >= n);
        });
    }
}

#[test]
fn a_gradient_search_costs_no_more_than_its_evaluations() {
    use calibrate::{Evaluation, Forward, Request, Response, Samples};
    use std::sync::atomic::{AtomicUsize, Ordering};
    /// Rosenbrock's valley, which counts how often anybody asks for an answer, known or not.
    struct Asked(AtomicUsize);
    impl Forward for Asked {
        fn evaluate(&self, x: &[f64], _: &Request) -> Evaluation {
            Ok(Response { values: rosenbrock(x), derivatives: Vec::new() })
        }
        fn has_sensitivities(&self, _: &Samples) -> bool {
            self.0.fetch_add(1, Ordering::Relaxed);
            false
        }
        fn length(&self, _: usize) -> usize {
            1
        }
    }
    let problem = least_squares(vec![parameter("x", -1.2, -2.0, 2.0), parameter("y", 1.0, -1.0, 3.0)], &[0.0, 0.0]);
    let model = Asked(AtomicUsize::new(0));
    with(&problem, &model, |evaluator, basis| {
        let found = gradient::search(evaluator, basis, Start::Stated, 500).found.unwrap();
        let asked = model.0.load(Ordering::Relaxed);
        assert!(found.evaluations > 50, "{found:?}");
        assert!(asked < 10 * found.evaluations, "{asked} questions for {} evaluations", found.evaluations);
    });
}

#[test]
fn a_problem_says_everything_that_is_wrong_with_it() {
    use calibrate::{Channel, Misfit, Problem};
    let parameters = vec![
        parameter("E", 3.0, 2.0, 1.0),
        parameter("E", 0.0, 0.0, 1.0).logarithmic(),
        parameter("k", f64::NAN, 0.0, f64::INFINITY),
    ];
    let channels = vec![
        Channel::peak("crown", "mm", 0.0),
        Channel::history("pier", "mm", vec![1.0, f64::NAN]),
        Channel::default(),
    ];
    let findings = Problem::new(parameters, channels, Misfit::default()).unwrap_err();
    let at = |place: &str| findings.iter().filter(|finding| finding.place == place).count();
    assert_eq!((at("E"), at("k"), at("crown"), at("pier"), at("")), (3, 1, 2, 1, 2), "{findings:#?}");
}
