//! Functions with known minima (benchmarks: upd.testfunctions).

use crate::common::{Function, least_squares, with};
use calibrate::search::{gradient, modern, referee};
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

        let downhill = gradient::search(evaluator, basis, &Start::Stated, 500).found.unwrap();
        assert!(downhill.norm < 1e-4, "{downhill:?}");
        assert!(downhill.evaluations > found.evaluations / 3, "least squares is the cheaper per start");

        let referee = referee::search(evaluator, basis, &referee::Settings::default());
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
        let zeros: Vec<&Vec<f64>> = outcome
            .minima
            .iter()
            .map(|k| &outcome.runs[*k])
            .filter(|run| run.norm < 1e-8)
            .map(|run| &run.end)
            .collect();
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
            gradient::search(evaluator, basis, &Start::Means, 200).found.unwrap(),
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
        let referee = referee::search(evaluator, basis, &referee::Settings::default()).found.unwrap();
        assert!(referee.norm < 1e-3, "{referee:?}");
    });
}
