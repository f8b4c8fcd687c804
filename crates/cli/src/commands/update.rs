//! `extrados update`: from the records of a train's passage to the moduli of a bridge; or the verdict on the records alone.

use super::source::Source;
use crate::args::Update as Arguments;
use crate::desk::Desk;
use crate::folder::{self, Folder};
use crate::log;
use crate::program;
use crate::report::Report;
use crate::results;
use crate::shelf::{FolderShelf, Resume};
use crate::status::Status;
use crate::summary;
use crate::watcher::watched;
use extrados::{Means, Refusal, UpdateOptions, written};
use outcome::update::{Update, UpdateStatus};
use serde_json::json;

/// Reads file and records, searches, writes what was found. Every evaluation is kept as soon as it is done.
pub(super) fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Refusal> {
    let source = Source::open(desk, &arguments.file)?;
    if source.bridge().is_none() {
        return Ok(source.report(Status::UnusableInput));
    }
    extrados::can_update(&source.project)?;
    let out = folder::named(&arguments.out, &arguments.file);
    let folder = source.folder(&out, if arguments.records_only { "update-records" } else { "update" })?;
    if arguments.records_only {
        return judged(desk, &source, &folder);
    }
    let shelf = FolderShelf::new(&folder, if arguments.resume { Resume::Asked } else { Resume::No });
    let clock = desk.clock;
    let means = Means { shelf: &shelf, clock: &|| clock.elapsed().as_secs_f64(), program: &program::hash() };
    let options = UpdateOptions { search: arguments.search, variant: arguments.variant, start: arguments.start };
    let project = &source.project;
    let found = watched(desk.screen.quiet, |spectator| extrados::update(project, &options, &means, spectator));
    let trouble = shelf.trouble();
    // What kept evaluations from being kept says more than the refusal.
    let found = found.map_err(|refusal| trouble.clone().unwrap_or(refusal))?;
    let mut report = source.report(Status::of(found.status.word()));
    if let Some(failure) = trouble {
        report.warn(&mut desk.screen, failure.code, &failure.message);
    }
    report.warn_of(&mut desk.screen, &found.warnings);
    doubts(desk, &found, &mut report);
    if found.status == UpdateStatus::Cancelled {
        let path = folder.file(log::NAME).display().to_string();
        let said = format!("interrupted; evaluations are kept in {path}\nthe same command with --resume goes on\n");
        return Ok(report.saying(said).with("log", path));
    }
    report.fields = found.object();
    report.fields.insert("evaluations_taken_up".to_owned(), json!(shelf.taken_up()));
    report.summary = summary::update(&found, &folder.path().display().to_string());
    results::publish(desk, report, &folder, written::update(&found))
}

/// The records alone, beside one passage of the start model. Exit code 1 where somebody should look at them.
fn judged(desk: &mut Desk, source: &Source, folder: &Folder) -> Result<Report, Refusal> {
    let clock = desk.clock;
    let means = Means { clock: &|| clock.elapsed().as_secs_f64(), ..Means::default() };
    let found = watched(desk.screen.quiet, |spectator| extrados::judge(&source.project, &means, spectator))?;
    if found.status == UpdateStatus::Cancelled {
        return Ok(source.report(Status::Cancelled).saying("interrupted; nothing was written\n"));
    }
    let status = if found.records.doubted() { Status::Inadequate } else { Status::Completed };
    let mut report = source.report(status);
    report.warn_of(&mut desk.screen, &found.warnings);
    doubts(desk, &found, &mut report);
    report.fields = found.object();
    report.summary = summary::records(&found, &folder.path().display().to_string());
    results::publish(desk, report, folder, written::update(&found))
}

/// Shows what a reader of the records should look at, each with its file, line and column.
fn doubts(desk: &mut Desk, found: &Update, report: &mut Report) {
    for (finding, file) in found.records.findings.iter().zip(&found.records.places) {
        if finding.severity > outcome::records::Severity::Note {
            report.warn_with(&mut desk.screen, written::finding_in_records(file, finding));
        }
    }
}
