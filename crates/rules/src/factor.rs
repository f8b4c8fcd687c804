//! One factor with its source.

use crate::{Confidence, Source};
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

impl Factor {
    /// Whether it gives safety: above 1, and from a source. What is carried without such a factor on live loads shows no safety.
    pub fn is_safety(&self) -> bool {
        self.value > 1.0 && self.source.confidence != Confidence::Assumed
    }
}
