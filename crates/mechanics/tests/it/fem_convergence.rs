//! How fast errors fall with the mesh: displacements and stresses against a solution that was made up, with the body forces that it takes.

use crate::fem_stress::stress_at;
use crate::fem_tools::{carried, elastic, grid, held, model, moved, tight};
use mechanics::fem::law::Plane;
use mechanics::fem::{Element, Kinematics, Mesh, Model, State, Status, Target};
use mechanics::ids::{Id, NodeId, QuadId};
use mechanics::plane::{Vec2, vec2};
use std::f64::consts::PI;

const MODULUS: f64 = 1e7;
const RATIO: f64 = 0.3;
const SIZE: f64 = 1e-3;

/// Lamé's constants [Pa].
fn lame() -> (f64, f64) {
    (MODULUS * RATIO / ((1.0 + RATIO) * (1.0 - 2.0 * RATIO)), MODULUS / (2.0 * (1.0 + RATIO)))
}

/// Displacements [m].
fn field(p: Vec2) -> [f64; 2] {
    [SIZE * (PI * p.x).sin() * (PI * p.y).sin(), SIZE * 0.5 * (PI * p.x).cos() * p.y * p.y]
}

/// Stress [Pa]: xx, yy, xy, in plane strain.
fn stress(p: Vec2) -> [f64; 3] {
    let (lambda, mu) = lame();
    let (sx, cx, sy, cy) = ((PI * p.x).sin(), (PI * p.x).cos(), (PI * p.y).sin(), (PI * p.y).cos());
    let (xx, yy) = (SIZE * PI * cx * sy, SIZE * cx * p.y);
    let xy = SIZE * (PI * sx * cy - 0.5 * PI * sx * p.y * p.y);
    [lambda * (xx + yy) + 2.0 * mu * xx, lambda * (xx + yy) + 2.0 * mu * yy, mu * xy]
}

/// Force on the body [N/m^3] that balances that stress.
fn body(p: Vec2) -> [f64; 2] {
    let (lambda, mu) = lame();
    let (sx, cx, sy, cy) = ((PI * p.x).sin(), (PI * p.x).cos(), (PI * p.y).sin(), (PI * p.y).cos());
    let (u_xx, u_xy) = (-PI * PI * sx * sy, PI * PI * cx * cy);
    let (v_xx, v_yy, v_xy) = (-0.5 * PI * PI * cx * p.y * p.y, cx, -PI * sx * p.y);
    let x = (lambda + 2.0 * mu) * u_xx + lambda * v_xy + mu * (u_xx + v_xy);
    let y = mu * (u_xy + v_xx) + lambda * u_xy + (lambda + 2.0 * mu) * v_yy;
    [-SIZE * x, -SIZE * y]
}

/// Three Gauss points along a line, exact to the fifth power.
const GAUSS: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];

/// Weights of the corners, place and area of each of nine points of a quadrilateral.
fn points(corners: [Vec2; 4]) -> Vec<([f64; 4], Vec2, f64)> {
    let mut all = Vec::new();
    for (xi, a) in GAUSS {
        for (eta, b) in GAUSS {
            let n = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            let weights = n.map(|(i, j)| 0.25 * (1.0 + i * xi) * (1.0 + j * eta));
            let sum =
                |part: [f64; 4]| corners.iter().zip(part).fold(Vec2::ZERO, |sum, (corner, part)| sum + *corner * part);
            let (along, up) =
                (sum(n.map(|(i, j)| 0.25 * i * (1.0 + j * eta))), sum(n.map(|(i, j)| 0.25 * j * (1.0 + i * xi))));
            all.push((weights, sum(weights), a * b * along.cross(up)));
        }
    }
    all
}

/// The unit square in `n` by `n` elements; distorted, every second node within is shifted by a sixth of an element to and fro, as much on
/// any mesh, so that elements do not turn into parallelograms as they get smaller.
fn square(n: usize, distorted: bool) -> Mesh {
    let shift = if distorted { 1.0 / 6.0 / n as f64 } else { 0.0 };
    grid(n, n, |s, t| {
        let (i, j) = ((s * n as f64).round() as usize, (t * n as f64).round() as usize);
        let within = i % n != 0 && j % n != 0;
        let sign = |k: usize| if k.is_multiple_of(2) { shift } else { -shift };
        if within { vec2(s + sign(i + j), t + sign(j)) } else { vec2(s, t) }
    })
}

/// Relative errors: displacements in the mean square, stresses in the energy.
fn errors(element: Element, n: usize, distorted: bool) -> [f64; 2] {
    let mesh = square(n, distorted);
    let rim = |p: &Vec2| p.x < 1e-9 || p.x > 1.0 - 1e-9 || p.y < 1e-9 || p.y > 1.0 - 1e-9;
    let supports: Vec<_> = mesh.nodes.pairs().filter(|(_, p)| rim(p)).map(|(id, _)| held(id, true, true)).collect();
    let imposed = supports.iter().flat_map(|s| {
        let [x, y] = field(mesh.nodes[s.node]);
        [(s.node, 0, x), (s.node, 1, y)]
    });
    let imposed: Vec<(NodeId, usize, f64)> = imposed.collect();
    let square = model(mesh, elastic(MODULUS, RATIO, Plane::Strain, element), &supports, Kinematics::Small);
    let mut forces = vec![0.0; 2 * square.mesh.nodes.len()];
    for (id, quad) in square.mesh.quads.pairs() {
        for (weights, place, area) in points(square.corners(id)) {
            let force = body(place);
            for (node, weight) in quad.nodes.iter().zip(weights) {
                forces[2 * node.index()] += weight * area * force[0];
                forces[2 * node.index() + 1] += weight * area * force[1];
            }
        }
    }
    let (state, _, outcome) = carried(&square, &Target { forces, imposed }, &tight(1));
    assert_eq!(outcome.status, Status::Completed, "{outcome:?}");
    compared(&square, &state)
}

fn compared(square: &Model, state: &State) -> [f64; 2] {
    let (lambda, mu) = lame();
    // Energy of a stress in plane strain.
    let energy = |[x, y, xy]: [f64; 3]| {
        let sum = (x + y) / (2.0 * (lambda + mu));
        0.5 * ((x * x + y * y - lambda * sum * (x + y)) / (2.0 * mu) + xy * xy / mu)
    };
    let (mut off, mut whole) = ([0.0; 2], [0.0; 2]);
    for (id, quad) in square.mesh.quads.pairs() {
        for (weights, place, area) in points(square.corners(id)) {
            let exact = field(place);
            for axis in 0..2 {
                let found: f64 = quad.nodes.iter().zip(weights).map(|(node, w)| w * moved(state, *node)[axis]).sum();
                off[0] += area * (found - exact[axis]).powi(2);
                whole[0] += area * exact[axis].powi(2);
            }
            let found = stress_at(square, state, QuadId::new(id.index()), place).expect("the place lies within");
            let exact = stress(place);
            off[1] += area * energy([found[0] - exact[0], found[1] - exact[1], found[3] - exact[2]]);
            whole[1] += area * energy(exact);
        }
    }
    [0, 1].map(|k| f64::sqrt(off[k] / whole[k]))
}

/// Both elements lose three quarters of the error of displacements, and half of that of the energy, each time elements are halved: on
/// meshes of squares, and on distorted ones.
#[test]
#[expect(clippy::print_stdout, reason = "the table of the page is made from it")]
fn errors_fall_at_the_rates_of_theory() {
    for (element, distorted) in [(Element::Q4, false), (Element::QM6, false), (Element::Q4, true), (Element::QM6, true)]
    {
        let sizes = [4, 8, 16, 32, 64];
        let found = sizes.map(|n| errors(element, n, distorted));
        for (n, [displacement, energy]) in sizes.iter().zip(found) {
            println!("{element:?} distorted {distorted} {n:>3} {displacement:.3e} {energy:.3e}");
        }
        for pair in found.windows(2).skip(1) {
            let [displacement, energy] = [0, 1].map(|k| (pair[0][k] / pair[1][k]).log2());
            println!("   rates {displacement:.3} {energy:.3}");
            // The rates are limits for small elements: from eight along a side on they are reached to a tenth.
            assert!((1.9..2.1).contains(&displacement), "{element:?} {distorted}: {displacement}");
            assert!((0.9..1.1).contains(&energy), "{element:?} {distorted}: {energy}");
        }
    }
}
