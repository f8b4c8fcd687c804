//! The worst of several runs of the same vehicles: with and without braking and traction, with and without what helps the bridge.

use outcome::sweep::Ended;
use outcome::vehicles::VehicleSweep;

/// The run that governs, by its number, with each vehicle from the run that is worst for it; a run that was stopped stands by itself.
pub(crate) fn worst_of(runs: &[VehicleSweep]) -> (usize, VehicleSweep) {
    let least = |run: &VehicleSweep| run.vehicles.iter().map(|one| one.size()).fold(f64::INFINITY, f64::min);
    let stopped = runs.iter().position(|run| run.status() == Ended::Cancelled);
    let base = stopped.unwrap_or_else(|| {
        (0..runs.len()).fold(0, |best, k| if least(&runs[k]) < least(&runs[best]) { k } else { best })
    });
    let mut found = runs[base].clone();
    if stopped.is_none() {
        for (k, vehicle) in found.vehicles.iter_mut().enumerate() {
            for run in runs {
                if run.vehicles[k].size() < vehicle.size() {
                    *vehicle = run.vehicles[k].clone();
                }
            }
        }
    }
    (base, found)
}
