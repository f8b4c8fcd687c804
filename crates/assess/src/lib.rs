//! The one place where a bridge meets its mechanics.

pub mod analysis;
pub mod checkpoint;
pub mod discretise;
pub mod disks;
pub mod outcome;
pub mod packing_file;
pub mod vary;
pub mod verify;
pub mod warning;
pub mod wire;

#[cfg(test)]
mod samples;
