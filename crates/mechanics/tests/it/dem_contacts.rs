//! Contact detection against brute force, in runs where neighbours change.

use crate::dem_support::{Motion, Scene, dry, settings};
use mechanics::blocks::Held;
use mechanics::dem::{Damping, contacts};
use mechanics::ids::BlockId;
use mechanics::plane::{Core, Pose, Vec2, vec2};
use std::collections::BTreeSet;

/// Distance of two convex polygons, negative by the least push that parts them when they overlap: every corner
/// against every edge, none of the engine's code.
fn distance(a: &[Vec2], b: &[Vec2]) -> f64 {
    let mut overlap = f64::NEG_INFINITY;
    let mut apart = f64::INFINITY;
    for (p, q) in [(a, b), (b, a)] {
        for i in 0..p.len() {
            let (start, end) = (p[i], p[(i + 1) % p.len()]);
            let edge = end - start;
            let normal = edge.right().unit();
            overlap = overlap.max(q.iter().map(|v| (*v - start).dot(normal)).fold(f64::INFINITY, f64::min));
            for v in q {
                let t = ((*v - start).dot(edge) / edge.dot(edge)).clamp(0.0, 1.0);
                apart = apart.min((*v - (start + edge * t)).norm());
            }
        }
    }
    if overlap > 0.0 { apart } else { overlap }
}

/// Steps on and compares the closed pairs with brute force every 100 steps. Pairs are excused whose gap is smaller
/// than the travel within which the engine does not look again: features of listed pairs are kept until a block may
/// have moved a thousandth of the smallest block's reach, and each of the two may.
struct Check {
    cores: Vec<Core>,
    held: Vec<bool>,
    excuse: f64,
    compared: usize,
    excused: usize,
    deepest: f64,
}

impl Check {
    fn new(scene: &Scene) -> Check {
        let cores: Vec<Core> = scene.model().cores().unwrap().iter().cloned().collect();
        let reach = cores.iter().map(|c| c.reach).fold(f64::INFINITY, f64::min);
        let held = scene.blocks.iter().map(|b| b.held.is_fixed()).collect();
        Check { cores, held, excuse: 2e-3 * reach, compared: 0, excused: 0, deepest: 0.0 }
    }
    /// Compares the contacts of `motion`, found at `poses` (those before its last step).
    fn compare(&mut self, motion: &Motion, poses: &[Pose]) {
        let found: BTreeSet<(BlockId, BlockId)> = contacts(&motion.state).iter().map(|c| (c.first, c.second)).collect();
        let placed: Vec<Vec<Vec2>> =
            self.cores.iter().zip(poses).map(|(c, p)| c.vertices.iter().map(|&v| p.place(v)).collect()).collect();
        for i in 0..placed.len() {
            for j in i + 1..placed.len() {
                if self.held[i] && self.held[j] {
                    continue;
                }
                let gap = distance(&placed[i], &placed[j]) - self.cores[i].radius - self.cores[j].radius;
                let closed = found.contains(&(BlockId(i as u32), BlockId(j as u32)));
                self.deepest = self.deepest.min(gap);
                self.compared += usize::from(closed || gap < 0.0);
                if closed != (gap < 0.0) {
                    assert!(gap.abs() < self.excuse, "step {}: {i} {j} {closed} {gap:e}", motion.state.steps);
                    self.excused += 1;
                }
            }
        }
    }
    fn run(&mut self, motion: &mut Motion, hundreds: usize) {
        for _ in 0..hundreds {
            motion.steps(99);
            let poses = motion.state.poses.clone();
            motion.step();
            self.compare(motion, &poses);
        }
    }
    /// Nearly all comparisons need no excuse, and nothing has sunk in farther than its weight or its fall explain.
    fn verdict(&self, sunk: f64) {
        assert!(self.compared > 100, "{}", self.compared);
        assert!(self.excused * 100 <= self.compared, "{} of {} excused", self.excused, self.compared);
        assert!(self.deepest > -sunk, "{}", self.deepest);
    }
}

/// A block pushed across four others: pairs come and go under it.
#[test]
fn a_block_slid_across_four_others_meets_each_in_turn() {
    let mut scene = Scene::new(dry(1e9, 5e8, 20.0));
    for k in 0..4 {
        scene.rectangle(vec2(0.5 * f64::from(k), -0.3), 0.5, 0.3, Held::FIXED);
    }
    let slider = scene.brick(vec2(0.0, 0.0), 0.45, 0.2);
    let weight = scene.weight(slider);
    scene.push(slider, vec2(0.2, 0.02), vec2(0.37 * weight, 0.0));
    let mut check = Check::new(&scene);
    let mut motion = scene.begin(settings(Damping::Local(0.7)));
    let mut met = BTreeSet::new();
    while motion.position(slider).x < 1.7 {
        check.run(&mut motion, 1);
        met.extend(contacts(&motion.state).iter().map(|c| c.first));
        assert!(motion.state.steps < 400_000, "the block does not slide");
    }
    assert_eq!(met.len(), 4);

    // 4 micrometres of static compression on a full joint.
    check.verdict(1e-5);
}

/// A dry wall in half bond whose foot is undercut falls to the floor.
#[test]
fn a_dry_wall_collapses_without_missing_a_contact() {
    let mut scene = Scene::new(dry(2e8, 1e8, 30.0));
    scene.floor(-4.0, 6.0);
    for course in 0..6 {
        let shift = if course % 2 == 0 { 0.0 } else { 0.2 };
        for k in 0..3 {
            // Nothing under the left third of the wall.
            if course > 0 || k > 0 {
                scene.brick(vec2(0.4 * f64::from(k) + shift, 0.2 * f64::from(course)), 0.4, 0.2);
            }
        }
    }
    let mut check = Check::new(&scene);
    let mut s = settings(Damping::Local(0.1));
    s.time_step_factor = 0.3;
    let mut motion = scene.begin(s);
    check.run(&mut motion, 150);

    // A brick of 160 kg that falls 1 m onto a corner of 0.01 m x 2e8 Pa/m sinks in by v sqrt(m/k) = 0.04 m.
    check.verdict(0.04);
}

/// An arch without one abutment falls to the floor.
#[test]
fn an_arch_falls_to_the_ground() {
    let mut scene = Scene::new(dry(2e8, 1e8, 30.0));
    scene.floor(-4.0, 4.0);
    let at = |radius: f64, k: usize| {
        let angle = std::f64::consts::PI * k as f64 / 15.0;
        vec2(-radius * angle.cos(), 1.0 + radius * angle.sin())
    };
    for k in 0..15 {
        scene.polygon(vec![at(1.0, k), at(1.0, k + 1), at(1.3, k + 1), at(1.3, k)], Held::FREE);
    }
    scene.rectangle(vec2(-1.4, 0.5), 0.5, 0.5, Held::FIXED);
    let mut check = Check::new(&scene);
    let mut s = settings(Damping::Local(0.1));
    s.time_step_factor = 0.3;
    let mut motion = scene.begin(s);
    check.run(&mut motion, 200);

    let lowest = (1..=15).map(|k| motion.position(BlockId(k)).y).fold(f64::INFINITY, f64::min);
    assert!(lowest < 0.3 && lowest > 0.05, "{lowest}");
    // A voussoir of 140 kg that falls 1.2 m onto a corner of 0.01 m x 2e8 Pa/m sinks in by v sqrt(m/k) = 0.04 m.
    check.verdict(0.04);
}
