//! Free motion, impact and oscillation against closed forms.

use crate::dem_support::{G, Scene, dry, settings};
use mechanics::blocks::Held;
use mechanics::dem::{Damping, energy};
use mechanics::plane::vec2;

/// Central differences follow a parabola exactly: with velocities kept half a step early, a block released with `v0`
/// has after n steps of h the height `y0 + v0 t - g t (t + h) / 2`. Only round-off is left, which grows with the steps.
#[test]
fn free_fall_is_the_exact_parabola_of_the_leapfrog() {
    for v0 in [0.0, -5.0, 5.0] {
        let mut scene = Scene::new(dry(1e9, 1e9, 30.0));
        let block = scene.brick(vec2(0.0, 10.0), 0.4, 0.3);
        let mut motion = scene.begin(settings(Damping::None));
        let start = motion.position(block);
        let h = motion.state.time_step;
        motion.state.velocities[0] = [0.3, v0, 2.0];
        motion.steps(200);
        let t = 200.0 * h;
        let expected = start + vec2(0.3 * t, v0 * t - 0.5 * G * t * (t + h));
        assert!((motion.position(block) - expected).norm() < 1e-12, "{:?}", motion.position(block) - expected);
        // One spin step turns the block by 2 atan(w h / 2) with w = 2 rad/s: 3e-6 short of w h in 200 steps of 10 ms.
        let turned = 200.0 * 2.0 * h.atan() - motion.angle(block);
        let turns = turned / std::f64::consts::TAU;
        assert!((turns - turns.round()).abs() < 1e-12, "{turns}");
    }
}

/// The floor carries the weight: local damping leaves no force behind at rest, so only the residual of 1e-9 counts.
#[test]
fn a_floor_carries_the_weight_of_what_stands_on_it() {
    let mut scene = Scene::new(dry(1e9, 5e8, 30.0));
    let floor = scene.floor(-2.0, 2.0);
    let mut weight = 0.0;
    for k in 0..5 {
        let brick = scene.brick(vec2(-0.3 + 0.05 * f64::from(k), 0.3 * f64::from(k)), 0.6, 0.3);
        weight += scene.weight(brick);
    }
    let mut motion = scene.begin(settings(Damping::Local(0.7)));
    motion.rest(1e-12);
    let carried: f64 = mechanics::dem::contacts(&motion.state)
        .iter()
        .filter(|c| c.first == floor)
        .map(|c| c.normal.y * c.compression + c.normal.left().y * c.shear)
        .sum();
    assert!((carried / weight - 1.0).abs() < 1e-6, "{carried} {weight}");
}

/// Two blocks meet face to face without gravity. The contact is an undamped spring, so momentum and energy fix the
/// velocities afterwards. The step of contact and of release cut the spring's half-wave at up to half a step each:
/// with 200 steps a half-wave, the velocities keep 1e-3 of the closing speed.
#[test]
fn a_head_on_impact_keeps_momentum_and_energy() {
    for (width, v_expected) in [(0.5, (0.0, 1.0)), (1.5, (-0.5, 0.5))] {
        let mut scene = Scene::new(dry(1e8, 1e8, 0.0));
        scene.gravity = vec2(0.0, 0.0);
        let a = scene.brick(vec2(0.0, 0.0), 0.5, 0.4);
        let b = scene.brick(vec2(0.51, 0.0), width, 0.4);
        let mut s = settings(Damping::None);
        s.time_step_factor = 0.01;
        let mut motion = scene.begin(s);
        motion.state.velocities[0] = [1.0, 0.0, 0.0];
        let before = 0.5 * scene.blocks[a].mass();
        motion.run(0.05);
        let (va, vb) = (motion.velocity(a), motion.velocity(b));
        let momentum = scene.blocks[a].mass() * va[0] + scene.blocks[b].mass() * vb[0];
        assert!((momentum / scene.blocks[a].mass() - 1.0).abs() < 1e-12, "{momentum}");
        assert!((va[0] - v_expected.0).abs() < 1e-3 && (vb[0] - v_expected.1).abs() < 1e-3, "{va:?} {vb:?}");
        assert!(va[2].abs() < 1e-9 && va[1].abs() < 1e-9, "{va:?}");
        let kinetic = energy(&motion.model, &motion.state).kinetic;
        assert!((kinetic / before - 1.0).abs() < 1e-3, "{kinetic} {before}");
    }
}

/// A block that can only move vertically rests on two springs; local damping of 0.8 stretches and shrinks them in
/// turn: half cycles of pi/2 (1/sqrt(0.2) + 1/sqrt(1.8)) = 4.68321 sqrt(m/k), amplitudes a third of the last one.
/// Quarter cycles end at whole steps; a step of 1e-3 of the critical one keeps that below 1e-3.
#[test]
fn local_damping_thirds_the_amplitude_every_half_cycle() {
    let mut scene = Scene::new(dry(1e6, 1e6, 30.0));
    scene.floor(-1.0, 1.0);
    let block = scene.rectangle(vec2(-0.25, 0.0), 0.5, 0.4, Held { x: true, y: false, rotation: true });
    let mut s = settings(Damping::Local(0.8));
    s.time_step_factor = 2e-4;
    let mut motion = scene.begin(s);
    // Contact points 0.48 m apart stand for 0.24 m each.
    let (mass, stiffness) = (scene.blocks[block].mass(), 1e6 * 0.48);
    let unit = (mass / stiffness).sqrt();
    let rest = motion.position(block).y - mass * G / stiffness;
    // Released above the position of rest by the static compression: the contact stays closed.
    let mut turns = Vec::new();
    let mut last = (0.0, motion.position(block).y);
    for _ in 0..200_000 {
        let before = motion.velocity(block)[1];
        motion.step();
        let now = (motion.state.steps as f64 * motion.state.time_step, motion.position(block).y);
        if before != 0.0 && before.signum() != motion.velocity(block)[1].signum() {
            turns.push((last.0, last.1 - rest));
            if turns.len() == 3 {
                break;
            }
        }
        last = now;
    }
    let first = mass * G / stiffness;
    for (k, turn) in turns.iter().enumerate() {
        let expected = first / (-3.0_f64).powi(k as i32 + 1);
        assert!((turn.1 / expected - 1.0).abs() < 1e-3, "{k}: {turn:?} {expected}");
        assert!((turn.0 / (unit * 4.68321 * (k + 1) as f64) - 1.0).abs() < 1e-3, "{k}: {turn:?} {unit}");
    }
    assert_eq!(turns.len(), 3);
}

/// A stack of bricks comes to rest just below the critical time step, whatever the share of local damping. Damping
/// that opposes the old velocity alone stiffens contacts (1 + share) times and keeps this stack jumping for ever
/// above 1/sqrt(1.8) = 0.745 of the critical step.
#[test]
fn local_damping_is_stable_up_to_the_critical_step() {
    for (damping, factor) in [(0.7, 0.9), (0.8, 0.9), (0.8, 0.8), (0.3, 0.9)] {
        let mut scene = Scene::new(dry(1e9, 1e8, 30.0));
        scene.floor(-2.0, 2.0);
        for k in 0..5 {
            scene.brick(vec2(-0.3 + 0.05 * f64::from(k), 0.3 * f64::from(k)), 0.6, 0.3);
        }
        let mut s = settings(Damping::Local(damping));
        s.time_step_factor = factor;
        let mut motion = scene.begin(s);
        motion.steps(5_000);
        // Static compressions are some ten micrometres; a millionth of that is rest.
        assert!(motion.step().moved < 1e-11, "{damping} {factor}");
    }
}
