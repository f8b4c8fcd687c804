//! What is refused, and what is caught while it runs.

use crate::dem_bridgemill::{bridgemill, paper, program};
use crate::dem_support::{Scene, dry, settings};
use mechanics::blocks::{ContactLaw, Held, ModelError, Movement, PointForce, Stiffness};
use mechanics::dem::{Body, ContactLength, Damping, Model, Outcome, Program, Settings, Status, collapse};
use mechanics::ids::{BlockId, GroupId};
use mechanics::plane::{Vec2, vec2};
use mechanics::watch::Unwatched;

fn stack() -> Scene {
    let mut scene = Scene::new(dry(1e9, 5e8, 30.0));
    scene.floor(-2.0, 2.0);
    for k in 0..4 {
        scene.brick(vec2(-0.3 + 0.05 * f64::from(k), 0.3 * f64::from(k)), 0.6, 0.3);
    }
    scene
}

fn run(scene: &Scene, settings: &Settings) -> Outcome {
    let program = Program { increment: 0.5, limit: 1.0, resolution: None, watched: (BlockId(1), Vec2::ZERO) };
    collapse(&scene.model(), &scene.loading, &program, settings, None, &mut Unwatched).unwrap()
}

fn refused(scene: &Scene) -> ModelError {
    Model::new(&scene.model(), &scene.loading).err().unwrap()
}

/// Well above the critical step a run is broken, by a block and a step, and never a collapse: whether numbers explode
/// at once or blocks are shaken apart slowly. Just below it the stack stands.
#[test]
fn a_time_step_too_large_is_no_collapse() {
    for (factor, breaks) in [(0.95, false), (1.3, true), (2.0, true), (10.0, true), (1e6, true)] {
        let s = Settings { time_step_factor: factor, ..settings(Damping::Local(0.7)) };
        match run(&stack(), &s).status {
            Status::Broken { body: Body::Block(block), step } => {
                assert!(breaks, "{factor}");
                assert!(block.0 >= 1 && block.0 <= 4 && step > 0, "{block:?} {step}");
            }
            status => assert!(!breaks && status == Status::StableToLastLoad, "{factor}: {status:?}"),
        }
    }
    let (model, loading) = bridgemill(false, 1.0);
    let s = Settings { time_step_factor: 1.3, ..paper(Damping::Local(0.7), ContactLength::Fixed) };
    let outcome = collapse(&model, &loading, &program(None), &s, None, &mut Unwatched).unwrap();
    assert!(matches!(outcome.status, Status::Broken { .. }), "{:?}", outcome.status);
}

#[test]
fn a_number_that_breaks_is_named() {
    let mut scene = stack();
    scene.push(BlockId(3), vec2(0.0, 0.7), vec2(f64::NAN, 0.0));
    let status = run(&scene, &settings(Damping::Local(0.7))).status;
    assert!(matches!(status, Status::Broken { body: Body::Block(BlockId(3)), step: 1 }), "{status:?}");
    let mut scene = stack();
    scene.law.normal = Stiffness::Given(1e300);
    // The critical step is then too small to move anything: no answer, and no panic.
    let status = run(&scene, &Settings { step_limit: 30_000, ..settings(Damping::Local(0.7)) }).status;
    assert!(!matches!(status, Status::StableToLastLoad | Status::Collapsed), "{status:?}");
}

#[test]
fn senseless_laws_are_refused() {
    let good = dry(1e9, 5e8, 30.0);
    let bad = [
        ContactLaw { normal: Stiffness::Given(0.0), ..good },
        ContactLaw { normal: Stiffness::Given(f64::NAN), ..good },
        ContactLaw { shear: Stiffness::Given(-1.0), ..good },
        ContactLaw { normal: Stiffness::Given(f64::INFINITY), ..good },
        ContactLaw { normal: Stiffness::Series { joint: f64::INFINITY, body: f64::INFINITY }, ..good },
        ContactLaw { friction: -0.1, ..good },
        ContactLaw { friction: f64::NAN, ..good },
        ContactLaw { cohesion: -1.0, ..good },
        ContactLaw { tension: f64::NAN, ..good },
        ContactLaw { crushing: 0.0, ..good },
        ContactLaw { least_length: 0.0, ..good },
        ContactLaw { fixed_length: Some(0.0), ..good },
    ];
    for law in bad {
        let mut scene = stack();
        scene.law = law;
        assert!(matches!(refused(&scene), ModelError::Law { .. }), "{law:?}");
    }
}

#[test]
fn blocks_that_overlap_are_refused() {
    let mut scene = stack();
    scene.brick(vec2(-0.2, 1.199), 0.4, 0.2);
    assert!(matches!(refused(&scene), ModelError::Overlap(4, 5, depth) if (depth - 1e-3).abs() < 1e-9));
    // One inside another.
    let mut scene = stack();
    scene.brick(vec2(-0.1, 0.1), 0.1, 0.1);
    assert!(matches!(refused(&scene), ModelError::Overlap(1, 5, _)));
}

#[test]
fn nothing_free_is_refused_and_so_is_moving_what_is_free() {
    let mut scene = Scene::new(dry(1e9, 5e8, 30.0));
    assert_eq!(refused(&scene), ModelError::NothingFree);
    scene.floor(-1.0, 1.0);
    assert_eq!(refused(&scene), ModelError::NothingFree);
    let mut scene = stack();
    let guided = scene.rectangle(vec2(1.0, 0.0), 0.2, 0.2, Held { x: true, y: false, rotation: true });
    let movement = |translation| Movement { block: guided, translation, rotation: 0.0 };
    scene.loading.movements = vec![movement(vec2(0.01, 0.0))];
    assert!(Model::new(&scene.model(), &scene.loading).is_ok());
    scene.loading.movements = vec![movement(vec2(0.0, 0.01))];
    assert_eq!(refused(&scene), ModelError::MovedWhileFree(guided.0));
}

/// The stack has blocks 0 to 4 and one group.
#[test]
fn what_the_model_does_not_have_is_named() {
    let force = PointForce { block: BlockId(5), at: Vec2::ZERO, force: vec2(0.0, -1.0) };
    let unknown = |what, id| ModelError::Unknown { what, id };
    let mut scene = stack();
    scene.loading.permanent = vec![force];
    assert_eq!(refused(&scene), unknown("block", 5));
    let mut scene = stack();
    scene.loading.variable = vec![PointForce { block: BlockId(u32::MAX), ..force }];
    assert_eq!(refused(&scene), unknown("block", u32::MAX));
    let mut scene = stack();
    scene.loading.movements = vec![Movement { block: BlockId(7), translation: Vec2::ZERO, rotation: 0.0 }];
    assert_eq!(refused(&scene), unknown("block", 7));
    let mut model = stack().model();
    let mut stranger = model.blocks[BlockId(2)].clone();
    stranger.group = GroupId(1);
    model.blocks.push(stranger);
    assert_eq!(Model::new(&model, &Default::default()).err(), Some(unknown("group", 1)));
    let scene = stack();
    let program = Program { increment: 0.5, limit: 1.0, resolution: None, watched: (BlockId(5), Vec2::ZERO) };
    let s = settings(Damping::Local(0.7));
    let outcome = collapse(&scene.model(), &scene.loading, &program, &s, None, &mut Unwatched);
    assert_eq!(outcome.err(), Some(unknown("block", 5)));
}

/// Without gravity there is nothing to carry until the load comes; without increments there is an end all the same.
#[test]
fn odd_programs_end() {
    let mut scene = stack();
    scene.gravity = Vec2::ZERO;
    assert_eq!(run(&scene, &settings(Damping::Local(0.7))).status, Status::StableToLastLoad);
    for (increment, limit) in [(0.0, 1.0), (-1.0, 1.0), (f64::NAN, 1.0), (1.0, 0.0), (1.0, f64::NAN)] {
        let scene = stack();
        let program = Program { increment, limit, resolution: Some(0.0), watched: (BlockId(1), Vec2::ZERO) };
        let settings = settings(Damping::Local(0.7));
        let outcome = collapse(&scene.model(), &scene.loading, &program, &settings, None, &mut Unwatched).unwrap();
        assert!(
            outcome.last_stable_factor.is_some() || increment.is_nan(),
            "{increment} {limit}: {:?}",
            outcome.status
        );
    }
}

/// A tolerance below round-off is never met: that is a stall, not an instability, and it ends.
#[test]
fn an_impossible_tolerance_is_a_stall() {
    let s = Settings { tolerance: 1e-30, ..settings(Damping::Local(0.7)) };
    let outcome = run(&stack(), &s);
    assert_eq!(outcome.status, Status::Stalled);
    assert_eq!(outcome.last_stable_factor, None);
}
