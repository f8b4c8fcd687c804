//! Model updating: records, channels, parameters, searches.

use super::{Field, Kind, Section};
use crate::choice::{Choice, choice};
use crate::edit::Document;
use crate::findings::Findings;
use crate::model::Bridge;
use crate::passage::default_sensors;
use crate::quantity::Dimension::Frequency;
use crate::tree::Table;
use crate::update::{Channel, Compared, Parameter, Plan, Records, Search, Start, Update, Variant, Weights};
use crate::values::read;
use crate::vary::{self, find, settle};

choice! {
    /// What the channel is laid on by which clocks are aligned.
    enum AlignedBy {
        /// its history in the start model
        Model = "model",
        /// the times at which axles pass its sensor
        Axles = "axles",
    }
}

pub(super) static RECORDS: Section = Section {
    path: "records",
    doc: "Records of a train's passage that `extrados update` compares with. Their columns are named after the sensors.",
    fields: &[
        Field::new(
            "place",
            Kind::Text,
            "a table (.csv), or a folder in which every table is a run; beside this file",
            "table-6.csv",
        ),
        Field::new("zero", Kind::Flag, "whether the level before the train is subtracted", "true").default("true"),
        Field::new("drift", Kind::Flag, "whether the line between the levels before and after is subtracted", "false")
            .default("false"),
        Field::new(
            "low_pass",
            Kind::Quantity(Frequency),
            "frequency above which records are filtered, forward and backward so that nothing shifts in time; noise \
             raises a peak, which is the largest of many samples",
            "10 Hz",
        )
        .positive()
        .optional("as recorded"),
        Field::new("align", Kind::Text, "the channel by which clocks are aligned", "crown displacement")
            .optional("the records' clock is that of [passage]: zero where the first axle starts"),
        Field::new("align_by", Kind::Word(AlignedBy::WORDS), "what that channel is aligned with", "model")
            .default(AlignedBy::Model.word()),
    ],
};

pub(super) static CHANNEL: Section = Section {
    path: "channel",
    doc: "Information on a channel of the records; sensors without a [[channel]] are compared as they are.",
    fields: &[
        Field::new("sensor", Kind::Text, "name of the sensor", "crown strain"),
        Field::new("column", Kind::Text, "name of the column in the records", "SG 4").optional("the sensor's name"),
        Field::new("reversed", Kind::Flag, "whether the sign of the records is reversed", "false").default("false"),
        Field::new("uncertainty", Kind::Number, "standard deviation of one value, in mm, microstrain or MPa", "0.01")
            .positive()
            .optional("not known; needed by the posterior and by `by_uncertainty`"),
        Field::new("weight", Kind::Number, "its weight, where weights are given", "1.0")
            .positive()
            .optional("needed only where `weights` = \"given\""),
        Field::new(
            "leave_out",
            Kind::Text,
            "reason for which it is left out; it is still shown",
            "a gauge on a stone sees no opening",
        )
        .optional("it is compared"),
    ],
};

choice! {
    /// How a range is divided.
    enum Spacing {
        /// evenly in the value
        Linear = "linear",
        /// evenly in its logarithm, for ranges over orders of magnitude
        Logarithmic = "logarithmic",
    }
}

pub(super) static PARAMETER: Section = Section {
    path: "parameter",
    doc: "A quantity of this file that `extrados update` searches for between bounds. The search starts at its own \
          value.",
    fields: &[
        Field::new("quantity", Kind::Text, "path of the quantity, as in [[vary]]", "fill.elastic_modulus"),
        Field::new("name", Kind::Text, "name in results", "fill").optional("its path"),
        Field::new("lower", Kind::Value, "lower end of the acceptable range", "20 MPa"),
        Field::new("upper", Kind::Value, "upper end of the acceptable range", "200 MPa"),
        Field::new("spacing", Kind::Word(Spacing::WORDS), "how the range is divided", "linear")
            .default(Spacing::Linear.word()),
    ],
};

pub(super) static UPDATE: Section = Section {
    path: "update",
    doc: "How `extrados update` searches for the parameters.",
    fields: &[
        Field::new("search", Kind::Word(Search::WORDS), "which search", "modern").default(Search::Modern.word()),
        Field::new("variant", Kind::Word(Variant::WORDS), "reading of the hierarchical search", "printed")
            .default(Variant::Printed.word()),
        Field::new("start", Kind::Word(Start::WORDS), "where the hierarchical search begins", "means")
            .default(Start::Means.word()),
        Field::new("starts", Kind::Count, "starts of the modern search", "4")
            .at_least(1.0)
            .at_most(1000.0)
            .default("4"),
        Field::new("passes", Kind::Count, "most passes of the hierarchical search", "2")
            .at_least(1.0)
            .at_most(100.0)
            .default("2"),
        Field::new("points", Kind::Count, "points of a sweep, and of a surface along each parameter", "11")
            .at_least(3.0)
            .at_most(201.0)
            .default("11"),
        Field::new("compare", Kind::Word(Compared::WORDS), "what is compared", "peaks").default(Compared::Peaks.word()),
        Field::new(
            "slices",
            Kind::Flag,
            "whether peaks are compared in static slices instead of full passages",
            "true",
        )
        .default("true"),
        Field::new("weights", Kind::Word(Weights::WORDS), "where weights come from", "shapes")
            .default(Weights::Shapes.word()),
        Field::new("by_uncertainty", Kind::Flag, "whether errors are expressed in multiples of `uncertainty`", "false")
            .default("false"),
        Field::new(
            "posterior",
            Kind::Flag,
            "whether the posterior of the parameters is \
                                             sampled",
            "false",
        )
        .default("false"),
        Field::new(
            "model_error",
            Kind::Number,
            "scale of the model's own error, a share of the peaks; 0 for none",
            "0.1",
        )
        .at_least(0.0)
        .at_most(1.0)
        .default("0.1"),
        Field::new(
            "common_gain_deviation",
            Kind::Number,
            "standard deviation of a gain that all channels share, a share of the response: axle loads as they are against those of \
             [train], the width that carries them, the share of a track; 0 where all of these are known exactly",
            "0.1",
        )
        .at_least(0.0)
        .at_most(0.5)
        .default("0.1"),
        Field::new("samples", Kind::Count, "effective samples of the posterior", "10000")
            .at_least(100.0)
            .at_most(1_000_000.0)
            .default("10000"),
        Field::new("seed", Kind::Count, "seed of starts, surrogate and posterior", "1")
            .at_least(0.0)
            .at_most(9e15)
            .default("1"),
    ],
};

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
        file.need(key, findings);
    }
    let sensors = sensors(bridge);
    let records = records(file, sensors.as_deref(), findings);
    let channels = channels(file, sensors.as_deref(), findings);
    let document = Document::parse(text).map(|mut document| {
        SECTIONS.iter().for_each(|section| document.remove(section));
        document
    });
    let parameters = parameters(file, document.as_ref(), findings);
    let plan = file.part("update", findings, plan);
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
    let table = &file.table("records", findings)?;
    let by = table.read("align_by", findings);
    let records = read!(
        table,
        findings,
        Records {
            place,
            zero,
            drift,
            low_pass,
            align;
            by_axles: match by? {
                AlignedBy::Model => false,
                AlignedBy::Axles => true,
            },
        }
    )?;
    if let (Some(align), Some(names)) = (&records.align, names)
        && !names.contains(align)
    {
        let help = format!("the sensors are {}", names.join(", "));
        findings.error("B671", table.place("align"), "there is no such sensor", "name of a [[sensor]]", help);
    }
    Some(records)
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
    read!(table, findings, Channel { sensor, column, reversed, uncertainty, weight, left_out = "leave_out" })
}

fn parameters(file: &Table<'_>, document: Option<&Document>, findings: &mut Findings) -> Option<Vec<Parameter>> {
    let tables = file.tables("parameter", findings);
    if let Some(beyond) = tables.get(MOST_PARAMETERS) {
        let message = format!("there are {} parameters", tables.len());
        findings.error("B672", beyond.range, message, "there are twenty at most", "search for fewer at a time");
        return None;
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
    let name = name.unwrap_or(quantity);
    Some(Parameter { name, path: varied.path, unit: varied.unit, start, lower, upper, logarithmic })
}

fn plan(table: &Table<'_>, findings: &mut Findings) -> Option<Plan> {
    read!(
        table,
        findings,
        Plan {
            search,
            variant,
            start,
            starts,
            passes,
            points,
            compare,
            slices,
            weights,
            by_uncertainty,
            posterior,
            model_error,
            common_gain_deviation,
            samples,
            seed,
        }
    )
}
