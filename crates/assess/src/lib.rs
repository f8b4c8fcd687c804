//! The one place where a bridge meets its mechanics.

pub mod outcome;
