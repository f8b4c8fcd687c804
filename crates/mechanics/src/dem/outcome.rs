//! What a run reports.

use crate::ids::{BlockId, ParticleId, Table};
use crate::plane::{Pose, Vec2};
use serde::{Deserialize, Serialize};

/// How a run ended. All of these are answers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Status {
    /// A load step set the blocks moving without end.
    Collapsed,
    /// Every load up to the limit was carried.
    StableToLastLoad,
    /// A load step neither came to rest nor collapsed: the out-of-balance force oscillates.
    Stalled,
    /// The blocks do not stand under their own weight.
    UnstableUnderSelfWeight,
    /// A stage used up its iterations while still settling.
    StepLimit,
    /// The onlooker stopped the run; its state can be resumed.
    Cancelled,
    /// A number stopped being finite, a block ran away within one step, or the blocks gained energy out of nothing: the
    /// answer would be about the time step, not about the blocks.
    Broken {
        /// The body where it was seen first; the fastest one where only the energy tells.
        body: Body,
        /// The iteration.
        step: u64,
    },
}

/// One load step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PathPoint {
    /// Load factor.
    pub factor: f64,
    /// Displacement of the watched point since it was built [m].
    pub displacement: Vec2,
    /// Iterations of this step.
    pub iterations: u64,
    /// Out-of-balance force at the end of the step, relative to the acting forces.
    pub unbalanced_ratio: f64,
    /// Whether the step came to rest.
    pub at_rest: bool,
}

/// One closed contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ContactState {
    /// First block.
    pub first: BlockId,
    /// Second block.
    pub second: BlockId,
    /// Where [m].
    pub point: Vec2,
    /// Unit normal from the first to the second block.
    pub normal: Vec2,
    /// Compression [N/m], positive.
    pub compression: f64,
    /// Shear [N/m], positive when the force on the second block acts along `normal.left()`.
    pub shear: f64,
    /// Length the contact stands for [m].
    pub length: f64,
    /// Whether it slides.
    pub sliding: bool,
}

/// A block or a particle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Body {
    /// A particle.
    Particle(ParticleId),
    /// A block.
    Block(BlockId),
}

/// One closed contact of a particle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ParticleContact {
    /// The particle.
    pub particle: ParticleId,
    /// What it touches.
    pub partner: Body,
    /// Where [m].
    pub point: Vec2,
    /// Unit normal from the partner to the particle.
    pub normal: Vec2,
    /// Compression [N/m], positive.
    pub compression: f64,
    /// Shear [N/m], positive when the force on the particle acts along `normal.left()`.
    pub shear: f64,
    /// Length that the contact stands for [m].
    pub length: f64,
    /// Whether it slides.
    pub sliding: bool,
}

impl ParticleContact {
    /// Force on the particle [N/m]; its opposite acts on the partner.
    pub fn force(&self) -> Vec2 {
        self.normal * self.compression + self.normal.left() * self.shear
    }
}

/// A particle at one moment.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct ParticleState {
    /// Centre [m].
    pub centre: Vec2,
    /// Radius [m].
    pub radius: f64,
    /// Angle turned since it was built [rad].
    pub angle: f64,
    /// Velocity of the centre [m/s].
    pub velocity: Vec2,
    /// Angular velocity [rad/s].
    pub spin: f64,
    /// Average stress [Pa], tension positive: xx, yy, xy.
    pub stress: [f64; 3],
}

/// The blocks at one moment.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Frame {
    /// Load factor.
    pub factor: f64,
    /// Iterations since the start of the run.
    pub iterations: u64,
    /// Where the blocks are.
    pub poses: Table<BlockId, Pose>,
    /// Velocity of the centre of mass [m/s] and angular velocity [rad/s] of each block.
    pub velocities: Table<BlockId, (Vec2, f64)>,
    /// Closed contacts, sorted by blocks.
    pub contacts: Vec<ContactState>,
    /// Average stress in each block [Pa], tension positive: xx, yy, xy (divergence theorem).
    pub stresses: Table<BlockId, [f64; 3]>,
    /// The particles.
    pub particles: Table<ParticleId, ParticleState>,
    /// Their closed contacts, in the order of memory.
    pub particle_contacts: Vec<ParticleContact>,
}

/// Where the energy went [J per metre of width].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energy {
    /// What the state held when it was taken over from a run of another model.
    pub initial: f64,
    /// Work of gravity.
    pub gravity: f64,
    /// Work of the loads.
    pub loads: f64,
    /// Work of imposed support movements.
    pub supports: f64,
    /// Kinetic energy now.
    pub kinetic: f64,
    /// Elastic energy in the contacts now.
    pub elastic: f64,
    /// Dissipated in friction, crushing and opened contacts.
    pub dissipated: f64,
    /// Taken out by numerical damping.
    pub damped: f64,
}

impl Energy {
    /// What the account does not explain: work done minus what became of it.
    pub fn drift(&self) -> f64 {
        self.initial + self.gravity + self.loads + self.supports
            - self.kinetic
            - self.elastic
            - self.dissipated
            - self.damped
    }
}

/// The result of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// How it ended.
    pub status: Status,
    /// Last load factor that came to rest; `None` when not even the self-weight did.
    pub last_stable_factor: Option<f64>,
    /// Smallest load factor that collapsed or stalled.
    pub collapse_factor: Option<f64>,
    /// Load steps in order; the first is the self-weight (factor 0).
    pub path: Vec<PathPoint>,
    /// Frames worth drawing: each load step at rest, then the collapse in a few pictures.
    pub frames: Vec<Frame>,
    /// Index into `frames` of the last stable state.
    pub last_stable_frame: Option<usize>,
    /// Largest compressive stress at rest over all load steps [Pa].
    pub max_compressive_stress: f64,
    /// Iterations in all.
    pub iterations_total: u64,
    /// Time step used [s].
    pub time_step: f64,
    /// Critical time step from the largest eigenvalue of the contact stiffness system [s].
    pub critical_time_step: f64,
    /// Critical time step from the one-degree-of-freedom estimate [s].
    pub single_mass_time_step: f64,
    /// The energy account.
    pub energy: Energy,
}
