//! A result beside that of another run of the same input with some keys changed: one ring instead of two, one span
//! instead of several, the other friction rule.

use serde_json::Value as Json;

/// The quantity that a comparison is about.
const LOAD: &str = "collapse_load_kn_per_m";

/// The other run, which must have a collapse load, or channels or checks.
pub(crate) fn checked(other: Result<Json, String>) -> Result<Json, String> {
    let other = other.map_err(|reason| format!("against: {reason}"))?;
    let found = other.get(LOAD).and_then(Json::as_f64).is_some_and(|load| load > 0.0)
        || ROWS.iter().any(|(rows, _)| other.get(*rows).is_some());
    found.then_some(other).ok_or("against: the other run has nothing to compare with".into())
}

/// Rows of the two results that belong together, and the number that is compared.
const ROWS: [(&str, &str); 2] = [("channels", "peak"), ("checks", "value")];

/// The result with `other_collapse_load_kn_per_m` and `collapse_load_over_other` beside it; in channels `peak_over_other`, in checks
/// `value_over_other`.
pub(crate) fn compared(mut result: Json, other: Option<&Json>) -> Json {
    let load = |run: &Json| run.get(LOAD).and_then(Json::as_f64);
    let own = load(&result);
    if let (Json::Object(keys), Some(other)) = (&mut result, other.and_then(load)) {
        keys.insert("other_collapse_load_kn_per_m".into(), other.into());
        if let Some(own) = own {
            keys.insert("collapse_load_over_other".into(), (own / other).into());
        }
    }
    for (rows, key) in ROWS {
        let beside = other.and_then(|other| other.get(rows)).and_then(Json::as_array);
        let (Some(own), Some(beside)) = (result.get_mut(rows).and_then(Json::as_array_mut), beside) else { continue };
        for (own, other) in own.iter_mut().zip(beside) {
            let number = |row: &Json| row.get(key).and_then(Json::as_f64);
            if let (Some(one), Some(other), Json::Object(keys)) = (number(own), number(other), own) {
                keys.insert(format!("{key}_over_other"), (one / other).into());
            }
        }
    }
    result
}
