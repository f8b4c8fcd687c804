//! What the data leave open, with the model as a straight line about one point: standard deviations, intervals and
//! correlations that cost no evaluation beyond the derivatives there (Laplace's approximation).
//!
//! Noise, common gain and model error are those of the posterior ([`crate::posterior::likelihood`]), gains going with the response at
//! the point. For every size $g$ of the model's error what is left is a normal distribution, cut off at the ranges; their mixture over $g$
//! is drawn from by Gibbs steps, with no model behind them.

pub mod design;
mod draws;
mod quadratic;

use crate::basis::{Basis, Halt, answer};
use crate::evaluator::Evaluator;
use crate::forward::{Evaluation, Forward, Request, Response, Samples, Serial};
use crate::identify::columns;
use crate::misfit::{Held, UNSTATED, compared, compared_derivatives, unstated};
use crate::parameter::{Parameter, shares, values};
use crate::posterior::likelihood::Likelihood;
use crate::posterior::summary::{self, Summary};
use crate::posterior::{CommonGain, bounded, gain};
use crate::problem::Problem;
use crate::search::sweep::{self, Sweep};
use crate::watch::Unwatched;
use serde::{Deserialize, Serialize};

/// The model as a straight line over the shares of the ranges.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Linearised {
    parameters: Vec<Parameter>,
    /// Shares about which it is one.
    at: Vec<f64>,
    /// What is compared of each channel there [unit of the channel].
    values: Vec<Vec<f64>>,
    /// Its derivatives with respect to shares, by parameter and channel.
    derivatives: Vec<Vec<Vec<f64>>>,
}

/// Parameters as the straight line leaves them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Left {
    /// Mean, spread and interval of each [unit of the parameter].
    pub parameters: Vec<Summary>,
    /// Whether the data tell each parameter: its interval is narrow beside the range and ends on no bound of it, and it is told apart from the
    /// common gain.
    pub told: Vec<bool>,
    /// Correlation of the parameters.
    pub correlation: Vec<Vec<f64>>,
    /// The model's error as a share of the response.
    pub model_error: f64,
    /// The gain that all channels share, where it is uncertain.
    pub common_gain: Option<CommonGain>,
    /// What is left open, in words.
    pub words: Vec<String>,
}

impl Linearised {
    /// Takes the derivatives at a point; those that the log knows, as after [`crate::identify`], are not evaluated again.
    ///
    /// # Errors
    /// A stop by the onlooker, or a model without an answer at the point or beside it.
    pub fn at(evaluator: &mut Evaluator, basis: &Basis, point: &[f64], step: f64) -> Result<Self, Halt> {
        let problem = evaluator.problem;
        let numbers = |response: &Response| compared(problem, &basis.held, response).concat();
        let own = |response: &Response| compared_derivatives(problem, response).iter().map(|d| d.concat()).collect();
        let parameters = problem.parameters().to_vec();
        let at = shares(&parameters, point);
        let flat = columns(evaluator, basis, (&at, point), step, &numbers, &own)?;
        let request = basis.request(evaluator.forward.has_sensitivities(&basis.samples));
        let values = compared(problem, &basis.held, &answer(evaluator, point, &request)?);
        let by_channel = |column: Vec<f64>| {
            let mut rest = column.into_iter();
            values.iter().map(|values| rest.by_ref().take(values.len()).collect()).collect()
        };
        let derivatives = flat.into_iter().map(by_channel).collect();
        Ok(Self { at, parameters, values, derivatives })
    }

    /// What the data leave open under noise and model error, without its local part, by draws from a seed. Channels without an uncertainty take
    /// one in its place and are named.
    pub fn left(&self, problem: &Problem, likelihood: &Likelihood, seed: u64) -> Left {
        let (problem, mut words) = stated(problem);
        let drawn = draws::draw(self, &problem, likelihood, seed);
        let column = |k: usize| drawn.shares.iter().map(|place| self.parameters[k].at(place[k])).collect::<Vec<f64>>();
        let columns: Vec<Vec<f64>> = (0..self.parameters.len()).map(column).collect();
        let sum = |(parameter, column): (&Parameter, &Vec<f64>)| {
            summary::summary(column, Some([parameter.lower, parameter.upper]))
        };
        let parameters: Vec<Summary> = self.parameters.iter().zip(&columns).map(sum).collect();
        let common_gain = CommonGain::of(&columns, &drawn.gains, likelihood.common_gain);
        let told = |(k, (parameter, summary)): (usize, (&Parameter, &Summary))| {
            let told_apart = common_gain.as_ref().is_none_or(|gain| gain.told_apart(k));
            told_apart && summary::tells(parameter, summary.interval_95)
        };
        let told = self.parameters.iter().zip(&parameters).enumerate().map(told).collect();
        let correlation =
            columns.iter().map(|a| columns.iter().map(|b| summary::correlation(a, b)).collect()).collect();
        let ends = self.parameters.iter().zip(&parameters);
        let ends = ends.filter(|(parameter, summary)| summary::ends_on_bound(parameter, summary.interval_95));
        words.extend(ends.map(|(parameter, summary)| bounded(parameter, summary.interval_95)));
        words.extend(gain::words(common_gain.as_ref(), &self.parameters, &parameters));
        Left { parameters, told, correlation, model_error: drawn.model_error, common_gain, words }
    }

    /// Every parameter varied alone over its range, all others as at the point: sensitivities by the straight line.
    pub fn sweeps(&self, problem: &Problem, held: &Held, start: &crate::misfit::Fit, count: usize) -> Vec<Sweep> {
        // Places of the values that are compared, which are all that the line has.
        let samples = Samples::At(self.values.iter().map(|values| (0..values.len()).collect()).collect());
        let basis = Basis { held: Held { beyond: Vec::new(), ..held.clone() }, samples, start: start.clone() };
        let mut watch = Unwatched;
        let mut evaluator = Evaluator::without_log(problem, self, &Serial, &mut watch);
        let all: Vec<usize> = (0..self.parameters.len()).collect();
        let point = values(&self.parameters, &self.at);
        let found = sweep::sweeps(&mut evaluator, &basis, (&self.parameters, &point), &all, count);
        found.unwrap_or_default()
    }
}

/// The problem with an uncertainty for every channel that counts, and which were not stated.
fn stated(problem: &Problem) -> (Problem, Vec<String>) {
    let mut silent = Vec::new();
    let uncertainty = |channel: &crate::Channel| {
        channel.uncertainty.unwrap_or_else(|| {
            if channel.counts() {
                silent.push(channel.name.clone());
            }
            unstated(channel).unwrap_or(0.0)
        })
    };
    let all: Vec<f64> = problem.channels().iter().map(uncertainty).collect();
    let words = format!(
        "No uncertainty is stated for {}: {} % of the measured peak is taken for one value.",
        silent.join(", "),
        100.0 * UNSTATED
    );
    (problem.with_uncertainties(&all), if silent.is_empty() { Vec::new() } else { vec![words] })
}

impl Forward for Linearised {
    fn evaluate(&self, point: &[f64], _: &Request) -> Evaluation {
        let away: Vec<f64> = shares(&self.parameters, point).iter().zip(&self.at).map(|(s, at)| s - at).collect();
        let mut values = self.values.clone();
        for (derivatives, away) in self.derivatives.iter().zip(away) {
            for (values, derivatives) in values.iter_mut().zip(derivatives) {
                values.iter_mut().zip(derivatives).for_each(|(value, d)| *value += away * d);
            }
        }
        Ok(Response { values, derivatives: Vec::new() })
    }

    fn length(&self, channel: usize) -> usize {
        self.values[channel].len()
    }
}
