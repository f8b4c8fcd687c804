//! The system matrix of Newton's method on the forces of some rows, `1 - S G`.
//!
//! `S` is the excess stiffness, the derivatives of the excess forces by the row values [N/m²]; `G` is the flexibility between the
//! rows [m²/N].

use super::dense::{Dense, Precision};
use crate::wide::wide;
use std::ops::Range;

/// One entry of `S`: row, column, derivative [N/m²]; rows and columns are counted within the system at hand.
pub(super) type StiffnessEntry = (usize, usize, f64);

/// `1 - S G`, factorised on the rows whose row of `S` is not empty, a few hundred. On the other rows the matrix is the identity,
/// and the step is the right-hand side.
#[derive(Default)]
pub(super) struct Tangent<D> {
    /// The rows whose row of `S` is not empty, in ascending order.
    pub nonlinear_rows: Vec<usize>,
    /// `S` by entries.
    stiffness: Vec<StiffnessEntry>,
    /// Index of a row among the nonlinear ones.
    index_of: Vec<usize>,
    factors: Dense<D>,
    gathered: Gathered<D>,
}

impl<D: Precision> Tangent<D> {
    /// Builds and factorises `1 - S G` for the entries `stiffness` of `S` and the rows `flexibility` of `G`.
    pub(super) fn factorise_for(&mut self, stiffness: &[StiffnessEntry], flexibility: &[Vec<f64>]) {
        self.nonlinear_rows.clear();
        self.nonlinear_rows.extend(stiffness.iter().map(|(p, _, _)| *p));
        self.nonlinear_rows.sort_unstable();
        self.nonlinear_rows.dedup();
        self.index_of.clear();
        self.index_of.resize(flexibility.len(), 0);
        self.nonlinear_rows.iter().enumerate().for_each(|(i, &p)| self.index_of[p] = i);
        self.stiffness.clear();
        self.stiffness.extend_from_slice(stiffness);
        wide(
            #[inline(always)]
            || self.subtract_product(flexibility),
        );
        self.factors.factorise();
    }

    /// Subtracts `S G` from the identity.
    #[inline(always)]
    fn subtract_product(&mut self, flexibility: &[Vec<f64>]) {
        let size = self.nonlinear_rows.len();
        let (factors, Gathered { rows, index, runs }) = (self.factors.set_identity(size), &mut self.gathered);
        rows.clear();
        index.clear();
        index.resize(flexibility.len(), u32::MAX);
        runs.clear();
        for &p in &self.nonlinear_rows {
            match runs.last_mut().filter(|run| run.end == p) {
                Some(run) => run.end += 1,
                None => runs.push(p..p + 1),
            }
        }
        let mut count = 0;
        for &(_, q, _) in &self.stiffness {
            if index[q] != u32::MAX {
                continue;
            }
            index[q] = count;
            count += 1;
            for run in runs.iter() {
                rows.extend(flexibility[q][run.clone()].iter().map(|g| D::from_f64_impl(*g)));
            }
        }
        // Entries of one row four at a time: the row of the system is read and written once for four.
        for stiffness in self.stiffness.chunk_by(|one, other| one.0 == other.0) {
            let to = self.index_of[stiffness[0].0] * size;
            let to = &mut factors[to..to + size];
            let from = |&(_, q, s): &StiffnessEntry| (&rows[index[q] as usize * size..][..size], D::from_f64_impl(s));
            for some in stiffness.chunks(4) {
                if let [a, b, c, d] = some {
                    let [(a, fa), (b, fb), (c, fc), (d, fd)] = [a, b, c, d].map(from);
                    for ((((entry, a), b), c), d) in to.iter_mut().zip(a).zip(b).zip(c).zip(d) {
                        *entry -= (fa * *a + fb * *b) + (fc * *c + fd * *d);
                    }
                } else {
                    for (from, s) in some.iter().map(from) {
                        to.iter_mut().zip(from).for_each(|(entry, g)| *entry -= s * *g);
                    }
                }
            }
        }
    }

    /// Solves `(1 - S G) step = right` for the change `step` of the forces [N/m]. `row_changes` are the changes of all row values
    /// [m] by the part of the step on rows with an empty row of `S`, which is known, and by whatever else changes them.
    pub(super) fn solve(&mut self, right: &[f64], row_changes: &[f64]) -> Vec<f64> {
        let mut rest: Vec<f64> = self.nonlinear_rows.iter().map(|&p| right[p]).collect();
        for &(p, q, s) in &self.stiffness {
            rest[self.index_of[p]] += s * row_changes[q];
        }
        self.factors.solve(&mut rest);
        let mut step = right.to_vec();
        self.nonlinear_rows.iter().zip(rest).for_each(|(&p, x)| step[p] = x);
        step
    }

    /// Solves `(1 - S G) step = e_r` for each row `r` of `rows` in turn.
    pub(super) fn unit_steps(&mut self, rows: &[usize], flexibility: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let size = self.nonlinear_rows.len();
        let mut right = vec![0.0; size * rows.len()];
        let is_nonlinear = |row: usize| self.nonlinear_rows.binary_search(&row).is_ok();
        for (k, &row) in rows.iter().enumerate() {
            let right = &mut right[k * size..(k + 1) * size];
            if is_nonlinear(row) {
                right[self.index_of[row]] = 1.0;
            } else {
                self.stiffness.iter().for_each(|&(p, q, s)| right[self.index_of[p]] += s * flexibility[row][q]);
            }
        }
        self.factors.solve(&mut right);
        let column = |(k, &row): (usize, &usize)| {
            let mut step = vec![0.0; flexibility.len()];
            step[row] = 1.0;
            self.nonlinear_rows.iter().zip(&right[k * size..]).for_each(|(&p, x)| step[p] = *x);
            step
        };
        rows.iter().enumerate().map(column).collect()
    }
}

/// The rows of `G` that the columns of `S` need, at the nonlinear rows alone.
#[derive(Default)]
struct Gathered<D> {
    rows: Vec<D>,
    /// Index of a row among them.
    index: Vec<u32>,
    /// The nonlinear rows, as ranges of consecutive numbers.
    runs: Vec<Range<usize>>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_step_solves_the_system() {
        let flexibility: Vec<Vec<f64>> =
            (0..5).map(|i| (0..5).map(|j| 1.0 / (1.0 + i as f64 + j as f64)).collect()).collect();
        // Five entries in one row, more than are taken at a time.
        let full = [0.3, -0.7, 0.05, -0.1, 0.02].into_iter().enumerate().map(|(q, s)| (1, q, s));
        let stiffness: Vec<StiffnessEntry> = full.chain([(3, 2, 0.4), (3, 1, 0.9), (4, 3, -0.2)]).collect();
        let right = [1.0, -2.0, 0.5, 3.0, 0.25];
        let mut tangent = Tangent::<f64>::default();
        tangent.factorise_for(&stiffness, &flexibility);
        assert_eq!(tangent.nonlinear_rows, [1, 3, 4]);
        let moved = |step: &[f64]| -> Vec<f64> {
            flexibility.iter().map(|row| row.iter().zip(step).map(|(a, s)| a * s).sum()).collect()
        };
        let left = |step: &[f64], right: &[f64]| {
            let values = moved(step);
            let mut left: Vec<f64> = step.iter().zip(right).map(|(step, right)| step - right).collect();
            stiffness.iter().for_each(|&(p, q, s)| left[p] -= s * values[q]);
            left.iter().fold(0.0_f64, |most, left| most.max(left.abs()))
        };
        let mut row_changes = right.to_vec();
        tangent.nonlinear_rows.iter().for_each(|&p| row_changes[p] = 0.0);
        let step = tangent.solve(&right, &moved(&row_changes));
        assert!(left(&step, &right) < 1e-14);
        // A unit right-hand side on a nonlinear row, and on another one.
        for (row, step) in [3, 2].into_iter().zip(tangent.unit_steps(&[3, 2], &flexibility)) {
            let mut right = [0.0; 5];
            right[row] = 1.0;
            assert!(left(&step, &right) < 1e-14, "row {row}");
        }
    }
}
