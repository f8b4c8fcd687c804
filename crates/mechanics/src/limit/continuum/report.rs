//! What the bounds say of the blocks, in the words of block limit analysis; and what soil exerts on them.

use super::lower::{Ends, Stresses, push};
use super::mesh::Mesh;
use super::model::{Bears, Continuum};
use super::setting::Setting;
use super::upper::Motion;
use crate::ids::BlockId;
use crate::limit::collapse::{joint_forces, resultants};
use crate::limit::mechanism::mechanism;
use crate::limit::outcome::{Outcome, Status};
use crate::plane::Vec2;

/// What soil exerts on a straight stretch of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pressure {
    /// The block.
    pub block: BlockId,
    /// Its ends, with the soil on the left of the way from the first to the second [m].
    pub ends: [Vec2; 2],
    /// Pressure on the block at the ends [Pa], positive.
    pub pressure: [f64; 2],
    /// Shear stress on the block at the ends [Pa], positive from the first end to the second.
    pub shear: [f64; 2],
}

/// Forces, lines of thrust, hinges: of the stresses the forces, of the motion the mechanism.
pub(super) fn of_blocks(setting: &Setting<'_>, below: &Stresses, above: &Motion) -> Outcome {
    let eq = &setting.equilibrium;
    let scaled: Vec<f64> = below.forces.iter().map(|f| f / eq.force).collect();
    let forces = joint_forces(eq, &scaled);
    Outcome {
        status: Status::Solved,
        interfaces: setting.interfaces.clone(),
        iterations: below.iterations + above.iterations,
        factor: Some(below.factor),
        lower_bound: Some(below.factor),
        upper_bound: Some(above.factor),
        equilibrium_residual: below.equilibrium_residual,
        yield_violation: below.yield_violation,
        flow_violation: above.flow_violation,
        resultants: resultants(eq, &forces),
        forces,
        mechanism: mechanism(setting.model, eq, &above.blocks),
        associated_factor: Some(below.factor),
        ..Outcome::default()
    }
}

/// Pressures on all blocks that touch the soil, sorted by block and then from left to right.
pub(super) fn pressures(soil: &Continuum, mesh: &Mesh, below: &Stresses) -> Vec<Pressure> {
    let mut found = Vec::new();
    for (e, edge) in mesh.edges.iter().enumerate() {
        let Some(Bears::Body { block: Some(block), .. }) = edge.side.map(|s| soil.sides[s].bears) else { continue };
        let at = Ends::of(mesh, e);
        // On the block: the opposite of what the soil's own traction is.
        let tractions = at.corners(mesh, edge.triangle).map(|k| push(below.stresses[edge.triangle][k], at.normal));
        found.push(Pressure {
            block,
            ends: at.points,
            pressure: tractions.map(|t| -t.dot(at.normal)),
            shear: tractions.map(|t| -t.dot(at.normal.left())),
        });
    }
    found.sort_by(|a, b| a.block.cmp(&b.block).then(a.ends[0].x.total_cmp(&b.ends[0].x)));
    found
}
