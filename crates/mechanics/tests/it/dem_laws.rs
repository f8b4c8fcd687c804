//! The laws of one contact against closed forms, through loading and unloading.

use crate::dem_support::{Motion, Scene, dry, settings};
use mechanics::blocks::{ContactLaw, Held, Movement};
use mechanics::dem::{ContactLength, ContactState, Damping, Program, Status, collapse, contacts};
use mechanics::ids::BlockId;
use mechanics::plane::{Rotation, vec2};
use mechanics::watch::Unwatched;

/// Two held blocks face to face, 0.5 m wide with contact points 0.48 m apart: the upper one is moved by hand, so that
/// the contact's law is all that answers.
struct Press {
    motion: Motion,
    block: BlockId,
}

impl Press {
    fn new(law: ContactLaw) -> Press {
        let mut scene = Scene::new(law);
        scene.gravity = vec2(0.0, 0.0);
        scene.rectangle(vec2(-0.25, -0.5), 0.5, 0.5, Held::FIXED);
        let block = scene.rectangle(vec2(-0.25, 0.0), 0.5, 0.5, Held { rotation: false, ..Held::FIXED });
        let mut motion = scene.begin(settings(Damping::None));
        motion.step();
        Press { motion, block }
    }
    /// Moves the upper block by (x, y) [m] in `count` steps and returns the sums over both contact points.
    fn go(&mut self, x: f64, y: f64, count: u64) -> (f64, f64, Vec<ContactState>) {
        let time = count as f64 * self.motion.state.time_step;
        let i = self.block.0 as usize;
        for velocity in std::iter::repeat_n([x / time, y / time, 0.0], count as usize).chain([[0.0; 3]]) {
            self.motion.state.velocities[i] = velocity;
            self.motion.step();
            // Only a block with some freedom has contacts with a held one; turn it back.
            self.motion.state.poses[i].rotation = Rotation::NONE;
            self.motion.state.velocities[i][2] = 0.0;
        }
        let found = contacts(&self.motion.state);
        (found.iter().map(|c| c.compression).sum(), found.iter().map(|c| c.shear).sum(), found)
    }
}

const JOINT: f64 = 0.48;

fn near(value: f64, reference: f64, scale: f64) {
    // Round-off of positions of order 1 m against overlaps of order 0.1 mm.
    assert!((value - reference).abs() < 1e-9 * scale, "{value}, not {reference}");
}

#[test]
fn compression_is_linear_and_opens_without_tension() {
    let mut press = Press::new(dry(1e9, 5e8, 30.0));
    for (move_by, depth) in [(-1e-4, 1e-4), (-2e-4, 3e-4), (2.5e-4, 5e-5), (-1e-4, 1.5e-4)] {
        near(press.go(0.0, move_by, 50).0, 1e9 * JOINT * depth, 1e5);
    }
    assert!(press.go(0.0, 3e-4, 50).2.is_empty());
    near(press.go(0.0, -2.5e-4, 50).0, 1e9 * JOINT * 1e-4, 1e5);
}

/// Crushing at 2 MPa: the plateau, an elastic return from it, a gap left behind, and the plateau again where it was.
#[test]
fn crushing_leaves_its_depth_behind() {
    let mut press = Press::new(ContactLaw { crushing: 2e6, ..dry(1e9, 5e8, 30.0) });
    let full = 2e6 * JOINT;
    near(press.go(0.0, -1e-3, 50).0, 1e9 * JOINT * 1e-3, full);
    near(press.go(0.0, -2e-3, 50).0, full, full);
    // Back by 0.5 mm: 1.5 MPa. Back by the elastic 2 mm: open, at a depth of 1 mm.
    near(press.go(0.0, 0.5e-3, 50).0, 1.5e6 * JOINT, full);
    assert!(press.go(0.0, 1.6e-3, 50).2.is_empty());
    // Down again to the depth of 3 mm: exactly the plateau; and beyond it.
    near(press.go(0.0, -1.1e-3, 50).0, 1e6 * JOINT, full);
    near(press.go(0.0, -2e-3, 50).0, full, full);
    // What was lost is the strength times the crushed depth, 1 mm and then 1 mm more.
    near(mechanics::dem::energy(&press.motion.model, &press.motion.state).dissipated, full * 2e-3, full * 2e-3);
}

/// Built bonded with 0.3 MPa: tension up to it, then nothing, and no tension ever again.
#[test]
fn a_bond_breaks_once() {
    let mut press = Press::new(ContactLaw { tension: 0.3e6, ..dry(1e9, 5e8, 30.0) });
    near(press.go(0.0, 2e-4, 50).0, -0.2e6 * JOINT, 1e5);
    near(press.go(0.0, -4e-4, 50).0, 0.2e6 * JOINT, 1e5);
    near(press.go(0.0, 4.9e-4, 50).0, -0.29e6 * JOINT, 1e5);
    assert!(press.go(0.0, 0.2e-4, 50).2.is_empty());
    assert!(press.go(0.0, -3e-4, 50).2.is_empty());
    near(press.go(0.0, -1.1e-4, 50).0, 0.1e6 * JOINT, 1e5);
    assert!(press.go(0.0, 2e-4, 50).2.is_empty());
}

/// Blocks that meet later were never bonded.
#[test]
fn blocks_built_apart_have_no_bond() {
    let mut scene = Scene::new(ContactLaw { tension: 1e6, ..dry(1e9, 5e8, 30.0) });
    scene.gravity = vec2(0.0, 0.0);
    scene.rectangle(vec2(-0.25, -0.5), 0.5, 0.5, Held::FIXED);
    // 5 mm apart: beyond what a bond of 1 MPa could stretch, within the reach of the search.
    let block = scene.rectangle(vec2(-0.25, 0.005), 0.5, 0.5, Held { rotation: false, ..Held::FIXED });
    let mut press = Press { motion: scene.begin(settings(Damping::None)), block };
    assert!(press.go(0.0, -1e-3, 50).2.is_empty());
    near(press.go(0.0, -4.1e-3, 200).0, 1e9 * JOINT * 1e-4, 1e5);
    assert!(press.go(0.0, 2e-4, 50).2.is_empty());
}

/// Shear: linear up to cohesion and friction, then constant; unloads along the spring; follows the compression when
/// that falls.
#[test]
fn shear_is_capped_by_mohr_and_coulomb() {
    let law = ContactLaw { cohesion: 1e5, ..dry(1e9, 5e8, 30.0) };
    let friction = law.friction;
    let mut press = Press::new(law);
    let normal = press.go(0.0, -4e-4, 50).0;
    near(normal, 1e9 * JOINT * 4e-4, normal);
    let cap = 1e5 * JOINT + friction * normal;
    // The force on the upper (second) block opposes its motion to the right; `normal.left()` points to the left.
    let spring = 5e8 * JOINT;
    near(press.go(1e-4, 0.0, 50).1, spring * 1e-4, normal);
    let (_, shear, found) = press.go(2e-3, 0.0, 50);
    near(shear, cap, normal);
    assert!(found.len() == 2);
    near(press.go(-1e-4, 0.0, 50).1, cap - spring * 1e-4, normal);
    near(press.go(-4e-3, 0.0, 50).1, -cap, normal);
    // Half the compression, half the friction.
    let (half, shear, _) = press.go(0.0, 2e-4, 50);
    near(half, 0.5 * normal, normal);
    near(shear, -(1e5 * JOINT + friction * half), normal);
    // Opened and closed again: nothing is remembered.
    press.go(0.0, 3e-4, 50);
    near(press.go(0.0, -2e-4, 50).1, 0.0, normal);
}

/// Updated lengths: half the joint where both points press, half the compressed part where one has lifted.
#[test]
fn updated_lengths_follow_the_compressed_part() {
    let mut scene = Scene::new(dry(1e9, 5e8, 30.0));
    scene.floor(-1.0, 1.0);
    let block = scene.brick(vec2(-0.25, 0.0), 0.5, 0.2);
    // A vertical force beyond the middle third tips the block onto one point; the other still stands or lifts.
    scene.push(block, vec2(0.2, 0.2), vec2(0.0, -20e3));
    let mut s = settings(Damping::Local(0.7));
    s.contact_length = ContactLength::Updated;
    let mut motion = scene.begin(s);
    motion.rest(1e-13);
    let found = contacts(&motion.state);
    let weight = scene.weight(block) + 20e3;
    assert!((found.iter().map(|c| c.compression).sum::<f64>() / weight - 1.0).abs() < 1e-6);
    // Both points stand at 0.24 m: the resultant lies at 0.2 * 20 / 21.96 = 0.18 m.
    let right = weight * 0.5 + (20e3 * 0.2) / JOINT;
    assert!((found[0].compression.max(found[1].compression) / right - 1.0).abs() < 1e-4, "{found:?} {right}");
    assert!(found.iter().all(|c| (c.length / (0.5 * JOINT) - 1.0).abs() < 1e-3), "{found:?}");
}

/// A joint that hangs on its bond is as long as it is built: two points of nearly equal opening do not stand for more,
/// and one point that still hangs after the other broke stands for no more than its half.
#[test]
fn a_bonded_joint_in_tension_is_no_longer_than_it_is_built() {
    let mut scene = Scene::new(ContactLaw { tension: 1e5, cohesion: 1e5, ..dry(1e9, 5e8, 30.0) });
    scene.gravity = vec2(0.0, 0.0);
    scene.rectangle(vec2(-0.25, -0.5), 0.5, 0.5, Held::FIXED);
    let block = scene.rectangle(vec2(-0.25, 0.0), 0.5, 0.5, Held { rotation: false, ..Held::FIXED });
    let mut s = settings(Damping::None);
    s.contact_length = ContactLength::Updated;
    let mut motion = scene.begin(s);
    motion.step();
    let i = block.0 as usize;
    // Openings of 2.00 and 1.99 um; then 110 and 90 um, beyond and below the 100 um that the bond carries.
    for (middle, turn) in [(1.995e-6, 1e-8 / JOINT), (100e-6, 20e-6 / JOINT)] {
        motion.state.poses[i].position.y = 0.25 + middle;
        motion.state.poses[i].rotation = Rotation::by(turn);
        motion.state.velocities[i] = [0.0; 3];
        motion.step();
        let found = contacts(&motion.state);
        let tensile: f64 = found.iter().map(|c| -c.compression).sum();
        assert!(tensile > 0.0, "{found:?}");
        assert!(found.iter().all(|c| c.length <= 0.5 * JOINT * (1.0 + 1e-6)), "{found:?}");
        assert!(tensile <= 1e9 * (middle + 0.5 * turn * JOINT) * JOINT * (1.0 + 1e-6), "{found:?}");
    }
}

/// A support is moved exactly as told, and a block held in x and rotation only moves in y.
#[test]
fn supports_move_as_prescribed() {
    let mut scene = Scene::new(dry(1e9, 5e8, 30.0));
    let support = scene.rectangle(vec2(-0.5, -0.5), 1.0, 0.5, Held::FIXED);
    let guided = scene.rectangle(vec2(-0.25, 0.0), 0.5, 0.3, Held { x: true, y: false, rotation: true });
    let top = scene.brick(vec2(-0.1, 0.3), 0.2, 0.2);
    scene.loading.movements.push(Movement { block: support, translation: vec2(0.02, 0.01), rotation: 0.0 });
    let program = Program { increment: 0.5, limit: 1.0, resolution: None, watched: (top, vec2(0.0, 0.5)) };
    let outcome =
        collapse(&scene.model(), &scene.loading, &program, &settings(Damping::Local(0.7)), None, &mut Unwatched)
            .unwrap();
    assert_eq!(outcome.status, Status::StableToLastLoad);
    let last = outcome.frames.last().unwrap();
    let built = scene.model().poses();
    let moved = |block: BlockId| last.poses[block].position - built[block].position;
    assert!((moved(support) - vec2(0.02, 0.01)).norm() < 1e-12, "{:?}", moved(support));
    assert!(moved(guided).x == 0.0 && last.poses[guided].rotation.sin == 0.0);
    // It follows the support up, less the change of its static compression, which is none.
    let sunk = (scene.weight(guided) + scene.weight(top)) / (1e9 * JOINT);
    assert!((moved(guided).y - 0.01 + sunk).abs() < 1e-3 * sunk, "{:?} {sunk}", moved(guided));
    assert!(moved(top).x.abs() < 1e-6);
    let energy = outcome.energy;
    let work = energy.gravity.abs() + energy.supports.abs();
    assert!(energy.drift().abs() < 1e-3 * work, "{energy:?} {}", energy.drift());
}
