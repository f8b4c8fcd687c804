//! What a checkpoint must contain.

use super::model::Model;
use super::outcome::ParticleState;
use super::particles::{Chunk, Particles};
use super::step::Workspace;
use super::touch::Touch;
use crate::ids::{Id, ParticleId, Table};
use crate::plane::{Pose, Vec2};
use serde::{Deserialize, Serialize};

/// Everything that changes during a run.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct State {
    /// Where each block is.
    pub poses: Vec<Pose>,
    /// Velocity [m/s], twice, and angular velocity [rad/s] of each block, half a step before the poses.
    pub velocities: Vec<[f64; 3]>,
    /// Forces [N/m], twice, and moment [N] that the contacts exert on each block.
    pub(super) contact_forces: Vec<[f64; 3]>,
    /// The same one step earlier.
    pub(super) previous_forces: Vec<[f64; 3]>,
    /// Pairs close enough to touch, sorted by their ids.
    pub(super) touches: Vec<Touch>,
    /// The particles and their contacts.
    pub(super) particles: Particles,
    /// Load factor.
    pub factor: f64,
    /// Load factor at which supports stand; it follows `factor` when they are moved.
    pub(super) support_factor: f64,
    /// Steps taken.
    pub steps: u64,
    /// Time step [s].
    pub time_step: f64,
    /// Largest distance that any point can have moved since pairs were last searched [m].
    pub(super) travel: f64,
    /// The same since the features of close pairs were last looked at [m].
    pub(super) feature_travel: f64,
    /// Damping coefficient of the adaptive and the viscous scheme [1/s].
    pub(super) viscosity: f64,
    /// Energy that the state held when it was taken over from a run of another model [J/m].
    pub(super) initial_energy: f64,
    /// Work that was done on the blocks by loads that have since changed [J/m], and by moved supports.
    pub(super) load_work: f64,
    pub(super) support_work: f64,
    /// Energy lost in friction, crushing and opened contacts, and to damping [J/m].
    pub(super) dissipated: f64,
    pub(super) damped: f64,
}

impl State {
    /// The particles one by one; stresses are left at zero, a frame has them.
    pub fn particles(&self, model: &Model) -> Table<ParticleId, ParticleState> {
        self.particles.states(&model.particles, &[])
    }
    /// Gives a particle a velocity [m/s] and an angular velocity [rad/s]; an unknown one is left out.
    pub fn set_particle_velocity(&mut self, model: &Model, particle: ParticleId, velocity: Vec2, spin: f64) {
        if let Some(&row) = model.particles.rows.get(particle.index()) {
            let disc = &mut self.particles.discs[row as usize];
            (disc.vx, disc.vy, disc.rim) = (velocity.x, velocity.y, spin * disc.radius);
        }
    }
    /// Bytes that the particles, their contacts and their search hold, the model's share included.
    pub fn particle_bytes(&self, model: &Model, work: &Workspace) -> usize {
        let Particles { discs, previous, chunks, .. } = &self.particles;
        let chunks: usize = chunks.iter().map(Chunk::bytes).sum();
        let rows = 64 * discs.capacity() + 24 * previous.capacity();
        chunks + rows + work.cells.bytes() + model.particles.len() * (4 + 4 + 24 + 1 + 8 + 16)
    }
}
