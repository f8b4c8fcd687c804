//! What every search ends with: parameters, norm, channels, and what it cost.

use crate::basis::{Basis, Halt, full_passage, wandered};
use crate::evaluator::Evaluator;
use crate::misfit::{self, ChannelError};
use crate::parameter::Parameter;
use serde::{Deserialize, Serialize};

/// One parameter at the end of a search.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FoundParameter {
    /// Its name.
    pub name: String,
    /// Its value [unit of the parameter].
    pub value: f64,
    /// Whether it stands on an end of its range.
    pub at_bound: bool,
    /// Whether the search calls it converged; never where it stands on a bound.
    pub converged: bool,
}

/// One channel of the problem at the end of a search.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FoundChannel {
    /// Signed peak of the model in a full passage [unit of the channel].
    pub model_peak: f64,
    /// Shape correlation of that passage with the record (eq. 4).
    pub shape_correlation: Option<f64>,
    /// Error (eq. 3, or as the misfit has it).
    pub error: f64,
}

/// Where a search ended, verified by a full passage.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Found {
    /// Parameters, in order.
    pub parameters: Vec<FoundParameter>,
    /// Weighted root mean square norm of the full passage.
    pub norm: f64,
    /// Norm as the search saw it, from its slices.
    pub norm_in_search: f64,
    /// Channels, in order.
    pub channels: Vec<FoundChannel>,
    /// Channels whose peak lies outside the slices of the search.
    pub wandered: Vec<String>,
    /// Evaluations of this search, each point once.
    pub evaluations: usize,
}

impl Found {
    /// The values of the parameters, in their order.
    pub fn point(&self) -> Vec<f64> {
        self.parameters.iter().map(|parameter| parameter.value).collect()
    }
}

/// Verifies a point by a full passage and says everything about it; bounds are those of `ranges`.
///
/// # Errors
/// A stop by the onlooker, or a model without an answer.
pub fn verify(
    evaluator: &mut Evaluator,
    basis: &Basis,
    ranges: &[Parameter],
    point: &[f64],
    norm_in_search: f64,
    converged: &[bool],
) -> Result<Found, Halt> {
    evaluator.stage = "full passage of what was found".into();
    let response = full_passage(evaluator, point)?;
    let problem = evaluator.problem;
    let fit = misfit::fit(problem, &basis.held, &response);
    let shapes = misfit::shape_correlations(problem, &response);
    let parameter = |(k, value): (usize, &f64)| {
        let at_bound = ranges[k].at_bound(*value);
        let converged = converged.get(k).copied().unwrap_or(false) && !at_bound;
        FoundParameter { name: problem.parameters()[k].name.clone(), value: *value, at_bound, converged }
    };
    let channel = |(channel, shape_correlation): (&ChannelError, Option<f64>)| FoundChannel {
        model_peak: channel.peak,
        shape_correlation,
        error: channel.error,
    };
    let strays = wandered(problem, &basis.samples, &response);
    Ok(Found {
        parameters: point.iter().enumerate().map(parameter).collect(),
        norm: fit.norm,
        norm_in_search,
        channels: fit.channels.iter().zip(shapes).map(channel).collect(),
        wandered: strays.into_iter().map(|k| problem.channels()[k].name.clone()).collect(),
        evaluations: evaluator.done,
    })
}
