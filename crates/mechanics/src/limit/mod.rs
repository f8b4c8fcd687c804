//! Limit analysis of rigid blocks: the load at which the blocks become a mechanism.
//!
//! The static theorem makes it a convex program. Of all joint forces in equilibrium with the permanent loads and
//! `factor` times the variable loads, and within the strength of every joint, find those with the largest factor:
//!
//! ```text
//! maximise factor   subject to   B f + factor p + w = 0,   f within strength
//! ```
//!
//! The multipliers of the equilibrium equations are the velocities of the collapse mechanism (Livesley 1978; Gilbert
//! and Melbourne 1994). The geometry is that of the blocks as built, and joints are infinitely stiff.
//!
//! Read in the order of the method: `joints` gather the strength, `equilibrium` sets up `B`, `p` and `w`,
//! `program` solves, `bounds` recomputes both bounds from what was returned, `mechanism` says what moves.

mod bedded;
mod bounds;
mod boxed;
mod collapse;
mod compliance;
pub mod continuum;
mod equilibrium;
mod ground;
mod interior_point;
mod inverse;
mod joints;
mod level;
mod mechanism;
mod outcome;
mod program;
mod proven;
mod reduced;
mod rest;
mod rows;
mod settings;
mod simplex;
mod smooth;
mod stiff;
mod support_movement;
mod sweeper;
mod thickness;
mod thrust_zone;

pub use collapse::{collapse_load, collapse_load_while};
pub use ground::{Effect, Ground, Section};
pub use outcome::{Hinge, JointForces, JointMotion, Mechanism, Outcome, PointForces, Resultant, Status};
pub use settings::{ContactPoints, Friction, Settings};
pub use support_movement::{Increments, MovementOutcome, MovementStatus, MovementStep, support_movement};
pub use sweeper::{Experience, Factor, Least, Sweeper};
pub use thickness::{LeastThickness, ThicknessStatus, minimum_thickness};
pub use thrust_zone::{ThrustZone, least_thrust, thrust_zone};
