//! A result beside that of another run of the same input with some keys changed: one ring instead of two, one span
//! instead of several, the other friction rule.

use super::measure::measure;
use serde_json::Value as Json;

/// The quantity that a comparison is about.
const LOAD: &str = "collapse_load_kn_per_m";

/// The other run, which must have a collapse load.
pub fn measured(document: &toml::Table) -> Result<Json, String> {
    let other = measure(document).map_err(|reason| format!("against: {reason}"))?;
    let found = other.get(LOAD).and_then(Json::as_f64).is_some_and(|load| load > 0.0);
    found.then_some(other).ok_or("against: the other run has no collapse load".into())
}

/// The result with `other_collapse_load_kn_per_m` and `collapse_load_over_other` beside it.
pub fn compared(mut result: Json, other: Option<&Json>) -> Json {
    let load = |run: &Json| run.get(LOAD).and_then(Json::as_f64);
    let own = load(&result);
    if let (Json::Object(keys), Some(other)) = (&mut result, other.and_then(load)) {
        keys.insert("other_collapse_load_kn_per_m".into(), other.into());
        if let Some(own) = own {
            keys.insert("collapse_load_over_other".into(), (own / other).into());
        }
    }
    result
}
