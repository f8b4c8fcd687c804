//! `extrados.vary/1`, its table, and the record of one run.

use super::kilo;
use crate::collapse::Collapse;
use crate::study::{Outcome, Row, Sensitivity, Study, sensitivity};
use bridge::vary::{Setting, Varied};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};
use std::fmt::Write;

/// The numbers of a collapse analysis, by the names they have in `extrados.collapse/1`.
pub fn collapse_numbers(c: &Collapse) -> Vec<(String, f64)> {
    let limit = c.limit();
    let numbers = [
        ("last_stable_load_kn_per_m", c.last_stable_load.map(kilo)),
        ("collapse_load_kn_per_m", c.collapse_load.map(kilo)),
        ("headline_kn_per_m", c.carried().map(kilo)),
        ("limit_load_kn_per_m", c.limit_load.map(kilo)),
        ("lower_bound_kn_per_m", limit.and_then(|l| l.lower_bound).map(kilo)),
        ("upper_bound_kn_per_m", limit.and_then(|l| l.upper_bound).map(kilo)),
        ("minimum_thickness_m", c.thickness().map(|t| t.crown_thickness)),
        ("minimum_thickness_factor", c.thickness().map(|t| t.factor[1])),
        ("thickness_factor_that_falls", c.thickness().map(|t| t.factor[0])),
        ("last_stable_movement_m", c.support().and_then(|s| s.last_stable)),
        ("collapse_movement_m", c.support().and_then(|s| s.collapse)),
        ("max_compressive_stress_mpa", c.max_compressive_stress.map(|stress| stress / 1e6)),
        ("hinges", Some(c.hinges.len() as f64)),
        ("sliding_joints", Some(c.sliding_joints.len() as f64)),
        ("blocks", Some(c.blocks as f64)),
        ("iterations_total", c.dem().map(|d| d.iterations_total as f64)),
    ];
    let found = numbers.into_iter().filter_map(|(name, number)| Some((name.to_owned(), number?)));
    found.filter(|(_, number)| number.is_finite()).collect()
}

/// Format of the record; it changes with what the record holds.
const RECORD: &str = "extrados.vary-run/1";

/// A finished run as it is kept.
#[derive(Debug, Serialize, Deserialize)]
struct Record {
    schema: String,
    status: String,
    outcomes: Map<String, Value>,
    warnings: Vec<String>,
    seconds: f64,
}

/// The record of a finished run.
pub fn run_record(outcome: &Outcome, seconds: f64) -> String {
    super::json(&Record {
        schema: RECORD.to_owned(),
        status: outcome.status.clone(),
        outcomes: numbers(outcome),
        warnings: outcome.warnings.clone(),
        seconds,
    })
}

/// A finished run and its seconds, from its record; none where the bytes are no whole record.
pub fn run_from_record(bytes: &[u8]) -> Option<(Outcome, f64)> {
    let record: Record = serde_json::from_slice(bytes).ok().filter(|record: &Record| record.schema == RECORD)?;
    let numbers: Option<Vec<(String, f64)>> =
        record.outcomes.into_iter().map(|(name, value)| Some((name, value.as_f64()?))).collect();
    let outcome = Outcome { status: record.status, numbers: numbers?, warnings: record.warnings, message: None };
    Some((outcome, record.seconds))
}

fn numbers(outcome: &Outcome) -> Map<String, Value> {
    outcome.numbers.iter().map(|(name, number)| (name.clone(), json!(number))).collect()
}

/// The fields of a study.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct VaryObject {
    bridge: String,
    command: &'static str,
    method: &'static str,
    analysis: &'static str,
    design: &'static str,
    outcome: String,
    outcome_resolution: f64,
    quantities: Vec<QuantityObject>,
    baseline: Option<RowObject>,
    rows: Vec<RowObject>,
    sensitivity: Vec<SensitivityObject>,
    runs: usize,
    runs_from_cache: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct QuantityObject {
    quantity: String,
    unit: String,
    own: Option<ValueObject>,
    values: Vec<ValueObject>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct ValueObject {
    text: String,
    number: Option<f64>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct RowObject {
    run: usize,
    varied: Option<String>,
    values: Map<String, Value>,
    status: String,
    outcomes: Map<String, Value>,
    warnings: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    message: Option<String>,
    seconds: f64,
    cached: bool,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct SensitivityObject {
    quantity: String,
    low: Option<ExtremeObject>,
    high: Option<ExtremeObject>,
    swing_percent: Option<f64>,
    elasticity: Option<f64>,
    trend: &'static str,
    runs_without_outcome: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct ExtremeObject {
    value: String,
    outcome: f64,
    change_percent: Option<f64>,
}

impl VaryObject {
    /// The fields of a study.
    pub fn new(study: &Study) -> VaryObject {
        let row = |(number, row): (usize, &Row)| RowObject {
            run: number,
            varied: row.run.varied.map(|quantity| study.quantities[quantity].path.to_string()),
            values: (0..study.quantities.len()).map(|quantity| value_of(study, row, quantity)).collect(),
            status: row.outcome.status.clone(),
            outcomes: numbers(&row.outcome),
            warnings: row.outcome.warnings.clone(),
            message: row.outcome.message.clone(),
            seconds: row.seconds,
            cached: row.cached,
        };
        let mut rows: Vec<RowObject> = study.rows.iter().enumerate().map(row).collect();
        let baseline = if rows.is_empty() { None } else { Some(rows.remove(0)) };
        VaryObject {
            bridge: study.bridge.clone(),
            command: study.command.word(),
            method: super::collapse::method(study.method),
            analysis: super::collapse::analysis(study.analysis),
            design: study.design.word(),
            outcome: study.outcome.clone(),
            outcome_resolution: study.resolution,
            quantities: study.quantities.iter().map(quantity).collect(),
            baseline,
            rows,
            sensitivity: sensitivity(study).iter().map(|one| sensitivity_object(study, one)).collect(),
            runs: study.rows.len(),
            runs_from_cache: study.rows.iter().filter(|row| row.cached).count(),
        }
    }
}

fn quantity(varied: &Varied) -> QuantityObject {
    let value = |setting: &Setting| ValueObject { text: setting.text.clone(), number: setting.number };
    QuantityObject {
        quantity: varied.path.to_string(),
        unit: varied.unit.clone(),
        own: varied.own.as_ref().map(value),
        values: varied.values.iter().map(value).collect(),
    }
}

/// A value by the path of its quantity: its number in the unit of the quantity, or its word.
fn value_of(study: &Study, row: &Row, quantity: usize) -> (String, Value) {
    let value = match study.setting(row, quantity) {
        Some(Setting { number: Some(number), .. }) => json!(number),
        Some(setting) => json!(setting.text),
        None => Value::Null,
    };
    (study.quantities[quantity].path.to_string(), value)
}

fn sensitivity_object(study: &Study, one: &Sensitivity) -> SensitivityObject {
    let extreme = |end: &Option<crate::study::Extreme>| {
        end.as_ref().map(|end| ExtremeObject {
            value: end.value.clone(),
            outcome: end.outcome,
            change_percent: end.change_percent,
        })
    };
    SensitivityObject {
        quantity: study.quantities[one.quantity].path.to_string(),
        low: extreme(&one.low),
        high: extreme(&one.high),
        swing_percent: one.swing_percent,
        elasticity: one.elasticity,
        trend: one.trend.word(),
        runs_without_outcome: one.without_answer,
    }
}

/// Every run in a line, units in the heading.
pub fn vary_table(study: &Study) -> String {
    let heading = |varied: &Varied| match varied.unit.as_str() {
        "" => varied.path.to_string(),
        unit => format!("{} [{unit}]", varied.path),
    };
    let names = study.numbers();
    let head = ["run".to_owned(), "varied".to_owned()].into_iter().chain(study.quantities.iter().map(heading));
    let head = head.chain(std::iter::once("status".to_owned())).chain(names.iter().map(|name| (*name).to_owned()));
    let mut table = head.map(|cell| quoted(&cell)).collect::<Vec<_>>().join(",") + "\n";
    for (number, row) in study.rows.iter().enumerate() {
        let varied = match row.run.varied {
            Some(quantity) => study.quantities[quantity].path.to_string(),
            None if number == 0 => "as the file has it".to_owned(),
            None => "all".to_owned(),
        };
        let values = (0..study.quantities.len()).map(|quantity| match study.setting(row, quantity) {
            Some(Setting { number: Some(number), .. }) => number.to_string(),
            Some(setting) => setting.text.clone(),
            None => String::new(),
        });
        let found =
            names.iter().map(|name| row.outcome.number(name).map_or(String::new(), |number| number.to_string()));
        let cells = [number.to_string(), varied].into_iter().chain(values);
        let cells = cells.chain(std::iter::once(row.outcome.status.clone())).chain(found);
        let line = cells.map(|cell| quoted(&cell)).collect::<Vec<_>>().join(",");
        // Writing to a string cannot fail.
        let _ = writeln!(table, "{line}");
    }
    table
}

/// A cell as spreadsheets read it (RFC 4180).
pub(super) fn quoted(cell: &str) -> String {
    match cell.contains(['"', ',', '\n', '\r']) {
        true => format!("\"{}\"", cell.replace('"', "\"\"")),
        false => cell.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_is_read_back_bit_by_bit() {
        let third = f64::from_bits(0.1_f64.to_bits() + 1) * 3.0;
        let numbers = vec![("b".to_owned(), third), ("a".to_owned(), -1e-300), ("c".to_owned(), 12.0)];
        let outcome = Outcome { status: "collapsed".into(), numbers, warnings: vec!["A106".into()], message: None };
        let record = run_record(&outcome, 0.25);
        assert_eq!(run_from_record(record.as_bytes()), Some((outcome, 0.25)));
    }

    #[test]
    fn what_is_no_whole_record_is_none() {
        let record = run_record(&Outcome { status: "locks".into(), ..Outcome::default() }, 1.0);
        assert!(run_from_record(record.as_bytes()).is_some());
        for broken in ["", "{}", "null", &record[..record.len() / 2], &record.replace("vary-run/1", "vary-run/0")] {
            assert_eq!(run_from_record(broken.as_bytes()), None, "{broken}");
        }
    }

    #[test]
    fn cells_with_commas_are_quoted() {
        assert_eq!([quoted("a"), quoted("a,b"), quoted("a \"b\"")], ["a", "\"a,b\"", "\"a \"\"b\"\"\""]);
    }
}
