//! The one place where what an engineer wrote or drew meets its mechanics.

pub mod analysis;
pub mod assessment;
pub mod blocks;
pub mod chain;
pub mod checkpoint;
pub mod checks;
pub mod condition;
pub mod discretise;
pub mod disks;
pub mod footing;
pub mod outcome;
pub mod packing_file;
pub mod vary;
pub mod vehicles;
// It reads files and a clock.
#[cfg(not(target_family = "wasm"))]
pub mod verify;
pub mod warning;
pub mod wire;

/// Parameters from channels: the plain data of searches and posteriors, which outcomes hold.
pub use calibrate;
/// Records: findings and what was done, which outcomes hold.
pub use records;
/// Load models and rules: the plain data that sweeps of vehicles hold.
pub use rules;

#[cfg(test)]
mod samples;
