//! Whether a balanced state stands: no eigenvalue of its tangent is negative.
//!
//! A state stands where every small motion takes work. A symmetric tangent has as many negative eigenvalues as an elimination without
//! exchanges has negative pivots (Sylvester 1852). The sign of the determinant says only whether their number is even: two like spans that both give
//! way have the sign of two that stand. No count is kept: an elimination is exact as long as pivots are positive, and ends at the first that is not.
//!
//! Tangents of joints that hold are nearly symmetric: shear follows the pressed length, and moments of forces change as a joint turns. The pivots are those of
//! the tangent itself, whose last one vanishes where the load is largest. Those of its symmetric part, which is the work of second order (Hill 1958), turn
//! negative within a ten-thousandth of that load before, and with the others everywhere else. Joints whose cohesion holds much shear on little of their length
//! are not: what they lose as they open is as large as what presses them. There pivots turn negative without an eigenvalue that does, and the eigenvalues are
//! asked for.

use crate::banded::Banded;

/// A tangent is nearly symmetric where no entry differs from its mirror image by more than this share of the largest stiffness: 0.15 at most of rings that rub,
/// and no less than 0.7 where pivots and eigenvalues were seen to disagree.
const NEARLY_SYMMETRIC: f64 = 0.25;

/// Most equations whose eigenvalues are sought, in half a second; of more the determinant alone is asked.
const MOST_EQUATIONS: usize = 600;

/// Whether no eigenvalue of a matrix that is not factorised is negative. The elimination takes place in `rows`.
pub(super) fn has_no_negative_eigenvalue(matrix: &Banded, rows: &mut Vec<f64>) -> bool {
    if is_definite(matrix, rows) {
        return true;
    }
    if is_nearly_symmetric(matrix) {
        return false;
    }
    let mut factors = matrix.clone();
    let even = factors.factorise() && factors.sign > 0;
    even && (matrix.size > MOST_EQUATIONS || least_real_part(matrix).is_some_and(|least| least > 0.0))
}

/// Whether that may be, as far as pivots tell: of what is far from symmetric they tell nothing.
pub(super) fn may_have_no_negative_eigenvalue(matrix: &Banded, rows: &mut Vec<f64>) -> bool {
    is_definite(matrix, rows) || !is_nearly_symmetric(matrix)
}

/// Whether all pivots are positive: `rows` holds every row from `below` columns before the diagonal to as many after it.
fn is_definite(matrix: &Banded, rows: &mut Vec<f64>) -> bool {
    let below = matrix.below;
    let width = 2 * below + 1;
    rows.clear();
    (0..matrix.size).for_each(|row| rows.extend_from_slice(matrix.about_diagonal(row)));
    for k in 0..matrix.size {
        let (start, count) = (k * width + below, matrix.last[k] as usize - k);
        let pivot = rows[start];
        // A comparison that a number which is not one fails.
        if !(pivot > 0.0) {
            return false;
        }
        let inverse = 1.0 / pivot;
        for below_it in 1..=count {
            let at = start + below_it * (width - 1);
            let (upper, lower) = rows.split_at_mut(at);
            let share = lower[0] * inverse;
            let from = &upper[start + 1..=start + count];
            for (to, from) in lower[1..=count].iter_mut().zip(from) {
                *to -= share * from;
            }
        }
    }
    true
}

fn entry(matrix: &Banded, row: usize, column: usize) -> f64 {
    let below = matrix.below;
    if row.abs_diff(column) <= below { matrix.about_diagonal(row)[column + below - row] } else { 0.0 }
}

fn is_nearly_symmetric(matrix: &Banded) -> bool {
    let largest = (0..matrix.size).fold(0.0, |most: f64, k| most.max(entry(matrix, k, k).abs()));
    let differs = |row: usize, column: usize| (entry(matrix, row, column) - entry(matrix, column, row)).abs();
    let most = NEARLY_SYMMETRIC * largest;
    (0..matrix.size).all(|row| (row + 1..=matrix.last[row] as usize).all(|column| differs(row, column) <= most))
}

/// Least real part of the eigenvalues; none where they are not found.
fn least_real_part(matrix: &Banded) -> Option<f64> {
    let whole = faer::Mat::from_fn(matrix.size, matrix.size, |row, column| entry(matrix, row, column));
    whole.eigenvalues().ok()?.iter().map(|value| value.re).min_by(f64::total_cmp)
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
            assert_eq!(is_definite(&banded, &mut Vec::new()), negative == 0, "{eigenvalues:?}");
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
        assert!(!is_definite(&banded, &mut Vec::new()));
    }

    /// Of a matrix that is far from symmetric a pivot may be negative though no eigenvalue is: here they are 1 + 3.5i, 1 - 3.5i, and the others.
    #[test]
    fn a_negative_pivot_of_what_is_not_symmetric_is_no_negative_eigenvalue() {
        let far = |other: f64| {
            let mut banded = Banded::new((0..4u32).map(|k| (k + 1).min(3)).collect());
            for (row, column, value) in
                [(0, 0, -1.0), (0, 1, 4.0), (1, 0, -4.0), (1, 1, 3.0), (2, 2, other), (3, 3, other)]
            {
                banded.add(row, column, value);
            }
            banded
        };
        let mut rows = Vec::new();
        assert!(!is_definite(&far(2.0), &mut rows) && has_no_negative_eigenvalue(&far(2.0), &mut rows));
        // Two that are negative leave the determinant positive.
        assert!(!has_no_negative_eigenvalue(&far(-0.5), &mut rows));
    }
}
