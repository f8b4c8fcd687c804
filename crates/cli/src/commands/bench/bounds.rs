//! `extrados bench bounds`: both bounds of Bridgemill's load with its fill as a continuum, from the bridge to the last mesh.

use super::of_example;
use super::repeated::{Repeated, repeated};
use crate::args::Bench;
use crate::report::Report;
use crate::status::Status;
use assess::analysis::engine::continuum;
use bridge::Bridge;
use extrados::Refusal;
use mechanics::limit::continuum::Bounds;
use mechanics::watch::CancelToken;

/// Bounds as close as the file wants them, 5 %, and as close as 2 %, which takes finer meshes than it has by default.
const CLOSE: (f64, usize) = (1.02, 12_000);

/// Repeats the bounds and gives the least and the middle time, once more for close ones; pictures and the range of strength are not
/// part of it.
pub(super) fn run(arguments: &Bench) -> Result<Report, Refusal> {
    let bridge = of_example("bridgemill", "continuum.toml")?;
    let mut finer = bridge.clone();
    finer.continuum.iter_mut().for_each(|plan| (plan.bound_ratio, plan.elements) = CLOSE);
    let wanted = measured(arguments, &bridge)?;
    let close = measured(arguments, &finer)?;
    let (bounds, reference) = &wanted.last;
    let load = |factor: Option<f64>| factor.map(|f| f * reference / 1e3);
    let (lower, upper) = (bounds.lower.as_ref().map(|l| l.factor), bounds.upper.as_ref().map(|u| u.factor));
    Ok(Report::new(Status::Completed)
        .with("name", "bounds")
        .with("repeats", arguments.repeats)
        .with("seconds", wanted.least)
        .with("seconds_median", wanted.middle)
        .with("elements", bounds.mesh.triangles.len())
        .with("bound_ratio", bounds.ratio())
        .with("lower_bound_kn_per_m", load(lower))
        .with("upper_bound_kn_per_m", load(upper))
        .with("seconds_close", close.least)
        .with("bound_ratio_close", close.last.0.ratio())
        .saying(told(arguments, &wanted) + &told(arguments, &close)))
}

fn measured(arguments: &Bench, bridge: &Bridge) -> Result<Repeated<(Bounds, f64)>, Refusal> {
    repeated(arguments, || continuum::bounds_alone(bridge, &CancelToken::default()))
}

fn told(arguments: &Bench, Repeated { least, middle, last: (bounds, _) }: &Repeated<(Bounds, f64)>) -> String {
    let ratio = bounds.ratio().map_or("none".to_owned(), |ratio| format!("{ratio:.3}"));
    format!(
        "bounds: {least:.2} s (median {middle:.2} s of {}), upper over lower {ratio}, {} triangles on the last of {} meshes, one core\n",
        arguments.repeats,
        bounds.mesh.triangles.len(),
        bounds.rounds.len()
    )
}
