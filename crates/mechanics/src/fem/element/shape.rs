//! Shape functions of the quadrilateral and their gradients at the points of integration.

use crate::plane::Vec2;

/// Corners on the parent square, and the signs of the points of integration.
const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Where two-point Gauss quadrature looks.
const GAUSS: f64 = 0.577_350_269_189_625_8;

/// Parent coordinates of a point of integration.
fn parent(point: usize) -> [f64; 2] {
    [GAUSS * CORNERS[point][0], GAUSS * CORNERS[point][1]]
}

/// Shape functions at a place of the parent square.
fn weights([xi, eta]: [f64; 2]) -> [f64; 4] {
    CORNERS.map(|[a, b]| 0.25 * (1.0 + a * xi) * (1.0 + b * eta))
}

/// Derivatives of the shape functions along the parent axes.
fn slopes([xi, eta]: [f64; 2]) -> [[f64; 4]; 2] {
    [CORNERS.map(|[a, b]| 0.25 * a * (1.0 + b * eta)), CORNERS.map(|[a, b]| 0.25 * b * (1.0 + a * xi))]
}

/// Derivatives of x and y along the parent axes: `[[x_xi, y_xi], [x_eta, y_eta]]`.
fn jacobian(corners: &[Vec2; 4], slopes: &[[f64; 4]; 2]) -> [[f64; 2]; 2] {
    let mut j = [[0.0; 2]; 2];
    for axis in 0..2 {
        for a in 0..4 {
            j[axis][0] += slopes[axis][a] * corners[a].x;
            j[axis][1] += slopes[axis][a] * corners[a].y;
        }
    }
    j
}

fn determinant(j: &[[f64; 2]; 2]) -> f64 {
    j[0][0] * j[1][1] - j[0][1] * j[1][0]
}

/// Gradients of the functions of one element at one place. The first four belong to the corners, the last two to the incompatible modes.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::fem) struct Sample {
    /// Along x [1/m].
    pub dx: [f64; 6],
    /// Along y [1/m].
    pub dy: [f64; 6],
    /// Area that the place stands for [m^2].
    pub area: f64,
}

/// Samples an element at one place.
fn sample_at(corners: &[Vec2; 4], place: [f64; 2], centre: &[[f64; 2]; 2]) -> Sample {
    let slopes = slopes(place);
    let j = jacobian(corners, &slopes);
    let area = determinant(&j);
    let inverse = 1.0 / area;
    let (mut dx, mut dy) = ([0.0; 6], [0.0; 6]);
    for a in 0..4 {
        dx[a] = (j[1][1] * slopes[0][a] - j[0][1] * slopes[1][a]) * inverse;
        dy[a] = (j[0][0] * slopes[1][a] - j[1][0] * slopes[0][a]) * inverse;
    }
    // Taylor's modes 1 - xi^2 and 1 - eta^2: gradients through the centre's Jacobian, scaled by j0 / j, so that they vanish in the mean
    // (equation 5).
    let (xi, eta) = (-2.0 * place[0] * inverse, -2.0 * place[1] * inverse);
    (dx[4], dy[4]) = (centre[1][1] * xi, -centre[1][0] * xi);
    (dx[5], dy[5]) = (-centre[0][1] * eta, centre[0][0] * eta);
    Sample { dx, dy, area }
}

/// The four points of integration of an element.
pub(in crate::fem) fn sample(corners: &[Vec2; 4]) -> [Sample; 4] {
    let centre = jacobian(corners, &slopes([0.0, 0.0]));
    std::array::from_fn(|point| sample_at(corners, parent(point), &centre))
}

/// Gradients of the corner functions at the centre.
pub(in crate::fem) fn centre(corners: &[Vec2; 4]) -> Sample {
    let centre = jacobian(corners, &slopes([0.0, 0.0]));
    sample_at(corners, [0.0, 0.0], &centre)
}

/// `integral of N_a N_b` [m^2] (equation 8), and `integral of N_a` on its rows' sums.
pub(in crate::fem) fn mass(corners: &[Vec2; 4]) -> [[f64; 4]; 4] {
    let mut mass = [[0.0; 4]; 4];
    for (point, sample) in sample(corners).iter().enumerate() {
        let n = weights(parent(point));
        for a in 0..4 {
            for b in 0..4 {
                mass[a][b] += sample.area * n[a] * n[b];
            }
        }
    }
    mass
}
