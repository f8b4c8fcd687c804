//! The whole of an unsymmetric tangent, factorised as LU with row exchanges: slow and sure.

use super::gmres::norm;
use super::pattern::Pattern;
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::sparse::linalg::lu::{LuSymbolicParams, NumericLu, SymbolicLu, factorize_symbolic_lu};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par};

/// Pattern, ordering and factor.
pub(super) struct Whole {
    columns: Vec<u32>,
    rows: Vec<u32>,
    /// For each entry the one of the lower triangle it comes from, and the sign of its skew part.
    from: Vec<(u32, f64)>,
    values: Vec<f64>,
    symbolic: SymbolicLu<u32>,
    numeric: NumericLu<u32, f64>,
    memory: MemBuffer,
}

impl Whole {
    /// Mirrors the lower triangle and orders the equations; `None` where memory does not suffice.
    pub(super) fn new(pattern: &Pattern) -> Option<Whole> {
        let count = pattern.columns.len() - 1;
        let mut entries: Vec<Vec<(u32, u32, f64)>> = vec![Vec::new(); count];
        for column in 0..count {
            for k in pattern.column(column) {
                let row = pattern.rows[k];
                entries[column].push((row, k as u32, 1.0));
                if row as usize != column {
                    // Columns are walked in order, so that these come before the column's own entries, and ascending.
                    entries[row as usize].push((column as u32, k as u32, -1.0));
                }
            }
        }
        let (mut columns, mut rows, mut from) = (vec![0], Vec::new(), Vec::new());
        for mut column in entries {
            column.sort_unstable_by_key(|(row, _, _)| *row);
            rows.extend(column.iter().map(|(row, _, _)| *row));
            from.extend(column.iter().map(|(_, k, sign)| (*k, *sign)));
            columns.push(u32::try_from(rows.len()).ok()?);
        }
        let matrix = SymbolicSparseColMatRef::new_checked(count, count, &columns, None, &rows);
        let symbolic = factorize_symbolic_lu(matrix, LuSymbolicParams::default()).ok()?;
        let need = StackReq::any_of(&[
            symbolic.factorize_numeric_lu_scratch::<f64>(Par::Seq, Default::default()),
            symbolic.solve_in_place_scratch::<f64>(1, Par::Seq),
        ]);
        let memory = MemBuffer::try_new(need).ok()?;
        let values = vec![0.0; rows.len()];
        Some(Whole { columns, rows, from, values, symbolic, numeric: NumericLu::new(), memory })
    }

    /// Factorises and solves; the residual over the right-hand side comes with the solution.
    pub(super) fn solve(
        &mut self,
        pattern: &Pattern,
        (values, skew): (&[f64], &[f64]),
        right: &[f64],
    ) -> Option<(Vec<f64>, f64)> {
        for (value, (k, sign)) in self.values.iter_mut().zip(&self.from) {
            *value = values[*k as usize] + sign * skew[*k as usize];
        }
        let count = right.len();
        let structure = SymbolicSparseColMatRef::new_checked(count, count, &self.columns, None, &self.rows);
        let matrix = SparseColMatRef::new(structure, &self.values);
        let stack = MemStack::new(&mut self.memory);
        let factor =
            self.symbolic.factorize_numeric_lu(&mut self.numeric, matrix, Par::Seq, stack, Default::default()).ok()?;
        let mut x = right.to_vec();
        let stack = MemStack::new(&mut self.memory);
        factor.solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(&mut x, count, 1),
            Par::Seq,
            stack,
        );
        let mut rest: Vec<f64> = right.iter().map(|right| -right).collect();
        pattern.multiply(values, skew, &x, &mut rest);
        let residual = norm(&rest) / norm(right).max(f64::MIN_POSITIVE);
        Some((x, residual))
    }
}
