//! `extrados vary`: an analysis over ranges of the file's quantities.

mod list;
mod requests;

use super::answer::refused;
use super::source::Source;
use crate::args::Vary as Arguments;
use crate::desk::Desk;
use crate::failure;
use crate::folder::Folder;
use crate::program;
use crate::report::Report;
use crate::results;
use crate::shards;
use crate::shelf::{self, FolderShelf, Resume};
use crate::signs;
use crate::status::Status;
use crate::summary;
use crate::watcher::watched;
use extrados::shard::Shard;
use extrados::{Means, Portion, Refusal, Studied, VaryOptions, VaryPlan, written};
use outcome::study::Study;
use serde_json::json;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Reads the file, checks every run, makes those that were not made yet, writes the study.
pub(super) fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Refusal> {
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
    let shard = arguments.sharing.shard;
    let out = arguments.out.clone().unwrap_or_else(|| shards::folder_of(default_folder(&arguments.file), shard));
    let kind = format!("vary-{}{}", plan.analysis().command, if arguments.grid { "-grid" } else { "" });
    let folder = source.folder(&out, &shards::kind(&kind, shard))?;
    let shelf = FolderShelf::new(&folder, Resume::No);
    let cache = shelf.runs();
    let kept = format!("finished runs are kept in {}\nthe same command takes them up by itself", cache.display());
    signs::keeps("cache", &cache, kept);
    let own = plan.own();
    let clock = desk.clock;
    let means = Means { shelf: &shelf, clock: &|| clock.elapsed().as_secs_f64(), program: &program::hash() };
    if let Some(merged) = &arguments.sharing.merged {
        match plan.identity(&means) {
            Ok(identity) => merged.bring(&identity, &folder)?,
            Err(refusals) => return Ok(refused(desk, report, refusals)),
        }
    }
    if let Some(shard) = shard {
        return match watched(desk.screen.quiet, |spectator| plan.share(shard, &means, spectator)) {
            Ok(found) => share(desk, report, shard, found, &folder),
            Err(refusals) => Ok(refused(desk, report, refusals)),
        };
    }
    let found = match watched(desk.screen.quiet, |spectator| plan.run(&means, spectator)) {
        Ok(found) => found,
        Err(mut refusals) if refusals.len() == 1 && ALONE.contains(&refusals[0].code) => {
            return Err(refusals.remove(0));
        }
        Err(refusals) => return Ok(refused(desk, report, refusals)),
    };
    if let Some(error) = &found.trouble {
        let failure = failure::not_written(&cache, error);
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

/// An interrupted command: what is finished is kept, and the same command goes on with the rest.
fn interrupted(mut report: Report, found: &Studied, cache: &Path) -> Report {
    report.status = Status::Cancelled;
    let (shown, finished, runs) = (cache.display().to_string(), found.finished, found.runs);
    report.summary = format!(
        "interrupted; {finished} of {runs} runs are kept in {shown}\ngo on with the same command: it takes them up by itself\n"
    );
    report.with("runs_finished", finished).with("runs", runs).with("cache", shown)
}

/// A shard: its runs are its results.
fn share(
    desk: &mut Desk,
    mut report: Report,
    shard: Shard,
    found: Portion,
    folder: &Folder,
) -> Result<Report, Refusal> {
    if let Some(error) = &found.trouble {
        return Err(failure::not_written(&folder.file("cache"), error));
    }
    if !found.finished {
        report.status = Status::Cancelled;
        return Ok(report.saying(shards::INTERRUPTED));
    }
    report.fields.insert("runs_from_cache".to_owned(), json!(found.taken_up));
    let files = found.kept.iter().map(|name| shelf::file(name)).collect();
    shards::publish(desk, report, folder, shard, found.identity, (BTreeMap::new(), files))
}

fn write(desk: &mut Desk, mut report: Report, study: &Study, folder: &Folder) -> Result<Report, Refusal> {
    if study.rows.iter().all(|row| study.number(row).is_none()) {
        report.status = Status::Undetermined;
    }
    let settings = std::mem::replace(&mut report.fields, study.object());
    report.fields.extend(settings);
    written::warnings_of_study(study).into_iter().for_each(|warning| report.warn_with(&mut desk.screen, warning));
    report.summary = summary::vary(study, &folder.path().display().to_string());
    results::publish(desk, report, folder, written::study(study))
}
