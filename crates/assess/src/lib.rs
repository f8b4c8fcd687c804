//! The one place where a bridge meets its mechanics.

pub mod analysis;
pub mod discretise;
pub mod outcome;
pub mod warning;

#[cfg(test)]
mod samples;
