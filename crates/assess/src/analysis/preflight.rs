//! Whether the analysis that a file plans can be set up: everything that it refuses before it computes, and no computing.

use super::by_dem::require_stiffness;
use super::{AnalysisError, by_limit, default_stiffness, filled, thickness};
use bridge::{Analysis, Bridge, Method, Strip};
use mechanics::dem::PackingError;
use mechanics::watch::{Progress, Watch, Wish};
use structure::discretise::fill;
use structure::discretise::ring_mesh::ring_mesh;

/// Refuses what the collapse analysis of the file's plan would refuse. A file that describes no load plans none.
pub fn planned(bridge: &Bridge) -> Result<(), AnalysisError> {
    let both = bridge.plan.analysis == Analysis::Load && bridge.plan.strip == Strip::Both;
    if !both {
        return one(bridge);
    }
    for strip in [Strip::Fill, Strip::Wall] {
        let mut alone = bridge.clone();
        alone.plan.strip = strip;
        one(&alone)?;
    }
    Ok(())
}

fn one(bridge: &Bridge) -> Result<(), AnalysisError> {
    let method = bridge.plan.method;
    match bridge.plan.analysis {
        Analysis::Load if bridge.loads.is_empty() => Ok(()),
        Analysis::Load => load(bridge),
        Analysis::Thickness if method == Method::Path => Err(AnalysisError::NotByPath("the least thickness")),
        Analysis::Thickness if method == Method::Fe => Err(AnalysisError::NotByFiniteElements("the least thickness")),
        Analysis::Thickness => thickness::thickened(bridge, 1.0).map(|_| ()),
        Analysis::SupportMovement if bridge.plan.support_movement.is_none() => {
            let why = "which support moves, and where, is the question";
            Err(AnalysisError::Missing { what: "support_movement", why })
        }
        Analysis::SupportMovement if method == Method::Path => Err(AnalysisError::NotByPath("support movements")),
        Analysis::SupportMovement if method == Method::Fe => {
            Err(AnalysisError::NotByFiniteElements("support movements"))
        }
        Analysis::SupportMovement if method == Method::Dem => require_stiffness(bridge),
        Analysis::SupportMovement => Ok(()),
    }
}

fn load(bridge: &Bridge) -> Result<(), AnalysisError> {
    match bridge.plan.method {
        Method::Limit => {}
        Method::Path => require_stiffness(&default_stiffness::stiffened(bridge))?,
        Method::Dem | Method::Fe => require_stiffness(bridge)?,
    }
    let d = by_limit::prepared(bridge)?;
    if d.loading.variable.is_empty() {
        return Err(AnalysisError::NoLoad);
    }
    if bridge.plan.method == Method::Fe {
        return ring_mesh(&d, bridge.service.mesh.ring_nodes, false).map(|_| ()).ok_or(AnalysisError::NotOneRing);
    }
    let Some(particles) = fill::wanted(bridge) else { return Ok(()) };
    if bridge.plan.method == Method::Path {
        return Err(AnalysisError::NotByPath("particles"));
    }
    let Some(region) = &d.fill else { return Err(AnalysisError::NoLoad) };
    if bridge.plan.load_step.is_none() {
        let why = "limit analysis, from which it would be chosen, knows no particles";
        return Err(AnalysisError::Missing { what: "load_step", why });
    }
    filled::fits(region, &particles.grains)?;
    match filled::packing(bridge, &d, region, particles, &mut Stopping) {
        Ok(_) | Err(PackingError::Stopped) => Ok(()),
        Err(error) => Err(error.into()),
    }
}

/// Stops a run as soon as it has begun.
struct Stopping;

impl Watch for Stopping {
    fn look(&mut self, _: &Progress) -> Wish {
        Wish::Stop
    }
}
