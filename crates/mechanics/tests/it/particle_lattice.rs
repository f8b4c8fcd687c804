//! Regular packings: exact stiffness and exact critical time step.

use crate::particle_support::{Moving, NORMAL, fill, mass, settings, stone, wall, world};
use mechanics::blocks::{ContactLaw, Stiffness};
use mechanics::blocks::{Held, Loading, PointForce};
use mechanics::dem::{Damping, critical_time_step, exact_critical_time_step, frame};
use mechanics::ids::{BlockId, Id, ParticleId};
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

/// Stress [Pa m] of the middle particle's cell when the lattice, pressed together a little, is strained by `strain` (xx, yy,
/// xy) in one step.
fn stress_after(shear_share: f64, strain: [f64; 3]) -> [f64; 3] {
    let (n, r) = (11, 0.07);
    // Centres stand closer than two radii by a hundred times the strain, so that no contact opens.
    let mut m = lattice(n, r * (1.0 + 1e-5), shear_share);
    let centres: Vec<Vec2> = m.state.particles(&m.model).iter().map(|p| p.centre * (1.0 / (1.0 + 1e-5))).collect();
    let law = ContactLaw { shear: Stiffness::Given((0.532e9 * shear_share).max(1e-3)), ..fill(0.5) };
    let discs: Vec<(Vec2, f64)> = centres.iter().map(|&c| (c, r * (1.0 + 1e-5))).collect();
    m = Moving::new(&world(law, Vec2::ZERO, Vec::new(), &discs), settings(Damping::None, 1e-3));
    let rate = 1.0 / m.state.time_step;
    for (k, c) in centres.iter().enumerate() {
        let by = vec2(strain[0] * c.x + strain[2] * c.y, strain[2] * c.x + strain[1] * c.y) * rate;
        m.state.set_particle_velocity(&m.model, ParticleId::new(k), by, 0.0);
    }
    m.step();
    let middle = frame(&m.model, &m.state).particles[ParticleId::new(n / 2 * n + n / 2)].stress;
    // The frame counts the disc's own area; the cell is larger.
    middle.map(|s| s * std::f64::consts::PI / (2.0 * 3f64.sqrt()))
}

/// Young's modulus and Poisson's ratio of the lattice, in the plane, are `2 sqrt(3) kn (1 + k) / (3 + k)` and
/// `(1 - k) / (3 + k)` for `k = ks / kn`: every cell is its own mirror image, so that imposed strain is the strain of every
/// cell. Pressing together by 1e-5 changes lengths and directions by as much, and stresses by a small multiple.
#[test]
fn the_moduli_of_the_triangular_lattice() {
    for k in [0.0, 0.2, 0.4, 0.5, 1.0] {
        let e = 1e-7;
        let still = stress_after(k, [0.0; 3]);
        let per_strain = |strain: [f64; 3]| {
            let s = stress_after(k, strain);
            [0, 1, 2].map(|c| (s[c] - still[c]) / e / NORMAL)
        };
        let (xx, yy, xy) = (per_strain([e, 0.0, 0.0]), per_strain([0.0, e, 0.0]), per_strain([0.0, 0.0, e]));
        let modulus = 2.0 * 3f64.sqrt() * (1.0 + k) / (3.0 + k);
        let ratio = (1.0 - k) / (3.0 + k);
        let direct = modulus / (1.0 - ratio * ratio);
        let near = |found: f64, exact: f64| assert!((found - exact).abs() < 1e-4 * direct, "{k}: {found} {exact}");
        near(xx[0], direct);
        near(yy[1], direct);
        near(xx[1], direct * ratio);
        near(yy[0], direct * ratio);
        near(xx[2], 0.0);
        // Shear stress over the tensor's shear strain is twice the shear modulus.
        near(xy[2], modulus / (1.0 + ratio));
    }
}

/// Two columns of five discs between a floor and a plate: six contacts in a row, two rows beside one another.
#[test]
fn a_column_of_discs_is_as_stiff_as_its_contacts_in_series() {
    let r = 0.07;
    let discs: Vec<(Vec2, f64)> =
        (0..10).map(|k| (vec2(0.2 + 0.4 * (k % 2) as f64, r * (1.0 + 2.0 * (k / 2) as f64)), r)).collect();
    let mut plate = stone(&[(0.0, 10.0 * r), (0.8, 10.0 * r), (0.8, 1.0), (0.0, 1.0)], 0.0, Held::FREE);
    plate.held = Held { x: true, y: false, rotation: true };
    let world = world(fill(0.5), Vec2::ZERO, vec![wall(vec2(-1.0, -0.3), 3.0, 0.3), plate], &discs);
    let push = PointForce { block: BlockId(1), at: vec2(0.4, 1.0), force: vec2(0.0, -1e3) };
    let loading = Loading { permanent: vec![push], ..Loading::default() };
    let mut m = Moving::loaded(&world, &loading, settings(Damping::Local(0.7), 0.8));
    let built = m.state.poses[1].position.y;
    m.run(20_000);
    let moved = built - m.state.poses[1].position.y;
    // Coordinates of a metre are rounded to 1e-16, the shortening is 4e-5 m.
    assert!((moved / (1e3 * 6.0 / 2.0 / NORMAL) - 1.0).abs() < 1e-9, "{moved:e}");
}
