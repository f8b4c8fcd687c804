//! Discrete elements: rigid blocks in deformable point contact, stepped in time to rest or to collapse.

mod outcome;
mod settings;

pub use outcome::{ContactState, Energy, Frame, Outcome, PathPoint, Status};
pub use settings::{ContactLength, Damping, Program, Settings};

use crate::blocks::{BlockModel, Loading, ModelError};
use crate::watch::Watch;

/// Brings the blocks to rest under their own weight and the permanent forces, then raises the load factor in steps
/// until they collapse or the limit is reached. `resume` takes up a state that [`Watch::keep`] was offered, for the
/// same model, loading, program and settings; the numbers are those of an undisturbed run.
pub fn collapse(
    _model: &BlockModel,
    _loading: &Loading,
    _program: &Program,
    _settings: &Settings,
    _resume: Option<&[u64]>,
    _watch: &mut dyn Watch,
) -> Result<Outcome, ModelError> {
    todo!("discrete element method")
}
