//! States of the ring as pictures show them: stones as blocks that move, springs as contacts, resultants of the joints.

use crate::analysis::geometry::{moving_as_built, point, scaled, thrust_lines};
use crate::analysis::picture::stresses;
use mechanics::fem::joint::PairState;
use mechanics::fem::{Model, State};
use mechanics::ids::{BlockId, Id, NodeId};
use mechanics::plane::{Vec2, vec2};
use outcome::picture::{ContactForce, Motion, Picture, Snapshot};
use structure::discretise::Discretised;
use structure::discretise::ring_mesh::RingMesh;

/// What is to be kept of a state in balance.
pub(super) fn show(d: &Discretised, ring: &RingMesh, model: &Model, state: &State, factor: f64) -> Snapshot {
    let contacts = contacts(ring, model, state);
    Snapshot {
        load: d.load(factor),
        motions: motions(d, ring, model, &state.displacements),
        velocities: vec![[0.0; 2]; d.model.blocks.len()],
        stresses: stresses(d, &contacts, factor),
        contacts,
        ..Snapshot::default()
    }
}

/// Motion of each block: that of its corners in the mean, turned as they are as a whole.
pub(super) fn motions(d: &Discretised, ring: &RingMesh, model: &Model, displacements: &[f64]) -> Vec<Motion> {
    let moved = |node: NodeId| vec2(displacements[2 * node.index()], displacements[2 * node.index() + 1]);
    let mut all = vec![Motion::default(); d.model.blocks.len()];
    for stone in &ring.stones {
        let corners = stone.corners().map(|node| (model.mesh.nodes[node], moved(node)));
        let mean =
            |pick: fn(&(Vec2, Vec2)) -> Vec2| corners.iter().fold(Vec2::ZERO, |sum, corner| sum + pick(corner)) * 0.25;
        let (middle, shift) = (mean(|corner| corner.0), mean(|corner| corner.1));
        let (mut sine, mut cosine) = (0.0, 0.0);
        for (place, moved) in corners {
            let (arm, now) = (place - middle, place + moved - middle - shift);
            sine += arm.cross(now);
            cosine += arm.dot(now);
        }
        let rotation = sine.atan2(cosine);
        // The centroid is not quite the middle of the corners.
        let off = d.model.blocks[stone.block].outline.centroid() - middle;
        let turned =
            vec2(off.x * rotation.cos() - off.y * rotation.sin(), off.x * rotation.sin() + off.y * rotation.cos());
        all[stone.block.index()] = Motion { translation: point(shift + turned - off), rotation };
    }
    all
}

/// Springs that press, joint by joint, where they now are.
fn contacts(ring: &RingMesh, model: &Model, state: &State) -> Vec<ContactForce> {
    let place = |node: NodeId| {
        let k = 2 * node.index();
        model.mesh.nodes[node] + vec2(state.displacements[k], state.displacements[k + 1])
    };
    let mut all = Vec::new();
    for (spring, bond) in model.springs.iter().zip(&state.bonds) {
        if bond.state == PairState::Open || bond.traction[0] >= 0.0 {
            continue;
        }
        let joint = spring.interface.index();
        let blocks = blocks(ring, joint);
        let nodes = &model.mesh.interfaces[spring.interface];
        let (first, last) = (nodes.two[0], nodes.two[nodes.two.len() - 1]);
        let middle = |k: usize| (place(nodes.one[k]) + place(nodes.two[k])) * 0.5;
        let way = if first == last { spring.direction } else { (middle(nodes.two.len() - 1) - middle(0)).unit() };
        all.push(ContactForce {
            blocks: blocks.map(BlockId::index),
            point: point(spring.place().fold(Vec2::ZERO, |sum, (node, share)| sum + place(node) * share)),
            normal: point(way.left()),
            compression: -bond.traction[0] * spring.area,
            // A positive shear works on side two moving along the way, so that it pulls side two back; along the normal turned left.
            shear: bond.traction[1] * spring.area,
            stress: -bond.traction[0],
            sliding: bond.state == PairState::Sliding,
        });
    }
    all
}

/// The blocks left and right of a joint.
fn blocks(ring: &RingMesh, joint: usize) -> [BlockId; 2] {
    let left = if joint == 0 { ring.abutments[0] } else { ring.stones[joint - 1].block };
    let right = ring.stones.get(joint).map_or(ring.abutments[1], |stone| stone.block);
    [left, right]
}

/// Puts states and mechanism into a picture.
pub(super) fn draw(d: &Discretised, shown: &[Snapshot], onset: Option<&[Motion]>, picture: &mut Picture) {
    picture.last_stable = shown.len().checked_sub(1);
    picture.thrust_lines = shown.last().map_or_else(Vec::new, |last| thrust_lines(d, &last.contacts));
    picture.snapshots = shown.to_vec();
    picture.mechanism = onset.and_then(|motions| scaled(motions.to_vec()));
    moving_as_built(d, picture);
}
