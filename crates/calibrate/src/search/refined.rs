//! From the end of a search by slices on to that of full passages.
//!
//! A slice remembers no earlier axle, a passage does: the two ends differ. Derivatives differ little, and slices give them exactly. So each step here is that of
//! least squares with the residuals of a full passage and the derivatives of the slices where it began, brought up to date by
//! every passage that was seen since (Broyden 1965), inside the ranges and inside a radius that grows with success. A round costs one full
//! passage. Records that no model meets leave a norm, and then derivatives have to be right: differences of full passages end it.

use basin::{BoxBounds, Constraints, DenseMatrix, Executor, Jacobian, Residual, TrustRegionReflective};

use crate::basis::{Basis, Halt, full_passage, unless_failed};
use crate::evaluator::Evaluator;
use crate::forward::Samples;
use crate::identify::sensitivities;
use crate::misfit::residuals;
use crate::parameter::{shares, values};
use crate::search::jacobian::STEP;
use crate::search::modern::RunEnd;

/// Most full passages.
const ROUNDS: usize = 20;

/// A step shorter than this share of every range ends it: a tenth of the half per cent of a value that a twin has to be found to.
const SETTLED: f64 = 2e-4;

/// Norm below which errors of the derivatives shift nothing.
const NOTHING: f64 = 1e-3;

/// First radius, as a share of the ranges.
const RADIUS: f64 = 0.25;

/// Nearer to an end of its range than this share, a parameter is put on it: the solver stays strictly inside.
const ON_BOUND: f64 = 1e-4;

/// Goes on from the end of a run; where nothing settles, the best point that was seen and why it is not called converged.
pub(super) fn settle(evaluator: &mut Evaluator, basis: &Basis, from: &RunEnd) -> Result<RunEnd, Halt> {
    let parameters = evaluator.problem.parameters();
    evaluator.stage = "on by full passages".into();
    let corrected = basis.corrected(evaluator, &from.end)?;
    let columns = sensitivities(evaluator, &corrected, &from.end, STEP)?;
    let whole = Basis { samples: Samples::All, ..basis.clone() };
    let mut ask = |at: &[f64], wanted: Wanted| -> Result<Vec<Vec<f64>>, Halt> {
        let point = values(parameters, at);
        match wanted {
            Wanted::Residuals => {
                let found = unless_failed(full_passage(evaluator, &point))?;
                // A step to where the model has no answer was too long.
                let none = || vec![f64::INFINITY];
                Ok(vec![found.map_or_else(none, |response| residuals(evaluator.problem, &basis.held, &response))])
            }
            Wanted::Derivatives => sensitivities(evaluator, &whole, &point, STEP),
        }
    };
    let (here, norm, settled) = descend(shares(parameters, &from.end), columns, &mut ask)?;
    let ended = if settled { "Settled" } else { "full passages did not settle" }.to_owned();
    let end = values(parameters, &here);
    Ok(RunEnd { start: from.start.clone(), end, norm, converged: settled && from.converged, ended })
}

/// What is asked of full passages at a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Wanted {
    /// One row; infinite where the model has no answer.
    Residuals,
    /// A row for each axis.
    Derivatives,
}

/// Rows that full passages answer at a point.
type Ask<'a> = dyn FnMut(&[f64], Wanted) -> Result<Vec<Vec<f64>>, Halt> + 'a;

/// Goes down from a point with derivatives that need not be quite those of the residuals; where it settled with a norm left, their errors would shift it, and
/// it goes on once with the residuals' own.
fn descend(mut here: Vec<f64>, mut columns: Vec<Vec<f64>>, ask: &mut Ask<'_>) -> Result<(Vec<f64>, f64, bool), Halt> {
    let mut right = ask(&here, Wanted::Residuals)?.pop().unwrap_or_default();
    let (mut radius, mut exact) = (RADIUS, false);
    for _ in 0..ROUNDS {
        let there = step(&here, &right, &columns, radius);
        let way: Vec<f64> = there.iter().zip(&here).map(|(there, here)| there - here).collect();
        let moved = way.iter().fold(0.0_f64, |most, way| most.max(way.abs()));
        if moved > 0.0 {
            let found = ask(&there, Wanted::Residuals)?.pop().unwrap_or_default();
            if norm(&found).is_finite() {
                update(&mut columns, &way, &right, &found);
            }
            if norm(&found) < norm(&right) {
                (here, right) = (there, found);
                radius = (2.0 * radius).min(1.0);
            } else {
                radius = 0.5 * moved;
            }
        }
        if moved < SETTLED {
            if exact || norm(&right) < NOTHING {
                return Ok((here, norm(&right), true));
            }
            (columns, radius, exact) = (ask(&here, Wanted::Derivatives)?, RADIUS, true);
        }
    }
    let left = norm(&right);
    Ok((here, left, false))
}

fn norm(residuals: &[f64]) -> f64 {
    residuals.iter().map(|r| r * r).sum::<f64>().sqrt()
}

/// The derivatives that would have foreseen what was found, and differ least from those at hand.
fn update(columns: &mut [Vec<f64>], way: &[f64], before: &[f64], found: &[f64]) {
    let square: f64 = way.iter().map(|w| w * w).sum();
    let missed: Vec<f64> = (0..found.len())
        .map(|i| found[i] - before[i] - columns.iter().zip(way).map(|(column, w)| column[i] * w).sum::<f64>())
        .collect();
    for (column, w) in columns.iter_mut().zip(way) {
        column.iter_mut().zip(&missed).for_each(|(entry, missed)| *entry += missed * w / square);
    }
}

/// Where the linear residuals are least, within the ranges and a radius.
fn step(here: &[f64], right: &[f64], columns: &[Vec<f64>], radius: f64) -> Vec<f64> {
    let low: Vec<f64> = here.iter().map(|h| (h - radius).max(0.0)).collect();
    let high: Vec<f64> = here.iter().map(|h| (h + radius).min(1.0)).collect();
    let linear = Linear { here, right, columns, low: &low, high: &high };
    let solver = TrustRegionReflective::new().with_absolute_scaled_gradient_tolerance(1e-14);
    let ended = Executor::from_start(linear, solver, here.to_vec()).max_iter(200).run();
    let Ok(ended) = ended else { return here.to_vec() };
    let inside = |share: &f64| match *share {
        share if share < ON_BOUND => 0.0,
        share if share > 1.0 - ON_BOUND => 1.0,
        share => share,
    };
    ended.best_param().iter().map(inside).collect()
}

/// Linear least squares in a box.
struct Linear<'l> {
    here: &'l [f64],
    right: &'l [f64],
    columns: &'l [Vec<f64>],
    low: &'l Vec<f64>,
    high: &'l Vec<f64>,
}

impl Constraints for Linear<'_> {
    type Set = basin::ConstraintSet<BoxBounds<Vec<f64>>>;

    fn constraints(&self) -> <Self::Set as basin::ConstraintDescription>::Borrowed<'_> {
        basin::ConstraintSet::new().with_bounds(BoxBounds::new(Some(self.low), Some(self.high)))
    }
}

impl Residual for Linear<'_> {
    type Param = Vec<f64>;
    type Output = Vec<f64>;
    type Error = std::convert::Infallible;

    fn residual(&self, shares: &Vec<f64>) -> Result<Vec<f64>, Self::Error> {
        let mut all = self.right.to_vec();
        for ((column, share), here) in self.columns.iter().zip(shares).zip(self.here) {
            all.iter_mut().zip(column).for_each(|(sum, entry)| *sum += entry * (share - here));
        }
        Ok(all)
    }
}

impl Jacobian for Linear<'_> {
    type Jacobian = DenseMatrix;

    fn jacobian(&self, _: &Vec<f64>) -> Result<DenseMatrix, Self::Error> {
        let (rows, n) = (self.right.len(), self.columns.len());
        let data: Vec<f64> = (0..rows * n).map(|k| self.columns[k % n][k / n]).collect();
        Ok(DenseMatrix::from_row_slice(rows, n, &data))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Residuals that are all but linear, least on an end of a range.
    fn residuals_at(x: &[f64]) -> Vec<f64> {
        vec![x[0] + 0.5 * x[1] - 0.9 + 0.05 * x[0] * x[0], 0.3 * x[0] - x[1] + 0.75, 0.1 * x[0] + 0.2 * x[1] - 0.3]
    }

    #[test]
    fn derivatives_that_are_a_third_off_end_in_the_minimum() {
        let columns = vec![vec![0.7, 0.4, 0.1], vec![0.6, -0.8, 0.25]];
        let mut passages = 0;
        let mut ask = |x: &[f64], wanted: Wanted| {
            passages += 1;
            Ok(match wanted {
                Wanted::Residuals => vec![residuals_at(x)],
                Wanted::Derivatives => vec![vec![1.0 + 0.1 * x[0], 0.3, 0.1], vec![0.5, -1.0, 0.2]],
            })
        };
        let (here, left, settled) = descend(vec![0.9, 0.1], columns, &mut ask).unwrap();
        assert!(settled && passages < 20, "{passages}");
        let at = |x: f64, y: f64| norm(&residuals_at(&[x, y]));
        assert_eq!(at(here[0], here[1]), left);
        // A step that ends it is shorter than this.
        let near = 5.0 * SETTLED;
        for (dx, dy) in [(near, 0.0), (-near, 0.0), (0.0, near), (0.0, -near), (near, near), (-near, -near)] {
            assert!(at(here[0] + dx, here[1] + dy) >= left, "{here:?} {left} {dx} {dy}");
        }
    }

    #[test]
    fn steps_to_where_there_is_no_answer_are_shortened() {
        let mut refused = 0;
        let mut ask = |x: &[f64], wanted: Wanted| {
            // The first whole step from 0.1 would go beyond.
            let fails = x[1] > 0.3 && refused == 0;
            refused += usize::from(fails);
            Ok(match wanted {
                Wanted::Residuals if fails => vec![vec![f64::INFINITY]],
                Wanted::Residuals => vec![residuals_at(x)],
                Wanted::Derivatives => vec![vec![1.0 + 0.1 * x[0], 0.3, 0.1], vec![0.5, -1.0, 0.2]],
            })
        };
        let exact = vec![vec![1.05, 0.3, 0.1], vec![0.5, -1.0, 0.2]];
        let (here, left, settled) = descend(vec![0.5, 0.1], exact, &mut ask).unwrap();
        assert!(settled && left.is_finite() && refused == 1, "{here:?} {left} {refused}");
        assert!(here[1] > 0.8, "{here:?}");
    }

    #[test]
    fn a_step_meets_the_end_of_a_range() {
        let there = step(&[0.8, 0.5], &[-1.0, 0.0], &[vec![1.0, 0.0], vec![0.0, 1.0]], 0.5);
        assert_eq!(there[0], 1.0);
        assert!((there[1] - 0.5).abs() < 1e-6);
    }
}
