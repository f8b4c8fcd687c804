//! What stays when the population changes between stages.

use crate::particle_support::{DENSITY, Moving, fill, room, settings, stone, world};
use mechanics::blocks::{BlockModel, Held, Loading};
use mechanics::dem::{Body, Damping, Model, ParticleContact, Recipe, State, Target, energy, frame, pack, take_over};
use mechanics::ids::{BlockId, GroupId, ParticleId};
use mechanics::plane::{Vec2, vec2};
use mechanics::watch::Unwatched;
use std::collections::BTreeMap;

/// A packing under gravity and a lid, with friction, at rest.
fn lidded() -> (BlockModel, Moving) {
    let region = [vec2(0.0, 0.0), vec2(2.0, 0.0), vec2(2.0, 1.5), vec2(0.0, 1.5)];
    let recipe = Recipe {
        count: 130,
        size_ratio: 1.5,
        target: Target::Stress(1e5),
        seed: 9,
        density: DENSITY,
        group: GroupId(1),
    };
    let walls = world(fill(0.5), Vec2::ZERO, room(2.0, 1.5), &[]);
    let grains = pack(&walls, &region, &recipe, &mut Unwatched).unwrap().grains;
    let discs: Vec<(Vec2, f64)> = grains.iter().map(|g| (g.centre, g.radius)).collect();
    let world = world(fill(0.5), vec2(0.0, -9.81), room(2.0, 1.5), &discs);
    let mut m = Moving::new(&world, settings(Damping::Local(0.7), 0.8));
    m.run(8_000);
    (world, m)
}

/// Contacts by who touches whom; the force is that on the particle with the lower number, or on the particle.
fn forces(model: &Model, state: &State) -> BTreeMap<(u32, u32, bool), Vec2> {
    let one = |c: &ParticleContact| match c.partner {
        Body::Particle(other) if other < c.particle => ((other.0, c.particle.0, false), -c.force()),
        Body::Particle(other) => ((c.particle.0, other.0, false), c.force()),
        Body::Block(block) => ((c.particle.0, block.0, true), c.force()),
    };
    frame(model, state).particle_contacts.iter().map(one).collect()
}

/// Out-of-balance forces [N/m] of all particles together.
fn out_of_balance(model: &Model, state: &State, world: &BlockModel) -> f64 {
    let mut on: Vec<Vec2> = world.particles.iter().map(|p| world.gravity * p.mass()).collect();
    for (&(one, other, block), &force) in &forces(model, state) {
        on[one as usize] += force;
        if !block {
            on[other as usize] -= force;
        }
    }
    on.iter().map(|f| f.norm()).sum()
}

/// Taken over without a change, forces, places and velocities are the same to the last bit.
#[test]
fn nothing_changes_where_nothing_is_changed() {
    let (world, m) = lidded();
    let model = Model::new(&world, &Loading::default()).unwrap();
    let state = take_over(&model, &m.settings, (&m.model, &m.state));
    assert_eq!(forces(&model, &state), forces(&m.model, &m.state));
    assert_eq!(state.particles(&model), m.state.particles(&m.model));
    assert_eq!(out_of_balance(&model, &state, &world), out_of_balance(&m.model, &m.state, &world));
    let account = energy(&model, &state);
    // The sum of terms of kilojoules that cancel.
    assert!(account.drift().abs() < 1e-9 * (account.elastic.abs() + account.initial.abs()), "{account:?}");
}

/// The lid goes, or a block is set on the bare surface: all other contacts carry what they carried, and the run goes on from
/// there with its account closed.
#[test]
fn what_stays_carries_what_it_carried() {
    let (world, m) = lidded();
    let before = forces(&m.model, &m.state);
    let mut open = world.clone();
    open.blocks = world.blocks.iter().take(3).cloned().collect();
    let model = Model::new(&open, &Loading::default()).unwrap();
    let state = take_over(&model, &m.settings, (&m.model, &m.state));
    let now = forces(&model, &state);
    let kept: BTreeMap<_, _> =
        before.iter().filter(|((_, other, block), _)| !(*block && *other == 3)).map(|(k, f)| (*k, *f)).collect();
    assert!(kept.len() > 100 && kept.len() < before.len());
    assert_eq!(now, kept);
    let lid: f64 = before.iter().filter(|((_, other, block), _)| *block && *other == 3).map(|(_, f)| -f.y).sum();
    let (closed, opened) = (out_of_balance(&m.model, &m.state, &world), out_of_balance(&model, &state, &open));
    assert!(closed < 1e-3 * lid && opened > 0.9 * lid, "{closed} {opened} {lid}");
    assert!(energy(&model, &state).drift().abs() < 1e-6, "{:?}", energy(&model, &state));

    let mut m = Moving { model, state, work: Default::default(), settings: m.settings };
    m.run(10_000);
    let e = energy(&m.model, &m.state);
    // The lid's pressure is let go within a few steps, as in a fall: an impact's share of the energy that was stored.
    assert!(e.drift().abs() < 0.05 * e.initial.abs(), "{e:?}");
    let top = m.state.particles(&m.model).iter().map(|p| p.centre.y + p.radius).fold(0.0, f64::max);
    let mut laden = open.clone();
    let corners = [(0.3, top + 1e-3), (1.5, top + 1e-3), (1.5, top + 0.3), (0.3, top + 0.3)];
    laden.blocks.push(stone(&corners, 0.02, Held::FREE));
    let next = Model::new(&laden, &Loading::default()).unwrap();
    let before = forces(&m.model, &m.state);
    let state = take_over(&next, &m.settings, (&m.model, &m.state));
    assert_eq!(forces(&next, &state), before);
    let mut n = Moving { model: next, state, work: Default::default(), settings: m.settings };
    assert!(energy(&n.model, &n.state).drift().abs() < 1e-6);
    n.run(20_000);
    let weight = laden.blocks[BlockId(3)].mass() * 9.81;
    let found = forces(&n.model, &n.state);
    let carried: f64 = found.iter().filter(|((_, other, block), _)| *block && *other == 3).map(|(_, f)| -f.y).sum();
    // At rest the block presses with its weight.
    assert!((carried / weight - 1.0).abs() < 1e-3, "{carried} {weight}");
    assert!(n.state.particles(&n.model)[ParticleId(0)].centre.is_finite());
}
