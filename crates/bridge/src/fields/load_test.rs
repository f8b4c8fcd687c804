//! Loads at rest, and readings.

use super::structure::PlacedSpan;
use super::{train, vehicle};
use crate::card::{Field, Kind, Section};
use crate::cards::*;
use crate::findings::Findings;
use crate::load_test::{LoadTest, Patch, PatchForce, Position, Readings, Sequence, Standing, measured};
use crate::passage::{Passage, PassagePlan, Way};
use crate::quantity::{self, Dimension};
use crate::resolve::Layout;
use crate::sensor::{Sensor, default_sensors};
use crate::tree::{At, Table, shorten, wrong_type};
use toml::de::DeValue;

const fn readings(key: &'static str, doc: &'static str, example: &'static str) -> Field {
    Field::new(key, Kind::Readings, doc, example)
}

pub(super) static LOAD_TEST: Section = Section {
    path: "load_test",
    doc: "Loads at rest on the bridge, and what sensors read. `extrados respond` says what to expect in each position, `extrados update` compares \
          it with the readings. Readings are changes from that of the unloaded bridge before the first position.",
    fields: &[
        word::<Sequence>("sequence", "from which state each position is reached", "independent")
            .default(Sequence::Independent.word()),
        text(
            "readings",
            "a table beside this file (.csv): a row for each position, a column for each sensor with its unit, `crown displacement [mm]`",
            "load-test.csv",
        )
        .optional("the `readings` of each position"),
        readings(
            "uncertainty",
            "standard deviation of one reading, by sensor",
            r#"{ "crown displacement" = "0.02 mm", "crown strain" = "2 microstrain" }"#,
        )
        .optional("`uncertainty` of [[channel]], or else 1 % of the sensor's largest reading"),
        tables("position", &POSITION, "The positions, in the order of the test.").at_most(1000.0),
    ],
};

static POSITION: Section = Section {
    path: "load_test.position",
    doc: "A position of the load test: all that stands on the bridge at the same time.",
    fields: &[
        text("name", "name of the position", "quarter point").at_most(200.0),
        tables("vehicle", &STANDING, "Vehicles that stand on the bridge.").at_most(100.0).optional("no vehicle"),
        tables("force", &FORCE, "Forces of jacks, beams or weights on the surface.")
            .at_most(100.0)
            .optional("no force"),
        readings(
            "readings",
            "what sensors read, by their names",
            r#"{ "crown displacement" = "-0.31 mm", "crown strain" = "-24 microstrain" }"#,
        )
        .optional("those of the table, or none"),
    ],
};

static STANDING: Section = Section {
    path: "load_test.position.vehicle",
    doc: "A vehicle at rest. On a road its wheels press as those of [vehicle] do; a train stands on [track].",
    fields: Standing::CARDS,
};

static FORCE: Section = Section {
    path: "load_test.position.force",
    doc: "A force that presses evenly on a part of the surface, downwards.",
    fields: &[
        length("x", "middle of the part, from the left springing of the first span", "4.2 m"),
        line_load("force", "whole force, or force per metre of the width that carries it", "120 kN")
            .positive_up_to(1e7),
        length("length", "length of the part, along the bridge", "0.30 m").between(0.02, 20.0),
        length(
            "width",
            "width of the part, across the bridge; it spreads 1:2 to either side through the cover over the crown",
            "0.60 m",
        )
        .between(0.02, 100.0)
        .optional("the width of the barrel"),
    ],
};

/// The load test; `None` inside where there is none. `passage` as it was read, whose settings, vehicle and sensors it shares; `width` of the
/// barrel [m].
pub(crate) fn load_test(
    file: &Table<'_>,
    passage: Option<&Option<Passage>>,
    width: Option<f64>,
    (spans, layout): (Option<&[PlacedSpan]>, Option<&Layout>),
    findings: &mut Findings,
) -> Option<Option<LoadTest>> {
    if !file.has("load_test") {
        return Some(None);
    }
    let table = file.table("load_test", findings);
    let shared = match passage {
        Some(Some(known)) => Some(Shared {
            train: Some(known.train.clone()),
            way: Some(known.way.clone()),
            plan: known.plan.clone(),
            sensors: known.sensors.clone(),
        }),
        Some(None) => alone(file, width, (spans, layout), findings),
        None => None,
    };
    let table = table?;
    let sequence = table.read("sequence", findings);
    let path: Option<Option<String>> = table.read("readings", findings);
    let positions = positions(&table, file, width, findings);
    let Shared { train, way, plan, sensors } = shared?;
    let sensors = match sensors.is_empty() {
        true => default_sensors(layout?.spans.len()),
        false => sensors,
    };
    let readings = written(&table, &sensors, findings);
    let (values, uncertainty) = readings?;
    let readings = Readings { file: path?, synthetic: None, values, uncertainty };
    Some(Some(LoadTest { train, way, plan, sensors, positions: positions?, sequence: sequence?, readings }))
}

/// What a load test has in common with a passage.
struct Shared {
    train: Option<crate::train::Train>,
    way: Option<Way>,
    plan: PassagePlan,
    sensors: Vec<Sensor>,
}

/// The same where nothing crosses.
fn alone(
    file: &Table<'_>,
    width: Option<f64>,
    (spans, layout): (Option<&[PlacedSpan]>, Option<&Layout>),
    findings: &mut Findings,
) -> Option<Shared> {
    if let Some(other) = ["train", "track"].into_iter().find(|key| file.has("vehicle") && file.has(key)) {
        return file.exclude(other, "[vehicle]", findings);
    }
    let (train, way) = if file.has("vehicle") {
        let (train, way) = vehicle::vehicle(file, width, findings);
        (train.map(Some), way.map(Some))
    } else {
        if file.has("train") && !file.has("track") {
            return file.need("track", findings);
        }
        let train = file.has("train").then(|| train::train(file, findings));
        let track = file.has("track").then(|| train::track(file, width, findings));
        (
            train.map_or(Some(None), |train| train.map(Some)),
            track.map_or(Some(None), |track| track.map(|it| Some(Way::Rails(it)))),
        )
    };
    let plan = file.part("passage", findings, PassagePlan::of);
    let sensors = crate::sensor::sensors(file, spans, layout, findings);
    Some(Shared { train: train?, way: way?, plan: plan?, sensors: sensors? })
}

fn positions(
    table: &Table<'_>,
    file: &Table<'_>,
    width: Option<f64>,
    findings: &mut Findings,
) -> Option<Vec<Position>> {
    let tables = table.tables("position", findings);
    let list = table.all("position", &mut Findings::default(), |table, _| Some(table.place("name")));
    let read: Vec<Option<Position>> = tables.iter().map(|one| position(one, file, width, findings)).collect();
    let read = read.into_iter().collect::<Option<Vec<Position>>>()?;
    for (k, one) in read.iter().enumerate() {
        if read[..k].iter().any(|other| other.name == one.name) {
            let place = list.as_ref().and_then(|places| places.get(k)).copied().unwrap_or(table.range);
            let help = "give each a name of its own: readings are told apart by it";
            findings.error("B680", place, "two positions have the same name", "name of a position", help);
        }
    }
    (!read.is_empty()).then_some(read)
}

fn position(table: &Table<'_>, file: &Table<'_>, width: Option<f64>, findings: &mut Findings) -> Option<Position> {
    let name: Option<At<String>> = table.read("name", findings);
    let vehicles = table.all("vehicle", findings, |table, findings| {
        let one = Standing::of(table, findings)?;
        if one.vehicle.is_none() && !["vehicle", "train"].iter().any(|key| file.has(key)) {
            return findings.refuse(
                "B681",
                table.place("front_axle"),
                "the file describes no vehicle that could stand here",
                "first axle of a vehicle",
                "describe it with [vehicle], or write the name of one of the library: name = \"…\"",
            );
        }
        Some(one)
    });
    let forces = table.all("force", findings, |table, findings| patch(table, width, findings));
    let name = name?;
    if name.value.trim().is_empty() || name.value.contains([',', '"', ';', '\t']) {
        return findings.refuse(
            "B680",
            name.range,
            "this is no name for a position",
            "it heads a row of readings",
            "write a word or some, without commas, semicolons and quotes",
        );
    }
    let (vehicles, forces) = (vehicles?, forces?);
    if vehicles.is_empty() && forces.is_empty() {
        return findings.refuse(
            "B681",
            name.range,
            format!("nothing stands on the bridge in position \"{}\"", shorten(&name.value)),
            "a position at rest",
            "add vehicle = { front_axle = \"… m\" }, or force = { x = \"… m\", force = \"… kN\", length = \"… m\" }",
        );
    }
    Some(Position { name: name.value.trim().to_owned(), vehicles, forces })
}

fn patch(table: &Table<'_>, width: Option<f64>, findings: &mut Findings) -> Option<Patch> {
    let x = table.read("x", findings);
    let length = table.read("length", findings);
    let across: Option<Option<f64>> = table.read("width", findings);
    let force = table.entry("force").and_then(|(field, raw)| {
        let dimensions = [Dimension::Force, Dimension::LineLoad];
        let quantity = crate::values::measure(field, raw, &dimensions, findings)?;
        Some(match quantity.unit.dimension {
            Dimension::LineLoad => PatchForce::PerWidth(quantity.si()),
            _ => PatchForce::Whole(quantity.si()),
        })
    });
    if let (Some(Some(across)), Some(width)) = (across, width)
        && across > width * (1.0 + 1e-12)
    {
        findings.error(
            "B303",
            table.place("width"),
            "the force is wider than the barrel",
            format!("the barrel is {width} m wide"),
            format!("write \"{width} m\" or less, or leave it out"),
        );
    }
    Some(Patch { x: x?, force: force?, length: length?, width: across? })
}

/// Readings by sensor and position, and uncertainties by sensor [SI].
type Written = (Vec<Vec<Option<f64>>>, Vec<Option<f64>>);

/// What the file itself holds of readings.
fn written(table: &Table<'_>, sensors: &[Sensor], findings: &mut Findings) -> Option<Written> {
    let tables = table.tables("position", &mut Findings::default());
    let uncertainty = by_sensor(table, "uncertainty", sensors, findings);
    let rows: Vec<Option<Vec<Option<f64>>>> =
        tables.iter().map(|table| by_sensor(table, "readings", sensors, findings)).collect();
    let inside = tables.iter().find(|one| one.has("readings"));
    if let (true, Some(one)) = (table.has("readings"), inside) {
        return one.exclude("readings", "`readings` of [load_test]", findings);
    }
    let rows: Vec<Vec<Option<f64>>> = rows.into_iter().collect::<Option<_>>()?;
    let uncertainty = uncertainty?;
    if let Some(sensor) = uncertainty.iter().position(|value| value.is_some_and(|value| value <= 0.0)) {
        let message = format!("the uncertainty of {} is not above zero", sensors[sensor].name);
        let help = "write the standard deviation of one reading, a least count at least";
        findings.error("B682", table.place("uncertainty"), message, "a standard deviation", help);
    }
    let values = match inside {
        Some(_) => (0..sensors.len()).map(|sensor| rows.iter().map(|row| row[sensor]).collect()).collect(),
        None => Vec::new(),
    };
    Some((values, uncertainty))
}

/// Values that are written beside the names of sensors [SI], in their order.
fn by_sensor(table: &Table<'_>, key: &str, sensors: &[Sensor], findings: &mut Findings) -> Option<Vec<Option<f64>>> {
    let mut values = vec![None; sensors.len()];
    let Some((field, raw)) = table.entry(key) else { return Some(values) };
    let DeValue::Table(entries) = raw.get_ref() else { return wrong_type(field, raw, findings) };
    let mut whole = true;
    for (name, raw) in entries.iter() {
        let Some(k) = sensors.iter().position(|sensor| sensor.name == name.get_ref().trim()) else {
            let names = sensors.iter().map(|sensor| sensor.name.as_str());
            let near = crate::tree::nearest(name.get_ref(), names.clone());
            let near = near.map_or_else(String::new, |near| format!("did you mean \"{near}\"? "));
            let list = names.collect::<Vec<_>>().join(", ");
            let message = format!("there is no sensor \"{}\"", shorten(name.get_ref()));
            let range = name.span().into();
            findings.error("B682", range, message, "name of a [[sensor]]", format!("{near}the sensors are {list}"));
            whole = false;
            continue;
        };
        let dimension = measured(&sensors[k]);
        let quantity = raw.get_ref().as_str().and_then(|text| quantity::parse(text).ok());
        match quantity.filter(|one| one.unit.dimension == dimension && one.si().abs() <= dimension.most()) {
            Some(quantity) => values[k] = Some(quantity.si()),
            None => {
                let usual = dimension.units().map(|unit| unit.symbol).find(|symbol| *symbol != "m").unwrap_or("");
                let message = format!("this is no reading of {}", sensors[k].name);
                let help = format!("write {}, a number with its unit in quotes: \"… {usual}\"", dimension.name());
                findings.error("B682", raw.span().into(), message, field.doc, help);
                whole = false;
            }
        }
    }
    whole.then_some(values)
}
