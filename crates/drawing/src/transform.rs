//! Maps of the plane: from a block's own coordinates to those of the drawing.

use crate::Point;

/// A linear map and a shift.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Transform {
    /// Image of the unit vector along x.
    pub(crate) x: Point,
    /// Image of the unit vector along y.
    pub(crate) y: Point,
    /// Image of the origin.
    pub(crate) origin: Point,
}

impl Transform {
    /// Every length times `size`.
    pub(crate) fn scale(size: f64) -> Transform {
        Transform { x: [size, 0.0], y: [0.0, size], origin: [0.0, 0.0] }
    }

    /// The mirror image that an extrusion direction of (0, 0, -1) means: DXF Reference, arbitrary axis algorithm.
    pub(crate) fn mirrored() -> Transform {
        Transform { x: [-1.0, 0.0], ..Transform::scale(1.0) }
    }

    /// Where a point goes.
    pub(crate) fn point(&self, p: Point) -> Point {
        let v = self.vector(p);
        [v[0] + self.origin[0], v[1] + self.origin[1]]
    }

    /// Where a direction goes.
    pub(crate) fn vector(&self, v: Point) -> Point {
        [self.x[0] * v[0] + self.y[0] * v[1], self.x[1] * v[0] + self.y[1] * v[1]]
    }

    /// First `inner`, then this.
    pub(crate) fn after(&self, inner: &Transform) -> Transform {
        Transform { x: self.vector(inner.x), y: self.vector(inner.y), origin: self.point(inner.origin) }
    }

    /// Largest stretch: how much farther apart two points may come to lie.
    pub(crate) fn stretch(&self) -> f64 {
        // The larger singular value of the 2 by 2 matrix.
        let [a, c] = self.x;
        let [b, d] = self.y;
        let (sum, difference) = ((a + d).hypot(c - b), (a - d).hypot(c + b));
        0.5 * (sum + difference)
    }

    /// The factor of all lengths where there is one: circles stay circles.
    pub(crate) fn similarity(&self) -> Option<f64> {
        let (p, q) = (self.x[0].hypot(self.x[1]), self.y[0].hypot(self.y[1]));
        let skew = self.x[0] * self.y[0] + self.x[1] * self.y[1];
        // Round-off of a rotation and two equal scales.
        let alike = (p - q).abs() <= 1e-12 * p.max(q) && skew.abs() <= 1e-12 * p * q;
        (alike && p > 0.0).then_some(p)
    }
}
