//! The time step that random packings bear.

use crate::particle_support::{Chance, DENSITY, Moving, fill, room, settings, stone, world};
use mechanics::blocks::{BlockModel, Held};
use mechanics::dem::{Damping, Recipe, Target, critical_time_step, energy, exact_critical_time_step, pack};
use mechanics::ids::{GroupId, Id, ParticleId};
use mechanics::plane::{Vec2, vec2};
use mechanics::watch::Unwatched;

fn packed(seed: u64, size_ratio: f64, block: bool) -> BlockModel {
    let side = 2.2;
    let mut blocks = room(side, side);
    if block {
        blocks.push(stone(&[(0.8, 0.8), (1.5, 0.9), (1.4, 1.4), (0.9, 1.3)], 0.03, Held::FREE));
    }
    let walls = world(fill(0.5), Vec2::ZERO, blocks.clone(), &[]);
    let region = [vec2(0.0, 0.0), vec2(side, 0.0), vec2(side, side), vec2(0.0, side)];
    let target = if block { Target::SolidFraction(0.6) } else { Target::Stress(1e6) };
    let recipe = Recipe { count: 150, size_ratio, target, seed, density: DENSITY, group: GroupId(1) };
    let grains = pack(&walls, &region, &recipe, &mut Unwatched).unwrap().grains;
    let discs: Vec<(Vec2, f64)> = grains.iter().map(|g| (g.centre, g.radius)).collect();
    world(fill(0.5), Vec2::ZERO, blocks, &discs)
}

/// The bound lies below the eigenvalue's step, which is itself one percent on the safe side, and not far below.
#[test]
fn the_bound_lies_below_the_critical_step() {
    let mut shares = Vec::new();
    for (seed, ratio, block) in
        [(1, 1.5, false), (2, 1.5, false), (3, 1.5, false), (4, 1.0, false), (5, 4.0, false), (6, 1.5, true)]
    {
        let m = Moving::new(&packed(seed, ratio, block), settings(Damping::None, 0.8));
        let share =
            critical_time_step(&m.model, &m.state, &m.settings) / (1.01 * exact_critical_time_step(&m.model, &m.state));
        // Power iteration ends within 1e-6 of a frequency's square, from below.
        assert!(share <= 1.0 + 1e-5, "{share}");
        shares.push(share);
    }
    assert!(shares.iter().all(|s| *s > 0.85), "{shares:?}");
}

/// Largest kinetic energy of a shaken packing over that at the start, and after how many steps it passed `most`.
fn shaken(factor: f64, most: f64) -> (f64, u64) {
    let world = packed(1, 1.5, false);
    let mut m = Moving::new(&world, settings(Damping::Local(0.7), 0.8));
    m.run(5_000);
    m.settings = settings(Damping::None, factor);
    // The step is set by the next search.
    let before = m.state.time_step;
    m.run(1_001);
    assert!(m.state.time_step != before);
    let mut chance = Chance(3);
    let begun = m.state.steps;
    // Slow enough that no contact opens under 1 MPa.
    for k in 0..world.particles.len() {
        let v = vec2(chance.between(-1e-4, 1e-4), chance.between(-1e-4, 1e-4));
        m.state.set_particle_velocity(&m.model, ParticleId::new(k), v, chance.between(-1e-3, 1e-3));
    }
    let rest = energy(&m.model, &m.state);
    let whole = rest.kinetic;
    let mut largest = 0.0_f64;
    for _ in 0..400 {
        m.run(10);
        let e = energy(&m.model, &m.state);
        largest = largest.max(e.kinetic / whole);
        if !(largest < most) {
            break;
        }
    }
    (largest, m.state.steps - begun)
}

/// Just below the critical step a shaken packing swings for ever; at 1.3 of it the swing grows without end.
#[test]
fn the_critical_step_parts_stable_from_unstable() {
    let m = Moving::new(&packed(1, 1.5, false), settings(Damping::None, 0.8));
    let exact = exact_critical_time_step(&m.model, &m.state) / critical_time_step(&m.model, &m.state, &m.settings);
    for (factor, stable) in [(0.98, true), (0.98 * exact, true), (1.3 * exact, false)] {
        let (largest, steps) = shaken(factor, 1e2);
        assert_eq!(largest < 1e2, stable, "{factor}: {largest:e} after {steps} steps");
    }
}
