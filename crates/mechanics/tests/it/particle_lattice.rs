//! Regular packings: exact stiffness and exact critical time step.

use crate::particle_support::{Moving, NORMAL, fill, mass, settings, world};
use mechanics::blocks::{ContactLaw, Stiffness};
use mechanics::dem::{Damping, critical_time_step, exact_critical_time_step};
use mechanics::plane::{Vec2, vec2};

/// A patch of the triangular lattice with `n` particles along each side.
fn lattice(n: usize, r: f64, shear_share: f64) -> Moving {
    let law = ContactLaw { shear: Stiffness::Given((0.532e9 * shear_share).max(1e-3)), ..fill(0.5) };
    let discs: Vec<(Vec2, f64)> = (0..n)
        .flat_map(|row| {
            (0..n).map(move |k| {
                let x = 2.0 * r * (k as f64 + 0.5 * (row % 2) as f64);
                (vec2(x, 3f64.sqrt() * r * row as f64), r)
            })
        })
        .collect();
    Moving::new(&world(law, Vec2::ZERO, Vec::new(), &discs), settings(Damping::None, 0.9))
}

/// Critical steps of the endless lattice over sqrt(m / k), rotations included, by its dispersion relation: for shear
/// stiffness over normal stiffness 0, 0.2, 0.4, 0.5, 1. A patch has free edges, so its largest frequency lies a little
/// below; the bound that the steps use must never lie above.
#[test]
fn the_critical_step_of_the_lattice() {
    let exact = [(0.0, 0.816_497), (0.2, 0.790_569), (0.4, 0.645_497), (0.5, 0.577_350), (1.0, 0.408_248)];
    for (share, reference) in exact {
        let m = lattice(24, 0.07, share);
        let unit = (mass(0.07) / NORMAL).sqrt();
        let patch = exact_critical_time_step(&m.model, &m.state) / unit;
        // One percent of safety on the power iteration, and the edges.
        assert!((patch / reference - 1.0).abs() < 0.02, "{share}: {patch} {reference}");
        let bound = critical_time_step(&m.model, &m.state, &m.settings) / unit;
        assert!(bound <= reference * (1.0 + 1e-6) && bound >= 0.93 * reference, "{share}: {bound} {reference}");
    }
}
