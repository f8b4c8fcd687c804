//! Arguments of the analyses of a bridge file.

use super::choice::Choice;
use super::words::{seconds, times, word};
use crate::shards::Sharing;
use bridge::update::{Search, Start, Variant};
use clap::Args;
use extrados::StageName;
use std::path::PathBuf;

/// `extrados collapse`.
#[derive(Debug, Args)]
pub(crate) struct Collapse {
    /// The bridge file or block model file (TOML)
    pub file: PathBuf,
    /// Say everything: every number, every check, every warning and assumption
    #[arg(long)]
    pub details: bool,
    /// Folder for results [default: out/NAME]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Which analysis.
    #[command(flatten)]
    pub choice: Choice,
    /// Move the loads over the whole bridge by limit analysis and draw the envelope; with --method path on deformable joints too
    #[arg(long)]
    pub sweep: bool,
    /// Distance between the positions of a sweep, such as "0.25 m"
    #[arg(long, value_name = "LENGTH", requires = "sweep", allow_hyphen_values = true)]
    pub sweep_step: Option<String>,
    /// How many times larger displacements are in deformed.dxf [default: as in the figures]
    #[arg(long, value_name = "TIMES", value_parser = times)]
    pub displacement_scale: Option<f64>,
    /// Take up the checkpoint of an interrupted run
    #[arg(long)]
    pub resume: bool,
    /// Keep a checkpoint this often
    #[arg(long, value_name = "SECONDS", default_value_t = 2.0, value_parser = seconds)]
    pub keep_every: f64,
}

/// `extrados cases`.
#[derive(Debug, Args)]
pub(crate) struct Cases {
    /// The bridge file (.toml), with named cases
    pub file: PathBuf,
    /// Folder for results [default: out/NAME]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Which analysis, in place of the file's plan.
    #[command(flatten)]
    pub choice: Choice,
}

/// `extrados compare`.
#[derive(Debug, Args)]
pub(crate) struct Compare {
    /// The bridge file before, such as before a repair
    pub before: PathBuf,
    /// The bridge file after
    pub after: PathBuf,
    /// Folder for results [default: out/BEFORE-and-AFTER]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Which analysis, in place of the plans of both files.
    #[command(flatten)]
    pub choice: Choice,
}

/// `extrados vary`.
#[derive(Debug, Args)]
pub(crate) struct Vary {
    /// The bridge file (TOML)
    pub file: PathBuf,
    /// Folder for results and finished runs [default: out/NAME-vary]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// What to vary: "joint.friction_angle=30deg..40deg:5", or values with commas; in place of the file's [[vary]]
    #[arg(long, value_name = "PATH=VALUES")]
    pub set: Vec<String>,
    /// What to vary, from the [[vary]] tables of another file
    #[arg(long, value_name = "FILE", conflicts_with = "set")]
    pub ranges: Option<PathBuf>,
    /// Every value of each quantity with every value of all others, in place of one quantity after the other
    #[arg(long)]
    pub grid: bool,
    /// Refuse to start more runs than this
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub most_runs: u32,
    /// Repeat the sweep of vehicles, or of the file's loads, in place of the analysis at one position
    #[arg(long)]
    pub sweep: bool,
    /// The number that figures and sensitivities are about, such as max_compressive_stress_mpa; of sweeps adequacy_factor,
    /// load_factor, governing_position_m
    #[arg(long, value_name = "NAME")]
    pub outcome: Option<String>,
    /// Only list the quantities that can be varied
    #[arg(long)]
    pub list: bool,
    /// Whether it is one of several.
    #[command(flatten)]
    pub sharing: Sharing,
    /// Which analysis.
    #[command(flatten)]
    pub choice: Choice,
}

/// `extrados update`.
#[derive(Debug, Args)]
pub(crate) struct Update {
    /// The bridge file (TOML), with [records] and [[parameter]] beside its [passage]
    pub file: PathBuf,
    /// Folder for results and the log of evaluations [default: out/NAME]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Which search, in place of the file's
    #[arg(long, value_parser = word::<Search>())]
    pub search: Option<Search>,
    /// Reading of the hierarchical search, in place of the file's
    #[arg(long, value_parser = word::<Variant>())]
    pub variant: Option<Variant>,
    /// Where the hierarchical and the gradient search begin, in place of the file's
    #[arg(long, value_parser = word::<Start>())]
    pub start: Option<Start>,
    /// Take up the evaluations of an interrupted run
    #[arg(long)]
    pub resume: bool,
    /// Judge the records beside one passage of the start model, and seek nothing
    #[arg(long, conflicts_with_all = ["search", "variant", "start", "resume"])]
    pub records_only: bool,
}

/// `extrados assess`.
#[derive(Debug, Args)]
pub(crate) struct Assess {
    /// The bridge file (TOML), or a folder of bridge files
    pub file: PathBuf,
    /// Say everything: every number, every check, every warning and assumption
    #[arg(long)]
    pub details: bool,
    /// Folder for report, results and finished stages [default: out/NAME; out/NAME-fleet for a folder]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Leave a stage out
    #[arg(long, value_name = "STAGE", value_parser = word::<StageName>())]
    pub skip: Vec<StageName>,
    /// Take up the finished stages of an interrupted run; they are taken up without it too
    #[arg(long)]
    pub resume: bool,
    /// Write report.pdf too, for A4: by extrados-pdf where it lies beside this program, else by Chromium, Chrome or Edge
    #[arg(long)]
    pub pdf: bool,
    /// Take photographs from outside the folder of the bridge file into the report
    #[arg(long)]
    pub allow_outside: bool,
    /// Of a folder: whether it is one of several.
    #[command(flatten)]
    pub sharing: Sharing,
}

/// `extrados calibrate-fill`.
#[derive(Debug, Args)]
pub(crate) struct CalibrateFill {
    /// The bridge file (TOML), with a layer as particles
    pub file: PathBuf,
    /// Modulus that the fill is to have, in place of the file's, such as "40 MPa"
    #[arg(long, value_name = "STRESS", allow_hyphen_values = true)]
    pub modulus: Option<String>,
    /// Packings that samples are cut from, in place of the file's; the check takes as many again
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub seeds: Option<u32>,
    /// Folder for results [default: out/NAME]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}
