//! Collapse analyses: a bridge, a plan, and what came of it.

mod bands;
mod bonded_rings;
pub mod calibrate;
mod caveats;
mod default_stiffness;
mod defects;
mod deforming;
mod dimensions;
pub mod engine;
mod error;
mod geometry;
mod ground;
mod movement;
mod moving;
mod notes;
mod of_blocks;
pub(crate) mod parallel;
pub mod passage;
mod picture;
pub mod placing;
mod policy;
mod preflight;
mod service;
pub mod state;
mod statics;
mod sweep;
mod template;
mod thickness;
pub mod update;
pub mod vehicles;
mod wall_and_fill;

pub use default_stiffness::stiffened;
pub use error::AnalysisError;
pub(crate) use error::LEAST_SAMPLE;
pub use ground::ground_plan;
pub use movement::support_movement;
pub use of_blocks::{blocks_as_built, collapse_of_blocks};
pub use policy::bare;
pub use preflight::planned;
pub use state::by_weight_alone;
pub use statics::{statics, weighed};
pub use sweep::{Places, sweep};
pub use thickness::thickness;
pub use vehicles::{vehicle_sweep, vehicle_sweep_with_restrictions};

use bridge::{Analysis, Bridge, Method, Strip};
use mechanics::watch::Watch;
use outcome::collapse::Collapse;
use outcome::picture::Picture;
use state::{Change, with};
use structure::discretise::{Discretised, fill};

/// The bridge as its file describes it, for drawing: blocks, road surface, loads. Nothing is computed.
/// Particles are drawn where a saved packing says where they are.
///
/// # Errors
/// A bridge that cannot be cut into blocks, or a packing of another region.
pub fn as_built(bridge: &Bridge) -> Result<Picture, AnalysisError> {
    let label = if caveats::moved(bridge).is_some() { "as its support has moved it" } else { "as built" };
    Ok(picture::built(bridge, &engine::dem::filled::as_saved(bridge)?, label))
}

/// Makes the analysis that the bridge's plan asks for; what may help the bridge and may come and go is not counted. `resume` is a state that
/// [`Watch::keep`] was offered by a run of the same bridge.
///
/// # Errors
/// What the method or the question does not know, an analysis that cannot be set up, or a `resume` of something else.
pub fn collapse(bridge: &Bridge, resume: Option<&[u8]>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    if bridge.plan.analysis == Analysis::Load && bridge.plan.strip == Strip::Both {
        return wall_and_fill::both(bridge, resume, watch);
    }
    beside_bonded_rings(bridge, resume, watch)
}

/// What governs, with the load of bonded rings beside it.
fn beside_bonded_rings(
    bridge: &Bridge,
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
) -> Result<Collapse, AnalysisError> {
    let mut found = governing(bridge, resume, watch)?;
    bonded_rings::beside(bridge, &mut found, watch);
    Ok(found)
}

/// The least that a bridge comes to with and without each help that may come and go.
fn governing(bridge: &Bridge, resume: Option<&[u8]>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let states = policy::states(bridge);
    let turns = policy::Turns::new(states.len(), resume)?;
    let mut all = Vec::new();
    for (number, state) in states.iter().enumerate() {
        let mut turn = turns.watch((number, state), watch);
        all.push(as_described(&state.bridge, turns.kept(number), &mut turn)?);
        if all.last().is_some_and(Collapse::is_cancelled) {
            break;
        }
    }
    Ok(policy::least(bridge, &states, &all))
}

/// The same of one strip with all that the file says of the bridge, help that may come and go included: what a method finds, to be held against
/// tests and published numbers.
///
/// # Errors
/// What the method or the question does not know, an analysis that cannot be set up, or a `resume` of something else.
pub fn as_described(bridge: &Bridge, resume: Option<&[u8]>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    engine::can::refused(bridge)?;
    let mut found = match bridge.plan.analysis {
        Analysis::Load => engine::raising(bridge.plan.method, bridge).load(bridge, resume, watch),
        Analysis::Thickness => thickness(bridge, watch),
        Analysis::SupportMovement => support_movement(bridge, resume, watch),
    }?;
    found.picture.moves_supports = found.support().is_some();
    found.picture.collapse_load = found.support().map_or(found.collapse_load, |support| support.collapse);
    Ok(found)
}

/// A collapse by discrete elements that goes on when it is told to, with the fill packed and at rest where it is particles; none where the
/// onlooker wished to stop before.
///
/// # Errors
/// An analysis that cannot be set up, or fill that cannot be packed or does not come to rest.
pub fn stepping(
    bridge: &Bridge,
    watch: &mut dyn Watch,
) -> Result<Option<(Discretised, mechanics::dem::Stepping)>, AnalysisError> {
    let bridge = &policy::bare(bridge);
    match fill::wanted(bridge) {
        Some(particles) => engine::dem::filled::stepping(bridge, particles, watch),
        None => engine::dem::stepping(bridge).map(Some),
    }
}

/// The same where the bridge has no fill that is particles.
///
/// # Errors
/// Joints without stiffness, no load, or an analysis that cannot be set up.
pub fn stepping_of_blocks(bridge: &Bridge) -> Result<(Discretised, mechanics::dem::Stepping), AnalysisError> {
    engine::dem::stepping(&policy::bare(bridge))
}

/// The collapse load by a method, whatever the plan's is; what may help and may come and go is not counted.
///
/// # Errors
/// An analysis that cannot be set up.
pub fn collapse_by(method: Method, bridge: &Bridge, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let asked = with(bridge, &[Change::Analysis(Analysis::Load), Change::Method(method)]);
    beside_bonded_rings(&asked, None, watch)
}

/// By limit analysis.
///
/// # Errors
/// No load, or a bridge that cannot be cut into blocks.
pub fn collapse_by_limit(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    collapse_by(Method::Limit, bridge, watch)
}

/// A discretised bridge with its picture as built, particles where they were packed.
pub fn built(bridge: &Bridge, d: &Discretised) -> Picture {
    picture::built(bridge, d, "as built")
}

#[cfg(test)]
mod condition_tests;
#[cfg(test)]
mod continuum_tests;
#[cfg(test)]
mod defect_tests;
#[cfg(test)]
mod headline_tests;
#[cfg(test)]
mod horizontal_tests;
#[cfg(test)]
mod like_spans_tests;
#[cfg(test)]
mod mechanism_tests;
#[cfg(test)]
mod one_rule_tests;
#[cfg(test)]
mod path_many_tests;
#[cfg(test)]
mod path_tests;
#[cfg(test)]
mod ring_cohesion_tests;
#[cfg(test)]
mod slender_rings_tests;
#[cfg(test)]
mod tests;
