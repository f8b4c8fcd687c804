//! Arguments of `extrados respond`.

use super::words::word;
use bridge::passage::{PassageAnalysis, PassagePath};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// `extrados respond`.
#[derive(Debug, Args)]
pub(crate) struct Respond {
    /// The bridge file (TOML), with [train], [track] and [passage]
    pub file: PathBuf,
    /// Folder for results [default: out/NAME]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Speed of the train, in place of the file's, such as "65 km/h"
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    pub speed: Option<String>,
    /// Whether masses take part, in place of what the file says
    #[arg(long, value_parser = word::<PassageAnalysis>())]
    pub analysis: Option<PassageAnalysis>,
    /// How positions are solved, in place of what the file says
    #[arg(long, value_parser = word::<PassagePath>())]
    pub path: Option<PassagePath>,
    /// Write the channels as a logger would have, labelled synthetic, to this table (CSV); never over a measured record
    #[arg(long, value_name = "FILE")]
    pub records: Option<PathBuf>,
    /// How that record is taken.
    #[command(flatten)]
    pub logger: Logger,
}

/// How a synthetic record is taken.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "The synthetic record (with --records)")]
pub(crate) struct Logger {
    /// Noise of a logger, or none: the values as computed
    #[arg(long, value_name = "KIND", default_value = "logger", requires = "records")]
    pub noise: RecordNoise,
    /// Sampling rate [default: "200 Hz"; without noise, the times that were computed]
    #[arg(long, value_name = "FREQUENCY", allow_hyphen_values = true, requires = "records")]
    pub rate: Option<String>,
    /// Step to which values are rounded, once for displacements and once for strains [default: "0.01 mm", "0.05 microstrain"]
    #[arg(long, value_name = "STEP", allow_hyphen_values = true, requires = "records")]
    pub least_count: Vec<String>,
    /// Standard deviation of normal noise before rounding, likewise [default: one least count]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true, requires = "records")]
    pub deviation: Vec<String>,
    /// Seed of the noise: the same one gives the same record [default: 1]
    #[arg(long, value_name = "N", requires = "records")]
    pub seed: Option<u64>,
}

/// Noise of a synthetic record.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum RecordNoise {
    /// Normal noise, then rounding to the least count
    Logger,
    /// Neither noise nor rounding
    None,
}
