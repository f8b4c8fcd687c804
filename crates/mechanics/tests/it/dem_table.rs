//! A block shaken on a table, and a block that rocks.

use crate::dem_support::{G, Motion, Scene, dry, settings};
use mechanics::blocks::PointForce;
use mechanics::dem::{Damping, Settings};
use mechanics::ids::BlockId;
use mechanics::plane::{Rotation, vec2};

/// Zero of `f` between `low`, where it is positive, and `high`.
fn zero(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if f(middle) > 0.0 { low = middle } else { high = middle }
    }
    low
}

/// Where a rigid block of 1 kg under 8 cos(t) N and friction of 0.8 comes to rest after each of three slides: it moves
/// as soon as the force exceeds 7.848 N, and until it has lost its speed again, long before the next half period.
fn slides() -> [f64; 3] {
    let friction = 0.8 * G;
    let mut x = 3.0;
    let mut at = [0.0; 3];
    for (k, place) in at.iter_mut().enumerate() {
        // Time from the peak of the force.
        let start = if k == 0 { 0.0 } else { -(friction / 8.0).acos() };
        let speed = |t: f64| 8.0 * (t.sin() - start.sin()) - friction * (t - start);
        let end = zero((friction / 8.0).acos(), 1.0, speed);
        let t = end - start;
        let slide = 8.0 * (start.cos() - end.cos()) - 8.0 * start.sin() * t - 0.5 * friction * t * t;
        x += if k % 2 == 0 { slide } else { -slide };
        *place = x;
    }
    at
}

/// The places after each slide, and those that SOLFEC gives for 2, 5 and 8 s. Apart from the rigid block there is only
/// the give of the joint, 8 N / 3.8e6 N/m or 2 micrometres, and the speed that it gives the block when friction yields:
/// released from a hold at 98 % of the peak, 0.16 N / sqrt(1 kg 3.8e6 N/m) or 0.08 mm/s, which carries it 0.03 mm
/// farther in the third of a second that a slide lasts. (Set off from an unstrained joint it would be 4 mm/s.)
#[test]
fn a_block_shaken_on_a_table_slides_as_a_rigid_one() {
    let mut scene = Scene::new(dry(1e7, 1e7, 0.8_f64.atan().to_degrees()));
    scene.density = 25.0;
    scene.floor(0.0, 6.0);
    let block = scene.brick(vec2(2.8, 0.0), 0.4, 0.1);
    // At the joint, so that the block does not rock.
    scene.loading.variable.push(PointForce { block, at: vec2(3.0, 0.0), force: vec2(8.0, 0.0) });
    let mut motion = scene.begin(settings(Damping::None));
    motion.state.factor = 0.98;
    motion.rest(1e-14);
    let (start, h) = (motion.state.steps, motion.state.time_step);
    let solfec = [3.00435080898, 2.99129121231, 3.00441870359];
    for ((until, rigid), read) in [2.0, 5.0, 8.0].into_iter().zip(slides()).zip(solfec) {
        let mut t = 0.0;
        while t <= until {
            t = (motion.state.steps - start) as f64 * h;
            motion.state.factor = t.cos();
            motion.step();
        }
        let x = motion.position(block).x;
        assert!((x - rigid).abs() < 1e-4 && (x - read).abs() < 1e-4, "at {until} s: {x}, rigid {rigid}, read {read}");
    }
}

/// A block whose corners lie `width` and `height` apart, turned by `angle` about its right corner. The rounding of
/// 1 mm lies outside the corners.
fn tilted(width: f64, height: f64, angle: f64) -> Motion {
    let mut scene = Scene::new(dry(1e10, 1e10, 45.0));
    scene.rounding = 1e-3;
    scene.floor(-3.0, 3.0);
    scene.brick(vec2(-width - 1e-3, 0.0), width + 2e-3, height + 2e-3);
    let mut motion = scene.begin(Settings { time_step_factor: 0.5, ..settings(Damping::None) });
    let turn = Rotation::by(-angle);
    let pose = &mut motion.state.poses[1];
    pose.rotation = turn;
    pose.position = vec2(0.0, 1e-3) + turn.turn(vec2(-0.5 * width, 0.5 * height));
    motion
}

/// Steps until the block passes the upright (true) or lies twice as far over (false); the time that it took.
fn swing(motion: &mut Motion) -> (bool, f64) {
    let (start, first) = (motion.state.steps, motion.angle(BLOCK));
    while (motion.state.steps as f64) * motion.state.time_step < 10.0 {
        motion.step();
        let angle = motion.angle(BLOCK);
        if angle >= 0.0 || angle < 2.0 * first {
            return (angle >= 0.0, (motion.state.steps - start) as f64 * motion.state.time_step);
        }
    }
    panic!("it neither fell back nor over");
}

/// Slender block of `width` x `height` on its corner: alpha, and the frequency p = sqrt(3 g / 4 R) of Housner (1963).
fn slender(width: f64, height: f64) -> (f64, f64) {
    ((width / height).atan(), (0.75 * G / (0.5 * width.hypot(height))).sqrt())
}

const BLOCK: BlockId = BlockId(1);
const SIZES: [(f64, f64); 2] = [(0.25, 1.0), (0.5, 2.0)];

/// Released 0.2 % before its centre stands over its corner a block falls back, 0.2 % beyond it falls over: the rounding
/// of 1 mm moves the point below the corner, not the centre over it, and the joint gives by 4 micrometres in 125 mm.
#[test]
fn a_block_falls_over_beyond_the_angle_of_its_diagonal() {
    for (width, height) in SIZES {
        let (alpha, _) = slender(width, height);
        for (share, back) in [(0.998, true), (1.002, false)] {
            assert_eq!(swing(&mut tilted(width, height, share * alpha)).0, back, "{width} {height} {share}");
        }
    }
}

/// Let go at half of alpha, a block comes upright after a quarter of the period 4/p arcosh(1 / (1 - 1/2)), which is
/// Housner's for sin(x) = x (true to a hundredth at 14 degrees; 3 % is asked), and arrives with the angular velocity
/// that energy gives it without that approximation: 1 %, of which rounding makes half by the moment of inertia of a
/// block 2 mm wider and higher.
#[test]
fn a_rocking_block_keeps_housners_period() {
    for ((width, height), period) in SIZES.into_iter().zip([1.39423, 1.97174]) {
        let (alpha, p) = slender(width, height);
        let mut motion = tilted(width, height, 0.5 * alpha);
        let (back, quarter) = swing(&mut motion);
        assert!((period / (4.0 / p * 2.0_f64.acosh()) - 1.0).abs() < 1e-5);
        assert!(back && (4.0 * quarter / period - 1.0).abs() < 0.03, "{quarter} {period}");
        let omega = p * (2.0 * ((0.5 * alpha).cos() - alpha.cos())).sqrt();
        assert!((motion.velocity(BLOCK)[2] / omega - 1.0).abs() < 0.01, "{:?} {omega}", motion.velocity(BLOCK));
    }
}
