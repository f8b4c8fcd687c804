//! `extrados bench`: the speed of one method on this machine, one core.

use crate::args::{Bench, BenchName};
use crate::clock::Clock;
use crate::examples;
use crate::failure::Failure;
use crate::report::Report;
use crate::results;
use crate::status::Status;
use assess::analysis::{self, AnalysisError, Collapse};
use bridge::{Bridge, ContactPoints, Method};
use mechanics::watch::Unwatched;

/// Repeats the measure and gives the least and the middle time: the least is the method's, the middle the machine's.
pub fn run(arguments: &Bench) -> Result<Report, Failure> {
    let (method, points) = match arguments.name {
        BenchName::Arch => (Method::Dem, ContactPoints::Rounded),
        BenchName::Limit => (Method::Limit, ContactPoints::FullRing),
    };
    let bridge = case_one(method, points)?;
    let mut seconds = Vec::new();
    let mut last = None;
    for _ in 0..arguments.repeats {
        let clock = Clock::start();
        let found = once(&bridge).map_err(|error| results::not_set_up(&error))?;
        seconds.push(clock.seconds());
        last = Some(found);
    }
    seconds.sort_by(f64::total_cmp);
    let (least, middle) = (seconds[0], seconds[seconds.len() / 2]);
    let Some(found) = last else { return Ok(Report::new(Status::Undetermined)) };
    let report = Report::new(results::status(found.status))
        .with("size", found.blocks)
        .with("repeats", arguments.repeats)
        .with("tolerance", found.tolerance)
        .with("last_stable_load_kn_per_m", found.last_stable_load.map(|load| load / 1e3))
        .with("collapse_load_kn_per_m", found.collapse_load.map(|load| load / 1e3));
    Ok(match arguments.name {
        BenchName::Arch => {
            let iterations = found.dem.as_ref().map_or(0, |dem| dem.iterations_total);
            report
                .with("name", "arch")
                .with("seconds_to_collapse", least)
                .with("seconds_median", middle)
                .with("iterations_total", iterations)
                .saying(format!(
                    "arch: {least:.3} s to collapse (median {middle:.3} s of {}), {iterations} iterations, {} blocks, one core\n",
                    arguments.repeats, found.blocks
                ))
        }
        BenchName::Limit => report
            .with("name", "limit")
            .with("milliseconds", 1e3 * least)
            .with("milliseconds_median", 1e3 * middle)
            .saying(format!(
                "limit: {:.3} ms (median {:.3} ms of {}), building and both bounds included, {} blocks, one core\n",
                1e3 * least,
                1e3 * middle,
                arguments.repeats,
                found.blocks
            )),
    })
}

fn once(bridge: &Bridge) -> Result<Collapse, AnalysisError> {
    analysis::collapse(bridge, None, &mut Unwatched)
}

/// Bridgemill, case 1, as it stands in the examples.
fn case_one(method: Method, points: ContactPoints) -> Result<Bridge, Failure> {
    let text =
        examples::named("bridgemill").and_then(|example| example.files.iter().find(|file| file.name == "case-1.toml"));
    let read = text.and_then(|file| bridge::read(file.text.as_bytes()).bridge);
    let mut bridge =
        read.ok_or_else(|| Failure::input("F104", "the example bridgemill cannot be read", "report this"))?;
    bridge.plan.method = method;
    bridge.plan.contact_points = points;
    Ok(bridge)
}
