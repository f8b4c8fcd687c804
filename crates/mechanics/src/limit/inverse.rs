//! The inverse of a small dense matrix of which one row changes at a time, or the last column.

/// An inverse, kept by rows.
#[derive(Debug, Clone, Default)]
pub(super) struct Inverse {
    size: usize,
    values: Vec<f64>,
    /// Changes since it was made; each adds round-off.
    pub changes: usize,
}

/// A matrix with no larger pivot than this counts as singular.
const SINGULAR: f64 = 1e-13;
/// A last column whose share in the old inverse is smaller does not take the place of the old one.
const WEAK: f64 = 1e-6;

impl Inverse {
    /// By Gauss and Jordan in place, with the largest pivot of each column; none where the matrix is singular.
    pub(super) fn of(matrix: &[f64], size: usize) -> Option<Inverse> {
        let mut values = matrix.to_vec();
        let (mut swaps, mut pivot_row) = (Vec::with_capacity(size), vec![0.0; size]);
        for column in 0..size {
            let at = |row: usize| row * size + column;
            let mut pivot = column;
            for row in column + 1..size {
                if values[at(row)].abs() > values[at(pivot)].abs() {
                    pivot = row;
                }
            }
            let value = values[at(pivot)];
            if !(value.abs() > SINGULAR) {
                return None;
            }
            swaps.push(pivot);
            pivot_row.copy_from_slice(&values[pivot * size..][..size]);
            if pivot != column {
                values.copy_within(column * size..(column + 1) * size, pivot * size);
            }
            pivot_row[column] = 1.0;
            pivot_row.iter_mut().for_each(|v| *v /= value);
            values[column * size..][..size].copy_from_slice(&pivot_row);
            for (row, of_row) in values.chunks_exact_mut(size).enumerate() {
                if row != column {
                    let factor = std::mem::take(&mut of_row[column]);
                    of_row.iter_mut().zip(&pivot_row).for_each(|(v, p)| *v -= factor * p);
                }
            }
        }
        // Rows that changed places are columns of the inverse that do.
        for (column, pivot) in swaps.into_iter().enumerate().rev().filter(|(column, pivot)| column != pivot) {
            values.chunks_exact_mut(size).for_each(|row| row.swap(column, pivot));
        }
        Some(Inverse { size, values, changes: 0 })
    }

    /// Its last row: how much of each row of the matrix makes a one in the last column alone.
    pub(super) fn multipliers(&self) -> &[f64] {
        &self.values[self.values.len() - self.size..]
    }

    /// Its product with a vector.
    pub(super) fn times(&self, vector: &[f64], product: &mut [f64]) {
        for (to, row) in product.iter_mut().zip(self.values.chunks_exact(self.size)) {
            *to = dot(row, vector);
        }
    }

    /// A row as a sum of the rows of the matrix.
    pub(super) fn transposed_times(&self, row: &[f64]) -> Vec<f64> {
        let mut weights = vec![0.0; self.size];
        for (value, inverse) in row.iter().zip(self.values.chunks_exact(self.size)) {
            weights.iter_mut().zip(inverse).for_each(|(w, i)| *w += value * i);
        }
        weights
    }

    /// Lets a row of these weights take the place of row `leaving` of the matrix.
    pub(super) fn exchange(&mut self, leaving: usize, weights: &[f64]) {
        let pivot = weights[leaving];
        for row in self.values.chunks_exact_mut(self.size) {
            let value = row[leaving] / pivot;
            row.iter_mut().zip(weights).for_each(|(v, w)| *v -= value * w);
            row[leaving] = value;
        }
        self.changes += 1;
    }

    /// Lets another last column take the place of that of the matrix; false where it would be left singular, or nearly.
    pub(super) fn with_last<'v>(&mut self, last: impl Iterator<Item = &'v f64>) -> bool {
        let n = self.size;
        let last: Vec<f64> = last.copied().collect();
        let mut shares = vec![0.0; n];
        self.times(&last, &mut shares);
        if !(shares[n - 1].abs() > WEAK) {
            return false;
        }
        let (rest, own) = self.values.split_at_mut((n - 1) * n);
        own.iter_mut().for_each(|v| *v /= shares[n - 1]);
        for (row, share) in rest.chunks_exact_mut(n).zip(&shares) {
            row.iter_mut().zip(&*own).for_each(|(v, o)| *v -= share * o);
        }
        self.changes += 1;
        true
    }

    /// Takes out of the multipliers what they miss; false where they are none.
    pub(super) fn refine_multipliers(&mut self, matrix: &[f64]) -> bool {
        let n = self.size;
        let mut missing = vec![0.0; n];
        missing[n - 1] = 1.0;
        for (y, row) in self.multipliers().iter().zip(matrix.chunks_exact(n)) {
            missing.iter_mut().zip(row).for_each(|(m, a)| *m -= y * a);
        }
        let change = self.transposed_times(&missing);
        let from = self.values.len() - n;
        self.values[from..].iter_mut().zip(&change).for_each(|(y, d)| *y += d);
        self.multipliers().iter().all(|y| y.is_finite())
    }
}

/// The sum of the products of two vectors.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A matrix that needs its rows to change places, then a row and the last column of it changed.
    #[test]
    fn what_changes_one_at_a_time_is_the_inverse_of_the_whole() {
        let mut matrix = vec![0.0, 2.0, 1.0, 0.5, 0.0, -1.0, 3.0, 1.0, 0.25];
        let is_inverse = |inverse: &Inverse, matrix: &[f64]| {
            for j in 0..3 {
                let column: Vec<f64> = matrix.iter().skip(j).step_by(3).copied().collect();
                let mut product = [0.0; 3];
                inverse.times(&column, &mut product);
                for (k, p) in product.into_iter().enumerate() {
                    assert!((p - f64::from(u8::from(j == k))).abs() < 1e-14, "{j} {k} {p}");
                }
            }
        };
        let mut inverse = Inverse::of(&matrix, 3).unwrap();
        is_inverse(&inverse, &matrix);
        let row = [1.0, -0.5, 2.0];
        let weights = inverse.transposed_times(&row);
        inverse.exchange(1, &weights);
        matrix[3..6].copy_from_slice(&row);
        is_inverse(&inverse, &matrix);
        let last = [0.75, -1.0, 1.5];
        assert!(inverse.with_last(last.iter()));
        matrix.iter_mut().skip(2).step_by(3).zip(last).for_each(|(a, l)| *a = l);
        is_inverse(&inverse, &matrix);
        let exact = inverse.multipliers().to_vec();
        inverse.values[7] += 1e-7;
        assert!(inverse.refine_multipliers(&matrix));
        assert!(inverse.multipliers().iter().zip(exact).all(|(a, b)| (a - b).abs() < 1e-12));
        assert!(Inverse::of(&[1.0, 2.0, 2.0, 4.0], 2).is_none());
    }
}
