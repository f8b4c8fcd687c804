//! One factor with its source.

use crate::Source;
use serde::{Deserialize, Serialize};

/// A factor. A factor of 1 is written down like any other, with the reason why it is 1.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Factor {
    /// Its value.
    pub value: f64,
    /// Where it is from.
    pub source: Source,
}
