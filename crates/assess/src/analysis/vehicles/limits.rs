//! What a sweep of vehicles leaves out, and what its vehicles rest on: said in the result.

use super::across;
use crate::vehicles::Chosen;
use bridge::Bridge;
use outcome::vehicles::VehicleSweep;
use outcome::warning::{self, Warning};
use rules::{Confidence, Ways};

/// Warnings of what vehicles rest on and of what is left out. `beyond`: load models left out because of their spans.
pub fn of_vehicles(bridge: &Bridge, vehicles: &[Chosen], found: &VehicleSweep, beyond: &[String]) -> Vec<Warning> {
    let mut list = Vec::new();
    // Vehicles with the same source together.
    let mut doubtful: Vec<(String, Vec<&str>)> = Vec::new();
    for chosen in vehicles {
        let source = &chosen.source;
        if !matches!(source.confidence, Confidence::Read) {
            let note = if source.note.is_empty() { String::new() } else { format!("; {}", source.note) };
            let said = format!("({}): {}{note}", source.confidence.word(), source.text);
            match doubtful.iter_mut().find(|(known, _)| *known == said) {
                Some((_, codes)) => codes.push(&chosen.vehicle.code),
                None => doubtful.push((said, vec![&chosen.vehicle.code])),
            }
        }
    }
    let doubtful: Vec<String> =
        doubtful.into_iter().map(|(said, codes)| format!("{} {said}", codes.join(", "))).collect();
    if !doubtful.is_empty() {
        let message = format!("axles and distances that were not read in their standard: {}", doubtful.join(". "));
        list.push(Warning::new(warning::VEHICLE_NOT_READ, message));
    }
    if !beyond.is_empty() {
        let message = format!("spans of this bridge are too long for load models of the rule: {}", beyond.join("; "));
        list.push(Warning::new(warning::SPAN_TOO_LONG, message));
    }
    if bridge.carriageway.as_ref().is_none_or(|asked| asked.lanes.is_none() || asked.edge_distance.is_none()) {
        let mut ways: Vec<Ways> = Vec::new();
        vehicles.iter().filter(|v| found.vehicles.iter().any(|s| s.code == v.vehicle.code)).for_each(|v| {
            if !ways.contains(&v.ways) {
                ways.push(v.ways);
            }
        });
        let told: Vec<String> = ways.into_iter().map(|ways| assumed(bridge, ways)).collect();
        let message = format!("the file does not say where vehicles may stand across the bridge: {}", told.join("; "));
        list.push(Warning::new(warning::ACROSS_ASSUMED, message));
    }
    list.extend(crate::analysis::caveats::skew(bridge));
    let rail = vehicles.iter().any(|v| v.ways == Ways::Rail);
    let words = match bridge.sweep.as_ref().filter(|plan| plan.braking_given) {
        Some(plan) => {
            let reason = plan.braking_reason.as_ref().map_or(String::new(), |reason| format!(" ({reason})"));
            format!("the file writes braking = 0{reason}")
        }
        None if rail => "braking and traction of trains are left out".to_owned(),
        None => "braking is left out".to_owned(),
    };
    list.push(Warning::new(
        warning::NO_LONGITUDINAL,
        format!("loads stand vertically: {words}; {}", across::sideways(bridge)),
    ));
    list
}

/// What was assumed of lanes and edges.
fn assumed(bridge: &Bridge, ways: Ways) -> String {
    let (lanes, apart) = across::lanes(bridge, ways);
    let given = bridge.carriageway.clone().unwrap_or_default();
    let (what, abreast) = match ways {
        Ways::Road => ("vehicles on a road", "abreast"),
        Ways::Rail => ("trains", "on tracks"),
    };
    let lanes = match (given.lanes, lanes) {
        (Some(_), _) => String::new(),
        (None, 1) => format!("{what}: one at a time"),
        (None, count) => format!("{what}: up to {count} {abreast}, {apart} m apart"),
    };
    let edge = match given.edge_distance {
        Some(_) => "",
        None => "none nearer to the edge than its load spreads",
    };
    [lanes.as_str(), edge].into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
}
