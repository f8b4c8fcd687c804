//! Models as functions, and posing them.

use calibrate::misfit::{Misfit, Scaling, Weights};
use calibrate::{
    Basis, Channel, Evaluation, Evaluator, Forward, Log, Map, Parameter, Problem, Request, Response, Samples, Serial,
    Unwatched,
};

/// A model made of a function from parameters to one history a channel.
pub struct Function<F> {
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
pub fn plain() -> Misfit {
    Misfit { weights: Weights::Equal, scaling: Scaling::Uncertainty, ..Misfit::default() }
}

/// A channel of one value with its uncertainty.
pub fn value(name: &str, measured: f64, uncertainty: f64) -> Channel {
    Channel { uncertainty: Some(uncertainty), ..Channel::peak(name, "", measured) }
}

/// Poses least squares: residuals are the function's values less `measured`, over one.
pub fn least_squares(parameters: Vec<Parameter>, measured: &[f64]) -> Problem {
    let channels = measured.iter().enumerate().map(|(k, v)| value(&format!("r{k}"), *v, 1.0)).collect();
    Problem::new(parameters, channels, plain()).expect("a sound problem")
}

/// Does something with an evaluator of a fresh log and the basis of the start model.
pub fn with<T>(problem: &Problem, forward: &dyn Forward, act: impl FnOnce(&mut Evaluator, &Basis) -> T) -> T {
    with_map(problem, forward, &Serial, act)
}

/// The same by another map.
pub fn with_map<T>(
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
