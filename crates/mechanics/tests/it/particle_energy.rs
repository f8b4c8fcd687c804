//! Momentum, and the energy account of particles.

use crate::particle_support::{Chance, Moving, NORMAL, fill, loose, mass, regular, settings, stone, wall, world};
use mechanics::blocks::{Block, Held, Loading, PointForce};
use mechanics::dem::{Damping, Energy, energy};
use mechanics::ids::{BlockId, ParticleId};
use mechanics::plane::{Vec2, vec2};

/// A cloud of particles that runs into itself.
fn cloud(factor: f64) -> (Moving, Vec<f64>) {
    let discs = loose(12, 12, 21);
    let mut m = Moving::new(&world(fill(0.5), Vec2::ZERO, Vec::new(), &discs), settings(Damping::None, factor));
    let mut chance = Chance(5);
    for (k, (centre, _)) in discs.iter().enumerate() {
        let inwards = (vec2(1.1, 1.1) - *centre) * 2.0;
        let v = inwards + vec2(chance.between(-0.5, 0.5), chance.between(-0.5, 0.5));
        m.state.set_particle_velocity(&m.model, ParticleId(k as u32), v, chance.between(-5.0, 5.0));
    }
    (m, discs.iter().map(|d| d.1).collect())
}

/// Momentum [kg/s], twice, and angular momentum about the origin [kg m/s].
fn momenta(m: &Moving, radii: &[f64]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (p, r) in m.state.particles(&m.model).iter().zip(radii) {
        // The centre of mass of angular momentum is that of the half step at which velocities are known.
        let at = p.centre - p.velocity * (0.5 * m.state.time_step);
        let mass = mass(*r);
        sum[0] += mass * p.velocity.x;
        sum[1] += mass * p.velocity.y;
        sum[2] += mass * (at.cross(p.velocity) + 0.5 * r * r * p.spin);
    }
    sum
}

/// What a pair exerts on one particle it takes from the other, and both arms end in the same point: momentum and angular
/// momentum change by rounding only, some 1e-16 of the sum of all sizes for each of 4,000 steps.
#[test]
fn a_cloud_keeps_its_momentum_and_angular_momentum() {
    let (mut m, radii) = cloud(0.5);
    let before = momenta(&m, &radii);
    let sizes: f64 = m.state.particles(&m.model).iter().zip(&radii).map(|(p, r)| mass(*r) * p.velocity.norm()).sum();
    m.run(4_000);
    let after = momenta(&m, &radii);
    let account = energy(&m.model, &m.state);
    assert!(account.dissipated > 0.05 * account.kinetic, "{account:?}");
    for c in 0..3 {
        assert!((after[c] - before[c]).abs() < 1e-12 * sizes, "{c}: {:e} of {sizes}", after[c] - before[c]);
    }
}

fn box_of(width: f64, height: f64) -> Vec<Block> {
    vec![
        wall(vec2(-1.0, -0.5), width + 2.0, 0.5),
        wall(vec2(-0.5, 0.0), 0.5, height),
        wall(vec2(width, 0.0), 0.5, height),
    ]
}

/// What the account leaves unexplained of the work done since `before`, and the most that it may [1].
///
/// A contact that closes within a step pushes for all of it: over the way `m` of that step it takes `k d m` for an overlap
/// `d` of which the spring holds `k d (d + m) / 2`. The difference, `k m^2 / 12` on average, is a share `c / 6` of the
/// pair's energy of approach, `c` being `k dt^2` over its reduced mass. Opening gives it back; damping makes that slower,
/// so that some is left. It cannot be more than that share of all the work.
fn unexplained(m: &Moving, (mut e, before): (Energy, f64), work: f64) -> (f64, f64) {
    e.initial += before;
    let reduced = 0.5 * mass(0.075);
    (e.drift() / work, NORMAL * m.state.time_step.powi(2) / reduced / 6.0)
}

/// Falls into a box.
fn fall(damping: Damping, factor: f64) -> (f64, f64) {
    let fall = world(fill(0.5), vec2(0.0, -9.81), box_of(2.22, 5.0), &loose(12, 10, 2));
    let mut m = Moving::new(&fall, settings(damping, factor));
    m.run((3_000.0 / factor) as usize);
    let e = energy(&m.model, &m.state);
    unexplained(&m, (e, 0.0), e.gravity)
}

/// A column that spreads.
fn column(damping: Damping, factor: f64) -> (f64, f64) {
    let floor = vec![wall(vec2(-9.0, -0.5), 20.0, 0.5)];
    let column = world(fill(0.5), vec2(0.0, -9.81), floor, &loose(8, 16, 2));
    let mut m = Moving::new(&column, settings(damping, factor));
    m.run((3_000.0 / factor) as usize);
    let e = energy(&m.model, &m.state);
    unexplained(&m, (e, 0.0), e.gravity)
}

/// A heavy stone thrown through a bed.
fn thrown(damping: Damping, factor: f64) -> (f64, f64) {
    let mut blocks = box_of(2.96, 5.0);
    blocks.push(stone(&regular(vec2(0.6, 1.8), 0.4, 6, 0.2), 0.03, Held::FREE));
    let plough = world(fill(0.5), vec2(0.0, -9.81), blocks, &loose(16, 6, 2));
    let mut m = Moving::new(&plough, settings(damping, factor));
    m.state.velocities[3] = [3.0, -2.0, 1.0];
    let start = energy(&m.model, &m.state).kinetic;
    m.run((3_000.0 / factor) as usize);
    let e = energy(&m.model, &m.state);
    unexplained(&m, (e, start), e.gravity + start)
}

/// A bed settles under a plate, which is then pushed along it.
fn sheared(damping: Damping, factor: f64) -> (f64, f64) {
    let mut blocks = box_of(2.96, 5.0);
    blocks.push(stone(&[(0.05, 1.12), (1.4, 1.12), (1.4, 1.4), (0.05, 1.4)], 0.03, Held::FREE));
    let world = world(fill(0.5), vec2(0.0, -9.81), blocks, &loose(16, 6, 2));
    let push = PointForce { block: BlockId(3), at: vec2(0.7, 1.2), force: vec2(4e3, -4e3) };
    let loading = Loading { variable: vec![push], ..Loading::default() };
    let mut m = Moving::loaded(&world, &loading, settings(damping, factor));
    m.run((4_000.0 / factor) as usize);
    let before = energy(&m.model, &m.state);
    // The account counts a load's work from the start: what it would have done by now is taken off again.
    m.state.factor = 1.0;
    let unlike = energy(&m.model, &m.state).loads;
    m.run((6_000.0 / factor) as usize);
    let e = energy(&m.model, &m.state);
    let work = e.gravity - before.gravity + e.loads - unlike;
    unexplained(&m, (e, -before.drift() - unlike), work)
}

/// Impacts at metres a second, with and without damping, at the step of the examples and at smaller ones. Pushed slowly
/// from rest, as structures are loaded, a packing accounts for all but a thousandth.
#[test]
fn the_account_of_particles_closes() {
    for factor in [0.8, 0.4, 0.1] {
        for damping in [Damping::None, Damping::Local(0.7)] {
            for (what, run) in [("fall", fall as fn(_, _) -> _), ("column", column), ("thrown", thrown)] {
                let (drift, most): (f64, f64) = run(damping, factor);
                assert!(drift.abs() < most, "{what}, {damping:?}, {factor}: {drift:e} {most:e}");
            }
        }
        let (drift, _) = sheared(Damping::Local(0.7), factor);
        assert!(drift.abs() < 1e-3, "{factor}: {drift:e}");
    }
}

/// The cloud runs into itself at metres a second and flies apart until nothing is near anything; the step stays one in
/// which its next contact is resolved.
#[test]
fn a_cloud_keeps_its_energy() {
    for factor in [0.8, 0.4, 0.1] {
        let (mut m, _) = cloud(factor);
        let start = energy(&m.model, &m.state).kinetic;
        m.run((4_000.0 / factor) as usize);
        let (drift, most) = unexplained(&m, (energy(&m.model, &m.state), start), start);
        assert!(drift.abs() < most, "{factor}: {drift:e} {most:e}");
    }
}
