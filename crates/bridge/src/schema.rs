//! JSON Schema of the bridge file, for an editor's completion; made from the field cards.

use serde_json::{Map, Value, json};

use crate::fields::{FILE, Field, Kind, Need, Section, Word, blocks, sections_of};
use crate::library;
use crate::quantity::Dimension;

/// The schema of bridge files (draft 2020-12).
pub fn schema() -> Value {
    schema_of(&FILE, "extrados.bridge/1", "Extrados bridge file")
}

/// The schema of block model files.
pub fn schema_of_blocks() -> Value {
    schema_of(&blocks::FILE, "extrados.blocks/1", "Extrados block model file")
}

fn schema_of(file: &'static Section, id: &str, title: &str) -> Value {
    let mut root = table(file);
    let definitions: Map<String, Value> = sections_of(file)
        .into_iter()
        .filter(|section| !section.path.is_empty())
        .map(|section| (section.path.to_owned(), table(section)))
        .collect();
    if let Some(object) = root.as_object_mut() {
        object.insert("$schema".into(), json!("https://json-schema.org/draft/2020-12/schema"));
        object.insert("$id".into(), json!(id));
        object.insert("title".into(), json!(title));
        object.insert("$defs".into(), Value::Object(definitions));
    }
    root
}

/// A table: its keys, which of them must be there, and which only with certain words of another key.
fn table(section: &Section) -> Value {
    let properties: Map<String, Value> =
        section.fields.iter().map(|field| (field.key.to_owned(), property(field))).collect();
    let required: Vec<&str> =
        section.fields.iter().filter(|field| always_required(field)).map(|field| field.key).collect();
    // The name of a material of the library stands for what else must be written.
    let (by_name, required): (Vec<&str>, Vec<&str>) =
        required.into_iter().partition(|key| library::may_give(section, key));
    let conditions: Vec<Value> = section.fields.iter().filter_map(condition).collect();
    let mut schema = json!({
        "type": "object",
        "description": section.doc,
        "properties": properties,
        "required": required,
        "additionalProperties": false,
    });
    if let (false, Some(object)) = (by_name.is_empty(), schema.as_object_mut()) {
        object.insert("anyOf".into(), json!([{ "required": [library::KEY] }, { "required": by_name }]));
    }
    if let (false, Some(object)) = (conditions.is_empty(), schema.as_object_mut()) {
        object.insert("allOf".into(), Value::Array(conditions));
    }
    schema
}

fn always_required(field: &Field) -> bool {
    field.need == Need::Required && field.only.is_none()
}

/// A field that belongs to some words of another: required with them where it is required at all, forbidden without.
fn condition(field: &Field) -> Option<Value> {
    let (key, words) = field.only?;
    let then = if field.need == Need::Required { json!({ "required": [field.key] }) } else { json!({}) };
    Some(json!({
        "if": { "properties": { key: { "enum": words } }, "required": [key] },
        "then": then,
        "else": { "if": { "required": [key] }, "then": { "not": { "required": [field.key] } } },
    }))
}

fn property(field: &Field) -> Value {
    let mut schema = match field.kind {
        Kind::Table(section) => json!({ "$ref": format!("#/$defs/{}", section.path) }),
        Kind::Tables(section) => {
            let one = json!({ "$ref": format!("#/$defs/{}", section.path) });
            json!({ "anyOf": [{ "type": "array", "minItems": 1, "items": one }, one] })
        }
        Kind::Text => json!({ "type": "string" }),
        Kind::Quantity(dimension) => quantity(&[dimension]),
        Kind::QuantityOr(dimension, word) => json!({ "anyOf": [quantity(&[dimension]), { "const": word }] }),
        Kind::LineLoad => quantity(&[Dimension::LineLoad, Dimension::Force]),
        Kind::Quantities(dimension) => json!({ "type": "array", "items": quantity(&[dimension]) }),
        Kind::Points => {
            json!({ "type": "array", "minItems": 3, "items": {
                "type": "array", "minItems": 2, "maxItems": 2, "items": quantity(&[Dimension::Length]) } })
        }
        Kind::Rows(count) => {
            json!({ "type": "array", "minItems": 1, "items": {
                "type": "array", "minItems": count, "maxItems": count, "items": { "type": "number" } } })
        }
        Kind::Value => one_value(),
        Kind::Values => json!({ "type": "array", "minItems": 1, "items": one_value() }),
        Kind::Number => bounds(json!({ "type": "number" }), field),
        Kind::NumberOr(word) => json!({ "anyOf": [bounds(json!({ "type": "number" }), field), { "const": word }] }),
        Kind::Numbers => json!({ "type": "array", "items": bounds(json!({ "type": "number" }), field) }),
        Kind::Count => bounds(json!({ "type": "integer" }), field),
        Kind::Flag => json!({ "type": "boolean" }),
        Kind::Word(words) => self::words(words),
        Kind::Slope => json!({ "type": "string", "pattern": r"^\s*[0-9.]+\s*:\s*[0-9.]+\s*$" }),
        Kind::Share => json!({ "type": "string", "pattern":
            r"^\s*(crown|[0-9.]+%?|[0-9.]+/[0-9.]+)(\s*(of\s*)?span(\s*[0-9]+)?)?\s*$" }),
        Kind::Readings => {
            let dimensions = [Dimension::Length, Dimension::Strain, Dimension::Stress];
            json!({ "type": "object", "minProperties": 1, "additionalProperties": quantity(&dimensions) })
        }
        Kind::Support => {
            json!({ "type": "string", "pattern": r"^\s*(left abutment|right abutment|pier\s*[0-9]+)\s*$" })
        }
    };
    let Some(object) = schema.as_object_mut() else { return schema };
    object.insert("description".into(), json!(description(field)));
    if let Some(example) = example(field) {
        object.insert("examples".into(), json!([example]));
    }
    if let Need::Default(value) = field.need {
        object.insert("default".into(), literal(field, value));
    }
    schema
}

/// A value of whatever quantity.
fn one_value() -> Value {
    json!({ "type": ["string", "number", "boolean", "array"] })
}

/// What a field is, and what it means that it is not there.
fn description(field: &Field) -> String {
    match field.need {
        Need::Optional(meaning) => format!("{}. Where missing: {meaning}.", field.doc.trim_end_matches('.')),
        _ => field.doc.to_owned(),
    }
}

fn words(words: &[Word]) -> Value {
    let choices: Vec<Value> = words.iter().map(|word| json!({ "const": word.word, "description": word.doc })).collect();
    let names: Vec<&str> = words.iter().map(|word| word.word).collect();
    // The list serves completion, the choices their explanations.
    json!({ "type": "string", "enum": names, "oneOf": choices })
}

/// Text with a number and one of the units of the dimensions.
fn quantity(dimensions: &[Dimension]) -> Value {
    let units: Vec<String> = dimensions
        .iter()
        .flat_map(|dimension| dimension.accepted())
        .flat_map(|unit| spellings(unit.symbol))
        .map(|symbol| symbol.replace('^', r"\^"))
        .collect();
    let pattern = format!(r"^\s*[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?\s*({})\s*$", units.join("|"));
    json!({ "type": "string", "pattern": pattern })
}

/// A unit as it may be typed: kg/m^3, kg/m3, kg/m³.
fn spellings(symbol: &str) -> Vec<String> {
    let mut spellings = vec![symbol.to_owned()];
    if symbol.contains('^') {
        spellings.push(symbol.replace('^', ""));
        spellings.push(symbol.replace("^2", "²").replace("^3", "³"));
    }
    spellings
}

fn bounds(mut schema: Value, field: &Field) -> Value {
    let Some(object) = schema.as_object_mut() else { return schema };
    if field.limits.least.is_finite() {
        let name = if field.limits.least_included { "minimum" } else { "exclusiveMinimum" };
        object.insert(name.into(), json!(field.limits.least));
    }
    if field.limits.most.is_finite() {
        object.insert("maximum".into(), json!(field.limits.most));
    }
    schema
}

fn example(field: &Field) -> Option<Value> {
    (!field.example.is_empty()).then(|| literal(field, field.example))
}

/// A value as JSON has it; lists are written alike in TOML and JSON.
fn literal(field: &Field, text: &str) -> Value {
    let json = matches!(field.kind, Kind::Readings).then(|| text.replace("\" = \"", "\": \""));
    let text = json.as_deref().unwrap_or(text);
    if field.kind.is_bare() { serde_json::from_str(text).unwrap_or(Value::Null) } else { json!(text) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_is_in_the_schema_and_no_other() {
        let schema = schema();
        for section in sections_of(&FILE) {
            let table = if section.path.is_empty() { &schema } else { &schema["$defs"][section.path] };
            let keys: Vec<&str> = table["properties"].as_object().unwrap().keys().map(String::as_str).collect();
            let mut cards: Vec<&str> = section.fields.iter().map(|field| field.key).collect();
            cards.sort_unstable();
            let mut sorted = keys.clone();
            sorted.sort_unstable();
            assert_eq!(sorted, cards, "[{}]", section.path);
            assert_eq!(table["additionalProperties"], json!(false));
        }
        assert_eq!(schema["$defs"].as_object().unwrap().len() + 1, sections_of(&FILE).len());
    }

    #[test]
    fn examples_and_defaults_are_values() {
        for section in sections_of(&FILE) {
            for field in section.fields {
                if let Some(example) = example(field) {
                    assert!(!example.is_null(), "{}.{}: {}", section.path, field.key, field.example);
                }
                if let Need::Default(value) = field.need {
                    assert!(!literal(field, value).is_null(), "{}.{}: {value}", section.path, field.key);
                }
            }
        }
    }
}
