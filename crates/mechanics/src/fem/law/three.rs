//! Three by three, as much of it as principal stresses need.

pub(super) type Three = [f64; 3];
pub(super) type Matrix = [[f64; 3]; 3];

pub(super) fn dot(a: &Three, b: &Three) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn times(matrix: &Matrix, v: &Three) -> Three {
    [dot(&matrix[0], v), dot(&matrix[1], v), dot(&matrix[2], v)]
}

pub(super) fn transposed_times(matrix: &Matrix, v: &Three) -> Three {
    std::array::from_fn(|j| matrix[0][j] * v[0] + matrix[1][j] * v[1] + matrix[2][j] * v[2])
}

/// The inverse; none where it is singular to rounding.
pub(super) fn inverse(m: &Matrix) -> Option<Matrix> {
    let minor = |i: usize, j: usize| {
        let (a, b, c, d) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    let determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
    let rows: f64 = m.iter().map(|row| dot(row, row).sqrt()).product();
    if !(determinant.abs() > 1e-12 * rows) {
        return None;
    }
    Some(std::array::from_fn(|i| std::array::from_fn(|j| minor(j, i) / determinant)))
}

/// Hooke's law in principal directions.
pub(super) fn hooke(elastic: &super::Elastic) -> Matrix {
    let (lame, twice) = (elastic.lame(), 2.0 * elastic.shear());
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { lame + twice } else { lame }))
}
