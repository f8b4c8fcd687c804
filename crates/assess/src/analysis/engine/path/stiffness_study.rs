//! What a ring would carry on joints of other stiffness: nobody knows that of an old bridge well.

use crate::analysis::AnalysisError;
use crate::analysis::engine::joints::stiffer;
use mechanics::path::{Ground, Program, Settings, Status};
use mechanics::watch::{CancelToken, Watch};
use outcome::picture::OverStiffness;
use structure::discretise::Discretised;

/// Multiples of the stiffness of the result.
const TIMES: [f64; 9] = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 100.0];

/// Iterations of the result beyond which its path is too slow to be repeated.
const MOST_ITERATIONS: u32 = 1000;

/// Steps after which another stiffness is given up: those of a ring that does not slide are some ten.
const MOST_STEPS: u64 = 300;

/// First step, as a share of the load of rigid blocks.
const FIRST_STEP: f64 = 0.15;

/// Largest loads over the stiffness of all joints; none where the path of the result was long, and no point where the blocks
/// do not stand or the path broke off or is long. `own` is the result's factor and its iterations, `rigid` the factor of
/// rigid blocks.
pub(super) fn over_stiffness(
    d: &Discretised,
    (settings, program): (&Settings, &Program),
    (own, iterations): (f64, u32),
    rigid: f64,
) -> Result<Option<OverStiffness>, AnalysisError> {
    if iterations > MOST_ITERATIONS {
        return Ok(None);
    }
    let mut points = Vec::new();
    for times in TIMES {
        let load = if times == 1.0 {
            Some(own)
        } else {
            scaled(d, (settings, program), rigid, times, &mut CancelToken::limited_to(MOST_STEPS))?
        };
        points.extend(load.map(|factor| [times, d.load(factor)]));
    }
    Ok(Some(OverStiffness { points, rigid: d.load(rigid) }))
}

/// Largest factor with joints so many times as stiff.
fn scaled(
    d: &Discretised,
    (settings, program): (&Settings, &Program),
    rigid: f64,
    times: f64,
    watch: &mut dyn Watch,
) -> Result<Option<f64>, AnalysisError> {
    let mut model = d.model.clone();
    for law in model.laws.iter_mut() {
        *law = stiffer(law, times);
    }
    let ground = Ground::new(&model, &d.loading, settings, watch)?;
    let program = Program { increment: FIRST_STEP * rigid, ..program.clone() };
    let found = ground.sweeper().carried(&d.loading.variable, (&program, &[]), watch);
    Ok(found.last_stable_factor.filter(|_| matches!(found.status, Status::LimitPoint | Status::Bifurcation)))
}
