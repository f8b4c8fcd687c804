//! One factor with its source.

use crate::shape::table;
use crate::{Confidence, Source};

table! {
    /// A factor. A factor of 1 is written down like any other, with the reason why it is 1.
    pub struct Factor = "factor" {
        must value: f64, "the factor; 1 is written down like any other";
        must source: Source, "where it is from";
    }
}

impl Factor {
    /// Whether it gives safety: above 1, and from a source. What is carried without such a factor on live loads shows no safety.
    pub fn is_safety(&self) -> bool {
        self.value > 1.0 && self.source.confidence != Confidence::Assumed
    }
}
