//! What a path may be told.

use super::onset::Onset;
use crate::contact::ContactLength;
use crate::ids::BlockId;
use crate::plane::Vec2;
use serde::Serialize;

/// How the equilibrium path is followed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Settings {
    /// Where joints carry what presses them.
    pub contact_length: ContactLength,
    /// Largest gap at which two blocks share a joint [m].
    pub touching: f64,
    /// Out-of-balance force of a balanced state, relative to all acting forces.
    pub tolerance: f64,
    /// Most trial states on the way to a balanced one; where they do not do, a state closer by is sought.
    pub most_trials: u32,
    /// Most balanced states.
    pub most_steps: u32,
    /// How exactly the collapse load is told, relative to it.
    pub resolution: f64,
    /// Share of its load that the path loses past its peak before it ends.
    pub past: f64,
    /// How far blocks that lose their balance may move before they are taken to fall for good, as a share of their size.
    pub fallen: f64,
    /// How far the watched point may move [m].
    pub farthest: f64,
    /// States of which it is told at which load factor the path first meets them. They change nothing about the path.
    #[serde(skip)]
    pub onsets: Vec<Onset>,
}

impl Settings {
    /// Numbers that do for bridges.
    pub fn new(contact_length: ContactLength) -> Settings {
        Settings {
            contact_length,
            touching: 1e-6,
            tolerance: 1e-9,
            most_trials: 140,
            most_steps: 2000,
            resolution: 1e-5,
            past: 0.02,
            fallen: 0.5,
            farthest: f64::INFINITY,
            onsets: Vec::new(),
        }
    }
}

/// What is done to the blocks after their own weight.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Program {
    /// First increment of the load factor that is tried.
    pub increment: f64,
    /// Largest load factor.
    pub limit: f64,
    /// The block and the point on it (as built) [m] whose displacement the path records.
    pub watched: (BlockId, Vec2),
}
