//! A train crosses the bridge: mesh, loads and sensors are set up here, the positions are solved in `solve.rs`.

pub mod at_rest;
mod error;
pub mod loads;
mod model;
pub mod rail;
pub mod record;
pub mod sensors;
mod setup;
mod solve;

pub use at_rest::AtRest;
pub use error::PassageError;
pub use record::record;
pub use setup::{Setup, setup};
use solve::condenses;
pub use solve::{Passing, Scope, Solution, WantedSlices, slices, solve};

use super::AnalysisError;
use bridge::Bridge;
use bridge::passage::PassagePath;
use mechanics::watch::Watch;
use outcome::note::{InPassage, Note};
use outcome::passage::SensorRecord;
use outcome::passage::{Part, Passage, PassageStatus, PositionAtRest};
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

/// The load test that the file describes, where nothing crosses.
///
/// # Errors
/// Those of [`at_rest::setup`] and [`AtRest::solve`].
pub fn load_test(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Passage, AnalysisError> {
    let test = at_rest::setup(bridge)?;
    let solution = test.solve(bridge, WantedSlices::default(), watch)?;
    let rows = positions(bridge, &test, &solution);
    // Nothing crossed: there is no time and no place of a first axle.
    let none = Setup { times: Vec::new(), positions: Vec::new(), ..test.setup };
    let values = solution.values.clone();
    let mut found = report(bridge, &none, Solution { values: vec![Vec::new(); values.len()], ..solution });
    found.channels.iter_mut().zip(values).for_each(|(channel, values)| channel.values = values);
    Ok(Passage { positions_at_rest: rows, ..found })
}

/// Adds the positions of the file's load test to a passage that has come to its end.
///
/// # Errors
/// Those of [`at_rest::setup`] and [`AtRest::solve`].
pub fn with_load_test(bridge: &Bridge, found: &mut Passage, watch: &mut dyn Watch) -> Result<(), AnalysisError> {
    let test = at_rest::setup(bridge)?;
    let solution = test.solve(bridge, WantedSlices::default(), watch)?;
    found.positions_at_rest = positions(bridge, &test, &solution);
    let own = test.setup.assumptions.iter().filter(|note| !found.assumptions.contains(note));
    let own: Vec<Note> = own.cloned().collect();
    found.assumptions.extend(own);
    found.iterations_total += solution.log.iter().map(|step| step.iterations as u64).sum::<u64>();
    if solution.status != PassageStatus::Completed {
        found.status = solution.status;
        found.warnings.extend(broken(&solution));
        found.reason = solution.reason;
    }
    Ok(())
}

/// The positions that were solved, and what was read in them.
fn positions(bridge: &Bridge, test: &AtRest, solution: &Solution) -> Vec<PositionAtRest> {
    let solved = solution.values.first().map_or(0, Vec::len);
    let read = bridge.load_test.as_ref().map(|test| &test.readings.values[..]).unwrap_or_default();
    let of = |(k, name): (usize, &String)| PositionAtRest {
        name: name.clone(),
        values: solution.values.iter().map(|values| values[k]).collect(),
        readings: read.iter().map(|row| row.get(k).copied().flatten()).collect(),
    };
    test.names.iter().take(solved).enumerate().map(of).collect()
}

/// What a solution that broke off warns of.
fn broken(solution: &Solution) -> Option<Warning> {
    let reason = solution.reason.clone().filter(|_| solution.status == PassageStatus::NotConverged)?;
    Some(warning::Service::BrokenPassage { reason }.into())
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
    let mut warnings: Vec<Warning> = broken(&solution).into_iter().collect();
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
        positions_at_rest: Vec::new(),
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
mod at_rest_tests;
#[cfg(test)]
mod patch_tests;
#[cfg(test)]
pub(super) mod road_tests;
#[cfg(test)]
mod tests;
