//! Springs between the faces of an interface.

use super::element::{Angle, turned};
use super::joint::JointLaw;
use super::mesh::{Interface, Mesh, Quadrature};
use super::model::ModelError;
use super::settings::Kinematics;
use super::state::Bond;
use crate::ids::{Id, InterfaceId, NodeId};
use crate::plane::Vec2;

/// Most nodes of a spring: a pair, and the pairs on both sides of it that give its direction.
const NODES: usize = 6;
const ROWS: usize = 2 * NODES;

/// A point of integration of an interface.
#[derive(Debug, Clone, PartialEq)]
pub struct Spring {
    /// The interface it belongs to.
    pub interface: InterfaceId,
    /// Kind of the interface.
    pub kind: usize,
    /// Way along the interface, from its first pair [m].
    pub along: f64,
    /// Area that it stands for, per metre of width [m].
    pub area: f64,
    /// Direction of the way walked before anything moves.
    pub direction: Vec2,
    /// Nodes, and the part of each in the opening (negative on side one) and in the direction.
    nodes: Vec<(NodeId, f64, f64)>,
}

/// What a spring answers.
#[derive(Debug, Clone)]
pub(super) struct Pull {
    /// Forces on the components of its nodes [N/m].
    pub force: [f64; ROWS],
    /// Their derivatives [Pa].
    pub tangent: [[f64; ROWS]; ROWS],
    /// What it would remember.
    pub bond: Bond,
}

impl Spring {
    /// Nodes that it joins.
    pub fn nodes(&self) -> impl ExactSizeIterator<Item = NodeId> + '_ {
        self.nodes.iter().map(|(node, _, _)| *node)
    }

    /// Nodes of side two, and their parts in the opening: where the spring stands.
    pub fn shares(&self) -> Vec<(NodeId, f64)> {
        self.nodes.iter().filter(|(_, weight, _)| *weight > 0.0).map(|&(node, weight, _)| (node, weight)).collect()
    }

    /// Nodes of both sides and their shares in the place midway between the two.
    pub fn place(&self) -> impl Iterator<Item = (NodeId, f64)> + '_ {
        self.nodes.iter().map(|&(node, weight, _)| (node, 0.5 * weight.abs()))
    }

    /// Normal and tangential opening at small displacements: components and weights.
    pub(super) fn openings(&self) -> [Vec<(usize, f64)>; 2] {
        let (x, y) = (self.direction.x, self.direction.y);
        let along = |cx: f64, cy: f64| {
            let terms = self.nodes.iter().filter(|(_, weight, _)| *weight != 0.0);
            terms.flat_map(|&(node, w, _)| [(2 * node.index(), w * cx), (2 * node.index() + 1, w * cy)]).collect()
        };
        [along(-y, x), along(x, y)]
    }

    /// Forces at displacements `u` of all nodes; `None` where its direction has no length.
    pub(super) fn respond(&self, law: &JointLaw, mesh: &Mesh, u: &[f64], large: bool, old: &Bond) -> Option<Pull> {
        let m = 2 * self.nodes.len();
        let mut places = [0.0; ROWS];
        let mut angle = Angle { along: [self.direction.x, self.direction.y], slopes: [[0.0; ROWS]; 2] };
        if large {
            angle.along = [0.0; 2];
        }
        let base = mesh.nodes[self.nodes[0].0];
        for (n, &(node, _, part)) in self.nodes.iter().enumerate() {
            let moved = [u[2 * node.index()], u[2 * node.index() + 1]];
            let start = mesh.nodes[node] - base;
            // Only differences of places count; small displacements leave the places out.
            places[2 * n] = moved[0] + if large { start.x } else { 0.0 };
            places[2 * n + 1] = moved[1] + if large { start.y } else { 0.0 };
            if large {
                angle.along[0] += part * places[2 * n];
                angle.along[1] += part * places[2 * n + 1];
                angle.slopes[0][2 * n] = part;
                angle.slopes[1][2 * n + 1] = part;
            }
        }
        let [cos, sin] = angle.direction()?;
        let mut opening = [0.0; 2];
        for (n, &(_, weight, _)) in self.nodes.iter().enumerate() {
            let (x, y) = (places[2 * n], places[2 * n + 1]);
            (places[2 * n], places[2 * n + 1]) = (cos * x + sin * y, cos * y - sin * x);
            opening[0] += weight * places[2 * n + 1];
            opening[1] += weight * places[2 * n];
        }
        let answer = law.respond(opening, self.area, &old.memory);
        let mut pull = Pull {
            force: [0.0; ROWS],
            tangent: [[0.0; ROWS]; ROWS],
            bond: Bond { memory: answer.memory, traction: answer.traction, opening, state: answer.state },
        };
        // In the frame the first axis is tangential, the second normal (equation 14).
        const AXIS: [usize; 2] = [1, 0];
        for (n, &(_, one, _)) in self.nodes.iter().enumerate() {
            for i in 0..2 {
                pull.force[2 * n + i] = self.area * one * answer.traction[AXIS[i]];
                for (k, &(_, two, _)) in self.nodes.iter().enumerate() {
                    for j in 0..2 {
                        pull.tangent[2 * n + i][2 * k + j] = self.area * one * two * answer.tangent[AXIS[i]][AXIS[j]];
                    }
                }
            }
        }
        turned(&angle, [cos, sin], &places, (&mut pull.force, &mut pull.tangent), m);
        Some(pull)
    }
}

/// Springs of all interfaces, in their order.
pub(super) fn springs(mesh: &Mesh, kinematics: Kinematics) -> Result<Vec<Spring>, ModelError> {
    let mut all = Vec::new();
    for (id, interface) in mesh.interfaces.pairs() {
        let face = Face::of(mesh, id, interface)?;
        match interface.quadrature {
            Quadrature::Gauss => {
                let half = 0.5 / 3.0_f64.sqrt();
                face.within(&[0.5 - half, 0.5 + half], &mut all);
            }
            Quadrature::Strips(count) => {
                let middles: Vec<f64> = (0..count).map(|k| (f64::from(k) + 0.5) / f64::from(count)).collect();
                face.within(&middles, &mut all);
            }
            Quadrature::EqualSprings | Quadrature::Nodal => face.pairs(kinematics, &mut all),
        }
    }
    Ok(all)
}

/// An interface laid out.
struct Face<'a> {
    id: InterfaceId,
    interface: &'a Interface,
    /// Middle between the sides [m], and the way to each pair [m].
    middle: Vec<Vec2>,
    along: Vec<f64>,
}

impl<'a> Face<'a> {
    fn of(mesh: &Mesh, id: InterfaceId, interface: &'a Interface) -> Result<Face<'a>, ModelError> {
        let pairs = interface.one.iter().zip(&interface.two);
        let middle: Vec<Vec2> = pairs.map(|(one, two)| (mesh.nodes[*one] + mesh.nodes[*two]) * 0.5).collect();
        let mut along = vec![0.0];
        for (a, b) in middle.iter().zip(&middle[1..]) {
            let length = (*b - *a).norm();
            if !(length > 0.0) {
                return Err(ModelError::Interface(id.index()));
            }
            along.push(along.last().copied().unwrap_or_default() + length);
        }
        Ok(Face { id, interface, middle, along })
    }

    fn spring(&self, along: f64, area: f64, direction: Vec2, nodes: Vec<(NodeId, f64, f64)>) -> Spring {
        Spring { interface: self.id, kind: self.interface.kind, along, area, direction, nodes }
    }

    /// One spring between the nodes of each pair.
    fn pairs(&self, kinematics: Kinematics, all: &mut Vec<Spring>) {
        let last = self.middle.len() - 1;
        let length = self.along[last];
        for pair in 0..=last {
            let (before, after) = (pair.saturating_sub(1), (pair + 1).min(last));
            let area = match self.interface.quadrature {
                Quadrature::EqualSprings => length / (last + 1) as f64,
                _ => 0.5 * (self.along[after] - self.along[before]),
            };
            let direction = self.middle[after] - self.middle[before];
            let mut nodes = vec![(self.interface.one[pair], -1.0, 0.0), (self.interface.two[pair], 1.0, 0.0)];
            if kinematics == Kinematics::Large {
                for (other, part) in [(before, -0.5), (after, 0.5)] {
                    for (side, of_pair) in [(&self.interface.one, 0), (&self.interface.two, 1)] {
                        match other == pair {
                            true => nodes[of_pair].2 += part,
                            false => nodes.push((side[other], 0.0, part)),
                        }
                    }
                }
            }
            all.push(self.spring(self.along[pair], area, direction.unit(), nodes));
        }
    }

    /// Springs at these shares of each segment, of the same area.
    fn within(&self, shares: &[f64], all: &mut Vec<Spring>) {
        for a in 0..self.middle.len() - 1 {
            let b = a + 1;
            let way = self.middle[b] - self.middle[a];
            let length = self.along[b] - self.along[a];
            for &share in shares {
                let nodes = vec![
                    (self.interface.one[a], share - 1.0, -0.5),
                    (self.interface.one[b], -share, 0.5),
                    (self.interface.two[a], 1.0 - share, -0.5),
                    (self.interface.two[b], share, 0.5),
                ];
                all.push(self.spring(self.along[a] + share * length, length / shares.len() as f64, way.unit(), nodes));
            }
        }
    }
}
