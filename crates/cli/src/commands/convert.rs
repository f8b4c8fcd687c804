//! `extrados convert`: bridge files, block model files, drawings and ParaView files, by extension.

mod checker;
mod cloud;
mod road;
mod section;
mod table;

use super::model::Model;
use super::source::{Source, read_file, read_text};
use crate::args::Convert;
use crate::desk::Desk;
use crate::failure;
use crate::folder;
use crate::quantities;
use crate::render::{self, Paint};
use crate::report::Report;
use crate::status::Status;
use assess::analysis::AnalysisError;
use drawing::{Drawing, Item, Options, Sheet};
use extrados::Refusal;
use extrados::files::LONGEST_DRAWING;
use findings::words::counted;
use outcome::picture::{Motion, Picture, Shape, Snapshot};
use std::f64::consts::TAU;
use std::path::Path;
use structure::blocks::{Scene, of_bridge, skeleton, toml};

/// What was read: a model that can be analysed, or the bare geometry of a drawing.
enum Content {
    Model(Box<Scene>),
    Drawing(Drawing),
}

/// Reads FROM and writes TO.
pub(super) fn run(desk: &mut Desk, arguments: &Convert) -> Result<Report, Refusal> {
    let (from, to) = (ending(&arguments.from), ending(&arguments.to));
    if matches!((from.as_str(), to.as_str()), ("xml" | "landxml", "toml")) {
        return road::run(desk, arguments);
    }
    if arguments.station.is_some() || arguments.springing_level.is_some() || arguments.profile.is_some() {
        let message = "--station, --springing-level and --profile are for road profiles (LandXML, .xml)";
        return Err(Refusal::new("F107", message, "leave them out"));
    }
    if let Some(format) = scan::Format::of_ending(&from) {
        return match to.as_str() {
            "toml" | "svg" | "png" | "csv" => cloud::run(desk, arguments, format, &to),
            _ => Err(no_pair(&from, &to)),
        };
    }
    if cloud::is_asked(arguments) {
        let message = "--line, --slab and --levels are for point clouds (.e57, .las, .laz)";
        return Err(Refusal::new("F107", message, "leave them out"));
    }
    if matches!((from.as_str(), to.as_str()), ("csv" | "txt" | "tsv" | "xy", "toml" | "svg" | "png" | "csv")) {
        return match table::read(&arguments.from)? {
            Some(text) => table::run(desk, arguments, &text, &to),
            None => section::run(desk, arguments, &to),
        };
    }
    if from == "dxf"
        && matches!(to.as_str(), "toml" | "svg" | "png" | "csv")
        && let Some(points) = traced(desk, arguments)?
    {
        return section::traced(desk, arguments, &points, &to);
    }
    if from == "toml" && matches!(to.as_str(), "py" | "csv") {
        return checker::run(desk, arguments, &to);
    }
    if !matches!((from.as_str(), to.as_str()), ("toml" | "dxf", "toml" | "dxf" | "vtu")) {
        return Err(no_pair(&from, &to));
    }
    let (report, content, inputs) = match from.as_str() {
        "dxf" => read_drawing(desk, arguments)?,
        _ => read_model(desk, arguments)?,
    };
    let Some(content) = content else { return Ok(report) };
    let name = arguments.from.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let bytes = match (&content, to.as_str()) {
        (Content::Model(scene), "toml") => toml(scene).into_bytes(),
        (Content::Drawing(drawing), "toml") => skeleton(&name, drawing).into_bytes(),
        (_, "dxf") => sheet(&content).dxf(),
        _ => vtu(&name, &content).unwrap_or_default().into_bytes(),
    };
    let inputs: Vec<&Path> = inputs.iter().map(AsRef::as_ref).collect();
    guard(arguments, &inputs)?;
    folder::write_whole(&arguments.to, &bytes).map_err(|error| failure::unwritable(&arguments.to, &error))?;
    let (blocks, particles) = match &content {
        Content::Model(scene) => (scene.bodies.len(), scene.particles.len()),
        Content::Drawing(drawing) => (drawing.outlines.len(), drawing.circles.len()),
    };
    let shown = arguments.to.display().to_string();
    let written = [counted(blocks, "block"), counted(particles, "particle")].join(", ");
    let mut summary = format!("{}: {written} written to {shown}\n", arguments.from.display());
    if matches!((&content, to.as_str()), (Content::Drawing(_), "toml")) {
        summary += "fill in the lines marked TO FILL IN, then: extrados check ";
        summary += &shown;
        summary.push('\n');
    }
    Ok(report.with("blocks", blocks).with("particles", particles).with("written", shown).saying(summary))
}

/// What a file's name ends in, in small letters.
fn ending(path: &Path) -> String {
    path.extension().map_or_else(String::new, |ending| ending.to_string_lossy().to_lowercase())
}

fn no_pair(from: &str, to: &str) -> Refusal {
    let shown =
        |ending: &str| if ending.is_empty() { "a file without extension".to_owned() } else { format!(".{ending}") };
    let message = format!("there is no conversion from {} to {}", shown(from), shown(to));
    Refusal::new(
        "F118",
        message,
        "convert .toml to .dxf, .vtu, .toml, .py (OpenSees) or .csv, .dxf to .toml, .vtu or .dxf, a section's .csv or a point cloud (.e57, .las, .laz) to .toml, .svg, .png or .csv, or a table of \
         numbers (.txt, .csv) or a road profile (LandXML, .xml) to .toml",
    )
}

/// How a bridge is cut into blocks.
type Cut<'a> = dyn Fn(&bridge::Bridge) -> Result<structure::discretise::Discretised, AnalysisError> + 'a;

type ReadIn = (Report, Option<Content>, Vec<std::path::PathBuf>);

fn read_model(desk: &mut Desk, arguments: &Convert) -> Result<ReadIn, Refusal> {
    read_model_by(desk, arguments, &|bridge| Ok(structure::discretise::discretise(bridge)?))
}

/// The same, with a bridge cut into blocks as is wanted.
fn read_model_by(desk: &mut Desk, arguments: &Convert, cut: &Cut<'_>) -> Result<ReadIn, Refusal> {
    let of_drawing = arguments.unit.is_some()
        || arguments.chord_tolerance.is_some()
        || arguments.gap_tolerance.is_some()
        || arguments.cut_concave;
    if of_drawing {
        let message = "--unit, --chord-tolerance, --gap-tolerance and --cut-concave are for drawings (.dxf)";
        return Err(Refusal::new("F107", message, "write them into [drawing] of the block model file"));
    }
    let mut inputs = vec![arguments.from.clone()];
    if bridge::is_block_file(&read_text(&arguments.from)?) {
        let model = Model::open(desk, &arguments.from)?;
        inputs.extend(model.0.drawing().map(|(place, _)| place.to_owned()));
        let scene = model.0.scene().cloned();
        let status = if scene.is_some() { Status::Completed } else { Status::UnusableInput };
        return Ok((model.report(status), scene.map(|scene| Content::Model(Box::new(scene))), inputs));
    }
    let source = Source::open(desk, &arguments.from)?;
    let Some(bridge) = source.bridge() else { return Ok((source.report(Status::UnusableInput), None, inputs)) };
    let scene = Box::new(of_bridge(bridge, &cut(bridge)?));
    Ok((source.report(Status::Completed), Some(Content::Model(scene)), inputs))
}

/// How a drawing is to be read.
fn options(arguments: &Convert) -> Result<Options, Refusal> {
    let length = |option: &str, text: &Option<String>, default: f64| match text {
        Some(text) => quantities::length(option, text),
        None => Ok(default),
    };
    let default = Options::default();
    let metres = |symbol: &str| bridge::quantity::UNITS.iter().find(|unit| unit.symbol == symbol).map(|unit| unit.size);
    Ok(Options {
        unit: arguments.unit.as_deref().and_then(metres),
        chord_tolerance: length("--chord-tolerance", &arguments.chord_tolerance, default.chord_tolerance)?,
        gap_tolerance: length("--gap-tolerance", &arguments.gap_tolerance, default.gap_tolerance)?,
        concave: if arguments.cut_concave { drawing::Concave::Cut } else { drawing::Concave::Refuse },
        ignored: Vec::new(),
    })
}

/// Points of the one line, or the single points, that a drawing has where it has no blocks.
fn traced(desk: &mut Desk, arguments: &Convert) -> Result<Option<Vec<[f64; 2]>>, Refusal> {
    // One that cannot be read is told of by the reader of drawings.
    let Ok(bytes) = read_file(&arguments.from, LONGEST_DRAWING) else { return Ok(None) };
    let Some(trace) = drawing::trace(&bytes, &options(arguments)?) else { return Ok(None) };
    let is_usable = trace.findings.iter().all(|finding| finding.severity != drawing::Severity::Error);
    if is_usable && !desk.screen.quiet {
        let name = arguments.from.display().to_string();
        desk.screen.remark(&render::drawing(&name, &trace.findings, &Paint::for_stderr()));
    }
    // What keeps it from being read is told by the reader of drawings.
    Ok(is_usable.then_some(trace.points))
}

fn read_drawing(desk: &mut Desk, arguments: &Convert) -> Result<ReadIn, Refusal> {
    let bytes = read_file(&arguments.from, LONGEST_DRAWING)?;
    let options = options(arguments)?;
    let read = drawing::read(&bytes, &options);
    let name = arguments.from.display().to_string();
    let usable = read.is_usable();
    if !usable || !desk.screen.quiet {
        desk.screen.remark(&render::drawing(&name, &read.findings, &Paint::for_stderr()));
    }
    let mut report = Report::new(if usable { Status::Completed } else { Status::UnusableInput });
    report.add_drawing(&name, &read.findings);
    Ok((report, usable.then_some(Content::Drawing(read.drawing)), vec![arguments.from.clone()]))
}

/// Refuses to replace an input, and any other file unless it was asked for.
fn guard(arguments: &Convert, inputs: &[&Path]) -> Result<(), Refusal> {
    guard_at(&arguments.to, arguments, inputs)
}

/// The same of a file at another place.
fn guard_at(to: &Path, arguments: &Convert, inputs: &[&Path]) -> Result<(), Refusal> {
    let Ok(target) = to.canonicalize() else { return Ok(()) };
    let shown = to.display();
    if inputs.iter().any(|input| input.canonicalize().is_ok_and(|input| input == target)) {
        let message = format!("{shown} is an input of this conversion");
        return Err(Refusal::new("F119", message, "write to another file"));
    }
    if !arguments.overwrite {
        let help = "name another file, or add --overwrite to replace it";
        return Err(Refusal::new("F119", format!("{shown} exists"), help));
    }
    Ok(())
}

/// The bodies on their layers.
fn sheet(content: &Content) -> Sheet {
    let mut sheet = Sheet::default();
    let mut put = |layer: &str, item: Item| {
        // Black, green, cyan, magenta, red, yellow, blue and grey in turn.
        let colours = [7, 3, 4, 6, 1, 2, 5, 8];
        let colour = colours[sheet.layers.len() % colours.len()];
        sheet.layer(layer, colour);
        sheet.items.push(item);
    };
    let line =
        |layer: &str, points: &[[f64; 2]]| Item::Line { layer: layer.into(), points: points.into(), closed: true };
    let circle = |layer: &str, centre, radius| Item::Circle { layer: layer.into(), centre, radius };
    match content {
        Content::Model(scene) => {
            scene.bodies.iter().for_each(|body| put(&body.layer, line(&body.layer, &body.outline)));
            scene.particles.iter().for_each(|p| put(&p.layer, circle(&p.layer, p.centre, p.radius)));
        }
        Content::Drawing(drawing) => {
            drawing.outlines.iter().for_each(|o| put(&o.layer, line(&o.layer, &o.points)));
            drawing.circles.iter().for_each(|c| put(&c.layer, circle(&c.layer, c.centre, c.radius)));
        }
    }
    sheet
}

/// Corners of the polygon that stands for a circle in ParaView files.
const ROUND: usize = 32;

/// The bodies as a ParaView file, circles as polygons.
fn vtu(name: &str, content: &Content) -> Option<String> {
    let round = |centre: [f64; 2], radius: f64| {
        let corner = |k: usize| {
            let (s, c) = (TAU * k as f64 / ROUND as f64).sin_cos();
            [centre[0] + radius * c, centre[1] + radius * s]
        };
        Shape { outline: (0..ROUND).map(corner).collect(), role: "particle".into(), held: false }
    };
    let shapes: Vec<Shape> = match content {
        Content::Model(scene) => {
            let bodies = assess::analysis::blocks_as_built(scene).shapes.into_iter();
            bodies.chain(scene.particles.iter().map(|p| round(p.centre, p.radius))).collect()
        }
        Content::Drawing(drawing) => {
            let block = |o: &drawing::Outline| Shape { outline: o.points.clone(), role: "block".into(), held: false };
            let outlines = drawing.outlines.iter().map(block);
            outlines.chain(drawing.circles.iter().map(|c| round(c.centre, c.radius))).collect()
        }
    };
    let at_rest = Snapshot { motions: vec![Motion::default(); shapes.len()], ..Snapshot::default() };
    let picture = Picture { title: name.to_owned(), shapes, snapshots: vec![at_rest], ..Picture::default() };
    figures::vtk::blocks(&picture, 0)
}
