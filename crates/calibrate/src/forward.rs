//! The model, as a search sees it: parameters in, channels out, or a named failure.

use serde::{Deserialize, Serialize};

/// Which values of the channels are wanted.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Samples {
    /// The whole history of every channel: a full passage.
    All,
    /// Of every channel the values at these places in its history, in ascending order: peak slices, solved statically.
    At(Vec<Vec<usize>>),
}

/// One question to the model.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Request {
    /// Which values are wanted.
    pub samples: Samples,
    /// Whether their derivatives are wanted too.
    pub sensitivities: bool,
}

impl Request {
    /// A full passage without derivatives.
    pub fn all() -> Self {
        Self { samples: Samples::All, sensitivities: false }
    }
}

/// The model's answer.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Response {
    /// Values by channel, in the order of the request.
    pub values: Vec<Vec<f64>>,
    /// Derivatives with respect to each parameter, in the shape of `values`; empty where they were not asked for.
    pub derivatives: Vec<Vec<Vec<f64>>>,
}

/// Why a point has no answer: a run that did not converge, locked or was refused.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Failure {
    /// Short name ("not-converged"), the same for all failures of a kind.
    pub code: String,
    /// In words, with numbers.
    pub message: String,
}

impl Failure {
    /// A failure with its name and words.
    pub fn new(code: &str, message: impl Into<String>) -> Self {
        Self { code: code.to_owned(), message: message.into() }
    }
}

/// Name of the failure of an evaluation that was stopped: it is no answer, and no log keeps it.
pub const STOPPED: &str = "cancelled";

/// What one point gave.
pub type Evaluation = Result<Response, Failure>;

/// A model whose parameters are sought. It must be a function: the same point and request give the same bits.
pub trait Forward: Sync {
    /// Values of every channel of the problem, left-out ones included, at one point.
    ///
    /// # Errors
    /// Why the model has no answer there; [`STOPPED`] after [`stop`](Self::stop).
    fn evaluate(&self, point: &[f64], request: &Request) -> Evaluation;

    /// Whether requests for sensitivities of such values are answered; where not, differences are taken.
    fn has_sensitivities(&self, samples: &Samples) -> bool {
        let _ = samples;
        false
    }

    /// Ends the evaluations that are at work: they fail as [`STOPPED`], and so do all that are begun later.
    fn stop(&self) {}

    /// Length of the history of a channel, in samples.
    fn length(&self, channel: usize) -> usize;
}

/// The caller's way to do many evaluations, by threads or not. Answers come in the order of the points.
pub trait Map {
    /// Applies `work` to every point. `look` asks the onlooker, who may end what is at work: to be called from time to time, or never.
    fn map(
        &self,
        points: &[Vec<f64>],
        work: &(dyn Fn(&[f64]) -> Evaluation + Sync),
        look: &mut dyn FnMut(),
    ) -> Vec<Evaluation>;

    /// How many points are handed over at once; between such lots the onlooker may stop the search.
    fn at_once(&self) -> usize {
        16
    }
}

/// One after the other.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
pub struct Serial;

impl Map for Serial {
    fn map(
        &self,
        points: &[Vec<f64>],
        work: &(dyn Fn(&[f64]) -> Evaluation + Sync),
        _: &mut dyn FnMut(),
    ) -> Vec<Evaluation> {
        points.iter().map(|point| work(point)).collect()
    }

    fn at_once(&self) -> usize {
        1
    }
}
