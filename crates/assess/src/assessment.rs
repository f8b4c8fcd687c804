//! Everything that is known of a bridge when it is judged: what its file says, and the facts of every stage. Checks,
//! condition and reports read this and nothing else.

use crate::wire::{MovementFacts, SensitivityFacts, ServiceFacts, UltimateFacts, UpdateFacts, VehicleFacts};
use bridge::Bridge;
use bridge::assess::Assess;

/// What became of a stage.
#[derive(Debug, Clone, PartialEq)]
pub enum Stage<T> {
    /// It was made.
    Made(T),
    /// The file does not ask for it, or has not what it needs: in words.
    NotAsked(String),
    /// It was asked for and came to no end: in words.
    Failed(String),
}

impl<T> Stage<T> {
    /// Its facts.
    pub fn made(&self) -> Option<&T> {
        match self {
            Stage::Made(facts) => Some(facts),
            _ => None,
        }
    }

    /// Why there are none.
    pub fn why_not(&self) -> Option<&str> {
        match self {
            Stage::Made(_) => None,
            Stage::NotAsked(why) | Stage::Failed(why) => Some(why),
        }
    }

    /// Whether it was asked for and came to no end.
    pub fn failed(&self) -> bool {
        matches!(self, Stage::Failed(_))
    }
}

/// A bridge with the facts of its stages.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessment {
    /// The bridge that was analysed: with updated parameters where records gave them.
    pub bridge: Bridge,
    /// What the file asks for.
    pub asked: Assess,
    /// Model updating.
    pub update: Stage<UpdateFacts>,
    /// Loads in service.
    pub service: Stage<ServiceFacts>,
    /// The file's loads at collapse.
    pub ultimate: Stage<UltimateFacts>,
    /// Vehicles moved over the bridge.
    pub vehicles: Stage<VehicleFacts>,
    /// A support that moves.
    pub movement: Stage<MovementFacts>,
    /// What changes the governing utilisation; it can only be made once there is one.
    pub sensitivity: Stage<SensitivityFacts>,
}
