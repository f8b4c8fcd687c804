//! A point cloud is cut along a line, and its section fitted like one that was surveyed.

use super::{Report, section};
use crate::args::Convert;
use crate::desk::Desk;
use crate::quantities;
use extrados::Refusal;
use scan::{CELL, Cut, Format, Slice};
use std::fmt::Write;
use std::fs::File;
use structure::section::LengthUnit;

/// Thickness of what is taken where nobody says [m]: two courses of bricks hold some of each.
const THICKNESS: f64 = 0.1;

/// Reads the cloud, cuts it and writes what the extension `to` asks for.
pub(super) fn run(desk: &mut Desk, arguments: &Convert, format: Format, to: &str) -> Result<Report, Refusal> {
    let from = arguments.from.display().to_string();
    if arguments.unit.is_some() && format == Format::E57 {
        return Err(Refusal::new("F107", "--unit: the coordinates of E57 are metres", "leave it out"));
    }
    let unit = arguments.unit.as_deref().and_then(LengthUnit::named).map_or(1.0, |unit| unit.size);
    let cut = arguments.line.as_deref().map(|line| asked(arguments, line, unit)).transpose()?;
    let file = File::open(&arguments.from).map_err(|error| Refusal::unreadable(&arguments.from, &error))?;
    let slice = scan::cut(file, format, unit, cut.as_ref()).map_err(|error| {
        let help = "export the cloud anew as E57, LAS or LAZ; extrados explain F138 tells what is read";
        Refusal::new("F138", format!("{from}: {error}"), help)
    })?;
    let Some(cut) = cut else {
        let message = format!("{from}: where the cloud is cut is not said; it has {}", told(&slice, unit));
        return Err(Refusal::new(
            "F138",
            message,
            "write --line \"X,Y,X,Y\": the ends of the section in plan, a little outside the springings",
        ));
    };
    if slice.taken == 0 {
        let message = format!(
            "{from}: no point lies within {:.0} mm of --line; it has {}",
            500.0 * cut.thickness,
            told(&slice, unit)
        );
        return Err(Refusal::new("F138", message, "correct --line or --levels, in the coordinates of the cloud"));
    }
    let note = format!(
        "{} of {} points of the cloud lie in the section and are taken as {} means over squares of {:.0} mm\n",
        slice.taken,
        slice.of,
        slice.points.len(),
        1e3 * CELL
    );
    let report = section::cut(desk, arguments, &slice.points, to)?;
    Ok(report.with("cloud_points", slice.of).with("cloud_points_taken", slice.taken).adding(&note))
}

/// Whether any of what only clouds take was said.
pub(super) fn is_asked(arguments: &Convert) -> bool {
    arguments.line.is_some() || arguments.slab.is_some() || arguments.levels.is_some()
}

/// The cut that was asked for [m], of coordinates that count `unit` metres.
fn asked(arguments: &Convert, line: &str, unit: f64) -> Result<Cut, Refusal> {
    let [x0, y0, x1, y1] = numbers("--line", line, "12.0, 4.0, 21.5, 4.2")?.map(|value| value * unit);
    if (x1 - x0).hypot(y1 - y0) < CELL {
        let message = format!("--line \"{line}\" ends where it begins");
        return Err(Refusal::new("F107", message, "write the x and y of the left end and then those of the right end"));
    }
    let thickness = match &arguments.slab {
        Some(text) => quantities::length("--slab", text)?,
        None => THICKNESS,
    };
    let levels = match &arguments.levels {
        Some(text) => numbers("--levels", text, "98.2, 101.5")?.map(|value| value * unit),
        None => [f64::NEG_INFINITY, f64::INFINITY],
    };
    Ok(Cut { ends: [[x0, y0], [x1, y1]], thickness, levels: [levels[0].min(levels[1]), levels[0].max(levels[1])] })
}

/// N numbers with commas or blanks between them, in the unit of the cloud.
fn numbers<const N: usize>(option: &str, text: &str, example: &str) -> Result<[f64; N], Refusal> {
    let words = text.split([',', ';', ' ']).map(str::trim).filter(|word| !word.is_empty());
    let found: Option<Vec<f64>> = words.map(|word| word.parse().ok().filter(|value: &f64| value.is_finite())).collect();
    found.and_then(|found| found.try_into().ok()).ok_or_else(|| {
        let message = format!("{option} \"{text}\" is not {N} numbers in the coordinates of the cloud");
        Refusal::new("F107", message, format!("write {option} \"{example}\", without units"))
    })
}

/// A cloud in words, in its own coordinates.
fn told(slice: &Slice, unit: f64) -> String {
    let mut words = format!("{} points", slice.of);
    for (axis, [low, high]) in ["x", "y", "z"].iter().zip(slice.extent) {
        let _ = write!(words, ", {axis} from {:.2} to {:.2}", low / unit, high / unit);
    }
    words
}
