//! A train crosses the bridge: mesh, loads and sensors are set up here, the positions are solved in `solve.rs`.

mod error;
pub mod loads;
mod model;
pub mod rail;
pub mod record;
pub mod sensors;
mod setup;
mod solve;

pub use error::PassageError;
pub use record::record;
pub use setup::{Setup, setup};
pub use solve::{Passing, Scope, Solution, WantedSlices, slices, solve};

use super::AnalysisError;
use bridge::Bridge;
use bridge::passage::PassagePath;
use mechanics::watch::Watch;
use outcome::note::{InPassage, Note};
use outcome::passage::SensorRecord;
use outcome::passage::{Part, Passage, PassageStatus};
use outcome::warning::{self, Warning};

/// A tolerance above this is worth a word: peaks then differ in their third digit.
const LOOSE: f64 = 1e-4;

/// The passage that the file describes.
///
/// # Errors
/// Those of [`setup()`] and [`solve()`].
pub fn passage(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Passage, AnalysisError> {
    let setup = setup(bridge)?;
    let solution = solve(bridge, &setup, Scope::Everything, &[], watch)?;
    Ok(report(bridge, &setup, solution))
}

/// Steps that were balanced; those of the self-weight know of open joints at their end alone.
fn kept(log: &[outcome::passage::StepLog]) -> impl Iterator<Item = &outcome::passage::StepLog> {
    log.iter().filter(|step| step.cuts == 0 || step.stage == Part::Passage)
}

/// Share of a peak that may lie between positions without a word.
const BETWEEN: f64 = 0.05;

/// Records whose peak may lie between two positions: a parabola through three of them rises by up to an eighth of their second difference.
fn coarse(setup: &Setup, values: &[Vec<f64>], positions: &[f64]) -> Option<Warning> {
    let apart = positions.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
    let mut largest = 0.0f64;
    let missed = |values: &Vec<f64>| {
        let peak = (0..values.len()).max_by(|a, b| values[*a].abs().total_cmp(&values[*b].abs()))?;
        let [before, at, after] = values.get(peak.checked_sub(1)?..peak + 2)? else { return None };
        Some((before - 2.0 * at + after).abs() / (8.0 * at.abs())).filter(|share| *share > BETWEEN)
    };
    let channels: Vec<String> = setup
        .sensors
        .iter()
        .zip(values)
        .filter_map(|(sensor, values)| {
            missed(values).map(|share| (largest = largest.max(share), sensor.name.clone()).1)
        })
        .collect();
    (!channels.is_empty()).then(|| warning::Service::CoarsePassage { apart, channels, share: largest }.into())
}

/// The solution in an engineer's words.
pub fn report(bridge: &Bridge, setup: &Setup, solution: Solution) -> Passage {
    let plan = &setup.plan;
    let mut warnings: Vec<Warning> = Vec::new();
    if let (PassageStatus::NotConverged, Some(reason)) = (solution.status, &solution.reason) {
        warnings.push(warning::Service::BrokenPassage { reason: reason.clone() }.into());
    }
    if plan.tolerance > LOOSE {
        warnings.push(warning::Service::Loose { tolerance: plan.tolerance }.into());
    }
    let mut assumptions: Vec<Note> = setup.assumptions.iter().cloned().chain(solution.assumptions).collect();
    if plan.path == PassagePath::Condensed && !solve::condenses(setup) {
        assumptions.push(InPassage::AllFreedoms.into());
    }
    if bridge.spandrel_wall.is_some() {
        warnings.push(warning::Service::WallsLeftOut.into());
    }
    let open_joints = kept(&solution.log).map(|step| step.open_joints).max().unwrap_or(0);
    let plastic_points = kept(&solution.log).map(|step| step.plastic_points).max().unwrap_or(0);
    let locking_elements = kept(&solution.log).map(|step| step.locking_elements).max().unwrap_or(0);
    if locking_elements > 0 {
        warnings.push(warning::Service::Locking { elements: locking_elements }.into());
    }
    if let Some(at) = solution.no_influence_at.filter(|_| solution.status != PassageStatus::Cancelled) {
        warnings.push(warning::Service::NoInfluenceLines { at }.into());
    }
    let solved = solution.values.first().map_or(0, Vec::len);
    warnings.extend(coarse(setup, &solution.values, &setup.positions[..solved]));
    let channels = setup.sensors.iter().zip(solution.values).enumerate().map(|(k, (sensor, values))| SensorRecord {
        name: sensor.name.clone(),
        quantity: sensor.quantity,
        about: sensor.about.clone(),
        self_weight: solution.self_weight.get(k).copied().unwrap_or(0.0),
        values,
    });
    Passage {
        bridge: bridge.name.clone(),
        train: setup.train.clone(),
        speed: plan.speed,
        analysis: plan.analysis,
        kinematics: plan.kinematics,
        path: if solve::condenses(setup) { PassagePath::Condensed } else { PassagePath::Plain },
        status: solution.status,
        reason: solution.reason,
        times: setup.times[..solved].to_vec(),
        positions: setup.positions[..solved].to_vec(),
        channels: channels.collect(),
        degrees_of_freedom: solution.degrees_of_freedom,
        condensed_degrees_of_freedom: solution.condensed_degrees_of_freedom,
        iterations_total: solution.log.iter().map(|step| step.iterations as u64).sum(),
        open_joints,
        plastic_points,
        locking_elements,
        effective_width: setup.effective_width,
        tolerance: plan.tolerance,
        assumptions,
        warnings,
        log: solution.log,
        mesh: setup.meshed.picture(),
        moments: solution.moments,
        influence: solution.influence,
    }
}

#[cfg(test)]
mod road_tests;
#[cfg(test)]
mod tests;
