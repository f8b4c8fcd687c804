//! Discrete elements: rigid blocks in deformable point contact, stepped in time to rest or to collapse.

mod outcome;
mod settings;

pub use outcome::{ContactState, Energy, Frame, Outcome, PathPoint, Status};
pub use settings::{ContactLength, Damping, Program, Settings};
