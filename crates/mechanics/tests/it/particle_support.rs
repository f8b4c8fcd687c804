//! Small worlds of particles that several tests share.

use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, Particle, Stiffness};
use mechanics::dem::{ContactLength, Damping, Model, Settings, State, StepReport, Workspace, begin, step};
use mechanics::ids::{GroupId, Table};
use mechanics::plane::{Polygon, Vec2, vec2};

/// The fill of the Bridgemill paper, Table 1 and 2: 0.532 and 0.222 GPa/m, each contact standing for 0.15 m.
pub(crate) fn fill(friction: f64) -> ContactLaw {
    ContactLaw {
        normal: Stiffness::Given(0.532e9),
        shear: Stiffness::Given(0.222e9),
        friction,
        cohesion: 0.0,
        tension: 0.0,
        crushing: f64::INFINITY,
        fixed_length: Some(0.15),
        least_length: 0.01,
    }
}

/// Stiffness of one such contact [Pa].
pub(crate) const NORMAL: f64 = 0.532e9 * 0.15;
pub(crate) const SHEAR: f64 = 0.222e9 * 0.15;
pub(crate) const DENSITY: f64 = 1890.0;

pub(crate) fn settings(damping: Damping, time_step_factor: f64) -> Settings {
    Settings {
        damping,
        contact_length: ContactLength::Fixed,
        tolerance: 1e-6,
        step_limit: 1_000_000,
        time_step_factor,
        scaled_inertia: false,
    }
}

/// Particles and held blocks under one law; group 0 are the blocks, group 1 the particles.
pub(crate) fn world(law: ContactLaw, gravity: Vec2, blocks: Vec<Block>, discs: &[(Vec2, f64)]) -> BlockModel {
    let particle = |&(centre, radius): &(Vec2, f64)| Particle { centre, radius, density: DENSITY, group: GroupId(1) };
    BlockModel {
        blocks: blocks.into_iter().collect(),
        particles: discs.iter().map(particle).collect::<Table<_, _>>(),
        groups: ["wall".to_string(), "fill".to_string()].into_iter().collect(),
        laws: LawTable::uniform(2, law),
        gravity,
    }
}

pub(crate) fn wall(corner: Vec2, width: f64, height: f64) -> Block {
    let outline = Polygon::rectangle(corner, width, height).unwrap();
    Block { outline, rounding: 0.0, density: 2000.0, group: GroupId(0), held: Held::FIXED }
}

/// Four walls around a room from the origin.
pub(crate) fn room(width: f64, height: f64) -> Vec<Block> {
    let t = 0.3;
    vec![
        wall(vec2(-t, -t), width + 2.0 * t, t),
        wall(vec2(-t, 0.0), t, height),
        wall(vec2(width, 0.0), t, height),
        wall(vec2(-t, height), width + 2.0 * t, t),
    ]
}

pub(crate) fn mass(radius: f64) -> f64 {
    DENSITY * std::f64::consts::PI * radius * radius
}

/// A model that moves.
pub(crate) struct Moving {
    pub model: Model,
    pub state: State,
    pub work: Workspace,
    pub settings: Settings,
}

impl Moving {
    pub(crate) fn new(world: &BlockModel, settings: Settings) -> Moving {
        Moving::loaded(world, &Loading::default(), settings)
    }
    pub(crate) fn loaded(world: &BlockModel, loading: &Loading, settings: Settings) -> Moving {
        let model = Model::new(world, loading).unwrap();
        let state = begin(&model, &settings);
        Moving { model, state, work: Workspace::default(), settings }
    }
    pub(crate) fn step(&mut self) -> StepReport {
        step(&self.model, &mut self.state, &mut self.work, &self.settings)
    }
    pub(crate) fn run(&mut self, steps: usize) {
        (0..steps).for_each(|_| {
            self.step();
        });
    }
}

/// A linear congruential generator (Knuth), the same numbers in every run.
pub(crate) struct Chance(pub u64);

impl Chance {
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Rows of loose particles of 0.06 to 0.09 m, none touching another, from the corner (0, 0) upwards.
pub(crate) fn loose(columns: usize, rows: usize, seed: u64) -> Vec<(Vec2, f64)> {
    let mut chance = Chance(seed);
    let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    cells
        .map(|(column, row)| {
            let r = chance.between(0.06, 0.09);
            let play = 0.0925 - r;
            let at = vec2(0.0925 + 0.185 * column as f64, 0.0925 + 0.185 * row as f64);
            (at + vec2(chance.between(-play, play), chance.between(-play, play)), r)
        })
        .collect()
}

pub(crate) fn stone(corners: &[(f64, f64)], rounding: f64, held: Held) -> Block {
    let outline = Polygon::new(corners.iter().map(|&(x, y)| vec2(x, y)).collect()).unwrap();
    Block { outline, rounding, density: 2400.0, group: GroupId(0), held }
}

/// A regular polygon of `count` corners around `centre`, turned by `turn` [rad].
pub(crate) fn regular(centre: Vec2, reach: f64, count: usize, turn: f64) -> Vec<(f64, f64)> {
    let angle = |k: usize| turn + std::f64::consts::TAU * k as f64 / count as f64;
    (0..count).map(|k| (centre.x + reach * angle(k).cos(), centre.y + reach * angle(k).sin())).collect()
}
