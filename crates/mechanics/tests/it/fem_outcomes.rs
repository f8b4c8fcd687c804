//! How runs end: completed, singular, not converged, cancelled; and that no input makes numbers that are none.

use crate::fem_tools::{carried, elastic, forces, grid, held, model, node, of, tie, tight, with_joints};
use mechanics::fem::joint::{Contact, JointLaw};
use mechanics::fem::law::{Elastic, Material, Plane, VonMises};
use mechanics::fem::{
    Element, Interface, Kinematics, Mesh, Model, ModelError, Quad, Quadrature, Settings, State, Status, Target,
    Workspace, advance, reactions,
};
use mechanics::ids::{Id, NodeId};
use mechanics::plane::vec2;
use mechanics::watch::{Progress, Unwatched, Watch, Wish};
use proptest::prelude::*;

const STIFF: Elastic = Elastic { modulus: 1e6, ratio: 0.25 };

/// A body that nothing holds against sliding.
#[test]
fn a_body_without_support_is_singular() {
    let mesh = grid(3, 3, vec2);
    let supports: Vec<_> = (0..=3).map(|i| held(node(3, i, 0), false, true)).collect();
    let body = model(mesh, elastic(1e6, 0.25, Plane::Strain, Element::QM6), &supports, Kinematics::Small);
    let target = Target { forces: forces(&body, &[(node(3, 3, 3), 1.0, 0.0)]), imposed: Vec::new() };
    let (state, _, outcome) = carried(&body, &target, &tight(2));
    assert_eq!(outcome.status, Status::Singular, "{outcome:?}");
    assert!(outcome.reached == 0.0 && state == State::new(&body), "the state stands where it stood");
}

/// A tension bar yields at its strength: the load above it is never carried, the state stands just below.
#[test]
fn a_load_beyond_the_limit_is_not_carried() {
    let material = Material::VonMises(VonMises { elastic: STIFF, strength: 100.0 });
    let mesh = grid(4, 1, |s, t| vec2(4.0 * s, t));
    let mut supports: Vec<_> = (0..=4).map(|i| held(node(4, i, 0), i == 0, true)).collect();
    supports.push(held(node(4, 0, 1), true, false));
    let bar = model(mesh, of(material, Plane::Strain, Element::Q4), &supports, Kinematics::Small);
    // Plane strain, no stress across: flow without change of volume at 2 k.
    let pull = forces(&bar, &[(node(4, 4, 0), 150.0, 0.0), (node(4, 4, 1), 150.0, 0.0)]);
    let (state, mut work, outcome) =
        carried(&bar, &Target { forces: pull, imposed: Vec::new() }, &Settings { load_steps: 10, ..tight(10) });
    assert!(matches!(outcome.status, Status::NotConverged | Status::Singular), "{outcome:?}");
    let carried = 300.0 * outcome.reached;
    assert!((195.0..=200.0 + 1e-6).contains(&carried), "{carried}");
    let held: f64 = [0, 1].map(|j| reactions(&bar, &mut work, &state)[2 * node(4, 0, j).index()]).iter().sum();
    assert!((held + carried).abs() < 1e-6 * carried, "{held} for {carried}");
    assert!(outcome.steps.iter().any(|step| !step.kept), "steps that failed are told");
}

/// Is asked before each load step and in its one iteration.
struct Impatient(u32);

impl Watch for Impatient {
    fn look(&mut self, _: &Progress) -> Wish {
        self.0 += 1;
        if self.0 > 6 { Wish::Stop } else { Wish::GoOn }
    }
}

#[test]
fn an_onlooker_stops_at_a_balanced_state() {
    let mesh = grid(3, 3, vec2);
    let supports: Vec<_> = (0..=3).map(|i| held(node(3, i, 0), true, true)).collect();
    let body = model(mesh, elastic(1e6, 0.25, Plane::Strain, Element::QM6), &supports, Kinematics::Small);
    let target = Target { forces: forces(&body, &[(node(3, 3, 3), 1.0, 0.0)]), imposed: Vec::new() };
    let (mut state, mut work) = (State::new(&body), Workspace::new(&body).unwrap());
    let outcome = advance(&body, &mut state, &mut work, &target, &tight(10), &mut Impatient(0));
    assert_eq!((outcome.status, outcome.steps.len()), (Status::Cancelled, 3));
    assert!((outcome.reached - 0.3).abs() < 1e-12 && (state.forces[31 - 1] - 0.3).abs() < 1e-12);
}

/// Two squares, one on the other, with an interface between them.
fn stacked(law: JointLaw, quadrature: Quadrature, kinematics: Kinematics) -> (Model, Vec<NodeId>) {
    let n = 4;
    let mut mesh = Mesh::default();
    let zone = mesh.zones.push("blocks".to_owned());
    mesh.kinds.push("joint".to_owned());
    let rows: Vec<Vec<NodeId>> = [0.0, 1.0, 1.0, 2.0]
        .iter()
        .map(|y| (0..=n).map(|i| mesh.nodes.push(vec2(i as f64 / n as f64, *y))).collect())
        .collect();
    for (low, high) in [(0, 1), (2, 3)] {
        for i in 0..n {
            mesh.quads.push(Quad { nodes: [rows[low][i], rows[low][i + 1], rows[high][i + 1], rows[high][i]], zone });
        }
    }
    mesh.interfaces.push(Interface { one: rows[1].clone(), two: rows[2].clone(), kind: 0, quadrature });
    let supports: Vec<_> = rows[0].iter().map(|node| held(*node, true, true)).collect();
    let section = elastic(1e8, 0.0, Plane::Strain, Element::QM6);
    (with_joints(mesh, section, vec![law], &supports, kinematics), rows[3].clone())
}

/// A block pressed on another by 1 kN slides at friction times that and not before, whatever the quadrature and the kinematics.
#[test]
fn a_block_slides_at_its_friction() {
    let law = JointLaw::Contact(Contact {
        normal: 1e10,
        tangential: 1e10,
        friction: 0.4,
        cohesion: 0.0,
        separation: true,
        rounding: 0.0,
    });
    for quadrature in [Quadrature::EqualSprings, Quadrature::Nodal, Quadrature::Gauss] {
        for kinematics in [Kinematics::Small, Kinematics::Large] {
            let (body, top) = stacked(law, quadrature, kinematics);
            let share = [0.125, 0.25, 0.25, 0.25, 0.125];
            let down: Vec<_> = top.iter().zip(share).map(|(node, s)| (*node, 0.0, -1000.0 * s)).collect();
            // The sideways force acts at the joint, so that it does not tip the block.
            let foot: Vec<NodeId> = (10..15).map(NodeId::new).collect();
            let with = |side: f64| {
                let mut all = down.clone();
                all.extend(foot.iter().zip(share).map(|(node, s)| (*node, side * s, 0.0)));
                Target { forces: forces(&body, &all), imposed: Vec::new() }
            };
            let (mut state, mut work) = (State::new(&body), Workspace::new(&body).unwrap());
            let settings = Settings { tolerance: 1e-8, ..Settings::default() };
            let pressed = advance(&body, &mut state, &mut work, &with(0.0), &settings, &mut Unwatched);
            assert_eq!(pressed.status, Status::Completed, "{quadrature:?} {kinematics:?}");
            let holds = advance(&body, &mut state, &mut work, &with(399.0), &settings, &mut Unwatched);
            assert_eq!(holds.status, Status::Completed, "{quadrature:?} {kinematics:?} {holds:?}");
            let slides = advance(&body, &mut state, &mut work, &with(450.0), &settings, &mut Unwatched);
            assert!(slides.status != Status::Completed, "{quadrature:?} {kinematics:?}");
            let reached = 399.0 + 51.0 * slides.reached;
            assert!(reached <= 400.0 + 1e-3, "{quadrature:?} {kinematics:?}: {reached}");
        }
    }
}

/// Springs of an interface carry what presses on them: area by area, and in all.
#[test]
fn areas_of_springs_fill_the_face() {
    for quadrature in [Quadrature::EqualSprings, Quadrature::Nodal, Quadrature::Gauss] {
        let law = tie(1e9, 1e9);
        let (body, _) = stacked(law, quadrature, Kinematics::Small);
        let area: f64 = body.springs.iter().map(|spring| spring.area).sum();
        assert!((area - 1.0).abs() < 1e-12, "{quadrature:?}: {area}");
        let equal = body.springs.iter().all(|spring| (spring.area - 0.2).abs() < 1e-12);
        assert_eq!(equal, quadrature == Quadrature::EqualSprings);
    }
}

#[test]
fn models_that_are_none_are_named() {
    let section = elastic(1e6, 0.25, Plane::Strain, Element::QM6);
    let with =
        |mesh: Mesh, section| Model::new(mesh, [section].into_iter().collect(), Vec::new(), &[], Kinematics::Small);
    let folded = grid(1, 1, |s, t| vec2(-s, t));
    assert!(matches!(with(folded, section), Err(ModelError::Folded(0, _))));
    let nowhere = grid(1, 1, |s, t| vec2(s, t / 0.0));
    assert!(matches!(with(nowhere, section), Err(ModelError::Node(_))));
    let soft = elastic(-1.0, 0.25, Plane::Strain, Element::QM6);
    assert!(matches!(with(grid(1, 1, vec2), soft), Err(ModelError::Material(_))));
    let mut torn = grid(1, 1, vec2);
    torn.interfaces.push(Interface {
        one: vec![NodeId::new(0)],
        two: vec![NodeId::new(1)],
        kind: 0,
        quadrature: Quadrature::Nodal,
    });
    assert!(matches!(with(torn, section), Err(ModelError::Missing { .. })));
}

/// The same run twice, to the bit.
#[test]
fn runs_repeat_to_the_bit() {
    let run = || {
        let material = Material::VonMises(VonMises { elastic: STIFF, strength: 100.0 });
        let mesh = grid(6, 6, vec2);
        let supports: Vec<_> = (0..=6).map(|i| held(node(6, i, 0), true, true)).collect();
        let body = model(mesh, of(material, Plane::Strain, Element::QM6), &supports, Kinematics::Large);
        let target = Target { forces: forces(&body, &[(node(6, 6, 6), 12.0, -12.0)]), imposed: Vec::new() };
        carried(&body, &target, &Settings::default())
    };
    let (one, two) = (run(), run());
    assert!(one.0 == two.0 && one.2 == two.2, "{:?}", one.2);
    assert!(one.2.status == Status::Completed && one.0.yielding() > 0, "{:?}", one.2);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// Whatever the load, strength, element and kinematics: a named end, and a state of finite numbers that carries what it says.
    #[test]
    fn any_load_ends(
        load in prop::array::uniform2(-300.0..300.0_f64),
        strength in 1.0..200.0_f64,
        modes in any::<bool>(),
        large in any::<bool>(),
        skew in -0.3..0.3_f64,
    ) {
        let material = Material::VonMises(VonMises { elastic: STIFF, strength });
        let element = if modes { Element::QM6 } else { Element::Q4 };
        let kinematics = if large { Kinematics::Large } else { Kinematics::Small };
        let mesh = grid(3, 3, |s, t| vec2(s + skew * s * t, t + skew * s));
        let supports: Vec<_> = (0..=3).map(|i| held(node(3, i, 0), true, true)).collect();
        let body = model(mesh, of(material, Plane::Strain, element), &supports, kinematics);
        let target = Target { forces: forces(&body, &[(node(3, 2, 3), load[0], load[1])]), imposed: Vec::new() };
        let settings = Settings { load_steps: 4, cut_limit: 4, ..Settings::default() };
        let (state, mut work, outcome) = carried(&body, &target, &settings);
        prop_assert!(state.displacements.iter().all(|u| u.is_finite()));
        let expected = load.map(|load| load * outcome.reached);
        let all = reactions(&body, &mut work, &state);
        for axis in 0..2 {
            let sum: f64 = all.iter().skip(axis).step_by(2).sum();
            prop_assert!((sum + expected[axis]).abs() < 1e-4 * (load[0].hypot(load[1])), "{sum} {expected:?} {outcome:?}");
        }
        prop_assert!((outcome.reached == 1.0) == (outcome.status == Status::Completed));
    }
}

/// A soft column on a stiff contact on another: the displacement of its top, which the contact hardly adds to.
fn on_a_stiff_contact(normal: f64) -> (Status, f64) {
    let mut mesh = grid(4, 4, vec2);
    let zone = mesh.quads.iter().next().unwrap().zone;
    let below = |i: usize, j: usize| NodeId::new(25 + 5 * j + i);
    for j in 0..=4 {
        for i in 0..=4 {
            mesh.nodes.push(vec2(0.25 * i as f64, -1.0 + 0.25 * j as f64));
        }
    }
    for (i, j) in (0..4).flat_map(|j| (0..4).map(move |i| (i, j))) {
        mesh.quads.push(Quad { nodes: [below(i, j), below(i + 1, j), below(i + 1, j + 1), below(i, j + 1)], zone });
    }
    mesh.kinds = vec!["contact".into()];
    let (one, two) = ((0..=4).map(|i| below(i, 4)).collect(), (0..=4).map(|i| node(4, i, 0)).collect());
    mesh.interfaces.push(Interface { one, two, kind: 0, quadrature: Quadrature::Nodal });
    let contact =
        Contact { normal, tangential: 0.4 * normal, friction: 0.4, cohesion: 0.0, separation: true, rounding: 0.0 };
    let supports: Vec<_> =
        (0..=4).map(|i| held(below(i, 0), true, true)).chain([held(node(4, 0, 4), true, false)]).collect();
    let soft = elastic(1e5, 0.2, Plane::Strain, Element::QM6);
    let model = with_joints(mesh, soft, vec![JointLaw::Contact(contact)], &supports, Kinematics::Small);
    let target = Target { forces: model.weight(vec2(0.0, -9.81)), imposed: vec![] };
    let (state, _, outcome) = carried(&model, &target, &Settings { load_steps: 2, ..Settings::default() });
    (outcome.status, state.displacements[2 * node(4, 4, 4).index() + 1])
}

/// Ten orders of magnitude between a contact and what it stands on: the equations have an inverse, and it is found.
#[test]
fn a_stiff_contact_on_soft_ground_is_no_mechanism() {
    let (_, exact) = on_a_stiff_contact(1e10);
    for normal in [1e12, 1e14, 1e15, 1e16] {
        let (status, found) = on_a_stiff_contact(normal);
        assert_eq!(status, Status::Completed, "{normal:e}");
        assert!((found / exact - 1.0).abs() < 1e-3, "{normal:e}: {found} for {exact}");
    }
}
