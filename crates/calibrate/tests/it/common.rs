//! Models as functions, and posing them.

use calibrate::misfit::{Misfit, Scaling, Weights};
use calibrate::search::modern::{Outcome, RunEnd};
use calibrate::{
    Basis, Channel, Evaluation, Evaluator, Forward, Log, Map, Parameter, Problem, Request, Response, Samples, Serial,
    Unwatched,
};

/// A model made of a function from parameters to one history a channel.
pub(crate) struct Function<F> {
    pub channels: usize,
    pub length: usize,
    pub values: F,
}

impl<F: Fn(&[f64]) -> Vec<Vec<f64>> + Sync> Forward for Function<F> {
    fn evaluate(&self, point: &[f64], request: &Request) -> Evaluation {
        let all = (self.values)(point);
        let values = match &request.samples {
            Samples::All => all,
            Samples::At(places) => {
                places.iter().zip(&all).map(|(places, row)| places.iter().map(|k| row[*k]).collect()).collect()
            }
        };
        Ok(Response { values, derivatives: Vec::new() })
    }

    fn length(&self, channel: usize) -> usize {
        assert!(channel < self.channels);
        self.length
    }
}

/// Peaks compared with equal weights, in units of their uncertainty: plain least squares.
pub(crate) fn plain() -> Misfit {
    Misfit { weights: Weights::Equal, scaling: Scaling::Uncertainty, ..Misfit::default() }
}

pub(crate) fn value(name: &str, measured: f64, uncertainty: f64) -> Channel {
    Channel { uncertainty: Some(uncertainty), ..Channel::peak(name, "", measured) }
}

/// Poses least squares: residuals are the function's values less `measured`, over one.
pub(crate) fn least_squares(parameters: Vec<Parameter>, measured: &[f64]) -> Problem {
    let channels = measured.iter().enumerate().map(|(k, v)| value(&format!("r{k}"), *v, 1.0)).collect();
    Problem::new(parameters, channels, plain()).expect("a sound problem")
}

/// Does something with an evaluator of a fresh log and the basis of the start model.
pub(crate) fn with<T>(problem: &Problem, forward: &dyn Forward, act: impl FnOnce(&mut Evaluator, &Basis) -> T) -> T {
    with_map(problem, forward, &Serial, act)
}

/// The same by another map.
pub(crate) fn with_map<T>(
    problem: &Problem,
    forward: &dyn Forward,
    map: &dyn Map,
    act: impl FnOnce(&mut Evaluator, &Basis) -> T,
) -> T {
    let mut watch = Unwatched;
    let mut evaluator = Evaluator::new(problem, forward, map, &mut watch, Log::new("test"));
    let basis = Basis::at(&mut evaluator, &problem.start()).expect("the start model answers");
    act(&mut evaluator, &basis)
}

/// Of runs that converged those that ended in different places, best first: the first of every group within a thousandth of every range.
pub(crate) fn minima<'o>(parameters: &[Parameter], outcome: &'o Outcome) -> Vec<&'o RunEnd> {
    let apart = |p: &Parameter, a: f64, b: f64| (p.share(a) - p.share(b)).abs() >= 1e-3;
    let near = |a: &RunEnd, b: &RunEnd| {
        let mut ends = parameters.iter().zip(&a.end).zip(&b.end);
        !ends.any(|((p, a), b)| apart(p, *a, *b))
    };
    let mut minima: Vec<&RunEnd> = Vec::new();
    for run in outcome.runs.iter().filter(|run| run.converged && run.norm.is_finite()) {
        if !minima.iter().any(|first| near(first, run)) {
            minima.push(run);
        }
    }
    minima
}

/// Places in a history.
pub(crate) const LENGTH: usize = 60;
/// What five channels take from each of five flexibilities: every parameter leads in one channel, as in a bridge, and acts
/// in all.
const SHARES: [[f64; 5]; 5] = [
    [1.0, 0.25, 0.1, 0.2, 0.05],
    [0.3, 1.0, 0.15, 0.1, 0.05],
    [0.2, 0.1, 0.8, 0.25, 0.1],
    [0.1, 0.2, 0.3, 0.9, 0.1],
    [0.15, 0.1, 0.2, 0.3, 0.5],
];
const SIGNS: [f64; 5] = [-0.3, 0.24, 22.0, -25.0, -23.0];

/// Five channels as a train passes: bells whose middle moves with the stiffness that leads.
pub(crate) fn five(x: &[f64]) -> Vec<Vec<f64>> {
    let channel = |c: usize| {
        let size: f64 = (0..5).map(|k| SHARES[c][k] / x[k]).sum();
        let middle = 20.0 + 4.0 * c as f64 + 3.0 * (x[c] - 1.0);
        let bell = |t: usize| {
            let away = (t as f64 - middle) / 8.0;
            SIGNS[c] * size * (-away * away).exp()
        };
        (0..LENGTH).map(bell).collect()
    };
    (0..5).map(channel).collect()
}

/// From parameters to one history a channel.
pub(crate) type Histories = fn(&[f64]) -> Vec<Vec<f64>>;

/// The model of five channels.
pub(crate) fn five_model() -> Function<Histories> {
    Function { channels: 5, length: LENGTH, values: five }
}

/// Ranges from half to three halves, starts at their middle.
pub(crate) fn five_parameters() -> Vec<Parameter> {
    ["fill", "abutment", "haunch", "voussoir", "mortar"].map(|name| Parameter::new(name, "", 1.0, 0.5, 1.5)).to_vec()
}

/// The problem of five channels measured at a truth.
pub(crate) fn five_problem(truth: &[f64], misfit: Misfit) -> Problem {
    let names = ["crown", "pier", "crown strain", "pier strain", "abutment strain"];
    let channels = names.iter().zip(five(truth)).map(|(name, history)| Channel::history(name, "", history)).collect();
    Problem::new(five_parameters(), channels, misfit).expect("sound")
}
