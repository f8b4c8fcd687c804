//! A surveyed section of an intrados becomes a bridge file to fill in, a drawing or a table of its deviations.

use super::{Report, folder, guard};
use crate::args::Convert;
use crate::commands::source::read_file;
use crate::desk::Desk;
use crate::failure;
use crate::results;
use crate::status::Status;
use extrados::Refusal;
use extrados::files::LONGEST;
use findings::words::counted;
use outcome::section::{Face, Section, Surveyed};
use serde_json::{Value, json};
use std::fmt::Write;
use structure::section::{self, LengthUnit};

/// Points that are named in a message.
const NAMED: usize = 5;

/// Share of the curve's length without a point from which on it is told.
const GAP: f64 = 0.05;

/// Reads the section, fits its curve and writes what the extension `to` asks for.
pub(super) fn run(desk: &mut Desk, arguments: &Convert, to: &str) -> Result<Report, Refusal> {
    if arguments.chord_tolerance.is_some() || arguments.gap_tolerance.is_some() || arguments.cut_concave {
        let message = "--chord-tolerance, --gap-tolerance and --cut-concave are for drawings (.dxf)";
        return Err(Refusal::new("F107", message, "leave them out"));
    }
    let from = arguments.from.display().to_string();
    let unit = arguments.unit.as_deref().and_then(LengthUnit::named);
    let table = bridge::as_utf8(read_file(&arguments.from, LONGEST)?);
    let read = section::read(&String::from_utf8_lossy(&table), unit)
        .map_err(|error| refused(&from, &error, "extrados explain F133 tells what a section is"))?;
    let overruled = read.overruled.zip(unit).map(|(headed, unit)| {
        format!("the heading says {}, --unit says {}, which is taken: correct the heading", headed.symbol, unit.symbol)
    });
    fitted(desk, arguments, (&read.points, overruled), to)
}

/// The points of an open line, or single points, of a drawing as a section.
pub(super) fn traced(desk: &mut Desk, arguments: &Convert, points: &[[f64; 2]], to: &str) -> Result<Report, Refusal> {
    fitted(desk, arguments, (points, None), to)
}

/// The points of a section that was cut out of a cloud.
pub(super) fn cut(desk: &mut Desk, arguments: &Convert, points: &[[f64; 2]], to: &str) -> Result<Report, Refusal> {
    fitted(desk, arguments, (points, None), to)
}

fn refused(from: &str, error: &section::SectionError, help: &str) -> Refusal {
    Refusal::new("F133", format!("{from}: {error}"), help)
}

/// Fits the curve of a section [m] and writes what the extension `to` asks for; with it a doubt about its unit.
fn fitted(
    desk: &mut Desk,
    arguments: &Convert,
    (points, overruled): (&[[f64; 2]], Option<String>),
    to: &str,
) -> Result<Report, Refusal> {
    let from = arguments.from.display().to_string();
    let help = match super::ending(&arguments.from).as_str() {
        "dxf" => {
            "draw the intrados as one open line or as points, twelve or more, alone in its drawing; blocks are drawn as closed polylines"
        }
        "e57" | "las" | "laz" => {
            "keep to the intrados: --levels \"LOW,HIGH\" leaves out ground and road, and --line ends a little outside the springings"
        }
        _ => "extrados explain F133 tells what a section is",
    };
    let found = section::fit(points).map_err(|error| refused(&from, &error, help))?;
    let name = arguments.from.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let drawing = || figures::section_drawing(&name, &found);
    let bytes = match to {
        "toml" => section::span_file(&name, &found).into_bytes(),
        "svg" => drawing().into_bytes(),
        "png" => {
            figures::png(&drawing(), figures::PNG_WIDTH).map_err(|error| results::not_drawn(&arguments.to, &error))?
        }
        _ => section::deviations(&found).into_bytes(),
    };
    guard(arguments, &[&arguments.from])?;
    folder::write_whole(&arguments.to, &bytes).map_err(|error| failure::unwritable(&arguments.to, &error))?;
    let mut report = Report::new(Status::Completed);
    for doubt in overruled.into_iter().chain(doubts(&found)) {
        report.warn(&mut desk.screen, "F134", &doubt);
    }
    let shown = arguments.to.display().to_string();
    let summary = summary(&from, &found, &shown, to == "toml");
    Ok(fields(report, &found).with("written", shown).saying(summary))
}

fn fields(report: Report, found: &Section) -> Report {
    let point = |p: &Surveyed| json!({ "x_m": p.at[0], "y_m": p.at[1], "deviation_mm": 1e3 * p.deviation });
    let left_out: Vec<Value> = found.left_out().map(point).collect();
    let face =
        |f: &Face| json!({ "x_m": f.x, "foot_x_m": f.foot, "bottom_m": f.bottom, "top_m": f.top, "points": f.points });
    let faces: Vec<Value> = found.faces.iter().map(face).collect();
    report
        .with("points", found.points.len())
        .with("repeated", found.repeated)
        .with("abutment_faces", faces)
        .with("left_out", left_out)
        .with("span_m", found.span())
        .with("rise_m", found.rise())
        .with("scatter_mm", 1e3 * found.scatter)
        .with("noise_mm", 1e3 * found.noise)
        .with("terms", found.terms)
        .with("tilt_mm", 1e3 * found.tilt)
        .with("circle_radius_m", found.circle.radius)
        .with("circle_scatter_mm", 1e3 * found.circle.scatter)
}

fn summary(from: &str, found: &Section, shown: &str, is_file: bool) -> String {
    let mut page = format!("{from}: {} of an intrados\n\n", counted(found.points.len(), "point"));
    let _ = writeln!(page, "  span                  {:9.3} m", found.span());
    let _ = writeln!(page, "  rise                  {:9.3} m", found.rise());
    let _ = writeln!(
        page,
        "  scatter               {:9.1} mm   about a smooth curve of {}",
        1e3 * found.scatter,
        counted(found.terms, "term")
    );
    let _ = writeln!(
        page,
        "  circle                {:9.3} m    radius; points scatter by {:.1} mm about it",
        found.circle.radius,
        1e3 * found.circle.scatter
    );
    let _ = writeln!(page, "  left out              {:9}", found.left_out().count());
    if found.repeated > 0 {
        let _ = writeln!(page, "  repeated, counted once{:9}", found.repeated);
    }
    let _ = writeln!(page, "\nwritten to {shown}");
    if is_file {
        let _ = writeln!(page, "fill in the lines marked TO FILL IN, then: extrados check {shown}");
    }
    page
}

/// What somebody should look at before the curve is used.
fn doubts(found: &Section) -> Vec<String> {
    let mut doubts = Vec::new();
    let left_out: Vec<&Surveyed> = found.left_out().collect();
    if !left_out.is_empty() {
        let named: Vec<String> = left_out
            .iter()
            .take(NAMED)
            .map(|p| format!("x = {:.3} m ({:+.0} mm)", p.at[0], 1e3 * p.deviation))
            .collect();
        let more = if left_out.len() > NAMED { format!(" and {} more", left_out.len() - NAMED) } else { String::new() };
        let (lies, was) = if left_out.len() == 1 { ("lies", "was") } else { ("lie", "were") };
        doubts.push(format!(
            "{} {lies} too far from the curve and {was} left out: {}{more}",
            counted(left_out.len(), "point"),
            named.join(", ")
        ));
    }
    if !found.faces.is_empty() {
        let face = |f: &Face| {
            let points = counted(f.points, "point");
            // No zero with a sign.
            let [x, bottom, top] = [f.x, f.bottom, f.top].map(|value| 0.01 * (100.0 * value).round() + 0.0);
            format!("{points} at x = {x:.2} m between y = {bottom:.2} and {top:.2} m")
        };
        let faces: Vec<String> = found.faces.iter().map(face).collect();
        doubts.push(format!(
            "the section goes on down the faces of the abutments, which are no part of the arch and were left out: {}; look whether the \
             springings lie above them",
            faces.join("; ")
        ));
    }
    let ends = [found.points.first(), found.points.last()].into_iter().flatten();
    if ends.filter(|end| end.is_left_out).count() > 0 {
        doubts.push(
            "an outermost point was left out: the span ends at the next one; check that it is the springing".to_owned(),
        );
    }
    if found.has_steps() {
        doubts.push(format!(
            "points depart from the smooth curve by {:.1} mm where neighbours scatter by {:.1} mm: a kink (pointed crown), steps or slipped \
             stones are rounded off",
            1e3 * found.scatter,
            1e3 * found.noise
        ));
    }
    let length: f64 = found.drawn.windows(2).map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1])).sum();
    if found.gap.0 > GAP * length {
        let (gap, [from, to]) = found.gap;
        doubts.push(format!(
            "there is no point over {gap:.2} m between x = {from:.2} and {to:.2} m: the curve is a guess there"
        ));
    }
    if found.tilt.abs() > 1e-3 {
        doubts.push(format!(
            "the right end lies {:.0} mm {} the left one; the section was turned to be level",
            1e3 * found.tilt.abs(),
            if found.tilt > 0.0 { "above" } else { "below" }
        ));
    }
    doubts
}
