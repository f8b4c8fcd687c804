//! Mortar that breaks: which pairs do, and that the way there does not matter.

use crate::fem_tools::{bed_of_mortar, carried, elastic, forces, grid, held, moved, node, tie, tight, with_joints};
use mechanics::fem::condensed::{Condensed, Reached, load_pattern};
use mechanics::fem::joint::{JointLaw, LiftOff, Mortar, PairState};
use mechanics::fem::law::Plane;
use mechanics::fem::{Element, Interface, Kinematics, Mesh, Model, Quad, Quadrature, State, Status, Target};
use mechanics::ids::{Id, NodeId};
use mechanics::plane::vec2;
use mechanics::watch::Unwatched;

const STONE: f64 = 10e9;

/// A bed that breaks at a tension [Pa].
fn bed(strength: f64) -> JointLaw {
    JointLaw::Mortar(Mortar { lift_off: LiftOff::Stress(strength), ..bed_of_mortar(1.25e9, 0.0, 0.0125) })
}

/// Two stones on a floor, one above the other, with a bed under each.
fn column(strengths: [f64; 2]) -> (Model, [NodeId; 2]) {
    let mut mesh = Mesh { kinds: vec!["lower".into(), "upper".into()], ..Mesh::default() };
    let zone = mesh.zones.push("stones".into());
    let row = |mesh: &mut Mesh, y: f64| [0.0, 0.4, 0.8].map(|x| mesh.nodes.push(vec2(x, y)));
    let floor = row(&mut mesh, 0.0);
    let mut below = floor;
    for k in 0..2 {
        let (foot, head) = (row(&mut mesh, 0.5 * k as f64), row(&mut mesh, 0.5 * (k + 1) as f64));
        for i in 0..2 {
            mesh.quads.push(Quad { nodes: [foot[i], foot[i + 1], head[i + 1], head[i]], zone });
        }
        let (one, two) = (below.to_vec(), foot.to_vec());
        mesh.interfaces.push(Interface { one, two, kind: k, quadrature: Quadrature::EqualSprings });
        below = head;
    }
    let supports: Vec<_> = floor.iter().chain(&below).map(|at| held(*at, true, true)).collect();
    let section = elastic(STONE, 0.0, Plane::Stress, Element::QM6);
    let model = with_joints(mesh, section, strengths.map(bed).to_vec(), &supports, Kinematics::Small);
    (model, [below[0], below[2]])
}

/// Pulled apart, a column gives way at the weaker of its beds, across all of it and there alone: both are beyond their strength before, and nothing pulls after.
#[test]
fn the_weakest_bed_gives_way_and_spares_the_others() {
    let apart = 1e-4;
    for (strengths, weaker) in [([100e3, 250e3], 0), ([250e3, 100e3], 1)] {
        for steps in [1, 7, 40] {
            let (model, _) = column(strengths);
            let heads = model.mesh.nodes.pairs().filter(|(_, place)| place.y == 1.0).map(|(at, _)| at);
            let imposed = heads.flat_map(|at| [(at, 0, 0.0), (at, 1, apart)]).collect();
            let target = Target { forces: model.weight(vec2(0.0, -9.81)), imposed };
            let (state, _, outcome) = carried(&model, &target, &tight(steps));
            assert_eq!(outcome.status, Status::Completed, "{outcome:?}");
            for (spring, bond) in model.springs.iter().zip(&state.bonds) {
                let open = spring.kind == weaker;
                assert_eq!((bond.memory.broken, bond.state == PairState::Open), (open, open), "{steps}: {spring:?}");
                // What the stones weigh moves them by a fortieth of that.
                assert!((bond.opening[0] - if open { apart } else { 0.0 }).abs() < 0.04 * apart, "{steps}: {bond:?}");
            }
        }
    }
}

/// A block that moves as one above a floor, with these edges of its elements [m] and interfaces of these kinds under them.
fn block(edges: &[f64], kinds: &[Option<usize>], laws: Vec<JointLaw>) -> Model {
    let n = kinds.len();
    let mut mesh = grid(n, 1, |s, t| vec2(edges[(s * n as f64).round() as usize], 0.3 * t));
    mesh.kinds = laws.iter().enumerate().map(|(k, _)| k.to_string()).collect();
    for (i, kind) in kinds.iter().enumerate().filter_map(|(i, kind)| kind.map(|kind| (i, kind))) {
        let two = vec![node(n, i, 0), node(n, i + 1, 0)];
        let one = two.iter().map(|at| mesh.nodes[*at]).collect::<Vec<_>>();
        let one = one.into_iter().map(|place| mesh.nodes.push(place)).collect();
        mesh.interfaces.push(Interface { one, two, kind, quadrature: Quadrature::EqualSprings });
    }
    let supports: Vec<_> =
        mesh.interfaces.iter().flat_map(|joint| joint.one.iter().map(|at| held(*at, true, true))).collect();
    let section = elastic(1e6 * STONE, 0.0, Plane::Stress, Element::QM6);
    with_joints(mesh, section, laws, &supports, Kinematics::Small)
}

const TIE: JointLaw = tie(50e9, 50e9);

/// A bed beside ties: whole as long as its share is within its strength, gone beyond, and gone for good. Between the force at which it breaks and that at which it
/// would be beyond its strength without carrying, both are balanced. By both paths, in one step or many.
#[test]
fn a_bed_between_ties_holds_while_it_can_and_never_again() {
    let (strength, width, tie) = (200e3, 0.4, 50e9);
    let mortar = 1.25e9 / 0.0125;
    let breaks = strength * width * (1.0 + 2.0 * tie / mortar);
    let model = block(&[0.0, 0.4, 0.8, 1.2], &[Some(1), Some(0), Some(1)], vec![bed(strength), TIE]);
    let pulled = |force: f64| forces(&model, &(0..4).map(|i| (node(3, i, 1), 0.0, force / 4.0)).collect::<Vec<_>>());
    let (whole, gone) = (width * (mortar + 2.0 * tie), width * 2.0 * tie);
    let way = [(0.5, whole), (0.99, whole), (1.01, gone), (0.99, gone), (-0.5, whole), (0.2, gone)];
    let top = node(3, 1, 1);
    for steps in [1, 10] {
        let (mut state, mut work) = (State::new(&model), mechanics::fem::Workspace::new(&model).unwrap());
        let pattern = load_pattern(&pulled(breaks));
        let observed = [vec![(2 * top.index() + 1, 1.0)]];
        let mut condensed = Condensed::new(model.clone(), State::new(&model), &[pattern], &observed).unwrap();
        for (share, stiffness) in way {
            let target = Target { forces: pulled(share * breaks), imposed: Vec::new() };
            let unwatched = &mut mechanics::watch::Unwatched;
            let outcome = mechanics::fem::advance(&model, &mut state, &mut work, &target, &tight(steps), unwatched);
            assert_eq!(outcome.status, Status::Completed, "{share}: {outcome:?}");
            assert_eq!(condensed.solve_position(&[share], &mut Unwatched).unwrap().reached, Reached::Balanced);
            let closed = share * breaks / stiffness;
            for lifted in [moved(&state, top)[1], condensed.observed()[0]] {
                assert!((lifted / closed - 1.0).abs() < 1e-3, "{share} in {steps}: {lifted:e} {closed:e}");
            }
        }
    }
}

/// A block on two beds with a tie in the middle, where it is pulled up: both beds are beyond their strength, but once one of them has gone the block tilts about
/// the tie and the other is spared. The weaker goes, whichever of them takes part from the beginning.
#[test]
fn what_does_not_take_part_yet_breaks_first_if_it_has_to() {
    let edges = [0.0, 0.1, 0.55, 0.65, 1.1, 1.2];
    let model = block(&edges, &[Some(0), None, Some(2), None, Some(1)], vec![bed(60e3), bed(130e3), TIE]);
    let (beds, tie) = (0.2 * 1.25e9 / 0.0125, 0.1 * 50e9);
    let pull = 143e3 / 1e11 * (beds + tie);
    let pull = forces(&model, &[2, 3].map(|i| (node(5, i, 1), 0.0, 0.5 * pull)));
    let broken = |state: &State, kind: usize| {
        let bonds = model.springs.iter().zip(&state.bonds).filter(|(spring, _)| spring.kind == kind);
        bonds.map(|(_, bond)| bond.memory.broken).collect::<Vec<bool>>()
    };
    let (plain, _, outcome) = carried(&model, &Target { forces: pull.clone(), imposed: Vec::new() }, &tight(1));
    assert_eq!(outcome.status, Status::Completed, "{outcome:?}");
    assert_eq!((broken(&plain, 0), broken(&plain, 1)), (vec![true; 2], vec![false; 2]));
    for known in [None, Some(0), Some(1)] {
        let mut condensed = Condensed::new(model.clone(), State::new(&model), &[load_pattern(&pull)], &[]).unwrap();
        let springs = model.springs.iter().enumerate().filter(|(_, spring)| Some(spring.kind) == known);
        condensed.retain_parts(&springs.map(|(index, _)| index).collect::<Vec<_>>(), &mut Unwatched);
        assert_eq!(condensed.solve_position(&[1.0], &mut Unwatched).unwrap().reached, Reached::Balanced);
        let state = condensed.state().unwrap();
        assert_eq!((broken(&state, 0), broken(&state, 1)), (vec![true; 2], vec![false; 2]), "{known:?}");
    }
}
