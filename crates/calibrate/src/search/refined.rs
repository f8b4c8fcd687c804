//! The same search with slices brought to what full passages give.
//!
//! A slice remembers no earlier axle, a passage does. At a point both are found, and by what the passage gives beyond the slices every value of the
//! slices is corrected while the search goes on from there; where it ends, both are found anew. The correction changes little from
//! one end to the next, so that a few full passages do, and every end is one of the problem of full passages.

use crate::basis::{Basis, Halt};
use crate::evaluator::Evaluator;
use crate::forward::Failure;
use crate::parameter::shares;
use crate::report::verify;
use crate::search::modern::{self, Outcome, RunEnd, Settings, Status};

/// Most corrections.
const ROUNDS: usize = 6;

/// Ends nearer than this share of every range are one: a tenth of the half per cent of a value that is asked of a twin.
const SETTLED: f64 = 2e-4;

/// Goes on from a point of a search by slices.
pub fn search(evaluator: &mut Evaluator, basis: &Basis, from: &[f64], settings: &Settings) -> Outcome {
    let mut outcome = Outcome { status: Status::Stopped, runs: Vec::new(), minima: Vec::new(), found: None };
    if let Err(halt) = run(evaluator, basis, from, settings, &mut outcome) {
        outcome.status = match halt {
            Halt::Stopped => Status::Stopped,
            Halt::Failed(failure) => Status::Failed(failure),
        };
    }
    outcome
}

fn run(
    evaluator: &mut Evaluator,
    basis: &Basis,
    from: &[f64],
    settings: &Settings,
    outcome: &mut Outcome,
) -> Result<(), Halt> {
    evaluator.begin(None);
    let parameters = evaluator.problem.parameters();
    let mut end: Option<RunEnd> = None;
    let mut settled = false;
    for round in 1..=ROUNDS {
        evaluator.stage(format!("corrected by full passages, round {round}"));
        let here = end.as_ref().map_or(from, |end| &end.end).to_vec();
        let corrected = basis.corrected(evaluator, &here)?;
        let next = modern::solve(evaluator, &corrected, settings, std::slice::from_ref(&here))?.pop();
        let Some(next) = next.filter(|next| next.norm.is_finite()) else { break };
        let (old, new) = (shares(parameters, &here), shares(parameters, &next.end));
        let moved = old.iter().zip(&new).fold(0.0_f64, |most, (old, new)| most.max((old - new).abs()));
        end = Some(RunEnd { start: from.to_vec(), ..next });
        if moved < SETTLED {
            settled = true;
            break;
        }
    }
    let Some(end) = end else {
        return Err(Halt::Failed(Failure::new("no-start", "the model fails at the start")));
    };
    let converged = vec![settled && end.converged; end.end.len()];
    let found = verify(evaluator, basis, parameters, &end.end, end.norm, &converged)?;
    outcome.status = match (settled, end.converged) {
        (true, true) => Status::Converged,
        (false, _) => Status::NotConverged("the corrections by full passages did not settle".to_owned()),
        _ => Status::NotConverged(end.ended.clone()),
    };
    outcome.minima = vec![0];
    outcome.runs = vec![end];
    outcome.found = Some(found);
    Ok(())
}
