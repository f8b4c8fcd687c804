//! Arguments of `extrados bench`.

use super::words::ground;
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use verification::footing::Ground;

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
    #[arg(long, value_name = "LAW", value_parser = ground())]
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
