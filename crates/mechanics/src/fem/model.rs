//! What is fixed of a finite element problem: mesh, materials, supports.

use super::dofs::{Dofs, dof};
use super::element::{Element, Section, mass, sample};
use super::interface::{Spring, springs};
use super::joint::{JointLaw, PairState};
use super::law::Material;
use super::mesh::{Mesh, Quad};
use super::settings::Kinematics;
use super::state::Point;
use crate::ids::{Id, InterfaceId, NodeId, QuadId, Table, ZoneId};
use crate::plane::Vec2;
use thiserror::Error;

/// A node that is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Support {
    /// Which one.
    pub node: NodeId,
    /// Whether it is held along x and along y.
    pub held: [bool; 2],
}

/// A finite element problem.
#[derive(Debug, Clone)]
pub struct Model {
    /// Nodes, quadrilaterals and interfaces.
    pub mesh: Mesh,
    /// What each zone is made of.
    pub sections: Table<ZoneId, Section>,
    /// Law of each kind of interface.
    pub joints: Vec<JointLaw>,
    /// What displacements do to geometry.
    pub kinematics: Kinematics,
    /// Points of the interfaces.
    pub springs: Vec<Spring>,
    pub(super) dofs: Dofs,
    /// Length of an element, in the mean [m].
    pub(super) size: f64,
}

/// Why there is no model.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ModelError {
    /// A place that is no number.
    #[error("node {0} has no finite coordinates")]
    Node(usize),
    /// An index beyond the end of its table.
    #[error("{what} {index} names {of} {named}, of which there are {count}")]
    Missing {
        /// What names it.
        what: &'static str,
        /// Which one of them.
        index: usize,
        /// What is named.
        of: &'static str,
        /// Its index.
        named: usize,
        /// How many there are.
        count: usize,
    },
    /// A quadrilateral that is folded, has no area or runs clockwise.
    #[error("quadrilateral {0} of zone {1:?} is folded or does not run counter-clockwise")]
    Folded(usize, String),
    /// Tables of different lengths.
    #[error("{0} zones have {1} sections")]
    Sections(usize, usize),
    /// A stiffness, a ratio or a density that no material has.
    #[error("zone {0:?} needs a modulus above 0, a Poisson's ratio above -1 and below 0.5, and a density of 0 or more")]
    Material(String),
    /// An interface whose sides do not fit, or that has no length.
    #[error("interface {0} needs two or more pairs of nodes at different places")]
    Interface(usize),
    /// More components than the system of equations can number.
    #[error("{0} nodes are more than the {1} that can be numbered")]
    TooLarge(usize, usize),
}

/// Most nodes: entries of the tangent are numbered with 32 bits, and a node has about 40.
const MOST_NODES: usize = 50_000_000;

impl Model {
    /// Checks the parts and puts them together.
    ///
    /// # Errors
    /// An index beyond its table, a folded quadrilateral, a material or an interface that cannot be, or too many nodes.
    pub fn new(
        mesh: Mesh,
        sections: Table<ZoneId, Section>,
        joints: Vec<JointLaw>,
        supports: &[Support],
        kinematics: Kinematics,
    ) -> Result<Model, ModelError> {
        check(&mesh, &sections, &joints, supports)?;
        let springs = springs(&mesh, kinematics)?;
        let mut held = vec![false; 2 * mesh.nodes.len()];
        for support in supports {
            for axis in 0..2 {
                held[dof(support.node, axis)] |= support.held[axis];
            }
        }
        let size = size(&mesh);
        Ok(Model { dofs: Dofs::new(&held), springs, size, mesh, sections, joints, kinematics })
    }

    /// Equations: free components of displacement.
    pub fn equations(&self) -> usize {
        self.dofs.free.len()
    }

    /// Components (`2 node` for x, `2 node + 1` for y) in order of their equations.
    pub fn free(&self) -> &[u32] {
        &self.dofs.free
    }

    /// Whether a component of a node is held.
    pub fn held(&self, node: NodeId, axis: usize) -> bool {
        self.dofs.held(dof(node, axis))
    }

    /// Corners of a quadrilateral before anything moves [m].
    pub fn corners(&self, quad: QuadId) -> [Vec2; 4] {
        self.mesh.quads[quad].nodes.map(|node| self.mesh.nodes[node])
    }

    /// Displacement components of a quadrilateral's corners.
    pub(super) fn components(&self, quad: QuadId) -> [usize; 8] {
        let nodes = self.mesh.quads[quad].nodes;
        std::array::from_fn(|i| dof(nodes[i / 2], i % 2))
    }

    /// Section of a quadrilateral.
    pub fn section(&self, quad: QuadId) -> &Section {
        &self.sections[self.mesh.quads[quad].zone]
    }

    /// Whether every tangent is symmetric.
    pub(super) fn symmetric(&self) -> bool {
        self.sections.iter().all(|section| section.solid.material.symmetric())
            && self.joints.iter().all(JointLaw::symmetric)
    }

    /// Nodal forces [N/m] of the weight under `gravity` [m/s^2] (equation 7).
    pub fn weight(&self, gravity: Vec2) -> Vec<f64> {
        let mut forces = vec![0.0; self.dofs.equation.len()];
        for (id, quad) in self.mesh.quads.pairs() {
            let density = self.section(id).density;
            let mass = mass(&self.corners(id));
            for a in 0..4 {
                let share: f64 = density * mass[a].iter().sum::<f64>();
                forces[dof(quad.nodes[a], 0)] += share * gravity.x;
                forces[dof(quad.nodes[a], 1)] += share * gravity.y;
            }
        }
        forces
    }

    /// Whether a quadrilateral locks where all of its points flow: plain ones do (Nagtegaal, Parks and Rice 1974).
    pub(super) fn may_lock(&self, quad: QuadId) -> bool {
        let section = self.section(quad);
        section.element == Element::Q4
            && !matches!(section.solid.material, Material::Elastic(_) | Material::NoTension(_))
    }

    /// Those that do, by what the points of all quadrilaterals answer; and those that `holds` its modes.
    pub(super) fn locking(&self, points: &[Point], holds: impl Fn(QuadId) -> bool) -> usize {
        let flows = |quad: QuadId| points[4 * quad.index()..4 * quad.index() + 4].iter().all(|point| point.yields);
        self.mesh.quads.pairs().filter(|(quad, _)| (self.may_lock(*quad) || holds(*quad)) && flows(*quad)).count()
    }

    /// Whether the modes of a quadrilateral are to be sought.
    pub(super) fn incompatible(&self, quad: QuadId) -> bool {
        self.section(quad).element == Element::QM6
    }
}

fn size(mesh: &Mesh) -> f64 {
    let across = |quad: &Quad| (mesh.nodes[quad.nodes[2]] - mesh.nodes[quad.nodes[0]]).norm();
    mesh.quads.iter().map(across).sum::<f64>() / mesh.quads.len().max(1) as f64
}

/// How many of some pairs are open, and how many slide.
pub(super) fn count(states: impl Iterator<Item = PairState>) -> (usize, usize) {
    states.fold((0, 0), |(open, sliding), state| match state {
        PairState::Closed => (open, sliding),
        PairState::Open => (open + 1, sliding),
        PairState::Sliding => (open, sliding + 1),
    })
}

fn check(
    mesh: &Mesh,
    sections: &Table<ZoneId, Section>,
    joints: &[JointLaw],
    supports: &[Support],
) -> Result<(), ModelError> {
    let nodes = mesh.nodes.len();
    let within = |what, index, of, named: usize, count: usize| {
        if named < count { Ok(()) } else { Err(ModelError::Missing { what, index, of, named, count }) }
    };
    if nodes > MOST_NODES {
        return Err(ModelError::TooLarge(nodes, MOST_NODES));
    }
    if let Some((id, _)) = mesh.nodes.pairs().find(|(_, place)| !place.is_finite()) {
        return Err(ModelError::Node(id.index()));
    }
    if sections.len() != mesh.zones.len() {
        return Err(ModelError::Sections(mesh.zones.len(), sections.len()));
    }
    for (zone, section) in sections.pairs() {
        let elastic = section.solid.material.elastic();
        let sound = elastic.modulus > 0.0 && elastic.modulus.is_finite() && elastic.ratio > -1.0 && elastic.ratio < 0.5;
        if !(sound && section.density >= 0.0 && section.density.is_finite()) {
            return Err(ModelError::Material(mesh.zones[zone].clone()));
        }
    }
    for (id, quad) in mesh.quads.pairs() {
        for node in quad.nodes {
            within("quadrilateral", id.index(), "node", node.index(), nodes)?;
        }
        within("quadrilateral", id.index(), "zone", quad.zone.index(), mesh.zones.len())?;
        let corners = quad.nodes.map(|node| mesh.nodes[node]);
        if !sample(&corners).iter().all(|sample| sample.area > 0.0) {
            return Err(ModelError::Folded(id.index(), mesh.zones[quad.zone].clone()));
        }
    }
    for (id, interface) in mesh.interfaces.pairs() {
        for node in interface.one.iter().chain(&interface.two) {
            within("interface", id.index(), "node", node.index(), nodes)?;
        }
        within("interface", id.index(), "kind", interface.kind, joints.len())?;
        if interface.one.len() != interface.two.len() || interface.one.len() < 2 {
            return Err(ModelError::Interface(InterfaceId::index(id)));
        }
    }
    for (index, support) in supports.iter().enumerate() {
        within("support", index, "node", support.node.index(), nodes)?;
    }
    Ok(())
}
