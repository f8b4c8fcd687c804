//! The tangent is the derivative of the forces: compared with central differences, for every kind of element, law and interface.

use crate::fem_tools::{elastic, grid, held, node, of, tie};
use mechanics::fem::joint::{Contact, JointLaw};
use mechanics::fem::law::{Cone, DruckerPrager, Elastic, Material, Plane, VonMises};
use mechanics::fem::{
    Element, Interface, Kinematics, Mesh, Model, Quad, Quadrature, Section, State, Support, Workspace,
};
use mechanics::ids::{Id, NodeId};
use mechanics::plane::{Vec2, vec2};

/// A small shear-free number sequence: displacements that nobody chose.
fn some(i: usize) -> f64 {
    ((i as f64 * 12.9898).sin() * 43_758.545).fract()
}

/// Largest difference between the tangent's columns and central differences of the forces, over the largest entry.
fn error(model: &Model, state: &State, step: f64) -> f64 {
    let mut work = Workspace::new(model).unwrap();
    let free = model.free().to_vec();
    let forces = |work: &mut Workspace, state: &State| {
        assert!(work.stiffness(model, state).is_ok(), "no answer");
        free.iter().map(|c| work.internal[*c as usize]).collect::<Vec<f64>>()
    };
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    for column in 0..free.len() {
        let at = |sign: f64| {
            let mut moved = state.clone();
            moved.displacements[free[column] as usize] += sign * step;
            moved
        };
        let (plus, minus) = (forces(&mut work, &at(1.0)), forces(&mut work, &at(-1.0)));
        work.stiffness(model, state).unwrap();
        let mut unit = vec![0.0; free.len()];
        unit[column] = 1.0;
        for (exact, (plus, minus)) in work.tangent_times(&unit).iter().zip(plus.iter().zip(&minus)) {
            worst = worst.max((exact - (plus - minus) / (2.0 * step)).abs());
            largest = largest.max(exact.abs());
        }
    }
    worst / largest
}

/// Four crooked elements, held at one side, bent out of shape by about `size` [m].
fn crooked(section: Section, kinematics: Kinematics, size: f64) -> (Model, State) {
    let mesh = grid(2, 2, |s, t| vec2(s + 0.1 * t * t, t + 0.15 * s * t));
    let supports = [0, 1, 2].map(|j| held(node(2, 0, j), true, true));
    let model = crate::fem_tools::model(mesh, section, &supports, kinematics);
    let mut state = State::new(&model);
    for (i, u) in state.displacements.iter_mut().enumerate().filter(|(i, _)| !model.held(NodeId::new(i / 2), i % 2)) {
        *u = size * some(i + 1);
    }
    (model, state)
}

const STIFF: Elastic = Elastic { modulus: 1e6, ratio: 0.25 };

/// Large displacements: the turned frame's derivatives are complete. With differences of 1e-6 their own error is about 1e-9.
#[test]
fn of_large_displacements() {
    for element in [Element::Q4, Element::QM6] {
        for size in [1e-3, 0.1, 0.4] {
            let (model, state) = crooked(elastic(1e6, 0.25, Plane::Strain, element), Kinematics::Large, size);
            let off = error(&model, &state, 1e-6);
            assert!(off < 1e-7, "{element:?} {size}: {off}");
        }
    }
}

/// Yielding points beside elastic ones, with and without modes, associated or not.
#[test]
fn of_yielding_elements() {
    let von_mises = Material::VonMises(VonMises { elastic: STIFF, strength: 100.0 });
    let cone = |dilatancy: f64| {
        let angle = 30.0_f64.to_radians();
        Material::DruckerPrager(DruckerPrager::matching(STIFF, Cone::PlaneStrain, 100.0, angle, dilatancy))
    };
    for material in [von_mises, cone(30.0_f64.to_radians()), cone(0.0)] {
        for (plane, kinematics) in
            [(Plane::Strain, Kinematics::Small), (Plane::Stress, Kinematics::Small), (Plane::Strain, Kinematics::Large)]
        {
            for element in [Element::Q4, Element::QM6] {
                let (model, state) = crooked(of(material, plane, element), kinematics, 5e-4);
                let off = error(&model, &state, 1e-9);
                // Differences of forces of 100 N that are exact to 1e-12 over 1e-9 m, against 1e6 Pa.
                assert!(off < 1e-5, "{material:?} {plane:?} {element:?} {kinematics:?}: {off}");
            }
        }
    }
}

/// Two blocks with a joint of three pairs between them, the upper one displaced.
fn blocks(quadrature: Quadrature, law: JointLaw, kinematics: Kinematics, size: f64) -> (Model, State) {
    let mut mesh = Mesh::default();
    let zone = mesh.zones.push("blocks".to_owned());
    mesh.kinds.push("joint".to_owned());
    let mut rows = Vec::new();
    for y in [0.0, 1.0, 1.0, 2.0] {
        // A joint that bends a little, so that normals differ from pair to pair.
        let place = |x: f64| vec2(x, y + if y == 1.0 { 0.1 * x * x } else { 0.0 });
        rows.push([0.0, 0.4, 1.0].map(|x| mesh.nodes.push(place(x))));
    }
    for (low, high) in [(0, 1), (2, 3)] {
        for i in 0..2 {
            mesh.quads.push(Quad { nodes: [rows[low][i], rows[low][i + 1], rows[high][i + 1], rows[high][i]], zone });
        }
    }
    mesh.interfaces.push(Interface { one: rows[1].to_vec(), two: rows[2].to_vec(), kind: 0, quadrature });
    let supports: Vec<Support> = rows[0].iter().map(|node| held(*node, true, true)).collect();
    let section = elastic(1e6, 0.2, Plane::Strain, Element::QM6);
    let model = crate::fem_tools::with_joints(mesh, section, vec![law], &supports, kinematics);
    let mut state = State::new(&model);
    for row in &rows[1..] {
        for node in row {
            for axis in 0..2 {
                let i = 2 * node.index() + axis;
                state.displacements[i] = size * some(i + 7);
            }
        }
    }
    (model, state)
}

/// Every quadrature, in fixed and in turning frames; closed, sliding and open friction.
#[test]
fn of_interfaces() {
    let elastic = tie(2e6, 1e6);
    let contact = JointLaw::Contact(Contact {
        normal: 2e6,
        tangential: 1e6,
        friction: 0.4,
        cohesion: 10.0,
        separation: true,
        rounding: 0.0,
    });
    for quadrature in [Quadrature::EqualSprings, Quadrature::Nodal, Quadrature::Gauss] {
        for kinematics in [Kinematics::Small, Kinematics::Large] {
            for (law, size) in [(elastic, 0.05), (contact, 0.02)] {
                let (model, state) = blocks(quadrature, law, kinematics, size);
                let off = error(&model, &state, 1e-7);
                assert!(off < 1e-6, "{quadrature:?} {kinematics:?} {law:?}: {off}");
            }
        }
    }
}

/// Turned by 90 degrees as a whole, a body and its joints feel nothing.
#[test]
fn a_quarter_turn_strains_nothing() {
    for quadrature in [Quadrature::EqualSprings, Quadrature::Nodal, Quadrature::Gauss] {
        let law = tie(2e6, 1e6);
        let (model, mut state) = blocks(quadrature, law, Kinematics::Large, 0.0);
        for (id, place) in model.mesh.nodes.pairs() {
            let turned: Vec2 = place.left() + vec2(3.0, -1.0);
            state.displacements[2 * id.index()] = turned.x - place.x;
            state.displacements[2 * id.index() + 1] = turned.y - place.y;
        }
        let mut work = Workspace::new(&model).unwrap();
        work.stiffness(&model, &state).unwrap();
        let most = work.internal.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
        // Rounding of 1e6 Pa on strains of 1e-16.
        assert!(most < 1e-8, "{quadrature:?}: {most}");
    }
}
