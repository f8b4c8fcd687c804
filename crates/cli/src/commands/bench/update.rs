//! `extrados bench update`: what one evaluation of a model under updating costs: six slices of a passage for other moduli.

use super::of_example;
use super::repeated::least_and_middle;
use crate::args::Bench;
use crate::report::Report;
use crate::status::Status;
use crate::watcher::asked_to_stop;
use assess::analysis::passage::{WantedSlices, setup, slices};
use extrados::Refusal;
use mechanics::watch::{Progress, Unwatched, Watch};
use outcome::passage::PassageStatus;
use std::time::Instant;

/// Slices of an evaluation: one for each channel of the railway paper.
const SLICES: usize = 6;

/// Evaluates models whose fill and mortar differ a little from one another, and gives the time of one.
pub(super) fn run(onlooker: &mut dyn Watch, arguments: &Bench) -> Result<Report, Refusal> {
    let bridge = of_example("railway-arch", "passage.toml")?;
    let base = setup(&bridge)?;
    let count = base.positions.len();
    let positions: Vec<f64> = (1..=SLICES).map(|k| base.positions[k * count / (SLICES + 2)]).collect();
    let asked = WantedSlices { positions: &positions, ..WantedSlices::default() };
    let usual = slices(&bridge, &base, asked, &mut Unwatched)?.taking_part;
    let (mut seconds, mut iterations, mut completed) = (Vec::new(), 0, true);
    for k in 0..arguments.repeats {
        let share = f64::from(k) / f64::from(arguments.repeats);
        let mut other = bridge.clone();
        let scaled = |modulus: Option<f64>, factor: f64| modulus.map(|modulus| factor * modulus);
        other.service.fill.elastic_modulus = scaled(bridge.service.fill.elastic_modulus, 0.8 + 0.4 * share);
        other.service.mortar.elastic_modulus = scaled(bridge.service.mortar.elastic_modulus, 1.2 - 0.4 * share);
        onlooker.look(&Progress { stage: "evaluations".into(), fraction: Some(share), steps: u64::from(k) });
        let clock = Instant::now();
        let found = slices(&other, &base, WantedSlices { expected: &usual, ..asked }, &mut Unwatched)?;
        seconds.push(clock.elapsed().as_secs_f64());
        iterations += found.log.iter().map(|step| step.iterations).sum::<usize>();
        completed &= found.status == PassageStatus::Completed;
        if asked_to_stop() {
            break;
        }
    }
    let evaluations = seconds.len();
    let total: f64 = seconds.iter().sum();
    let [least, middle] = least_and_middle(&mut seconds);
    Ok(Report::new(if completed { Status::Completed } else { Status::Undetermined })
        .with("name", "update")
        .with("size", 2 * base.meshed.mesh.nodes.len())
        .with("repeats", evaluations)
        .with("seconds", total)
        .with("evaluations", evaluations)
        .with("seconds_per_evaluation", least)
        .with("seconds_per_evaluation_median", middle)
        .with("slices", SLICES)
        .with("iterations_total", iterations)
        .saying(format!(
            "update: {least:.3} s an evaluation (median {middle:.3} s of {evaluations}), self-weight and {SLICES} slices of {} over {} spans, \
             {iterations} iterations in all, one core\n",
            base.train,
            bridge.spans.len(),
        )))
}
