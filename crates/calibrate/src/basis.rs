//! What norms are computed with: weights held at the start model, and the places where peaks are looked for.

use crate::evaluator::Evaluator;
use crate::forward::{Failure, Request, Response, Samples};
use crate::misfit::{self, Compare, Fit, Held};
use crate::problem::Problem;
use crate::watch::Stopped;
use serde::{Deserialize, Serialize};

/// Why something ended before its time.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub enum Halt {
    /// The onlooker wanted it.
    Stopped,
    /// The model failed where it must not.
    Failed(Failure),
}

impl From<Stopped> for Halt {
    fn from(_: Stopped) -> Self {
        Self::Stopped
    }
}

/// Weights and places. Norms of different searches are comparable where they share it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Basis {
    /// Weights and shape correlation factors of the start model.
    pub held: Held,
    /// Which values are asked for in a search.
    pub samples: Samples,
    /// What a full passage of the start model amounts to.
    pub start: Fit,
}

impl Basis {
    /// Runs a full passage of a start model and holds its weights.
    ///
    /// # Errors
    /// A stop by the onlooker, a start model without an answer, or one whose norm is no finite number.
    pub fn at(evaluator: &mut Evaluator, start: &[f64]) -> Result<Self, Halt> {
        evaluator.stage = "start model".into();
        let response = full_passage(evaluator, start)?;
        let held = misfit::hold(evaluator.problem, &response);
        let fit = misfit::fit(evaluator.problem, &held, &response);
        let samples = samples(evaluator, &response);
        if !(fit.norm.is_finite()) {
            let message = "the start model's norm is no finite number: no channel has both a weight and an error";
            return Err(Halt::Failed(Failure::new("no-norm", message)));
        }
        Ok(Self { held, samples, start: fit })
    }

    /// The same weights with the peaks' places of a full passage of another model.
    ///
    /// # Errors
    /// A stop by the onlooker, or a model without an answer.
    pub fn refreshed(&self, evaluator: &mut Evaluator, point: &[f64]) -> Result<Self, Halt> {
        if !evaluator.problem.misfit().slices {
            return Ok(self.clone());
        }
        let response = full_passage(evaluator, point)?;
        Ok(Self { samples: samples(evaluator, &response), ..self.clone() })
    }

    /// The peaks' places of a full passage of another model, and by how much its peaks differ from those of the slices at these places;
    /// the same where there are no slices.
    ///
    /// # Errors
    /// A stop by the onlooker, or a model without an answer.
    pub fn corrected(&self, evaluator: &mut Evaluator, point: &[f64]) -> Result<Self, Halt> {
        if self.samples == Samples::All {
            return Ok(self.clone());
        }
        let full = full_passage(evaluator, point)?;
        let mut basis = Self { samples: samples(evaluator, &full), ..self.clone() };
        let request = basis.request(evaluator.forward.has_sensitivities(&basis.samples));
        let slices = answer(evaluator, point, &request)?;
        let problem = evaluator.problem;
        let peak = |channel: usize, values: &[f64]| misfit::peak_place(problem, channel, values).map(|at| values[at]);
        let beyond = |k: usize| match problem.compare(k) {
            Compare::Peaks => Some(peak(k, &full.values[k])? - peak(k, &slices.values[k])?),
            Compare::Histories => None,
        };
        basis.held.beyond = (0..full.values.len()).map(|k| beyond(k).unwrap_or(0.0)).collect();
        Ok(basis)
    }

    /// The question that a search asks.
    pub fn request(&self, sensitivities: bool) -> Request {
        Request { samples: self.samples.clone(), sensitivities }
    }

    /// Fits at many points; none where the model failed there.
    ///
    /// # Errors
    /// A stop by the onlooker.
    pub fn fits(&self, evaluator: &mut Evaluator, points: &[Vec<f64>]) -> Result<Vec<Option<Fit>>, Stopped> {
        let answers = evaluator.respond(points, &self.request(false))?;
        let fit = |response: &Response| misfit::fit(evaluator.problem, &self.held, response);
        Ok(answers.iter().map(|answer| answer.as_ref().as_ref().ok().map(fit)).collect())
    }
}

/// What was found; none where the model failed.
pub(crate) fn unless_failed<T>(found: Result<T, Halt>) -> Result<Option<T>, Stopped> {
    match found {
        Ok(found) => Ok(Some(found)),
        Err(Halt::Failed(_)) => Ok(None),
        Err(Halt::Stopped) => Err(Stopped),
    }
}

/// A full passage at one point.
pub(crate) fn full_passage(evaluator: &mut Evaluator, point: &[f64]) -> Result<Response, Halt> {
    answer(evaluator, point, &Request::all())
}

/// The answer at one point.
pub(crate) fn answer(evaluator: &mut Evaluator, point: &[f64], request: &Request) -> Result<Response, Halt> {
    let answers = evaluator.respond(&[point.to_vec()], request)?;
    answers[0].as_ref().clone().map_err(Halt::Failed)
}

/// Places of the peaks with their neighbours, where peaks are compared and slices are wanted.
fn samples(evaluator: &Evaluator, response: &Response) -> Samples {
    let misfit = evaluator.problem.misfit();
    if !misfit.slices || misfit.compare == Compare::Histories {
        return Samples::All;
    }
    let neighbours = |(channel, values): (usize, &Vec<f64>)| {
        if evaluator.problem.compare(channel) == Compare::Histories {
            return (0..values.len()).collect();
        }
        let place = misfit::peak_place(evaluator.problem, channel, values);
        let last = evaluator.forward.length(channel).saturating_sub(1);
        place.map_or_else(Vec::new, |place| (place.saturating_sub(1)..=(place + 1).min(last)).collect())
    };
    Samples::At(response.values.iter().enumerate().map(neighbours).collect())
}

/// Channels whose peak has reached an outer neighbour, or another place altogether, in a full passage.
pub fn wandered(problem: &Problem, samples: &Samples, full: &Response) -> Vec<usize> {
    let Samples::At(places) = samples else {
        return Vec::new();
    };
    let strays = |channel: &usize| {
        let place = misfit::peak_place(problem, *channel, &full.values[*channel]);
        place.is_some_and(|place| !places[*channel].contains(&place))
    };
    (0..places.len()).filter(strays).collect()
}
