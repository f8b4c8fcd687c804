//! Meshes and materials that the tests of finite elements share.

use mechanics::fem::joint::{Contact, JointLaw, LiftOff, Mortar, Shear};
use mechanics::fem::law::{Elastic, Material, Plane, Solid};
use mechanics::fem::{
    Element, Kinematics, Mesh, Model, Outcome, Quad, Section, Settings, State, Status, Support, Target, Workspace,
    advance,
};
use mechanics::ids::{Id, NodeId, ZoneId};
use mechanics::plane::Vec2;
use mechanics::watch::Unwatched;

/// A grid of `nx` by `ny` quadrilaterals in one zone; `place` maps the unit square.
pub(crate) fn grid(nx: usize, ny: usize, place: impl Fn(f64, f64) -> Vec2) -> Mesh {
    let mut mesh = Mesh::default();
    let zone = mesh.zones.push("body".to_owned());
    for j in 0..=ny {
        for i in 0..=nx {
            mesh.nodes.push(place(i as f64 / nx as f64, j as f64 / ny as f64));
        }
    }
    for j in 0..ny {
        for i in 0..nx {
            let at = |i: usize, j: usize| node(nx, i, j);
            mesh.quads.push(Quad { nodes: [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)], zone });
        }
    }
    mesh
}

/// Node of a grid.
pub(crate) fn node(nx: usize, i: usize, j: usize) -> NodeId {
    NodeId::new(j * (nx + 1) + i)
}

pub(crate) fn elastic(modulus: f64, ratio: f64, plane: Plane, element: Element) -> Section {
    of(Material::Elastic(Elastic { modulus, ratio }), plane, element)
}

/// A bed of a modulus [Pa], a Poisson's ratio and a thickness [m], without strength in tension and of a shear strength of 1 MPa.
pub(crate) fn bed_of_mortar(modulus: f64, ratio: f64, thickness: f64) -> Mortar {
    let normal = modulus / thickness;
    Mortar {
        normal,
        tangential: normal / (2.0 * (1.0 + ratio)),
        lift_off: LiftOff::Stress(0.0),
        compressive_strength: None,
        shear: Shear::Panel { strength: 1e6, when_open: false },
    }
}

/// A section of 2000 kg/m^3.
/// A joint that only deforms: linear in both directions, in tension as in compression.
pub(crate) const fn tie(normal: f64, tangential: f64) -> JointLaw {
    let (friction, cohesion, separation, rounding) = (0.0, f64::INFINITY, false, 0.0);
    JointLaw::Contact(Contact { normal, tangential, friction, cohesion, separation, rounding })
}

pub(crate) fn of(material: Material, plane: Plane, element: Element) -> Section {
    Section { solid: Solid { material, plane }, element, density: 2000.0 }
}

/// One section in all zones.
pub(crate) fn model(mesh: Mesh, section: Section, supports: &[Support], kinematics: Kinematics) -> Model {
    with_joints(mesh, section, Vec::new(), supports, kinematics)
}

/// One section in all zones, and interfaces.
pub(crate) fn with_joints(
    mesh: Mesh,
    section: Section,
    joints: Vec<JointLaw>,
    supports: &[Support],
    kinematics: Kinematics,
) -> Model {
    let sections = mesh.zones.ids().map(|_: ZoneId| section).collect();
    Model::new(mesh, sections, joints, supports, kinematics).unwrap()
}

pub(crate) fn held(node: NodeId, x: bool, y: bool) -> Support {
    Support { node, held: [x, y] }
}

/// Nodal forces from a list.
pub(crate) fn forces(model: &Model, list: &[(NodeId, f64, f64)]) -> Vec<f64> {
    let mut all = vec![0.0; 2 * model.mesh.nodes.len()];
    for (node, x, y) in list {
        all[2 * node.index()] += x;
        all[2 * node.index() + 1] += y;
    }
    all
}

/// Settings of one load step to a tight tolerance.
pub(crate) fn tight(load_steps: u32) -> Settings {
    Settings { tolerance: 1e-10, load_steps, ..Settings::default() }
}

/// Carries a target from nothing.
pub(crate) fn carried(model: &Model, target: &Target, settings: &Settings) -> (State, Workspace, Outcome) {
    let (mut state, mut work) = (State::new(model), Workspace::new(model).unwrap());
    let outcome = advance(model, &mut state, &mut work, target, settings, &mut Unwatched);
    (state, work, outcome)
}

/// Carries forces in one step, which has to succeed.
pub(crate) fn solved(model: &Model, forces: Vec<f64>) -> State {
    let (state, _, outcome) = carried(model, &Target { forces, imposed: Vec::new() }, &tight(1));
    assert_eq!(outcome.status, Status::Completed, "{outcome:?}");
    state
}

pub(crate) fn moved(state: &State, node: NodeId) -> [f64; 2] {
    [state.displacements[2 * node.index()], state.displacements[2 * node.index() + 1]]
}
