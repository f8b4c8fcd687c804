//! The train and the track under it.

use super::loading::slope_of;
use super::materials::maybe;
use super::structure::{exclude, need};
use crate::findings::Findings;
use crate::passage::Track;
use crate::train::{AxleLoads, LIBRARY, MOST_AXLES, Train, Vehicle, built_in, read_toml};
use crate::tree::Table;

/// The train: of the library, of a file that somebody else reads, or of vehicles written here.
pub(super) fn train(file: &Table<'_>, findings: &mut Findings) -> Option<Train> {
    let table = file.table("train", findings)?;
    let name = table.text("name", findings);
    let path = table.text("file", findings);
    let written = vehicles(&table, findings);
    if table.has("file") && table.has("vehicle") {
        exclude(&table, "file", "[[train.vehicle]]", findings);
        return None;
    }
    let named = maybe(&table, "name", name)?;
    if let Some(path) = maybe(&table, "file", path)? {
        let name = named.unwrap_or(path).to_owned();
        return Some(Train { name, file: Some(path.to_owned()), vehicles: Vec::new() });
    }
    if table.has("vehicle") {
        return Some(Train { name: named.unwrap_or("train").to_owned(), file: None, vehicles: written? });
    }
    let list = LIBRARY.iter().map(|train| format!("\"{}\"", train.name)).collect::<Vec<_>>().join(", ");
    let Some(named) = named else {
        need(&table, "name", findings);
        return None;
    };
    match built_in(named) {
        Some(found) => {
            let vehicles = read_toml(found.text.as_bytes()).vehicles?;
            Some(Train { name: found.name.to_owned(), file: None, vehicles })
        }
        None => {
            findings.error(
                "B651",
                table.place("name"),
                "the library has no such train, and there are no vehicles",
                "a train of the library, or one described here",
                format!("write one of {list}, or describe the train with [[train.vehicle]] or file = \"train.toml\""),
            );
            None
        }
    }
}

/// The vehicles of a train or of a file of vehicles.
pub(crate) fn vehicles(table: &Table<'_>, findings: &mut Findings) -> Option<Vec<Vehicle>> {
    let tables = table.tables("vehicle", findings);
    let list: Vec<Option<Vehicle>> = tables.iter().map(|table| vehicle(table, findings)).collect();
    let list: Vec<Vehicle> = list.into_iter().collect::<Option<_>>()?;
    let axles: usize = list.iter().map(|vehicle| vehicle.count.saturating_mul(vehicle.spacings.len() + 1)).sum();
    if axles > MOST_AXLES {
        findings.error(
            "B652",
            tables.first().map_or(table.range, |table| table.range),
            format!("the train has {axles} axles"),
            "the longest trains have some 3,000",
            format!("write a smaller `count`: {MOST_AXLES} axles at most"),
        );
        return None;
    }
    (!list.is_empty()).then_some(list)
}

fn vehicle(table: &Table<'_>, findings: &mut Findings) -> Option<Vehicle> {
    let name = table.text("name", findings);
    let count = table.count("count", findings);
    let masses = table.quantities("axle_loads", findings);
    let forces = table.quantities("axle_forces", findings);
    let spacings = table.quantities("axle_spacings", findings);
    let front = table.quantity("front_overhang", findings);
    let rear = table.quantity("rear_overhang", findings);
    let key = match (table.has("axle_loads"), table.has("axle_forces")) {
        (true, true) => {
            exclude(table, "axle_forces", "`axle_loads`", findings);
            return None;
        }
        (false, false) => {
            need(table, "axle_loads", findings);
            return None;
        }
        (true, false) => "axle_loads",
        (false, true) => "axle_forces",
    };
    let given = if key == "axle_loads" { masses? } else { forces? };
    let spacings = spacings?.value;
    let axles = spacings.len() + 1;
    let each = match given.value.len() {
        1 => vec![given.value[0]; axles],
        same if same == axles => given.value,
        other => {
            findings.error(
                "B652",
                given.range,
                format!("{other} loads for {axles} axles"),
                "one for each axle, or one for all",
                format!("give {axles} loads or one; there is one spacing between every two adjacent axles"),
            );
            return None;
        }
    };
    Some(Vehicle {
        name: maybe(table, "name", name)?.unwrap_or("vehicle").to_owned(),
        count: maybe(table, "count", count)?.map_or(1, |n| n as usize),
        loads: if key == "axle_loads" { AxleLoads::Masses(each) } else { AxleLoads::Forces(each) },
        spacings,
        overhangs: [front?.value, rear?.value],
    })
}

/// Rails, sleepers, ballast. `width` of the barrel [m].
pub(super) fn track(file: &Table<'_>, width: Option<f64>, findings: &mut Findings) -> Option<Track> {
    let table = file.table("track", findings)?;
    let mut quantity = |key| table.quantity(key, findings);
    let (rail, modulus) = (quantity("rail_bending_stiffness"), quantity("track_modulus"));
    let (spacing, breadth) = (quantity("sleeper_spacing"), quantity("sleeper_breadth"));
    let (length, depth) = (quantity("sleeper_length"), quantity("ballast_depth"));
    let (dead_load, effective) = (quantity("dead_load"), quantity("effective_width"));
    let slope = slope_of(&table, "ballast_slope", findings);
    if let (Some(effective), Some(width)) = (effective, width)
        && effective.value > width * (1.0 + 1e-12)
    {
        findings.error(
            "B303",
            effective.range,
            "the effective width of an axle is more than the width of the barrel",
            format!("the barrel is {width} m wide"),
            format!("write \"{width} m\" or less, or leave it out"),
        );
    }
    if let (Some(spacing), Some(breadth)) = (spacing, breadth)
        && breadth.value > spacing.value
    {
        findings.error(
            "B653",
            breadth.range,
            "sleepers are wider than the distance between them",
            format!("their middles are {} m apart", spacing.value),
            "check whether `sleeper_breadth` and `sleeper_spacing` are swapped",
        );
    }
    Some(Track {
        rail_bending_stiffness: rail?.value,
        track_modulus: modulus?.value,
        sleeper_spacing: spacing?.value,
        sleeper_breadth: breadth?.value,
        sleeper_length: length?.value,
        ballast_depth: depth?.value,
        ballast_slope: slope?.value,
        dead_load: dead_load?.value,
        effective_width: maybe(&table, "effective_width", effective)?,
    })
}
