//! Vehicles moved over a bridge by limit analysis: every position, both ways, every run of neighbouring axles, under the
//! factors of a rule.
//!
//! Read in the order of the method: `weights` lists the combinations of factors on dead load, `factored` gives loads and
//! strengths their factors, `traffic` puts vehicles under them, `cases` lists places, `standing` what stands there, `search` tells what `moving` finds of it, `continuum` asks what governs on fill that yields, `deformable` follows the cases on deformable joints, `discrete` makes the governing case by
//! discrete elements; `restrictions` looks for a weight limit.

pub(super) mod across;
mod beside;
mod braking;
mod cases;
mod continuum;
mod cracked;
mod deformable;
mod discrete;
mod driven;
mod factored;
mod limits;
mod restrictions;
#[cfg(test)]
mod screened_tests;
mod search;
mod seeds;
#[cfg(test)]
mod settled_tests;
mod standing;
#[cfg(test)]
pub(crate) mod tests;
mod told;
mod traffic;
mod weights;

pub use across::ROAD_LANE;
pub(super) use braking::worst_of;
pub(super) use driven::Asked;
pub use driven::{Carried, Driven};
pub use restrictions::vehicle_sweep_with_restrictions;
pub(super) use standing::Standing;

use super::parallel::portion;
use super::state::{self, Change};
use super::{AnalysisError, default_stiffness, engine, moving, policy};
use crate::vehicles::{Chosen, chosen, left_out};
use bridge::{Bridge, JointContact, Method};
use mechanics::watch::Watch;
use outcome::collapse::{Collapse, Status};
use outcome::note::{self, Governing, Note};
use outcome::sweep::Ended;
use outcome::vehicles::{Case, Swept, VehicleSweep};
use outcome::warning::{self, OpenPositions, RecalledFactor, Warning};
use rules::{Acting, Confidence, Rule, Source};
use structure::discretise::DiscretiseError;
use structure::discretise::continuum::wanted;
use traffic::Traffic;

/// Moves the vehicles of the bridge's plan over it: as they stand, and where the plan has braking also with that share of their loads
/// along the bridge, to the right and to the left. The least factor of each vehicle counts. Where the onlooker wishes to stop, what is done
/// by then is returned.
///
/// # Errors
/// A vehicle or a rule that is not known, or a bridge that cannot be analysed.
pub fn vehicle_sweep(bridge: &Bridge, watch: &mut dyn Watch) -> Result<VehicleSweep, AnalysisError> {
    policy::moved(bridge, watch, &with_braking)
}

/// The same on one state of the bridge.
fn with_braking(bridge: &Bridge, watch: &mut dyn Watch) -> Result<VehicleSweep, AnalysisError> {
    let share = bridge.sweep.as_ref().map_or(0.0, |plan| plan.braking);
    if share == 0.0 {
        return moved(bridge, watch);
    }
    if !bridge.plan.method.follows_moving_loads() && wanted(bridge).is_some() {
        return Err(DiscretiseError::Horizontal { what: "fill as a continuum" }.into());
    }
    let mut own = bridge.clone();
    let mut runs = Vec::new();
    for (k, sign) in [0.0, 1.0, -1.0].into_iter().enumerate() {
        own.sweep.iter_mut().for_each(|plan| plan.braking = sign * share);
        let part = &mut portion(watch, [k as f64 / 3.0, (k + 1) as f64 / 3.0]);
        let run = moved(&own, part)?;
        let stopped = run.status() == Ended::Cancelled;
        runs.push(run);
        if stopped {
            break;
        }
    }
    let (_, mut found) = worst_of(&runs);
    found.warnings.retain(|warning| warning.code() != warning::NO_LONGITUDINAL);
    found.assumptions.push(note::Moving::Braking { share, sideways: across::sideways(bridge) }.into());
    Ok(found)
}

/// Moves vehicles with one share of their loads along the bridge.
fn moved(bridge: &Bridge, watch: &mut dyn Watch) -> Result<VehicleSweep, AnalysisError> {
    let plan = bridge.sweep.as_ref().ok_or(AnalysisError::Missing {
        what: "[sweep]",
        why: "it says which vehicles are moved, and by which rule",
    })?;
    let (rule, vehicles) = chosen(bridge, plan)?;
    let own = default_stiffness::for_paths(bridge);
    let (bridge, taken) = (own.as_ref().map_or(bridge, |own| &own.0), own.as_ref().and_then(|own| own.1.clone()));
    let step = cases::places_apart(bridge, plan);
    let weights = weights::combinations(bridge, &rule);
    let gives = bridge.plan.method.follows_moving_loads();
    let yields = !gives && wanted(bridge).is_some();
    let before = if vehicles.iter().any(|chosen| chosen.acting.beside.is_some()) { 0.3 } else { 0.0 };
    let (first_part, rigid_part) = ([0.0, before], if gives || yields { [before, 0.5] } else { [before, 1.0] });
    let vehicles = beside::loaded(bridge, (&rule, plan), vehicles, (&weights, step), &mut portion(watch, first_part))?;
    let traffic = Traffic::new(bridge, (&rule, plan), (&vehicles, &weights))?;
    let mut swept = search::all(&traffic, (step, true), &mut portion(watch, rigid_part))?;
    let answered = swept.iter().all(|one| !matches!(one.status, Status::Cancelled | Status::UnstableUnderSelfWeight));
    let done = {
        let second_part = &mut portion(watch, [0.5, 1.0]);
        match answered {
            true if gives => deformable::beside(bridge, &traffic, (&mut swept, step), second_part)?,
            true if yields => continuum::beside(&traffic, &mut swept, second_part)?,
            _ => true,
        }
    };
    if !done {
        swept.iter_mut().for_each(Swept::cancel);
    }
    let governing = swept
        .iter()
        .enumerate()
        .filter_map(|(k, s)| s.factor().map(|a| (k, a)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(k, _)| k);
    let mut found = VehicleSweep {
        bridge: bridge.name.clone(),
        rule,
        weights,
        vehicles: swept,
        governing,
        restrictions: Vec::new(),
        collapse: None,
        discrete_elements: None,
        step,
        warnings: Vec::new(),
        assumptions: Vec::new(),
    };
    if let Some((k, case)) = governing.and_then(|k| found.vehicles[k].case.clone().map(|case| (k, case)))
        && found.status() != Ended::Cancelled
    {
        let factored = factored::bridge(bridge, &found.rule, &case.weights);
        let one = factored::with_case(&factored, plan, &found.rule, &vehicles[k], &case);
        let mut run = alone(bridge, &one, found.vehicles[k].is_deformable_governing(), watch)?;
        let capacity = found.rule.capacity_factor();
        match run.status {
            Status::Cancelled => {
                let least = found.vehicles[k].factor();
                found.vehicles[k].end(false, least);
            }
            _ => found.vehicles[k].governed_by(&run, capacity),
        }
        run.picture.case = Some(told::case(&found.vehicles[k], &case, &one));
        if plan.discrete_elements && run.status != Status::Cancelled {
            let limit = found.vehicles[k].factor();
            found.discrete_elements = Some(discrete::carried(&one, &run, &found.rule, limit, watch));
        }
        found.collapse = Some(Box::new(run));
    }
    notes(bridge, &vehicles, &mut found);
    found.assumptions.extend(beside::told(&vehicles).map(Note::from));
    found.warnings.extend(taken);
    Ok(found)
}

/// The governing case by itself, by the method that gives less.
fn alone(bridge: &Bridge, case: &Bridge, gives: bool, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    if !gives {
        return engine::raising(Method::Limit, case).load(case, None, watch);
    }
    let mut case = state::with(case, &[Change::Method(Method::Path), Change::OpenSteps]);
    case.plan.contact = bridge.plan.contact;
    engine::by(Method::Path).load(&case, None, watch)
}

/// The adequacy factor of one case of a vehicle on another state of the bridge, by the methods of its plan; none where it finds none.
pub(super) fn case_by_itself(
    bridge: &Bridge,
    vehicle: &str,
    case: &Case,
    watch: &mut dyn Watch,
) -> Result<Option<f64>, AnalysisError> {
    let Some(plan) = &bridge.sweep else { return Ok(None) };
    let (rule, vehicles) = chosen(bridge, plan)?;
    let Some(chosen) = vehicles.iter().find(|one| one.vehicle.code == vehicle) else { return Ok(None) };
    let own = default_stiffness::for_paths(bridge);
    let bridge = own.as_ref().map_or(bridge, |own| &own.0);
    let one = factored::with_case(&factored::bridge(bridge, &rule, &case.weights), plan, &rule, chosen, case);
    let run = alone(bridge, &one, bridge.plan.method.follows_moving_loads(), watch)?;
    Ok(run.carried().map(|load| load / run.reference_load * rule.capacity_factor()))
}

fn notes(bridge: &Bridge, vehicles: &[Chosen], found: &mut VehicleSweep) {
    let rule = &found.rule;
    let factors = uncertain(rule, &found.vehicles);
    if !factors.is_empty() {
        found.warnings.push(warning::Vehicles::Recalled { rule: rule.code.clone(), factors }.into());
    }
    for chosen in vehicles.iter().filter(|chosen| !rule.ways.contains(&chosen.ways)) {
        let (rule, vehicle) = (rule.code.clone(), chosen.vehicle.code.clone());
        found.warnings.push(warning::Vehicles::OtherWays { rule, vehicle }.into());
    }
    found.warnings.extend(not_converged(&found.vehicles));
    // What is to be said of the governing case is to be said of the sweep.
    let of_case = found.collapse.iter().flat_map(|collapse| &collapse.warnings).cloned();
    found.warnings.extend(of_case.collect::<Vec<_>>());
    let beyond = bridge.sweep.as_ref().map_or(Vec::new(), |plan| left_out(bridge, plan));
    found.warnings.extend(limits::of_vehicles(bridge, vehicles, found, &beyond));
    found.warnings.extend(near_the_limit(found));
    let slides = found.vehicles.iter().filter(|v| v.without_dilation.is_some()).count();
    let assumed = [note::Moving::Adequacy].into_iter().chain(of_weights(found)).chain([
        note::Moving::PositionsOfVehicles { apart: found.step },
        note::Moving::UniformLoads,
        note::Moving::Across { vehicles: found.vehicles.iter().map(|v| (v.code.clone(), v.across.clone())).collect() },
        moving::outside(found.vehicles.iter().flat_map(|v| &v.sections)),
    ]);
    found.assumptions = assumed.map(Note::from).collect();
    if found.vehicles.iter().any(|v| v.by_interior_point > 0) {
        found.assumptions.push(note::Moving::FarAbove { times: moving::FAR_ABOVE }.into());
    }
    if slides > 0 {
        found.assumptions.push(note::Moving::Sliding { vehicles: slides }.into());
    }
    found.warnings.extend(told::broken_off(&found.vehicles));
    found.assumptions.push(told::assumed(&found.vehicles).into());
    if found.discrete_elements.is_some() && bridge.plan.contact != Some(JointContact::Distributed) {
        found.warnings.push(warning::Joints::TwoPoints.into());
    }
    if let Some(by) = found.discrete_elements.as_ref().and_then(|c| c.inset) {
        found.assumptions.push(note::Moving::Inset { by }.into());
    }
    found.assumptions.extend(super::notes::particles_as_weight(bridge));
    if bridge.continuum.is_some() {
        found.assumptions.push(note::Soil::InSweepOfVehicles.into());
    }
    if bridge.fill_pressure.is_some_and(|fill| fill.applies) {
        found.assumptions.push(note::Fill::PressesInSweep.into());
    }
    let factors = rule.listed().iter().map(|(name, f)| ((*name).to_owned(), f.value)).collect();
    let acting = by_acting(&found.vehicles).into_iter().map(|(models, acting)| (models, acting.clone())).collect();
    let told = note::Moving::Rule { code: rule.code.clone(), factors, acting };
    found.assumptions.push(told.into());
}

/// What is to be said of vehicles with positions that were not answered.
fn not_converged(all: &[Swept]) -> Option<Warning> {
    let told = |of: &Swept| OpenPositions {
        code: of.code.clone(),
        open: of.positions_not_converged,
        of: of.envelope.len(),
        at_most: of.adequacy_at_most,
    };
    let vehicles: Vec<_> = all.iter().filter(|of| of.positions_not_converged > 0).map(told).collect();
    (!vehicles.is_empty()).then(|| warning::Vehicles::PositionsOpen { vehicles }.into())
}

/// Factors that are recalled and not read, each with its value: the rule's, then those on the loads of the vehicles.
fn uncertain(rule: &Rule, vehicles: &[Swept]) -> Vec<RecalledFactor> {
    let recalled = |source: &Source| source.confidence == Confidence::Recalled;
    let own = rule.listed().into_iter().filter(|(name, f)| *name != "live load" && recalled(&f.source));
    let mut list: Vec<_> = own.map(|(name, f)| RecalledFactor::Named(name.to_owned(), f.value)).collect();
    for (models, acting) in by_acting(vehicles) {
        if recalled(&acting.live_load.source) {
            list.push(RecalledFactor::LiveLoad(acting.live_load.value, models.clone()));
        }
        if acting.sources().into_iter().any(recalled) {
            list.push(RecalledFactor::Impact(Box::new(acting.clone()), models.clone()));
        }
        if let Some(beside) = acting.beside.as_ref().filter(|beside| recalled(&beside.source)) {
            list.push(RecalledFactor::Beside(beside.share, beside.vehicles.clone(), models));
        }
    }
    list
}

/// What the rule does with loads, and the load models that it does it with.
pub fn by_acting(vehicles: &[Swept]) -> Vec<(String, &Acting)> {
    let mut list: Vec<(Vec<&str>, &Acting)> = Vec::new();
    for v in vehicles {
        match list.iter_mut().find(|(_, acting)| **acting == v.acting) {
            Some((models, _)) if !models.contains(&v.model.as_str()) => models.push(&v.model),
            Some(_) => {}
            None => list.push((vec![&v.model], &v.acting)),
        }
    }
    list.into_iter().map(|(models, acting)| (models.join(", "), acting)).collect()
}

/// Vehicles that would not be met if discrete elements took as much off them as off the governing one.
fn near_the_limit(found: &VehicleSweep) -> Option<Warning> {
    let governing = &found.vehicles.get(found.governing?)?.code;
    let second = found.discrete_elements.as_ref()?;
    let share = second.adequacy? / second.limit?;
    let met = found.vehicles.iter().filter_map(|v| Some((v.code.clone(), v.adequacy?)));
    let near = met.filter(|(code, adequacy)| code != governing && *adequacy >= 1.0 && adequacy * share < 1.0);
    let vehicles: Vec<_> = near.collect();
    (!vehicles.is_empty())
        .then(|| warning::Vehicles::NearTheLimit { governing: governing.clone(), share, vehicles }.into())
}

/// Which factors on weights were tried, and which govern.
fn of_weights(found: &VehicleSweep) -> Option<note::Moving> {
    let combinations = found.weights.len();
    if combinations == 1 {
        return Some(note::Moving::OneWeight { weights: found.weights[0] });
    }
    let least = found.governing.and_then(|k| found.vehicles.get(k)).or(found.vehicles.first());
    let governing = match least.and_then(|v| v.weights.map(|w| (v, w))) {
        Some((v, weights)) if v.adequacy.is_some() => Governing::Vehicle { code: v.code.clone(), weights },
        Some((v, weights)) if v.status == Status::UnstableUnderSelfWeight => Governing::Falls { weights },
        Some((v, _)) => Governing::Unanswered { code: v.code.clone() },
        None => Governing::Nothing,
    };
    (combinations > 1).then_some(note::Moving::EveryWeight { combinations, governing })
}
