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

/// What a survey measured; a bare number is in the unit of its question.
#[derive(Debug, Args)]
#[command(
    next_help_heading = "Your bridge (a bare number is in m, kg/m3, MPa, kN or deg; of --bond in kPa, of --lost-mortar in mm)"
)]
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
    /// Number of the structure in the owner's list
    #[arg(long, value_name = "NUMBER", requires = "span")]
    pub reference: Option<String>,
    /// Rings of the arch one above the other, which share its thickness
    #[arg(long, value_name = "COUNT", allow_hyphen_values = true, requires = "span")]
    pub rings: Option<String>,
    /// Cohesion between the rings: what it adds stands beside the load that leads, which is of rings that only rub [default: 0 kPa]
    #[arg(long, value_name = "STRESS", allow_hyphen_values = true, requires = "rings")]
    pub bond: Option<String>,
    /// Angle of skew, such as 12deg; 0 for a square bridge
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true, requires = "span")]
    pub skew: Option<String>,
    /// Material of the fill, of the library: old-fill, crushed-stone, hardcore, …
    #[arg(long, value_name = "MATERIAL", requires = "span")]
    pub fill: Option<String>,
    /// Density of fill and surfacing
    #[arg(long, value_name = "DENSITY", allow_hyphen_values = true, requires = "span")]
    pub fill_density: Option<String>,
    /// Depth of joints without mortar, at the intrados, such as 20mm
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, requires = "span")]
    pub lost_mortar: Option<String>,
    /// What the inspection found of the barrel, in words
    #[arg(long, value_name = "WORDS", requires = "span")]
    pub condition: Option<String>,
    /// Rule that the bridge is judged by, such as cs-454
    #[arg(long, value_name = "RULE", requires = "span")]
    pub rule: Option<String>,
    /// Vehicle or load model; repeat the flag, or write commas, for more [default: every one that goes with the rule]
    #[arg(long, value_name = "NAME", value_delimiter = ',', requires = "rule")]
    pub vehicle: Vec<String>,
}
