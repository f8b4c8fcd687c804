//! `test.toml`: what was measured when a bridge was loaded to collapse, from where, and how certain.

use serde::Deserialize;

bridge::choice! {
    /// How certain a value is.
    pub enum Mark {
        /// Read in the report of the test or its abstract.
        Read = "read",
        /// Read in a publication that quotes it.
        ReadSecondary = "read-secondary",
        /// Remembered, and read nowhere.
        Memory = "memory",
        /// Not even remembered: chosen, with the reason.
        Assumed = "assumed",
    }
}

impl Mark {
    /// Whether somebody read it.
    pub fn is_read(self) -> bool {
        match self {
            Mark::Read | Mark::ReadSecondary => true,
            Mark::Memory | Mark::Assumed => false,
        }
    }
}

/// A dimension of the bridge file and how certain it is.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct KnownDimension {
    /// Its key in the bridge file, rows by number from 0: `span.0.rise`.
    pub key: String,
    /// How certain it is.
    pub mark: Mark,
    /// The end of its interval that gives less load.
    pub weak: Option<toml::Value>,
    /// The end of its interval that gives more load.
    pub strong: Option<toml::Value>,
    /// Where it is from.
    pub source: String,
}

/// The test.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FieldTest {
    /// Bridge, place and year.
    pub title: String,
    /// Who describes it.
    pub source: String,
    /// Where the load stood and how it was brought in.
    pub load: String,
    /// Largest load on the whole width [kN].
    pub failure_load_kn: f64,
    /// How certain that is.
    pub failure_load_mark: Mark,
    /// How it failed.
    pub failed: String,
    /// Kind of its masonry in the priors.
    pub masonry: String,
    /// Kind of its fill in the priors.
    pub fill: String,
    /// What is known of its backing, as in the priors.
    pub backing: String,
    /// Why it may be no fair test of the methods.
    pub doubt: Option<String>,
    /// What else a reader should know.
    #[serde(default)]
    pub remarks: Vec<String>,
    /// Every dimension that the load depends on.
    pub dimension: Vec<KnownDimension>,
}

impl FieldTest {
    /// What is wrong with it, with its key.
    pub fn wrong(&self) -> Option<String> {
        if !(self.failure_load_kn > 0.0 && self.failure_load_kn.is_finite()) {
            return Some("failure_load_kn: write the largest load on the whole width in kN, above zero".into());
        }
        let words = [("title", &self.title), ("source", &self.source), ("load", &self.load), ("failed", &self.failed)];
        if let Some((key, _)) = words.into_iter().find(|(_, text)| text.trim().is_empty()) {
            return Some(format!("{key}: it is empty; say what is known"));
        }
        self.dimension.iter().find_map(|one| {
            let ends = (one.weak.is_some(), one.strong.is_some());
            let key = &one.key;
            match (one.mark.is_read(), ends) {
                (false, (true, true)) | (_, (false, false)) => None,
                (false, _) => Some(format!("dimension {key}: an interval has two ends; write weak and strong")),
                (true, _) => Some(format!("dimension {key}: what is read has no interval; remove weak and strong")),
            }
        })
    }

    /// Dimensions that nobody read.
    pub fn recalled(&self) -> impl Iterator<Item = &KnownDimension> {
        self.dimension.iter().filter(|one| !one.mark.is_read())
    }
}
