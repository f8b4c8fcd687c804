//! `extrados compare`: two bridge files side by side.

use super::source::{Source, read_text};
use crate::args::Compare as Arguments;
use crate::desk::Desk;
use crate::folder::{self, Folder, Purpose};
use crate::report::Report;
use crate::results;
use crate::status::Status;
use crate::watcher::watched;
use extrados::{Compared, Refusal};
use findings::words::counted;
use serde_json::json;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Differences that are shown on the screen.
const SHOWN: usize = 20;

/// Reads both files, makes both analyses, writes what differs.
pub(super) fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Refusal> {
    let files = [&arguments.before, &arguments.after];
    for file in files {
        if bridge::is_block_file(&read_text(file)?) {
            let message = format!("{} is a block model file; two bridge files can be compared", file.display());
            return Err(Refusal::new("F107", message, "compare the results of two runs of extrados collapse"));
        }
    }
    let sources = [Source::open(desk, files[0])?, Source::open(desk, files[1])?];
    let mut report = sources[0].report(Status::Completed);
    let project = &sources[1].project;
    report.add_findings(project.name(), project.text(), project.findings());
    let [Some(before), Some(_)] = [sources[0].bridge(), sources[1].bridge()] else {
        report.status = Status::UnusableInput;
        return Ok(report);
    };
    let choice = arguments.choice.of(before.width)?;
    let folder = folder(arguments, &sources)?;
    let before = &sources[0].project;
    let found = watched(desk.screen.quiet, |spectator| extrados::compare(before, project, choice, spectator))?;
    write(desk, arguments, &found, report, &folder)
}

fn folder(arguments: &Arguments, sources: &[Source; 2]) -> Result<Folder, Refusal> {
    let stem = |file: &Path| folder::shown_stem(file).to_string_lossy().into_owned();
    let named = || Path::new("out").join(format!("{}-and-{}", stem(&arguments.before), stem(&arguments.after)));
    let out = arguments.out.clone().unwrap_or_else(named);
    let mut inputs: Vec<PathBuf> = sources.iter().flat_map(|source| source.project.inputs()).cloned().collect();
    inputs.push(arguments.before.clone());
    Folder::prepare(&out, Purpose::new("compare", &arguments.after, &inputs))
}

fn write(
    desk: &mut Desk,
    arguments: &Arguments,
    found: &Compared,
    mut report: Report,
    folder: &Folder,
) -> Result<Report, Refusal> {
    report.status = Status::worst_of(found.answers.iter().map(|answer| answer.status));
    let named = [&arguments.before, &arguments.after].map(|file| file.display().to_string());
    report.fields.insert("before_file".into(), json!(named[0]));
    report.fields.insert("after_file".into(), json!(named[1]));
    report.fields.extend(found.object());
    report.summary = summary(found, &named, folder.path());
    results::publish(desk, report, folder, extrados::written::compared(found))
}

fn summary(found: &Compared, named: &[String; 2], folder: &Path) -> String {
    let mut page = format!("{} and {}: {}\n", named[0], named[1], found.verdict());
    for caution in &found.cautions {
        let _ = writeln!(page, "  careful: {caution}");
    }
    let _ = writeln!(page, "\n  {:<30} {:>14} {:>14} {:>10}", "", "before", "after", "change");
    for one in &found.numbers {
        // What has no unit is a count.
        let decimals =
            if one.name.ends_with("_m") || one.name.contains("_kn") || one.name.ends_with("_mpa") { 3 } else { 0 };
        let shown = |value: Option<f64>| value.map_or("-".to_owned(), |value| format!("{value:.decimals$}"));
        let change = one.change().map_or(String::new(), |change| format!("{:+.1} %", 100.0 * change));
        let _ = writeln!(page, "  {:<30} {:>14} {:>14} {change:>10}", one.name, shown(one.before), shown(one.after));
    }
    let count = found.differences.len();
    let _ = writeln!(page, "\n  {} of input", counted(count, "difference"));
    for one in found.differences.iter().take(SHOWN) {
        let said = |value: &Option<String>| value.clone().unwrap_or_else(|| "(not there)".to_owned());
        let _ = writeln!(page, "    {}: {} -> {}", one.path, said(&one.before), said(&one.after));
    }
    if count > SHOWN {
        let _ = writeln!(page, "    and {} more, see differences.csv", count - SHOWN);
    }
    for (which, said) in ["first", "second"].into_iter().zip(&found.assumptions) {
        for assumption in said {
            let _ = writeln!(page, "  only the {which} assumes: {assumption}");
        }
    }
    let _ = writeln!(page, "\nResults are in {}", folder.display());
    page
}
