//! Trains, and the track under them.

use crate::card::Section;
use crate::cards::*;
use crate::findings::Findings;
use crate::passage::Track;
use crate::train::{AxleLoads, LIBRARY, MOST_AXLES, Train, Vehicle, built_in, read_toml};
use crate::tree::{At, Table};
use findings::words::counted;

pub(crate) static VEHICLE: Section = Section {
    path: "train.vehicle",
    doc: "A vehicle of the train, or several equal ones; the first one leads, and the train travels to the right. Give \
          `axle_loads` or `axle_forces`.",
    fields: &[
        text("name", "name of the vehicle", "locomotive").optional("vehicle"),
        count("count", "how many of them follow one another", "2").between(1.0, 1000.0).default("1"),
        masses("axle_loads", "mass on each axle, from the first one back; a single value is for all", r#"["20.5 t"]"#)
            .positive_up_to(1e6)
            .optional("given by `axle_forces`"),
        forces(
            "axle_forces",
            "force of each axle, from the first one back; a single value is for all",
            r#"["250 kN"]"#,
        )
        .positive_up_to(1e7)
        .optional("given by `axle_loads`"),
        lengths(
            "axle_spacings",
            "distances between the axles, one fewer than the axles",
            r#"["2.0 m", "4.524 m", "2.0 m"]"#,
        )
        .positive(),
        length("front_overhang", "from the front coupler to the first axle", "1.0945 m").at_least(0.0),
        length("rear_overhang", "from the last axle to the rear coupler", "1.0945 m").at_least(0.0),
    ],
};

pub(super) static TRAIN: Section = Section {
    path: "train",
    doc: "The train that crosses in `extrados respond`, travelling to the right: one of the library by its `name`, \
          vehicles from a `file`, or vehicles written here as [[train.vehicle]].",
    fields: &[
        text(
            "name",
            "a train of the library (paper-short, paper-full, paper-short-light), or a name for the train",
            "paper-short",
        )
        .optional("named after its file, or \"train\""),
        text(
            "file",
            "a file beside this one: TOML with [[vehicle]] tables, or CSV with axle_load_t,distance_m",
            "train.toml",
        )
        .optional("the library's, or [[train.vehicle]]"),
        tables("vehicle", &VEHICLE, "The vehicles, from the first one back.")
            .optional("the library's, or those of the file"),
    ],
};

/// A file of vehicles.
pub(crate) static FILE: Section = Section {
    path: "",
    doc: "The vehicles of a train, from the first one back.",
    fields: &[tables("vehicle", &VEHICLE, "The vehicles, from the first one back.")],
};

pub(super) static TRACK: Section = Section {
    path: "track",
    doc: "How an axle load reaches the fill: half of it bears on each rail, a beam on the springs under its sleepers; \
          each sleeper's share spreads through the ballast and presses on the top of the fill.",
    fields: Track::CARDS,
};

/// The train: of the library, of a file that somebody else reads, or of vehicles written here.
pub(crate) fn train(file: &Table<'_>, findings: &mut Findings) -> Option<Train> {
    let table = file.table("train", findings)?;
    let name: Option<Option<String>> = table.read("name", findings);
    let path: Option<Option<String>> = table.read("file", findings);
    let written = vehicles(&table, findings);
    if table.has("file") && table.has("vehicle") {
        return table.exclude("file", "[[train.vehicle]]", findings);
    }
    let named = name?;
    if let Some(path) = path? {
        return Some(Train { name: named.unwrap_or_else(|| path.clone()), file: Some(path), vehicles: Vec::new() });
    }
    if table.has("vehicle") {
        return Some(Train { name: named.unwrap_or_else(|| "train".to_owned()), file: None, vehicles: written? });
    }
    let list = LIBRARY.iter().map(|train| format!("\"{}\"", train.name)).collect::<Vec<_>>().join(", ");
    let Some(named) = named else { return table.need("name", findings) };
    match built_in(&named) {
        Some(found) => {
            let vehicles = read_toml(found.text.as_bytes()).vehicles?;
            Some(Train { name: found.name.to_owned(), file: None, vehicles })
        }
        None => findings.refuse(
            "B651",
            table.place("name"),
            "the library has no such train, and there are no vehicles",
            "a train of the library, or one described here",
            format!("write one of {list}, or describe the train with [[train.vehicle]] or file = \"train.toml\""),
        ),
    }
}

/// The vehicles of a train or of a file of vehicles.
pub(crate) fn vehicles(table: &Table<'_>, findings: &mut Findings) -> Option<Vec<Vehicle>> {
    let tables = table.tables("vehicle", findings);
    let list: Vec<Option<Vehicle>> = tables.iter().map(|table| vehicle(table, findings)).collect();
    let list: Vec<Vehicle> = list.into_iter().collect::<Option<_>>()?;
    let axles: usize = list.iter().map(|vehicle| vehicle.count.saturating_mul(vehicle.spacings.len() + 1)).sum();
    if axles > MOST_AXLES {
        return findings.refuse(
            "B652",
            tables.first().map_or(table.range, |table| table.range),
            format!("the train has {axles} axles"),
            "the longest trains have some 3,000",
            format!("write a smaller `count`: {MOST_AXLES} axles at most"),
        );
    }
    (!list.is_empty()).then_some(list)
}

fn vehicle(table: &Table<'_>, findings: &mut Findings) -> Option<Vehicle> {
    let name: Option<Option<String>> = table.read("name", findings);
    let count = table.read("count", findings);
    let axles = axles(table, findings);
    let overhangs = ["front_overhang", "rear_overhang"].map(|key| table.read::<f64>(key, findings));
    let (loads, spacings) = axles?;
    Some(Vehicle {
        name: name?.unwrap_or_else(|| "vehicle".to_owned()),
        count: count?,
        loads,
        spacings,
        overhangs: [overhangs[0]?, overhangs[1]?],
    })
}

/// What axles bring, and the distances between them.
pub(super) fn axles(table: &Table<'_>, findings: &mut Findings) -> Option<(AxleLoads, Vec<f64>)> {
    let masses: Option<Option<At<Vec<f64>>>> = table.read("axle_loads", findings);
    let forces: Option<Option<At<Vec<f64>>>> = table.read("axle_forces", findings);
    let spacings: Option<Vec<f64>> = table.read("axle_spacings", findings);
    let (loads, given): (fn(Vec<f64>) -> AxleLoads, _) = match (table.has("axle_loads"), table.has("axle_forces")) {
        (true, true) => return table.exclude("axle_forces", "`axle_loads`", findings),
        (false, false) => return table.need("axle_loads", findings),
        (true, false) => (AxleLoads::Masses, masses??),
        (false, true) => (AxleLoads::Forces, forces??),
    };
    let spacings = spacings?;
    let axles = spacings.len() + 1;
    let each = match given.value.len() {
        1 => vec![given.value[0]; axles],
        same if same == axles => given.value,
        other => {
            return findings.refuse(
                "B652",
                given.range,
                format!("{} for {}", counted(other, "load"), counted(axles, "axle")),
                "one for each axle, or one for all",
                format!("give {axles} loads or one; there is one spacing between every two adjacent axles"),
            );
        }
    };
    Some((loads(each), spacings))
}

/// Refuses a width that carries an axle and is more than that of the barrel [m].
pub(super) fn within(table: &Table<'_>, effective: Option<f64>, width: Option<f64>, findings: &mut Findings) {
    if let (Some(effective), Some(width)) = (effective, width)
        && effective > width * (1.0 + 1e-12)
    {
        findings.error(
            "B303",
            table.place("effective_width"),
            "the effective width of an axle is more than the width of the barrel",
            format!("the barrel is {width} m wide"),
            format!("write \"{width} m\" or less, or leave it out"),
        );
    }
}

/// Rails, sleepers, ballast. `width` of the barrel [m].
pub(crate) fn track(file: &Table<'_>, width: Option<f64>, findings: &mut Findings) -> Option<Track> {
    let table = &file.table("track", findings)?;
    let track = Track::of(table, findings)?;
    within(table, track.effective_width, width, findings);
    if track.sleeper_breadth > track.sleeper_spacing {
        findings.error(
            "B653",
            table.place("sleeper_breadth"),
            "sleepers are wider than the distance between them",
            format!("their middles are {} m apart", track.sleeper_spacing),
            "check whether `sleeper_breadth` and `sleeper_spacing` are swapped",
        );
    }
    Some(track)
}
