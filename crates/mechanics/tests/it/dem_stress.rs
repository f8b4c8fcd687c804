//! Average stress by the divergence theorem, and the forces it is made of.

use crate::dem_support::{Motion, Scene, dry, settings};
use mechanics::dem::{Damping, contacts, stresses};
use mechanics::plane::{Vec2, vec2};

fn stress(motion: &Motion) -> Vec<[f64; 3]> {
    stresses(&motion.model, &motion.state, &contacts(&motion.state), &[])
}

/// At rest to round-off; what is left is the overlap of up to 0.2 mm, half of which shortens arms of 200 mm.
const NEAR: f64 = 1e-3;

fn near(value: f64, reference: f64, scale: f64) {
    assert!((value - reference).abs() < NEAR * scale, "{value}, not {reference}");
}

/// Pressed from both sides without weight: sigma = F / width across the joint, from contact forces in y and from point
/// forces alone in x, where the resultant is zero.
#[test]
fn a_block_under_uniaxial_loads_has_their_stress() {
    let mut scene = Scene::new(dry(1e9, 5e8, 30.0));
    scene.gravity = vec2(0.0, 0.0);
    scene.floor(-1.0, 1.0);
    let block = scene.brick(vec2(-0.25, 0.0), 0.5, 0.4);
    scene.push(block, vec2(-0.1, 0.4), vec2(0.0, -50e3));
    scene.push(block, vec2(0.1, 0.4), vec2(0.0, -50e3));
    scene.push(block, vec2(-0.25, 0.2), vec2(30e3, 0.0));
    scene.push(block, vec2(0.25, 0.2), vec2(-30e3, 0.0));
    let mut motion = scene.begin(settings(Damping::Local(0.7)));
    motion.rest(1e-13);
    let [xx, yy, xy] = stress(&motion)[block.0 as usize];
    near(yy, -100e3 / 0.5, 200e3);
    near(xx, -30e3 / 0.4, 200e3);
    near(xy, 0.0, 200e3);
}

/// In a column each block carries what stands above it and, on average, half of itself.
#[test]
fn a_column_carries_the_weight_above() {
    let mut scene = Scene::new(dry(1e9, 5e8, 30.0));
    scene.floor(-1.0, 1.0);
    let bricks: Vec<_> = (0..5).map(|k| scene.brick(vec2(-0.3, 0.3 * f64::from(k)), 0.6, 0.3)).collect();
    let mut motion = scene.begin(settings(Damping::Local(0.7)));
    motion.rest(1e-13);
    let found = stress(&motion);
    let weight = scene.weight(bricks[0]);
    for (k, brick) in bricks.iter().enumerate() {
        let carried = weight * (bricks.len() - 1 - k) as f64 + 0.5 * weight;
        near(found[brick.0 as usize][1], -carried / 0.6, weight / 0.6);
    }
}

/// A turned block keeps its stress: loads fixed in direction, arms that turn.
#[test]
fn arms_of_loads_turn_with_the_block() {
    let mut scene = Scene::new(dry(1e9, 5e8, 30.0));
    scene.gravity = vec2(0.0, 0.0);
    let block = scene.brick(vec2(-0.2, -0.2), 0.4, 0.4);
    scene.push(block, vec2(0.0, 0.2), vec2(0.0, 10e3));
    scene.push(block, vec2(0.0, -0.2), vec2(0.0, -10e3));
    let mut motion = scene.begin(settings(Damping::None));
    motion.state.poses[0].rotation = mechanics::plane::Rotation::by(0.5);
    let [xx, yy, xy] = stress(&motion)[block.0 as usize];
    // Arms +-0.2 (-sin, cos), forces +-(0, 10e3), area 0.16.
    let scale = 2.0 * 0.2 * 10e3 / 0.16;
    near(xx, 0.0, scale);
    near(yy, scale * 0.5_f64.cos(), scale);
    near(xy, -0.5 * scale * 0.5_f64.sin(), scale);
}

/// The reported contact forces hold every voussoir of an arch at rest in equilibrium, hinges included: to the
/// tolerance of the run, 1e-5 of all acting forces, which are about as large as the largest contact force.
#[test]
fn reported_contacts_are_in_equilibrium() {
    let (model, loading) = crate::dem_bridgemill::bridgemill(false, 1.0);
    let program = crate::dem_bridgemill::program(None);
    let settings = crate::dem_bridgemill::paper(Damping::Adaptive, mechanics::dem::ContactLength::Fixed);
    let outcome =
        mechanics::dem::collapse(&model, &loading, &program, &settings, None, &mut mechanics::watch::Unwatched)
            .unwrap();
    let frame = &outcome.frames[outcome.last_stable_frame.unwrap()];
    let mut sums: Vec<Vec2> = model.blocks.iter().map(|b| model.gravity * b.mass()).collect();
    for f in loading.variable.iter() {
        sums[f.block.0 as usize] += f.force * frame.factor;
    }
    let mut largest: f64 = 0.0;
    for c in &frame.contacts {
        let force = c.normal * c.compression + c.normal.left() * c.shear;
        sums[c.second.0 as usize] += force;
        sums[c.first.0 as usize] -= force;
        largest = largest.max(c.compression);
    }
    for (i, sum) in sums.iter().enumerate().take(62) {
        assert!(sum.norm() < 2e-5 * largest, "block {i}: {sum:?} beside {largest}");
    }
}
