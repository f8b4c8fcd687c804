//! `extrados collapse`: the load, the thickness or the support movement that makes a mechanism.

use super::model;
use super::source::{Source, read_text};
use crate::args::Collapse as Arguments;
use crate::checkpoint::Checkpoint;
use crate::desk::Desk;
use crate::failure::Failure;
use crate::folder::{self, Folder};
use crate::report::Report;
use crate::results;
use crate::status::Status;
use crate::watcher::{Spectator, Watcher};
use crate::{quantities, summary};
use extrados::{Choice, CollapseOptions, SweepOptions, Swept, written};
use outcome::collapse::Collapse;
use outcome::sweep::Ended;
use outcome::sweep::Sweep;
use outcome::vehicles::VehicleSweep;
use std::time::Duration;

/// Reads the file, makes the analysis, writes its results.
pub(super) fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Failure> {
    desk.screen.details = arguments.details;
    if bridge::is_block_file(&read_text(&arguments.file)?) {
        return model::collapse(desk, arguments);
    }
    let source = Source::open(desk, &arguments.file)?;
    let Some(own) = source.bridge() else { return Ok(source.report(Status::UnusableInput)) };
    let choice = choice(own.width, arguments)?;
    let bridge = extrados::planned(&source.project, &choice)?;
    let out = arguments.out.clone().unwrap_or_else(|| folder::default_for(&arguments.file));
    let folder = source.folder(&out, &kind(&bridge.plan, arguments.sweep.then_some(bridge.sweep.is_some())))?;
    if arguments.sweep {
        return sweep(desk, arguments, &source, choice, &folder);
    }
    let run = |resume: Option<Vec<u8>>, watcher: &mut Watcher| {
        extrados::collapse(&source.project, &CollapseOptions { choice, resume }, watcher).map_err(Failure::from)
    };
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

/// What the command line says in place of the file's plan, for a bridge of this width [m].
pub(super) fn choice(width: f64, arguments: &Arguments) -> Result<Choice, Failure> {
    let other = arguments.choice.method.filter(|method| !extrados::sweeps(*method));
    if let (true, Some(method)) = (arguments.sweep, other) {
        let message = format!("--sweep is limit analysis: --method {} cannot do it", method.word());
        let way_out = "leave --method out, say --method limit, or --method path for deformable joints too";
        return Err(Failure::input("F107", message, way_out));
    }
    arguments.choice.of(width)
}

/// The analysis under a watcher, and its files; where it was interrupted, the report says so.
pub(super) fn analyse(
    desk: &mut Desk,
    arguments: &Arguments,
    mut report: Report,
    checkpoint: Checkpoint,
    folder: &Folder,
    run: impl FnOnce(Option<Vec<u8>>, &mut Watcher) -> Result<Collapse, Failure>,
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
    let found = run(resume, &mut watcher);
    let kept = watcher.has_kept();
    let trouble = watcher.finish();
    let found = found?;
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
    report.warn_of(&mut desk.screen, &written::warnings_of(found));
    report.fields.extend(found.object());
    let page = summary::collapse(found, &folder.path().display().to_string(), desk.screen.details);
    report.show(&desk.screen, &page);
    let mut files = results::files(folder, written::collapse(found, arguments.displacement_scale))?;
    let not_drawn = |error| results::not_drawn(folder.path(), &error);
    for (folder, one) in std::iter::once(("", found)).chain(found.wall_strip.iter().map(|wall| ("wall/", &**wall))) {
        let moving = figures::animation(&one.picture).map_err(not_drawn)?;
        files.extend(moving.map(|bytes| figures::File { name: format!("{folder}animation.png"), bytes }));
    }
    results::publish(desk, report, folder, &files)
}

/// The vehicles of the file's [sweep] moved over the bridge, or its loads where it has none.
fn sweep(
    desk: &mut Desk,
    arguments: &Arguments,
    source: &Source,
    choice: Choice,
    folder: &Folder,
) -> Result<Report, Failure> {
    let vehicles = source.bridge().is_some_and(|bridge| bridge.sweep.is_some());
    desk.schema = if vehicles { "extrados.vehicle-sweep/1" } else { "extrados.sweep/1" }.to_owned();
    let step = arguments.sweep_step.as_ref().map(|text| quantities::length("--sweep-step", text)).transpose()?;
    let mut spectator = Spectator::new(desk.screen.quiet);
    let found = extrados::sweep(&source.project, &SweepOptions { choice, step }, &mut spectator);
    spectator.finish();
    match found? {
        Swept::Vehicles(found) => vehicles_moved(desk, source, &found, folder),
        Swept::Loads(found) => loads_moved(desk, source, &found, folder),
    }
}

/// Writes a sweep of vehicles.
fn vehicles_moved(desk: &mut Desk, source: &Source, found: &VehicleSweep, folder: &Folder) -> Result<Report, Failure> {
    let mut report = source.report(ended(found.status()));
    report.warn_of(&mut desk.screen, &found.warnings);
    report.fields = found.object();
    report.show(&desk.screen, &summary::vehicles(found, &folder.path().display().to_string()));
    let mut files = results::files(folder, written::vehicles_moved(found))?;
    if let Some(collapse) = &found.collapse {
        let moving =
            figures::animation(&collapse.picture).map_err(|error| results::not_drawn(folder.path(), &error))?;
        files.extend(moving.map(|bytes| figures::File { name: "animation.png".to_owned(), bytes }));
    }
    results::publish(desk, report, folder, &files)
}

/// Writes a sweep of the file's loads.
fn loads_moved(desk: &mut Desk, source: &Source, found: &Sweep, folder: &Folder) -> Result<Report, Failure> {
    let mut report = source.report(ended(found.ended()));
    report.warn_of(&mut desk.screen, &found.warnings);
    let (name, width) = source.bridge().map_or(("", 1.0), |bridge| (bridge.name.as_str(), bridge.width));
    report.fields = found.object(name, width);
    report.show(&desk.screen, &summary::sweep(found, &folder.path().display().to_string()));
    let files = results::files(folder, written::loads_moved(name, found))?;
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
