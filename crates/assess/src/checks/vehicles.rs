//! Vehicles under the factors of a rule.

use super::{Card, Check, Finding, NotMade, of};
use crate::assessment::Assessment;

/// The check.
pub struct Vehicles;

impl Check for Vehicles {
    fn card(&self) -> Card {
        Card {
            code: "C204",
            title: "adequacy of vehicles",
            clause: "adequacy factor of every vehicle under the factors of its rule",
            text: "The factor by which all loads of a vehicle may be multiplied before a mechanism forms, by limit analysis over every position, \
                   both ways and every run of neighbouring axles. Partial factors, impact, dispersal, effective width and condition are those of \
                   the rule of [sweep], each with its source in the report; the limit is therefore 1. Where it is not met, look at the governing case: \
                   its position, its axles, and which factors are recalled and not read. \
                   With confirm = true in [sweep] the governing case is made by discrete elements too, and the smaller number counts.",
            source: "the rule of [sweep]; plastic theory of masonry arches (Heyman 1969)",
        }
    }

    fn run(&self, a: &Assessment) -> Result<Vec<Finding>, NotMade> {
        let facts = of(&a.vehicles)?;
        if let Some(open) = facts.vehicles.iter().find(|one| one.status == "not-converged") {
            return Err(NotMade { why: format!("limit analysis of {} came to no end", open.code), failed: true });
        }
        let bounded = facts.vehicles.iter().filter(|one| one.adequacy.is_some() || one.status != "locks");
        let list: Vec<Finding> = bounded
            .map(|one| {
                // Joints that deform carry less; the smaller number counts where both were found.
                let governs = facts.governing.as_ref() == Some(&one.code);
                let second = facts.adequacy_by_discrete_elements.filter(|_| governs);
                let by_limit = one.adequacy.unwrap_or(0.0);
                let value = by_limit.min(second.unwrap_or(f64::INFINITY));
                let method = match value < by_limit {
                    true => format!("discrete elements (limit analysis {by_limit:.3})"),
                    false => "limit analysis".to_owned(),
                };
                Finding {
                    load_model: one.code.clone(),
                    value,
                    limit: 1.0,
                    unit: "",
                    utilisation: if value > 0.0 { 1.0 / value } else { f64::MAX },
                    basis: match one.position_m {
                        Some(x) => format!(
                            "{method}; {}; {}, first axle at {x:.2} m; factor {:.3} on axles",
                            one.title, one.case, one.load_factor
                        ),
                        None => format!("{}; {}", one.title, one.status),
                    },
                    position: one.position_m,
                    columns: None,
                }
            })
            .collect();
        match list.is_empty() {
            true => Err(NotMade::because("no vehicle makes a mechanism of the bridge: the factors have no bound")),
            false => Ok(list),
        }
    }
}
