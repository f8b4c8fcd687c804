//! Bridges before anything is computed.

use crate::project::Project;
use crate::refusal::Refusal;
use assess::analysis;
use assess::vehicles::{Library, library as whole};
use outcome::picture::Picture;

/// The bridge as its file describes it, for drawing: what `figures::bridge_as_drawn` takes.
///
/// # Errors
/// A file that cannot be used, or a bridge that cannot be cut into blocks (F108).
pub fn as_built(project: &Project) -> Result<Picture, Refusal> {
    Ok(analysis::as_built(project.bridge()?)?)
}

/// The vehicles and rules of the library, with the trains of passages, whose axles weigh by standard gravity.
///
/// # Errors
/// A file of the library that cannot be read (F108).
pub fn library() -> Result<Library, Refusal> {
    whole(bridge::quantity::STANDARD_GRAVITY).map_err(|unknown| Refusal::not_set_up(&unknown))
}
