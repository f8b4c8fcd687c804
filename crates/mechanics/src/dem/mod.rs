//! Discrete elements: rigid blocks in deformable point contact, stepped in time to rest or to collapse.
//!
//! The method is that of Cundall (1971) for blocks as Rouxinol, Providência and Lemos use it for masonry arches:
//! Newton's law for each block and a force-displacement law at each contact point, in turn, with numerical damping,
//! until the out-of-balance force vanishes or the blocks keep moving.

mod account;
mod end;
mod kept;
mod model;
mod outcome;
mod packing;
mod particles;
mod relax;
mod run;
mod search;
mod settings;
mod state;
mod step;
mod stepping;
mod stiffness;
mod take_over;
mod touch;

pub use crate::contact::ContactLength;
pub use account::{contacts, energy, frame, stresses};
pub use model::Model;
pub use outcome::{Body, ContactState, Energy, Frame, Outcome, ParticleContact, ParticleState, PathPoint, Status};
pub use packing::{Grain, Packed, Packing, PackingError, Recipe, Target, pack};
pub use particles::Disc;
pub use run::{Rested, collapse, collapse_from, rest};
pub use settings::{Damping, Program, Settings};
pub use state::State;
pub use step::{StepReport, Workspace, begin, critical_time_step, exact_critical_time_step, step};
pub use stepping::Stepping;
pub use take_over::take_over;
