//! Small models for the tests of the block engine.

use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, PointForce, Stiffness};
use mechanics::dem::{ContactLength, Damping, Model, Settings, State, StepReport, Workspace, begin, step};
use mechanics::ids::{BlockId, GroupId, Table};
use mechanics::plane::{Polygon, Vec2, vec2};

/// Gravity as in the reference values of the field.
pub(crate) const G: f64 = 9.81;

/// A dry joint whose points stand for half the joint each.
pub(crate) fn dry(normal: f64, shear: f64, friction_angle: f64) -> ContactLaw {
    ContactLaw {
        normal: Stiffness::Given(normal),
        shear: Stiffness::Given(shear),
        friction: friction_angle.to_radians().tan(),
        cohesion: 0.0,
        tension: 0.0,
        crushing: f64::INFINITY,
        fixed_length: None,
        least_length: 0.01,
    }
}

pub(crate) fn settings(damping: Damping) -> Settings {
    Settings {
        damping,
        contact_length: ContactLength::Fixed,
        tolerance: 1e-5,
        step_limit: 2_000_000,
        time_step_factor: 0.9,
        scaled_inertia: false,
    }
}

/// Blocks of one group, one law.
pub(crate) struct Scene {
    pub blocks: Table<BlockId, Block>,
    pub law: ContactLaw,
    pub rounding: f64,
    pub density: f64,
    pub gravity: Vec2,
    pub loading: Loading,
}

impl Scene {
    pub(crate) fn new(law: ContactLaw) -> Scene {
        Scene {
            blocks: Table::default(),
            law,
            rounding: 0.01,
            density: 2000.0,
            gravity: vec2(0.0, -G),
            loading: Loading::default(),
        }
    }
    pub(crate) fn polygon(&mut self, corners: Vec<Vec2>, held: Held) -> BlockId {
        self.blocks.push(Block {
            outline: Polygon::new(corners).unwrap(),
            rounding: self.rounding,
            density: self.density,
            group: GroupId(0),
            held,
        })
    }
    pub(crate) fn rectangle(&mut self, corner: Vec2, width: f64, height: f64, held: Held) -> BlockId {
        let outline = Polygon::rectangle(corner, width, height).unwrap();
        self.polygon(outline.vertices().to_vec(), held)
    }
    /// A free block.
    pub(crate) fn brick(&mut self, corner: Vec2, width: f64, height: f64) -> BlockId {
        self.rectangle(corner, width, height, Held::FREE)
    }
    /// A held block whose top lies at y = 0.
    pub(crate) fn floor(&mut self, from: f64, to: f64) -> BlockId {
        self.rectangle(vec2(from, -0.5), to - from, 0.5, Held::FIXED)
    }
    pub(crate) fn push(&mut self, block: BlockId, at: Vec2, force: Vec2) {
        self.loading.permanent.push(PointForce { block, at, force });
    }
    pub(crate) fn model(&self) -> BlockModel {
        let mut groups: Table<GroupId, String> = Table::default();
        groups.push("all".to_string());
        BlockModel {
            blocks: self.blocks.clone(),
            particles: Table::default(),
            groups,
            laws: LawTable::uniform(1, self.law),
            gravity: self.gravity,
        }
    }
    pub(crate) fn weight(&self, block: BlockId) -> f64 {
        self.blocks[block].mass() * self.gravity.norm()
    }
    pub(crate) fn begin(&self, settings: Settings) -> Motion {
        let model = Model::new(&self.model(), &self.loading).unwrap();
        let state = begin(&model, &settings);
        Motion { model, state, settings, work: Workspace::default() }
    }
}

/// A run through the public steps.
pub(crate) struct Motion {
    pub model: Model,
    pub state: State,
    pub settings: Settings,
    pub work: Workspace,
}

impl Motion {
    pub(crate) fn step(&mut self) -> StepReport {
        let report = step(&self.model, &mut self.state, &mut self.work, &self.settings);
        assert!(report.moved.is_finite(), "a number broke in step {}", self.state.steps);
        report
    }
    pub(crate) fn steps(&mut self, count: u64) {
        for _ in 0..count {
            self.step();
        }
    }
    /// Steps for `time` [s] and returns how many steps that was.
    pub(crate) fn run(&mut self, time: f64) -> u64 {
        let count = (time / self.state.time_step).round() as u64;
        self.steps(count);
        count
    }
    /// Steps until local damping has taken the motion out: a bound on any point's move falls below `moved` [m].
    pub(crate) fn rest(&mut self, moved: f64) {
        let damping = std::mem::replace(&mut self.settings.damping, Damping::Local(0.7));
        let mut quiet = 0;
        for _ in 0..1_000_000 {
            quiet = if self.step().moved < moved { quiet + 1 } else { 0 };
            if quiet > 50 {
                self.settings.damping = damping;
                return;
            }
        }
        panic!("the blocks never came to rest");
    }
    pub(crate) fn position(&self, block: BlockId) -> Vec2 {
        self.state.poses[block.0 as usize].position
    }
    pub(crate) fn velocity(&self, block: BlockId) -> [f64; 3] {
        self.state.velocities[block.0 as usize]
    }
    pub(crate) fn angle(&self, block: BlockId) -> f64 {
        let turn = self.state.poses[block.0 as usize].rotation;
        turn.sin.atan2(turn.cos)
    }
}
