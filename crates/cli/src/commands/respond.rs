//! `extrados respond`: displacements, strains and stresses as a train passes.

mod record;

use self::record::Recorder;
use super::source::Source;
use crate::args::Respond as Arguments;
use crate::desk::Desk;
use crate::failure::Failure;
use crate::folder::{self, Folder};
use crate::report::Report;
use crate::results;
use crate::status::Status;
use crate::watcher::Watcher;
use crate::{quantities, summary};
use extrados::{RespondOptions, written};
use outcome::passage::{Passage, PassageStatus};
use serde_json::json;

/// Reads the file, lets the train cross, writes the records.
pub(super) fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Failure> {
    let source = Source::open(desk, &arguments.file)?;
    if source.bridge().is_none() {
        return Ok(source.report(Status::UnusableInput));
    }
    let options = options(arguments)?;
    let recorder = Recorder::new(arguments)?;
    let out = arguments.out.clone().unwrap_or_else(|| folder::default_for(&arguments.file));
    let folder = source.folder(&out, "respond")?;
    let mut watcher = Watcher::without_checkpoint(desk.screen.quiet);
    let found = extrados::respond(&source.project, &options, &mut watcher);
    watcher.finish();
    let found = found?;
    let mut report = source.report(Status::named(found.status.word()).unwrap_or(Status::NotConverged));
    if found.status == PassageStatus::Cancelled {
        return Ok(report.saying("interrupted; nothing was written\n".to_owned()));
    }
    report.warn_of(&mut desk.screen, &found.warnings);
    report.fields = found.object();
    report.summary = summary::passage(&found, &folder.path().display().to_string());
    if let Some(recorder) = recorder {
        keep(&recorder, &found, &mut report)?;
    }
    write(desk, &found, report, &folder)
}

/// Writes the record of a train that has crossed; half a passage would pass for a whole one.
fn keep(recorder: &Recorder, found: &Passage, report: &mut Report) -> Result<(), Failure> {
    if found.status != PassageStatus::Completed {
        report.summary += "  no synthetic record was written: the train did not cross\n";
        return Ok(());
    }
    let written = recorder.write(found)?;
    report.summary += &written.words();
    let object = json!({ "file": written.path, "synthetic": written.label(), "samples": written.run.times.len() });
    report.fields.insert("records".to_owned(), object);
    Ok(())
}

/// What the command line says in place of the file.
fn options(arguments: &Arguments) -> Result<RespondOptions, Failure> {
    let speed = arguments.speed.as_ref().map(|text| quantities::speed("--speed", text));
    Ok(RespondOptions { speed: speed.transpose()?, analysis: arguments.analysis, path: arguments.path })
}

fn write(desk: &mut Desk, found: &Passage, report: Report, folder: &Folder) -> Result<Report, Failure> {
    results::publish(desk, report, folder, &results::files(folder, written::passage(found))?)
}
