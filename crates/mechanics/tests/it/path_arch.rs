//! The equilibrium path of the Bridgemill arch beside the block engine and the exact load of rigid blocks.

use super::dem_bridgemill::{bridgemill, paper, program as blocks_program, run as by_blocks};
use mechanics::blocks::{BlockModel, Loading, PointForce};
use mechanics::contact::ContactLength;
use mechanics::dem::Damping;
use mechanics::ids::Id;
use mechanics::limit;
use mechanics::path::{Cause, Frame, Ground, Outcome, Program, Settings, Status, collapse};
use mechanics::plane::{Polygon, Vec2, vec2};
use mechanics::watch::Unwatched;

fn program() -> Program {
    let blocks = blocks_program(None);
    Program { increment: blocks.increment, limit: 1000.0, watched: blocks.watched }
}

fn run((model, loading): &(BlockModel, Loading), contact_length: ContactLength) -> Outcome {
    collapse(model, loading, (&Settings::new(contact_length), &program()), None, &mut Unwatched).unwrap()
}

fn load(outcome: &Outcome) -> f64 {
    assert_eq!(outcome.status, Status::LimitPoint);
    outcome.collapse_factor.unwrap()
}

fn within(value: f64, reference: f64, share: f64) {
    assert!((value / reference - 1.0).abs() <= share, "{value} is not within {share} of {reference}");
}

/// The block engine comes to rest at 205.5 kN/m and collapses 0.1 above; for case 2 it is 331.0. There the state in which a
/// hinge moves to the next joint is passed with a swing, and along the path without: 0.5 %.
#[test]
fn points_collapse_at_the_load_of_the_block_engine() {
    for (fill, share) in [(false, 1e-3), (true, 6e-3)] {
        let arch = bridgemill(fill, 1.0);
        let blocks = by_blocks(&arch, Some(0.1), &paper(Damping::Adaptive, ContactLength::Fixed));
        within(load(&run(&arch, ContactLength::Fixed)), blocks.last_stable_factor.unwrap(), share);
    }
}

/// With pressure over the whole joint the arch carries 124 kN/m and not 205: it swings for long before it comes to rest, so that
/// the block engine gives a lower bound that is close.
#[test]
fn distributed_joints_collapse_at_the_load_of_the_block_engine() {
    for (fill, expected) in [(false, 124.2), (true, 169.3)] {
        let arch = bridgemill(fill, 1.0);
        let blocks = by_blocks(&arch, Some(0.5), &paper(Damping::Adaptive, ContactLength::Distributed));
        let path = load(&run(&arch, ContactLength::Distributed));
        within(path, blocks.last_stable_factor.unwrap(), 5e-3);
        within(path, expected, 1e-3);
    }
}

/// The load rises with the stiffness and never reaches that of rigid blocks.
#[test]
fn loads_approach_the_rigid_one_from_below() {
    let (model, loading) = bridgemill(false, 1.0);
    let rigid = limit::collapse_load(&model, &loading, &limit::Settings::default()).unwrap().factor.unwrap();
    for (contact_length, nearest) in [(ContactLength::Fixed, 1e-3), (ContactLength::Distributed, 2e-2)] {
        let mut last = 0.0;
        for stiffness in [1.0, 10.0, 100.0, 1000.0, 10_000.0] {
            let found = load(&run(&bridgemill(false, stiffness), contact_length));
            assert!(found > last && found < rigid, "{contact_length:?} {stiffness}: {last} {found} {rigid}");
            last = found;
        }
        within(last, rigid, nearest);
    }
}

/// Seen from behind the arch carries the same.
#[test]
fn a_mirrored_arch_carries_the_same() {
    for contact_length in [ContactLength::Fixed, ContactLength::Updated, ContactLength::Distributed] {
        let (mut model, mut loading) = bridgemill(false, 1.0);
        let one = load(&run(&(model.clone(), loading.clone()), contact_length));
        let turned = |p: Vec2| vec2(-p.x, p.y);
        for block in model.blocks.iter_mut() {
            let corners = block.outline.vertices().iter().rev().map(|&p| turned(p)).collect();
            block.outline = Polygon::new(corners).unwrap();
        }
        for force in &mut loading.variable {
            force.at = turned(force.at);
        }
        let mut program = program();
        program.watched.1 = turned(program.watched.1);
        let settings = Settings::new(contact_length);
        let other = collapse(&model, &loading, (&settings, &program), None, &mut Unwatched).unwrap();
        within(load(&other), one, 2e-5);
    }
}

/// Forces of a frame, gathered here: joints, weights and loads balance in every block.
fn out_of_balance((model, loading): &(BlockModel, Loading), outcome: &Outcome, frame: &Frame) -> f64 {
    let mut sums = vec![(Vec2::ZERO, 0.0); model.blocks.len()];
    let mut add = |block: usize, at: Vec2, force: Vec2| {
        let arm = at - frame.poses.iter().nth(block).unwrap().position;
        sums[block].0 += force;
        sums[block].1 += arm.cross(force);
    };
    for (id, block) in model.blocks.pairs() {
        add(id.index(), frame.poses[id].position, model.gravity * block.mass());
    }
    for (forces, factor) in [(&loading.permanent, 1.0), (&loading.variable, frame.factor)] {
        for f in forces {
            let arm = f.at - model.blocks[f.block].outline.centroid();
            add(f.block.index(), frame.poses[f.block].place(arm), f.force * factor);
        }
    }
    for (joint, face) in frame.joints.iter().zip(&outcome.interfaces) {
        for end in &joint.ends {
            let force = joint.normal * end.compression + joint.normal.left() * end.shear;
            add(face.first.index(), end.at, -force);
            add(face.second.index(), end.at, force);
        }
    }
    let free = model.blocks.pairs().filter(|(_, block)| !block.held.is_fixed()).map(|(id, _)| sums[id.index()]);
    free.map(|(force, moment)| force.norm().max(moment.abs())).fold(0.0, f64::max)
}

/// Every state balances to a hundredth of a newton in half a meganewton, and no joint carries tension or more shear than friction.
#[test]
fn states_balance_and_keep_within_their_strength() {
    for contact_length in [ContactLength::Fixed, ContactLength::Updated, ContactLength::Distributed] {
        let arch = bridgemill(true, 1.0);
        let found = run(&arch, contact_length);
        assert!(found.frames.len() > 10);
        assert!(found.path.iter().all(|point| point.excess < 1e-6), "{contact_length:?}");
        for frame in &found.frames {
            let left = out_of_balance(&arch, &found, frame);
            assert!(left < 0.01, "{contact_length:?} at {}: {left} N/m", frame.factor);
            for end in frame.joints.iter().flat_map(|joint| &joint.ends) {
                let most = 35.6_f64.to_radians().tan() * end.compression * (1.0 + 1e-9) + 1e-6;
                assert!(end.compression >= 0.0 && end.shear.abs() <= most, "{end:?}");
            }
        }
    }
}

/// Past its peak the load falls, joints have opened, and the ends of the arch stay where they are in the mechanism.
#[test]
fn the_path_goes_past_its_peak() {
    let arch = bridgemill(false, 1.0);
    let found = run(&arch, ContactLength::Distributed);
    let (peak, last) = (found.collapse_factor.unwrap(), found.path.last().unwrap());
    assert!(last.factor < 0.99 * peak && last.displacement.y < -0.05, "{last:?}");
    assert_eq!(found.cause, Some(Cause::Hinging));
    let fastest = found.mechanism.iter().map(|(velocity, _)| velocity.norm()).fold(0.0, f64::max);
    assert!(fastest > 0.5 && fastest <= 1.0, "{fastest}");
    assert!(
        arch.0.blocks.pairs().all(|(id, block)| !block.held.is_fixed() || found.mechanism[id] == (Vec2::ZERO, 0.0))
    );
}

/// Joints that crush carry less, and nothing above their strength.
#[test]
fn crushing_takes_load_away() {
    let (mut model, loading) = bridgemill(false, 10.0);
    let free = load(&run(&(model.clone(), loading.clone()), ContactLength::Distributed));
    model.laws.iter_mut().for_each(|law| law.crushing = 4e6);
    let found = run(&(model, loading), ContactLength::Distributed);
    assert!(load(&found) < 0.95 * free, "{} {free}", load(&found));
    assert!(found.path.iter().all(|point| point.stress <= 4e6));
    assert!(found.path.iter().any(|point| point.crushed > 0.1));
}

/// A load limit ends the path as such; a ring a hundred times as heavy on joints of 1 MPa does not stand, and its path says so.
#[test]
fn a_path_has_a_name_for_its_end() {
    let arch = bridgemill(false, 1.0);
    let settings = Settings::new(ContactLength::Distributed);
    let short = Program { limit: 50.0, ..program() };
    let found = collapse(&arch.0, &arch.1, (&settings, &short), None, &mut Unwatched).unwrap();
    assert_eq!((found.status, found.collapse_factor), (Status::StableToLastLoad, None));
    within(found.last_stable_factor.unwrap(), 50.0, 1e-12);
    let mut heavy = arch;
    heavy.0.gravity = heavy.0.gravity * 100.0;
    heavy.0.laws.iter_mut().for_each(|law| law.crushing = 1e6);
    let found = collapse(&heavy.0, &heavy.1, (&settings, &program()), None, &mut Unwatched).unwrap();
    assert_eq!(found.status, Status::UnstableUnderSelfWeight);
}

/// Loads that are followed one after the other from one state under self-weight carry what each carries by itself, whichever came
/// before it and however long its steps are.
#[test]
fn loads_followed_from_one_self_weight_carry_what_they_carry_alone() {
    let (model, loading) = bridgemill(false, 1.0);
    let ground = Ground::new(&model, &loading, &Settings::new(ContactLength::Distributed), &mut Unwatched).unwrap();
    let mut sweeper = ground.sweeper();
    let twice: Vec<_> = loading.variable.iter().map(|f| PointForce { force: f.force * 2.0, ..*f }).collect();
    let mut carried = |forces: &[PointForce], increment: f64| {
        let found = sweeper.carried(forces, (&Program { increment, ..program() }, &[]), &mut Unwatched);
        assert_eq!((found.status, found.cause), (Status::LimitPoint, Some(Cause::Hinging)));
        found.last_stable_factor.unwrap()
    };
    let alone = load(&run(&(model, loading.clone()), ContactLength::Distributed));
    within(carried(&loading.variable, 0.15 * alone), alone, 2e-5);
    within(2.0 * carried(&twice, 0.1 * alone), alone, 2e-5);
    within(carried(&loading.variable, 0.02 * alone), alone, 2e-5);
}

/// Whether a load is carried is answered beside the state of the load before it as the path from self-weight answers, on either side of the
/// largest load: the wrong way never, and most often at all.
#[test]
fn loads_beside_others_are_carried_as_far_as_their_paths_go() {
    let (model, loading) = bridgemill(false, 1.0);
    let ground = Ground::new(&model, &loading, &Settings::new(ContactLength::Distributed), &mut Unwatched).unwrap();
    let (mut sweeper, mut alone) = (ground.sweeper(), ground.sweeper());
    let loaded = loading.variable[0].block.index();
    let force = loading.variable.iter().fold(Vec2::ZERO, |sum, f| sum + f.force);
    let (mut answered, mut asked) = (0, 0);
    for block in loaded - 4..loaded + 8 {
        let id = Id::new(block);
        let forces = [PointForce { block: id, at: model.blocks[id].outline.centroid(), force }];
        let followed = alone.carried(&forces, (&program(), &[]), &mut Unwatched);
        assert_eq!(followed.status, Status::LimitPoint, "block {block} of {}", model.blocks.len());
        let peak = followed.last_stable_factor.unwrap();
        assert!(!alone.clone().carries(&forces, 1.001 * peak), "block {block}");
        for share in [0.6, 0.9, 0.99] {
            asked += 1;
            answered += u32::from(sweeper.carries(&forces, share * peak));
            assert!(!sweeper.carries(&forces, 1.001 * peak), "block {block} after {share}");
        }
        if asked == 3 {
            assert_eq!(answered, 0, "nothing was met before");
            sweeper.carried(&forces, (&program(), &[]), &mut Unwatched);
        }
    }
    assert!(answered >= 24, "{answered} of {asked}");
}
