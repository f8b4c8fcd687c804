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
use crate::report::Report;
use crate::status::Status;
use crate::watcher::watched;
use assess::analysis::AnalysisError;
use bridge::Bridge;
use extrados::{Looking, Refusal, examples};
use mechanics::contact::ContactLength;
use repeated::{Repeated, repeated};
use verification::kernels;
use verification::kernels::Found;

/// Measures.
pub(super) fn run(desk: &Desk, arguments: &Bench) -> Result<Report, Refusal> {
    let quiet = desk.screen.quiet || desk.screen.json;
    match arguments.name {
        BenchName::Disks => disks::run(quiet, arguments),
        BenchName::Arch => bridgemill(arguments, |bridge| kernels::discrete_elements(bridge, None)),
        BenchName::Limit => bridgemill(arguments, kernels::limit_analysis),
        BenchName::Path => bridgemill(arguments, kernels::equilibrium_path),
        BenchName::Bounds => bounds::run(arguments),
        BenchName::Crossing => crossing::run(arguments),
        BenchName::Factor => factor::run(arguments),
        BenchName::Footing => watched(quiet, |onlooker| footing::run(&mut Looking(onlooker), arguments)),
        BenchName::Passage => passage::run(quiet, arguments),
        BenchName::Update => watched(quiet, |onlooker| update::run(&mut Looking(onlooker), arguments)),
    }
}

fn bridgemill(arguments: &Bench, method: fn(&Bridge) -> Result<Found, AnalysisError>) -> Result<Report, Refusal> {
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
            let on_joints = Some(ContactLength::Distributed);
            let by_blocks = repeated(arguments, || kernels::discrete_elements(&bridge, on_joints))?;
            let rigid = repeated(arguments, || kernels::limit_analysis(&bridge))?;
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

/// A file of an example.
fn of_example(name: &str, file: &str) -> Result<Bridge, Refusal> {
    let text = examples::named(name).and_then(|example| example.files.iter().find(|one| one.name == file));
    let read = text.and_then(|file| bridge::read(file.text.as_bytes()).bridge);
    read.ok_or_else(|| Refusal::new("F104", format!("the example {name} cannot be read"), "report this"))
}
