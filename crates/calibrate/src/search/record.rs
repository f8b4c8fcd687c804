//! What the paper's search may do, what it did, and where it ended.

use crate::forward::Failure;
use crate::parameter::Start;
use crate::report::Found;
use crate::search::surface::Surface;
use crate::search::sweep::Sweep;
use serde::{Deserialize, Serialize};

/// Which reading of the rules.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Variant {
    /// The three cases as printed: a parameter has converged where its minimum lies inside its range and in a decided
    /// trough; others follow by the range of the norm (Table 4).
    #[default]
    Printed,
    /// As the paper did: a decided descent to a bound freezes a parameter there, as it did the abutment fill; after the
    /// first pair, others follow by the mean range of the channels' errors (Table 5), as the voussoirs did.
    AsPractised,
}

impl Variant {
    /// The word that files and scripts read.
    pub fn word(self) -> &'static str {
        match self {
            Variant::Printed => "printed",
            Variant::AsPractised => "as-practised",
        }
    }
}

/// What the search may do.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Settings {
    /// Which reading of the rules.
    pub variant: Variant,
    /// Where it begins.
    pub start: Start,
    /// Points of a single sweep, and of a surface along each parameter, at least 3.
    pub points: usize,
    /// Passes, at least 1; fewer are made where a pass ends where it began.
    pub passes: usize,
    /// Lower and upper ends to which the ranges may be widened once, where a pair ends with both at bounds.
    pub widened: Option<Vec<(f64, f64)>>,
}

impl Default for Settings {
    fn default() -> Self {
        Self { variant: Variant::Printed, start: Start::Means, points: 11, passes: 2, widened: None }
    }
}

/// How it ended.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub enum Status {
    /// Every parameter was frozen.
    Resolved,
    /// These parameters never were.
    Unresolved(Vec<usize>),
    /// A pair of the last pass had both its parameters at bounds, which the paper calls failed.
    BothAtBounds([usize; 2]),
    /// The onlooker wanted it to end; the passes hold what was done.
    Stopped,
    /// The model failed where it must not.
    Failed(Failure),
}

/// One surface and what followed from it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Stage {
    /// The surface.
    pub surface: Surface,
    /// Parameters frozen after it.
    pub frozen: Vec<usize>,
    /// The parameter carried on to the next surface.
    pub carried: Option<usize>,
    /// A parameter left at its least value without being resolved, because another was carried on.
    pub set_aside: Option<usize>,
}

/// Once through Fig. 4.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Pass {
    /// The model at its beginning.
    pub start: Vec<f64>,
    /// Single sweeps, in the order of the parameters (Fig. 5, 6, Table 4, 5).
    pub sweeps: Vec<Sweep>,
    /// Parameters by the range of the norm, largest first (Table 4).
    pub ranking: Vec<usize>,
    /// Parameters by the mean range of the channels' errors, largest first (last row of Table 5).
    pub ranking_by_channels: Vec<usize>,
    /// Norm of the naive combination, every parameter at the minimum of its own sweep (the paper's yardstick, norm 0.24); none where the model
    /// failed.
    pub naive_norm: Option<f64>,
    /// Surfaces, in order (Fig. 7 to 9).
    pub stages: Vec<Stage>,
    /// Last single sweeps (Fig. 10).
    pub last: Vec<Sweep>,
    /// Which parameters were frozen.
    pub frozen: Vec<bool>,
    /// The model at its end, and its norm.
    pub end: Vec<f64>,
    /// Norm at the end.
    pub norm: f64,
    /// A pair that had both its parameters at bounds.
    pub failed_pair: Option<[usize; 2]>,
}

/// A model on the way, for pictures.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Step {
    /// What led to it.
    pub stage: String,
    /// The model.
    pub point: Vec<f64>,
    /// Its norm; none where it was not looked at.
    pub norm: Option<f64>,
}

/// What the search did and where it ended.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// How it ended.
    pub status: Status,
    /// Passes, in order.
    pub passes: Vec<Pass>,
    /// Whether the last pass ended where it began: another would change nothing.
    pub settled: bool,
    /// The path taken.
    pub path: Vec<Step>,
    /// The ranges it ended with, wider than the problem's where they were widened.
    pub ranges: Vec<(f64, f64)>,
    /// The end of the better pass, verified; none where it did not come so far.
    pub found: Option<Found>,
}
