//! Where a number is from, and how sure it is.

use serde::{Deserialize, Serialize};

/// Where numbers are from.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// Document and clause or table.
    pub text: String,
    /// Its year or edition.
    pub date: String,
    /// How sure the number is.
    pub confidence: Confidence,
    /// What else a reader should know.
    #[serde(default)]
    pub note: String,
}

/// How sure a number is, the surest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Confidence {
    /// Read in the source.
    Read,
    /// Calculated from what was read.
    Calculated,
    /// From memory: confirm it in the source before a verdict rests on it.
    Recalled,
    /// Chosen, because no source gives it; the note says why.
    #[default]
    Assumed,
}

impl Confidence {
    /// The word in files and reports.
    pub fn word(self) -> &'static str {
        match self {
            Confidence::Read => "read",
            Confidence::Calculated => "calculated",
            Confidence::Recalled => "recalled",
            Confidence::Assumed => "assumed",
        }
    }
}
