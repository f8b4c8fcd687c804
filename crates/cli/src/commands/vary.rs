//! `extrados vary`: an analysis over ranges of the file's quantities.

mod list;
mod requests;
mod task;
mod work;

use super::{Desk, Source};
use crate::args::Vary as Arguments;
use crate::cache::Cache;
use crate::failure::Failure;
use crate::folder::Folder;
use crate::render::{self, Paint};
use crate::report::{self, Report};
use crate::results;
use crate::signs;
use crate::status::Status;
use crate::summary;
use assess::vary::{self, Analysis, Study};
use assess::wire;
use bridge::Bridge;
use serde_json::json;
use std::path::{Path, PathBuf};
use task::Task;
use work::{Finished, Work};

/// Why there is nothing to start: everything that is wrong.
type Refusals = Vec<Failure>;

/// Reads the file, checks every run, makes those that were not made yet, writes the study.
pub fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Failure> {
    let analysis = analysis(arguments)?;
    let source = Source::open(desk, &arguments.file)?;
    let Some(own) = source.read.bridge.clone() else { return Ok(source.report(Status::UnusableInput)) };
    let document = requests::document(&source)?;
    if arguments.list {
        return Ok(list::list(&source, &document));
    }
    let mut report = source.report(Status::Completed);
    let varied = match requests::gather(desk, arguments, &source, &document, &mut report)? {
        Ok(varied) => varied,
        Err(refusals) => return Ok(refused(desk, report, &refusals)),
    };
    let plan =
        task::Plan { source: &source, own: &own, document: &document, choice: &arguments.choice, grid: arguments.grid };
    if let Err(refusals) = plan.check(&varied) {
        return Ok(refused(desk, report, &refusals));
    }
    let out = arguments.out.clone().unwrap_or_else(|| default_folder(&arguments.file));
    let folder =
        source.folder(&out, &format!("vary-{}{}", analysis.name, if arguments.grid { "-grid" } else { "" }))?;
    let cache = Cache::in_folder(folder.path());
    let kept =
        format!("finished runs are kept in {}\nthe same command takes them up by itself", cache.path().display());
    signs::keeps("cache", cache.path(), kept);
    let work = Work { analysis: &analysis, cache: &cache, quiet: desk.screen.quiet };
    let count = vary::count(plan.design(), &varied.iter().map(|one| one.values.len()).collect::<Vec<_>>());
    if let Some(runs) = too_many(count, arguments.most_runs) {
        return too_many_runs(&plan, &work, runs, arguments.most_runs);
    }
    let task = match plan.task(varied, &analysis, &cache) {
        Ok(task) => task,
        Err(refusals) => return Ok(refused(desk, report, &refusals)),
    };
    let found = work.all(&task)?;
    if let Some(error) = &found.trouble {
        let failure = Failure::not_written(cache.path(), error);
        report.warn(&mut desk.screen, failure.code, &failure.message);
    }
    match found.rows {
        Some(rows) => {
            let own = plan.chosen(own.clone())?;
            report.fields.insert("tolerance".to_owned(), json!(own.plan.tolerance));
            report.fields.insert("seed".to_owned(), json!(own.plan.seed));
            write(desk, report, arguments, &analysis, study(&own, &analysis, plan.design(), task, rows), &folder)
        }
        None => Ok(interrupted(report, found.finished, found.runs, &cache)),
    }
}

/// What is repeated: a sweep where it is asked for, or where only a sweep finds the number that is.
fn analysis(arguments: &Arguments) -> Result<Analysis, Failure> {
    let asked = arguments
        .outcome
        .as_deref()
        .is_some_and(|name| vary::OF_SWEEPS.contains(&name) || name.starts_with(vary::OF_SWEEPS[0]));
    let sweeps = arguments.sweep || asked;
    if sweeps && arguments.choice.method.is_some_and(|method| method != crate::args::Method::Limit) {
        let message = "a sweep is limit analysis: no other --method can make it";
        return Err(Failure::input("F107", message, "leave --method out, or say --method limit"));
    }
    Ok(if sweeps { vary::SWEEP } else { vary::COLLAPSE })
}

/// out/NAME-vary beside the current folder, so that an answer of `collapse` stays.
fn default_folder(file: &Path) -> PathBuf {
    let mut name = file.file_stem().unwrap_or(file.as_os_str()).to_os_string();
    name.push("-vary");
    Path::new("out").join(name)
}

/// Everything that is wrong, shown and listed.
fn refused(desk: &mut Desk, mut report: Report, refusals: &[Failure]) -> Report {
    report.status = Status::UnusableInput;
    for failure in refusals {
        desk.screen.remark(&render::failure(failure, &Paint::for_stderr()));
        report.errors.push(json!({ "code": failure.code, "message": failure.message, "help": failure.help }));
    }
    report
}

/// The number of runs where it is more than allowed; the largest number where it cannot be counted.
fn too_many(count: Option<usize>, most: u32) -> Option<usize> {
    let count = count.unwrap_or(usize::MAX);
    (count > most as usize).then_some(count)
}

/// Refuses a number of runs, with the time they would take going by the bridge as its file has it.
fn too_many_runs(plan: &task::Plan, work: &Work, runs: usize, most: u32) -> Result<Report, Failure> {
    let task = plan.own_task(work.analysis, work.cache)?;
    let seconds = work.all(&task)?.rows.and_then(|rows| rows.first().map(|row| row.seconds));
    let threads = rayon::current_num_threads();
    let time = seconds.map_or(String::new(), |seconds| {
        let all = seconds * runs as f64 / threads as f64;
        format!(": at {} each, some {} on {threads} thread{}", duration(seconds), duration(all), plural(threads))
    });
    let message = format!("{runs} runs are more than {most}{time}");
    let help = match runs <= 100_000 {
        true => format!("--most-runs {runs} allows them; fewer values, or no --grid, need less"),
        false => "give fewer values, or leave --grid away: more than 100000 runs are never started".to_owned(),
    };
    Err(Failure::input("F115", message, help))
}

fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

/// A time in the unit that people would use.
fn duration(seconds: f64) -> String {
    match seconds {
        _ if seconds < 1.0 => format!("{:.0} ms", (1e3 * seconds).max(1.0)),
        _ if seconds < 120.0 => format!("{seconds:.1} s"),
        _ if seconds < 7200.0 => format!("{:.0} min", seconds / 60.0),
        _ if seconds < 172_800.0 => format!("{:.1} h", seconds / 3600.0),
        _ => format!("{:.0} days", seconds / 86_400.0),
    }
}

fn study(own: &Bridge, analysis: &Analysis, design: vary::Design, task: Task, finished: Vec<Finished>) -> Study {
    let rows = task.runs.iter().zip(&task.new_warnings).zip(finished);
    let rows = rows.map(|((run, new), mut found)| {
        found.outcome.warnings.extend(new.iter().map(|code| (*code).to_owned()));
        vary::Row { run: run.clone(), outcome: found.outcome, seconds: found.seconds, cached: found.cached }
    });
    Study {
        bridge: own.name.clone(),
        command: analysis.name,
        analysis: own.plan.analysis,
        method: own.plan.method,
        design,
        outcome: String::new(),
        resolution: 0.0,
        rows: rows.collect(),
        quantities: task.varied,
    }
}

/// An interrupted command: what is finished is kept, and the same command goes on with the rest.
fn interrupted(mut report: Report, finished: usize, runs: usize, cache: &Cache) -> Report {
    report.status = Status::Cancelled;
    let shown = cache.path().display().to_string();
    report.summary = format!(
        "interrupted; {finished} of {runs} runs are kept in {shown}\ngo on with the same command: it takes them up by itself\n"
    );
    report.with("runs_finished", finished).with("runs", runs).with("cache", shown)
}

fn write(
    desk: &mut Desk,
    mut report: Report,
    arguments: &Arguments,
    analysis: &Analysis,
    mut study: Study,
    folder: &Folder,
) -> Result<Report, Failure> {
    study.outcome = outcome(arguments, analysis, &study)?;
    study.resolution = vary::resolution(analysis, &study);
    if study.rows.iter().all(|row| study.number(row).is_none()) {
        report.status = Status::Undetermined;
    }
    let settings = std::mem::replace(&mut report.fields, report::fields_of(wire::VaryObject::new(&study)));
    report.fields.extend(settings);
    report.summary = summary::vary(&study, &folder.path().display().to_string());
    let mut files = figures::study(&study).map_err(|error| results::not_drawn(folder.path(), &error))?;
    files.push(figures::File { name: "vary.csv".to_owned(), bytes: wire::vary_table(&study).into_bytes() });
    results::publish(desk, report, folder, &files)
}

/// The number that the study is about: the one asked for, or the one that the analysis is made for.
fn outcome(arguments: &Arguments, analysis: &Analysis, study: &Study) -> Result<String, Failure> {
    let names = study.numbers();
    match &arguments.outcome {
        Some(name) if names.contains(&name.as_str()) => Ok(name.clone()),
        Some(name) => {
            let message = format!("no run found a number `{name}`");
            Err(Failure::input("F117", message, format!("the runs found {}", names.join(", "))))
        }
        None => {
            let outcomes: Vec<&vary::Outcome> = study.rows.iter().map(|row| &row.outcome).collect();
            let leading = vary::leading(analysis, &outcomes);
            Ok(leading.or(analysis.leading.last().copied()).unwrap_or_default().to_owned())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_are_in_a_unit_of_their_size() {
        let words: Vec<String> = [0.0002, 0.25, 5.0, 600.0, 9000.0, 1e6].into_iter().map(duration).collect();
        assert_eq!(words, ["1 ms", "250 ms", "5.0 s", "10 min", "2.5 h", "12 days"]);
    }

    #[test]
    fn more_than_can_be_counted_is_too_many() {
        assert_eq!(
            [too_many(Some(10), 10), too_many(Some(11), 10), too_many(None, 10)],
            [None, Some(11), Some(usize::MAX)]
        );
    }
}
