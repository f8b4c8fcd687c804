//! `extrados assess`: the whole chain against the file's limits, with a report; on a folder, for every bridge file in it.

mod fleet;
mod pdf;

use super::source::Source;
use crate::args::Assess as Arguments;
use crate::desk::Desk;
use crate::folder::{self, Folder};
use crate::program;
use crate::report::Report;
use crate::results;
use crate::shelf::{FolderShelf, Resume};
use crate::signs;
use crate::status::Status;
use crate::summary;
use crate::watcher::{silent, watched};
use extrados::{AssessOptions, Assessed, Disk, Files, Means, Refusal, WholeDisk};
use std::time::{Instant, SystemTime, UNIX_EPOCH};

/// One bridge, or a folder of them.
pub(super) fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Refusal> {
    desk.screen.details = arguments.details;
    if arguments.file.is_dir() {
        return fleet::run(desk, arguments);
    }
    if arguments.sharing.shard.is_some() {
        let message = format!("{} is one bridge, and no work that can be cut into shards", arguments.file.display());
        return Err(Refusal::new("F146", message, "leave --shard away, or name a folder of bridge files"));
    }
    let source = Source::open_from(desk, &arguments.file, pictures(arguments))?;
    if source.bridge().is_none() {
        return Ok(source.report(Status::UnusableInput));
    }
    let folder = source.folder(&folder::named(&arguments.out, &arguments.file), "assess")?;
    let program = program::hash();
    signs::keeps("out", folder.path(), KEPT);
    let Some(done) = assessed(&source, &folder, &program, arguments, desk.screen.quiet)? else {
        return Ok(source.report(Status::Cancelled).saying(format!("interrupted; {KEPT}\n")));
    };
    let mut report = answer(&done, &source);
    report.warn_of(&mut desk.screen, &done.warnings());
    for [code, message] in pictures_left_out(&done) {
        report.warn(&mut desk.screen, &code, &message);
    }
    let mut written = extrados::written::assessed(&done);
    let mut named = "report.html".to_owned();
    match arguments.pdf.then(|| pdf::pdf(&done, &folder)) {
        None => {}
        Some(Ok(file)) => {
            named += ", report.pdf";
            written.files.push(file);
        }
        Some(Err([code, message])) => {
            named = format!("{message}\n{named}");
            report.warn(&mut desk.screen, &code, &message);
        }
    }
    let place = format!("{named}, checks.csv and result.json are in {}", folder.path().display());
    let page = summary::assessment(&done.assessment, place, desk.screen.details);
    report.show(&desk.screen, &page);
    results::publish(desk, report, &folder, written)
}

/// Photographs that the report does not show, and why.
fn pictures_left_out(done: &Assessed) -> Vec<[String; 2]> {
    let why = |one: &::report::Photograph| {
        one.source.as_ref().err().map(|why| format!("{} is not in the report: {why}", one.file))
    };
    done.photographs.iter().filter_map(why).map(|message| ["F147".to_owned(), message]).collect()
}

/// What stays of an assessment that is interrupted.
const KEPT: &str = "finished stages are kept, and the same command takes them up";

/// The answer for scripts.
pub(super) fn answer(done: &Assessed, source: &Source) -> Report {
    let mut report = source.report(Status::of(done.assessment.verdict.status.word()));
    report.finished = done.assessment.verdict.finished;
    report.fields = done.object();
    report.with("stages", done.stages()).with("input_hash", done.appendix.input.as_str())
}

/// Where pictures of a report may come from: the folder of the bridge file and those below, or wherever the file says.
fn pictures(arguments: &Arguments) -> &'static dyn Files {
    if arguments.allow_outside { &WholeDisk } else { &Disk }
}

/// Makes the chain of one bridge; none where somebody asked to stop.
fn assessed(
    source: &Source,
    folder: &Folder,
    program: &str,
    arguments: &Arguments,
    quiet: bool,
) -> Result<Option<Assessed>, Refusal> {
    let shelf = FolderShelf::new(folder, Resume::WherePossible);
    let options = AssessOptions {
        skip: arguments.skip.clone(),
        command: command(arguments, source.project.name()),
        day: today(),
    };
    let clock = Instant::now();
    let means = Means { shelf: &shelf, clock: &|| clock.elapsed().as_secs_f64(), program };
    let project = &source.project;
    Ok(match quiet {
        true => extrados::assess(project, &options, &means, &mut silent)?,
        false => watched(false, |spectator| extrados::assess(project, &options, &means, spectator))?,
    })
}

/// The command that makes this bridge's report by itself.
fn command(arguments: &Arguments, file: &str) -> String {
    let skipped: String = arguments.skip.iter().map(|stage| format!(" --skip {stage}")).collect();
    let outside = if arguments.allow_outside { " --allow-outside" } else { "" };
    format!("extrados assess {file}{skipped}{outside}")
}

/// Today in universal time, as year-month-day; the rule for civil days is Hinnant's.
fn today() -> String {
    let days = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs() / 86_400) as i64;
    let [year, month, day] = civil(days);
    format!("{year:04}-{month:02}-{day:02}")
}

/// Year, month and day of a day counted from 1970-01-01.
fn civil(days: i64) -> [i64; 3] {
    let z = days + 719_468;
    let era = z.div_euclid(146_097);
    let day_of_era = z.rem_euclid(146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * shifted + 2) / 5 + 1;
    let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
    [year_of_era + era * 400 + i64::from(month <= 2), month, day]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_are_counted_as_calendars_do() {
        assert_eq!(civil(0), [1970, 1, 1]);
        assert_eq!(civil(59), [1970, 3, 1]);
        assert_eq!(civil(11_016), [2000, 2, 29]);
        assert_eq!(civil(20_778), [2026, 11, 21]);
    }
}
