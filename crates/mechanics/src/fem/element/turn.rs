//! Frames that turn with the body: displacements are large, strains small.
//!
//! The turn of a frame is the angle of a vector `(a, b)` that is linear in the displacements. What moves in the frame is the position
//! turned back; forces and tangent computed there are brought to the fixed axes with all their derivatives (equations 9 to 12), so that
//! Newton's method sees the exact tangent.

/// The angle of a vector `(a, b)` that is linear in `m` displacements.
#[derive(Debug, Clone, Copy)]
pub(in crate::fem) struct Angle<const M: usize> {
    /// The vector.
    pub along: [f64; 2],
    /// Derivatives of both of its components.
    pub slopes: [[f64; M]; 2],
}

impl<const M: usize> Angle<M> {
    /// Cosine and sine; `None` for a vector without length.
    pub(in crate::fem) fn direction(&self) -> Option<[f64; 2]> {
        let [a, b] = self.along;
        let length = a.hypot(b);
        (length > 0.0 && length.is_finite()).then(|| [a / length, b / length])
    }
}

/// Forces and tangent in a turned frame, brought to the fixed axes.
///
/// `positions` are those of the nodes in the frame; `force` and `tangent` answer them. Only the first `m` rows are read and written.
pub(in crate::fem) fn turned<const M: usize>(
    angle: &Angle<M>,
    [cos, sin]: [f64; 2],
    positions: &[f64; M],
    (force, tangent): (&mut [f64; M], &mut [[f64; M]; M]),
    m: usize,
) {
    let [a, b] = angle.along;
    let [da, db] = &angle.slopes;
    let inverse = 1.0 / (a * a + b * b);
    // Gradient of the angle, and the moment of the forces about the frame's origin.
    let mut g = [0.0; M];
    let (mut moment, mut radial) = (0.0, 0.0);
    for i in 0..m {
        g[i] = (a * db[i] - b * da[i]) * inverse;
    }
    // How positions turn back as the frame turns on: -J x.
    let mut back = [0.0; M];
    for n in 0..m / 2 {
        let (x, y) = (positions[2 * n], positions[2 * n + 1]);
        (back[2 * n], back[2 * n + 1]) = (y, -x);
        moment += y * force[2 * n] - x * force[2 * n + 1];
        radial += x * force[2 * n] + y * force[2 * n + 1];
    }
    // Tangent of the material: E^T K E with E = R^T + back g^T.
    let mut right = [[0.0; M]; M];
    for i in 0..m {
        let kb: f64 = (0..m).map(|j| tangent[i][j] * back[j]).sum();
        for n in 0..m / 2 {
            let (x, y) = (tangent[i][2 * n], tangent[i][2 * n + 1]);
            right[i][2 * n] = cos * x - sin * y + kb * g[2 * n];
            right[i][2 * n + 1] = sin * x + cos * y + kb * g[2 * n + 1];
        }
    }
    let mut pull = [0.0; M];
    for j in 0..m {
        pull[j] = (0..m).map(|i| back[i] * right[i][j]).sum();
    }
    // Forces on the fixed axes, and those turned by a quarter.
    let mut global = [0.0; M];
    let mut quarter = [0.0; M];
    for n in 0..m / 2 {
        let (x, y) = (force[2 * n], force[2 * n + 1]);
        let (fx, fy) = (cos * x - sin * y, sin * x + cos * y);
        (global[2 * n], global[2 * n + 1]) = (fx, fy);
        (quarter[2 * n], quarter[2 * n + 1]) = (-fy, fx);
    }
    for n in 0..m / 2 {
        for j in 0..m {
            let (x, y) = (right[2 * n][j], right[2 * n + 1][j]);
            tangent[2 * n][j] = cos * x - sin * y;
            tangent[2 * n + 1][j] = sin * x + cos * y;
        }
    }
    for i in 0..m {
        for j in 0..m {
            let curl = (db[i] * da[j] - da[i] * db[j]) * inverse;
            let second = curl - 2.0 * inverse * g[i] * (a * da[j] + b * db[j]);
            tangent[i][j] +=
                g[i] * pull[j] + quarter[i] * g[j] + g[i] * quarter[j] - radial * g[i] * g[j] + moment * second;
        }
        force[i] = global[i] + moment * g[i];
    }
}
