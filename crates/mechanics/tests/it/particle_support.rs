//! Small worlds of particles that several tests share.

use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, Particle, Stiffness};
use mechanics::dem::{ContactLength, Damping, Model, Settings, State, StepReport, Workspace, begin, step};
use mechanics::ids::{GroupId, Table};
use mechanics::plane::{Polygon, Vec2, vec2};

/// The fill of the Bridgemill paper, Table 1 and 2: 0.532 and 0.222 GPa/m, each contact standing for 0.15 m.
pub fn fill(friction: f64) -> ContactLaw {
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
pub const NORMAL: f64 = 0.532e9 * 0.15;
pub const SHEAR: f64 = 0.222e9 * 0.15;
pub const DENSITY: f64 = 1890.0;

pub fn settings(damping: Damping, time_step_factor: f64) -> Settings {
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
pub fn world(law: ContactLaw, gravity: Vec2, blocks: Vec<Block>, discs: &[(Vec2, f64)]) -> BlockModel {
    let particle = |&(centre, radius): &(Vec2, f64)| Particle { centre, radius, density: DENSITY, group: GroupId(1) };
    BlockModel {
        blocks: blocks.into_iter().collect(),
        particles: discs.iter().map(particle).collect::<Table<_, _>>(),
        groups: ["wall".to_string(), "fill".to_string()].into_iter().collect(),
        laws: LawTable::uniform(2, law),
        gravity,
    }
}

pub fn wall(corner: Vec2, width: f64, height: f64) -> Block {
    let outline = Polygon::rectangle(corner, width, height).unwrap();
    Block { outline, rounding: 0.0, density: 2000.0, group: GroupId(0), held: Held::FIXED }
}

/// Four walls around a room from the origin.
pub fn room(width: f64, height: f64) -> Vec<Block> {
    let t = 0.3;
    vec![
        wall(vec2(-t, -t), width + 2.0 * t, t),
        wall(vec2(-t, 0.0), t, height),
        wall(vec2(width, 0.0), t, height),
        wall(vec2(-t, height), width + 2.0 * t, t),
    ]
}

pub fn mass(radius: f64) -> f64 {
    DENSITY * std::f64::consts::PI * radius * radius
}

/// A model that moves.
pub struct Moving {
    pub model: Model,
    pub state: State,
    pub work: Workspace,
    pub settings: Settings,
}

impl Moving {
    pub fn new(world: &BlockModel, settings: Settings) -> Moving {
        let model = Model::new(world, &Loading::default()).unwrap();
        let state = begin(&model, &settings);
        Moving { model, state, work: Workspace::default(), settings }
    }
    pub fn step(&mut self) -> StepReport {
        step(&self.model, &mut self.state, &mut self.work, &self.settings)
    }
    pub fn run(&mut self, steps: usize) {
        (0..steps).for_each(|_| {
            self.step();
        });
    }
}
