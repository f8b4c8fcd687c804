//! A plain gradient search from one start (L-BFGS-B on the square of the norm): what a general program offers, and what
//! the paper compares with. It ends in the minimum into whose valley it happens to start.

use basin::{Executor, Lbfgsb};

use crate::basis::{Basis, Halt};
use crate::evaluator::Evaluator;
use crate::forward::Failure;
use crate::parameter::{Start, shares, values};
use crate::report::{Found, verify};
use crate::search::jacobian::STEP;
use crate::search::modern::Status;
use crate::search::replay::{Known, Missing, Sought, broken_off, replay};

/// Where it ended.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// How it ended.
    pub status: Status,
    /// Its end, verified.
    pub found: Option<Found>,
}

/// Goes downhill from a start, for at most so many iterations.
pub fn search(evaluator: &mut Evaluator, basis: &Basis, start: &Start, iterations: u64) -> Outcome {
    match run(evaluator, basis, start, iterations) {
        Ok((status, found)) => Outcome { status, found: Some(found) },
        Err(Halt::Stopped) => Outcome { status: Status::Stopped, found: None },
        Err(Halt::Failed(failure)) => Outcome { status: Status::Failed(failure), found: None },
    }
}

fn run(evaluator: &mut Evaluator, basis: &Basis, start: &Start, iterations: u64) -> Result<(Status, Found), Halt> {
    evaluator.begin(None);
    evaluator.stage("gradient search");
    let parameters = evaluator.problem.parameters();
    let begin = shares(parameters, &start.point(parameters));
    let one = |_: usize, known: &Known| -> Result<_, Missing> {
        let solver = Lbfgsb::<Vec<f64>>::new().with_absolute_projected_gradient_tolerance(1e-7);
        let ended = Executor::from_start(Sought::new(known), solver, begin.clone())
            .max_iter(iterations.max(1))
            .run()
            .map_err(broken_off)?;
        let converged = ended.report.termination.is_converged();
        Ok((values(parameters, ended.best_param()), ended.best_cost(), converged, format!("{:?}", ended.report.code())))
    };
    let end = replay(evaluator, basis, STEP, 1, one)?.pop().filter(|end| end.1.is_finite());
    let Some((point, cost, converged, ended)) = end else {
        return Err(Halt::Failed(Failure::new("no-start", "the model fails at the start")));
    };
    let found = verify(evaluator, basis, parameters, &point, cost.sqrt(), &vec![converged; point.len()])?;
    Ok((if converged { Status::Converged } else { Status::NotConverged(ended) }, found))
}
