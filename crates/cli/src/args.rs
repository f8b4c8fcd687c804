//! What may be said on the command line.

mod analyses;
mod bench;
mod choice;
mod new;
mod respond;
mod words;

pub(crate) use analyses::{Assess, CalibrateFill, Cases, Collapse, Compare, Update, Vary};
pub(crate) use bench::{Bench, BenchName};
pub(crate) use new::{New, Survey};
pub(crate) use respond::{Logger, RecordNoise, Respond};

use crate::shards::Sharing;
use clap::{Args, Parser, Subcommand};
use outcome::validation::Predictor;
use std::path::PathBuf;

/// Masonry arch bridges: from a bridge file to a collapse load, by discrete elements and by limit analysis.
#[derive(Debug, Parser)]
#[command(
    name = "extrados",
    version = extrados::VERSION,
    about,
    after_help = "Start with: extrados new mybridge && extrados collapse mybridge/case-1.toml"
)]
pub(crate) struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// How to speak.
    #[command(flatten)]
    pub speech: Speech,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Write the file of your bridge from what a survey measured, or a working example to edit
    New(Box<New>),
    /// Read a bridge file, report every problem with its place, and draw the bridge; computes nothing
    Check(Check),
    /// Find the load, the thickness or the support movement that makes a mechanism of the bridge
    Collapse(Box<Collapse>),
    /// Find what each named case of a bridge file carries, side by side
    Cases(Box<Cases>),
    /// Compare two bridge files: what they say differently, and what each carries
    Compare(Box<Compare>),
    /// Convert between bridge files, block model files, drawings (DXF) and ParaView files (VTU), by extension
    Convert(Convert),
    /// Repeat an analysis over ranges of the file's quantities: table, tornado chart, curves
    Vary(Box<Vary>),
    /// Displacements, strains and stresses as a train passes
    Respond(Respond),
    /// Find the moduli of a bridge from the records of a train's passage, and which parameters they cannot identify
    Update(Update),
    /// Judge a bridge, or a folder of bridges, against the limits of its file, with a report
    Assess(Assess),
    /// Put the shards of a command together, as if it had run alone
    Merge {
        /// Folders of results of the shards
        #[arg(required = true, value_name = "DIR")]
        dirs: Vec<PathBuf>,
        /// Folder for the results of the whole
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
    },
    /// Find the contact stiffness of fill particles that gives the fill a wanted modulus
    CalibrateFill(CalibrateFill),
    /// Tell what an error, a warning or a status means, and find those and the keys of bridge files that are about some words
    Explain {
        /// A code such as B104, a status such as collapsed, or words such as ring separation; without any, all codes are listed
        words: Vec<String>,
    },
    /// List the vehicles and rules of the library: their names, loads, factors and sources
    Vehicles {
        /// A vehicle, a load model or a rule, such as lm71 or cs-454; without a name, all are listed
        name: Option<String>,
    },
    /// List the materials of the library: what is usual of masonry, joints, fill and backing, between which ends, and where that is from
    Materials {
        /// A material or a table of a bridge file, such as sandstone or masonry; without a name, all are listed
        name: Option<String>,
    },
    /// Print the JSON Schema of bridge files or block model files, for editors
    Schema(Schema),
    /// Run the verification cases and print their table
    Verify(Verify),
    /// Predict every field test of a folder by every method from one set of prior values: table and figure of prediction over test
    Validate(Validate),
    /// Open the interactive workbench, where loads are dragged over the bridge, in the browser of this machine
    Workbench(Workbench),
    /// Measure the speed of one method on this machine
    Bench(Bench),
    /// Print what makes a shell complete commands and flags
    Completions {
        /// Which shell
        shell: clap_complete::Shell,
    },
    /// Write the manual pages of all commands into a folder
    Man {
        /// The folder, such as share/man/man1
        dir: PathBuf,
    },
}

/// How a command speaks.
#[derive(Debug, Clone, Args)]
pub(crate) struct Speech {
    /// Print exactly one JSON object on stdout
    #[arg(long, global = true)]
    pub json: bool,
    /// No progress and no warnings on stderr
    #[arg(long, short, global = true)]
    pub quiet: bool,
    /// Where stderr is no terminal, say this often how far the run is; 0 for never
    #[arg(long, value_name = "SECONDS", default_value_t = 30.0, value_parser = words::seconds, global = true)]
    pub progress_every: f64,
    /// Threads to use [default: one per core]; the numbers are the same whatever it is
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024), global = true)]
    pub threads: Option<u16>,
}

/// `extrados check`.
#[derive(Debug, Args)]
pub(crate) struct Check {
    /// The bridge file or block model file (TOML)
    pub file: PathBuf,
    /// Folder for the drawing [default: out/NAME]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// `extrados convert`.
#[derive(Debug, Args)]
pub(crate) struct Convert {
    /// A bridge file or a block model file (.toml), a drawing (.dxf), a surveyed section of an intrados (.csv), a point cloud (.e57, .las, .laz), a table of a bridge's numbers (.txt, .csv), or a road profile (LandXML, .xml)
    pub from: PathBuf,
    /// What to write: .toml, .dxf, .vtu, .py (OpenSees) or .csv; of a section or a cloud .toml, .svg, .png or .csv; of a table or a road profile .toml
    pub to: PathBuf,
    /// Unit of a drawing or a section, in place of what its header says
    #[arg(long, value_name = "UNIT", value_parser = ["m", "cm", "mm", "ft", "in"])]
    pub unit: Option<String>,
    /// How far a chord may lie from its curve, such as "1 mm"
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub chord_tolerance: Option<String>,
    /// How far apart ends may lie that are meant to meet, such as "1 mm"
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub gap_tolerance: Option<String>,
    /// Cut concave outlines into convex pieces
    #[arg(long)]
    pub cut_concave: bool,
    /// Of a road profile (.xml): the station of the left springing of the first span, at the intrados, such as "1234.5 m"
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub station: Option<String>,
    /// Of a road profile: the level of that springing in the same datum
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub springing_level: Option<String>,
    /// Of a road profile: which one, where the file has several
    #[arg(long, value_name = "NAME")]
    pub profile: Option<String>,
    /// Of a point cloud (.e57, .las, .laz): where it is cut, in plan from the left end of the section to the right one, such as "12.0, 4.0, 21.5, 4.2"
    #[arg(long, value_name = "X,Y,X,Y", allow_hyphen_values = true)]
    pub line: Option<String>,
    /// Of a point cloud: thickness of what is taken along that line [default: 0.1 m]
    #[arg(long, value_name = "LENGTH", requires = "line")]
    pub slab: Option<String>,
    /// Of a point cloud: levels between which points are taken, such as "98.2, 101.5": above water and growth, below the road
    #[arg(long, value_name = "LOW,HIGH", allow_hyphen_values = true, requires = "line")]
    pub levels: Option<String>,
    /// Replace TO where it exists; never the input
    #[arg(long)]
    pub overwrite: bool,
}

/// `extrados schema`.
#[derive(Debug, Args)]
pub(crate) struct Schema {
    /// Of block model files instead of bridge files
    #[arg(long)]
    pub blocks: bool,
    /// Of files of vehicles
    #[arg(long, conflicts_with = "blocks")]
    pub vehicles: bool,
    /// Of files of a rule
    #[arg(long, conflicts_with_all = ["blocks", "vehicles"])]
    pub rule: bool,
}

/// `extrados verify`.
#[derive(Debug, Args)]
pub(crate) struct Verify {
    /// Folder with cases, or one case
    #[arg(default_value = "verification")]
    pub folder: PathBuf,
    /// Slow cases too
    #[arg(long)]
    pub slow: bool,
    /// Write the verification manual to this file (Markdown)
    #[arg(long, value_name = "FILE")]
    pub manual: Option<PathBuf>,
}

/// `extrados validate`.
#[derive(Debug, Args)]
pub(crate) struct Validate {
    /// Folder with priors.toml and a folder for each test
    #[arg(default_value = "validation")]
    pub folder: PathBuf,
    /// Folder for results [default: out/validate]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Only the test in the folder of this name; repeat the flag, or write commas, for more
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    pub only: Vec<String>,
    /// Only these methods, with commas [default: all but particles, which take hours]
    #[arg(long, value_name = "METHOD", value_delimiter = ',', value_parser = words::predictor())]
    pub methods: Vec<Predictor>,
    /// Whether it is one of several.
    #[command(flatten)]
    pub sharing: Sharing,
}

/// `extrados workbench`.
#[derive(Debug, Args)]
pub(crate) struct Workbench {
    /// Port on 127.0.0.1; 0 for a free one
    #[arg(long, value_name = "N", default_value_t = 7717)]
    pub port: u16,
    /// Only print the address
    #[arg(long)]
    pub no_browser: bool,
    /// Write the page into a new or empty folder, for any web server, and end
    #[arg(long, value_name = "DIR", conflicts_with_all = ["port", "no_browser"])]
    pub export: Option<PathBuf>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Arguments::command().debug_assert();
    }
}
