//! `extrados respond`: displacements, strains and stresses as a train passes.

mod record;

use self::record::Recorder;
use super::source::Source;
use crate::args::Respond as Arguments;
use crate::desk::Desk;
use crate::folder;
use crate::report::Report;
use crate::results;
use crate::status::Status;
use crate::watcher::watched;
use crate::{quantities, summary};
use extrados::{Refusal, RespondOptions, written};
use outcome::passage::{Passage, PassageStatus};
use serde_json::json;

/// Reads the file, lets the train cross, writes the records.
pub(super) fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Refusal> {
    let source = Source::open(desk, &arguments.file)?;
    if source.bridge().is_none() {
        return Ok(source.report(Status::UnusableInput));
    }
    let options = options(arguments)?;
    let recorder = Recorder::new(arguments)?;
    let folder = source.folder(&folder::named(&arguments.out, &arguments.file), "respond")?;
    let found = watched(desk.screen.quiet, |spectator| extrados::respond(&source.project, &options, spectator))?;
    let mut report = source.report(Status::of(found.status.word()));
    if found.status == PassageStatus::Cancelled {
        return Ok(report.saying("interrupted; nothing was written\n".to_owned()));
    }
    report.warn_of(&mut desk.screen, &found.warnings);
    report.fields = found.object();
    report.summary = summary::passage(&found, &folder.path().display().to_string());
    if let Some(recorder) = recorder {
        keep(&recorder, &found, &mut report)?;
    }
    results::publish(desk, report, &folder, written::passage(&found))
}

/// Writes the record of a train that has crossed; half a passage would pass for a whole one.
fn keep(recorder: &Recorder, found: &Passage, report: &mut Report) -> Result<(), Refusal> {
    if found.times.is_empty() {
        report.summary += "  no synthetic record was written: nothing crosses; positions.csv has the values at rest\n";
        return Ok(());
    }
    if found.status != PassageStatus::Completed {
        report.summary += "  no synthetic record was written: the train did not cross\n";
        return Ok(());
    }
    let run = recorder.write(found)?;
    let (path, label) = (recorder.path.display().to_string(), run.synthetic.as_deref().unwrap_or_default());
    report.summary += &format!("synthetic record in {path}: {label}\n");
    let object = json!({ "file": path, "synthetic": label, "samples": run.times.len() });
    report.fields.insert("records".to_owned(), object);
    Ok(())
}

/// What the command line says in place of the file.
fn options(arguments: &Arguments) -> Result<RespondOptions, Refusal> {
    let speed = arguments.speed.as_ref().map(|text| quantities::speed("--speed", text));
    Ok(RespondOptions { speed: speed.transpose()?, analysis: arguments.analysis, path: arguments.path })
}
