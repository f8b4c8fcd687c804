//! Warnings of other results.

use super::Warning;
use crate::sentences::{listed, notes};

notes! {
    /// A warning that another result has.
    Passed {
        OfWalls { warning: Box<Warning> } => "strip of the walls: {warning}";
        OfCases { cases: Vec<String>, warning: Box<Warning> } => "{}: {warning}", listed(cases);
    }
}

impl Passed {
    /// The code of the warning.
    pub fn code(&self) -> &'static str {
        match self {
            Passed::OfWalls { warning } | Passed::OfCases { warning, .. } => warning.code(),
        }
    }
}
