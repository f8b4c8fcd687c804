//! The load, the thickness or the support movement that makes a mechanism.

use crate::choice::Choice;
use crate::project::Project;
use crate::refusal::Refusal;
use crate::watch::{Looking, Watch};
use assess::analysis;
use bridge::Bridge;
use outcome::collapse::Collapse;

/// How a collapse is sought.
#[derive(Debug, Clone, Default)]
pub struct CollapseOptions {
    /// What takes the place of the file's plan.
    pub choice: Choice,
    /// The state of an interrupted run of the same bridge, as [`Watch::keep`] was offered it.
    pub resume: Option<Vec<u8>>,
}

/// Makes the analysis that the file plans. An interrupted run ends with the status `cancelled`.
///
/// # Errors
/// A file that cannot be used, or an analysis that cannot be set up for its bridge (F108).
pub fn collapse(project: &Project, options: &CollapseOptions, watch: &mut dyn Watch) -> Result<Collapse, Refusal> {
    let bridge = planned(project, &options.choice)?;
    Ok(analysis::collapse(&bridge, options.resume.as_deref(), &mut Looking(watch))?)
}

/// The bridge of a project with what was chosen in place of its plan.
///
/// # Errors
/// A file that cannot be used (F108).
pub fn planned(project: &Project, choice: &Choice) -> Result<Bridge, Refusal> {
    let mut bridge = project.bridge()?.clone();
    choice.apply(&mut bridge.plan);
    Ok(bridge)
}

/// What each method does not know of a bridge and its question, in words; none where it knows all of it (`docs/theory/methods.md`).
#[must_use]
pub fn not_known(bridge: &bridge::Bridge) -> Vec<(bridge::Method, Option<String>)> {
    let of = |method: &bridge::Method| {
        let mut own = bridge.clone();
        own.plan.method = *method;
        (*method, analysis::engine::can::refused(&own).err().map(|cannot| cannot.to_string()))
    };
    bridge::Method::ALL.iter().map(of).collect()
}
