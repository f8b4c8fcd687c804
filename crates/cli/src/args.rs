//! What may be said on the command line.

use crate::quantities;
use crate::shards::Sharing;
use bridge::choice::Choice as Words;
use bridge::passage::{PassageAnalysis, PassagePath};
use bridge::update::{Search, Start, Variant};
use bridge::{Analysis, ContactLength, ContactPoints, Friction, JointContact, Method};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum};
use extrados::{Refusal, StageName};
use outcome::validation::Predictor;
use std::path::PathBuf;
use verification::footing::Ground;

/// Masonry arch bridges: from a bridge file to a collapse load, by discrete elements and by limit analysis.
#[derive(Debug, Parser)]
#[command(
    name = "extrados",
    version,
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
    /// Write a working example to edit
    New(New),
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
    Merge(Merge),
    /// Find the contact stiffness of fill particles that gives the fill a wanted modulus
    CalibrateFill(CalibrateFill),
    /// Tell what an error, a warning or a status means
    Explain(Explain),
    /// List the vehicles and rules of the library: their names, loads, factors and sources
    Vehicles(Vehicles),
    /// List the materials of the library: what is usual of masonry, joints, fill and backing, between which ends, and where that is from
    Materials(Materials),
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
    #[arg(long, value_name = "SECONDS", default_value_t = 30.0, value_parser = seconds, global = true)]
    pub progress_every: f64,
    /// Threads to use [default: one per core]; the numbers are the same whatever it is
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024), global = true)]
    pub threads: Option<u16>,
}

/// `extrados new`.
#[derive(Debug, Args)]
pub(crate) struct New {
    /// The folder to write; it must be new or empty
    pub dir: PathBuf,
    /// Which example
    #[arg(long, value_name = "NAME", default_value = "bridgemill")]
    pub from: String,
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

/// Which analysis, and how exactly, in place of the file's plan.
#[derive(Debug, Clone, Args)]
pub(crate) struct Choice {
    /// Method, in place of the file's
    #[arg(long, value_parser = word::<Method>())]
    pub method: Option<Method>,
    /// What is made to collapse, in place of the file's
    #[arg(long, value_parser = word::<Analysis>())]
    pub analysis: Option<Analysis>,
    /// Refine the collapse load below the load step to this, such as "1 kN/m"
    #[arg(long, value_name = "LOAD", allow_hyphen_values = true)]
    pub resolution: Option<String>,
    /// What to set in place of the file's plan.
    #[command(flatten)]
    pub overrides: Overrides,
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
    /// Take photographs from outside the folder of the bridge file into the report
    #[arg(long)]
    pub allow_outside: bool,
    /// Of a folder: whether it is one of several.
    #[command(flatten)]
    pub sharing: Sharing,
}

/// `extrados merge`.
#[derive(Debug, Args)]
pub(crate) struct Merge {
    /// Folders of results of the shards
    #[arg(required = true, value_name = "DIR")]
    pub dirs: Vec<PathBuf>,
    /// Folder for the results of the whole
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
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

/// Numerical settings in place of the file's.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Numerical settings, in place of the file's")]
pub(crate) struct Overrides {
    /// local, viscous or adaptive, the first two with a share: "local:0.8"
    #[arg(long, value_name = "KIND[:SHARE]", value_parser = damping)]
    pub damping: Option<bridge::Damping>,
    /// Where joints carry what presses them: in points at their ends, or over their compressed part
    #[arg(long, value_parser = word::<JointContact>())]
    pub contact: Option<JointContact>,
    /// Whether the length of a contact point is kept or updated
    #[arg(long, value_parser = word::<ContactLength>())]
    pub contact_length: Option<ContactLength>,
    /// Friction rule of limit analysis
    #[arg(long, value_parser = word::<Friction>())]
    pub friction: Option<Friction>,
    /// Where limit analysis puts the contact points of a joint
    #[arg(long, value_parser = word::<ContactPoints>())]
    pub contact_points: Option<ContactPoints>,
    /// Out-of-balance force at rest over the acting forces, such as 1e-5
    #[arg(long, value_name = "RATIO", value_parser = tolerance)]
    pub tolerance: Option<f64>,
    /// Most iterations in one load step
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub step_limit: Option<u64>,
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

/// `extrados convert`.
#[derive(Debug, Args)]
pub(crate) struct Convert {
    /// A bridge file or a block model file (.toml), a drawing (.dxf), or a surveyed section of an intrados (.csv)
    pub from: PathBuf,
    /// What to write: .toml, .dxf or .vtu; of a section .toml, .svg, .png or .csv
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
    /// Replace TO where it exists; never the input
    #[arg(long)]
    pub overwrite: bool,
}

/// `extrados explain`.
#[derive(Debug, Args)]
pub(crate) struct Explain {
    /// A code such as B104, or a status such as collapsed; without one, all are listed
    pub code: Option<String>,
}

/// `extrados vehicles`.
#[derive(Debug, Args)]
pub(crate) struct Vehicles {
    /// A vehicle, a load model or a rule, such as lm71 or cs-454; without a name, all are listed
    pub name: Option<String>,
}

/// `extrados materials`.
#[derive(Debug, Args)]
pub(crate) struct Materials {
    /// A material or a table of a bridge file, such as sandstone or masonry; without a name, all are listed
    pub name: Option<String>,
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
    #[arg(long, value_name = "METHOD", value_delimiter = ',', value_parser = predictor())]
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
}

/// `extrados bench`.
#[derive(Debug, Args)]
pub(crate) struct Bench {
    /// What to measure
    pub name: BenchName,
    /// How often
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub repeats: u32,
    /// How many discs, for `disks` (2000); how many elements along the ground, for `factor` (316) and `footing` (142)
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(20..=10_000_000))]
    pub count: Option<u32>,
    /// What yields, for `footing` (von-mises)
    #[arg(long, value_name = "LAW", value_parser = one_of(GROUNDS.to_vec()))]
    pub material: Option<Ground>,
    /// For `disks`: compare with this many boxes stepped side by side, one thread each
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=64))]
    pub copies: Option<u16>,
    /// For `disks`: measure this many steps from the expanded packing on, settling included, and once
    #[arg(long, value_name = "N", conflicts_with_all = ["copies", "repeats"], value_parser = clap::value_parser!(u32).range(1..))]
    pub steps: Option<u32>,
    /// For `disks --steps`: keep the state in DIR every now and then, and go on from the one that is there
    #[arg(long, value_name = "DIR", requires = "steps")]
    pub checkpoint: Option<PathBuf>,
}

/// A measure of speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum BenchName {
    /// Dense discs in a closed box near rest: steps of particles in a second
    Disks,
    /// Bridgemill, case 1, to collapse by discrete elements
    Arch,
    /// Bridgemill's ring and dispersed knife load by limit analysis, building and both bounds included
    Limit,
    /// The same ring along the equilibrium path, joints with distributed contact, from its weight to past its peak
    Path,
    /// A vehicle of 13 axles at 510 positions over three spans, on rigid blocks and on deformable joints
    Crossing,
    /// Bridgemill with its fill as a continuum: both bounds of its load, meshes included
    Bounds,
    /// The elastic stiffness of a finite element mesh: analysed, assembled, factorised, solved with
    Factor,
    /// A rough footing pushed into yielding ground, in ten load steps
    Footing,
    /// The railway arch on a fine mesh under two locomotives and eight wagons, quasi-static, by the condensed path
    Passage,
    /// The railway arch with other moduli: self-weight and six slices of its passage, again and again
    Update,
}

/// A word on the command line, what it means there, and what it stands for.
pub(crate) type Word<T> = (&'static str, &'static str, T);

/// Ground under the footing of `bench footing`.
pub(crate) const GROUNDS: &[Word<Ground>] = &[
    ("von-mises", "Clay", Ground::VonMises),
    ("drucker-prager", "Frictional, with associated flow", Ground::DruckerPrager),
    ("non-associated", "Frictional, without dilation: an unsymmetric tangent", Ground::NonAssociated),
    ("mohr-coulomb", "Frictional, the pyramid in place of the cone, with associated flow", Ground::MohrCoulomb),
];

/// Words of a key of bridge files or of stages, with what is said of them.
fn word<T: Words + Send + Sync>() -> impl TypedValueParser<Value = T> {
    one_of(T::WORDS.iter().zip(T::VALUES).map(|(choice, value)| (choice.word, choice.doc, *value)).collect())
}

/// A method of `validate` by its word.
fn predictor() -> impl TypedValueParser<Value = Predictor> {
    one_of(Predictor::ALL.iter().map(|one| (one.word(), one.about(), *one)).collect())
}

/// Takes one of these words for what it stands for.
fn one_of<T: Copy + Send + Sync + 'static>(words: Vec<Word<T>>) -> impl TypedValueParser<Value = T> {
    let known: Vec<PossibleValue> = words.iter().map(|(word, about, _)| PossibleValue::new(word).help(about)).collect();
    PossibleValuesParser::new(known)
        .map(move |said| words.iter().find(|(word, ..)| *word == said).expect("only these words pass").2)
}

/// The word for one of these.
pub(crate) fn word_for<T: PartialEq>(words: &[Word<T>], value: T) -> &'static str {
    words.iter().find(|(.., one)| *one == value).map_or("", |(word, ..)| word)
}

impl Choice {
    /// What was said in place of a file's plan, for a bridge of this width [m].
    pub(crate) fn of(&self, width: f64) -> Result<extrados::Choice, Refusal> {
        let resolution = self.resolution.as_ref().map(|text| quantities::line_load("--resolution", text, width));
        let own = &self.overrides;
        Ok(extrados::Choice {
            analysis: self.analysis,
            method: self.method,
            resolution: resolution.transpose()?,
            damping: own.damping,
            contact: own.contact,
            contact_length: own.contact_length,
            friction: own.friction,
            contact_points: own.contact_points,
            tolerance: own.tolerance,
            step_limit: own.step_limit,
        })
    }
}

fn damping(text: &str) -> Result<bridge::Damping, String> {
    let (kind, share) = match text.split_once(':') {
        Some((kind, share)) => (kind, Some(share)),
        None => (text, None),
    };
    let share =
        share.map(|words| number(words, |share| share > 0.0 && share <= 1.0, "the share lies above 0 and up to 1"));
    match (kind, share.transpose()?) {
        ("local", share) => Ok(bridge::Damping::Local(share.unwrap_or(0.8))),
        ("viscous", share) => Ok(bridge::Damping::Viscous(share.unwrap_or(0.8))),
        ("adaptive", None) => Ok(bridge::Damping::Adaptive),
        ("adaptive", Some(_)) => Err("adaptive damping finds its own intensity: give no share".to_owned()),
        _ => Err("write local, viscous or adaptive, such as local:0.8".to_owned()),
    }
}

fn seconds(text: &str) -> Result<f64, String> {
    number(text, |seconds| (0.0..=1e6).contains(&seconds), "write a number of seconds, such as 2")
}

fn times(text: &str) -> Result<f64, String> {
    number(text, |times| times > 0.0 && times <= 1e6, "write a positive number, such as 50")
}

fn tolerance(text: &str) -> Result<f64, String> {
    let fits = |ratio| ratio > 0.0 && ratio <= 0.1;
    number(text, fits, "the tolerance is a ratio above 0 and up to 0.1, such as 1e-5")
}

fn number(text: &str, fits: impl FnOnce(f64) -> bool, help: &str) -> Result<f64, String> {
    text.parse().ok().filter(|number: &f64| fits(*number)).ok_or_else(|| help.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn damping_takes_a_share() {
        assert_eq!(damping("local:0.7"), Ok(bridge::Damping::Local(0.7)));
        assert_eq!(damping("adaptive"), Ok(bridge::Damping::Adaptive));
        assert!(damping("local:2").is_err() && damping("soft").is_err() && damping("adaptive:0.5").is_err());
    }
}
