//! From a surveyed section of an intrados, points in a table, to the profile of a bridge file.

mod fit;
mod read;
mod write;

pub use fit::fit;
pub use read::{LengthUnit, read};
pub use write::{deviations, span_file};

use thiserror::Error;

/// Why a table is no section of an intrados.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SectionError {
    /// Rows that are no points.
    #[error("line {line}: {what}")]
    Row {
        /// Its line, from 1.
        line: usize,
        /// What is wrong with it.
        what: String,
    },
    /// The unit is not known.
    #[error("the table does not say its unit: head the columns x_m,y_m (or x_mm,y_mm), or give --unit")]
    NoUnit,
    /// Too few points.
    #[error("{count} points are too few for a curve with its scatter: {least} or more, better hundreds")]
    TooFew {
        /// How many there are.
        count: usize,
        /// How many there must be.
        least: usize,
    },
    /// Points that lie on no arch.
    #[error(
        "the points lie on no arch: {why}; the section needs distance along the bridge and height, up positive, of the intrados alone"
    )]
    NoArch {
        /// Why.
        why: &'static str,
    },
    /// Springings at different levels.
    #[error(
        "the ends of the section differ by {:.0} mm in height over a span of {span:.3} m: cut it at the springings, at equal levels",
        1e3 * tilt.abs()
    )]
    NotLevel {
        /// Height of the right end above the left one [m].
        tilt: f64,
        /// Horizontal distance of the ends [m].
        span: f64,
    },
}

#[cfg(test)]
mod tests;
