//! The stages of an assessment: each makes one analysis and keeps its facts. Whoever calls them keeps finished ones.

mod sensitivity;
mod service;
mod shortened;
mod ultimate;
mod updated;
mod vehicles;

pub use crate::analysis::passage::Scope;
pub use sensitivity::sensitivity;
pub use service::service;
pub use ultimate::{Ultimate, movement, movement_facts, ultimate};
pub use updated::with_parameters;
pub use vehicles::vehicle_facts;
