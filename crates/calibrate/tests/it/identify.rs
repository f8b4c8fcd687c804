//! What the data tell of functions of which it is known, and a surrogate in their place.

use crate::common::{Function, LENGTH, five, five_model, five_problem, least_squares, with};
use calibrate::identify::identify;
use calibrate::misfit::{Compare, Misfit};
use calibrate::posterior::{self, Likelihood, ModelError};
use calibrate::search::jacobian::STEP;
use calibrate::search::modern;
use calibrate::surrogate::build;
use calibrate::{
    Basis, Channel, Evaluation, Evaluator, Failure, Forward, Parameter, Problem, Request, Response, Samples, Serial,
    Unwatched,
};

const TRUTH: [f64; 5] = [1.2, 0.8, 1.1, 0.7, 1.3];

#[test]
fn a_sum_is_told_and_its_parts_are_not() {
    let range = |name: &str| Parameter::new(name, "", 0.5, 0.0, 1.0);
    let problem = least_squares(vec![range("a"), range("b"), range("c")], &[1.0, 1.0, 0.5]);
    let sum = |x: &[f64]| vec![vec![x[0] + x[1]], vec![2.0 * (x[0] + x[1]) - 1.0], vec![x[2]]];
    with(&problem, &Function { channels: 3, length: 1, values: sum }, |evaluator, basis| {
        let found = identify(evaluator, basis, &[0.5, 0.5, 0.5], STEP).unwrap();
        assert_eq!((found.rank, found.identifiable.clone()), (2, vec![false, false, true]), "{found:?}");
        assert!(found.condition > 1e6);
        assert!(found.words.iter().any(|line| line.starts_with("a and b act alike")), "{:?}", found.words);
        assert!(found.words.iter().any(|line| line.starts_with("The data determine 2 of 3")));
    });
}

/// The model of five channels with derivatives by complex-free closed form: only the size depends on the others.
struct Exact;

impl Forward for Exact {
    fn evaluate(&self, x: &[f64], request: &Request) -> Evaluation {
        if request.samples != calibrate::Samples::All {
            return Err(Failure::new("not-here", "full passages alone"));
        }
        let derivative = |k: usize| {
            // Central differences with Richardson's extrapolation: to rounding, 1e-12 of the values.
            let at = |h: f64| {
                let mut point = x.to_vec();
                point[k] += h;
                five(&point)
            };
            let slope = |h: f64| -> Vec<Vec<f64>> {
                let (up, down) = (at(h), at(-h));
                up.iter().zip(&down).map(|(u, d)| u.iter().zip(d).map(|(u, d)| (u - d) / (2.0 * h)).collect()).collect()
            };
            let (fine, coarse) = (slope(5e-4), slope(1e-3));
            let best = |(f, c): (&Vec<f64>, &Vec<f64>)| f.iter().zip(c).map(|(f, c)| (4.0 * f - c) / 3.0).collect();
            fine.iter().zip(&coarse).map(best).collect()
        };
        let derivatives = if request.sensitivities { (0..5).map(derivative).collect() } else { Vec::new() };
        Ok(Response { values: five(x), derivatives })
    }

    fn has_sensitivities(&self, _: &Samples) -> bool {
        true
    }

    fn length(&self, _: usize) -> usize {
        LENGTH
    }
}

#[test]
fn derivatives_of_the_model_and_differences_say_the_same_and_the_former_are_cheaper() {
    let problem = five_problem(&TRUTH, Misfit { compare: Compare::Histories, ..Misfit::default() });
    let look = |forward: &dyn Forward| {
        with(&problem, forward, |evaluator, basis| {
            let outcome = modern::search(evaluator, basis, &modern::Settings { starts: 4, ..Default::default() });
            let found = outcome.found.unwrap();
            for (value, truth) in found.point().iter().zip(TRUTH) {
                // Records without noise; the solver ends at a gradient of 1e-10 of a norm of order one.
                assert!((value - truth).abs() < 1e-5, "{:?}", found.point());
            }
            (identify(evaluator, basis, &TRUTH, STEP).unwrap(), found.evaluations)
        })
    };
    let (exact, cheap) = look(&Exact);
    let (differences, dear) = look(&five_model());
    assert!(cheap * 4 < dear, "{cheap} {dear}");
    let pairs = exact.sensitivities.concat().into_iter().zip(differences.sensitivities.concat());
    // Central differences over 1e-4: an error of 1e-8 of the third derivative, which is some ten times the values.
    assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-6), "{exact:?} {differences:?}");
    assert_eq!(exact.rank, 5);
}

#[test]
fn a_surrogate_states_its_error_and_serves_a_posterior() {
    let mut channels: Vec<Channel> = five_problem(&TRUTH, Misfit::default()).channels().to_vec();
    for channel in &mut channels {
        channel.uncertainty = Some(0.03 * channel.measured_peak().unwrap().abs());
    }
    let parameters = crate::common::five_parameters();
    let problem = Problem::new(parameters, channels, Misfit { slices: true, ..Misfit::default() }).unwrap();
    with(&problem, &five_model(), |evaluator, basis| {
        let surrogate = build(evaluator, basis, [300, 40], 1).unwrap();
        // Reciprocals over a range of one to three are exponentials of the logarithm: the fifth term is about 0.1 %, bells
        // that move add as much again.
        assert_eq!(surrogate.degree, 4);
        assert!(surrogate.mean_error.iter().all(|e| *e < 0.01), "{}", surrogate.words());
        assert!(surrogate.largest_error.iter().zip(&surrogate.mean_error).all(|(l, m)| l >= m));
        let settings = posterior::Settings {
            likelihood: Likelihood { model_error: ModelError::None, block: None, common_gain: 0.0 },
            particles: 200,
            effective_samples: 400.0,
            steps: 2000,
            ..posterior::Settings::default()
        };
        let wider = surrogate.widen(&problem);
        let grown = wider
            .channels()
            .iter()
            .zip(problem.channels())
            .map(|(w, p)| w.uncertainty.unwrap() / p.uncertainty.unwrap());
        assert!(grown.into_iter().all(|ratio| (1.0..1.1).contains(&ratio)));
        let mut watch = Unwatched;
        let mut fast = Evaluator::without_log(&wider, &surrogate, &Serial, &mut watch);
        let by_surrogate = posterior::sample(&mut fast, basis, &settings).unwrap();
        let mut watch = Unwatched;
        let model = five_model();
        let mut full = Evaluator::without_log(&problem, &model, &Serial, &mut watch);
        let basis = Basis { ..basis.clone() };
        let by_model = posterior::sample(&mut full, &basis, &settings).unwrap();
        for (a, b) in by_surrogate.parameters.iter().zip(&by_model.parameters) {
            // Two means of 400 effective samples differ by 0.07 deviations; the surrogate's error adds as much.
            let away = (a.summary.mean - b.summary.mean).abs() / b.summary.standard_deviation;
            assert!(away < 0.4, "{}: {away}", a.name);
        }
    });
}
