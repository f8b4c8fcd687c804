//! Vehicles of the file's [sweep], as facts.

use super::spoken;
use crate::analysis::vehicles::{Swept, VehicleSweep};
use crate::wire::{SweptFacts, VehicleFacts};

/// The facts of a sweep of vehicles.
pub fn vehicle_facts(found: &VehicleSweep) -> VehicleFacts {
    let source = |source: &rules::Source| format!("{} ({}, {})", source.text, source.date, source.confidence.word());
    VehicleFacts {
        rule: format!("{}: {}", found.rule.title, source(&found.rule.source)),
        factors: found
            .rule
            .listed()
            .into_iter()
            .map(|(name, factor)| [name.to_owned(), factor.value.to_string(), source(&factor.source)])
            .collect(),
        vehicles: found.vehicles.iter().map(swept).collect(),
        step_m: found.step,
        assumptions: found.assumptions.clone(),
        warnings: spoken(&found.warnings),
    }
}

fn swept(one: &Swept) -> SweptFacts {
    let case = one.case.as_ref().map_or(String::new(), |case| {
        let axles = match case.axles {
            Some([first, last]) if first == last => format!("axle {}", first + 1),
            Some([first, last]) => format!("axles {} to {}", first + 1, last + 1),
            None => "uniform loads alone".to_owned(),
        };
        let arrangement = if case.arrangement.is_empty() { String::new() } else { format!(", {}", case.arrangement) };
        format!("{axles}, driving to the {}{arrangement}", case.direction.word())
    });
    SweptFacts {
        code: one.code.clone(),
        title: one.title.clone(),
        status: one.status.word().to_owned(),
        adequacy: one.adequacy,
        position_m: one.case.as_ref().map(|case| case.position),
        case,
        effective_width_m: one.effective_width,
        load_factor: one.load_factors[0],
    }
}
