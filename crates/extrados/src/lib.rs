//! Masonry arch bridges from one bridge file: collapse, service response, updating, assessment.
//!
//! This crate is the one door to all of it, for the command, for pages in a browser and for other programs. A [`Project`] is a
//! bridge file with what it takes from other files; every analysis takes one, its options and someone who looks on, and gives
//! typed results. Nothing here reads a file or a clock but through [`files::Files`] and the clock of [`Means`].
//!
//! ```
//! use extrados::{CollapseOptions, Memory, Project, Unwatched, collapse};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let files = Memory::default().with("bridge.toml", include_str!("../../../examples/tiny/bridge.toml"));
//! let project = Project::read("bridge.toml", &files)?;
//! let found = collapse(&project, &CollapseOptions::default(), &mut Unwatched)?;
//! let carried = found.headline().map_or(0.0, |headline| headline.load);
//! println!("carried: {:.1} kN/m", carried / 1e3);
//! assert!(carried > 0.0);
//! # Ok(())
//! # }
//! ```
//!
//! | Function | Answer |
//! |---|---|
//! | [`collapse`] | the load, the thickness or the support movement that makes a mechanism |
//! | [`collapse_of_blocks`] | the same for blocks that are listed or drawn |
//! | [`cases`] | the same for every named case of the file |
//! | [`sweep`] | the same for loads or vehicles at every position |
//! | [`respond`] | displacements, strains and stresses as a train passes |
//! | [`update`], [`judge`] | parameters from records of a passage; the records alone |
//! | [`plan_load_test`] | which positions and sensors of a load test tell most of the parameters |
//! | [`vary`] | an analysis over ranges of the file's quantities |
//! | [`calibrate_fill`] | contacts of particles for a wanted fill |
//! | [`assess`] | the bridge against the limits of its file, with a report |
//!
//! Collapse and non-convergence are answers with names. Errors are [`Refusal`]s: what is wrong, where, and what to write instead.

mod assess;
mod blocks;
mod built;
mod calibrate_fill;
mod cases;
mod choice;
mod collapse;
mod companions;
mod compare;
pub mod examples;
pub mod files;
mod materials;
pub mod means;
mod names;
mod passing;
mod placing;
mod project;
mod refusal;
mod respond;
pub mod shard;
pub mod shelf;
mod shown;
mod stepping;
mod sweep;
mod update;
mod vary;
mod watch;
pub mod written;

/// Version, and the commit where a release names it (`.ci/release` sets `EXTRADOS_VERSION`).
pub const VERSION: &str = match option_env!("EXTRADOS_VERSION") {
    Some(version) => version,
    None => env!("CARGO_PKG_VERSION"),
};

pub use crate::assess::{AssessOptions, Assessed, StageName, assess};
pub use crate::blocks::{Blocks, collapse_of_blocks};
pub use crate::built::{as_built, library};
pub use crate::calibrate_fill::{CalibrateFillOptions, calibrate_fill};
pub use crate::cases::{CaseAnswer, Cases, cases};
pub use crate::choice::{Choice, damping};
pub use crate::collapse::{CollapseOptions, collapse, not_known, planned};
pub use crate::compare::{Answered, Compared, Difference, compare};
pub use crate::files::{Disk, Files, Memory, WholeDisk};
pub use crate::materials::with_material;
pub use crate::means::Means;
pub use crate::passing::Passing;
pub use crate::placing::{Carried, Placed, Placing, VehicleChoice};
pub use crate::project::Project;
pub use crate::refusal::{Refusal, reason};
pub use crate::respond::{RespondOptions, respond};
pub use crate::shown::{Excerpt, finding_in_words};
pub use crate::stepping::Stepping;
pub use crate::sweep::{SweepOptions, Swept, sweep, sweeps};
pub use crate::update::{UpdateOptions, can_update, judge, plan_load_test, update};
pub use crate::vary::{Portion, Studied, VaryOptions, VaryPlan, settings, vary};
pub use crate::watch::{Looking, Progress, Unwatched, Watch, Wish};

/// Results as data, their objects for scripts and their tables.
pub use ::outcome as results;
/// The bridge as its file describes it.
pub use bridge;
/// Materials of the library, which [`with_material`] writes into a file.
pub use bridge::material::materials;
/// Drawings (DXF) as outlines.
pub use drawing;
/// Drawings, pictures and ParaView files of results.
pub use figures;
/// Blocks and particles as the block engine has them, which [`Stepping`] shows.
pub use mechanics::dem;
/// A block model file from a drawing: what the drawing does not say stands there as a line to fill in, which the reader refuses until that
/// is done.
pub use structure::blocks::skeleton as of_drawing;
