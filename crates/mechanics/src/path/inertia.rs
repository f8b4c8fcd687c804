//! Whether a balanced state stands: no eigenvalue of its tangent is negative.
//!
//! A state stands where every small motion takes work. A symmetric tangent has as many negative eigenvalues as an elimination without
//! exchanges has negative pivots (Sylvester 1852). The sign of the determinant says only whether their number is even: two like spans that both give
//! way have the sign of two that stand. No count is kept: an elimination is exact as long as pivots are positive, and ends at the first that is not.
//!
//! Tangents of joints that hold are nearly symmetric: shear follows the pressed length, and moments of forces change as a joint turns. The pivots are those of
//! the tangent itself, whose last one vanishes where the load is largest. Those of its symmetric part, which is the work of second order (Hill 1958), turn
//! negative within a ten-thousandth of that load before, and with the others everywhere else.

use super::banded::Banded;

/// Room for an elimination.
#[derive(Debug, Clone, Default)]
pub(super) struct Elimination {
    /// Row by row from `below` columns before the diagonal to as many after it.
    rows: Vec<f64>,
}

impl Elimination {
    /// Whether all pivots of a matrix that is not factorised are positive.
    pub fn is_definite(&mut self, matrix: &Banded) -> bool {
        let below = matrix.below();
        let width = 2 * below + 1;
        self.rows.clear();
        (0..matrix.size()).for_each(|row| self.rows.extend_from_slice(matrix.about_diagonal(row)));
        for k in 0..matrix.size() {
            let (start, count) = (k * width + below, matrix.last(k) - k);
            let pivot = self.rows[start];
            // A comparison that a number which is not one fails.
            if !(pivot > 0.0) {
                return false;
            }
            let inverse = 1.0 / pivot;
            for below_it in 1..=count {
                let at = start + below_it * (width - 1);
                let (upper, lower) = self.rows.split_at_mut(at);
                let share = lower[0] * inverse;
                let from = &upper[start + 1..=start + count];
                for (to, from) in lower[1..=count].iter_mut().zip(from) {
                    *to -= share * from;
                }
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A matrix of `size` with a band of two diagonals, and its eigenvalues.
    fn matrix(size: usize, entry: impl Fn(usize, usize) -> f64) -> (Banded, Vec<f64>) {
        let mut banded = Banded::new((0..size).map(|k| (k + 2).min(size - 1) as u32).collect());
        let mut whole = faer::Mat::<f64>::zeros(size, size);
        for row in 0..size {
            for column in row.saturating_sub(2)..=(row + 2).min(size - 1) {
                let value = entry(row.min(column), row.max(column));
                banded.add(row, column, value);
                whole[(row, column)] = value;
            }
        }
        (banded, whole.self_adjoint_eigenvalues(faer::Side::Lower).unwrap())
    }

    /// A matrix is definite where all its eigenvalues are positive: not where an even number of them is negative.
    #[test]
    fn what_is_definite_has_no_negative_eigenvalue() {
        let mut counts = [0; 3];
        for shift in 0..600 {
            let diagonal = 6.0 - 0.015 * f64::from(shift);
            let entry = |row: usize, column: usize| {
                if row == column { diagonal } else { ((row * 7 + column * 5) % 5) as f64 - 2.0 }
            };
            let (mut banded, eigenvalues) = matrix(14, entry);
            let negative = eigenvalues.iter().filter(|value| **value < 0.0).count();
            assert_eq!(Elimination::default().is_definite(&banded), negative == 0, "{eigenvalues:?}");
            assert!(banded.factorise());
            counts[negative.min(2)] += 1;
        }
        assert!(counts.iter().all(|&met| met > 0), "none, one and more are met: {counts:?}");
    }

    #[test]
    fn two_like_parts_that_both_give_way_are_not_definite() {
        let (banded, eigenvalues) = matrix(4, |row, column| match (row, column) {
            (0, 1) | (2, 3) => 2.0,
            _ if row == column => 1.0,
            _ => 0.0,
        });
        assert_eq!(eigenvalues.iter().filter(|value| **value < 0.0).count(), 2);
        assert!(eigenvalues.iter().product::<f64>() > 0.0);
        assert!(!Elimination::default().is_definite(&banded));
    }
}
