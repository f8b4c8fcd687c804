//! Finished stages on a shelf, by the hash of what they were computed from.

use crate::means::Means;
use report::Figure;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

/// A finished stage.
pub(super) struct Finished<T> {
    pub facts: T,
    /// Its drawings.
    pub figures: Vec<Figure>,
    /// How long it took [s].
    pub seconds: f64,
}

/// A stage that was finished from the same input. A piece that is damaged or of another input is none.
pub(super) fn get<T: DeserializeOwned>(means: &Means<'_>, stage: &str, key: &str) -> Option<Finished<T>> {
    let value: Value = serde_json::from_slice(&means.shelf.find(&format!("stages/{stage}"))?).ok()?;
    if value["key"].as_str() != Some(key) {
        return None;
    }
    let figures = value["figures"].as_array()?.iter().map(|one| {
        let text = |name: &str| one[name].as_str().map(str::to_owned);
        Some(Figure { stage: stage.to_owned(), name: text("name")?, caption: text("caption")?, svg: text("svg")? })
    });
    Some(Finished {
        figures: figures.collect::<Option<_>>()?,
        seconds: value["seconds"].as_f64()?,
        facts: serde_json::from_value(value["facts"].clone()).ok()?,
    })
}

/// Keeps a finished stage. One that cannot be kept is computed again: that is no failure.
pub(super) fn put<T: Serialize>(means: &Means<'_>, stage: &str, key: &str, finished: &Finished<T>) {
    let figures: Vec<Value> = finished
        .figures
        .iter()
        .map(|figure| json!({ "name": figure.name, "caption": figure.caption, "svg": figure.svg }))
        .collect();
    let Ok(facts) = serde_json::to_value(&finished.facts) else { return };
    let value = json!({ "key": key, "seconds": finished.seconds, "facts": facts, "figures": figures });
    let _ = means.shelf.put(&format!("stages/{stage}"), value.to_string().as_bytes());
}
