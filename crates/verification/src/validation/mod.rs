//! Bridges that were loaded to collapse, predicted by every method from one stated set of prior values.
//!
//! A folder of tests holds `priors.toml` and a folder for each bridge with `bridge.toml` (its geometry and its load) and `test.toml`
//! (what was measured, from where, how certain). A bridge file has no materials of its own: they are put in from the priors, so that
//! no test can have values that were chosen for it.

mod corpus;
mod document;
mod field_test;
mod predict;
mod priors;
mod statistics;

pub use corpus::{Corpus, CorpusError, Test};
pub use document::{Level, Side};
pub use field_test::{FieldTest, KnownDimension, Mark};
pub use predict::{Answer, Job, gather, jobs, predict};
pub use priors::{Prior, Priors};
pub use statistics::bias;

#[cfg(test)]
mod tests;
