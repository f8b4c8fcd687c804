//! What `extrados update` is asked for in the file.

use super::materials::maybe;
use super::structure::need;
use crate::edit::Document;
use crate::fields::Kind;
use crate::findings::Findings;
use crate::model::Bridge;
use crate::passage::default_sensors;
use crate::tree::Table;
use crate::update::{Channel, Parameter, Plan, Records, Update};
use crate::vary::{Spread, find, settle};

/// Sections of updating, which are no part of the bridge.
pub(crate) const SECTIONS: [&str; 4] = ["records", "channel", "parameter", "update"];

/// Most parameters: surfaces grow with their square, identifiability with the power of two.
const MOST_PARAMETERS: usize = 20;

/// Updating as the file asks for it; nothing where it says nothing of it or where something is wrong.
pub(crate) fn update(text: &str, file: &Table<'_>, bridge: Option<&Bridge>, findings: &mut Findings) -> Option<Update> {
    if !SECTIONS.iter().any(|section| file.has(section)) {
        return None;
    }
    for key in ["records", "parameter"].into_iter().filter(|key| !file.has(key)) {
        need(file, key, findings);
    }
    let sensors = sensors(bridge);
    let records = records(file, sensors.as_deref(), findings);
    let channels = channels(file, sensors.as_deref(), findings);
    let document = Document::parse(text).map(|mut document| {
        SECTIONS.iter().for_each(|section| document.remove(section));
        document
    });
    let parameters = parameters(file, document.as_ref(), findings);
    let plan = plan(file, findings);
    Some(Update { records: records?, channels: channels?, parameters: parameters?, plan: plan? })
}

/// Names of the sensors; nothing where the bridge or its passage is not known.
fn sensors(bridge: Option<&Bridge>) -> Option<Vec<String>> {
    let bridge = bridge?;
    let sensors = bridge.passage.as_ref().map(|passage| passage.sensors.clone())?;
    let sensors = if sensors.is_empty() { default_sensors(bridge.spans.len()) } else { sensors };
    Some(sensors.into_iter().map(|sensor| sensor.name).collect())
}

fn records(file: &Table<'_>, names: Option<&[String]>, findings: &mut Findings) -> Option<Records> {
    let table = file.table("records", findings)?;
    let place = table.text("place", findings);
    let (zero, drift) = (table.flag("zero", findings), table.flag("drift", findings));
    let low_pass = table.quantity("low_pass", findings);
    let (align, by) = (table.text("align", findings), table.word("align_by", findings));
    let align = maybe(&table, "align", align)?.map(str::to_owned);
    if let (Some(align), Some(names)) = (&align, names)
        && !names.contains(align)
    {
        let help = format!("the sensors are {}", names.join(", "));
        findings.error("B671", table.place("align"), "there is no such sensor", "name of a [[sensor]]", help);
    }
    Some(Records {
        zero: maybe(&table, "zero", zero)?.unwrap_or(true),
        drift: maybe(&table, "drift", drift)?.unwrap_or(false),
        low_pass: maybe(&table, "low_pass", low_pass)?,
        align,
        by_axles: maybe(&table, "align_by", by)? == Some("axles"),
        place: place?.value.to_owned(),
    })
}

fn channels(file: &Table<'_>, names: Option<&[String]>, findings: &mut Findings) -> Option<Vec<Channel>> {
    let tables = file.tables("channel", findings);
    let mut seen: Vec<String> = Vec::new();
    let mut list = Vec::new();
    for table in &tables {
        let channel = channel(table, findings);
        if let (Some(channel), Some(names)) = (&channel, names) {
            let known = names.contains(&channel.sensor);
            if !known || seen.contains(&channel.sensor) {
                let message = if known { "two tables name the same channel" } else { "there is no such sensor" };
                let help = format!("the sensors are {}", names.join(", "));
                findings.error("B671", table.place("sensor"), message, "name of a [[sensor]]", help);
            }
            seen.push(channel.sensor.clone());
        }
        list.push(channel);
    }
    list.into_iter().collect()
}

fn channel(table: &Table<'_>, findings: &mut Findings) -> Option<Channel> {
    let sensor = table.text("sensor", findings);
    let (column, left_out) = (table.text("column", findings), table.text("leave_out", findings));
    let reversed = table.flag("reversed", findings);
    let (uncertainty, weight) = (table.number("uncertainty", findings), table.number("weight", findings));
    Some(Channel {
        column: maybe(table, "column", column)?.map(str::to_owned),
        reversed: maybe(table, "reversed", reversed)?.unwrap_or(false),
        uncertainty: maybe(table, "uncertainty", uncertainty)?,
        weight: maybe(table, "weight", weight)?,
        left_out: maybe(table, "leave_out", left_out)?.map(str::to_owned),
        sensor: sensor?.value.to_owned(),
    })
}

fn parameters(file: &Table<'_>, document: Option<&Document>, findings: &mut Findings) -> Option<Vec<Parameter>> {
    let tables = file.tables("parameter", findings);
    if let Some(beyond) = tables.get(MOST_PARAMETERS) {
        let message = format!("there are {} parameters", tables.len());
        findings.error("B672", beyond.range, message, "there are twenty at most", "search for fewer at a time");
        return None;
    }
    let list: Vec<Option<Parameter>> = tables.iter().map(|table| parameter(table, document, findings)).collect();
    let list: Vec<Parameter> = list.into_iter().collect::<Option<_>>()?;
    for (k, one) in list.iter().enumerate() {
        if list[..k].iter().any(|other| other.name == one.name || other.path == one.path) {
            let help = "name every quantity once, with its own name";
            findings.error("B672", tables[k].place("quantity"), "a parameter is there twice", "path or name", help);
        }
    }
    Some(list)
}

fn parameter(table: &Table<'_>, document: Option<&Document>, findings: &mut Findings) -> Option<Parameter> {
    let quantity = table.text("quantity", findings);
    let name = table.text("name", findings);
    let (lower, upper) = (table.value("lower", findings), table.value("upper", findings));
    let spacing = table.word("spacing", findings);
    let logarithmic = maybe(table, "spacing", spacing)? == Some("logarithmic");
    let name = maybe(table, "name", name)?;
    let (quantity, lower, upper) = (quantity?, lower?, upper?);
    let settled = find(document?, quantity.value)
        .and_then(|found| settle(&found, &Spread::List(vec![lower, upper])).map(|varied| (found, varied)));
    let (found, varied) = match settled {
        Ok(pair) => pair,
        Err(slip) => {
            let place = table.place(if slip.of_values { "lower" } else { "quantity" });
            findings.error(slip.code, place, slip.message, slip.label, slip.help);
            return None;
        }
    };
    let numbers = (varied.own.as_ref().and_then(|own| own.number), varied.values[0].number, varied.values[1].number);
    let continuous =
        matches!(found.field.kind, Kind::Quantity(_) | Kind::QuantityOr(..) | Kind::Number | Kind::Quantities(_));
    let (true, (Some(start), Some(lower), Some(upper))) = (continuous, numbers) else {
        let help = "name a quantity that has a number in this file, between two bounds of the same dimension";
        findings.error("B670", table.place("quantity"), "this is not a range of numbers", "not continuous", help);
        return None;
    };
    if !(lower < upper && lower <= start && start <= upper && (lower > 0.0 || !logarithmic)) {
        let message = format!("{lower} to {upper} is not a range that contains {start} {}", varied.unit);
        let help =
            "write a lower bound below the upper one, with the file's own value between; above zero where logarithmic";
        findings.error("B670", table.place("lower"), message, "lower end of the acceptable range", help);
        return None;
    }
    let name = name.map_or_else(|| quantity.value.to_owned(), str::to_owned);
    Some(Parameter { name, path: varied.path, unit: varied.unit, start, lower, upper, logarithmic })
}

fn plan(file: &Table<'_>, findings: &mut Findings) -> Option<Plan> {
    let table = if file.has("update") { Some(file.table("update", findings)?) } else { None };
    let word = |key: &str, default: &'static str, findings: &mut Findings| match &table {
        Some(table) => {
            let value = table.word(key, findings);
            maybe(table, key, value).map(|word| word.unwrap_or(default))
        }
        None => Some(default),
    };
    let count = |key: &str, default: u64, findings: &mut Findings| match &table {
        Some(table) => {
            let value = table.count(key, findings);
            maybe(table, key, value).map(|count| count.unwrap_or(default))
        }
        None => Some(default),
    };
    let flag = |key: &str, default: bool, findings: &mut Findings| match &table {
        Some(table) => {
            let value = table.flag(key, findings);
            maybe(table, key, value).map(|flag| flag.unwrap_or(default))
        }
        None => Some(default),
    };
    let (search, variant, start) =
        (word("search", "modern", findings), word("variant", "printed", findings), word("start", "means", findings));
    let (compare, weights) = (word("compare", "peaks", findings), word("weights", "shapes", findings));
    let (starts, passes, points) =
        (count("starts", 4, findings), count("passes", 2, findings), count("points", 11, findings));
    let (samples, seed) = (count("samples", 10_000, findings), count("seed", 1, findings));
    let (by_uncertainty, posterior) = (flag("by_uncertainty", false, findings), flag("posterior", false, findings));
    let slices = flag("slices", true, findings);
    let model_error = match &table {
        Some(table) => {
            let value = table.number("model_error", findings);
            maybe(table, "model_error", value)?.unwrap_or(0.1)
        }
        None => 0.1,
    };
    Some(Plan {
        search: search?,
        variant: variant?,
        start: start?,
        starts: starts?,
        passes: passes?,
        points: points?,
        compare: compare?,
        slices: slices?,
        weights: weights?,
        by_uncertainty: by_uncertainty?,
        posterior: posterior?,
        model_error,
        samples: samples?,
        seed: seed?,
    })
}
