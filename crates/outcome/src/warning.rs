//! Warnings of an analysis, each with a card that explains it.

mod calibration;
mod cards;
mod cover;
mod joints;
mod loads;
mod passed;
mod service;
mod soil;
mod vehicles;

pub use calibration::Calibration;
pub use cards::*;
pub use cover::Cover;
pub use joints::Joints;
pub use loads::Loads;
pub use passed::Passed;
pub use service::{Asked, Command, Service};
pub use soil::Yielding;
pub use vehicles::{Braking, BrokenPath, Lanes, OpenPositions, RecalledFactor, TooLong, Vehicles};

use crate::sentences::coded_subjects;
use crate::wire::{Unit, Wire};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

coded_subjects! {
    /// A warning of an analysis: its numbers; two that read the same are the same.
    #[derive(Debug, Clone, Serialize, Deserialize)]
    pub enum Warning {
        /// Calibrations of particles.
        Calibration,
        /// What a command says.
        Command,
        /// Fill, cover and shape.
        Cover,
        /// Joints and blocks.
        Joints,
        /// Loads that were found, or were not.
        Loads,
        /// Warnings of other results.
        Passed,
        /// Passages and updates.
        Service,
        /// Vehicles.
        Vehicles,
        /// Fill that yields.
        Yielding,
    }
}

impl Warning {
    /// Its sentence.
    pub fn message(&self) -> String {
        self.to_string()
    }
}

impl PartialEq for Warning {
    fn eq(&self, other: &Warning) -> bool {
        self.code() == other.code() && self.message() == other.message()
    }
}

impl Wire for Warning {
    fn wire(&self, _: Unit) -> Value {
        json!({ "code": self.code(), "message": self.message() })
    }
}
