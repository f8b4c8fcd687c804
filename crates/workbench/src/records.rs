//! Measured channels as a page draws them.

use extrados::results::records::{ReadOptions, read};
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

/// Most samples that are handed over of a channel: more than a screen can show.
const MOST: usize = 20_000;

/// A table of measurements: its channels, and what was found in it.
#[wasm_bindgen]
pub fn records(name: &str, bytes: &[u8]) -> String {
    let found = read(bytes, &ReadOptions { name: name.to_owned(), ..ReadOptions::default() });
    let findings: Vec<Value> = found
        .findings
        .iter()
        .map(|one| json!({ "code": one.code, "severity": one.severity.word(), "message": one.words(), "help": one.help }))
        .collect();
    let Some(run) = found.run else {
        return json!({ "name": name, "channels": [], "rows": 0, "times": [], "values": [], "findings": findings, "synthetic": null }).to_string();
    };
    let step = run.times.len().div_ceil(MOST).max(1);
    let thin = |values: &[f64]| values.iter().step_by(step).copied().collect::<Vec<f64>>();
    let channels: Vec<Value> = run
        .channels
        .iter()
        .map(|one| json!({ "name": one.title(), "unit": one.unit.symbol, "scale": one.unit.per_si, "left_out": one.left_out }))
        .collect();
    json!({
        "name": run.name, "speed": run.speed, "synthetic": run.synthetic, "rows": run.times.len(), "every": step, "channels": channels,
        "times": thin(&run.times), "values": run.channels.iter().map(|one| thin(&one.values)).collect::<Vec<_>>(),
        "findings": findings,
    })
    .to_string()
}
