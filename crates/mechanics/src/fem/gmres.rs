//! Generalised minimal residuals (Saad and Schultz 1986), preconditioned from the right, without restarts.
//!
//! Frictional flow and sliding make tangents unsymmetric. Their symmetric part is factorised like any other tangent; what is skew
//! disturbs few eigenvalues, so that a few dozen vectors suffice where the unsymmetric factorisation costs eighteen times as much.

/// Most vectors: each costs about a quarter of a factorisation.
const LIMIT: usize = 40;

/// Solves `matrix x = right` to `goal`; both functions act on vectors, the first adds to its second argument. The norm of the residual over
/// that of the right-hand side comes with the solution.
pub(super) fn solve(
    matrix: impl Fn(&[f64], &mut [f64]),
    mut inverse: impl FnMut(&mut [f64]),
    right: &[f64],
    goal: f64,
) -> (Vec<f64>, f64) {
    let size = norm(right);
    if !(size > 0.0) {
        return (vec![0.0; right.len()], 0.0);
    }
    let mut basis = vec![right.iter().map(|r| r / size).collect::<Vec<f64>>()];
    // Columns of the Hessenberg matrix, turned into a triangle by the rotations as they come.
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut rotations: Vec<[f64; 2]> = Vec::new();
    let mut left = vec![size];
    while columns.len() < LIMIT && left[columns.len()].abs() > goal * size {
        let last = columns.len();
        let mut z = basis[last].clone();
        inverse(&mut z);
        let mut w = vec![0.0; right.len()];
        matrix(&z, &mut w);
        let mut column = Vec::with_capacity(last + 2);
        for v in &basis {
            let h = dot(v, &w);
            w.iter_mut().zip(v).for_each(|(w, v)| *w -= h * v);
            column.push(h);
        }
        let h = norm(&w);
        if !h.is_finite() {
            break;
        }
        for (i, [c, s]) in rotations.iter().enumerate() {
            (column[i], column[i + 1]) = (c * column[i] + s * column[i + 1], c * column[i + 1] - s * column[i]);
        }
        let length = column[last].hypot(h);
        if !(length > 0.0) {
            break;
        }
        let [c, s] = [column[last] / length, h / length];
        column[last] = length;
        rotations.push([c, s]);
        left.push(-s * left[last]);
        left[last] *= c;
        columns.push(column);
        if h <= f64::EPSILON * length {
            break;
        }
        basis.push(w.iter().map(|w| w / h).collect());
    }
    let mut x = combine(&basis, &columns, &left, right.len());
    inverse(&mut x);
    // What is left is measured and not believed.
    let mut rest = vec![0.0; right.len()];
    matrix(&x, &mut rest);
    rest.iter_mut().zip(right).for_each(|(rest, right)| *rest = right - *rest);
    (x, norm(&rest) / size)
}

/// Back substitution, then the sum of the basis vectors.
fn combine(basis: &[Vec<f64>], columns: &[Vec<f64>], left: &[f64], rows: usize) -> Vec<f64> {
    let count = columns.len();
    let mut y = left[..count].to_vec();
    for i in (0..count).rev() {
        for j in i + 1..count {
            y[i] -= columns[j][i] * y[j];
        }
        y[i] /= columns[i][i];
    }
    let mut x = vec![0.0; rows];
    for (v, y) in basis.iter().zip(&y) {
        x.iter_mut().zip(v).for_each(|(x, v)| *x += y * v);
    }
    x
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}
