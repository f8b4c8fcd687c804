//! Contacts of particles fitted to a wanted fill: what was found.

use crate::words::words;
pub mod moduli;
pub mod report;

pub use moduli::{Curve, CurvePoint, Spread};

use crate::picture::Point;
use crate::warning::Warning;
use bridge::{Calibration, Modulus};
use serde::{Deserialize, Serialize};

words! {
    /// How a calibration ended.
    pub enum Verdict {
        /// Everything that was asked for was found.
        Completed = "completed",
        /// The wanted modulus is out of reach, or could not be checked.
        Undetermined = "undetermined",
        /// The onlooker stopped it.
        Cancelled = "cancelled",
    }
}

/// A multiple of the file's stiffness and the modulus there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct At {
    /// Multiple.
    pub multiple: f64,
    /// Modulus [Pa].
    pub modulus: f64,
}

/// What a calibration found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CalibrationReport {
    /// How it ended.
    pub verdict: Verdict,
    /// Name of the bridge.
    pub bridge: String,
    /// Which modulus is compared with the wanted one.
    pub modulus: Modulus,
    /// The plan.
    pub plan: Calibration,
    /// Stiffness [Pa/m] of contacts between particles in the file, normal and shear, for particles of mean size.
    pub stiffness: [f64; 2],
    /// Seeds of the packings.
    pub seeds: Vec<u64>,
    /// How many squares were cut out of them.
    pub squares: usize,
    /// How many particles they hold.
    pub particles: usize,
    /// Mean diameter of the particles [m].
    pub mean_diameter: f64,
    /// Mean share of the squares that particles cover.
    pub solid_fraction: f64,
    /// Particles that the cuts went through, and how many of them were replaced.
    pub cut: usize,
    /// See `cut`.
    pub replaced: usize,
    /// Moduli at the multiples of the file, in its order.
    pub table: Vec<Measured>,
    /// Where the fill has the wanted modulus.
    pub found: Option<Measured>,
    /// Lowest and highest modulus within reach, where the wanted one is not.
    pub reach: Option<[At; 2]>,
    /// The same on other packings.
    pub check: Option<Check>,
    /// Friction and cohesion of contacts for a wanted strength.
    pub strength: Option<Sheared>,
    /// A sample for drawings.
    pub drawn: Option<Drawn>,
    /// What to look at.
    pub warnings: Vec<Warning>,
}

/// The stiffness that was found, on other packings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// Their seeds.
    pub seeds: Vec<u64>,
    /// What they have.
    pub measured: Measured,
}

/// What was found for a wanted strength.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Sheared {
    /// What was wanted.
    pub wanted: TargetStrength,
    /// What was found: the nearest where it is out of reach.
    pub found: Strength,
    /// Whether what is wanted is within reach.
    pub reached: bool,
    /// The same on other packings.
    pub check: Option<Strength>,
}

/// All samples at one multiple.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// Multiple of the file's stiffness.
    pub multiple: f64,
    /// Mean of the step slopes [Pa].
    pub tangent: Option<Spread>,
    /// Slope of least squares [Pa].
    pub least_squares: Option<Spread>,
    /// Secant from the first result to the last [Pa].
    pub secant: Option<Spread>,
    /// The same without the first steps [Pa].
    pub late_secant: Option<Spread>,
    /// Samples that did not come to rest, or did not get shorter in every step.
    pub left_out: usize,
    /// Mean curve of the samples that count, and the standard deviation of its strain.
    pub curve: Vec<(CurvePoint, f64)>,
    /// Every sample: seed, square, curve.
    pub samples: Vec<(u64, usize, Curve)>,
    /// Iterations in all.
    pub iterations: u64,
    /// The first sample that counts: its index, and its particles before and after.
    pub drawn: Option<(usize, Vec<AtRest>)>,
}

/// Particles and block of a press at rest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AtRest {
    /// Centres and radii of the particles [m].
    pub particles: Vec<[f64; 3]>,
    /// Level of the block's underside [m].
    pub block: f64,
}

/// Particles in the press.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Confined {
    /// Centres and radii [m], from the lower left corner of the square.
    pub particles: Vec<[f64; 3]>,
    /// Level of the block's underside [m].
    pub block: f64,
    /// Mean stress under it [Pa].
    pub stress: f64,
}

/// A sample for drawings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Drawn {
    /// Seed and square.
    pub name: (u64, usize),
    /// Side [m].
    pub size: f64,
    /// Particles that the cut went through.
    pub cuts: Vec<Cut>,
    /// The particles as cut, the replacements last.
    pub particles: Vec<[f64; 3]>,
    /// Under the block alone, and after the last load step.
    pub pressed: [Confined; 2],
}

/// What contacts between particles resist with.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Contact {
    /// Friction angle [rad].
    pub friction_angle: f64,
    /// Cohesion [Pa].
    pub cohesion: f64,
}

/// What the fill resists with, over all samples.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Strength {
    /// Contacts that it was measured with.
    pub contact: Contact,
    /// Friction angle of the fill [rad].
    pub friction_angle: Spread,
    /// Cohesion of the fill [Pa].
    pub cohesion: Spread,
    /// Confining pressure and mean stress at the peak [Pa].
    pub peaks: Vec<[f64; 2]>,
    /// Samples that did not come to rest under the confining pressure, or did not give way.
    pub left_out: usize,
}

/// What is wanted of the fill.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TargetStrength {
    /// Friction angle [rad].
    pub friction_angle: Option<f64>,
    /// Cohesion [Pa].
    pub cohesion: Option<f64>,
}

/// A particle that the cut went through.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Cut {
    /// Its centre, from the lower left corner of the square [m].
    pub centre: Point,
    /// Its radius [m].
    pub radius: f64,
    /// Whether a smaller one stands in its place.
    pub replaced: bool,
}
