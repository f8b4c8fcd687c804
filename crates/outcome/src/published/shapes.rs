//! JSON Schemas of an engineer's own files of vehicles and rules, from the cards of their keys.

use rules::shape::{Key, Kind, Shape};
use rules::{LoadModel, Rule};
use serde_json::{Map, Value, json};

/// The schema of files of vehicles.
pub fn schema_of_vehicles() -> Value {
    headed("Extrados: vehicles", LoadModel::SHAPE)
}

/// The schema of files of rules.
pub fn schema_of_rules() -> Value {
    headed("Extrados: a rule", Rule::SHAPE)
}

fn headed(title: &str, shape: &Shape) -> Value {
    let mut schema = table(shape);
    schema["$schema"] = json!("https://json-schema.org/draft/2020-12/schema");
    schema["title"] = json!(title);
    schema
}

fn table(shape: &Shape) -> Value {
    let properties: Map<String, Value> = shape.keys.iter().map(|key| (key.name.to_owned(), value(key))).collect();
    let required: Vec<&str> = shape.keys.iter().filter(|key| key.required).map(|key| key.name).collect();
    json!({ "type": "object", "properties": properties, "required": required, "additionalProperties": false })
}

fn value(key: &Key) -> Value {
    let number = json!({ "type": "number" });
    let range = json!({
        "type": "object",
        "properties": { "from": number, "to": number, "step": number },
        "required": ["from", "to", "step"],
        "additionalProperties": false,
    });
    let mut schema = match key.kind {
        Kind::Text => json!({ "type": "string" }),
        Kind::Number => number,
        Kind::Flag => json!({ "type": "boolean" }),
        Kind::Word(words) => json!({ "enum": words }),
        Kind::Texts => json!({ "type": "array", "items": { "type": "string" } }),
        Kind::Words(words) => json!({ "type": "array", "items": { "enum": words } }),
        Kind::Numbers => json!({ "type": "array", "items": number }),
        Kind::Rows => json!({ "type": "array", "items": { "type": "array", "items": number } }),
        Kind::Spacings => json!({ "type": "array", "items": { "anyOf": [number, range] } }),
        Kind::Table(shape) => table(shape),
        Kind::Tables(shape) => json!({ "type": "array", "items": table(shape) }),
        Kind::Tagged(forms) => json!({ "oneOf": forms.iter().map(|form| table(form.1)).collect::<Vec<_>>() }),
    };
    schema["description"] = json!(key.doc);
    schema
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn schemas_hold_every_key() {
        let vehicles = schema_of_vehicles();
        let spacing = &vehicles["properties"]["vehicle"]["items"]["properties"]["spacings_m"];
        assert_eq!(spacing["items"]["anyOf"][1]["required"], json!(["from", "to", "step"]));
        let rule = schema_of_rules();
        let forms = rule["properties"]["loads"]["items"]["properties"]["impact"]["oneOf"].as_array().unwrap();
        assert_eq!(forms.len(), 5);
        assert!(forms.iter().all(|form| form["properties"]["kind"]["enum"].as_array().unwrap().len() == 1));
        assert!(rule["required"].as_array().unwrap().contains(&json!("factors")));
    }
}
