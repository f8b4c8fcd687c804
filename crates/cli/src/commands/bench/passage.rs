//! `extrados bench passage`: a train over the railway arch on a fine mesh, from the bridge to the last position.

use super::of_example;
use crate::args::Bench;
use crate::report::Report;
use crate::status::Status;
use crate::watcher::{asked_to_stop, watched};
use assess::analysis::passage::{Scope, Setup, Solution, setup, solve};
use bridge::Bridge;
use bridge::passage::PassagePath;
use extrados::{Looking, Refusal};
use mechanics::watch::{Progress, Watch, Wish};
use outcome::passage::{Part, PassageStatus};
use std::time::Instant;

/// Length of an element near the rings [m] where `--count` does not say: 60,000 unknowns and more.
const SIZE: f64 = 0.045;

/// Positions at which the whole system is solved beside the condensed one.
const COMPARED: usize = 50;

/// Repeats the passage, then compares it with the plain path at some of its positions.
pub(super) fn run(quiet: bool, arguments: &Bench) -> Result<Report, Refusal> {
    let mut bridge = of_example("railway-arch", "passage.toml")?;
    // A count is one of elements along a metre.
    bridge.service.mesh.size = Some(arguments.count.map_or(SIZE, |count| 1.0 / f64::from(count)));
    let (mut runs, mut last) = (Vec::new(), None);
    for _ in 0..arguments.repeats {
        let clock = Instant::now();
        let made = setup(&bridge)?;
        let seconds_mesh = clock.elapsed().as_secs_f64();
        let (found, until_positions) = timed(quiet, clock, &bridge, &made)?;
        runs.push([clock.elapsed().as_secs_f64(), seconds_mesh, until_positions]);
        last = Some((made, found));
        if asked_to_stop() {
            break;
        }
    }
    runs.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let ([seconds, mesh, rest], middle) = (runs[0], runs[runs.len() / 2][0]);
    let Some((setup, found)) = last else { return Ok(Report::new(Status::Undetermined)) };
    let compared = compare(&bridge, &setup, quiet)?;
    let status = match found.status {
        PassageStatus::Completed => Status::Completed,
        PassageStatus::NotConverged => Status::Undetermined,
        PassageStatus::Cancelled => Status::Cancelled,
    };
    let positions = found.values.first().map_or(0, Vec::len);
    let crossing = found.log.iter().filter(|step| step.stage == Part::Passage);
    let iterations: usize = crossing.map(|step| step.iterations).sum();
    let plastic = found.log.iter().map(|step| step.plastic_points).max().unwrap_or(0);
    let opened = found.log.iter().map(|step| step.open_joints).max().unwrap_or(0);
    let retained = found.condensed_degrees_of_freedom;
    Ok(Report::new(status)
        .with("name", "passage")
        .with("size", found.degrees_of_freedom)
        .with("repeats", runs.len())
        .with("seconds", seconds)
        .with("seconds_median", middle)
        .with("seconds_mesh", mesh)
        .with("seconds_self_weight_and_condensing", rest)
        .with("seconds_positions", seconds - mesh - rest)
        .with("load_positions", positions)
        .with("degrees_of_freedom", found.degrees_of_freedom)
        .with("condensed_degrees_of_freedom", retained)
        .with("ring_nodes", bridge.service.mesh.ring_nodes)
        .with("iterations_total", iterations)
        .with("plastic_points", plastic)
        .with("open_joints", opened)
        .with("compared_positions", compared.positions)
        .with("plain_path", compared.ended)
        .with("largest_difference", compared.difference)
        .with("seconds_plain_per_position", compared.seconds)
        .saying(format!(
            "passage: {seconds:.2} s (median {middle:.2} s of {}) for {positions} positions of {} over {} spans, {} degrees of freedom, one \
             core\nmesh {mesh:.2} s, self-weight and condensing {rest:.2} s, positions {:.2} s; {iterations} iterations on {} retained rows, at \
             most {plastic} points flow and {opened} joints are open\nplain path {} at {} positions: {:.2} s each; records differ by at most \
             {:.1e} of a channel's largest value\n",
            runs.len(),
            setup.train,
            bridge.spans.len(),
            found.degrees_of_freedom,
            seconds - mesh - rest,
            retained.unwrap_or(0),
            compared.ended,
            compared.positions,
            compared.seconds,
            compared.difference,
        )))
}

/// The plain path beside the condensed one.
struct Compared {
    /// How the plain path ended: positions that it did not reach are not compared.
    ended: &'static str,
    positions: usize,
    /// Largest difference of a record over the channel's largest value.
    difference: f64,
    /// Of the plain path, each position [s].
    seconds: f64,
}

/// Both paths go through the same positions, for what has yielded and slid depends on the way: from the middle of the passage on, a
/// quarter of a metre apart at 45 km/h.
fn compare(bridge: &Bridge, setup: &Setup, quiet: bool) -> Result<Compared, Refusal> {
    const EVERY: usize = 4;
    let middle = setup.positions.len() / 2;
    let thinned = |all: &[f64]| all.iter().skip(middle).step_by(EVERY).take(COMPARED).copied().collect::<Vec<f64>>();
    let mut few = Setup { times: thinned(&setup.times), positions: thinned(&setup.positions), ..setup.clone() };
    let go = |few: &Setup| -> Result<(Solution, f64), Refusal> {
        let clock = Instant::now();
        let (found, until_positions) = timed(quiet, clock, bridge, few)?;
        Ok((found, clock.elapsed().as_secs_f64() - until_positions))
    };
    let (condensed, _) = go(&few)?;
    few.plan.path = PassagePath::Plain;
    // As close to balance as the condensed path comes.
    few.plan.tolerance = few.plan.tolerance.min(1e-9);
    let (plain, seconds) = go(&few)?;
    let positions = plain.values.first().map_or(0, Vec::len);
    let difference = condensed.values.iter().zip(&plain.values).map(|(condensed, plain)| {
        let largest = plain.iter().fold(f64::MIN_POSITIVE, |most, value| most.max(value.abs()));
        let differ = condensed.iter().zip(plain).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        differ / largest
    });
    Ok(Compared {
        ended: plain.status.word(),
        positions,
        difference: difference.fold(0.0, f64::max),
        seconds: seconds / positions.max(1) as f64,
    })
}

/// An onlooker that notes when the positions begin.
struct Timed<'a> {
    spectator: Looking<'a>,
    clock: Instant,
    until_positions: Option<f64>,
}

/// A passage, and what a clock says when its positions begin [s].
fn timed(quiet: bool, clock: Instant, bridge: &Bridge, setup: &Setup) -> Result<(Solution, f64), Refusal> {
    watched(quiet, |spectator| {
        let mut onlooker = Timed { spectator: Looking(spectator), clock, until_positions: None };
        let found = solve(bridge, setup, Scope::Sensors, &[], &mut onlooker)?;
        Ok((found, onlooker.until_positions.unwrap_or_default()))
    })
}

impl Watch for Timed<'_> {
    fn look(&mut self, progress: &Progress) -> Wish {
        if progress.stage.starts_with("position") {
            self.until_positions.get_or_insert(self.clock.elapsed().as_secs_f64());
        }
        self.spectator.look(progress)
    }
}
