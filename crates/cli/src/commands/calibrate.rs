//! `extrados calibrate-fill`: the contact stiffness of fill particles for a wanted modulus.

use super::source::Source;
use crate::args::CalibrateFill as Arguments;
use crate::desk::Desk;
use crate::failure::Failure;
use crate::folder::{self, Folder};
use crate::report::Report;
use crate::results;
use crate::status::Status;
use crate::watcher::Watcher;
use crate::{quantities, summary};
use extrados::{CalibrateFillOptions, calibrate_fill};
use outcome::calibration::{CalibrationReport, Verdict};
use outcome::published;

/// Reads the file, packs, presses, searches, checks, writes what was found.
pub(super) fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Failure> {
    let source = Source::open(desk, &arguments.file)?;
    if source.bridge().is_none() {
        return Ok(source.report(Status::UnusableInput));
    }
    let modulus = arguments.modulus.as_ref().map(|text| quantities::stress("--modulus", text)).transpose()?;
    let options = CalibrateFillOptions { modulus, seeds: arguments.seeds.map(u64::from) };
    let out = arguments.out.clone().unwrap_or_else(|| folder::default_for(&arguments.file));
    let folder = source.folder(&out, "calibrate-fill")?;
    let mut watcher = Watcher::without_checkpoint(desk.screen.quiet);
    let found = calibrate_fill(&source.project, &options, &mut watcher);
    watcher.finish();
    let found = found?;
    let mut report = source.report(Status::named(found.verdict.word()).unwrap_or(Status::Undetermined));
    if found.verdict == Verdict::Cancelled {
        return Ok(report.saying("interrupted; nothing was written\n".to_owned()));
    }
    report.warn_of(&mut desk.screen, &found.warnings);
    report.fields = found.object();
    report.summary = summary::calibration(&found, &folder.path().display().to_string());
    write(desk, &found, report, &folder)
}

fn write(desk: &mut Desk, found: &CalibrationReport, report: Report, folder: &Folder) -> Result<Report, Failure> {
    let mut files = Vec::new();
    for (name, svg) in figures::calibration(found) {
        files.extend(figures::both(&name, &svg).map_err(|error| results::not_drawn(folder.path(), &error))?);
    }
    let tables = [("curve", published::calibration_curves(found)), ("moduli", published::calibration_moduli(found))];
    files.extend(results::tables(tables));
    results::publish(desk, report, folder, &files)
}
