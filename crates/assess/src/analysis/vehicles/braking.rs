//! Braking and traction: of runs with and without forces along the bridge, the worst for each vehicle.

use outcome::sweep::Ended;
use outcome::vehicles::{Swept, VehicleSweep};
use outcome::warning;

/// The size by which vehicles are compared: one without an answer comes first, since its factor may be the least.
fn size(one: &Swept) -> f64 {
    match one.factor() {
        Some(factor) => factor,
        None if one.status == outcome::collapse::Status::Locks => f64::INFINITY,
        None => f64::NEG_INFINITY,
    }
}

/// The run that governs, with each vehicle from the run that is worst for it.
pub fn worst(share: f64, across: &str, runs: Vec<VehicleSweep>) -> VehicleSweep {
    let least = |run: &VehicleSweep| run.vehicles.iter().map(size).fold(f64::INFINITY, f64::min);
    let stopped = runs.iter().position(|run| run.status() == Ended::Cancelled);
    let base = stopped.unwrap_or_else(|| {
        (0..runs.len()).fold(0, |best, k| if least(&runs[k]) < least(&runs[best]) { k } else { best })
    });
    let mut found = runs[base].clone();
    if stopped.is_none() {
        for (k, vehicle) in found.vehicles.iter_mut().enumerate() {
            for run in &runs {
                if size(&run.vehicles[k]) < size(vehicle) {
                    *vehicle = run.vehicles[k].clone();
                }
            }
        }
    }
    found.warnings.retain(|warning| warning.code != warning::NO_LONGITUDINAL);
    found.assumptions.push(format!(
        "Braking and traction: {:.0} % of every axle and uniform load acts along the bridge at the surface as well, to the right, to the left or \
         not at all, whichever is worst for a vehicle; all of it reaches the rings, and none the ground before and behind. Of forces across \
         the bridge: {across}.",
        100.0 * share
    ));
    found
}
