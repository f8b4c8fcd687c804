//! `extrados collapse`: the load, the thickness or the support movement that makes a mechanism.

use super::model;
use super::source::{Source, read_text};
use crate::args::Collapse as Arguments;
use crate::checkpoint::Checkpoint;
use crate::desk::Desk;
use crate::folder::{self, Folder};
use crate::report::Report;
use crate::results;
use crate::status::Status;
use crate::watcher::{Watcher, watched};
use crate::{quantities, summary};
use extrados::{Choice, CollapseOptions, Refusal, SweepOptions, Swept, written};
use outcome::collapse::Collapse;
use outcome::picture::Picture;
use outcome::sweep::Sweep;
use outcome::vehicles::VehicleSweep;
use std::time::Duration;

/// Reads the file, makes the analysis, writes its results.
pub(super) fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Refusal> {
    desk.screen.details = arguments.details;
    if bridge::is_block_file(&read_text(&arguments.file)?) {
        return model::collapse(desk, arguments);
    }
    let source = Source::open(desk, &arguments.file)?;
    let Some(own) = source.bridge() else { return Ok(source.report(Status::UnusableInput)) };
    let choice = choice(own.width, arguments)?;
    let bridge = extrados::planned(&source.project, &choice)?;
    let out = folder::named(&arguments.out, &arguments.file);
    let sweeps = arguments.sweep || plans_vehicles_alone(&bridge);
    let folder = source.folder(&out, &kind(&bridge.plan, sweeps.then_some(bridge.sweep.is_some())))?;
    if sweeps {
        return sweep(desk, arguments, &source, choice, &folder);
    }
    let run = |resume: Option<Vec<u8>>, watcher: &mut Watcher<'_>| {
        extrados::collapse(&source.project, &CollapseOptions { choice, resume }, watcher)
    };
    let checkpoint = Checkpoint::of(&bridge, &folder);
    let report = source.report(Status::Completed);
    analyse(desk, arguments, report, checkpoint, &folder, run)
}

/// Whether vehicles are all that a file has to bring its bridge to collapse, by a method that moves them.
fn plans_vehicles_alone(bridge: &bridge::Bridge) -> bool {
    let plan = &bridge.plan;
    plan.analysis == bridge::Analysis::Load
        && bridge.loads.is_empty()
        && bridge.sweep.is_some()
        && extrados::sweeps(plan.method)
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
pub(super) fn choice(width: f64, arguments: &Arguments) -> Result<Choice, Refusal> {
    let other = arguments.choice.method.filter(|method| !extrados::sweeps(*method));
    if let (true, Some(method)) = (arguments.sweep, other) {
        let message = format!("--sweep is limit analysis: --method {} cannot do it", method.word());
        let way_out = "leave --method out, say --method limit, or --method path for deformable joints too";
        return Err(Refusal::new("F107", message, way_out));
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
    run: impl FnOnce(Option<Vec<u8>>, &mut Watcher<'_>) -> Result<Collapse, Refusal>,
) -> Result<Report, Refusal> {
    let resume = if arguments.resume { checkpoint.take_up()? } else { None };
    if let Some(words) = if arguments.resume { None } else { checkpoint.make_way()? } {
        report.warn(&mut desk.screen, "F110", &words);
    }
    if arguments.resume && resume.is_none() {
        let message = format!("there is no checkpoint in {}: the run starts anew", folder.path().display());
        report.warn(&mut desk.screen, "F110", &message);
    }
    let keep_every = Duration::from_secs_f64(arguments.keep_every);
    let (found, kept, trouble) = watched(desk.screen.quiet, |spectator| {
        let checkpoint = &checkpoint;
        let mut watcher = Watcher { spectator, checkpoint, keep_every, kept: None, trouble: None };
        (run(resume, &mut watcher), watcher.kept.is_some(), watcher.trouble)
    });
    let found = found?;
    if let Some(failure) = trouble {
        report.warn(&mut desk.screen, failure.code, &failure.message);
    }
    report.status = Status::of(found.status.word());
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
) -> Result<Report, Refusal> {
    report.warn_of(&mut desk.screen, &written::warnings_of(found));
    report.fields.extend(found.object());
    let page = summary::collapse(found, &folder.path().display().to_string(), desk.screen.details);
    report.show(&desk.screen, &page);
    let mut written = written::collapse(found, arguments.displacement_scale);
    for (below, one) in std::iter::once(("", found)).chain(found.wall_strip.iter().map(|wall| ("wall/", &**wall))) {
        written.files.extend(animation(folder, below, &one.picture)?);
    }
    results::publish(desk, report, folder, written)
}

/// The run of a picture as it moves, as a file of this folder below that of the results.
fn animation(folder: &Folder, below: &str, picture: &Picture) -> Result<Option<figures::File>, Refusal> {
    let moving = figures::animation(picture).map_err(|error| results::not_drawn(folder.path(), &error))?;
    Ok(moving.map(|bytes| figures::File { name: format!("{below}animation.png"), bytes }))
}

/// The vehicles of the file's [sweep] moved over the bridge, or its loads where it has none.
fn sweep(
    desk: &mut Desk,
    arguments: &Arguments,
    source: &Source,
    choice: Choice,
    folder: &Folder,
) -> Result<Report, Refusal> {
    let vehicles = source.bridge().is_some_and(|bridge| bridge.sweep.is_some());
    desk.schema = if vehicles { "extrados.vehicle-sweep/1" } else { "extrados.sweep/1" }.to_owned();
    let step = arguments.sweep_step.as_ref().map(|text| quantities::length("--sweep-step", text)).transpose()?;
    let options = SweepOptions { choice, step };
    match watched(desk.screen.quiet, |spectator| extrados::sweep(&source.project, &options, spectator))? {
        Swept::Vehicles(found) => vehicles_moved(desk, source, &found, folder),
        Swept::Loads(found) => loads_moved(desk, source, &found, folder),
    }
}

/// Writes a sweep of vehicles.
fn vehicles_moved(desk: &mut Desk, source: &Source, found: &VehicleSweep, folder: &Folder) -> Result<Report, Refusal> {
    let mut report = source.report(Status::of(found.status().word()));
    report.warn_of(&mut desk.screen, &found.warnings);
    report.fields = found.object();
    report.show(&desk.screen, &summary::vehicles(found, &folder.path().display().to_string()));
    let mut written = written::vehicles_moved(found);
    if let Some(collapse) = &found.collapse {
        written.files.extend(animation(folder, "", &collapse.picture)?);
    }
    results::publish(desk, report, folder, written)
}

/// Writes a sweep of the file's loads.
fn loads_moved(desk: &mut Desk, source: &Source, found: &Sweep, folder: &Folder) -> Result<Report, Refusal> {
    let mut report = source.report(Status::of(found.ended().word()));
    report.warn_of(&mut desk.screen, &found.warnings);
    let (name, width) = source.bridge().map_or(("", 1.0), |bridge| (bridge.name.as_str(), bridge.width));
    report.fields = found.object(name, width);
    report.show(&desk.screen, &summary::sweep(found, &folder.path().display().to_string()));
    results::publish(desk, report, folder, written::loads_moved(name, found))
}
