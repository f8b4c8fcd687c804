//! What a text says, for an editor: findings at their places, quantities with their ranges.

use crate::document::{Document, Read};
use extrados::bridge::fields::{Field, Kind};
use extrados::bridge::path::Path;
use extrados::bridge::whereabouts::Whereabouts;
use extrados::bridge::{Diagnostic, TextRange, edit, quantity, text, vary};
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

/// Where a range of bytes begins and ends as an editor in a browser counts: in UTF-16 units.
fn units(text: &str, range: TextRange) -> [usize; 2] {
    [range.start, range.end].map(|byte| {
        let mut end = byte.min(text.len());
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        text[..end].encode_utf16().count()
    })
}

fn findings(of: &str, list: &[Diagnostic]) -> Vec<Value> {
    let one = |finding: &Diagnostic| {
        let place = text::position(of.as_bytes(), finding.range.start);
        let [start, end] = units(of, finding.range);
        json!({
            "code": finding.code, "severity": finding.severity.word(), "message": finding.message, "label": finding.label,
            "note": finding.note, "help": finding.help, "start": start, "end": end, "line": place.line, "column": place.column,
        })
    };
    list.iter().map(one).collect()
}

/// Findings, and what there is to analyse.
pub fn reading(document: &Document) -> Value {
    let project = match &document.read {
        Read::Bridge(project) => project,
        Read::Blocks(blocks) => {
            let drawing = blocks.drawing().map_or_else(Vec::new, |(_, found)| {
                let one = |finding: &extrados::drawing::Finding| {
                    json!({
                        "code": finding.code, "severity": finding.severity.word(), "message": finding.words(), "label": "in the drawing",
                        "note": null, "help": finding.help, "start": 0, "end": 0, "line": 1, "column": 1,
                    })
                };
                found.iter().map(one).collect()
            });
            let all: Vec<Value> = findings(&document.text(), blocks.findings()).into_iter().chain(drawing).collect();
            return json!({
                "kind": "blocks", "usable": blocks.scene().is_some(), "name": blocks.name(), "width_m": null, "sections": null,
                "refusal": null, "findings": all,
                "inputs": blocks.drawing().map(|(place, _)| vec![place.display().to_string()]).unwrap_or_default(),
            });
        }
        Read::Refused(refusal) => {
            return json!({
                "kind": "bridge", "usable": false, "name": "", "width_m": null, "sections": null, "refusal": refusal, "findings": [],
                "inputs": [],
            });
        }
    };
    let meaning = project.meaning();
    let bridge = meaning.bridge.as_ref();
    let sections = bridge.map(|bridge| {
        let not_known: serde_json::Map<String, Value> =
            extrados::not_known(bridge).into_iter().map(|(method, why)| (method.word().to_owned(), why.into())).collect();
        json!({
            "not_known": not_known,
            "loads": bridge.loads.len(), "load_names": bridge.loads.iter().map(|load| &load.name).collect::<Vec<_>>(), "sweep": bridge.sweep.is_some(), "passage": bridge.passage.is_some(),
            "update": meaning.update.is_some(), "assess": meaning.assess.is_some(), "vary": !meaning.vary.is_empty(),
            "cases": meaning.cases.len(), "particles": bridge.cover.layers.iter().any(|layer| layer.particles),
            "continuum": bridge.continuum.is_some(), "method": bridge.plan.method.word(), "analysis": bridge.plan.analysis,
            "stiffness": bridge.joint.normal_stiffness.is_some(), "spans": bridge.spans.len(),
        })
    });
    json!({
        "kind": "bridge", "usable": bridge.is_some(), "name": bridge.map_or("", |bridge| bridge.name.as_str()),
        "width_m": bridge.map(|bridge| bridge.width), "sections": sections, "refusal": null,
        "findings": findings(&document.text(), project.findings()),
        "inputs": project.inputs().iter().map(|path| path.display().to_string()).collect::<Vec<_>>(),
    })
}

/// Every quantity of a text that has a value; none where the text is no TOML.
pub fn quantities(text: &str) -> Value {
    let Some(document) = edit::Document::parse(text) else { return json!([]) };
    let places = Whereabouts::of(text);
    let one = |known: vary::Known| {
        let path = Path::parse(&known.path)?;
        let found = vary::find(&document, &known.path).ok()?;
        let place = places.value(&path).map(|range| units(text, range));
        let written = plain(&known.value);
        let measured = quantity::parse(&written).ok();
        let number = measured.map(|measured| measured.number).or_else(|| written.parse().ok());
        let size = measured.map_or(1.0, |measured| measured.unit.size);
        let bound = |value: f64| (value.is_finite() && number.is_some()).then(|| value / size);
        Some(json!({
            "path": known.path, "value": known.value, "by_default": known.by_default, "doc": known.doc, "text": written, "number": number,
            "unit": measured.map_or("", |measured| measured.unit.symbol), "words": words(found.field),
            "least": bound(found.field.limits.least), "most": bound(found.field.limits.most),
            "start": place.map(|[start, _]| start), "end": place.map(|[_, end]| end),
        }))
    };
    vary::known(&document).into_iter().filter_map(one).collect()
}

/// Where a text says what a path of a report names: the value, or the table where it would stand; null where there is neither.
#[wasm_bindgen]
pub fn place(text: &str, path: &str) -> String {
    let places = Whereabouts::of(text);
    let mut wanted = path;
    while !wanted.is_empty() {
        // The first of several, where the path does not say which.
        let found = [wanted.to_owned(), format!("{wanted}[1]")].iter().find_map(|one| places.value(&Path::parse(one)?));
        if let Some(range) = found.filter(|range| range.start < range.end) {
            let [start, end] = units(text, range);
            return json!({ "start": start, "end": end, "path": wanted, "written": wanted == path }).to_string();
        }
        wanted = wanted.rsplit_once('.').map_or("", |(table, _)| table);
    }
    "null".to_owned()
}

/// Words that a field may hold.
pub fn words(field: &Field) -> Vec<Value> {
    match field.kind {
        Kind::Word(words) => words.iter().map(|word| json!({ "word": word.word, "doc": word.doc })).collect(),
        _ => Vec::new(),
    }
}

/// A value without its quotes.
fn plain(literal: &str) -> String {
    let literal = literal.trim();
    let quoted = |mark: char| literal.strip_prefix(mark).and_then(|rest| rest.strip_suffix(mark));
    quoted('"').or_else(|| quoted('\'')).unwrap_or(literal).to_owned()
}

/// A value as TOML has it: as it stands where it is TOML, in quotes where it is a text such as `18.5 m`.
pub fn literal(written: &str) -> String {
    let written = written.trim();
    let toml =
        written.starts_with(['"', '\'', '[']) || written.parse::<f64>().is_ok() || ["true", "false"].contains(&written);
    if toml { written.to_owned() } else { format!("\"{}\"", written.replace('\\', "\\\\").replace('"', "\\\"")) }
}
