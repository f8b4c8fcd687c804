//! A plain gradient search from one start (L-BFGS-B on the square of the norm): what a general program offers, and what
//! the paper compares with. It ends in the minimum into whose valley it happens to start.

use std::cell::RefCell;

use basin::{BoxBounds, ConstraintSolveError, Constraints, CostFunction, Executor, Gradient, Lbfgsb};

use crate::basis::{Basis, Halt, answer, unless_failed};
use crate::evaluator::Evaluator;
use crate::forward::{Failure, Response};
use crate::identify::columns;
use crate::misfit::{residual_derivatives, residuals};
use crate::parameter::{Start, shares, values};
use crate::search::jacobian::STEP;
pub use crate::search::modern::End as Outcome;
use crate::search::modern::end;
use crate::watch::Stopped;

/// Goes downhill from a start, for at most so many iterations.
pub fn search(evaluator: &mut Evaluator, basis: &Basis, start: Start, iterations: u64) -> Outcome {
    run(evaluator, basis, start, iterations).unwrap_or_else(Outcome::from)
}

fn run(evaluator: &mut Evaluator, basis: &Basis, start: Start, iterations: u64) -> Result<Outcome, Halt> {
    evaluator.begin(None);
    evaluator.stage = "gradient search".into();
    let parameters = evaluator.problem.parameters();
    let begin = shares(parameters, &start.point(parameters));
    let solver = Lbfgsb::<Vec<f64>>::new().with_absolute_projected_gradient_tolerance(1e-7);
    let [zero, one] = [0.0, 1.0].map(|end| vec![end; begin.len()]);
    let sought = Sought { evaluator: RefCell::new(&mut *evaluator), basis, zero, one };
    let ended = match Executor::from_start(sought, solver, begin).max_iter(iterations.max(1)).run() {
        Err(ConstraintSolveError::Evaluation(Stopped)) => return Err(Halt::Stopped),
        ended => ended.ok(),
    };
    let lowest = ended.map(|ended| {
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
}

impl Sought<'_, '_> {
    /// Residuals; none where the model failed.
    fn residuals(&self, shares: &[f64]) -> Result<Option<Vec<f64>>, Stopped> {
        let mut evaluator = self.evaluator.borrow_mut();
        let point = values(evaluator.problem.parameters(), shares);
        let request = self.basis.request(evaluator.forward.has_sensitivities(&self.basis.samples));
        let found = unless_failed(answer(&mut evaluator, &point, &request))?;
        Ok(found.map(|response| residuals(evaluator.problem, &self.basis.held, &response)))
    }

    /// Columns of derivatives of the residuals; none where the model failed.
    fn columns(&self, shares: &[f64]) -> Result<Option<Vec<Vec<f64>>>, Stopped> {
        let mut evaluator = self.evaluator.borrow_mut();
        let (problem, held) = (evaluator.problem, &self.basis.held);
        let point = values(problem.parameters(), shares);
        let numbers = |response: &Response| residuals(problem, held, response);
        let own = |response: &Response| residual_derivatives(problem, held, response);
        unless_failed(columns(&mut evaluator, self.basis, (shares, &point), STEP, &numbers, &own))
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
        Ok(self.residuals(shares)?.map_or(f64::INFINITY, |residuals| residuals.iter().map(|r| r * r).sum()))
    }
}

impl Gradient for Sought<'_, '_> {
    type Gradient = Vec<f64>;

    fn gradient(&self, shares: &Vec<f64>) -> Result<Vec<f64>, Stopped> {
        let (Some(residuals), Some(columns)) = (self.residuals(shares)?, self.columns(shares)?) else {
            return Ok(vec![f64::NAN; shares.len()]);
        };
        let slope = |column: &Vec<f64>| 2.0 * column.iter().zip(&residuals).map(|(a, b)| a * b).sum::<f64>();
        Ok(columns.iter().map(slope).collect())
    }
}
