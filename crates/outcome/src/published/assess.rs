//! `extrados.assess/1`.

use super::{CollapseObject, Run, UpdateObject};
use crate::assessment::Assessment;
use crate::checked::{Checked, Comparison, governing};
use crate::collapse::Collapse;
use crate::condition::Condition;
use crate::facts::{SensitivityFacts, ServiceFacts, VehicleFacts};
use serde::Serialize;

/// The result of an assessment. Status, warnings and times are those of the command.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AssessObject {
    bridge: String,
    verdict: String,
    headline: &'static str,
    strength_assessed: bool,
    missing: Vec<String>,
    qualifications: Vec<String>,
    checks: Vec<CheckObject>,
    not_made: Vec<NotMadeObject>,
    governing: Option<GoverningObject>,
    condition: Vec<ConditionObject>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sensitivity: Option<SensitivityFacts>,
    #[serde(skip_serializing_if = "Option::is_none")]
    service: Option<ServiceFacts>,
    #[serde(skip_serializing_if = "Option::is_none")]
    collapse: Option<CollapseObject>,
    #[serde(skip_serializing_if = "Option::is_none")]
    vehicles: Option<VehicleFacts>,
    #[serde(skip_serializing_if = "Option::is_none")]
    support_movement: Option<CollapseObject>,
    #[serde(skip_serializing_if = "Option::is_none")]
    update: Option<UpdateObject>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct CheckObject {
    code: String,
    title: String,
    clause: String,
    load_model: String,
    value: f64,
    limit: f64,
    unit: &'static str,
    utilisation: f64,
    met: bool,
    basis: String,
    position_m: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    columns: Option<ColumnsObject>,
}

/// The columns of the railway paper's Table 7, in the check's unit.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct ColumnsObject {
    self_weight: f64,
    live_load_design_cda: f64,
    total_design_cda: f64,
    live_load_total_cda: f64,
    total_total_cda: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct NotMadeObject {
    code: String,
    title: String,
    why: String,
    analysis_failed: bool,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct GoverningObject {
    code: String,
    title: String,
    load_model: String,
    utilisation: f64,
    met: bool,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct ConditionObject {
    parameter: String,
    unit: String,
    before: Option<f64>,
    value: Option<f64>,
    expected_lower: Option<f64>,
    expected_upper: Option<f64>,
    verdict: &'static str,
    words: String,
}

impl AssessObject {
    /// The object for a report.
    pub fn new(a: &Assessment) -> AssessObject {
        let Assessment { facts, checked, verdict, .. } = a;
        let collapse = |found: &Option<Box<Collapse>>| found.as_ref().map(|c| CollapseObject::new(c, &Run::default()));
        let found = checked.iter().flat_map(|check| {
            let list = check.outcome.as_ref().map_or(&[][..], |list| list);
            list.iter().map(|finding| object(check, finding))
        });
        let not_made = checked.iter().filter_map(|check| {
            let why = check.outcome.as_ref().err()?;
            let (code, title) = (check.code.clone(), check.title.clone());
            Some(NotMadeObject { code, title, why: why.why.clone(), analysis_failed: why.failed })
        });
        let worst = governing(checked).and_then(|(check, finding)| {
            let finding = checked[check].outcome.as_ref().ok()?.get(finding)?;
            Some(GoverningObject {
                code: checked[check].code.clone(),
                title: checked[check].title.clone(),
                load_model: finding.load_model.clone(),
                utilisation: finding.utilisation,
                met: finding.met(),
            })
        });
        AssessObject {
            bridge: a.bridge.clone(),
            verdict: verdict.words.clone(),
            headline: verdict.headline.word(),
            strength_assessed: verdict.strength.assessed,
            missing: verdict.strength.missing.clone(),
            qualifications: verdict.strength.qualifications.clone(),
            checks: found.collect(),
            not_made: not_made.collect(),
            governing: worst,
            condition: a.condition.iter().map(judged).collect(),
            sensitivity: facts.sensitivity.made().cloned(),
            service: facts.service.made().cloned(),
            collapse: facts.ultimate.made().and_then(|facts| collapse(&facts.collapse)),
            vehicles: facts.vehicles.made().cloned(),
            support_movement: facts.movement.made().and_then(|facts| collapse(&facts.collapse)),
            update: facts.update.made().and_then(|facts| facts.update.as_deref()).map(UpdateObject::new),
        }
    }
}

fn object(check: &Checked, finding: &Comparison) -> CheckObject {
    CheckObject {
        code: check.code.clone(),
        title: check.title.clone(),
        clause: check.clause.clone(),
        load_model: finding.load_model.clone(),
        value: finding.value,
        limit: finding.limit,
        unit: finding.unit.word(),
        utilisation: finding.utilisation,
        met: finding.met(),
        basis: finding.basis.clone(),
        position_m: finding.position,
        columns: finding.columns.map(|[own, design, sum, total, whole]| ColumnsObject {
            self_weight: own,
            live_load_design_cda: design,
            total_design_cda: sum,
            live_load_total_cda: total,
            total_total_cda: whole,
        }),
    }
}

fn judged(one: &Condition) -> ConditionObject {
    ConditionObject {
        parameter: one.parameter.clone(),
        unit: one.unit.clone(),
        before: Some(one.before).filter(|value| value.is_finite()),
        value: one.after,
        expected_lower: one.expected.map(|range| range[0]),
        expected_upper: one.expected.map(|range| range[1]),
        verdict: one.standing.word(),
        words: one.words.clone(),
    }
}

/// The checks as a table.
pub fn checks_table(checked: &[Checked]) -> String {
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let mut csv = String::from("code,title,load_model,value,limit,unit,utilisation,met,basis\n");
    for check in checked {
        for finding in check.outcome.iter().flatten() {
            csv += &format!(
                "{},{},{},{},{},{},{},{},{}\n",
                check.code.clone(),
                quoted(&check.title),
                quoted(&finding.load_model),
                finding.value,
                finding.limit,
                finding.unit,
                finding.utilisation,
                finding.met(),
                quoted(&finding.basis)
            );
        }
    }
    csv
}
