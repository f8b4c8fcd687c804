//! The stages of an assessment: each makes one analysis and keeps its facts. Whoever calls them keeps finished ones.

mod sensitivity;
mod service;
mod shortened;
mod ultimate;
mod updated;
mod vehicles;

pub use crate::analysis::passage::Scope;
pub use sensitivity::{SensitivityError, sensitivity};
pub use service::{NoRule, ServiceError, augment, probes, service, window};
pub use ultimate::{Ultimate, at_position, movement, movement_facts, ultimate};
pub use updated::with_parameters;

pub use vehicles::{vehicle_facts, vehicles};
