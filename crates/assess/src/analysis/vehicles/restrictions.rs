//! The weight limit of a bridge that does not carry what its rule asks for: the grades that the rule names, lightest first, up to the first that
//! is not carried.

use super::super::AnalysisError;
use super::super::parallel::portion;
use super::{limits, vehicle_sweep};
use crate::vehicles::{Chosen, chosen, of_model};
use bridge::Bridge;
use mechanics::watch::Watch;
use outcome::sweep::Ended;
use outcome::vehicles::VehicleSweep;

/// Share of the onlooker's progress that the vehicles of the plan have where grades may follow.
const FIRST: f64 = 0.7;

/// Moves the vehicles of the bridge's plan, as [`vehicle_sweep`] does; where one is not carried for whose loads the rule names grades, and none
/// of the plan's vehicles has a grade, the vehicles of these grades as well. They stand apart: no check reads them, and nothing governs among them.
///
/// # Errors
/// Those of [`vehicle_sweep`].
pub fn vehicle_sweep_with_restrictions(bridge: &Bridge, watch: &mut dyn Watch) -> Result<VehicleSweep, AnalysisError> {
    let Some(grades) = grades(bridge) else { return vehicle_sweep(bridge, watch) };
    let mut found = vehicle_sweep(bridge, &mut portion(watch, [0.0, FIRST]))?;
    let short = found.vehicles.iter().any(|one| one.is_carried() == Some(false) && grades.begin_with(&one.code));
    if found.status() != Ended::Cancelled && short {
        let count = grades.vehicles.len() as f64;
        for (k, vehicle) in grades.vehicles.iter().enumerate() {
            let shares = [k, k + 1].map(|k| FIRST + (1.0 - FIRST) * k as f64 / count);
            let alone = asking_for(bridge, &vehicle.vehicle.code);
            let run = vehicle_sweep(&alone, &mut portion(watch, shares))?;
            let carried = run.vehicles.iter().all(|one| one.is_carried() == Some(true));
            found.restrictions.extend(run.vehicles);
            // What stands in the grades above is heavier.
            if !carried {
                break;
            }
        }
        found.warnings.extend(limits::not_read(&grades.vehicles[..found.restrictions.len()]));
    }
    Ok(found)
}

/// Vehicles that stand for grades, lightest first, and those of the plan for which they are looked up.
struct Grades {
    vehicles: Vec<Chosen>,
    of: Vec<String>,
}

impl Grades {
    fn begin_with(&self, code: &str) -> bool {
        self.of.iter().any(|one| one == code)
    }
}

/// The grades that the rule of a plan names; none where it names none, where they do not go with spans like these, or where the plan has asked for
/// grades itself.
fn grades(bridge: &Bridge) -> Option<Grades> {
    let plan = bridge.sweep.as_ref()?;
    let (rule, asked) = chosen(bridge, plan).ok()?;
    let model = rule.restrictions.as_ref().filter(|_| asked.iter().all(|one| one.grade.is_none()))?;
    // Exceptional vehicles have other factors: no grade of normal traffic follows from them.
    let of =
        asked.iter().filter(|one| rule.acts_alike(&one.model, model)).map(|one| one.vehicle.code.clone()).collect();
    let mut vehicles = of_model(bridge, plan, &rule, model).ok()?;
    vehicles.retain(|one| one.grade.is_some());
    vehicles.sort_by_key(|one| one.grade.as_ref().map(|grade| grade.rank));
    Some(Grades { vehicles, of })
}

/// The bridge whose plan has one vehicle, by limit analysis alone.
fn asking_for(bridge: &Bridge, code: &str) -> Bridge {
    let mut own = bridge.clone();
    own.sweep.iter_mut().for_each(|plan| {
        plan.vehicles = vec![code.to_owned()];
        plan.discrete_elements = false;
    });
    own
}
