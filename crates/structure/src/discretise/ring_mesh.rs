//! The blocks of one ring as quadrilaterals: the same outlines, the same joints, for a collapse analysis by finite elements.
//!
//! Each voussoir is a grid of its own; neighbours face one another across a joint with a spring at each of the nodes across, the
//! outermost of them at the edges of the ring, or with springs in many strips of it. The springings face nodes that are held.

use super::{Discretised, Faces, Origin};
use mechanics::fem::{Interface, Mesh, Quad, Quadrature, Support};
use mechanics::ids::{BlockId, Id, NodeId};
use mechanics::plane::{Vec2, vec2};

/// Strips across a joint at least, where its stress is spread: with springs at nodes alone a joint that is open but for its edge presses
/// at that edge, where no pressure over a length can. A tenth of a joint that is closed has some thirteen of them.
const STRIPS: u32 = 128;

/// Elements along a voussoir, from joint to joint.
const ALONG: usize = 2;

/// Farthest that a block's face may lie from its neighbour's [m]: round-off of the outlines.
const APART: f64 = 1e-6;

/// A ring as a mesh, with the way back to its blocks.
#[derive(Debug, Clone, PartialEq)]
pub struct RingMesh {
    /// One zone, one kind of interface; interface `i` is the joint left of stone `i`, the last one the right springing.
    pub mesh: Mesh,
    /// Springs in each joint.
    pub springs: usize,
    /// The nodes of the springings.
    pub supports: Vec<Support>,
    /// The voussoirs from left to right.
    pub stones: Vec<Stone>,
    /// The fixed blocks behind the left and the right springing.
    pub abutments: [BlockId; 2],
}

/// A voussoir.
#[derive(Debug, Clone, PartialEq)]
pub struct Stone {
    /// The block that it is.
    pub block: BlockId,
    /// Its faces as built.
    faces: Faces,
    /// Its nodes: columns from left to right, each from the intrados up.
    columns: Vec<Vec<NodeId>>,
}

/// The mesh of a bridge of one ring on fixed abutments, with `across` nodes (two or more) on each joint; `None` for others. The stress
/// is summed at these nodes, or spread over the joint.
pub fn ring_mesh(d: &Discretised, across: usize, spread: bool) -> Option<RingMesh> {
    let free = d.model.blocks.pairs().filter(|(_, block)| !block.held.is_fixed());
    let voussoirs: Vec<(BlockId, Faces)> = free.map(|(id, _)| Some((id, (d.faces[id])?))).collect::<Option<_>>()?;
    let one_ring = voussoirs
        .iter()
        .enumerate()
        .all(|(i, (id, _))| d.origins[*id] == Origin::Voussoir { span: 0, ring: 0, voussoir: i });
    let joined = voussoirs.windows(2).all(|pair| {
        let (left, right) = (pair[0].1, pair[1].1);
        (left.bed[1] - right.bed[0]).norm().max((left.back[1] - right.back[0]).norm()) <= APART
    });
    let support =
        |last: bool| d.origins.iter().position(|o| matches!(o, Origin::Abutment { support } if (*support > 0) == last));
    let abutments = [BlockId::new(support(false)?), BlockId::new(support(true)?)];
    let is_ring = one_ring && joined && !voussoirs.is_empty() && d.model.particles.is_empty() && across >= 2;
    is_ring.then(|| build(&voussoirs, abutments, (across, spread)))
}

fn build(voussoirs: &[(BlockId, Faces)], abutments: [BlockId; 2], (across, spread): (usize, bool)) -> RingMesh {
    let mut mesh = Mesh { kinds: vec!["joint".into()], ..Mesh::default() };
    let zone = mesh.zones.push("voussoirs".into());
    let strips = STRIPS.div_ceil(across as u32 - 1);
    let (quadrature, springs) = match spread {
        true => (Quadrature::Strips(strips), strips as usize * (across - 1)),
        false => (Quadrature::Nodal, across),
    };
    let share = |j: usize| j as f64 / (across - 1) as f64;
    let mut stones: Vec<Stone> = Vec::new();
    for &(block, faces) in voussoirs {
        let mut column = |i: usize| -> Vec<NodeId> {
            let along = i as f64 / ALONG as f64;
            (0..across).map(|j| mesh.nodes.push(at(&faces, along, share(j)))).collect()
        };
        let columns: Vec<Vec<NodeId>> = (0..=ALONG).map(&mut column).collect();
        for pair in columns.windows(2) {
            for j in 0..across - 1 {
                mesh.quads.push(Quad { nodes: [pair[0][j], pair[1][j], pair[1][j + 1], pair[0][j + 1]], zone });
            }
        }
        stones.push(Stone { block, faces, columns });
    }
    let mut held = |column: &[NodeId]| -> Vec<NodeId> {
        let places: Vec<Vec2> = column.iter().map(|node| mesh.nodes[*node]).collect();
        places.into_iter().map(|place| mesh.nodes.push(place)).collect()
    };
    let springings = [held(&stones[0].columns[0]), held(&stones[stones.len() - 1].columns[ALONG])];
    let lefts = std::iter::once(&springings[0]).chain(stones.iter().map(|stone| &stone.columns[ALONG]));
    let rights = stones.iter().map(|stone| &stone.columns[0]).chain([&springings[1]]);
    for (left, right) in lefts.zip(rights) {
        // Walked from the extrados down, so that the stone on the left is on the right-hand side, `one`.
        let down = |nodes: &Vec<NodeId>| nodes.iter().rev().copied().collect();
        let (one, two) = (down(left), down(right));
        mesh.interfaces.push(Interface { one, two, kind: 0, quadrature });
    }
    let supports = springings.iter().flatten().map(|node| Support { node: *node, held: [true, true] }).collect();
    RingMesh { mesh, springs, supports, stones, abutments }
}

/// A place of a voussoir: shares of the way from its left to its right joint, and from bed to back.
fn at(faces: &Faces, along: f64, across: f64) -> Vec2 {
    let bed = faces.bed[0] * (1.0 - along) + faces.bed[1] * along;
    let back = faces.back[0] * (1.0 - along) + faces.back[1] * along;
    bed * (1.0 - across) + back * across
}

impl Stone {
    /// Nodes at its four corners: bed left and right, back right and left.
    pub fn corners(&self) -> [NodeId; 4] {
        let (left, right) = (&self.columns[0], &self.columns[ALONG]);
        let top = left.len() - 1;
        [left[0], right[0], right[top], left[top]]
    }

    /// Nodes and weights that a force at a place of the stone as built comes to: the same force and moment, done the same work by the
    /// element's displacements.
    pub fn shares(&self, place: Vec2) -> [(NodeId, f64); 4] {
        let [along, across] = self.inside(place);
        let rows = self.columns[0].len() - 1;
        let cell = |share: f64, count: usize| {
            let index = ((share * count as f64).floor().max(0.0) as usize).min(count - 1);
            (index, share * count as f64 - index as f64)
        };
        let ((i, x), (j, y)) = (cell(along, ALONG), cell(across, rows));
        let (left, right) = (&self.columns[i], &self.columns[i + 1]);
        [
            (left[j], (1.0 - x) * (1.0 - y)),
            (right[j], x * (1.0 - y)),
            (right[j + 1], x * y),
            (left[j + 1], (1.0 - x) * y),
        ]
    }

    /// Shares along and across of a place, by Newton's method on the bilinear map of the four corners.
    fn inside(&self, place: Vec2) -> [f64; 2] {
        let (mut along, mut across) = (0.5, 0.5);
        for _ in 0..20 {
            let miss = place - at(&self.faces, along, across);
            let by_along = at(&self.faces, 1.0, across) - at(&self.faces, 0.0, across);
            let by_across = at(&self.faces, along, 1.0) - at(&self.faces, along, 0.0);
            let area = by_along.cross(by_across);
            if !(area.abs() > 0.0) {
                break;
            }
            let step = vec2(miss.cross(by_across) / area, by_along.cross(miss) / area);
            (along, across) = (along + step.x, across + step.y);
            if step.norm() < 1e-14 {
                break;
            }
        }
        [along, across]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discretise::discretise;
    use crate::samples;

    #[test]
    fn a_stone_takes_a_force_without_changing_its_moment() {
        let ring = ring_mesh(&discretise(&samples::bridgemill()).unwrap(), 7, false).unwrap();
        for stone in &ring.stones {
            for (along, across) in [(0.0, 1.0), (0.3, 1.0), (0.77, 0.4), (1.0, 0.0)] {
                let place = at(&stone.faces, along, across);
                let shares = stone.shares(place);
                let found = shares.iter().fold(Vec2::ZERO, |sum, &(node, share)| sum + ring.mesh.nodes[node] * share);
                assert!((found - place).norm() < 1e-9, "{place:?} {found:?}");
                assert!((shares.iter().map(|(_, share)| share).sum::<f64>() - 1.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn the_mesh_has_the_area_of_the_blocks_and_a_joint_more_than_stones() {
        let d = discretise(&samples::bridgemill()).unwrap();
        let ring = ring_mesh(&d, 5, true).unwrap();
        let quads = ring.mesh.quads.iter().map(|quad| {
            let [a, b, c, e] = quad.nodes.map(|node| ring.mesh.nodes[node]);
            0.5 * (c - a).cross(e - b)
        });
        let blocks: f64 = ring.stones.iter().map(|stone| d.model.blocks[stone.block].outline.area()).sum();
        let meshed: f64 = quads.sum();
        assert!((meshed - blocks).abs() < 1e-9 * blocks, "{meshed} {blocks}");
        assert_eq!(ring.mesh.interfaces.len(), ring.stones.len() + 1);
    }
}
