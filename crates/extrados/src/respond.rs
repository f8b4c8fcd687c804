//! Displacements, strains and stresses as a train passes.

use crate::passing::Passing;
use crate::project::Project;
use crate::refusal::Refusal;
use crate::watch::Watch;
use bridge::Bridge;
use bridge::passage::{PassageAnalysis, PassagePath};
use outcome::passage::Passage;

/// How a train crosses.
#[derive(Debug, Clone, Copy, Default)]
pub struct RespondOptions {
    /// Its speed [m/s]; none for the file's.
    pub speed: Option<f64>,
    /// At rest at every position, or through time; none for the file's.
    pub analysis: Option<PassageAnalysis>,
    /// By which path the equations are solved; none for the file's.
    pub path: Option<PassagePath>,
}

/// Lets the train of the file cross. An interrupted passage ends with the status `cancelled`.
///
/// # Errors
/// A file that cannot be used or has no train, or a passage that cannot be set up (F108).
pub fn respond(project: &Project, options: &RespondOptions, watch: &mut dyn Watch) -> Result<Passage, Refusal> {
    let mut passing = Passing::new(project, options, watch)?;
    passing.advance(usize::MAX, watch)?;
    passing.finish(watch)
}

/// The bridge of a project with the passage that was asked for.
pub(crate) fn crossed(project: &Project, options: &RespondOptions) -> Result<Bridge, Refusal> {
    let mut bridge = project.bridge()?.clone();
    if let Some(asked) = &mut bridge.passage {
        let plan = &mut asked.plan;
        plan.speed = options.speed.unwrap_or(plan.speed);
        plan.analysis = options.analysis.unwrap_or(plan.analysis);
        plan.path = options.path.unwrap_or(plan.path);
    }
    Ok(bridge)
}
