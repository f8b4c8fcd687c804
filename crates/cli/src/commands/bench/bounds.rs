//! `extrados bench bounds`: both bounds of Bridgemill's load with its fill as a continuum, from the bridge to the last mesh.

use super::of_bridgemill;
use crate::args::Bench;
use crate::clock::Clock;
use crate::failure::Failure;
use crate::report::Report;
use crate::results;
use crate::status::Status;
use assess::analysis::by_bounds;
use mechanics::watch::Pace;

/// Repeats the bounds and gives the least and the middle time; pictures and the range of strength are not part of it.
pub fn run(arguments: &Bench) -> Result<Report, Failure> {
    let bridge = of_bridgemill("continuum.toml")?;
    let (mut seconds, mut last) = (Vec::new(), None);
    for _ in 0..arguments.repeats {
        let clock = Clock::start();
        let found = by_bounds::bounds_alone(&bridge, &Pace::default());
        seconds.push(clock.seconds());
        last = Some(found.map_err(|error| results::not_set_up(&error))?);
    }
    seconds.sort_by(f64::total_cmp);
    let (least, middle) = (seconds[0], seconds[seconds.len() / 2]);
    let Some((bounds, reference)) = last else { return Ok(Report::new(Status::Undetermined)) };
    let load = |factor: Option<f64>| factor.map(|f| f * reference / 1e3);
    let (lower, upper) = (bounds.lower.as_ref().map(|l| l.factor), bounds.upper.as_ref().map(|u| u.factor));
    let (ratio, elements) = (bounds.ratio(), bounds.mesh.triangles.len());
    let told = ratio.map_or("none".to_owned(), |ratio| format!("{ratio:.3}"));
    Ok(Report::new(Status::Completed)
        .with("name", "bounds")
        .with("repeats", arguments.repeats)
        .with("seconds", least)
        .with("seconds_median", middle)
        .with("elements", elements)
        .with("bound_ratio", ratio)
        .with("lower_bound_kn_per_m", load(lower))
        .with("upper_bound_kn_per_m", load(upper))
        .saying(format!(
            "bounds: {least:.2} s (median {middle:.2} s of {}), upper over lower {told}, {elements} triangles on the last of {} \
             meshes, one core\n",
            arguments.repeats,
            bounds.rounds.len()
        )))
}
