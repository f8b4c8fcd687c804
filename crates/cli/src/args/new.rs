//! `extrados new`.

use clap::Args;
use std::path::PathBuf;

/// `extrados new`.
#[derive(Debug, Args)]
#[command(after_help = crate::commands::examples_of_new())]
pub(crate) struct New {
    /// The folder to write; it must be new or empty
    pub dir: PathBuf,
    /// A working example instead [default without a survey: bridgemill]
    #[arg(long, value_name = "NAME", conflicts_with_all = ["span", "rise", "ring"])]
    pub from: Option<String>,
    /// What was measured.
    #[command(flatten)]
    pub survey: Survey,
}

/// What a survey measured; a bare number is in metres, kg/m3, MPa or kN.
#[derive(Debug, Args)]
#[command(next_help_heading = "Your bridge (a bare number is in m, kg/m3, MPa or kN)")]
pub(crate) struct Survey {
    /// Clear span between the springings, at the intrados
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, requires_all = ["rise", "ring", "width", "cover"])]
    pub span: Option<String>,
    /// Rise of the crown's intrados above the springings
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, requires = "span")]
    pub rise: Option<String>,
    /// Thickness of the ring
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, requires = "span")]
    pub ring: Option<String>,
    /// Width of the barrel that carries the road, between the parapets
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, requires = "span")]
    pub width: Option<String>,
    /// Depth of fill and surfacing over the crown
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, requires = "span")]
    pub cover: Option<String>,
    /// Name of the bridge [default: that of the folder]
    #[arg(long, value_name = "NAME", requires = "span")]
    pub name: Option<String>,
    /// Height of solid backing above the springings
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, requires = "span")]
    pub backing: Option<String>,
    /// Density of the masonry
    #[arg(long, value_name = "DENSITY", allow_hyphen_values = true, requires = "span")]
    pub density: Option<String>,
    /// Compressive strength of the masonry
    #[arg(long, value_name = "STRENGTH", allow_hyphen_values = true, requires = "span")]
    pub strength: Option<String>,
    /// Length of a stone or brick along the ring
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, requires = "span")]
    pub stone: Option<String>,
    /// Force of the axle whose multiple is sought
    #[arg(long, value_name = "FORCE", allow_hyphen_values = true, requires = "span")]
    pub axle: Option<String>,
    /// How many arches stand in a row, all alike
    #[arg(long, value_name = "COUNT", allow_hyphen_values = true, requires_all = ["span", "pier_width", "pier_height"])]
    pub spans: Option<String>,
    /// Width of a pier along the road, at its top
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, requires = "spans")]
    pub pier_width: Option<String>,
    /// Height of a pier, from the springings to the ground
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, requires = "spans")]
    pub pier_height: Option<String>,
    /// Rule that the bridge is judged by, such as cs-454
    #[arg(long, value_name = "RULE", requires = "span")]
    pub rule: Option<String>,
    /// Vehicle or load model; repeat the flag, or write commas, for more [default: every one that goes with the rule]
    #[arg(long, value_name = "NAME", value_delimiter = ',', requires = "rule")]
    pub vehicle: Vec<String>,
}
