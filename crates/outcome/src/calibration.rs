//! Contacts of particles fitted to a wanted fill: what was found.

pub mod moduli;
pub mod report;
pub mod strength;

pub use moduli::{At, Curve, CurvePoint, Spread};
pub use strength::{Contact, Strength, TargetStrength};

use crate::picture::Point;
use crate::published::{list, object};
use crate::sweep::Ended;
use crate::warning::Warning;
use crate::wire::{Unit, Wire, published};
use bridge::Calibration;
use serde::{Deserialize, Serialize};
use serde_json::Value;

published! {
    /// What a calibration found; its status is published as that of the command. The stiffness is that with the wanted modulus, and that of
    /// the file where none is wanted.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct CalibrationReport |report| {
        /// How it ended: undetermined where the wanted modulus is out of reach, or could not be checked.
        pub verdict: Ended [kept],
        /// Name of the bridge.
        pub bridge: String,
        /// Normal stiffness of contacts between particles of mean size.
        = contact_normal_stiffness: Option<f64> [GPa/m] = report.shown().map(|m| m.multiple * report.stiffness[0]),
        /// Their shear stiffness.
        = contact_shear_stiffness: Option<f64> [GPa/m] = report.shown().map(|m| m.multiple * report.stiffness[1]),
        /// What multiple of the file's stiffness that is.
        = multiple: Option<f64> = report.shown().map(|m| m.multiple),
        = multiple_standard_error: Option<f64> = report.multiple_error(),
        = wanted_modulus: Option<f64> [MPa] = report.plan.wanted_modulus,
        /// Which modulus is compared with the wanted one.
        = matched: String = report.plan.modulus.word(),
        /// Mean of the step slopes.
        = tangent_modulus: Option<f64> [MPa] = report.tangent().map(|spread| spread.mean),
        = tangent_standard_error: Option<f64> [MPa] = report.tangent().map(|spread| spread.standard_error),
        /// Secant from the first result to the last.
        = secant_modulus: Option<f64> [MPa] = report.secant().map(|spread| spread.mean),
        = secant_standard_error: Option<f64> [MPa] = report.secant().map(|spread| spread.standard_error),
        /// The modulus that is compared, on other packings.
        = check_modulus: Option<f64> [MPa] = report.checked().map(|spread| spread.mean),
        = check_standard_error: Option<f64> [MPa] = report.checked().map(|spread| spread.standard_error),
        /// Seeds of these packings.
        = check_seeds: Vec<u64> = report.check.as_ref().map_or(&[][..], |check| &check.seeds),
        /// The plan.
        pub plan: Calibration [kept],
        /// Stiffness [Pa/m] of contacts between particles in the file, normal and shear, for particles of mean size.
        pub stiffness: [f64; 2] [kept],
        /// Lowest and highest modulus within reach, where the wanted one is not.
        pub reach: Option<[At; 2]>,
        /// Mean curve of the samples: `stress_kpa`, `strain`, `strain_standard_deviation`, `displacement_mm`.
        = curve: Vec<Object> = report.shown().map_or_else(Vec::new, |m| list(&m.curve, |(p, deviation)| object! {
            stress_kpa: p.stress / 1e3,
            strain: p.strain,
            strain_standard_deviation: deviation,
            displacement_mm: p.displacement * 1e3,
        })),
        /// How many particles the packings hold.
        pub particles: usize,
        /// How many squares were cut out of them.
        pub squares: usize as samples,
        /// Seeds of the packings.
        pub seeds: Vec<u64>,
        /// Mean diameter of the particles [m].
        pub mean_diameter: f64 [m],
        /// Mean share of the squares that particles cover.
        pub solid_fraction: f64,
        /// Particles that the cuts went through, and how many of them were replaced.
        pub cut: usize as cut_particles,
        /// See `cut_particles`.
        pub replaced: usize as replaced_particles,
        /// Normal stiffness of contacts in the file.
        = first_normal_stiffness: f64 [GPa/m] = report.stiffness[0],
        /// Their shear stiffness.
        = first_shear_stiffness: f64 [GPa/m] = report.stiffness[1],
        /// Moduli at the multiples of the file, in its order.
        pub table: Vec<Measured> as moduli = list(report.table.iter().enumerate(), |(row, m)| m.object(report, row)),
        /// Where the fill has the wanted modulus.
        pub found: Option<Measured> [kept],
        /// The same on other packings.
        pub check: Option<Check> [kept],
        /// Friction and cohesion of contacts for a wanted strength.
        pub strength: Option<Sheared>,
        /// Iterations in all.
        = iterations_total: u64 = report.measured().map(|m| m.iterations).sum::<u64>(),
        /// A sample for drawings.
        pub drawn: Option<Drawn> [kept],
        /// What to look at.
        pub warnings: Vec<Warning> [kept],
    }
}

/// The stiffness that was found, on other packings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// Their seeds.
    pub seeds: Vec<u64>,
    /// What they have.
    pub measured: Measured,
}

published! {
    /// What was found for a wanted strength.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Sheared |sheared| {
        = wanted_friction_angle: Option<f64> [deg] = sheared.wanted.friction_angle,
        = wanted_cohesion: Option<f64> [kPa] = sheared.wanted.cohesion,
        /// What was wanted.
        pub wanted: TargetStrength [kept],
        /// Whether what is wanted is within reach.
        pub reached: bool,
        = contact_friction_angle: f64 [deg] = sheared.found.contact.friction_angle,
        = contact_cohesion: f64 [kPa] = sheared.found.contact.cohesion,
        = friction_angle_deg: Spread = degrees(sheared.found.friction_angle),
        = cohesion: Spread [kPa] = sheared.found.cohesion,
        /// The friction angle on other packings.
        = check_friction_angle_deg: Option<Spread> = sheared.check.as_ref().map(|check| degrees(check.friction_angle)),
        /// The cohesion on other packings.
        = check_cohesion: Option<Spread> [kPa] = sheared.check.as_ref().map(|check| check.cohesion),
        /// At each confining pressure the mean stress at the peak: `confining_pressure_kpa`, `peak_stress_kpa`.
        = peaks: Vec<Object> = list(&sheared.found.peaks, |[pressure, peak]| object! {
            confining_pressure_kpa: pressure / 1e3,
            peak_stress_kpa: peak / 1e3,
        }),
        /// Samples that did not come to rest under the confining pressure, or did not give way.
        = samples_left_out: usize = sheared.found.left_out,
        /// What was found: the nearest where it is out of reach.
        pub found: Strength [kept],
        /// The same on other packings.
        pub check: Option<Strength> [kept],
    }
}

/// An angle [rad] in degrees, with its scatter.
fn degrees(angle: Spread) -> Value {
    angle.wire(Unit { suffix: "_deg", symbol: "°", of: |x| x / (std::f64::consts::PI / 180.0) })
}

published! {
    /// All samples at one multiple, in a row of the table of a report.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Measured |m, report: &CalibrationReport, row: usize| {
        /// Multiple of the file's stiffness.
        pub multiple: f64,
        = contact_normal_stiffness: f64 [GPa/m] = m.multiple * report.stiffness[0],
        = contact_shear_stiffness: f64 [GPa/m] = m.multiple * report.stiffness[1],
        /// Mean of the step slopes [Pa].
        pub tangent: Option<Spread> [MPa],
        /// Slope of least squares [Pa].
        pub least_squares: Option<Spread> [MPa],
        /// Secant from the first result to the last [Pa].
        pub secant: Option<Spread> [MPa],
        /// The same without the first steps [Pa].
        pub late_secant: Option<Spread> [MPa],
        /// The modulus that the file has it compared with.
        = compare_with: Option<f64> [MPa] = report.plan.compare_with.get(row),
        /// Samples that did not come to rest, or did not get shorter in every step.
        pub left_out: usize as samples_left_out,
        /// Mean curve of the samples that count, and the standard deviation of its strain.
        pub curve: Vec<(CurvePoint, f64)> [kept],
        /// Every sample: seed, square, curve.
        pub samples: Vec<(u64, usize, Curve)> [kept],
        /// Iterations in all.
        pub iterations: u64 [kept],
        /// The first sample that counts: its index, and its particles before and after.
        pub drawn: Option<(usize, Vec<AtRest>)> [kept],
    }
}

/// Particles and block of a press at rest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AtRest {
    /// Centres and radii of the particles [m].
    pub particles: Vec<[f64; 3]>,
    /// Level of the block's underside [m].
    pub block: f64,
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
    /// Under the block alone, and after the last load step: from the lower left corner of the square, and the mean stress under the block [Pa].
    pub pressed: [(AtRest, f64); 2],
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
