//! `extrados vary`: an analysis over ranges of the file's quantities.

mod list;
mod requests;

use super::{Desk, Source};
use crate::args::Vary as Arguments;
use crate::failure::Failure;
use crate::folder::Folder;
use crate::program;
use crate::render::{self, Paint};
use crate::report::Report;
use crate::results;
use crate::shelf::{FolderShelf, Resume};
use crate::signs;
use crate::status::Status;
use crate::summary;
use crate::watcher::Spectator;
use extrados::{Means, Refusal, Studied, VaryOptions, VaryPlan, written};
use outcome::published;
use outcome::study::Study;
use serde_json::json;
use std::path::{Path, PathBuf};

/// Reads the file, checks every run, makes those that were not made yet, writes the study.
pub fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Failure> {
    let mut options = VaryOptions {
        sweep: arguments.sweep,
        grid: arguments.grid,
        outcome: arguments.outcome.clone(),
        most_runs: arguments.most_runs as usize,
        choice: arguments.choice.of(1.0)?,
    };
    options.analysis()?;
    let source = Source::open(desk, &arguments.file)?;
    let Some(own) = source.bridge() else { return Ok(source.report(Status::UnusableInput)) };
    options.choice = arguments.choice.of(own.width)?;
    if arguments.list {
        return list::list(&source);
    }
    let mut report = source.report(Status::Completed);
    let requests = match requests::gather(desk, arguments, &source, &mut report)? {
        Ok(requests) => requests,
        Err(refusals) => return Ok(refused(desk, report, refusals)),
    };
    let plan = match VaryPlan::new(&source.project, &requests, &options) {
        Ok(plan) => plan,
        Err(refusals) => return Ok(refused(desk, report, refusals)),
    };
    let out = arguments.out.clone().unwrap_or_else(|| default_folder(&arguments.file));
    let kind = format!("vary-{}{}", plan.analysis().command, if arguments.grid { "-grid" } else { "" });
    let folder = source.folder(&out, &kind)?;
    let shelf = FolderShelf::new(&folder, Resume::No);
    let cache = shelf.runs();
    let kept = format!("finished runs are kept in {}\nthe same command takes them up by itself", cache.display());
    signs::keeps("cache", &cache, kept);
    let own = plan.own();
    let mut spectator = Spectator::new(desk.screen.quiet);
    let means = Means { shelf: &shelf, clock: &desk.clock, program: &program::hash() };
    let found = plan.run(&means, &mut spectator);
    spectator.finish();
    let found = match found {
        Ok(found) => found,
        Err(mut refusals) if refusals.len() == 1 && ALONE.contains(&refusals[0].code) => {
            return Err(refusals.remove(0).into());
        }
        Err(refusals) => return Ok(refused(desk, report, refusals)),
    };
    if let Some(error) = &found.trouble {
        let failure = Failure::not_written(&cache, error);
        report.warn(&mut desk.screen, failure.code, &failure.message);
    }
    match found.study {
        Some(study) => {
            report.fields.insert("tolerance".to_owned(), json!(own.plan.tolerance));
            report.fields.insert("seed".to_owned(), json!(own.plan.seed));
            write(desk, report, &study, &folder)
        }
        None => Ok(interrupted(report, &found, &cache)),
    }
}

/// Refusals of the whole command, and not of one of its values.
const ALONE: [&str; 3] = ["F108", "F115", "F117"];

/// out/NAME-vary beside the current folder, so that an answer of `collapse` stays.
fn default_folder(file: &Path) -> PathBuf {
    let mut name = file.file_stem().unwrap_or(file.as_os_str()).to_os_string();
    name.push("-vary");
    Path::new("out").join(name)
}

/// Everything that is wrong, shown and listed.
fn refused(desk: &mut Desk, mut report: Report, refusals: Vec<Refusal>) -> Report {
    report.status = Status::UnusableInput;
    for failure in refusals.into_iter().map(Failure::from) {
        desk.screen.remark(&render::failure(&failure, &Paint::for_stderr()));
        report.errors.push(json!({ "code": failure.code, "message": failure.message, "help": failure.help }));
    }
    report
}

/// An interrupted command: what is finished is kept, and the same command goes on with the rest.
fn interrupted(mut report: Report, found: &Studied, cache: &Path) -> Report {
    report.status = Status::Cancelled;
    let (shown, finished, runs) = (cache.display().to_string(), found.finished, found.runs);
    report.summary = format!(
        "interrupted; {finished} of {runs} runs are kept in {shown}\ngo on with the same command: it takes them up by itself\n"
    );
    report.with("runs_finished", finished).with("runs", runs).with("cache", shown)
}

fn write(desk: &mut Desk, mut report: Report, study: &Study, folder: &Folder) -> Result<Report, Failure> {
    if study.rows.iter().all(|row| study.number(row).is_none()) {
        report.status = Status::Undetermined;
    }
    let settings = std::mem::replace(&mut report.fields, published::vary(study));
    report.fields.extend(settings);
    report.summary = summary::vary(study, &folder.path().display().to_string());
    let files = results::files(folder, written::study(study))?;
    results::publish(desk, report, folder, &files)
}
