//! The one place where what an engineer wrote or drew meets its mechanics.

pub mod analysis;
pub mod chain;
pub mod checkpoint;
pub mod checks;
pub mod condition;
pub mod coverage;
pub mod evidence;
mod judged;
pub mod next;
pub mod plan_facts;
pub mod record;
pub mod vary;
pub mod vehicles;

#[cfg(test)]
mod published_tests;
#[cfg(test)]
#[path = "../../structure/src/samples.rs"]
mod samples;
