//! Solves the positions: the one function between the set-up of a passage and its report.

use super::outcome::{Influence, Moment, PassageStatus, StepLog};
use super::{PassageError, Setup};
use crate::analysis::AnalysisError;
use crate::warning::Warning;
use bridge::Bridge;
use mechanics::watch::Watch;

/// What solving gives. Records end at the last position that was solved.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// How it ended.
    pub status: PassageStatus,
    /// Why, where it did not complete.
    pub reason: Option<String>,
    /// Value of each sensor under self-weight alone [SI].
    pub self_weight: Vec<f64>,
    /// Value of each sensor at every position, self-weight taken off [SI]: all of the same length.
    pub values: Vec<Vec<f64>>,
    /// Unknowns of the model.
    pub degrees_of_freedom: usize,
    /// Unknowns that iterate, where linear parts are condensed.
    pub condensed_degrees_of_freedom: Option<usize>,
    /// Every step: of the self-weight, then of the passage.
    pub log: Vec<StepLog>,
    /// The bridge at chosen moments, self-weight first.
    pub moments: Vec<Moment>,
    /// Influence lines, where they were computed.
    pub influence: Option<Influence>,
    /// What the solver assumed, in words.
    pub assumptions: Vec<String>,
    /// Warnings.
    pub warnings: Vec<Warning>,
}

/// Self-weight first, then position after position.
pub fn solve(_bridge: &Bridge, _setup: &Setup, _watch: &mut dyn Watch) -> Result<Solution, AnalysisError> {
    Err(PassageError::NoSolver.into())
}
