//! Displacements, strains and stresses as a train passes, and under loads at rest.

use crate::passing::Passing;
use crate::project::Project;
use crate::refusal::Refusal;
use crate::watch::{Looking, Watch};
use assess::analysis::passage;
use bridge::Bridge;
use bridge::passage::{PassageAnalysis, PassagePath};
use outcome::passage::{Passage, PassageStatus};

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

/// Lets the train of the file cross, then puts the loads of its load test on the bridge, position by position; either where the file has both. An
/// interrupted passage ends with the status `cancelled`.
///
/// # Errors
/// A file that cannot be used or has neither, or a passage or a load test that cannot be set up (F108).
pub fn respond(project: &Project, options: &RespondOptions, watch: &mut dyn Watch) -> Result<Passage, Refusal> {
    let bridge = crossed(project, options)?;
    if bridge.passage.is_none() && bridge.load_test.is_some() {
        return Ok(passage::load_test(&bridge, &mut Looking(watch))?);
    }
    let mut passing = Passing::new(project, options, watch)?;
    passing.advance(usize::MAX, watch)?;
    let mut found = passing.finish(watch)?;
    if bridge.load_test.is_some() && found.status == PassageStatus::Completed {
        passage::with_load_test(&bridge, &mut found, &mut Looking(watch))?;
    }
    Ok(found)
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
    if let (Some(test), Some(path)) = (&mut bridge.load_test, options.path) {
        test.plan.path = path;
    }
    Ok(bridge)
}
