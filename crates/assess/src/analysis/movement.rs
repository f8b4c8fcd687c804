//! Collapse by the movement of a support.

use super::AnalysisError;
use super::engine::{self, rings::MovedSupport};
use bridge::{Bridge, SupportMovement};
use mechanics::watch::Watch;
use outcome::collapse::Collapse;
use outcome::note;
use outcome::warning::{Loads, Warning};
use structure::discretise::discretise;

/// Moves the support of the plan in increments until the blocks collapse, under the permanent loads alone.
///
/// # Errors
/// A plan without a movement, a method that does not know it, or an analysis that cannot be set up.
pub fn support_movement(
    bridge: &Bridge,
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
) -> Result<Collapse, AnalysisError> {
    let mut d = discretise(bridge)?;
    d.loading.variable.clear();
    let movement = given(bridge)?;
    // A thousandth of the shortest span a step, up to a tenth of it: no bridge moves farther unnoticed.
    let shortest = bridge.spans.iter().map(|s| s.span).fold(f64::INFINITY, f64::min);
    let largest = movement.limit.unwrap_or(0.1 * shortest);
    let step = movement.increment.unwrap_or(1e-3 * shortest);
    let moves = MovedSupport { bridge, blocks: &d, step, largest };
    let mut c = engine::by(bridge.plan.method).support_movement(&moves, resume, watch)?;
    c.assumptions.push(note::Blocks::WeightsAlone.into());
    let increment = movement.increment.is_none().then_some(Loads::Increment { increment: step });
    let limit = movement.limit.is_none().then_some(Loads::LargestMovement { limit: largest });
    c.warnings.extend(increment.into_iter().chain(limit).map(Warning::from));
    Ok(c)
}

/// The movement that the file describes.
pub(super) fn given(bridge: &Bridge) -> Result<SupportMovement, AnalysisError> {
    let why = "which support moves, and where, is the question";
    bridge.plan.support_movement.ok_or(AnalysisError::Missing { what: "support_movement", why })
}
