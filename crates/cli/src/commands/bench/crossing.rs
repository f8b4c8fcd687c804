//! `extrados bench crossing`: a vehicle of 13 axles at 511 positions over three spans, rigid and on joints that give, without and
//! with crushing.

use crate::args::Bench;
use crate::clock::Clock;
use crate::failure::Failure;
use crate::report::Report;
use crate::results;
use crate::status::Status;
use assess::analysis::vehicles;
use bridge::{Bridge, Method};
use mechanics::watch::Unwatched;
use outcome::vehicles::VehicleSweep;

/// Three spans of 10 m in 40 voussoirs each, and what crosses them.
const BRIDGE: &str = include_str!("crossing/bridge.toml");
const UNLIMITED: &str = "\"unlimited\"";
const VEHICLE: &str = include_str!("crossing/vehicle.toml");

/// Repeats each sweep and gives its least time, from the bridge to the envelope of every position; pictures and pages are not part of it.
pub fn run(arguments: &Bench) -> Result<Report, Failure> {
    let mut report = Report::new(Status::Completed).with("name", "crossing").with("repeats", arguments.repeats);
    let mut page = String::new();
    for (strength, about, key) in
        [(UNLIMITED, "without crushing", ""), ("\"8 MPa\"", "joints that crush at 8 MPa", "_crushing")]
    {
        let own = bridge(strength)?;
        let (rigid, _) = least(&own, Method::Limit, arguments.repeats)?;
        let (gives, swept) = least(&own, Method::Path, arguments.repeats)?;
        let one = &swept.vehicles[0];
        let (positions, factor) =
            (one.envelope.len(), |found: Option<f64>| found.map_or("none".to_owned(), |f| format!("{f:.3}")));
        let stiff = one.envelope.iter().filter_map(|point| point.rigid).min_by(f64::total_cmp);
        report = report
            .with("positions", positions)
            .with(&format!("seconds_limit{key}"), rigid)
            .with(&format!("seconds{key}"), gives)
            .with(&format!("adequacy_factor{key}"), one.factor());
        page += &format!(
            "crossing, {about}: {gives:.2} s for {positions} positions of 13 axles, of which rigid blocks alone {rigid:.2} s; adequacy \
             {} ({} rigid), one core\n",
            factor(one.factor()),
            factor(stiff),
        );
    }
    Ok(report.saying(page))
}

/// Least time of a sweep [s], and the last one.
fn least(bridge: &Bridge, method: Method, repeats: u32) -> Result<(f64, VehicleSweep), Failure> {
    let mut own = bridge.clone();
    own.plan.method = method;
    let sweep = || -> Result<(f64, VehicleSweep), Failure> {
        let clock = Clock::start();
        let found = vehicles::vehicle_sweep(&own, &mut Unwatched).map_err(|error| results::not_set_up(&error))?;
        Ok((clock.seconds(), found))
    };
    let mut best = sweep()?;
    for _ in 1..repeats {
        let next = sweep()?;
        best = (best.0.min(next.0), next.1);
    }
    Ok(best)
}

/// The bridge with its vehicle, of a masonry of this strength.
fn bridge(strength: &str) -> Result<Bridge, Failure> {
    let read = bridge::read(BRIDGE.replace(UNLIMITED, strength).as_bytes()).bridge;
    let mut bridge =
        read.ok_or_else(|| Failure::input("F104", "the bridge of the bench cannot be read", "report this"))?;
    bridge.sweep.iter_mut().for_each(|plan| plan.texts.push(("vehicle.toml".to_owned(), VEHICLE.to_owned())));
    Ok(bridge)
}
