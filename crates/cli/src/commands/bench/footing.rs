//! `extrados bench footing`: yielding ground under a rough footing, from the mesh to the last load step.

use super::repeated::least_and_middle;
use crate::args::Bench;
use crate::report::Report;
use crate::status::Status;
use crate::watcher::asked_to_stop;
use extrados::Refusal;
use mechanics::fem;
use mechanics::watch::Watch;
use std::time::Instant;
use verification::footing::{Ground, footing, prandtl, settings};

/// Elements along the ground where `--count` does not say.
const COLUMNS: u32 = 142;

/// Out-of-balance force over the reaction at which a step counts as balanced.
const TOLERANCE: f64 = 1e-6;

/// Repeats the push and gives the least and the middle time.
pub(super) fn run(onlooker: &mut dyn Watch, arguments: &Bench) -> Result<Report, Refusal> {
    let columns = arguments.count.unwrap_or(COLUMNS) as usize;
    let ground = arguments.material.unwrap_or(Ground::VonMises);
    let refused = |error: String| Refusal::new("F108", error, "ask for less");
    let (mut seconds, mut last) = (Vec::new(), None);
    for _ in 0..arguments.repeats {
        let clock = Instant::now();
        let mesh = footing(columns, ground, fem::Element::Q4).map_err(|error| refused(error.to_string()))?;
        let pushed = mesh.push(&settings(TOLERANCE), onlooker).map_err(|error| refused(error.to_string()))?;
        seconds.push(clock.elapsed().as_secs_f64());
        last = Some((pushed, mesh.model.equations()));
        if asked_to_stop() {
            break;
        }
    }
    let [least, middle] = least_and_middle(&mut seconds);
    let Some((pushed, equations)) = last else { return Ok(Report::new(Status::Undetermined)) };
    let (status, ended) = match pushed.outcome.status {
        fem::Status::Completed => (Status::Completed, "completed"),
        fem::Status::NotConverged => (Status::Undetermined, "not converged"),
        fem::Status::Singular => (Status::Undetermined, "singular"),
        fem::Status::Cancelled => (Status::Cancelled, "cancelled"),
    };
    let pressure = pushed.mean_pressure / 1e3;
    let exact = prandtl(ground).map(|pressure| pressure / 1e3);
    let beyond = exact.map_or(String::new(), |exact| format!(", Prandtl's limit {exact:.1} kPa"));
    let kept = pushed.outcome.steps.iter().filter(|step| step.kept).count();
    Ok(Report::new(status)
        .with("name", "footing")
        .with("size", columns * columns.div_ceil(2))
        .with("repeats", seconds.len())
        .with("material", ground.word())
        .with("seconds", least)
        .with("seconds_median", middle)
        .with("iterations_total", pushed.outcome.iterations)
        .with("mean_pressure_kpa", pressure)
        .with("limit_pressure_kpa", exact)
        .with("reached", pushed.outcome.reached)
        .with("load_steps", kept)
        .with("ended", ended)
        .with("plastic_points", pushed.yielding)
        .with("tolerance", TOLERANCE)
        .with("degrees_of_freedom", equations)
        .saying(format!(
            "footing: {least:.3} s (median {middle:.3} s of {}), {}, {columns} x {} elements, {equations} degrees of freedom, one \
             core\n{ended} at {:.1} % of the push in {kept} steps and {} iterations to {TOLERANCE:.0e}; mean pressure {pressure:.1} \
             kPa{beyond}; {} points flow\n",
            seconds.len(),
            ground.word(),
            columns.div_ceil(2),
            100.0 * pushed.outcome.reached,
            pushed.outcome.iterations,
            pushed.yielding,
        )))
}
