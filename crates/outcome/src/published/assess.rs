//! Lists of `extrados.assess/1`, and its table.

use super::objects::{Object, list, object};
use super::rows::{Quoted, row};
use crate::checked::{self, Checked};
use crate::note::{self, Note};
use crate::statics::Statics;
use crate::warning::Warning;
use serde::Serialize;
use serde_json::{Value, json};

/// Every comparison that was made.
pub(crate) fn checks(checked: &[Checked]) -> Vec<Object> {
    let made = checked.iter().flat_map(|check| check.outcome.iter().flatten().map(move |finding| (check, finding)));
    list(made, |(check, finding)| finding.object(check))
}

/// Checks that could not be made.
pub(crate) fn not_made(checked: &[Checked]) -> Vec<Object> {
    let not_made = checked.iter().filter_map(|check| Some((check, check.outcome.as_ref().err()?)));
    list(not_made, |(check, why)| why.object(check))
}

/// The comparison that governs.
pub(crate) fn worst(checked: &[Checked]) -> Option<Object> {
    let (check, finding) = checked::worst(checked)?;
    Some(object! {
        code: check.code,
        title: check.title,
        load_model: finding.load_model,
        utilisation: finding.utilisation,
        met: finding.met(),
    })
}

/// What was found as it is kept, but for its notes: assumptions are sentences, a warning is a pair of code and sentence.
pub fn with_sentences(found: &impl Serialize, assumptions: &[Note], warnings: &[Warning]) -> Value {
    let mut value = json!(found);
    value["assumptions"] = json!(note::words(assumptions));
    value["warnings"] = warnings.iter().map(|warning| json!([warning.code(), warning.message()])).collect();
    value
}

/// Weights and reactions at rest, per metre of width.
pub(crate) fn statics(found: &Statics) -> Object {
    object! {
        dead_load_kn_per_m: 1e-3 * found.total(),
        width_m: found.width,
        weights: list(&found.weights, |one| object! { part: one.part, kn_per_m: 1e-3 * one.force, }),
        not_in_the_loads: list(&found.apart, |one| object! { part: one.part, kn: one.weight.map(|weight| 1e-3 * weight), why: one.why, }),
        reactions: list(&found.reactions, |one| object! {
            place: one.place,
            vertical_kn_per_m: 1e-3 * one.vertical,
            thrust_kn_per_m: 1e-3 * one.horizontal,
            eccentricity_m: one.eccentricity,
            depth_m: one.depth,
            pressure_mpa: one.pressure.map(|pressure| 1e-6 * pressure),
        }),
        assumptions: note::words(&found.assumptions),
    }
}

/// The checks as a table.
pub fn checks_table(checked: &[Checked]) -> String {
    let mut csv = String::from("code,title,load_model,value,limit,unit,utilisation,met,basis\n");
    for check in checked {
        for finding in check.outcome.iter().flatten() {
            row!(
                &mut csv,
                check.code,
                Quoted(&check.title),
                Quoted(&finding.load_model),
                finding.value,
                finding.limit,
                finding.unit.word(),
                finding.utilisation,
                finding.met(),
                Quoted(&finding.basis)
            );
        }
    }
    csv
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::facts::VehicleFacts;
    use crate::warning::Joints;

    #[test]
    fn facts_are_published_with_sentences() {
        let (note, warning) = (note::Moving::Adequacy, Joints::TwoPoints);
        let (assumptions, warnings) = (vec![note.clone().into()], vec![warning.clone().into()]);
        let facts = VehicleFacts { assumptions, warnings, ..VehicleFacts::default() };
        let value = with_sentences(&facts, &facts.assumptions, &facts.warnings);
        assert_eq!(value["assumptions"], json!([note.to_string()]));
        assert_eq!(value["warnings"], json!([["A176", warning.to_string()]]));
    }
}
