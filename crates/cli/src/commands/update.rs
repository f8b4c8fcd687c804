//! `extrados update`: from the records of a train's passage to the moduli of a bridge; or the verdict on the records alone.

pub(super) mod log;

use super::{Desk, Source, read_file};
use crate::args::{Update as Arguments, UpdateSearch, UpdateStart, UpdateVariant};
use crate::failure::Failure;
use crate::folder::{self, Folder};
use crate::report::{self, Report};
use crate::results;
use crate::status::Status;
use crate::summary;
use assess::analysis::update::{self, Means, RecordFile, Task, Threads, Update, UpdateError, UpdateStatus};
use assess::wire;
use bridge::edit::Document;
use bridge::update::Plan;
use log::{Keeper, Onlooker};
use serde_json::json;
use std::path::Path;

/// Reads file and records, searches, writes what was found. Every evaluation is kept as soon as it is done.
pub fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Failure> {
    let source = Source::open(desk, &arguments.file)?;
    let Some(own) = source.read.bridge.clone() else { return Ok(source.report(Status::UnusableInput)) };
    let Some(mut asked) = source.read.update.clone() else {
        let message = format!("{} says nothing of what to seek", source.name);
        return Err(Failure::input("F130", message, "add [records] and [[parameter]] tables; extrados explain F130"));
    };
    chosen(&mut asked.plan, arguments);
    let document = document(&source)?;
    let files = records(&arguments.file, &asked.records.place)?;
    let out = arguments.out.clone().unwrap_or_else(|| folder::default_for(&arguments.file));
    let folder = source.folder(&out, if arguments.records_only { "update-records" } else { "update" })?;
    let task = Task { bridge: &own, document: &document, asked: &asked, files: &files };
    if arguments.records_only {
        return judged(desk, &source, &task, &folder);
    }
    let (known, mut keeper) = Keeper::open(&folder, &task.identity(), arguments.resume, desk.screen.quiet)?;
    let taken_up = known.len();
    let clock = desk.clock;
    let means = Means { map: &Threads, watch: &mut keeper, clock: &|| clock.seconds() };
    let found = update::update(&task, known, means);
    let trouble = keeper.finish();
    let found = found.map_err(|error| refused(&error))?;
    let mut report = source.report(Status::named(found.status.word()).unwrap_or(Status::NotConverged));
    if let Some(failure) = trouble {
        report.warn(&mut desk.screen, failure.code, &failure.message);
    }
    for warning in &found.warnings {
        report.warn(&mut desk.screen, warning.code, &warning.message);
    }
    doubts(desk, &found, &mut report);
    if found.status == UpdateStatus::Cancelled {
        let path = folder.file(log::NAME).display().to_string();
        let said = format!("interrupted; evaluations are kept in {path}\nthe same command with --resume goes on\n");
        return Ok(report.saying(said).with("log", path));
    }
    report.fields = report::fields_of(wire::UpdateObject::new(&found));
    report.fields.insert("evaluations_taken_up".to_owned(), json!(taken_up));
    report.summary = summary::update(&found, &folder.path().display().to_string());
    write(desk, &found, report, &folder)
}

/// The records alone, beside one passage of the start model. Exit code 1 where somebody should look at them.
fn judged(desk: &mut Desk, source: &Source, task: &Task<'_>, folder: &Folder) -> Result<Report, Failure> {
    let (clock, mut watch) = (desk.clock, Onlooker::new(desk.screen.quiet));
    let means = Means { map: &Threads, watch: &mut watch, clock: &|| clock.seconds() };
    let found = update::judge(task, means).map_err(|error| refused(&error))?;
    watch.finish();
    if found.status == UpdateStatus::Cancelled {
        return Ok(source.report(Status::Cancelled).saying("interrupted; nothing was written\n"));
    }
    let status = if found.records.doubted() { Status::Inadequate } else { Status::Completed };
    let mut report = source.report(status);
    for warning in &found.warnings {
        report.warn(&mut desk.screen, warning.code, &warning.message);
    }
    doubts(desk, &found, &mut report);
    report.fields = report::fields_of(wire::UpdateObject::new(&found));
    report.summary = summary::records(&found, &folder.path().display().to_string());
    write(desk, &found, report, folder)
}

/// Shows what a reader of the records should look at, each with its file, line and column.
fn doubts(desk: &mut Desk, found: &Update, report: &mut Report) {
    for (finding, file) in found.records.findings.iter().zip(&found.records.places) {
        if finding.severity > assess::records::Severity::Note {
            report.warn_at(&mut desk.screen, file, finding);
        }
    }
}

/// Sets what the command line says in place of the file.
fn chosen(plan: &mut Plan, arguments: &Arguments) {
    plan.search = match arguments.search {
        Some(UpdateSearch::Hierarchical) => "hierarchical",
        Some(UpdateSearch::Modern) => "modern",
        Some(UpdateSearch::Referee) => "referee",
        Some(UpdateSearch::Gradient) => "gradient",
        Some(UpdateSearch::All) => "all",
        None => plan.search,
    };
    plan.variant = match arguments.variant {
        Some(UpdateVariant::Printed) => "printed",
        Some(UpdateVariant::AsPractised) => "as-practised",
        Some(UpdateVariant::Both) => "both",
        None => plan.variant,
    };
    plan.start = match arguments.start {
        Some(UpdateStart::Stated) => "stated",
        Some(UpdateStart::Means) => "means",
        Some(UpdateStart::Bounds) => "bounds",
        Some(UpdateStart::All) => "all",
        None => plan.start,
    };
}

/// The file's text as a tree that can be edited, without what it says of updating.
pub(super) fn document(source: &Source) -> Result<Document, Failure> {
    let text = std::str::from_utf8(&source.text).unwrap_or_default();
    let mut document = Document::parse(text).ok_or_else(|| {
        Failure::input("F114", format!("{} cannot be edited", source.name), "check it with extrados check")
    })?;
    bridge::UPDATE_SECTIONS.iter().chain(&["vary"]).for_each(|section| document.remove(section));
    Ok(document)
}

/// The tables that the file names, beside it: one, or all of a folder in the order of their names.
pub(super) fn records(beside: &Path, place: &str) -> Result<Vec<RecordFile>, Failure> {
    let path = beside.parent().unwrap_or(Path::new("")).join(place);
    let mut paths = vec![path.clone()];
    if path.is_dir() {
        let entries = std::fs::read_dir(&path).map_err(|error| Failure::unreadable(&path, &error))?;
        paths = entries.flatten().map(|entry| entry.path()).collect();
        let table = |path: &std::path::PathBuf| {
            let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
            ending.is_some_and(|ending| ["csv", "txt", "tsv", "parquet"].contains(&ending.as_str()))
        };
        paths.retain(table);
        paths.sort();
    }
    if paths.is_empty() {
        let message = format!("the folder {} holds no table", path.display());
        return Err(Failure::input("F130", message, "put one table (.csv) for each run into it"));
    }
    let file = |path: &std::path::PathBuf| {
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        Ok(RecordFile { name, bytes: read_file(path)? })
    };
    paths.iter().map(file).collect()
}

fn refused(error: &UpdateError) -> Failure {
    match error {
        UpdateError::Analysis(error) => results::not_set_up(error),
        other => Failure::input("F130", other.to_string(), "extrados explain F130 tells what updating needs"),
    }
}

fn write(desk: &mut Desk, found: &Update, report: Report, folder: &Folder) -> Result<Report, Failure> {
    let tables = [
        ("histories", wire::histories_table(found)),
        ("sweeps", wire::sweeps_table(found)),
        ("samples", wire::samples_table(found)),
    ];
    let mut files = figures::update(found).map_err(|error| results::not_drawn(folder.path(), &error))?;
    files.extend(results::tables(tables));
    results::publish(desk, report, folder, &files)
}
