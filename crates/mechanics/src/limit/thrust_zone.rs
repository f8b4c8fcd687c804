//! Where the line of thrust can lie under a load that is carried.

use super::collapse::{TOLERANCE, joint_forces, resultants};
use super::equilibrium::Equilibrium;
use super::outcome::Resultant;
use super::program::{Interpretation, Program};
use super::settings::Settings;
use crate::blocks::{BlockModel, Interface, Loading, ModelError};
use crate::plane::Vec2;

/// Extreme states of equilibrium under a given load.
#[derive(Debug, Clone, PartialEq)]
pub struct ThrustZone {
    /// The joints, between which blocks and where.
    pub interfaces: Vec<Interface>,
    /// Of each joint the lowest and the highest place of its resultant, along `normal.left()` [m]; `None` where the
    /// joint cannot be compressed, or the load is not carried. Neighbouring joints reach theirs in different states.
    pub reach: Vec<Option<[Vec2; 2]>>,
}

/// The zone in which the line of thrust can lie under gravity, the permanent loads and `factor` times the variable
/// ones.
///
/// # Errors
/// Nothing that is free to move, particles, or a block whose rounding leaves nothing of an edge.
pub fn thrust_zone(
    model: &BlockModel,
    loading: &Loading,
    factor: f64,
    settings: &Settings,
) -> Result<ThrustZone, ModelError> {
    let zone = Zone::of(model, loading, factor, settings)?;
    let reach =
        (0..zone.equilibrium.joints.len()).map(|j| Some([zone.extreme(j, -1.0)?, zone.extreme(j, 1.0)?])).collect();
    Ok(ThrustZone { reach, interfaces: zone.interfaces })
}

/// The joints, and the line of thrust of the state with the least compression summed over all of them, under gravity,
/// the permanent loads and `factor` times the variable ones; no line where they are not carried.
///
/// # Errors
/// Those of [`thrust_zone`].
#[allow(clippy::type_complexity)]
pub fn least_thrust(
    model: &BlockModel,
    loading: &Loading,
    factor: f64,
    settings: &Settings,
) -> Result<(Vec<Interface>, Option<Vec<Option<Resultant>>>), ModelError> {
    let zone = Zone::of(model, loading, factor, settings)?;
    let line = zone.line();
    Ok((zone.interfaces, line))
}

struct Zone {
    interfaces: Vec<Interface>,
    equilibrium: Equilibrium,
    loads: Vec<f64>,
}

impl Zone {
    fn of(model: &BlockModel, loading: &Loading, factor: f64, settings: &Settings) -> Result<Zone, ModelError> {
        let (interfaces, equilibrium) = Equilibrium::of_free(model, loading, settings)?;
        let loads = equilibrium.loads(factor / equilibrium.factor_scale);
        Ok(Zone { interfaces, equilibrium, loads })
    }

    /// Farthest place of the resultant of joint `j` to one side of its tangent. A ratio of two forces, moment over
    /// compression, made linear by taking the compression as the unit of force (Charnes and Cooper 1962).
    fn extreme(&self, j: usize, side: f64) -> Option<Vec2> {
        let joint = &self.equilibrium.joints[j];
        let c = joint.column;
        if joint.points.len() < 2 {
            return joint.points.first().copied();
        }
        let solution = Program {
            scaled_loads: &self.loads,
            constant_loads: &vec![0.0; self.equilibrium.rows],
            objective: vec![(c, -side), (c + 1, side)],
            interpretation: Interpretation::UnitCompression(j),
            ..Program::of_the_factor(&self.equilibrium)
        }
        .solve(TOLERANCE);
        let share = solution.forces[c + 1];
        solution.solved.then(|| joint.points[0] * (1.0 - share) + joint.points[1] * share)
    }

    /// The line of thrust with the least sum of compressions.
    fn line(&self) -> Option<Vec<Option<Resultant>>> {
        let compressions = self.equilibrium.joints.iter().flat_map(|joint| joint.columns().take(joint.points.len()));
        let solution = Program {
            scaled_loads: &[],
            constant_loads: &self.loads,
            // `t` has no part in this program.
            cap: Some(0.0),
            objective: compressions.map(|column| (column, -1.0)).collect(),
            ..Program::of_the_factor(&self.equilibrium)
        }
        .solve(TOLERANCE);
        let forces = joint_forces(&self.equilibrium, &solution.forces);
        solution.solved.then(|| resultants(&self.equilibrium, &forces))
    }
}
