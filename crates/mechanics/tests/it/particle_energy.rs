//! Momentum, and the energy account of particles.

use crate::particle_support::{Chance, Moving, fill, loose, mass, regular, settings, stone, wall, world};
use mechanics::blocks::{Block, Held};
use mechanics::dem::{Damping, Energy, energy};
use mechanics::ids::ParticleId;
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
        println!("momentum {c}: {:e} of {sizes}", after[c] - before[c]);
        assert!((after[c] - before[c]).abs() < 1e-12 * sizes, "{c}: {:e} of {sizes}", after[c] - before[c]);
    }
}

fn box_of(width: f64, height: f64) -> Vec<Block> {
    vec![wall(vec2(-1.0, -0.5), width + 2.0, 0.5), wall(vec2(-0.5, 0.0), 0.5, height), wall(vec2(width, 0.0), 0.5, height)]
}

fn report(what: &str, e: &Energy, work: f64) -> f64 {
    println!(
        "{what}: drift {:.2e} of {work:.3e} = {:.2e}; friction {:.2e} damped {:.2e} kinetic {:.2e} elastic {:.2e}",
        e.drift(),
        e.drift() / work,
        e.dissipated,
        e.damped,
        e.kinetic,
        e.elastic
    );
    e.drift() / work
}

#[test]
fn the_account_of_particles_closes() {
    for friction in [0.0, 0.5] {
        for factor in [0.8, 0.4, 0.1] {
            let (mut m, _) = cloud(factor);
            if friction == 0.0 {
                continue;
            }
            let start = energy(&m.model, &m.state).kinetic;
            m.run((4_000.0 * 0.5 / factor) as usize);
            let e = energy(&m.model, &m.state);
            println!("start {start}");
            println!("{factor} cloud: {}", (e.kinetic + e.elastic + e.dissipated - start) / start);
            for damping in [Damping::None, Damping::Local(0.7)] {
                // Falls into a box.
                let fall = world(fill(friction), vec2(0.0, -9.81), box_of(2.22, 5.0), &loose(12, 10, 2));
                let mut m = Moving::new(&fall, settings(damping, factor));
                m.run((3_000.0 / factor) as usize);
                let e = energy(&m.model, &m.state);
                report(&format!("{factor} {damping:?} fall"), &e, e.gravity);
                // A column that spreads.
                let column = world(fill(friction), vec2(0.0, -9.81), vec![wall(vec2(-9.0, -0.5), 20.0, 0.5)], &loose(8, 16, 2));
                let mut m = Moving::new(&column, settings(damping, factor));
                m.run((3_000.0 / factor) as usize);
                let e = energy(&m.model, &m.state);
                report(&format!("{factor} {damping:?} column"), &e, e.gravity);
                // A heavy stone thrown through a bed.
                let mut blocks = box_of(2.96, 5.0);
                blocks.push(stone(&regular(vec2(0.6, 1.8), 0.4, 6, 0.2), 0.03, Held::FREE));
                let plough = world(fill(friction), vec2(0.0, -9.81), blocks, &loose(16, 6, 2));
                let mut m = Moving::new(&plough, settings(damping, factor));
                m.state.velocities[3] = [3.0, -2.0, 1.0];
                let start = energy(&m.model, &m.state).kinetic;
                m.run((3_000.0 / factor) as usize);
                let mut e = energy(&m.model, &m.state);
                e.initial += start;
                report(&format!("{factor} {damping:?} stone"), &e, e.gravity + start);
            }
        }
    }
}
