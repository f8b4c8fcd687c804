//! `extrados collapse`: the load, the thickness or the support movement that makes a mechanism.

use super::{Desk, Source, model};
use crate::args::Collapse as Arguments;
use crate::checkpoint::Checkpoint;
use crate::failure::Failure;
use crate::folder::{self, Folder};
use crate::report::{self, Report};
use crate::results;
use crate::status::Status;
use crate::watcher::{Spectator, Watcher};
use crate::{quantities, summary};
use assess::analysis::vehicles::Ended;
use assess::analysis::{self, AnalysisError, Collapse, Places};
use assess::{warning, wire};
use bridge::Bridge;
use std::time::Duration;

/// Reads the file, makes the analysis, writes its results.
pub fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Failure> {
    if bridge::is_block_file(&super::read_text(&arguments.file)?) {
        return model::collapse(desk, arguments);
    }
    let source = Source::open(desk, &arguments.file)?;
    let Some(mut bridge) = source.read.bridge.clone() else { return Ok(source.report(Status::UnusableInput)) };
    let width = bridge.width;
    plan(&mut bridge.plan, width, arguments)?;
    let out = arguments.out.clone().unwrap_or_else(|| folder::default_for(&arguments.file));
    let folder = source.folder(&out, &kind(&bridge.plan, arguments.sweep.then_some(bridge.sweep.is_some())))?;
    if arguments.sweep && bridge.sweep.is_some() {
        return vehicles(desk, arguments, &source, &mut bridge, &folder);
    }
    if arguments.sweep {
        return sweep(desk, arguments, &source, &bridge, &folder);
    }
    let run = |resume: Option<&[u64]>, watcher: &mut Watcher| analysis::collapse(&bridge, resume, watcher);
    let checkpoint = Checkpoint::of(&bridge, &folder);
    let report = source.report(Status::Completed);
    analyse(desk, arguments, report, checkpoint, &folder, run)
}

/// Which run this is: an answer of another one is kept when this one's takes its place. A sweep is of vehicles or of loads.
pub(super) fn kind(plan: &bridge::Plan, sweep_of_vehicles: Option<bool>) -> String {
    let (analysis, method) = (&plan.analysis, &plan.method);
    match sweep_of_vehicles {
        Some(true) => "sweep-vehicles".to_owned(),
        Some(false) => "sweep-loads".to_owned(),
        None => format!("collapse-{analysis:?}-{method:?}").to_lowercase(),
    }
}

/// Sets what the command line says in place of the file.
pub(super) fn plan(plan: &mut bridge::Plan, width: f64, arguments: &Arguments) -> Result<(), Failure> {
    if arguments.sweep && arguments.choice.method == Some(crate::args::Method::Dem) {
        let message = "--sweep is limit analysis: --method dem cannot do it";
        return Err(Failure::input("F107", message, "leave --method out, or say --method limit"));
    }
    arguments.choice.apply(plan, width)
}

/// The analysis under a watcher, and its files; where it was interrupted, the report says so.
pub(super) fn analyse(
    desk: &mut Desk,
    arguments: &Arguments,
    mut report: Report,
    checkpoint: Checkpoint,
    folder: &Folder,
    run: impl FnOnce(Option<&[u64]>, &mut Watcher) -> Result<Collapse, AnalysisError>,
) -> Result<Report, Failure> {
    let resume = if arguments.resume { checkpoint.take_up()? } else { None };
    if let Some(words) = if arguments.resume { None } else { checkpoint.make_way()? } {
        report.warn(&mut desk.screen, "F110", &words);
    }
    if arguments.resume && resume.is_none() {
        let message = format!("there is no checkpoint in {}: the run starts anew", folder.path().display());
        report.warn(&mut desk.screen, "F110", &message);
    }
    let mut watcher =
        Watcher::new(desk.screen.quiet, checkpoint.clone(), Duration::from_secs_f64(arguments.keep_every));
    let found = run(resume.as_deref(), &mut watcher);
    let kept = watcher.has_kept();
    let trouble = watcher.finish();
    let found = found.map_err(|error| results::not_set_up(&error))?;
    if let Some(failure) = trouble {
        report.warn(&mut desk.screen, failure.code, &failure.message);
    }
    report.status = results::status(found.status);
    if report.status != Status::Cancelled {
        let report = write(desk, arguments, &found, report, folder)?;
        // Only now is there nothing more to lose.
        checkpoint.remove();
        return Ok(report);
    }
    let shown = checkpoint.path().display().to_string();
    report.summary = match kept {
        true => format!("interrupted; the run is kept in {shown}\ngo on with the same command and --resume\n"),
        false => "interrupted before there was anything to keep\n".to_owned(),
    };
    Ok(if kept { report.with("checkpoint", shown) } else { report })
}

fn write(
    desk: &mut Desk,
    arguments: &Arguments,
    found: &Collapse,
    mut report: Report,
    folder: &Folder,
) -> Result<Report, Failure> {
    for warning in &found.warnings {
        report.warn(&mut desk.screen, warning.code, &warning.message);
    }
    for warning in found.wall_strip.iter().flat_map(|wall| &wall.warnings) {
        // What is said of the other strip already need not be repeated.
        if !found.warnings.contains(warning) {
            let message = format!("strip of the walls: {}", warning.message);
            report.warn(&mut desk.screen, warning.code, &message);
        }
    }
    if let Some(words) = figures::left_out(&found.picture) {
        report.warn(&mut desk.screen, warning::NOT_DRAWN, &words);
    }
    report.fields.extend(report::fields_of(wire::CollapseObject::new(found, &wire::Run::default())));
    report.summary = summary::collapse(found, &folder.path().display().to_string());
    let mut files = figures::all(&found.picture).map_err(|error| results::not_drawn(folder.path(), &error))?;
    files.extend(figures::dxf::drawings(&found.picture, arguments.displacement_scale));
    files.extend(tables(found));
    if let Some(wall) = &found.wall_strip {
        let mut own = figures::all(&wall.picture).map_err(|error| results::not_drawn(folder.path(), &error))?;
        own.extend(figures::dxf::drawings(&wall.picture, arguments.displacement_scale));
        own.extend(tables(wall));
        files.extend(own.into_iter().map(|file| figures::File { name: format!("wall/{}", file.name), ..file }));
    }
    results::publish(desk, report, folder, &files)
}

/// Every table that has rows.
fn tables(found: &Collapse) -> Vec<figures::File> {
    let all = [
        ("path", wire::path(found)),
        ("hinges", wire::hinges(found)),
        ("thrust-line", wire::thrust_line(found)),
        ("blocks", wire::blocks(found)),
        ("contacts", wire::contacts(found)),
        ("particles", wire::particles(found)),
        ("particle-contacts", wire::particle_contacts(found)),
        ("packing", assess::packing_file::write(found)),
    ];
    let filled = all.into_iter().filter(|(_, text)| text.lines().nth(1).is_some());
    filled.map(|(name, text)| table(name, text)).collect()
}

/// Vehicles of the library or of files, moved over the bridge as [sweep] says.
fn vehicles(
    desk: &mut Desk,
    arguments: &Arguments,
    source: &Source,
    bridge: &mut Bridge,
    folder: &Folder,
) -> Result<Report, Failure> {
    desk.schema = "extrados.vehicle-sweep/1".to_owned();
    if let (Some(text), Some(plan)) = (&arguments.sweep_step, &mut bridge.sweep) {
        plan.step = Some(quantities::length("--sweep-step", text)?);
    }
    let mut spectator = Spectator::new(desk.screen.quiet);
    let found = analysis::vehicle_sweep(bridge, &mut spectator);
    spectator.finish();
    let found = found.map_err(|error| results::not_set_up(&error))?;
    let mut report = source.report(ended(found.status()));
    for warning in &found.warnings {
        report.warn(&mut desk.screen, warning.code, &warning.message);
    }
    report.fields = report::fields_of(wire::VehicleSweepObject::new(&found, &wire::Run::default()));
    report.summary = summary::vehicles(&found, &folder.path().display().to_string());
    let mut files = Vec::new();
    if let Some(collapse) = &found.collapse {
        files = figures::all(&collapse.picture).map_err(|error| results::not_drawn(folder.path(), &error))?;
    }
    for (name, svg) in figures::vehicles(&found) {
        files.extend(figures::both(name, &svg).map_err(|error| results::not_drawn(folder.path(), &error))?);
    }
    files.push(table("vehicles", wire::vehicles_table(&found)));
    files.push(table("sweep", wire::vehicle_envelope_table(&found)));
    files.push(table("sections", wire::vehicle_sections_table(&found)));
    results::publish(desk, report, folder, &files)
}

/// How a sweep ended, for the command.
fn ended(sweep: Ended) -> Status {
    match sweep {
        Ended::Completed => Status::Completed,
        Ended::Undetermined => Status::Undetermined,
        Ended::Cancelled => Status::Cancelled,
    }
}

fn table(name: &str, text: String) -> figures::File {
    figures::File { name: format!("{name}.csv"), bytes: text.into_bytes() }
}

fn sweep(
    desk: &mut Desk,
    arguments: &Arguments,
    source: &Source,
    bridge: &Bridge,
    folder: &Folder,
) -> Result<Report, Failure> {
    desk.schema = "extrados.sweep/1".to_owned();
    let span = assess::discretise::bridge_length(bridge);
    let step = match &arguments.sweep_step {
        Some(text) => quantities::length("--sweep-step", text)?,
        None => span / 100.0,
    };
    let mut spectator = Spectator::new(desk.screen.quiet);
    let found = analysis::sweep(bridge, Places::Every(step), true, &mut spectator);
    spectator.finish();
    let found = found.map_err(|error| results::not_set_up(&error))?;
    let mut report = source.report(ended(found.ended()));
    for warning in &found.warnings {
        report.warn(&mut desk.screen, warning.code, &warning.message);
    }
    let object = wire::SweepObject::new(&bridge.name, bridge.width, &found, &wire::Run::default());
    report.fields = report::fields_of(object);
    report.summary = summary::sweep(&found, &folder.path().display().to_string());
    let points = found.points.iter().map(|point| (point.position, point.load_factor.unwrap_or(f64::NAN))).collect();
    let curve = figures::Sweep { label: "load factor".to_owned(), points };
    let mut files = Vec::new();
    if let Some(svg) = figures::envelope(&bridge.name, figures::Quantity::Factor, &[curve], None) {
        files.extend(figures::both("envelope", &svg).map_err(|error| results::not_drawn(folder.path(), &error))?);
    }
    files.push(table("sweep", wire::sweep_table(&found)));
    results::publish(desk, report, folder, &files)
}
