//! A low-rank update of the factorised tangent: from one iteration of Newton's method to the next few parts change their excess
//! stiffness.
//!
//! With `M` the tangent that is factorised, `D` the change of the excess stiffness, which is empty but for a few rows, and `Z`
//! the solutions of `M` for a one on each of these rows (Woodbury's identity)
//!
//! ```text
//! (M - D G)^-1 b = y + Z (1 - D G Z)^-1 D G y,   y = M^-1 b
//! ```

use super::dense::Dense;
use super::rows::{add_multiples, dots};
use super::tangent::{StiffnessEntry, Tangent};

/// Marks a row or part without an index.
pub(super) const NO_INDEX: u32 = u32::MAX;

/// The change `D` of the excess stiffness since the tangent was factorised, and what its solution needs.
#[derive(Default)]
pub(super) struct LowRankUpdate {
    /// Rows for which `Z` has a column, the columns, and the column of a row.
    rows: Vec<usize>,
    columns: Vec<Vec<f64>>,
    column_of: Vec<u32>,
    /// Rows at which `G Z` is read, their indices, and `G Z` there: for each of them by columns.
    reads: Vec<usize>,
    read_of: Vec<u32>,
    read_values: Vec<Vec<f64>>,
    /// `D`: row by its index among the columns in use, column by its index among the reads.
    changes: Vec<StiffnessEntry>,
    columns_in_use: Vec<usize>,
    /// The reads in use, and the index of each among them.
    reads_in_use: Vec<usize>,
    index_in_use: Vec<u32>,
    /// `1 - D G Z`.
    capacitance: Dense<f64>,
}

impl LowRankUpdate {
    /// Drops the update and its columns: another tangent is factorised now.
    pub(super) fn reset(&mut self) {
        let (capacitance, columns) = (std::mem::take(&mut self.capacitance), std::mem::take(&mut self.columns));
        *self = LowRankUpdate { capacitance, columns, ..LowRankUpdate::default() };
        self.columns.clear();
    }

    /// Takes the entries `changes` as `D`. Gives `false`, and leaves the update as it was, if they are in more than `most` rows.
    pub(super) fn build(
        &mut self,
        changes: &[StiffnessEntry],
        most: usize,
        tangent: &mut Tangent<f32>,
        flexibility: &[Vec<f64>],
    ) -> bool {
        let mut rows: Vec<usize> = changes.iter().map(|(p, _, _)| *p).collect();
        rows.sort_unstable();
        rows.dedup();
        if rows.len() > most {
            return false;
        }
        self.solve_new_columns(changes, tangent, flexibility);
        let mut index_of = vec![NO_INDEX; self.columns.len()];
        self.columns_in_use.clear();
        self.changes.clear();
        self.reads_in_use.clear();
        self.index_in_use.clear();
        self.index_in_use.resize(self.reads.len(), NO_INDEX);
        for &(p, q, s) in changes {
            let column = self.column_of[p] as usize;
            if index_of[column] == NO_INDEX {
                index_of[column] = self.columns_in_use.len() as u32;
                self.columns_in_use.push(column);
            }
            let read = self.read_of[q] as usize;
            if self.index_in_use[read] == NO_INDEX {
                self.index_in_use[read] = self.reads_in_use.len() as u32;
                self.reads_in_use.push(read);
            }
            self.changes.push((index_of[column] as usize, read, s));
        }
        let size = self.columns_in_use.len();
        let entries = self.capacitance.set_identity(size);
        for &(i, read, s) in &self.changes {
            let (row, read_values) = (&mut entries[i * size..(i + 1) * size], &self.read_values[read]);
            row.iter_mut().zip(&self.columns_in_use).for_each(|(entry, &column)| *entry -= s * read_values[column]);
        }
        self.capacitance.factorise();
        true
    }

    /// Solves for the columns of `Z` that are not known yet, and reads `G Z` where it was not read.
    fn solve_new_columns(&mut self, changes: &[StiffnessEntry], tangent: &mut Tangent<f32>, flexibility: &[Vec<f64>]) {
        self.column_of.resize(flexibility.len(), NO_INDEX);
        self.read_of.resize(flexibility.len(), NO_INDEX);
        let (columns, reads) = (self.columns.len(), self.reads.len());
        for &(p, q, _) in changes {
            if self.column_of[p] == NO_INDEX {
                self.column_of[p] = self.rows.len() as u32;
                self.rows.push(p);
            }
            if self.read_of[q] == NO_INDEX {
                self.read_of[q] = self.reads.len() as u32;
                self.reads.push(q);
            }
        }
        self.columns.extend(tangent.unit_steps(&self.rows[columns..], flexibility));
        self.read_values.resize_with(self.reads.len(), Vec::new);
        for (read, (read_values, &row)) in self.read_values.iter_mut().zip(&self.reads).enumerate() {
            let from = if read < reads { columns } else { 0 };
            dots(&flexibility[row], self.columns[from..].iter().map(Vec::as_slice), read_values);
        }
    }

    /// Corrects a step of the factorised tangent [N/m] to that of the updated one.
    pub(super) fn correct_step(&mut self, step: &mut [f64], flexibility: &[Vec<f64>]) {
        if self.columns_in_use.is_empty() {
            return;
        }
        let mut row_changes = Vec::with_capacity(self.reads_in_use.len());
        dots(step, self.reads_in_use.iter().map(|&read| flexibility[self.reads[read]].as_slice()), &mut row_changes);
        let mut right = vec![0.0; self.columns_in_use.len()];
        self.changes.iter().for_each(|&(i, read, s)| right[i] += s * row_changes[self.index_in_use[read] as usize]);
        self.capacitance.solve(&mut right);
        add_multiples(step, self.columns_in_use.iter().map(|&column| self.columns[column].as_slice()).zip(right));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fem::condensed::rows::dot;

    const ROWS: usize = 40;

    /// Flexibility between rows on soft ground.
    fn flexibility() -> Vec<Vec<f64>> {
        let entry = |i: usize, j: usize| 1.0 / (1.0 + i.abs_diff(j) as f64) + f64::from(u8::from(i == j));
        (0..ROWS).map(|i| (0..ROWS).map(|j| entry(i, j)).collect()).collect()
    }

    /// Largest residual of the step for a right-hand side, with a given excess stiffness.
    fn left(
        tangent: &mut Tangent<f32>,
        update: &mut LowRankUpdate,
        stiffness: &[StiffnessEntry],
        flexibility: &[Vec<f64>],
    ) -> f64 {
        let right: Vec<f64> = (0..ROWS).map(|i| ((7 * i) % 5) as f64 - 2.0).collect();
        let row_changes = |step: &[f64]| flexibility.iter().map(|row| dot(row, step)).collect::<Vec<f64>>();
        let mut known = right.clone();
        tangent.nonlinear_rows.iter().for_each(|&p| known[p] = 0.0);
        let mut step = tangent.solve(&right, &row_changes(&known));
        update.correct_step(&mut step, flexibility);
        let values = row_changes(&step);
        let mut left: Vec<f64> = step.iter().zip(&right).map(|(step, right)| step - right).collect();
        stiffness.iter().for_each(|&(p, q, s)| left[p] -= s * values[q]);
        left.iter().fold(0.0, |most, left| most.max(left.abs()))
    }

    #[test]
    fn an_updated_tangent_solves_the_changed_system() {
        let flexibility = flexibility();
        let stiffness: Vec<StiffnessEntry> =
            (0..24).flat_map(|i| [(i, i, 0.3 - 0.02 * i as f64), (i, (i + 3) % 24, 0.1)]).collect();
        let (mut tangent, mut update) = (Tangent::default(), LowRankUpdate::default());
        tangent.factorise_for(&stiffness, &flexibility);
        // One nonlinear row that no longer is, one that becomes so, others that change, and one entry twice. The second time some
        // rows are known, the third time only these are left.
        let first = [(2, 2, -0.26), (2, 5, -0.1), (30, 31, 0.4), (30, 30, -0.2), (7, 7, 0.5), (7, 7, 0.1)];
        let second = [(30, 31, 0.4), (30, 30, -0.2), (7, 9, 0.5), (11, 35, -0.3), (39, 2, 0.2)];
        for changes in [&first[..], &second, &second[..1]] {
            let all: Vec<StiffnessEntry> = stiffness.iter().chain(changes).copied().collect();
            update.columns_in_use.clear();
            let without = left(&mut tangent, &mut update, &all, &flexibility);
            assert!(update.build(changes, ROWS, &mut tangent, &flexibility));
            let with = left(&mut tangent, &mut update, &all, &flexibility);
            assert!(without > 1e-2 && with < 1e-5, "{without} without, {with} with the change");
        }
        assert!(!update.build(&second, 3, &mut tangent, &flexibility), "four rows have changed");
    }
}
