//! What the engine knows of files, codes, vehicles and examples, for completion and menus.

use crate::border::Thrown;
use crate::reading::words;
use extrados::bridge::explain::{self, FileCard};
use extrados::bridge::fields::{FILE, Field, Kind, Need, Section};
use extrados::bridge::schema as schemas;
use extrados::bridge::survey;
use extrados::{Refusal, drawing, examples};
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

/// The JSON Schema of bridge files.
#[wasm_bindgen]
pub fn schema() -> String {
    schemas::schema().to_string()
}

/// The examples.
#[wasm_bindgen(js_name = examples)]
pub fn list_of_examples() -> String {
    let one = |example: &examples::Example| {
        let files: Vec<Value> =
            example.files.iter().map(|file| json!({ "name": file.name, "about": file.about() })).collect();
        json!({
            "name": example.name, "about": example.about, "main": example.main, "command": example.command(), "files": files,
        })
    };
    Value::from_iter(examples::ALL.iter().map(one)).to_string()
}

/// A file of an example.
///
/// # Errors
/// No such file (F104).
#[wasm_bindgen]
pub fn example_file(example: &str, file: &str) -> Result<Vec<u8>, Thrown> {
    let found = examples::named(example).and_then(|example| example.files.iter().find(|one| one.name == file));
    let found = found.map(|file| file.text.as_bytes().to_vec());
    Ok(found.ok_or_else(|| {
        let names: Vec<&str> = examples::ALL.iter().map(|example| example.name).collect();
        let message = format!("there is no file {file} of an example called {example}");
        Refusal::new("F104", message, format!("the examples are {}", names.join(", ")))
    })?)
}

/// The cards of all keys, section by section.
#[wasm_bindgen]
pub fn keys() -> String {
    let mut all = Vec::new();
    visit(&FILE, "", false, &mut all);
    json!(all).to_string()
}

fn visit(section: &'static Section, path: &str, list: bool, all: &mut Vec<Value>) {
    let fields: Vec<Value> = section.fields.iter().map(field).collect();
    all.push(json!({ "path": path, "list": list, "doc": section.doc, "fields": fields }));
    for field in section.fields {
        let below = if path.is_empty() { field.key.to_owned() } else { format!("{path}.{}", field.key) };
        match field.kind {
            Kind::Table(inner) => visit(inner, &below, false, all),
            Kind::Tables(inner) => visit(inner, &below, true, all),
            _ => {}
        }
    }
}

fn field(field: &Field) -> Value {
    let kind = match field.kind {
        Kind::Quantity(_) | Kind::QuantityOr(..) | Kind::LineLoad => "quantity",
        Kind::Quantities(_) => "quantities",
        Kind::Number => "number",
        Kind::Count => "whole",
        Kind::Flag => "truth",
        Kind::Word(_) => "word",
        Kind::Text => "text",
        Kind::Table(_) => "table",
        Kind::Tables(_) => "tables",
        _ => "other",
    };
    let (need, default) = match field.need {
        Need::Required => ("required", None),
        Need::Optional(_) => ("optional", None),
        Need::Default(value) => ("default", Some(value)),
    };
    json!({
        "key": field.key, "kind": kind, "doc": field.doc, "need": need, "default": default, "words": words(field),
        "example": field.example_line(), "form": field.form(),
    })
}

fn card(card: &FileCard) -> Value {
    json!({
        "code": card.code, "title": card.title, "text": format!("{}\n\n{}", card.meaning, card.why), "instead_is": card.instead_is(),
        "instead": card.instead(), "source": card.source,
    })
}

/// The card of a code; null where there is none.
#[wasm_bindgen(js_name = explain)]
pub fn explained(code: &str) -> String {
    explain::explain(code).map_or(Value::Null, card).to_string()
}

/// Every card about files.
#[wasm_bindgen]
pub fn codes() -> String {
    Value::from_iter(explain::cards().map(card)).to_string()
}

/// The ten numbers of a survey, what several spans are asked beside them, and what else a survey may know.
#[wasm_bindgen]
pub fn survey_questions() -> String {
    let one = |one: &survey::Question| {
        json!({
            "key": one.key, "doc": one.doc, "unit": one.unit, "example": one.example, "assumed": one.assumed, "usual": one.usual,
        })
    };
    let all = |list: &[survey::Question]| -> Value { list.iter().map(one).collect() };
    json!({ "ten": all(&survey::QUESTIONS), "spans": one(&survey::SPANS), "pier": all(&survey::PIER), "more": all(&survey::MORE), "words": survey::WORDS })
        .to_string()
}

/// A bridge file from answers, an object of texts or numbers.
///
/// # Errors
/// Answers that are missing, no numbers or not possible (F108).
#[wasm_bindgen]
pub fn from_survey(answers: &str) -> Result<String, Thrown> {
    let given = given(answers)?;
    Ok(survey::file(&name(&given), &|key| said(&given, key)).map_err(|wrong| {
        let message: Vec<&str> = wrong.iter().map(|one| one.message.as_str()).collect();
        let help: Vec<&str> = wrong.iter().map(|one| one.help.as_str()).collect();
        Refusal::new("F108", message.join("; "), help.join("; "))
    })?)
}

/// The file to begin a survey with, in which everything is assumed.
#[wasm_bindgen]
pub fn survey_start() -> String {
    survey::start("A bridge")
}

/// What the file of a survey says, with changed answers in it: its text, null where one is refused; its answers, null where it cannot be read;
/// and what is wrong with answers or doubtful, each at its key. Null for a file that is no survey's.
///
/// # Errors
/// Changes that are no object (F108).
#[wasm_bindgen]
pub fn survey_changed(text: &str, changes: &str) -> Result<String, Thrown> {
    if !survey::is_survey(text) {
        return Ok(Value::Null.to_string());
    }
    let given = given(changes)?;
    let keys = given.as_object().into_iter().flat_map(|given| given.keys());
    let changes = keys.filter_map(|key| Some((key.clone(), said(&given, key)?))).collect();
    let survey::Changed { text: now, findings } = survey::changed(text, &changes);
    let answers = survey::answers(now.as_deref().unwrap_or(text));
    let one = |one: survey::Unusable| json!({ "key": one.key, "severity": one.severity.word(), "message": one.message, "help": one.help });
    let findings: Vec<Value> = findings.into_iter().map(one).collect();
    Ok(json!({ "text": now, "answers": answers, "findings": findings }).to_string())
}

/// Answers of a survey as the page gives them.
fn given(answers: &str) -> Result<Value, Refusal> {
    let help = "answer with numbers and units, such as 6.00 m";
    serde_json::from_str(answers).map_err(|error| Refusal::new("F108", error.to_string(), help))
}

fn said(given: &Value, key: &str) -> Option<String> {
    match given.get(key) {
        Some(Value::String(text)) => Some(text.clone()),
        Some(Value::Number(number)) => Some(number.to_string()),
        _ => None,
    }
}

fn name(given: &Value) -> String {
    said(given, "name").unwrap_or_else(|| "A bridge".to_owned())
}

/// A block model file from a drawing; what the drawing does not say stands there to be filled in.
///
/// # Errors
/// A drawing that cannot be used, with its findings (D101).
#[wasm_bindgen(js_name = from_dxf)]
pub fn from_drawing(name: &str, bytes: &[u8]) -> Result<String, Thrown> {
    let read = drawing::read(bytes, &drawing::Options::default());
    if !read.is_usable() {
        let words: Vec<String> = read.findings.iter().take(8).map(drawing::Finding::words).collect();
        return Err(Refusal::new("D101", words.join("; "), "mend the drawing and drop it again").into());
    }
    Ok(extrados::of_drawing(name, &read.drawing))
}

/// Materials of the library.
#[wasm_bindgen]
pub fn materials() -> String {
    json!(extrados::materials()).to_string()
}

/// The text of a bridge file with a table filled from a material of the library.
///
/// # Errors
/// Those of [`extrados::with_material`], as an exception.
#[wasm_bindgen]
pub fn with_material(text: &str, table: &str, material: &str, keys: Vec<String>) -> Result<String, Thrown> {
    let keys: Vec<&str> = keys.iter().map(String::as_str).collect();
    Ok(extrados::with_material(text, table, material, &keys)?)
}

/// Vehicles and rules of the library.
///
/// # Errors
/// A file of the library that cannot be read.
#[wasm_bindgen]
pub fn library() -> Result<String, Thrown> {
    let library = extrados::library()?;
    let models: Vec<Value> = library
        .models
        .iter()
        .map(|model| {
            let vehicles: Vec<Value> = model
                .vehicles
                .iter()
                .map(|one| {
                    let pattern = one.patterns().into_iter().next();
                    let axles = pattern.iter().flat_map(|pattern| &pattern.axles);
                    let axles: Vec<Value> =
                        axles.map(|axle| json!({ "force": axle.force, "offset": axle.offset })).collect();
                    json!({ "code": one.code, "title": one.title, "axles": axles, "uniform": !one.uniform.is_empty() })
                })
                .collect();
            // A rule that gives a verdict, and names no vehicles, takes every case of a loading that it takes up.
            let begun = |loading: &str| {
                !loading.is_empty() && library.models.iter().any(|one| !one.only_by_name && one.loading == loading)
            };
            let only_by_name = model.only_by_name && !begun(&model.loading);
            let rules: Vec<&str> = library
                .rules
                .iter()
                .filter(|rule| rule.acting(model).is_some())
                .map(|rule| rule.code.as_str())
                .collect();
            json!({
                "code": model.code, "title": model.title, "ways": model.ways, "vehicles": vehicles, "rules": rules,
                "source": model.source.text, "confidence": model.source.confidence,
                "only_by_name": only_by_name, "longest_span": model.span_limit.as_ref().map(|limit| limit.longest_m),
            })
        })
        .collect();
    let rules: Vec<Value> = (library.rules.iter())
        .map(|rule| {
            let judges = rule.factors.live_load.is_safety();
            json!({ "code": rule.code, "title": rule.title, "ways": rule.ways, "judges": judges })
        })
        .collect();
    Ok(json!({ "models": models, "rules": rules }).to_string())
}
