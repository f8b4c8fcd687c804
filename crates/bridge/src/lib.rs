//! What an engineer wrote about a bridge: read, checked, named.
//!
//! Reading never fails and never computes: it returns what it understood together with everything that is wrong.

pub mod diagnostic;
pub mod model;
pub mod ring;

pub use diagnostic::{Diagnostic, Severity, TextRange};
pub use model::*;

/// What reading gives: the bridge if it can be used, and all findings.
#[derive(Debug, Clone)]
pub struct Read {
    /// The bridge, unless a finding is an error.
    pub bridge: Option<Bridge>,
    /// Every finding, in the order of the file.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a bridge file from its bytes (TOML, UTF-8).
pub fn read(_text: &[u8]) -> Read {
    todo!("bridge reader")
}
