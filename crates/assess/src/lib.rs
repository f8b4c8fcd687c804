//! The one place where what an engineer wrote or drew meets its mechanics.

pub mod analysis;
pub mod blocks;
pub mod chain;
pub mod checkpoint;
pub mod checks;
pub mod condition;
pub mod discretise;
pub mod disks;
pub mod evidence;
pub mod footing;
pub mod packing_file;
pub mod vary;
pub mod vehicles;
// It reads files and a clock.
#[cfg(not(target_family = "wasm"))]
pub mod verify;

#[cfg(test)]
mod published_tests;
#[cfg(test)]
mod samples;
