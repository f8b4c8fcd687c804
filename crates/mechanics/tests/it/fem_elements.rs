//! Elements: patch test, Cook's membrane, the beams of MacNeal and Harder, Lamé's cylinder.

use crate::fem_stress::{recover, stress_at};
use crate::fem_tools::{elastic, forces, grid, held, model, moved, node, solved};
use mechanics::fem::law::Plane;
use mechanics::fem::{Element, Kinematics, Mesh, Quad};
use mechanics::ids::{Id, NodeId, QuadId};
use mechanics::plane::{Vec2, vec2};

/// MacNeal and Harder's patch: five elements, none of them a parallelogram.
fn patch() -> Mesh {
    let places =
        [(0.0, 0.0), (0.24, 0.0), (0.24, 0.12), (0.0, 0.12), (0.04, 0.02), (0.18, 0.03), (0.16, 0.08), (0.08, 0.08)];
    let quads = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]];
    let mut mesh = Mesh::default();
    let zone = mesh.zones.push("patch".to_owned());
    for (x, y) in places {
        mesh.nodes.push(vec2(x, y));
    }
    for quad in quads {
        mesh.quads.push(Quad { nodes: quad.map(NodeId::new), zone });
    }
    mesh
}

/// Displacements that are linear at the rim are linear within, to rounding, in either state of plane and for large
/// displacements too (MacNeal and Harder 1985).
#[test]
fn the_patch_test_is_passed() {
    let field = |p: Vec2| [1e-3 * (p.x + 0.5 * p.y), 1e-3 * (p.y + 0.5 * p.x)];
    for element in [Element::Q4, Element::QM6] {
        for (plane, kinematics) in
            [(Plane::Strain, Kinematics::Small), (Plane::Stress, Kinematics::Small), (Plane::Strain, Kinematics::Large)]
        {
            let mesh = patch();
            let supports: Vec<_> = (0..4).map(|i| held(NodeId::new(i), true, true)).collect();
            let body = model(mesh, elastic(1e6, 0.25, plane, element), &supports, kinematics);
            let imposed = (0..4).flat_map(|i| {
                let node = NodeId::new(i);
                let [x, y] = field(body.mesh.nodes[node]);
                [(node, 0, x), (node, 1, y)]
            });
            let target = mechanics::fem::Target { forces: vec![0.0; 16], imposed: imposed.collect() };
            let (state, _, outcome) = crate::fem_tools::carried(&body, &target, &crate::fem_tools::tight(1));
            assert_eq!(outcome.status, mechanics::fem::Status::Completed);
            // Strain e_xx = e_yy = gamma_xy = 1e-3.
            let stiff = if plane == Plane::Strain { 1e6 / (1.25 * 0.5) * 1e-3 } else { 1e6 / 0.75 * 1e-3 };
            let shear = 1e6 / 2.5 * 1e-3;
            for i in 4..8 {
                let node = NodeId::new(i);
                let (found, exact) = (moved(&state, node), field(body.mesh.nodes[node]));
                for axis in 0..2 {
                    assert!((found[axis] - exact[axis]).abs() < 1e-13, "{element:?} {plane:?} {found:?} {exact:?}");
                }
            }
            // Stress in the turned frame: this field does not turn, so that it is that of the fixed axes.
            for point in &state.points {
                let [x, y, _, xy] = point.stress;
                let off = (x - stiff).abs().max((y - stiff).abs()).max((xy - shear).abs());
                assert!(off < 1e-9 * stiff, "{element:?} {plane:?} {kinematics:?}: {:?}", point.stress);
            }
        }
    }
}

/// Tip of Cook's membrane at (48, 52), E = 1, nu = 1/3, plane stress, unit shear over the right edge.
fn cook(n: usize, element: Element) -> f64 {
    let mesh = grid(n, n, |s, t| vec2(48.0 * s, 44.0 * s + t * (44.0 + s * (16.0 - 44.0))));
    let supports: Vec<_> = (0..=n).map(|j| held(node(n, 0, j), true, true)).collect();
    let body = model(mesh, elastic(1.0, 1.0 / 3.0, Plane::Stress, element), &supports, Kinematics::Small);
    let share = 1.0 / n as f64;
    let edge: Vec<_> =
        (0..n).flat_map(|j| [(node(n, n, j), 0.0, 0.5 * share), (node(n, n, j + 1), 0.0, 0.5 * share)]).collect();
    let state = solved(&body, forces(&body, &edge));
    moved(&state, node(n, n, n / 2))[1]
}

/// Values of an independent program, to the four decimals it printed.
#[test]
fn cooks_membrane() {
    for (element, expected) in [
        (Element::Q4, [11.8452, 18.2992, 22.0792, 23.4304, 23.8176]),
        (Element::QM6, [21.0503, 23.0164, 23.6888, 23.8833, 23.9398]),
    ] {
        for (n, value) in [2, 4, 8, 16, 32].into_iter().zip(expected) {
            let tip = cook(n, element);
            assert!((tip - value).abs() < 1e-4, "{element:?} {n}: {tip} for {value}");
        }
    }
}

/// Errors against the converged value fall as the square of the element's size for QM6 between 8 and 32 elements; the corner at the
/// clamp is singular, so that the order stays a little below two.
#[test]
fn cooks_membrane_converges() {
    let errors = [8, 16, 32].map(|n| 23.9642 - cook(n, Element::QM6));
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((1.5..2.3).contains(&order), "{errors:?}: order {order}");
    }
}

/// MacNeal and Harder's slender beam, 6 x 0.2 x 0.1 by six elements: tip deflection under unit shear over 0.1081, and extension
/// under unit tension over 3e-5. Rectangles, trapezia and parallelograms aslant by 45 degrees.
#[test]
fn macneal_and_harders_slender_beam() {
    let n = 6;
    let shift = |shape: usize, i: usize, j: usize| match (shape, i) {
        (0, _) | (_, 0) | (_, 6) => 0.0,
        (1, _) => 0.1 * if (i + j).is_multiple_of(2) { -1.0 } else { 1.0 },
        _ => 0.1 * if j == 0 { -1.0 } else { 1.0 },
    };
    for (element, bend, stretch) in [
        (Element::Q4, [0.0933, 0.0269, 0.0342], None),
        (Element::QM6, [0.9929, 0.0515, 0.6323], Some([0.9957, 0.9993, 0.9992])),
    ] {
        for shape in 0..3 {
            let mesh = grid(n, 1, |s, t| {
                let (i, j) = ((s * n as f64).round() as usize, t.round() as usize);
                vec2(i as f64 + shift(shape, i, j), 0.2 * t)
            });
            let supports = [held(node(n, 0, 0), true, true), held(node(n, 0, 1), true, true)];
            let body = model(mesh, elastic(1e7, 0.3, Plane::Stress, element), &supports, Kinematics::Small);
            // A beam 0.1 thick carries a tenth of what one of unit thickness does.
            let tip = [node(n, n, 0), node(n, n, 1)];
            let state = solved(&body, forces(&body, &tip.map(|node| (node, 0.0, 5.0))));
            let found = 0.5 * (moved(&state, tip[0])[1] + moved(&state, tip[1])[1]) / 0.1081;
            assert!((found - bend[shape]).abs() < 1e-4, "{element:?} {shape}: {found} for {}", bend[shape]);
            if let Some(stretch) = stretch {
                let state = solved(&body, forces(&body, &tip.map(|node| (node, 5.0, 0.0))));
                let found = 0.5 * (moved(&state, tip[0])[0] + moved(&state, tip[1])[0]) / 3e-5;
                assert!((found - stretch[shape]).abs() < 1e-4, "{element:?} {shape}: {found} for {}", stretch[shape]);
            }
        }
    }
}

/// MacNeal and Harder's curved beam, radii 4.12 to 4.32, six elements over a quarter turn, radial load at the free end: deflection
/// over 0.08734; with 48 elements over the curve, the value itself.
#[test]
fn macneal_and_harders_curved_beam() {
    let tip = |n: usize, element: Element| {
        let mesh = grid(n, 1, |s, t| {
            let (turn, radius) = (std::f64::consts::FRAC_PI_2 * (1.0 - s), 4.12 + 0.2 * t);
            vec2(radius * turn.cos(), radius * turn.sin())
        });
        let supports = [held(node(n, 0, 0), true, true), held(node(n, 0, 1), true, true)];
        let body = model(mesh, elastic(1e7, 0.25, Plane::Stress, element), &supports, Kinematics::Small);
        let ends = [node(n, n, 0), node(n, n, 1)];
        let state = solved(&body, forces(&body, &ends.map(|node| (node, 5.0, 0.0))));
        0.5 * (moved(&state, ends[0])[0] + moved(&state, ends[1])[0])
    };
    for (element, value) in [(Element::Q4, 0.0734), (Element::QM6, 0.8875)] {
        let found = tip(6, element) / 0.08734;
        assert!((found - value).abs() < 1e-4, "{element:?}: {found} for {value}");
    }
    let found = tip(48, Element::QM6);
    assert!((found - 0.08854).abs() < 1e-5, "{found}");
}

/// Lamé's thick cylinder under internal pressure, plane strain: hoop stresses at both faces recovered at the nodes within 1 %, radial
/// ones within the body. Along each axis of an element with incompatible modes the stress that acts on that axis is the same, so that
/// at the face itself the radial stress is that of half an element further in.
#[test]
fn lames_cylinder() {
    let (nr, nt) = (48, 64);
    let mesh = grid(nr, nt, |s, t| {
        let (radius, turn) = (1.0 + s, std::f64::consts::FRAC_PI_2 * t);
        vec2(radius * turn.cos(), radius * turn.sin())
    });
    let mut supports = Vec::new();
    for i in 0..=nr {
        supports.push(held(node(nr, i, 0), false, true));
        supports.push(held(node(nr, i, nt), true, false));
    }
    let body = model(mesh, elastic(1000.0, 0.3, Plane::Strain, Element::QM6), &supports, Kinematics::Small);
    let mut pressed = Vec::new();
    for j in 0..nt {
        let (a, b) = (node(nr, 0, j), node(nr, 0, j + 1));
        let along = body.mesh.nodes[b] - body.mesh.nodes[a];
        let push = along.right() * 0.5;
        pressed.extend([(a, push.x, push.y), (b, push.x, push.y)]);
    }
    let state = solved(&body, forces(&body, &pressed));
    let recovered = recover(&body, &state);
    let zone = body.mesh.zones.ids().next().unwrap();
    let middle = nt / 2;
    let polar = |i: usize| {
        let [x, y, _, xy] = recovered[&(zone, node(nr, i, middle))];
        // At 45 degrees the radial stress is the mean plus the shear.
        (0.5 * (x + y) + xy, 0.5 * (x + y) - xy)
    };
    let ((inner_radial, inner_hoop), (_, outer_hoop)) = (polar(0), polar(nr));
    let radial = |radius: f64| (1.0 - 4.0 / (radius * radius)) / 3.0;
    for (found, exact) in [
        (inner_hoop, 5.0 / 3.0),
        (outer_hoop, 2.0 / 3.0),
        (polar(nr / 2).0, radial(1.5)),
        (inner_radial, radial(1.0 + 0.5 / nr as f64)),
    ] {
        assert!((found / exact - 1.0).abs() < 0.01, "{found} for {exact}");
    }
    // The radius moves as Lamé's formula has it: u(1) = (1 + nu) / E * (1 - 2 nu + 4) / 3.
    let exact = 1.3 / 1000.0 * (0.4 + 4.0) / 3.0;
    let found = moved(&state, node(nr, 0, 0))[0];
    assert!((found / exact - 1.0).abs() < 2e-3, "{found} for {exact}");
}

/// A bar under its own weight: displacements are exact at the nodes, stresses at the centres of the elements.
#[test]
fn a_column_under_its_own_weight() {
    let mesh = grid(2, 8, |s, t| vec2(s, 4.0 * t));
    let mut supports: Vec<_> = (0..=2).map(|i| held(node(2, i, 0), true, true)).collect();
    supports.extend((0..=8).flat_map(|j| [held(node(2, 0, j), true, false), held(node(2, 2, j), true, false)]));
    let section = elastic(1e8, 0.2, Plane::Strain, Element::QM6);
    let body = model(mesh, section, &supports, Kinematics::Small);
    let state = solved(&body, body.weight(vec2(0.0, -10.0)));
    // Confined modulus.
    let stiff = 1e8 * 0.8 / (1.2 * 0.6);
    let exact = 2000.0 * 10.0 * 16.0 / (2.0 * stiff);
    let found = -moved(&state, node(2, 1, 8))[1];
    assert!((found / exact - 1.0).abs() < 1e-9, "{found} for {exact}");
    let stress = stress_at(&body, &state, QuadId::new(0), vec2(0.25, 0.25)).unwrap();
    assert!((stress[1] + 2000.0 * 10.0 * 3.75).abs() < 1.0, "{stress:?}");
    assert!(stress_at(&body, &state, QuadId::new(0), vec2(0.75, 0.25)).is_none());
}
