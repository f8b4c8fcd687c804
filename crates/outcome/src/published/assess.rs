//! `extrados.assess/1`, and its table.

use super::{Object, Quoted, collapse, list, object, row, update};
use crate::assessment::Assessment;
use crate::checked::{Checked, Comparison, governing};
use crate::collapse::Collapse;
use crate::condition::Condition;
use crate::note::{self, Note};
use crate::statics::Statics;
use crate::warning::Warning;
use serde::Serialize;
use serde_json::{Value, json};

/// The result of an assessment; its status is that of the command.
pub fn assessment(a: &Assessment) -> Object {
    let Assessment { facts, checked, verdict, .. } = a;
    let of = |found: &Option<Box<Collapse>>| found.as_deref().map(collapse);
    let made = checked.iter().flat_map(|check| check.outcome.iter().flatten().map(move |finding| (check, finding)));
    let not_made = checked.iter().filter_map(|check| Some((check, check.outcome.as_ref().err()?)));
    let worst = governing(checked).and_then(|(check, finding)| {
        let check = &checked[check];
        Some((check, check.outcome.as_ref().ok()?.get(finding)?))
    });
    object! {
        bridge: a.bridge,
        verdict: verdict.words,
        headline: verdict.headline,
        head: verdict.head(),
        beside: verdict.beside(),
        by: verdict.given.by,
        by_name: verdict.given.name,
        level: verdict.given.level,
        to_confirm: verdict.given.to_confirm.len(),
        factors_to_confirm: verdict.given.to_confirm,
        skipped: verdict.given.skipped,
        load_cases_left_out: verdict.given.load_cases_left_out,
        doubtful: verdict.given.doubtful.iter().map(|one| one.code.clone()).collect::<Vec<_>>(),
        changed_factors: verdict.given.changed_factors,
        taken: verdict.given.taken.iter().map(ToString::to_string).collect::<Vec<_>>(),
        model_factor: verdict.given.model_factor,
        record: verdict.given.record,
        strength_assessed: verdict.strength.assessed,
        missing: verdict.strength.missing,
        qualifications: verdict.strength.qualifications,
        checks: list(made, |(check, finding)| comparison(check, finding)),
        not_made: list(not_made, |(check, why)| object! {
            code: check.code,
            title: check.title,
            why: why.why,
            analysis_failed: why.failed,
        }),
        governing: worst.map(|(check, finding)| object! {
            code: check.code,
            title: check.title,
            load_model: finding.load_model,
            utilisation: finding.utilisation,
            met: finding.met(),
        }),
        condition: list(&a.condition, judged),
        next_steps: list(&a.next, |one| object! {
            action: one.action,
            what: one.what,
            because: one.because,
            rule: one.rule,
        }),
        statics?: a.statics.as_ref().map(statics),
        sensitivity?: facts.sensitivity.made(),
        service?: facts.service.made().map(|facts| with_sentences(facts, &facts.assumptions, &facts.warnings)),
        collapse?: facts.ultimate.made().and_then(|facts| of(&facts.collapse)),
        shortened?: facts.ultimate.made().map(|facts| &facts.shortened),
        vehicles?: facts.vehicles.made().map(|facts| with_sentences(facts, &facts.assumptions, &facts.warnings)),
        cases?: facts.cases.made().map(|facts| with_sentences(facts, &facts.assumptions, &facts.warnings)),
        support_movement?: facts.movement.made().and_then(|facts| of(&facts.collapse)),
        update?: facts.update.made().and_then(|facts| facts.update.as_deref()).map(update),
    }
}

/// What was found as it is kept, but for its notes: assumptions are sentences, a warning is a pair of code and sentence.
pub fn with_sentences(found: &impl Serialize, assumptions: &[Note], warnings: &[Warning]) -> Value {
    let mut value = json!(found);
    value["assumptions"] = json!(note::words(assumptions));
    value["warnings"] = warnings.iter().map(|warning| json!([warning.code(), warning.message()])).collect();
    value
}

/// Weights and reactions at rest, per metre of width.
fn statics(found: &Statics) -> Object {
    object! {
        dead_load_kn_per_m: 1e-3 * found.total(),
        width_m: found.width,
        weights: list(&found.weights, |one| object! { part: one.part, kn_per_m: 1e-3 * one.force, }),
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

/// A check against one of its limits; its columns are those of the railway paper's Table 7, in the check's unit.
fn comparison(check: &Checked, finding: &Comparison) -> Object {
    object! {
        code: check.code,
        title: check.title,
        clause: check.clause,
        load_model: finding.load_model,
        value: finding.value,
        limit: finding.limit,
        unit: finding.unit,
        utilisation: finding.utilisation,
        met: finding.met(),
        needed_for_a_verdict?: finding.needed,
        basis: finding.basis,
        position_m: finding.position,
        columns?: finding.columns.as_ref().map(|row| row.values).map(|[own, design, sum, total, whole]| object! {
            self_weight: own,
            live_load_design_cda: design,
            total_design_cda: sum,
            live_load_total_cda: total,
            total_total_cda: whole,
        }),
    }
}

fn judged(one: &Condition) -> Object {
    object! {
        parameter: one.parameter,
        unit: one.unit,
        before: one.before,
        value: one.after,
        expected_lower: one.expected.map(|range| range[0]),
        expected_upper: one.expected.map(|range| range[1]),
        verdict: one.standing,
        words: one.words,
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
