//! Sliding and toppling of one block.

use crate::dem_support::{G, Motion, Scene, dry, settings};
use mechanics::dem::{Damping, Model, contacts};
use mechanics::ids::BlockId;
use mechanics::plane::vec2;

/// A block at rest on a level floor, then gravity turned by `tilt` [rad]: an incline without inclined coordinates.
fn incline(
    tilt: f64,
    friction_angle: f64,
    (width, height): (f64, f64),
    rounding: f64,
    stiffness: f64,
) -> (Motion, BlockId) {
    let mut scene = Scene::new(dry(stiffness, stiffness, friction_angle));
    scene.rounding = rounding;
    scene.floor(-5.0, 5.0);
    let block = scene.brick(vec2(-0.5 * width, 0.0), width, height);
    let mut motion = scene.begin(settings(Damping::Local(0.7)));
    motion.rest(1e-12);
    scene.gravity = vec2(G * tilt.sin(), -G * tilt.cos());
    motion.model = Model::new(&scene.model(), &scene.loading).unwrap();
    motion.work = Default::default();
    (motion, block)
}

/// Undamped sliding at 35 degrees with 34 degrees of friction: g (sin - tan(phi) cos) = 0.206514 m/s^2. Tilting
/// leaves the block bouncing by its static compression (4 micrometres) for ever; a second difference of positions
/// over one second sees that as 4 * 4e-6 / 0.2 = 8e-5 of the acceleration.
#[test]
fn a_block_slides_with_the_exact_acceleration() {
    let (mut motion, block) = incline(35f64.to_radians(), 34.0, (1.0, 0.2), 0.01, 1e9);
    motion.settings.damping = Damping::None;
    let half = (0.5 / motion.state.time_step).round() as u64;
    let x0 = motion.position(block).x;
    motion.steps(half);
    let x1 = motion.position(block).x;
    motion.steps(half);
    let x2 = motion.position(block).x;
    let time = half as f64 * motion.state.time_step;
    let acceleration = (x2 - 2.0 * x1 + x0) / (time * time);
    assert!((acceleration / 0.206514 - 1.0).abs() < 1e-3, "{acceleration}");
}

/// Friction decides at exactly its angle: a twentieth of a degree less and the block rests, a hundredth more and it
/// accelerates by g sin(0.01 deg) / cos(phi), of which local damping takes its share.
#[test]
fn a_block_rests_below_the_friction_angle_and_slides_above() {
    for phi in [20.0_f64, 34.0, 45.0] {
        let places = |offset: f64| {
            let (mut motion, block) = incline((phi + offset).to_radians(), phi, (1.0, 0.1), 0.01, 1e9);
            let x: [f64; 3] = std::array::from_fn(|_| {
                motion.steps(20_000);
                motion.position(block).x
            });
            (x, 20_000.0 * motion.state.time_step)
        };
        // Tilting at once sets the block off; a twentieth of a degree stops it within the first stretch.
        let (x, _) = places(-5e-2);
        assert!((x[2] - x[1]).abs() < 1e-12, "{phi}: creeps by {}", x[2] - x[1]);
        let (x, time) = places(1e-2);
        let acceleration = (x[2] - 2.0 * x[1] + x[0]) / (time * time);
        let expected = 0.3 * G * 1e-2f64.to_radians().sin() / phi.to_radians().cos();
        assert!((acceleration / expected - 1.0).abs() < 1e-3, "{phi}: {acceleration}, not {expected}");
    }
}

/// A block b x h topples at a tilt of atan(b/h) of its contact points' base: rounding by r moves each edge of the
/// base inwards by r, and a joint of stiffness k lets the block lean by its weight's moment over k b^3/12. The tilt
/// at which it falls lies between the one without and the one with the lean, computed here in closed form.
#[test]
fn a_block_topples_when_its_weight_leaves_the_base() {
    let (width, height) = (0.4, 1.0);
    for (rounding, stiffness) in [(0.01, 1e10), (0.002, 1e11)] {
        let base: f64 = width - 2.0 * rounding;
        let critical = (base / height).atan();
        // Just before toppling the whole weight W stands on one point of stiffness k base / 2: it has sunk by
        // 2 W / (k base) and the other point is about to lift, so the block leans by 2 W / (k base^2).
        let weight = 2000.0 * G * width * height * critical.cos();
        let lean = 2.0 * weight / (stiffness * base * base);
        // The lean adds to the tilt and the rolling corner adds its arc; both are far below this margin.
        let margin = 2.0 * lean + 1e-4;
        let angle = |tilt: f64| {
            let (mut motion, block) = incline(tilt, 60.0, (width, height), rounding, stiffness);
            for _ in 0..300 {
                motion.steps(1_000);
                if motion.angle(block).abs() > 0.1 {
                    break;
                }
            }
            motion.angle(block)
        };
        let stands = angle(critical - margin);
        assert!(stands.abs() < 2.0 * lean + 1e-6, "stands at {stands}, lean {lean}");
        let falls = angle(critical + margin);
        assert!(falls < -0.1, "falls to {falls}, lean {lean}");
    }
}

/// A block held by friction for two million steps beside blocks that come and go does not creep: its shear springs
/// outlive every refresh of the contact list.
#[test]
fn friction_holds_while_neighbours_change() {
    let mut scene = Scene::new(dry(1e8, 1e8, 35.0));
    scene.floor(-3.0, 3.0);
    let held = scene.brick(vec2(0.0, 0.0), 0.4, 0.3);
    let runner = scene.brick(vec2(-2.5, 0.0), 0.3, 0.2);
    // 90 % of what friction can carry.
    let push = 0.9 * 35f64.to_radians().tan() * scene.weight(held);
    scene.push(held, vec2(0.2, 0.02), vec2(push, 0.0));
    let mut motion = scene.begin(settings(Damping::Local(0.7)));
    motion.rest(1e-13);
    let start = motion.position(held);
    // The other block is thrown past over and over: each flight searches pairs and features again.
    motion.settings.damping = Damping::None;
    let shear =
        |motion: &Motion| -> f64 { contacts(&motion.state).iter().filter(|c| c.second == held).map(|c| c.shear).sum() };
    let before = shear(&motion);
    for _ in 0..10 {
        motion.state.poses[runner.0 as usize].position = vec2(-1.8, 1.0);
        motion.state.velocities[runner.0 as usize] = [9.0, 2.0, 1.0];
        motion.run(0.4);
    }
    assert!((shear(&motion) / before - 1.0).abs() < 1e-3, "{} {before}", shear(&motion));
    assert!((motion.position(held) - start).norm() < 1e-9, "{:?}", motion.position(held) - start);
}
