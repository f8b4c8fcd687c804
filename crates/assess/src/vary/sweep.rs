//! A sweep as an analysis that is repeated: adequacy under vehicles, load factor, and where it governs.

use super::outcome;
use crate::analysis::{self, AnalysisError, Places};
use bridge::Bridge;
use mechanics::watch::Watch;
use outcome::study::Outcome;
use outcome::sweep::Sweep;
use outcome::vehicles::VehicleSweep;
use structure::discretise::bridge_length;

/// Makes it: vehicles where the file has [sweep], its loads otherwise.
pub(super) fn run(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Outcome, AnalysisError> {
    let Some(plan) = &bridge.sweep else { return loads(bridge, watch) };
    // A second opinion on one position is for one bridge.
    let plan = bridge::SweepPlan { discrete_elements: false, ..plan.clone() };
    let bridge = Bridge { sweep: Some(plan), ..bridge.clone() };
    Ok(of_vehicles(&analysis::vehicle_sweep(&bridge, watch)?))
}

fn loads(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Outcome, AnalysisError> {
    let step = bridge_length(bridge) / STEPS;
    Ok(of_loads(&analysis::sweep(bridge, Places::Every(step), true, watch)?))
}

/// Steps over the bridge of a sweep of the file's loads, as `collapse --sweep` has them.
const STEPS: f64 = 100.0;

fn of_vehicles(found: &VehicleSweep) -> Outcome {
    let mut numbers = Vec::new();
    let mut put = |name: String, number: Option<f64>| {
        numbers.extend(number.filter(|number| number.is_finite()).map(|number| (name, number)));
    };
    let governing = found.governing.and_then(|k| found.vehicles.get(k));
    put("adequacy_factor".into(), governing.and_then(|v| v.adequacy));
    put("adequacy_lower_bound".into(), governing.and_then(|v| v.bounds).map(|bounds| bounds[0]));
    put("adequacy_upper_bound".into(), governing.and_then(|v| v.bounds).map(|bounds| bounds[1]));
    put("governing_position_m".into(), governing.and_then(|v| v.case.as_ref()).map(|case| case.position));
    for vehicle in &found.vehicles {
        put(format!("adequacy_factor_of_{}", vehicle.code), vehicle.adequacy);
    }
    outcome(found.status().word(), numbers, &found.warnings)
}

fn of_loads(found: &Sweep) -> Outcome {
    let governing = found.governing.and_then(|k| found.points.get(k));
    let numbers = [
        ("load_factor", governing.and_then(|point| point.load_factor)),
        ("last_stable_load_kn_per_m", governing.and_then(|point| point.collapse_load).map(|load| load / 1e3)),
        ("collapse_load_kn_per_m", governing.and_then(|point| point.collapse_load).map(|load| load / 1e3)),
        ("governing_position_m", governing.map(|point| point.position)),
    ];
    let numbers = numbers.into_iter().filter_map(|(name, number)| Some((name.to_owned(), number?)));
    let numbers = numbers.filter(|(_, number)| number.is_finite()).collect();
    outcome(found.ended().word(), numbers, &found.warnings)
}
