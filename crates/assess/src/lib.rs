//! The one place where a bridge meets its mechanics.

pub mod discretise;
pub mod outcome;

#[cfg(test)]
mod samples;
