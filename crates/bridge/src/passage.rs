//! What a bridge file says of a train that crosses: the train, the track under it, the analysis, and what is measured.

use crate::choice::choice;
pub use crate::sensor::*;
use crate::train::Train;
use crate::values::of_keys;

/// A train that crosses.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage {
    /// The train.
    pub train: Train,
    /// How axles reach the fill.
    pub track: Track,
    /// How it crosses, and how that is analysed.
    pub plan: PassagePlan,
    /// What is measured; empty where the file leaves that to the defaults, see [`default_sensors`].
    pub sensors: Vec<Sensor>,
}

of_keys! {
    /// Rails on sleepers on ballast, on the fill.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Track {
        /// Bending stiffness of one rail about its horizontal axis [N m^2].
        pub rail_bending_stiffness: f64,
        /// Stiffness of what bears one rail, per metre of rail [N/m per m].
        pub track_modulus: f64,
        /// Distance between the middles of sleepers [m].
        pub sleeper_spacing: f64,
        /// Size of a sleeper along the bridge [m].
        pub sleeper_breadth: f64,
        /// Size of a sleeper across the bridge [m].
        pub sleeper_length: f64,
        /// Depth of ballast below the sleepers, down to the top of the fill [m].
        pub ballast_depth: f64,
        /// Slope at which pressure spreads through it, vertical to one horizontal.
        pub ballast_slope: f64,
        /// Weight of rails and sleepers on the fill [Pa]; that of ballast is part of it only where no layer of the cover is ballast.
        pub dead_load: f64,
        /// Width of the bridge that carries an axle [m]; the barrel's where the file gives none.
        pub effective_width: Option<f64>,
    }
}

/// How a train crosses, and how that is analysed.
#[derive(Debug, Clone, PartialEq)]
pub struct PassagePlan {
    /// Speed [m/s].
    pub speed: f64,
    /// Time from one position to the next [s].
    pub time_step: f64,
    /// Where the first axle stands at the start [m], from the left springing of the first span; where the mesh begins if the
    /// file does not say.
    pub from: Option<f64>,
    /// Where it stands at the end [m]; where the last axle has left the mesh if the file does not say.
    pub to: Option<f64>,
    /// Whether masses take part.
    pub analysis: PassageAnalysis,
    /// Rayleigh damping, where there is some.
    pub damping: Option<Rayleigh>,
    /// Share of numerical damping in time integration: 0 is Newmark's average acceleration, up to 1/3 Hilber, Hughes and
    /// Taylor's method.
    pub numerical_damping: f64,
    /// Whether displacements and rotations are large.
    pub kinematics: PassageKinematics,
    /// Load steps of the self-weight.
    pub load_steps: usize,
    /// Most iterations of one load step.
    pub iterations: usize,
    /// Out-of-balance force at which a step has converged, relative to the applied forces.
    pub tolerance: f64,
    /// How positions are solved.
    pub path: PassagePath,
    /// Positions of the first axle [m] for which pictures are made; the peaks of the channels where the file gives none.
    pub pictures: Vec<f64>,
}

choice! {
    /// Whether masses take part.
    pub enum PassageAnalysis {
        /// every position at rest
        Static = "static",
        /// with inertia and damping
        Transient = "transient",
    }
}

/// Rayleigh damping: one damping ratio at two frequencies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rayleigh {
    /// Share of critical damping.
    pub ratio: f64,
    /// The two frequencies [Hz], the lower first.
    pub frequencies: [f64; 2],
}

choice! {
    /// Whether displacements and rotations are large.
    pub enum PassageKinematics {
        /// equilibrium on the bridge as built
        Small = "small",
        /// equilibrium on the deformed bridge: large displacements and rotations
        Large = "large",
    }
}

choice! {
    /// How positions are solved.
    pub enum PassagePath {
        /// linear parts are condensed once, and only nonlinear parts iterate; the same numbers, much faster
        Condensed = "condensed",
        /// all degrees of freedom at every position
        Plain = "plain",
    }
}

/// Most positions of one passage: an hour's record at the default time step.
pub const MOST_POSITIONS: usize = 720_000;
