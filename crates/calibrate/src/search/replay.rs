//! Library solvers over a log: a solver is run from its beginning until it asks for a point that is not known; what all
//! runs miss is evaluated in one batch; then they are run again. A solver is a function of the answers, so that it walks
//! the same way every time, and what costs is the model alone.
//!
//! So many starts advance together through the caller's map, a stopped search goes on from its log, and no thread is seen
//! by any solver.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use basin::{BoxBounds, Constraints, CostFunction, DenseMatrix, Jacobian, Residual};

use crate::basis::Basis;
use crate::evaluator::Evaluator;
use crate::forward::Evaluation;
use crate::misfit::{residual_count, residual_derivatives, residuals};
use crate::parameter::values;
use crate::search::jacobian::{by_differences, by_shares, points};
use crate::watch::Stopped;

/// The solver asked for something that is not known yet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Missing;

/// What costs were found, by the bits of the shares; kept over repeated runs.
pub(super) type Costs = RefCell<BTreeMap<Vec<u64>, f64>>;

/// The answers known so far, as solvers ask for them.
pub(super) struct Known<'e, 'a> {
    evaluator: &'e Evaluator<'a>,
    basis: &'e Basis,
    step: f64,
    count: usize,
    /// What was asked for in vain.
    pub missing: RefCell<Vec<Vec<f64>>>,
    /// What was answered, by its bits.
    pub used: RefCell<BTreeSet<Vec<u64>>>,
}

impl<'e, 'a> Known<'e, 'a> {
    pub(super) fn new(evaluator: &'e Evaluator<'a>, basis: &'e Basis, step: f64) -> Self {
        let count = residual_count(evaluator.problem, &basis.held, |channel| evaluator.forward.length(channel));
        let (missing, used) = (RefCell::default(), RefCell::default());
        Self { evaluator, basis, step, count, missing, used }
    }

    fn answer<T>(&self, shares: &[f64], read: impl Fn(&Evaluation) -> T) -> Result<T, Missing> {
        let point = values(self.evaluator.problem.parameters(), shares);
        let request = self.basis.request(self.evaluator.forward.has_sensitivities(&self.basis.samples));
        match self.evaluator.log.get(&point, &request) {
            Some(evaluation) => {
                self.used.borrow_mut().insert(point.iter().map(|value| value.to_bits()).collect());
                Ok(read(&evaluation))
            }
            None => {
                self.missing.borrow_mut().push(point);
                Err(Missing)
            }
        }
    }

    /// Residuals; all infinite where the model failed, which solvers reject.
    pub(super) fn residuals(&self, shares: &[f64]) -> Result<Vec<f64>, Missing> {
        let read = |evaluation: &Evaluation| match evaluation {
            Ok(response) => residuals(self.evaluator.problem, &self.basis.held, response),
            Err(_) => vec![f64::INFINITY; self.count],
        };
        self.answer(shares, read)
    }

    /// Columns of derivatives with respect to the shares.
    pub(super) fn jacobian(&self, shares: &[f64]) -> Result<Vec<Vec<f64>>, Missing> {
        if !self.evaluator.forward.has_sensitivities(&self.basis.samples) {
            // All points are asked for before the first that is missing breaks it off.
            let found: Vec<_> = points(shares, self.step).iter().map(|at| self.residuals(at)).collect();
            return Ok(by_differences(shares, self.step, found.into_iter().collect::<Result<Vec<_>, _>>()?));
        }
        let read = |evaluation: &Evaluation| match evaluation {
            Ok(response) => residual_derivatives(self.evaluator.problem, &self.basis.held, response),
            Err(_) => vec![vec![f64::NAN; self.count]; shares.len()],
        };
        Ok(by_shares(self.evaluator.problem.parameters(), shares, self.answer(shares, read)?))
    }
}

/// Evaluates points as solvers ask for them.
pub(super) fn supply(evaluator: &mut Evaluator, basis: &Basis, points: &[Vec<f64>]) -> Result<(), Stopped> {
    let request = basis.request(evaluator.forward.has_sensitivities(&basis.samples));
    evaluator.respond(points, &request).map(|_| ())
}

/// Counts what was used as evaluations of the present search, whether or not the log knew it before.
pub(super) fn count(evaluator: &mut Evaluator, basis: &Basis, used: BTreeSet<Vec<u64>>) -> Result<(), Stopped> {
    let points: Vec<Vec<f64>> = used.into_iter().map(|bits| bits.into_iter().map(f64::from_bits).collect()).collect();
    supply(evaluator, basis, &points)
}

/// Runs `solve` for each of `runs` until all have ended, whatever they miss supplied in common batches.
pub(super) fn replay<T>(
    evaluator: &mut Evaluator,
    basis: &Basis,
    step: f64,
    runs: usize,
    solve: impl Fn(usize, &Known) -> Result<T, Missing>,
) -> Result<Vec<T>, Stopped> {
    let mut ends: Vec<Option<T>> = (0..runs).map(|_| None).collect();
    let mut all_used = BTreeSet::new();
    loop {
        let known = Known::new(evaluator, basis, step);
        for run in 0..runs {
            if ends[run].is_none() {
                ends[run] = solve(run, &known).ok();
            }
        }
        all_used.extend(known.used.take());
        let missing = known.missing.take();
        supply(evaluator, basis, &missing)?;
        if missing.is_empty() {
            break;
        }
    }
    count(evaluator, basis, all_used)?;
    Ok(ends.into_iter().flatten().collect())
}

/// The problem in the words of the library of solvers: shares between zero and one.
pub(super) struct Sought<'k, 'e, 'a> {
    known: &'k Known<'e, 'a>,
    zero: Vec<f64>,
    one: Vec<f64>,
    /// Costs found before, and the count of points that may be missing before the solver is broken off.
    costs: Option<(&'k Costs, usize)>,
}

impl<'k, 'e, 'a> Sought<'k, 'e, 'a> {
    /// Breaks off at the first point that is not known.
    pub(super) fn new(known: &'k Known<'e, 'a>) -> Self {
        let n = known.evaluator.problem.parameters().len();
        Self { known, zero: vec![0.0; n], one: vec![1.0; n], costs: None }
    }

    /// Goes on, with an infinite cost, until so many points are missing: for solvers that draw a whole population before
    /// they look at any cost.
    pub(super) fn drawing(known: &'k Known<'e, 'a>, costs: &'k Costs, population: usize) -> Self {
        Self { costs: Some((costs, population)), ..Self::new(known) }
    }
}

impl Constraints for Sought<'_, '_, '_> {
    type Set = basin::ConstraintSet<BoxBounds<Vec<f64>>>;

    fn constraints(&self) -> <Self::Set as basin::ConstraintDescription>::Borrowed<'_> {
        basin::ConstraintSet::new().with_bounds(BoxBounds::new(Some(&self.zero), Some(&self.one)))
    }
}

impl CostFunction for Sought<'_, '_, '_> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Missing;

    fn cost(&self, shares: &Vec<f64>) -> Result<f64, Missing> {
        let square = |residuals: Vec<f64>| residuals.iter().map(|r| r * r).sum::<f64>();
        let Some((costs, population)) = self.costs else {
            return self.known.residuals(shares).map(square);
        };
        let key: Vec<u64> = shares.iter().map(|share| share.to_bits()).collect();
        if let Some(cost) = costs.borrow().get(&key) {
            return Ok(*cost);
        }
        match self.known.residuals(shares).map(square) {
            Ok(cost) => {
                costs.borrow_mut().insert(key, cost);
                Ok(cost)
            }
            Err(Missing) if self.known.missing.borrow().len() < population => Ok(f64::INFINITY),
            Err(Missing) => Err(Missing),
        }
    }
}

impl Residual for Sought<'_, '_, '_> {
    type Param = Vec<f64>;
    type Output = Vec<f64>;
    type Error = Missing;

    fn residual(&self, shares: &Vec<f64>) -> Result<Vec<f64>, Missing> {
        self.known.residuals(shares)
    }
}

impl Jacobian for Sought<'_, '_, '_> {
    type Jacobian = DenseMatrix;

    fn jacobian(&self, shares: &Vec<f64>) -> Result<DenseMatrix, Missing> {
        let columns = self.known.jacobian(shares)?;
        let (rows, n) = (self.known.count, columns.len());
        let entry = |k: usize| columns[k % n].get(k / n).copied().unwrap_or(f64::NAN);
        let data: Vec<f64> = (0..rows * n).map(entry).collect();
        Ok(DenseMatrix::from_row_slice(rows, n, &data))
    }
}

/// A run that a solver broke off. Refused bounds, the other error of the library, cannot occur: they are zero and one.
pub(super) fn broken_off(_: basin::ConstraintSolveError<Missing>) -> Missing {
    Missing
}
