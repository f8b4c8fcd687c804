//! What a run may be told.

use crate::contact::ContactLength;
use crate::ids::BlockId;
use crate::plane::Vec2;
use serde::Serialize;

/// Numerical damping; it takes energy out until the blocks rest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum Damping {
    /// Local, non-viscous: each motion is opposed by this share (0 to 1) of its out-of-balance force.
    Local(f64),
    /// Global viscous, mass-proportional: this share of critical damping in the lowest mode.
    Viscous(f64),
    /// Global viscous whose intensity follows the motion.
    Adaptive,
    /// None: for dynamics.
    None,
}

/// Settings of the discrete element method.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Settings {
    /// Numerical damping.
    pub damping: Damping,
    /// Length of a contact point.
    pub contact_length: ContactLength,
    /// Out-of-balance force at rest, relative to the acting forces.
    pub tolerance: f64,
    /// Most iterations in one stage; reaching it without rest or collapse is a named outcome.
    pub step_limit: u64,
    /// Share of the critical time step.
    pub time_step_factor: f64,
    /// Whether particles that are stiffer held than most are given more inertia (never more weight), so that a few of them
    /// do not set the time step of all: for states at rest, not for motions.
    pub scaled_inertia: bool,
}

/// What is done to the blocks after their own weight has come to rest.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Program {
    /// Increment of the load factor.
    pub increment: f64,
    /// Largest load factor tried.
    pub limit: f64,
    /// Refine the collapse factor to this resolution by returning to the last stable state.
    pub resolution: Option<f64>,
    /// The block and the point on it (as built) [m] whose displacement the path records.
    pub watched: (BlockId, Vec2),
}
