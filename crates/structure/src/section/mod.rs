//! From a surveyed section of an intrados, points in a table, to the profile of a bridge file.

mod faces;
mod fit;
mod ground;
mod read;
mod write;

pub use fit::fit;
pub use read::{LengthUnit, Table, read};
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
    /// Longer than any arch, or shorter: another unit was meant.
    #[error(
        "the section is {} long with its numbers in {unit}, and no arch is: {}",
        length(*span),
        likely(candidates)
    )]
    Unlikely {
        /// Length along the bridge [m].
        span: f64,
        /// The unit that it was read in.
        unit: &'static str,
        /// Units that would make an arch of it, with its length in them [m].
        candidates: Vec<(&'static str, f64)>,
    },
    /// Too few points.
    #[error("{} for a curve with its scatter: {least} or more, better hundreds", too_few(*count))]
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

fn too_few(count: usize) -> String {
    format!("{} {} too few", findings::words::counted(count, "point"), findings::words::verb(count, "is", "are"))
}

/// A length in words [m].
fn length(value: f64) -> String {
    if value >= 10.0 { format!("{value:.0} m") } else { format!("{value:.3} m") }
}

/// What to write where another unit was meant.
fn likely(candidates: &[(&'static str, f64)]) -> String {
    match candidates {
        [] => "is it one section, cut along the bridge's axis, with distances along the bridge in the first column?"
            .to_owned(),
        all => {
            let words = |(unit, span): &(&str, f64)| {
                format!("in {unit} it is {span:.3} m: head the columns x_{unit},y_{unit}, or give --unit {unit}")
            };
            all.iter().map(words).collect::<Vec<_>>().join("; ")
        }
    }
}

#[cfg(test)]
mod tests;
