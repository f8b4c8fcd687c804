//! What the caller says of a file.

use super::dialect::Dialect;
use super::mapping::Mapping;

/// What the caller says of a file that is read.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReadOptions {
    /// Name of the run, commonly the file's; a comment line `# run: slow` in the file counts more.
    pub name: String,
    /// Speed of the train [m/s]; counts more than a comment line `# speed: 45 km/h`.
    pub speed: Option<f64>,
    /// Which column is which channel.
    pub mapping: Mapping,
    /// How the table is written.
    pub dialect: Dialect,
}
