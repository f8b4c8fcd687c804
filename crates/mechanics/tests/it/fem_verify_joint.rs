//! Joints and contacts on meshes, against closed forms.

use crate::fem_tools::{bed_of_mortar, carried, elastic, forces, grid, held, model, node, of, tight, with_joints};
use mechanics::fem::joint::{Contact, JointLaw, PairState};
use mechanics::fem::law::{Elastic, Material, NoTension, Plane};
use mechanics::fem::{Element, Interface, Kinematics, Mesh, Model, Quadrature, Settings, Status, Target, reactions};
use mechanics::ids::{Id, NodeId};
use mechanics::plane::{Vec2, vec2};

/// A block of `n` by `rows` elements above a row of fixed nodes at its foot, with an interface between.
fn on_a_floor(n: usize, rows: usize, place: impl Fn(f64, f64) -> Vec2, quadrature: Quadrature) -> Mesh {
    let mut mesh = grid(n, rows, place);
    let two: Vec<NodeId> = (0..=n).map(|i| node(n, i, 0)).collect();
    let one = two.iter().map(|at| mesh.nodes[*at]).collect::<Vec<_>>();
    let one = one.into_iter().map(|place| mesh.nodes.push(place)).collect();
    mesh.kinds.push("joint".to_owned());
    mesh.interfaces.push(Interface { one, two, kind: 0, quadrature });
    mesh
}

fn floor(mesh: &Mesh) -> Vec<mechanics::fem::Support> {
    mesh.interfaces.iter().flat_map(|joint| joint.one.iter().map(|at| held(*at, true, true))).collect()
}

/// Force and moment about its middle of what holds a row of nodes, along `depth` from 0.
fn held_by(reactions: &[f64], row: impl Iterator<Item = (f64, NodeId)>, depth: f64) -> [f64; 2] {
    row.fold([0.0; 2], |[force, moment], (x, at)| {
        let push = -reactions[2 * at.index() + 1];
        [force + push, moment + push * (x - 0.5 * depth)]
    })
}

/// fem.notension.section: width 1, depth 0.54 m, force N at eccentricity e ≥ d/6 on a bed of E/l without tension. The bed is
/// turned and pressed as the closed form says, 2N/(3 (d/2 - e)) at its edge and none beyond 3 (d/2 - e); what holds it is N at e.
#[test]
fn an_eccentric_force_opens_a_bed_of_mortar() {
    let (depth, thickness, modulus, force) = (0.54, 0.0125, 1.25e9, 200e3);
    let bed = bed_of_mortar(modulus, 0.19, thickness);
    for share in [0.2, 0.3, 0.4] {
        let contact = 3.0 * depth * (0.5 - share);
        let turn = 2.0 * force / contact / contact / bed.normal;
        let errors = |n: usize, quadrature: Quadrature| {
            let mesh = on_a_floor(n, 1, |s, t| vec2(depth * s, 0.1 * t), quadrature);
            let mut supports = floor(&mesh);
            supports.extend((0..=n).map(|i| held(node(n, i, 0), true, true)));
            let section = elastic(10e9, 0.0, Plane::Stress, Element::QM6);
            let model = with_joints(mesh, section, vec![JointLaw::Mortar(bed)], &supports, Kinematics::Small);
            let place = |i: usize| depth * i as f64 / n as f64;
            let imposed = (0..=n).map(|i| (node(n, i, 0), 1, -turn * (place(i) - depth + contact))).collect();
            let target = Target { forces: vec![0.0; 2 * model.mesh.nodes.len()], imposed };
            let (state, mut work, outcome) = carried(&model, &target, &tight(1));
            assert_eq!(outcome.status, Status::Completed, "{outcome:?}");
            let open = state.bonds.iter().filter(|bond| bond.state == PairState::Open).count();
            assert!((open as f64 / state.bonds.len() as f64 - (1.0 - contact / depth)).abs() < 1.0 / n as f64 + 1e-9);
            let pushes = reactions(&model, &mut work, &state);
            let [found, moment] = held_by(&pushes, (0..=n).map(|i| (place(i), node(n, i, 0))), depth);
            [(found / force - 1.0).abs(), (moment / found / (share * depth) - 1.0).abs()]
        };
        // Where the contact ends within a segment, up to the square of that segment's part of the contact is missed or counted twice.
        for n in [30, 300] {
            let allowed = (depth / contact / n as f64).powi(2);
            let [found, place] = errors(n, Quadrature::Gauss);
            assert!(found < allowed && place < allowed, "{share}, {n}: {found:e} {place:e}");
        }
        // The bench's 1e-6.
        let [found, place] = errors(4000, Quadrature::Gauss);
        assert!(found < 1e-6 && place < 1e-6, "{share}: {found:e} {place:e}");
        // The paper's seven springs, an equal share each, the outer ones at the very edges, feel a force a tenth to a quarter
        // further out than it is: stiffer in turning than the bed they stand for, and too coarse to find where contact ends.
        let [_, place] = errors(6, Quadrature::EqualSprings);
        assert!(place > 0.1 && place < 0.3, "{share}: {place}");
    }
}

/// fem.notension.section again, of masonry itself without tension: a column whose ends are turned as the closed form says.
#[test]
fn an_eccentric_force_opens_a_column_without_tension() {
    let (depth, height, modulus, force) = (0.6, 0.3, 5e9, 300e3);
    let errors = |n: usize, share: f64, element: Element| {
        let contact = 3.0 * depth * (0.5 - share);
        // Curvature 2N/(9 E (d/2 - e)²).
        let turn = 2.0 * force / (9.0 * modulus * (depth * (0.5 - share)).powi(2)) * height;
        let rows = n / 2;
        let mesh = grid(n, rows, |s, t| vec2(depth * s, height * t));
        let elastic = Elastic { modulus, ratio: 0.0 };
        let masonry = of(Material::NoTension(NoTension { elastic }), Plane::Stress, element);
        let mut supports: Vec<_> = (0..=n).map(|i| held(node(n, i, 0), false, true)).collect();
        supports.extend((0..=n).map(|i| held(node(n, i, rows), false, true)));
        supports.push(held(node(n, n, rows / 2), true, false));
        let model = model(mesh, masonry, &supports, Kinematics::Small);
        let place = |i: usize| depth * i as f64 / n as f64;
        let imposed = (0..=n).map(|i| (node(n, i, rows), 1, -turn * (place(i) - depth + contact))).collect();
        // Pressed lightly from both sides: with nothing there, any width would do, and balance would not be one state but many.
        let mut list = Vec::new();
        for j in 0..=rows {
            let share = if j == 0 || j == rows { 0.5 } else { 1.0 } * height / rows as f64;
            list.extend([(node(n, 0, j), 50e3 * share, 0.0), (node(n, n, j), -50e3 * share, 0.0)]);
        }
        let target = Target { forces: forces(&model, &list), imposed };
        let settings = Settings { tolerance: 1e-8, load_steps: 4, ..Settings::default() };
        let (state, mut work, outcome) = carried(&model, &target, &settings);
        assert_eq!(outcome.status, Status::Completed, "{outcome:?}");
        let pushes = reactions(&model, &mut work, &state);
        let [found, moment] = held_by(&pushes, (0..=n).map(|i| (place(i), node(n, i, rows))), depth);
        [(found / force - 1.0).abs(), (moment / found / (share * depth) - 1.0).abs()]
    };
    for share in [0.2, 0.3] {
        // Q4 has to bend by shearing, which costs the square of the mesh size.
        let [coarse, fine] = [10, 40].map(|n| errors(n, share, Element::Q4));
        assert!((0..2).all(|i| fine[i] < 5e-4 && fine[i] < 0.08 * coarse[i]), "{share}: {coarse:?} {fine:?}");
        // QM6 bends as the closed form does, and the crack ends between elements here: exact.
        let exact = errors(10, share, Element::QM6);
        assert!(exact.iter().all(|error| *error < 1e-9), "{share}: {exact:?}");
    }
}

fn frictional(separation: bool) -> (Model, usize, f64) {
    let n = 8;
    let mesh = on_a_floor(n, 4, |s, t| vec2(2.0 * s, t), Quadrature::Nodal);
    let supports = floor(&mesh);
    let contact = Contact { normal: 50e9, tangential: 50e9, friction: 0.4, cohesion: 0.0, separation, rounding: 0.0 };
    let section = elastic(10e9, 0.2, Plane::Strain, Element::QM6);
    let model = with_joints(mesh, section, vec![JointLaw::Contact(contact)], &supports, Kinematics::Small);
    (model, n, 100e3)
}

/// Pressed by `weight` evenly at its top and pushed by `push` evenly at its foot, so that it is not tilted.
fn pushed(model: &Model, n: usize, weight: f64, push: f64) -> Vec<f64> {
    let mut list = Vec::new();
    for i in 0..=n {
        let share = if i == 0 || i == n { 0.5 } else { 1.0 } / n as f64;
        list.push((node(n, i, 4), 0.0, -weight * share));
        list.push((node(n, i, 0), push * share, 0.0));
    }
    forces(model, &list)
}

#[test]
fn a_block_slides_at_friction_times_weight() {
    use mechanics::fem::{State, Workspace, advance};
    use mechanics::watch::Unwatched;
    for separation in [true, false] {
        let (model, n, weight) = frictional(separation);
        for (share, slides) in [(0.999, false), (1.05, true)] {
            let (mut state, mut work) = (State::new(&model), Workspace::new(&model).unwrap());
            let settings = Settings { tolerance: 1e-8, load_steps: 10, ..Settings::default() };
            let mut carry = |push: f64| {
                let target = Target { forces: pushed(&model, n, weight, push), imposed: Vec::new() };
                advance(&model, &mut state, &mut work, &target, &settings, &mut Unwatched)
            };
            assert_eq!(carry(0.0).status, Status::Completed);
            let outcome = carry(share * 0.4 * weight);
            if !slides {
                assert_eq!(outcome.status, Status::Completed, "{outcome:?}");
                assert!(state.bonds.iter().any(|bond| bond.state != PairState::Sliding));
                continue;
            }
            // A block that slides away is a named outcome; what was carried last is friction times weight, to the smallest step.
            assert!(matches!(outcome.status, Status::NotConverged | Status::Singular), "{outcome:?}");
            let carried = outcome.reached * share;
            assert!(carried <= 1.0 + 1e-6 && carried > 1.0 - 2e-3, "{separation}: {carried}");
        }
    }
}

#[test]
fn a_block_drawn_along_is_held_back_by_friction_times_weight() {
    let (model, n, weight) = frictional(true);
    // One node of the foot is drawn along for a centimetre; a hand that holds it takes the force.
    let mesh = model.mesh.clone();
    let mut supports = floor(&mesh);
    supports.extend((0..=n).map(|i| held(node(n, i, 1), true, false)));
    let model = with_joints(
        mesh,
        model.sections[mechanics::ids::ZoneId::new(0)],
        model.joints.clone(),
        &supports,
        Kinematics::Small,
    );
    let draw: Vec<_> = (0..=n).map(|i| (node(n, i, 1), 0, 0.01)).collect();
    let target = Target { forces: pushed(&model, n, weight, 0.0), imposed: draw };
    let (state, mut work, outcome) = carried(&model, &target, &Settings { tolerance: 1e-8, ..Settings::default() });
    assert_eq!(outcome.status, Status::Completed, "{outcome:?}");
    let forces = reactions(&model, &mut work, &state);
    let drag: f64 = (0..=n).map(|i| forces[2 * node(n, i, 1).index()]).sum();
    // Every pair slides, and normal tractions sum up to the weight: exact but for the tolerance.
    assert!(state.bonds.iter().all(|bond| bond.state == PairState::Sliding));
    assert!((drag / (0.4 * weight) - 1.0).abs() < 1e-6, "{drag}");
}

/// fem.hertz.line: two equal cylinders of radius 1 m meet in a plane, so that one of them meets a rigid, smooth floor.
///
/// The contact is 9 mm wide to each side, and the cylinder is stood for by a square of 0.5 m with its curved foot.
#[test]
fn two_cylinders_meet_as_hertz_has_it() {
    let (half_width, peak): (f64, f64) = (0.009027033, 70523700.0);
    let (radius, size, force) = (1.0, 0.5, 1e6);
    let hertz = |fine: usize| {
        // `fine` even elements over 1.5 half widths, then growing to the far end.
        let even = 1.5 * half_width / fine as f64;
        let mut ways: Vec<f64> = (0..=fine).map(|i| i as f64 * even).collect();
        let mut step = even;
        while ways[ways.len() - 1] < size {
            step *= 1.2;
            ways.push((ways[ways.len() - 1] + step).min(size));
        }
        let n = ways.len() - 1;
        let at = |share: f64| ways[(share * n as f64).round() as usize];
        let sag = |x: f64| radius - (radius * radius - x * x).sqrt();
        let mut mesh = grid(n, n, |s, t| vec2(at(s), at(t) + sag(at(s)) * (1.0 - at(t) / size)));
        let two: Vec<NodeId> = (0..=fine).map(|i| node(n, i, 0)).collect();
        let one: Vec<NodeId> = (0..=fine).map(|i| mesh.nodes.push(vec2(ways[i], 0.0))).collect();
        let mut supports: Vec<_> = one.iter().map(|at| held(*at, true, true)).collect();
        supports.extend((0..=n).map(|j| held(node(n, 0, j), true, false)));
        mesh.kinds.push("contact".to_owned());
        mesh.interfaces.push(Interface { one, two, kind: 0, quadrature: Quadrature::Nodal });
        let contact =
            Contact { normal: 1e15, tangential: 1e9, friction: 0.0, cohesion: 0.0, separation: true, rounding: 0.0 };
        let section = elastic(15e9, 0.2, Plane::Strain, Element::QM6);
        let model = with_joints(mesh, section, vec![JointLaw::Contact(contact)], &supports, Kinematics::Large);
        // Half of the force on half of the body, evenly over its top.
        let mut list = Vec::new();
        for i in 0..n {
            let share = -0.5 * force * (ways[i + 1] - ways[i]) / size;
            list.push((node(n, i, n), 0.0, 0.5 * share));
            list.push((node(n, i + 1, n), 0.0, 0.5 * share));
        }
        let target = Target { forces: forces(&model, &list), imposed: Vec::new() };
        let settings = Settings { tolerance: 1e-8, load_steps: 10, ..Settings::default() };
        let (state, _, outcome) = carried(&model, &target, &settings);
        assert_eq!(outcome.status, Status::Completed, "{outcome:?}");
        // Squared, the pressure is p² = p0² (1 − x²/a²): the line through what is above a third of the peak gives both.
        let points: Vec<[f64; 2]> = (state.bonds.iter().zip(&model.springs))
            .map(|(bond, spring)| [spring.along * spring.along, bond.traction[0] * bond.traction[0]])
            .filter(|[_, squared]| *squared > (peak / 3.0).powi(2))
            .collect();
        let count = points.len() as f64;
        let mean = [0, 1].map(|i| points.iter().map(|p| p[i]).sum::<f64>() / count);
        let slope = points.iter().map(|p| (p[0] - mean[0]) * (p[1] - mean[1])).sum::<f64>()
            / points.iter().map(|p| (p[0] - mean[0]).powi(2)).sum::<f64>();
        let top = mean[1] - slope * mean[0];
        [(-top / slope).sqrt() / half_width - 1.0, top.sqrt() / peak - 1.0, -state.bonds[0].traction[0] / peak - 1.0]
    };
    for fine in [15, 30] {
        let errors = hertz(fine);
        // The bench allows 3 %; a body of 0.5 m for a cylinder is worth (a/size)², the penalty 0.1 % of the approach.
        assert!(errors.iter().all(|error| error.abs() < 5e-3), "{fine}: {errors:?}");
    }
}
