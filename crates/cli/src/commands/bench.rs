//! `extrados bench`: the speed of one method on this machine, on one core unless more are asked for.

mod bounds;
mod crossing;
mod disks;
mod factor;
mod footing;
mod passage;
mod repeated;
mod update;

use crate::args::{Bench, BenchName};
use crate::desk::Desk;
use crate::failure::Failure;
use crate::report::Report;
use crate::status::Status;
use crate::watcher::watched;
use assess::analysis::AnalysisError;
use assess::analysis::engine::{dem as by_dem, rigid};
use bridge::Bridge;
use extrados::examples;
use mechanics::contact::ContactLength;
use mechanics::watch::Unwatched;
use mechanics::{dem, limit, path};
use repeated::{Repeated, repeated};
use structure::discretise::{Discretised, discretise};

/// Measures.
pub(super) fn run(desk: &Desk, arguments: &Bench) -> Result<Report, Failure> {
    let quiet = desk.screen.quiet || desk.screen.json;
    match arguments.name {
        BenchName::Disks => disks::run(quiet, arguments),
        BenchName::Arch => bridgemill(arguments, arch),
        BenchName::Limit => bridgemill(arguments, limit),
        BenchName::Path => bridgemill(arguments, path),
        BenchName::Bounds => bounds::run(arguments),
        BenchName::Crossing => crossing::run(arguments),
        BenchName::Factor => factor::run(arguments),
        BenchName::Footing => watched(quiet, |onlooker| footing::run(onlooker, arguments)),
        BenchName::Passage => passage::run(quiet, arguments),
        BenchName::Update => watched(quiet, |onlooker| update::run(onlooker, arguments)),
    }
}

/// What a measure does.
type Measure = fn(&Bridge) -> Result<Found, AnalysisError>;

fn bridgemill(arguments: &Bench, method: Measure) -> Result<Report, Failure> {
    let bridge = of_example("bridgemill", "case-1.toml")?;
    let Repeated { least, middle, last: found } = repeated(arguments, || method(&bridge))?;
    let report = Report::new(Status::Completed)
        .with("size", found.blocks)
        .with("repeats", arguments.repeats)
        .with("tolerance", found.tolerance)
        .with("last_stable_load_kn_per_m", found.stands.map(|load| load / 1e3))
        .with("collapse_load_kn_per_m", found.falls.map(|load| load / 1e3))
        .with("iterations_total", found.iterations);
    let (repeats, iterations, blocks) = (arguments.repeats, found.iterations, found.blocks);
    Ok(match arguments.name {
        BenchName::Arch => report
            .with("name", "arch")
            .with("damping", "adaptive")
            .with("seconds_to_collapse", least)
            .with("seconds_median", middle)
            .saying(format!(
                "arch: {least:.3} s to collapse (median {middle:.3} s of {repeats}), {iterations} iterations with adaptive \
                 damping, {blocks} blocks, one core\n"
            )),
        BenchName::Path => {
            let by_blocks = repeated(arguments, || relaxed(&bridge))?;
            let rigid = repeated(arguments, || limit(&bridge))?;
            let load = |load: Option<f64>| load.map_or("no load".to_owned(), |load| format!("{:.1} kN/m", load / 1e3));
            report
                .with("name", "path")
                .with("seconds_to_peak", least)
                .with("seconds_median", middle)
                .with("seconds_block_engine", by_blocks.least)
                .with("seconds_limit", rigid.least)
                .saying(format!(
                    "path: {:.3} ms past the peak (median {:.3} ms of {repeats}), {iterations} iterations, {blocks} blocks, one core: {}\n\
                     beside it: block engine on the same joints {:.0} ms, {}; limit analysis of rigid blocks {:.1} ms, {}\n",
                    1e3 * least,
                    1e3 * middle,
                    load(found.stands),
                    1e3 * by_blocks.least,
                    load(by_blocks.last.stands),
                    1e3 * rigid.least,
                    load(rigid.last.stands),
                ))
        }
        _ => {
            let (least, middle) = (1e3 * least, 1e3 * middle);
            report.with("name", "limit").with("milliseconds", least).with("milliseconds_median", middle).saying(format!(
                "limit: {least:.3} ms (median {middle:.3} ms of {repeats}), building and both bounds included, {blocks} \
                 blocks, one core\n"
            ))
        }
    })
}

/// What one run of a method found.
struct Found {
    blocks: usize,
    iterations: u64,
    /// Largest load shown to stand, smallest shown to fall [N/m].
    stands: Option<f64>,
    falls: Option<f64>,
    tolerance: f64,
}

impl Found {
    /// With the factors on the load by which blocks were shown to stand and to fall.
    fn of(d: &Discretised, iterations: u64, factors: [Option<f64>; 2], tolerance: f64) -> Found {
        let [stands, falls] = factors.map(|factor| factor.map(|f| f * d.reference_load));
        Found { blocks: d.model.blocks.len(), iterations, stands, falls, tolerance }
    }
}

/// Case 1 to collapse by discrete elements, from the bridge to the last step; pictures are not part of it.
fn arch(bridge: &Bridge) -> Result<Found, AnalysisError> {
    by_blocks(bridge, by_dem::settings(bridge))
}

/// The same on joints with distributed contact.
fn relaxed(bridge: &Bridge) -> Result<Found, AnalysisError> {
    by_blocks(bridge, dem::Settings { contact_length: ContactLength::Distributed, ..by_dem::settings(bridge) })
}

fn by_blocks(bridge: &Bridge, settings: dem::Settings) -> Result<Found, AnalysisError> {
    let d = discretise(bridge)?;
    let settings = dem::Settings { damping: dem::Damping::Adaptive, ..settings };
    let step = bridge.plan.load_step.unwrap_or(100e3 / bridge.width) / d.reference_load;
    let program = dem::Program { increment: step, limit: 100.0 * step, resolution: None, watched: d.watched };
    let found = dem::collapse(&d.model, &d.loading, &program, &settings, None, &mut Unwatched)?;
    Ok(Found::of(&d, found.iterations_total, [found.last_stable_factor, found.collapse_factor], settings.tolerance))
}

/// Case 1 on joints with distributed contact, from the bridge to past its largest load.
fn path(bridge: &Bridge) -> Result<Found, AnalysisError> {
    let d = discretise(bridge)?;
    let settings = path::Settings::new(ContactLength::Distributed);
    let step = bridge.plan.load_step.unwrap_or(100e3 / bridge.width) / d.reference_load;
    let program = path::Program { increment: step, limit: 100.0 * step, watched: d.watched };
    let found = path::collapse(&d.model, &d.loading, (&settings, &program), None, &mut Unwatched)?;
    Ok(Found::of(
        &d,
        u64::from(found.iterations),
        [found.last_stable_factor, found.collapse_factor],
        settings.tolerance,
    ))
}

/// The full ring of case 1 by limit analysis: blocks, program, both bounds, mechanism.
fn limit(bridge: &Bridge) -> Result<Found, AnalysisError> {
    let d = discretise(bridge)?;
    let settings = limit::Settings { contact_points: limit::ContactPoints::FullRing, ..rigid::settings(bridge) };
    let found = limit::collapse_load(&d.model, &d.loading, &settings)?;
    Ok(Found::of(&d, u64::from(found.iterations), [found.lower_bound, found.upper_bound], 1e-6))
}

/// A file of an example.
fn of_example(name: &str, file: &str) -> Result<Bridge, Failure> {
    let text = examples::named(name).and_then(|example| example.files.iter().find(|one| one.name == file));
    let read = text.and_then(|file| bridge::read(file.text.as_bytes()).bridge);
    read.ok_or_else(|| Failure::input("F104", format!("the example {name} cannot be read"), "report this"))
}
