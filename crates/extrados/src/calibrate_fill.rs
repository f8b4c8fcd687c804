//! Contacts of particles for a wanted fill.

use crate::project::Project;
use crate::refusal::Refusal;
use crate::watch::{Looking, Watch};
use assess::analysis::calibrate;
use outcome::calibration::CalibrationReport;

/// How contacts are sought.
#[derive(Debug, Clone, Copy, Default)]
pub struct CalibrateFillOptions {
    /// The wanted modulus of the fill [Pa]; none for the file's.
    pub modulus: Option<f64>,
    /// Over how many packings; none for the file's.
    pub seeds: Option<u64>,
}

/// Measures the fill of the file as particles in a press and in a box, and finds the contacts that it needs. An interrupted run ends
/// with the verdict `cancelled`.
///
/// # Errors
/// A file that cannot be used, or whose fill is no particles (F108).
pub fn calibrate_fill(
    project: &Project,
    options: &CalibrateFillOptions,
    watch: &mut dyn Watch,
) -> Result<CalibrationReport, Refusal> {
    let mut bridge = project.bridge()?.clone();
    let plan = &mut bridge.calibration;
    plan.wanted_modulus = options.modulus.or(plan.wanted_modulus);
    plan.seeds = options.seeds.unwrap_or(plan.seeds);
    Ok(calibrate::calibrate_fill(&bridge, &mut Looking(watch))?)
}
