//! Warnings of other results.

use super::Warning;
use crate::note::{listed, notes};

notes! {
    /// A warning that another result has.
    Passed {
        /// The strip below the spandrel walls.
        OfWalls { warning: Box<Warning> } => "strip of the walls: {warning}";
        /// Some cases of a file.
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
