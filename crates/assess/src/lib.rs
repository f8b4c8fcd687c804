//! The one place where what an engineer wrote or drew meets its mechanics.

pub mod analysis;
pub mod blocks;
pub mod checkpoint;
pub mod discretise;
pub mod disks;
pub mod footing;
pub mod outcome;
pub mod packing_file;
pub mod vary;
pub mod verify;
pub mod warning;
pub mod wire;

#[cfg(test)]
mod samples;
