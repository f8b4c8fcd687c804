//! A stopped run with particles goes on as if nothing had happened, and only from what was kept for it.

use crate::dem_resume::{Looks, StopAt, damage_is_refused};
use crate::particle_support::{DENSITY, fill, room, settings, stone, world};
use mechanics::blocks::{BlockModel, Held, Loading, ModelError, PointForce};
use mechanics::dem::{Damping, Program, Recipe, Settings, Status, Target, collapse, pack};
use mechanics::ids::{BlockId, GroupId, ParticleId};
use mechanics::plane::{Vec2, vec2};
use mechanics::watch::Unwatched;

/// A plate that lies on particles in a box and is pressed down off its centre.
fn case() -> (BlockModel, Loading, Program) {
    let lidded = world(fill(0.0), Vec2::ZERO, room(1.12, 0.6), &[]);
    let region = [vec2(0.0, 0.0), vec2(1.12, 0.0), vec2(1.12, 0.6), vec2(0.0, 0.6)];
    let recipe = Recipe {
        count: 40,
        size_ratio: 1.5,
        target: Target::Stress(7e3),
        seed: 4,
        density: DENSITY,
        group: GroupId(1),
    };
    let grains = pack(&lidded, &region, &recipe, &mut Unwatched).unwrap().grains;
    let discs: Vec<(Vec2, f64)> = grains.iter().map(|g| (g.centre, g.radius)).collect();
    let mut blocks = room(1.12, 2.0);
    blocks.push(stone(&[(0.02, 0.6), (1.1, 0.6), (1.1, 0.9), (0.02, 0.9)], 0.02, Held::FREE));
    let world = world(fill(0.6), vec2(0.0, -9.81), blocks, &discs);
    let push = PointForce { block: BlockId(4), at: vec2(0.4, 0.9), force: vec2(0.0, -2e3) };
    let loading = Loading { variable: vec![push], ..Loading::default() };
    let watched = (BlockId(4), vec2(0.4, 0.9));
    (world, loading, Program { increment: 1.0, limit: 2.0, resolution: None, watched })
}

/// Small steps, so that stages last for several looks.
fn damped(damping: Damping) -> Settings {
    let factor = if damping == Damping::Adaptive { 0.06 } else { 0.3 };
    Settings { step_limit: 20_000, tolerance: 1e-7, ..settings(damping, factor) }
}

/// Whatever the damping, and wherever the run is stopped: in the fall, at rest, under load.
#[test]
fn a_resumed_run_with_particles_ends_in_the_same_bits() {
    let (model, loading, program) = case();
    for damping in [Damping::Local(0.3), Damping::Adaptive] {
        let settings = damped(damping);
        let mut count = Looks(0);
        let undisturbed = collapse(&model, &loading, &program, &settings, None, &mut count).unwrap();
        assert!(count.0 >= 3, "{} looks in {} steps", count.0, undisturbed.iterations_total);
        for stops in [vec![0], vec![count.0 / 2], vec![count.0 - 1], vec![0, 0]] {
            let mut kept: Option<Vec<u8>> = None;
            for look in stops {
                let mut watch = StopAt::look(look);
                let stopped = collapse(&model, &loading, &program, &settings, kept.as_deref(), &mut watch).unwrap();
                assert_eq!(stopped.status, Status::Cancelled);
                kept = Some(watch.kept);
            }
            let resumed = collapse(&model, &loading, &program, &settings, kept.as_deref(), &mut Unwatched).unwrap();
            assert_eq!(format!("{resumed:?}"), format!("{undisturbed:?}"));
        }
    }
}

/// States with any bit flipped, or kept for particles of another place, size, density or group, another gravity, or another
/// law between particles alone, are refused by name.
#[test]
fn damaged_and_foreign_states_with_particles_are_refused() {
    let (model, loading, program) = case();
    let settings = damped(Damping::Local(0.3));
    let mut watch = StopAt::look(1);
    collapse(&model, &loading, &program, &settings, None, &mut watch).unwrap();
    let kept = watch.kept;
    let take = |model: &BlockModel, kept: &[u8]| {
        collapse(model, &loading, &program, &settings, Some(kept), &mut StopAt::look(0)).map(|_| ())
    };
    assert_eq!(take(&model, &kept), Ok(()));
    let refused = Err(ModelError::ForeignState);
    damage_is_refused(&kept, |kept| take(&model, kept));
    let changes: [&dyn Fn(&mut BlockModel); 8] = [
        &|m| m.particles[ParticleId(3)].centre.x += 1e-9,
        &|m| m.particles[ParticleId(3)].radius *= 1.001,
        &|m| m.particles[ParticleId(3)].density *= 1.001,
        &|m| m.particles[ParticleId(3)].group = GroupId(0),
        &|m| m.particles = m.particles.iter().skip(1).copied().collect(),
        &|m| m.gravity.x = 1e-6,
        &|m| m.laws.iter_mut().for_each(|law| law.friction *= 1.01),
        &|m| {
            let between = mechanics::blocks::ContactLaw { friction: 0.1, ..*m.laws.between(GroupId(1), GroupId(1)) };
            m.laws.set(GroupId(1), GroupId(1), between);
        },
    ];
    for (k, change) in changes.iter().enumerate() {
        let mut other = model.clone();
        change(&mut other);
        assert_eq!(take(&other, &kept), refused, "change {k}");
    }
}
