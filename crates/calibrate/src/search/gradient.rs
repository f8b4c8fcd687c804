//! A plain gradient search from one start (L-BFGS-B on the square of the norm): what a general program offers, and what
//! the paper compares with. It ends in the minimum into whose valley it happens to start.

use std::cell::{Cell, RefCell};

use basin::{BoxBounds, Constraints, CostFunction, Executor, Gradient, Lbfgsb};

use crate::basis::{Basis, Halt};
use crate::evaluator::Evaluator;
use crate::forward::{Evaluation, Failure};
use crate::misfit::{residual_derivatives, residuals};
use crate::parameter::{Start, shares, values};
use crate::search::jacobian::{STEP, by_differences, by_shares, points};
pub use crate::search::modern::End as Outcome;
use crate::search::modern::end;
use crate::watch::Stopped;

/// Goes downhill from a start, for at most so many iterations.
pub fn search(evaluator: &mut Evaluator, basis: &Basis, start: Start, iterations: u64) -> Outcome {
    run(evaluator, basis, start, iterations).unwrap_or_else(Outcome::from)
}

fn run(evaluator: &mut Evaluator, basis: &Basis, start: Start, iterations: u64) -> Result<Outcome, Halt> {
    evaluator.begin(None);
    evaluator.stage("gradient search");
    let parameters = evaluator.problem.parameters();
    let begin = shares(parameters, &start.point(parameters));
    let solver = Lbfgsb::<Vec<f64>>::new().with_absolute_projected_gradient_tolerance(1e-7);
    let stopped = Cell::new(false);
    let [zero, one] = [0.0, 1.0].map(|end| vec![end; begin.len()]);
    let sought = Sought { evaluator: RefCell::new(&mut *evaluator), basis, zero, one, stopped: &stopped };
    let ended = Executor::from_start(sought, solver, begin).max_iter(iterations.max(1)).run();
    if stopped.get() {
        return Err(Halt::Stopped);
    }
    let lowest = ended.ok().map(|ended| {
        let converged = ended.report.termination.is_converged();
        (values(parameters, ended.best_param()), ended.best_cost(), converged, format!("{:?}", ended.report.code()))
    });
    let Some((point, cost, converged, ended)) = lowest.filter(|lowest| lowest.1.is_finite()) else {
        return Err(Halt::Failed(Failure::new("no-start", "the model fails at the start")));
    };
    end(evaluator, basis, (&point, cost.sqrt()), converged, ended)
}

/// The square of the norm over the shares. There is one run and nothing to advance beside it, so that every point is evaluated when it is asked
/// for: the cost of the search grows with its evaluations and not with their square.
struct Sought<'s, 'a> {
    evaluator: RefCell<&'s mut Evaluator<'a>>,
    basis: &'s Basis,
    zero: Vec<f64>,
    one: Vec<f64>,
    stopped: &'s Cell<bool>,
}

impl Sought<'_, '_> {
    /// What is read of the answers at some shares, in their order.
    fn answers<T>(
        &self,
        shares: &[Vec<f64>],
        read: impl Fn(&Evaluator, &Evaluation) -> Option<T>,
    ) -> Result<Vec<Option<T>>, Stopped> {
        let mut evaluator = self.evaluator.borrow_mut();
        let parameters = evaluator.problem.parameters();
        let points: Vec<Vec<f64>> = shares.iter().map(|shares| values(parameters, shares)).collect();
        let request = self.basis.request(evaluator.has_sensitivities(&self.basis.samples));
        let answers = evaluator.respond(&points, &request).inspect_err(|_| self.stopped.set(true))?;
        Ok(answers.iter().map(|answer| read(&evaluator, answer)).collect())
    }

    /// Residuals; none where the model failed.
    fn residuals(&self, shares: &[Vec<f64>]) -> Result<Vec<Option<Vec<f64>>>, Stopped> {
        self.answers(shares, |evaluator, answer| {
            Some(residuals(evaluator.problem, &self.basis.held, answer.as_ref().ok()?))
        })
    }

    /// Columns of derivatives of the residuals; none where the model failed.
    fn columns(&self, shares: &[f64]) -> Result<Option<Vec<Vec<f64>>>, Stopped> {
        let own = self.evaluator.borrow().has_sensitivities(&self.basis.samples);
        if own {
            let found = self.answers(&[shares.to_vec()], |evaluator, answer| {
                let problem = evaluator.problem;
                let columns = residual_derivatives(problem, &self.basis.held, answer.as_ref().ok()?);
                Some(by_shares(problem.parameters(), shares, columns))
            });
            return Ok(found?.pop().flatten());
        }
        let found: Option<Vec<_>> = self.residuals(&points(shares, STEP))?.into_iter().collect();
        Ok(found.map(|found| by_differences(shares, STEP, found)))
    }
}

impl Constraints for Sought<'_, '_> {
    type Set = basin::ConstraintSet<BoxBounds<Vec<f64>>>;

    fn constraints(&self) -> <Self::Set as basin::ConstraintDescription>::Borrowed<'_> {
        basin::ConstraintSet::new().with_bounds(BoxBounds::new(Some(&self.zero), Some(&self.one)))
    }
}

impl CostFunction for Sought<'_, '_> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Stopped;

    fn cost(&self, shares: &Vec<f64>) -> Result<f64, Stopped> {
        let found = self.residuals(std::slice::from_ref(shares))?.pop().flatten();
        Ok(found.map_or(f64::INFINITY, |residuals| residuals.iter().map(|r| r * r).sum()))
    }
}

impl Gradient for Sought<'_, '_> {
    type Gradient = Vec<f64>;

    fn gradient(&self, shares: &Vec<f64>) -> Result<Vec<f64>, Stopped> {
        let residuals = self.residuals(std::slice::from_ref(shares))?.pop().flatten();
        let (Some(residuals), Some(columns)) = (residuals, self.columns(shares)?) else {
            return Ok(vec![f64::NAN; shares.len()]);
        };
        let slope = |column: &Vec<f64>| 2.0 * column.iter().zip(&residuals).map(|(a, b)| a * b).sum::<f64>();
        Ok(columns.iter().map(slope).collect())
    }
}
