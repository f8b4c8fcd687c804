//! `extrados vehicles`: the vehicles and rules that a bridge file can name in [sweep] and [assess].

use crate::report::Report;
use crate::status::Status;
use assess::vehicles::{Extent, Library, LoadModel, Published, Rule, Source, Spacing, Uniform, Vehicle, Ways, library};
use extrados::Refusal;
use findings::words::counted;
use serde_json::{Value, json};
use std::fmt::Write;

/// Gravity by which the trains' axles weigh here; a bridge file may give another [m/s^2].
pub(super) const GRAVITY: f64 = 9.81;

/// Lists the library, or what bears one name.
pub(super) fn run(asked: Option<&str>) -> Result<Report, Refusal> {
    let library = library(GRAVITY).map_err(|unknown| Refusal::new("F126", unknown.to_string(), "report this"))?;
    let is = |code: &str| asked.is_none_or(|name| code.eq_ignore_ascii_case(name));
    // A name of a load model stands for all of its vehicles, as in a bridge file.
    let vehicles: Vec<(&LoadModel, &Vehicle)> =
        library.vehicles().filter(|(model, vehicle)| is(&vehicle.code) || is(&model.code)).collect();
    let rules: Vec<&Rule> = library.rules.iter().filter(|rule| is(&rule.code)).collect();
    if let Some(name) = asked.filter(|_| vehicles.is_empty() && rules.is_empty()) {
        let message = format!("the library has no vehicle, load model or rule \"{name}\"");
        return Err(Refusal::new("F126", message, "extrados vehicles lists them all"));
    }
    let mut page = String::new();
    if !vehicles.is_empty() {
        page += "Vehicles, by load model: names for `vehicles` in [sweep]\n";
        told_vehicles(&mut page, &library, &vehicles, asked.is_some());
    }
    if !rules.is_empty() {
        page += if page.is_empty() { "" } else { "\n" };
        page += "Rules: names for `rule` in [sweep] and [assess]\n";
        rules.iter().for_each(|rule| told_rule(&mut page, &library, rule, asked.is_some()));
    }
    if asked.is_none() {
        page += "\nextrados vehicles NAME tells more of one. Files of your own: `vehicle_files` and `rule_file` in [sweep], docs/input/vehicles.md\n";
    }
    let listed: Vec<Value> = vehicles.iter().map(|(model, vehicle)| vehicle_object(&library, model, vehicle)).collect();
    let factors: Vec<Value> = rules.iter().map(|rule| rule_object(&library, rule)).collect();
    Ok(Report::new(Status::Completed).with("vehicles", listed).with("rules", factors).saying(page))
}

fn told_vehicles(page: &mut String, library: &Library, vehicles: &[(&LoadModel, &Vehicle)], whole: bool) {
    let longest = vehicles.iter().map(|(_, vehicle)| vehicle.code.len()).max().unwrap_or(0);
    let mut last = "";
    for (model, vehicle) in vehicles {
        if model.code != last {
            last = &model.code;
            let _ = writeln!(page, "\n  {}: {}, {}", model.code, model.title, way(model.ways));
            let _ = writeln!(page, "    source: {}", source_words(&model.source));
            let _ = writeln!(page, "    rules made for it: {}", or_none(&rules_for(library, model)));
            let _ = writeln!(page, "    compared with: {}", compared_with(model));
            if !model.left_out.is_empty() {
                let _ = writeln!(page, "    left out: {}", model.left_out.join("; "));
            }
            if let Some(limit) = &model.span_limit {
                let _ = writeln!(page, "    for spans up to {} m: {}", limit.longest_m, limit.reason);
            }
        }
        let _ = writeln!(page, "    {:<longest$}  {}: {}", vehicle.code, vehicle.title, loads(vehicle));
        if !vehicle.with.is_empty() {
            let _ = writeln!(page, "    {:<longest$}  and with it {}", "", vehicle.with.join(", "));
        }
        if let Some(source) = &vehicle.source {
            let _ = writeln!(page, "    {:<longest$}  source: {}", "", source_words(source));
        }
        if whole && !vehicle.spacings_m.is_empty() {
            let spacings: Vec<String> = vehicle.spacings_m.iter().map(|spacing| distance(*spacing)).collect();
            let _ = writeln!(page, "    {:<longest$}  distances between axles [m]: {}", "", runs(&spacings));
        }
    }
}

fn told_rule(page: &mut String, library: &Library, rule: &Rule, whole: bool) {
    let ways: Vec<&str> = rule.ways.iter().map(|ways| way(*ways)).collect();
    let _ = writeln!(page, "\n  {}: {}, {}", rule.code, rule.title, ways.join(" and "));
    let _ = writeln!(page, "    source: {}", source_words(&rule.source));
    let _ = writeln!(page, "    load models: {}", or_none(&models_of(library, rule)));
    if !rule.requires.is_empty() {
        let words: Vec<&str> = rule.requires.iter().map(|one| one.what.word()).collect();
        let _ = writeln!(page, "    asks for: {}", words.join(", "));
    }
    for (name, factor) in rule.listed().into_iter().filter(|_| whole) {
        let _ = writeln!(page, "    {name}: {} ({})", factor.value, source_words(&factor.source));
    }
}

/// How many numbers somebody published, and how many were worked out by hand: "12 published numbers in 2 tables, 4 by hand".
fn compared_with(model: &LoadModel) -> String {
    let numbers = |tables: &[Published]| tables.iter().map(|table| table.values.len()).sum::<usize>();
    let (published, checked) = (numbers(&model.published), numbers(&model.checked));
    match (published, checked) {
        (0, 0) => "nothing".to_owned(),
        (0, checked) => format!("no published table; {checked} numbers worked out by hand from the same loads"),
        (published, checked) => {
            let tables = counted(model.published.len(), "table");
            let by_hand = if checked > 0 { format!("; {checked} worked out by hand") } else { String::new() };
            format!("{published} published numbers in {tables}{by_hand}")
        }
    }
}

/// A source with its confidence; what else a reader should know stands in the object.
fn source_words(source: &Source) -> String {
    format!("{}, {}, {}", source.text, source.date, source.confidence.word())
}

/// Axles, first to last, and uniform loads.
fn loads(vehicle: &Vehicle) -> String {
    let axles: Vec<String> = vehicle.axle_loads_kn.iter().map(|load| number(*load)).collect();
    let mut parts = Vec::new();
    if !axles.is_empty() {
        parts.push(format!("axles of {} kN", runs(&axles)));
    }
    parts.extend(vehicle.uniform.iter().map(|load| format!("{} kN/m {}", number(load.load_kn_per_m), place(load))));
    parts.join(", ")
}

/// Equal neighbours together: "2 x 60, 80".
fn runs(words: &[String]) -> String {
    let groups = words.chunk_by(|a, b| a == b);
    let told = groups.map(|group| match group.len() {
        1 => group[0].clone(),
        many => format!("{many} x {}", group[0]),
    });
    told.collect::<Vec<_>>().join(", ")
}

/// To a hundredth, without zeros at the end.
fn number(value: f64) -> String {
    ((100.0 * value).round() / 100.0).to_string()
}

fn distance(spacing: Spacing) -> String {
    let [from, to] = spacing.range();
    if from == to { number(from) } else { format!("{} to {}", number(from), number(to)) }
}

fn place(load: &Uniform) -> &'static str {
    match load.place {
        Extent::Ahead => "ahead",
        Extent::Behind => "behind",
        Extent::Everywhere => "along the whole bridge",
        Extent::Part => "over a part of the vehicle",
    }
}

fn way(ways: Ways) -> &'static str {
    match ways {
        Ways::Rail => "rail",
        Ways::Road => "road",
    }
}

fn rules_for<'a>(library: &'a Library, model: &LoadModel) -> Vec<&'a str> {
    library.rules.iter().filter(|rule| rule.acting(model).is_some()).map(|rule| rule.code.as_str()).collect()
}

fn models_of<'a>(library: &'a Library, rule: &Rule) -> Vec<&'a str> {
    library.models.iter().filter(|model| rule.acting(model).is_some()).map(|model| model.code.as_str()).collect()
}

fn or_none(codes: &[&str]) -> String {
    if codes.is_empty() { "none".to_owned() } else { codes.join(", ") }
}

fn source_object(source: &Source) -> Value {
    json!({
        "source": source.text,
        "date": source.date,
        "confidence": source.confidence.word(),
        "note": source.note,
    })
}

fn vehicle_object(library: &Library, model: &LoadModel, vehicle: &Vehicle) -> Value {
    let spacings: Vec<[f64; 2]> = vehicle.spacings_m.iter().map(|spacing| spacing.range()).collect();
    let uniform: Vec<Value> = vehicle
        .uniform
        .iter()
        .map(|load| json!({ "load_kn_per_m": load.load_kn_per_m, "place": place(load) }))
        .collect();
    let mut object = json!({
        "code": vehicle.code,
        "title": vehicle.title,
        "load_model": model.code,
        "load_model_title": model.title,
        "ways": way(model.ways),
        "rules": rules_for(library, model),
        "axle_loads_kn": vehicle.axle_loads_kn,
        "spacings_m": spacings,
        "uniform": uniform,
        "longest_span_m": model.span_limit.as_ref().map(|limit| limit.longest_m),
        "lanes": vehicle.lanes,
        "with": vehicle.with,
        "left_out": model.left_out,
        "published_numbers": numbers_of(&model.published, vehicle),
        "checked_numbers": numbers_of(&model.checked, vehicle),
    });
    merge(&mut object, source_object(model.source_of(vehicle)));
    object
}

/// How many numbers of tables a vehicle is compared with.
fn numbers_of(tables: &[Published], vehicle: &Vehicle) -> usize {
    let own = tables.iter().filter(|table| table.vehicle.eq_ignore_ascii_case(&vehicle.code));
    own.map(|table| table.values.len()).sum()
}

fn rule_object(library: &Library, rule: &Rule) -> Value {
    let factors: Vec<Value> = rule
        .listed()
        .into_iter()
        .map(|(name, factor)| {
            let mut object = json!({ "name": name, "value": factor.value });
            merge(&mut object, source_object(&factor.source));
            object
        })
        .collect();
    let ways: Vec<&str> = rule.ways.iter().map(|ways| way(*ways)).collect();
    let mut object = json!({
        "code": rule.code,
        "title": rule.title,
        "ways": ways,
        "load_models": models_of(library, rule),
        "factors": factors,
        "requires": rule.requires.iter().map(|one| json!({ "what": one.what.word(), "source": one.source.text })).collect::<Vec<_>>(),
    });
    merge(&mut object, source_object(&rule.source));
    object
}

/// Takes over the keys of another object.
fn merge(object: &mut Value, more: Value) {
    if let (Some(own), Value::Object(more)) = (object.as_object_mut(), more) {
        own.extend(more);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_neighbours_are_told_together() {
        let words = ["60", "60", "80", "60"].map(str::to_owned);
        assert_eq!(runs(&words), "2 x 60, 80, 60");
        assert_eq!(runs(&[]), "");
        assert_eq!([number(112.5), number(245.166), number(1e3)], ["112.5", "245.17", "1000"]);
    }
}
