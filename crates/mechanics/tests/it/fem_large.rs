//! Large displacements against closed forms.

use crate::fem_tools::{carried, elastic, forces, grid, held, model, moved, node, tight};
use mechanics::fem::law::Plane;
use mechanics::fem::{Element, Kinematics, Status, Target};
use mechanics::plane::vec2;

/// Tip of the elastica of a cantilever of unit length and stiffness under a transverse load: way down and way back, by shooting for the
/// slope at the tip: `integral from 0 to tip of d theta / sqrt(2 load (sin tip - sin theta)) = 1`.
fn elastica(load: f64) -> (f64, f64) {
    // With sin theta = sin tip (1 - s^2) the integrands are smooth; midpoint sums in s.
    let parts = 20_000;
    let sums = |tip: f64| {
        let top = tip.sin();
        let (mut length, mut down, mut out) = (0.0, 0.0, 0.0);
        for k in 0..parts {
            let s = (k as f64 + 0.5) / parts as f64;
            let sine = top * (1.0 - s * s);
            let cosine = (1.0 - sine * sine).sqrt();
            // d theta = 2 s top / cos ds, and sqrt(2 load top) s below.
            let element = 2.0 * top / cosine / (2.0 * load * top).sqrt() / parts as f64;
            length += element;
            down += element * sine;
            out += element * cosine;
        }
        (length, down, out)
    };
    let (mut low, mut high) = (1e-6, std::f64::consts::FRAC_PI_2 - 1e-9);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if sums(middle).0 < 1.0 { low = middle } else { high = middle }
    }
    let (_, down, out) = sums(0.5 * (low + high));
    (down, 1.0 - out)
}

/// The oracle against the published value: Bisshopp and Drucker (1945) give 0.493 and 0.161 at P L^2 / E I = 2 (Mattiasson 1981:
/// 0.49346, 0.16064).
#[test]
fn the_elastica_is_the_published_one() {
    let (down, back) = elastica(2.0);
    assert!((down - 0.49346).abs() < 2e-5 && (back - 0.16064).abs() < 2e-5, "{down} {back}");
}

/// A slender cantilever under a load that bends it by half its length and more.
#[test]
fn a_cantilever_bends_as_the_elastica() {
    let (n, thick, modulus) = (60, 0.02, 1e9);
    let mesh = grid(n, 2, |s, t| vec2(s, thick * (t - 0.5)));
    let supports = [0, 1, 2].map(|j| held(node(n, 0, j), true, true));
    let section = elastic(modulus, 0.0, Plane::Stress, Element::QM6);
    let beam = model(mesh, section, &supports, Kinematics::Large);
    let bending = modulus * thick * thick * thick / 12.0;
    for load in [1.0, 2.0, 5.0] {
        let tip = node(n, n, 1);
        let target = Target { forces: forces(&beam, &[(tip, 0.0, -load * bending)]), imposed: Vec::new() };
        let (state, _, outcome) = carried(&beam, &target, &tight(10));
        assert_eq!(outcome.status, Status::Completed, "{outcome:?}");
        let [x, y] = moved(&state, tip);
        let (down, back) = elastica(load);
        // Stretch and shear of a beam fifty times longer than deep: about 1e-4 of the length.
        assert!((-y - down).abs() < 1e-3 && (-x - back).abs() < 1e-3, "{load}: {x} {y} for {back} {down}");
    }
}

/// A strut's sway grows as its load nears Euler's: geometric stiffness against the beam column's closed form.
#[test]
fn a_strut_sways_towards_eulers_load() {
    let (n, thick, modulus) = (40, 0.02, 1e9);
    let bending = modulus * thick * thick * thick / 12.0;
    let euler = std::f64::consts::PI.powi(2) * bending / 4.0;
    let sway = |share: f64| {
        let mesh = grid(n, 2, |s, t| vec2(s, thick * (t - 0.5)));
        let supports = [0, 1, 2].map(|j| held(node(n, 0, j), true, true));
        let section = elastic(modulus, 0.0, Plane::Stress, Element::QM6);
        let strut = model(mesh, section, &supports, Kinematics::Large);
        let tip = node(n, n, 1);
        let lateral = 1e-3 * bending;
        let target = Target { forces: forces(&strut, &[(tip, -share * euler, lateral)]), imposed: Vec::new() };
        let (state, _, outcome) = carried(&strut, &target, &tight(4));
        assert_eq!(outcome.status, Status::Completed, "{outcome:?}");
        moved(&state, tip)[1]
    };
    // Timoshenko and Gere: the sway under a lateral load grows by 3 (tan k - k) / k^3 with k = sqrt(P / E I).
    let small = 1e-3 / 3.0;
    for share in [0.25, 0.5, 0.8] {
        let k = (share * euler / bending).sqrt();
        let exact = small * 3.0 * (k.tan() - k) / k.powi(3);
        let found = sway(share);
        assert!((found / exact - 1.0).abs() < 5e-3, "{share}: {found} for {exact}");
    }
}
