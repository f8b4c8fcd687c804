//! `extrados bench crossing`: a vehicle of 13 axles at 510 positions over three spans, rigid and on deformable joints, without and
//! with crushing.

use super::repeated::{Repeated, repeated};
use crate::args::Bench;
use crate::report::Report;
use crate::status::Status;
use assess::analysis::vehicle_sweep;
use bridge::{Bridge, Method};
use extrados::Refusal;
use mechanics::watch::Unwatched;
use outcome::vehicles::VehicleSweep;

/// Three spans of 10 m in 40 voussoirs each, and what crosses them.
const BRIDGE: &str = include_str!("crossing/bridge.toml");
const UNLIMITED: &str = "\"unlimited\"";
const VEHICLE: &str = include_str!("crossing/vehicle.toml");

/// Repeats each sweep and gives its least time, from the bridge to the envelope of every position; pictures and pages are not part of it.
pub(super) fn run(arguments: &Bench) -> Result<Report, Refusal> {
    let mut report = Report::new(Status::Completed).with("name", "crossing").with("repeats", arguments.repeats);
    let mut page = String::new();
    for (strength, about, key) in
        [(UNLIMITED, "without crushing", ""), ("\"8 MPa\"", "joints that crush at 8 MPa", "_crushing")]
    {
        let own = bridge(strength)?;
        let rigid = swept(arguments, &own, Method::Limit)?.least;
        let Repeated { least: gives, last: found, .. } = swept(arguments, &own, Method::Path)?;
        let one = &found.vehicles[0];
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

/// The sweep by a method.
fn swept(arguments: &Bench, bridge: &Bridge, method: Method) -> Result<Repeated<VehicleSweep>, Refusal> {
    let mut own = bridge.clone();
    own.plan.method = method;
    repeated(arguments, || vehicle_sweep(&own, &mut Unwatched))
}

/// The bridge with its vehicle, of a masonry of this strength.
fn bridge(strength: &str) -> Result<Bridge, Refusal> {
    let read = bridge::read(BRIDGE.replace(UNLIMITED, strength).as_bytes()).bridge;
    let mut bridge =
        read.ok_or_else(|| Refusal::new("F104", "the bridge of the bench cannot be read", "report this"))?;
    bridge.sweep.iter_mut().for_each(|plan| plan.texts.push(("vehicle.toml".to_owned(), VEHICLE.to_owned())));
    Ok(bridge)
}
