//! A global search as referee: evolution of a normal distribution (CMA-ES with bounds, Hansen 2016), which asks for no
//! derivative and no start.

use std::collections::BTreeSet;

use basin::{BoundedCmaEs, DenseMatrix, Executor, PopulationProgress};

use crate::basis::{Basis, Halt};
use crate::evaluator::Evaluator;
use crate::forward::Failure;
use crate::parameter::values;
use crate::search::jacobian::STEP;
pub use crate::search::modern::End as Outcome;
use crate::search::modern::end;
use crate::search::replay::{Costs, Known, Sought, count, supply};

/// Most generations, where it is not broken off.
pub const GENERATIONS: u64 = 150;

/// Points of a generation.
const POPULATION: usize = 16;
/// Widest axis of the distribution at which it ends, as a share of the ranges.
const WIDTH: f64 = 1e-4;

/// Searches the whole of the ranges from a seed, for at most so many generations.
pub fn search(evaluator: &mut Evaluator, basis: &Basis, seed: u64, generations: u64) -> Outcome {
    run(evaluator, basis, seed, generations).unwrap_or_else(Outcome::from)
}

fn run(evaluator: &mut Evaluator, basis: &Basis, seed: u64, generations: u64) -> Result<Outcome, Halt> {
    evaluator.begin(usize::try_from(generations).ok().map(|g| g.saturating_mul(POPULATION + 1)));
    evaluator.stage = "evolution".into();
    let parameters = evaluator.problem.parameters();
    let costs = Costs::default();
    let mut all_used = BTreeSet::new();
    // The first mean is known before any generation is drawn, so that a generation is all that is ever missing.
    let middle = vec![0.5; parameters.len()];
    supply(evaluator, basis, &[values(parameters, &middle)])?;
    let mut generation = 1;
    let (best, cost, converged, ended) = loop {
        // A generation is drawn before any of its costs is looked at: all its points are learnt of at once.
        let known = Known::new(evaluator, basis, STEP);
        let solver = BoundedCmaEs::<Vec<f64>, DenseMatrix>::new(seed, 0.3)
            .with_lambda(POPULATION)
            .with_absolute_distribution_size_tolerance(WIDTH);
        let begin = PopulationProgress::from_point(middle.clone());
        let sought = Sought::drawing(&known, &costs, POPULATION);
        let ended = Executor::new(sought, solver, begin).max_iter(generation).run();
        all_used.extend(known.used.take());
        let missing = known.missing.take();
        if !missing.is_empty() {
            supply(evaluator, basis, &missing[..missing.len().min(POPULATION)])?;
            continue;
        }
        let Ok(ended) = ended else {
            return Err(Halt::Failed(Failure::new("no-evolution", "the evolution broke off")));
        };
        let converged = ended.report.termination.is_converged();
        if converged || generation >= generations || ended.iter() < generation {
            let code = format!("{:?}", ended.report.code());
            break (values(parameters, ended.best_param()), ended.best_cost(), converged, code);
        }
        generation += 1;
    };
    evaluator.begin(None);
    count(evaluator, basis, all_used)?;
    if !cost.is_finite() {
        return Err(Halt::Failed(Failure::new("no-point", "the model fails wherever the evolution looked")));
    }
    end(evaluator, basis, (&best, cost.sqrt()), converged, ended)
}
