//! Vehicles that move, on every state of a bridge: for each vehicle the least counts.
//!
//! States that count no strength which may be lost are moved over whole; what strength adds is asked for in the governing case alone.

use super::super::AnalysisError;
use super::super::parallel::portion;
use super::super::vehicles::{case_by_itself, worst_of};
use super::standing::{Standing, hurts, leading, not_counted, warned};
use super::states::{State, states_of_moving};
use bridge::Bridge;
use mechanics::watch::Watch;
use outcome::collapse::Status;
use outcome::help::{Help, WithHelp};
use outcome::note::Size;
use outcome::sweep::Ended;
use outcome::vehicles::{Swept, VehicleSweep};
use outcome::warning;

/// A sweep of one state.
type Method<'a> = &'a dyn Fn(&Bridge, &mut dyn Watch) -> Result<VehicleSweep, AnalysisError>;

/// Moves vehicles over a bridge with what helps it left out.
pub(crate) fn moved(bridge: &Bridge, watch: &mut dyn Watch, method: Method<'_>) -> Result<VehicleSweep, AnalysisError> {
    let states = states_of_moving(bridge);
    if states.len() == 1 {
        return method(bridge, watch);
    }
    let whole: Vec<&State<Bridge>> = states.iter().filter(|state| !state.counts_strength()).collect();
    let parts = whole.len() as f64;
    let mut runs: Vec<VehicleSweep> = Vec::with_capacity(whole.len());
    for (k, state) in whole.iter().enumerate() {
        let part = &mut portion(watch, [k as f64 / parts, (k + 1) as f64 / parts]);
        // The second method takes minutes: it is asked for in the state that leads, mostly the first.
        let run = if k == 0 { method(&state.bridge, part) } else { method(&quickly(&state.bridge), part) }?;
        if run.status() == Ended::Cancelled {
            return Ok(run);
        }
        runs.push(run);
    }
    let (base, mut found) = worst_of(&runs);
    if base > 0 && bridge.sweep.as_ref().is_some_and(|plan| plan.discrete_elements) {
        runs[base] = method(&whole[base].bridge, &mut portion(watch, [1.0, 1.0]))?;
        found = worst_of(&runs).1;
    }
    for (k, vehicle) in found.vehicles.iter_mut().enumerate() {
        least_permissible(&runs, k, vehicle);
        let mut standings: Vec<Standing> =
            whole.iter().zip(&runs).map(|(state, run)| standing(&state.helps, &run.vehicles[k])).collect();
        let lead = leading(&standings);
        let described = states.iter().find(|state| state.counts_strength()).filter(|_| found.governing == Some(k));
        if let (Some(state), Some(case)) = (described, &vehicle.case) {
            let factor = case_by_itself(&state.bridge, &vehicle.code, case, &mut portion(watch, [1.0, 1.0]))?;
            let numbers =
                WithHelp { helps: state.helps.clone(), status: Status::Collapsed, factor, ..WithHelp::default() };
            standings.extend(factor.map(|size| Standing { size, numbers }));
        }
        vehicle.not_counted = not_counted(&standings, lead);
        if found.governing == Some(k) {
            found.assumptions.extend(hurts(&standings, lead, told));
        }
    }
    warn(&mut found);
    Ok(found)
}

/// The same without discrete elements for the governing case.
fn quickly(bridge: &Bridge) -> Bridge {
    let mut own = bridge.clone();
    own.sweep.iter_mut().for_each(|plan| plan.discrete_elements = false);
    own
}

/// A state that should not be met in service is met at the least factor of any run.
fn least_permissible(runs: &[VehicleSweep], k: usize, vehicle: &mut Swept) {
    let Some(own) = &mut vehicle.deformable else { return };
    for other in runs.iter().filter_map(|run| run.vehicles[k].deformable.as_ref()).flat_map(|one| &one.permissible) {
        match own.permissible.iter_mut().find(|known| known.criterion == other.criterion) {
            Some(known) if other.adequacy < known.adequacy => *known = *other,
            Some(_) => {}
            None => own.permissible.push(*other),
        }
    }
}

fn standing(helps: &[Help], vehicle: &Swept) -> Standing {
    let numbers =
        WithHelp { helps: helps.to_vec(), status: vehicle.status, factor: vehicle.factor(), ..WithHelp::default() };
    Standing { size: vehicle.size(), numbers }
}

/// The number of a state.
fn told(of: &WithHelp) -> Size {
    Size::Adequacy(of.factor)
}

/// What is told of the governing vehicle, and of all where fill presses.
fn warn(found: &mut VehicleSweep) {
    let pressed = found.vehicles.iter().filter_map(|one| {
        let with = one.not_counted.with(Help::FillPressure)?.factor?;
        Some((one.code.clone(), one.factor()?, with))
    });
    let vehicles: Vec<_> = pressed.collect();
    if !vehicles.is_empty() {
        found.warnings.push(warning::Cover::PressureOfVehicles { vehicles }.into());
    }
    let Some(governing) = found.governing.and_then(|k| found.vehicles.get(k)) else { return };
    if !governing.not_counted.left_out.is_empty() {
        let own = Size::Adequacy(governing.factor());
        let warning = warned(&governing.not_counted, Some(&governing.code), own, told);
        found.warnings.extend(warning);
    }
}
