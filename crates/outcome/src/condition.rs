//! Condition: what records say of the bridge's materials.

use crate::wire::published;
use crate::words::words;
use serde::{Deserialize, Serialize};

words! {
    /// How an identified parameter stands to what is expected.
    pub enum Standing {
        /// Within the expected range.
        AsExpected = "as-expected",
        /// Below it.
        Lower = "lower-than-expected",
        /// Above it.
        Higher = "higher-than-expected",
        /// The records do not tell it, or it stands on a bound of the search.
        Untold = "not-told-by-the-records",
        /// The file expects nothing of it.
        NothingExpected = "nothing-expected",
    }
}

published! {
    /// One parameter.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Condition |one| {
        /// Its name.
        pub parameter: String,
        /// Unit of the numbers.
        pub unit: String,
        /// Before the update.
        pub before: f64,
        /// After it.
        pub after: Option<f64> as value,
        /// Lower end of the expected range.
        = expected_lower: Option<f64> = one.expected.map(|range| range[0]),
        /// Upper end of it.
        = expected_upper: Option<f64> = one.expected.map(|range| range[1]),
        /// The expected range, in the same unit.
        pub expected: Option<[f64; 2]> [kept],
        /// Where that range is from.
        pub source: Option<String> [kept],
        /// How it stands.
        pub standing: Standing as verdict,
        /// In words for an owner.
        pub words: String,
    }
}
