//! Lists of `extrados.vary/1`, its table, and the record of one run.

use super::objects::{Object, json, kilo, list, number, object};
use super::rows::row;
use crate::collapse::Collapse;
use crate::study::{Outcome, Row, Study};
use bridge::vary::Setting;
use serde_json::{Value, json};

/// Numbers of a collapse analysis that a study shows, by their keys in `extrados.collapse/1`.
const NUMBERS: &str = "last_stable_load_kn_per_m collapse_load_kn_per_m headline_kn_per_m headline_with_help_kn_per_m \
                       limit_load_kn_per_m lower_bound_kn_per_m upper_bound_kn_per_m minimum_thickness_m \
                       minimum_thickness_factor thickness_factor_that_falls last_stable_movement_m collapse_movement_m \
                       max_compressive_stress_mpa hinges sliding_joints blocks iterations_total";

/// These numbers; iterations are those of discrete elements alone.
pub fn collapse_numbers(c: &Collapse) -> Vec<(String, f64)> {
    let object = c.object();
    let of = |name: &str| match name {
        "headline_with_help_kn_per_m" => c.not_counted.with_all()?.headline.map(kilo),
        "iterations_total" if c.dem().is_none() => None,
        _ => number(&object, name),
    };
    let found = NUMBERS.split(' ').filter_map(|name| Some((name.to_owned(), of(name)?)));
    found.filter(|(_, number)| number.is_finite()).collect()
}

/// Format of the record; it changes with what the record holds.
const RECORD: &str = "extrados.vary-run/1";

/// The record of a finished run.
pub fn run_record(outcome: &Outcome, seconds: f64) -> String {
    json(&object! {
        schema: RECORD,
        status: outcome.status,
        outcomes: numbers(outcome),
        warnings: outcome.warnings,
        seconds: seconds,
    })
}

/// A finished run and its seconds, from its record; none where the bytes are no whole record.
pub fn run_from_record(bytes: &[u8]) -> Option<(Outcome, f64)> {
    let record: Object =
        serde_json::from_slice(bytes).ok().filter(|record: &Object| record.get("schema") == Some(&json!(RECORD)))?;
    let number = |(name, value): (&String, &Value)| Some((name.clone(), value.as_f64()?));
    let word = |value: &Value| value.as_str().map(str::to_owned);
    let outcome = Outcome {
        status: word(record.get("status")?)?,
        numbers: record.get("outcomes")?.as_object()?.iter().map(number).collect::<Option<_>>()?,
        warnings: record.get("warnings")?.as_array()?.iter().map(word).collect::<Option<_>>()?,
        message: None,
    };
    Some((outcome, record.get("seconds")?.as_f64()?))
}

/// What a run found, by name.
pub(crate) fn numbers(outcome: &Outcome) -> Object {
    outcome.numbers.iter().map(|(name, number)| (name.clone(), json!(number))).collect()
}

/// What was varied.
pub(crate) fn quantities(study: &Study) -> Vec<Object> {
    let value = |setting: &Setting| object! { text: setting.text, number: setting.number, };
    list(&study.quantities, |varied| {
        object! {
            quantity: varied.path.to_string(),
            unit: varied.unit,
            own: varied.own.as_ref().map(value),
            values: list(&varied.values, value),
        }
    })
}

/// Values of a run by the paths of their quantities: a number in the unit of the quantity, or a word.
pub(crate) fn values(study: &Study, row: &Row) -> Object {
    let value = |quantity: usize| {
        let setting = study.setting(row, quantity);
        let number = setting.and_then(|setting| setting.number).map(|number| json!(number));
        (study.path(quantity), number.unwrap_or_else(|| json!(setting.map(|setting| &setting.text))))
    };
    (0..study.quantities.len()).map(value).collect()
}

/// Every run in a line, units in the heading.
pub fn vary_table(study: &Study) -> String {
    let headings = study.quantities.iter().map(|varied| match varied.unit.as_str() {
        "" => varied.path.to_string(),
        unit => format!("{} [{unit}]", varied.path),
    });
    let names = study.numbers();
    let mut csv = String::new();
    row!(&mut csv, "run", "varied", headings.collect::<Vec<_>>(), "status", names);
    for (number, row) in study.rows.iter().enumerate() {
        let varied = match row.run.varied {
            Some(quantity) => study.path(quantity),
            None if number == 0 => "as the file has it".to_owned(),
            None => "all".to_owned(),
        };
        let settings = (0..study.quantities.len()).map(|quantity| study.setting(row, quantity));
        let values = settings.map(|setting| {
            setting.map(|setting| setting.number.map_or_else(|| setting.text.clone(), |number| number.to_string()))
        });
        let found = names.iter().map(|name| row.outcome.number(name));
        row!(&mut csv, number, varied, values.collect::<Vec<_>>(), row.outcome.status, found.collect::<Vec<_>>());
    }
    csv
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
        let mut csv = String::new();
        row!(&mut csv, "a", "a,b", "a \"b\"");
        assert_eq!(csv, "a,\"a,b\",\"a \"\"b\"\"\"\n");
    }
}
