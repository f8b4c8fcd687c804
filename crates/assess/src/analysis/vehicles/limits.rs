//! What a sweep of vehicles leaves out, and what its vehicles rest on: said in the result.

use super::across;
use crate::vehicles::Chosen;
use bridge::Bridge;
use outcome::vehicles::VehicleSweep;
use outcome::warning::{self, Braking, Lanes, TooLong, Warning};
use rules::{Confidence, Source, Ways};

/// Warnings of what vehicles rest on and of what is left out. `beyond`: load models left out because of their spans.
pub(super) fn of_vehicles(
    bridge: &Bridge,
    vehicles: &[Chosen],
    found: &VehicleSweep,
    beyond: &[TooLong],
) -> Vec<Warning> {
    let mut list = Vec::new();
    list.extend(not_read(vehicles));
    let values: Vec<String> = crate::plan_facts::doubtful_files(bridge).iter().map(ToString::to_string).collect();
    if !values.is_empty() {
        list.push(warning::Vehicles::DoubtfulFile { values }.into());
    }
    if !beyond.is_empty() {
        list.push(warning::Vehicles::SpanTooLong { models: beyond.to_vec() }.into());
    }
    if bridge.carriageway.as_ref().is_none_or(|asked| asked.lanes.is_none() || asked.edge_distance.is_none()) {
        let mut ways: Vec<Ways> = Vec::new();
        vehicles.iter().filter(|v| found.vehicles.iter().any(|s| s.code == v.vehicle.code)).for_each(|v| {
            if !ways.contains(&v.ways) {
                ways.push(v.ways);
            }
        });
        let ways = ways.into_iter().map(|ways| assumed(bridge, ways)).collect();
        list.push(warning::Vehicles::AcrossAssumed { ways }.into());
    }
    list.extend(crate::analysis::caveats::skew(bridge));
    let rail = vehicles.iter().any(|v| v.ways == Ways::Rail);
    let braking = match bridge.sweep.as_ref().filter(|plan| plan.braking_given) {
        Some(plan) => Braking::Written(plan.braking_reason.clone()),
        None if rail => Braking::OfTrains,
        None => Braking::OfRoad,
    };
    list.push(warning::Vehicles::NoLongitudinal { braking, sideways: across::sideways(bridge) }.into());
    list
}

/// Vehicles whose loads or distances nobody read, those with the same source together.
pub(super) fn not_read(vehicles: &[Chosen]) -> Option<Warning> {
    let mut sources: Vec<(Vec<String>, Source)> = Vec::new();
    for chosen in vehicles.iter().filter(|chosen| chosen.source.confidence != Confidence::Read) {
        let (code, source) = (chosen.vehicle.code.clone(), &chosen.source);
        let same = |known: &Source| {
            (known.confidence, &known.text, &known.note) == (source.confidence, &source.text, &source.note)
        };
        match sources.iter_mut().find(|(_, known)| same(known)) {
            Some((codes, _)) => codes.push(code),
            None => sources.push((vec![code], source.clone())),
        }
    }
    (!sources.is_empty()).then(|| warning::Vehicles::NotRead { sources }.into())
}

/// What was assumed of lanes and edges.
fn assumed(bridge: &Bridge, ways: Ways) -> Lanes {
    let given = bridge.carriageway.clone().unwrap_or_default();
    let abreast = given.lanes.is_none().then(|| across::lanes(bridge, ways));
    Lanes { ways, abreast, open_edge: given.edge_distance.is_none() }
}
