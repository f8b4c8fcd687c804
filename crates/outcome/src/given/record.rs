//! The record of a method: what tests to collapse carried of its predictions.

use crate::wire::plain;
use serde::{Deserialize, Serialize};

/// A bridge that was loaded to collapse, beside what limit analysis predicts of it from prior values.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct FieldTest {
    /// Name of its folder in `validation/`.
    pub name: String,
    /// Largest load of the test [kN].
    pub carried_kn: f64,
    /// Limit load with the expected prior values [kN].
    pub predicted_kn: f64,
    /// The same where joints never crush [kN].
    pub without_crushing_kn: f64,
    /// Whether every dimension was read in a source.
    pub read: bool,
    /// Whether it was no fair test of the arch.
    pub doubted: bool,
}

impl FieldTest {
    /// Every test of a record, as `published::record` writes it; none where the text is no such record.
    pub fn all(text: &str) -> Vec<FieldTest> {
        serde_json::from_str(text).unwrap_or_default()
    }
}

/// What tests to collapse carried of a method's predictions.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Tests with a prediction.
    pub tests: usize,
    /// Tests all of whose dimensions were read in a source.
    pub with_read_dimensions: usize,
    /// Least load of a test over its prediction.
    pub carried_share_least: f64,
    /// Median of them.
    pub carried_share_median: f64,
    /// Largest of them.
    pub carried_share_most: f64,
}

impl Record {
    /// In a sentence.
    pub fn words(&self) -> String {
        format!(
            "record: {} bridges tested to collapse carried {:.2} to {:.1} times the method's prediction, {:.2} in the median; {} with dimensions \
             that were read",
            self.tests,
            self.carried_share_least,
            self.carried_share_most,
            self.carried_share_median,
            self.with_read_dimensions
        )
    }
}

plain!(Record);
