//! One or two particles against closed forms.

use crate::particle_support::{Moving, NORMAL, SHEAR, fill, mass, settings, wall, world};
use mechanics::blocks::ContactLaw;
use mechanics::dem::{Damping, energy};
use mechanics::ids::ParticleId;
use mechanics::plane::{Vec2, vec2};

fn two(law: ContactLaw, a: (Vec2, f64), b: (Vec2, f64), factor: f64) -> Moving {
    Moving::new(&world(law, Vec2::ZERO, Vec::new(), &[a, b]), settings(Damping::None, factor))
}

/// Two particles run head-on into one another: the time of contact is half a period of the reduced mass on the contact's
/// spring, they part with exchanged momentum, and no energy is lost. A step of `f` of the critical one resolves the half
/// period by `pi / f` steps; central differences shorten it by `f^2 / 24`.
#[test]
fn a_head_on_collision_keeps_energy_and_takes_half_a_period() {
    let (r1, r2) = (0.06, 0.09);
    let mut m = two(fill(0.5), (vec2(0.0, 0.0), r1), (vec2(0.1505, 0.0), r2), 0.02);
    m.state.set_particle_velocity(&m.model, ParticleId(0), vec2(0.5, 0.0), 0.0);
    m.state.set_particle_velocity(&m.model, ParticleId(1), vec2(-0.2, 0.0), 0.0);
    let (m1, m2) = (mass(r1), mass(r2));
    let reduced = m1 * m2 / (m1 + m2);
    let (mut closed, mut deepest) = (0.0, 0.0_f64);
    for _ in 0..20_000 {
        m.step();
        let p = m.state.particles(&m.model);
        let overlap = r1 + r2 - (p[ParticleId(1)].centre - p[ParticleId(0)].centre).norm();
        if overlap > 0.0 {
            closed += m.state.time_step;
        }
        deepest = deepest.max(overlap);
    }
    let half = std::f64::consts::PI * (reduced / NORMAL).sqrt();
    assert!((closed / half - 1.0).abs() < 0.01, "{closed} {half}");
    let depth = 0.7 * (reduced / NORMAL).sqrt();
    assert!((deepest / depth - 1.0).abs() < 1e-3, "{deepest} {depth}");
    let p = m.state.particles(&m.model);
    let centre = (0.5 * m1 - 0.2 * m2) / (m1 + m2);
    assert!((p[ParticleId(0)].velocity.x - (2.0 * centre - 0.5)).abs() < 1e-3 * 0.7);
    assert!((p[ParticleId(1)].velocity.x - (2.0 * centre + 0.2)).abs() < 1e-3 * 0.7);
}

/// An oblique collision in gross sliding: the shear impulse is friction times the normal one, so that each particle's
/// spin and tangential velocity change by known amounts; momentum, angular momentum and energy balance.
#[test]
fn an_oblique_collision_slides_as_coulomb_says() {
    let (r, friction) = (0.08, 0.2);
    let mut m = two(fill(friction), (Vec2::ZERO, r), (vec2(0.1601, 0.0), r), 0.02);
    // Fast enough sideways to slide from first to last.
    m.state.set_particle_velocity(&m.model, ParticleId(1), vec2(-0.3, 2.0), 0.0);
    let before = energy(&m.model, &m.state);
    m.run(4_000);
    let p = m.state.particles(&m.model);
    // The line of centres turns by the way travelled during contact over the distance: 2 m/s * half a period of 4.3 ms.
    let half = std::f64::consts::PI * (0.5 * mass(r) / NORMAL).sqrt();
    let turn = 2.0 * half / (2.0 * r);
    let impulse = 0.3 * mass(r);
    let tangential = friction * impulse / mass(r);
    let spin = friction * impulse * r / (0.5 * mass(r) * r * r);
    assert!((p[ParticleId(0)].velocity.y - tangential).abs() < 2.0 * turn * 0.3, "{:?}", p[ParticleId(0)]);
    assert!((p[ParticleId(0)].spin - spin).abs() < 0.2 * spin, "{} {spin}", p[ParticleId(0)].spin);
    let momentum = p.iter().map(|d| d.velocity).fold(Vec2::ZERO, |a, b| a + b) - vec2(-0.3, 2.0);
    assert!(momentum.norm() < 1e-12, "{momentum:?}");
    let angular =
        |d: &mechanics::dem::ParticleState| mass(r) * d.centre.cross(d.velocity) + 0.5 * mass(r) * r * r * d.spin;
    let whole: f64 = p.iter().map(angular).sum();
    let start = mass(r) * 0.1601 * 2.0;
    assert!((whole / start - 1.0).abs() < 1e-9, "{whole} {start}");
    let after = energy(&m.model, &m.state);
    assert!((after.kinetic + after.dissipated - before.kinetic).abs() < 2e-4 * before.kinetic, "{after:?}");
}

/// A disc that lands on a floor sliding rolls once friction has turned it: at two thirds of its speed, after
/// `v0 / (3 mu g)` (for a disc of moment of inertia m r^2 / 2).
#[test]
fn a_sliding_disc_comes_to_roll() {
    let (r, friction, v0) = (0.075, 0.3, 1.5);
    let floor = wall(vec2(-5.0, -0.3), 15.0, 0.3);
    // Where its weight and the contact balance.
    let sag = mass(r) * 9.81 / NORMAL;
    let world = world(fill(friction), vec2(0.0, -9.81), vec![floor], &[(vec2(0.0, r - sag), r)]);
    let mut m = Moving::new(&world, settings(Damping::None, 0.2));
    m.state.set_particle_velocity(&m.model, ParticleId(0), vec2(v0, 0.0), 0.0);
    let rolls_at = v0 / (3.0 * friction * 9.81);
    let mut time = 0.0;
    while time < 0.5 * rolls_at {
        m.step();
        time += m.state.time_step;
    }
    let p = m.state.particles(&m.model)[ParticleId(0)];
    assert!((p.velocity.x - (v0 - friction * 9.81 * time)).abs() < 1e-3 * v0, "{p:?} {time}");
    assert!((p.spin + 2.0 * friction * 9.81 * time / r).abs() < 1e-3 * v0 / r, "{p:?}");
    while time < 2.0 * rolls_at {
        m.step();
        time += m.state.time_step;
    }
    let p = m.state.particles(&m.model)[ParticleId(0)];
    // The last of the sliding leaves the shear spring ringing a little.
    assert!((p.velocity.x - 2.0 / 3.0 * v0).abs() < 2e-3 * v0, "{p:?}");
    assert!((p.spin * r + 2.0 / 3.0 * v0).abs() < 5e-3 * v0, "{p:?}");
}

/// A disc pushed along a floor sticks with the shear stiffness until friction and cohesion are used up.
#[test]
fn cohesion_and_friction_bound_the_shear() {
    let r = 0.075;
    let law = ContactLaw { cohesion: 10e3, ..fill(0.5) };
    let floor = wall(vec2(-5.0, -0.3), 10.0, 0.3);
    let sag = mass(r) * 9.81 / NORMAL;
    for (velocity, slides) in [(1e-3, false), (2.0, true)] {
        let world = world(law, vec2(0.0, -9.81), vec![floor.clone()], &[(vec2(0.0, r - sag), r)]);
        let mut m = Moving::new(&world, settings(Damping::None, 0.05));
        m.state.set_particle_velocity(&m.model, ParticleId(0), vec2(velocity, 0.0), 0.0);
        m.run(20);
        let frame = mechanics::dem::frame(&m.model, &m.state);
        let c = frame.particle_contacts[0];
        let cap = 10e3 * 0.15 + 0.5 * c.compression;
        assert_eq!(c.sliding, slides, "{c:?}");
        if slides {
            assert!((c.shear.abs() / cap - 1.0).abs() < 1e-9, "{c:?} {cap}");
        } else {
            // In 20 steps of a twentieth of the critical one the spring pulls back little.
            let way = velocity * 20.0 * m.state.time_step;
            let k = (3.0 * SHEAR / mass(r)).sqrt();
            let stretch = velocity / k * (k * 20.0 * m.state.time_step).sin();
            assert!((c.shear.abs() / (SHEAR * stretch) - 1.0).abs() < 0.02, "{c:?} {way}");
        }
    }
}
