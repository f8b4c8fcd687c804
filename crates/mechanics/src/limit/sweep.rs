//! Many places of a load on one model.

use super::bounds;
use super::collapse::{Found, carried, largest_factor_of_carried};
use super::equilibrium::Equilibrium;
use super::joints::joints;
use super::mechanism::mechanism;
use super::nonassociated::settle;
use super::outcome::Status;
use super::settings::{Friction, Settings};
use crate::blocks::{BlockModel, Loading, ModelError, PointForce};

/// The answer for one place of the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// How it ended.
    pub status: Status,
    /// Load factor at collapse; `None` unless solved.
    pub factor: Option<f64>,
    /// Upper bound from the associated mechanism by the work equation.
    pub upper_bound: Option<f64>,
    /// Load factor with associated friction.
    pub associated_factor: Option<f64>,
    /// The flow rule that `factor` belongs to.
    pub friction: Friction,
}

/// The answers for all places, in the order of the loads.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// One answer for each load.
    pub places: Vec<Place>,
    /// Index of the lowest load factor.
    pub governing: Option<usize>,
}

/// The load factor of each of `loads` in place of the variable loads. Joints and equations are set up once.
pub fn sweep(
    model: &BlockModel,
    loading: &Loading,
    loads: &[Vec<PointForce>],
    settings: &Settings,
) -> Result<Sweep, ModelError> {
    if model.blocks.iter().all(|b| b.held.is_fixed()) {
        return Err(ModelError::NothingFree);
    }
    let (_, joints) = joints(model, settings)?;
    let permanent = Loading { variable: Vec::new(), ..loading.clone() };
    let mut equilibrium = Equilibrium::new(model, &permanent, &joints);
    let strengths: Vec<_> = joints.iter().map(|j| j.strength).collect();
    let stands = carried(&equilibrium, &joints, &strengths);
    let places: Vec<Place> = loads
        .iter()
        .map(|load| {
            equilibrium.load(model, load);
            place(model, &equilibrium, &joints, &strengths, settings, &stands)
        })
        .collect();
    let mut governing = None;
    let mut lowest = f64::INFINITY;
    for (i, place) in places.iter().enumerate() {
        if let Some(factor) = place.factor
            && factor < lowest
        {
            (governing, lowest) = (Some(i), factor);
        }
    }
    Ok(Sweep { places, governing })
}

fn place(
    model: &BlockModel,
    equilibrium: &Equilibrium,
    joints: &[super::joints::Joint],
    strengths: &[super::joints::Strength],
    settings: &Settings,
    stands: &super::collapse::Carried,
) -> Place {
    let Found { status, solution, .. } = largest_factor_of_carried(equilibrium, joints, strengths, stands);
    let scale = equilibrium.factor_scale;
    let mut place =
        Place { status, factor: None, upper_bound: None, associated_factor: None, friction: Friction::Associated };
    if status == Status::Solved {
        place.factor = Some(solution.factor * scale);
        place.associated_factor = place.factor;
        place.upper_bound = Some(
            bounds::least_upper(equilibrium, joints, strengths, &solution.forces, &solution.velocities).factor * scale,
        );
    }
    let level = match settings.friction {
        Friction::Associated => false,
        Friction::NonAssociated => true,
        Friction::Automatic => {
            status == Status::Locks
                || mechanism(model, equilibrium, joints, &solution.velocities).is_some_and(|m| !m.sliding.is_empty())
        }
    };
    if level && matches!(status, Status::Solved | Status::Locks) {
        let forces = (status == Status::Solved).then_some(&solution.forces[..]);
        let settled = settle(equilibrium, joints, strengths, forces);
        place.friction = Friction::NonAssociated;
        place.status = if settled.is_some() { Status::Solved } else { Status::NotConverged };
        place.factor = settled.map(|s| s.solution.factor * scale);
    }
    place
}
