//! Model updating as a file asks for it: parameters by the paths of the file itself.

use crate::card::Kind;
use crate::edit::Document;
use crate::findings::Findings;
use crate::model::Bridge;
use crate::passage::default_sensors;
use crate::tree::Table;
use crate::update::{Channel, Parameter, Plan, Records, Spacing, UPDATE_SECTIONS, Update};
use crate::vary::{self, find, settle};

/// Most parameters: surfaces grow with their square, identifiability with the power of two.
const MOST_PARAMETERS: usize = 20;

/// Updating as the file asks for it; nothing where it says nothing of it or where something is wrong.
pub(crate) fn update(text: &str, file: &Table<'_>, bridge: Option<&Bridge>, findings: &mut Findings) -> Option<Update> {
    if !UPDATE_SECTIONS.iter().any(|section| file.has(section)) {
        return None;
    }
    // A load test that nobody has read yet can be planned.
    let at_rest = file.has("load_test");
    if !file.has("parameter") {
        file.need::<()>("parameter", findings);
    }
    if !file.has("records") && !at_rest {
        file.need::<()>("records", findings);
    }
    if file.has("records") && file.has("load_test") && !file.has("passage") {
        file.need::<()>("passage", findings);
    }
    let sensors = sensors(bridge);
    let records = match file.has("records") {
        true => records(file, sensors.as_deref(), findings).map(Some),
        false => at_rest.then_some(None),
    };
    let channels = channels(file, sensors.as_deref(), findings);
    let document = Document::parse(text).map(|mut document| {
        UPDATE_SECTIONS.iter().for_each(|section| document.remove(section));
        document
    });
    let parameters = parameters(file, document.as_ref(), findings);
    let plan = file.part("update", findings, Plan::of);
    Some(Update { records: records?, channels: channels?, parameters: parameters?, plan: plan? })
}

/// Names of the sensors; nothing where the bridge or its passage is not known.
fn sensors(bridge: Option<&Bridge>) -> Option<Vec<String>> {
    let bridge = bridge?;
    let at_rest = || bridge.load_test.as_ref().map(|test| test.sensors.clone());
    let sensors = bridge.passage.as_ref().map(|passage| passage.sensors.clone()).or_else(at_rest)?;
    let sensors = if sensors.is_empty() { default_sensors(bridge.spans.len()) } else { sensors };
    Some(sensors.into_iter().map(|sensor| sensor.name).collect())
}

fn records(file: &Table<'_>, names: Option<&[String]>, findings: &mut Findings) -> Option<Records> {
    let table = &file.table("records", findings)?;
    let records = Records::of(table, findings)?;
    if let (Some(align), Some(names)) = (&records.align, names)
        && !names.contains(align)
    {
        let help = format!("the sensors are {}", names.join(", "));
        findings.error("B671", table.place("align"), "there is no such sensor", "name of a [[sensor]]", help);
    }
    Some(records)
}

fn channels(file: &Table<'_>, names: Option<&[String]>, findings: &mut Findings) -> Option<Vec<Channel>> {
    let mut seen: Vec<String> = Vec::new();
    file.all("channel", findings, |table, findings| {
        let channel = Channel::of(table, findings)?;
        if let Some(names) = names {
            let known = names.contains(&channel.sensor);
            if !known || seen.contains(&channel.sensor) {
                let message = if known { "two tables name the same channel" } else { "there is no such sensor" };
                let help = format!("the sensors are {}", names.join(", "));
                findings.error("B671", table.place("sensor"), message, "name of a [[sensor]]", help);
            }
            seen.push(channel.sensor.clone());
        }
        Some(channel)
    })
}

fn parameters(file: &Table<'_>, document: Option<&Document>, findings: &mut Findings) -> Option<Vec<Parameter>> {
    let tables = file.tables("parameter", findings);
    if let Some(beyond) = tables.get(MOST_PARAMETERS) {
        let message = format!("there are {} parameters", tables.len());
        return findings.refuse(
            "B672",
            beyond.range,
            message,
            "there are twenty at most",
            "search for fewer at a time",
        );
    }
    let list = file.all("parameter", findings, |table, findings| parameter(table, document, findings))?;
    for (k, one) in list.iter().enumerate() {
        if list[..k].iter().any(|other| other.name == one.name || other.path == one.path) {
            let help = "name every quantity once, with its own name";
            findings.error("B672", tables[k].place("quantity"), "a parameter is there twice", "path or name", help);
        }
    }
    Some(list)
}

fn parameter(table: &Table<'_>, document: Option<&Document>, findings: &mut Findings) -> Option<Parameter> {
    let quantity: Option<String> = table.read("quantity", findings);
    let name: Option<Option<String>> = table.read("name", findings);
    let [lower, upper] = ["lower", "upper"].map(|key| table.read::<String>(key, findings));
    let logarithmic = match table.read("spacing", findings)? {
        Spacing::Linear => false,
        Spacing::Logarithmic => true,
    };
    let (quantity, name) = (quantity?, name?);
    let (lower, upper) = (lower?, upper?);
    let settled = find(document?, &quantity)
        .and_then(|found| settle(&found, &vary::Spread::List(vec![lower, upper])).map(|varied| (found, varied)));
    let (found, varied) = match settled {
        Ok(pair) => pair,
        Err(slip) => {
            let place = table.place(if slip.of_values { "lower" } else { "quantity" });
            return findings.refuse(slip.code, place, slip.message, slip.label, slip.help);
        }
    };
    let numbers = (varied.own.as_ref().and_then(|own| own.number), varied.values[0].number, varied.values[1].number);
    let continuous =
        matches!(found.field.kind, Kind::Quantity(_) | Kind::QuantityOr(..) | Kind::Number | Kind::Quantities(_));
    let (true, (Some(start), Some(lower), Some(upper))) = (continuous, numbers) else {
        let help = "name a quantity that has a number in this file, between two bounds of the same dimension";
        return findings.refuse(
            "B670",
            table.place("quantity"),
            "this is not a range of numbers",
            "not continuous",
            help,
        );
    };
    if !(lower < upper && lower <= start && start <= upper && (lower > 0.0 || !logarithmic)) {
        let message = format!("{lower} to {upper} is not a range that contains {start} {}", varied.unit);
        let help =
            "write a lower bound below the upper one, with the file's own value between; above zero where logarithmic";
        return findings.refuse("B670", table.place("lower"), message, "lower end of the acceptable range", help);
    }
    let name = name.unwrap_or(quantity);
    Some(Parameter { name, path: varied.path, unit: varied.unit, start, lower, upper, logarithmic })
}
