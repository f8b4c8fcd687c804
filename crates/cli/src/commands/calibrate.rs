//! `extrados calibrate-fill`: the contact stiffness of fill particles for a wanted modulus.

use super::source::Source;
use crate::args::CalibrateFill as Arguments;
use crate::desk::Desk;
use crate::folder;
use crate::report::Report;
use crate::results::{self, Written};
use crate::status::Status;
use crate::watcher::watched;
use crate::{quantities, summary};
use extrados::{CalibrateFillOptions, Refusal, calibrate_fill};
use outcome::published;
use outcome::sweep::Ended;

/// Reads the file, packs, presses, searches, checks, writes what was found.
pub(super) fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Refusal> {
    let source = Source::open(desk, &arguments.file)?;
    if source.bridge().is_none() {
        return Ok(source.report(Status::UnusableInput));
    }
    let modulus = arguments.modulus.as_ref().map(|text| quantities::stress("--modulus", text)).transpose()?;
    let options = CalibrateFillOptions { modulus, seeds: arguments.seeds.map(u64::from) };
    let folder = source.folder(&folder::named(&arguments.out, &arguments.file), "calibrate-fill")?;
    let found = watched(desk.screen.quiet, |spectator| calibrate_fill(&source.project, &options, spectator))?;
    let mut report = source.report(Status::of(found.verdict.word()));
    if found.verdict == Ended::Cancelled {
        return Ok(report.saying("interrupted; nothing was written\n".to_owned()));
    }
    report.warn_of(&mut desk.screen, &found.warnings);
    report.fields = found.object();
    report.summary = summary::calibration(&found, &folder.path().display().to_string());
    let tables = [("curve", published::calibration_curves(&found)), ("moduli", published::calibration_moduli(&found))];
    let written = Written { drawings: figures::calibration(&found), files: results::tables(tables).collect() };
    results::publish(desk, report, &folder, written)
}
