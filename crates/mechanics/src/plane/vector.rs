//! Plane vectors.

use serde::{Deserialize, Serialize};
use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// A point or a direction in the plane.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Vec2 {
    /// To the right.
    pub x: f64,
    /// Up.
    pub y: f64,
}

/// Short for `Vec2 { x, y }`.
#[inline]
pub const fn vec2(x: f64, y: f64) -> Vec2 {
    Vec2 { x, y }
}

impl Vec2 {
    /// The origin.
    pub const ZERO: Vec2 = vec2(0.0, 0.0);

    /// Scalar product.
    #[inline]
    pub fn dot(self, b: Vec2) -> f64 {
        self.x * b.x + self.y * b.y
    }
    /// Third component of the vector product; positive when `b` lies counter-clockwise of `self`.
    #[inline]
    pub fn cross(self, b: Vec2) -> f64 {
        self.x * b.y - self.y * b.x
    }
    /// Turned by +90 degrees.
    #[inline]
    pub fn left(self) -> Vec2 {
        vec2(-self.y, self.x)
    }
    /// Turned by -90 degrees: the outward normal of a counter-clockwise edge along `self`.
    #[inline]
    pub fn right(self) -> Vec2 {
        vec2(self.y, -self.x)
    }
    /// Length.
    #[inline]
    pub fn norm(self) -> f64 {
        self.dot(self).sqrt()
    }
    /// Unit vector along `self`; the zero vector stays zero.
    #[inline]
    pub fn unit(self) -> Vec2 {
        let n = self.norm();
        if n > 0.0 { self * (1.0 / n) } else { self }
    }
    /// Whether both components are finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl Add for Vec2 {
    type Output = Vec2;
    #[inline]
    fn add(self, b: Vec2) -> Vec2 {
        vec2(self.x + b.x, self.y + b.y)
    }
}
impl Sub for Vec2 {
    type Output = Vec2;
    #[inline]
    fn sub(self, b: Vec2) -> Vec2 {
        vec2(self.x - b.x, self.y - b.y)
    }
}
impl Mul<f64> for Vec2 {
    type Output = Vec2;
    #[inline]
    fn mul(self, k: f64) -> Vec2 {
        vec2(self.x * k, self.y * k)
    }
}
impl Neg for Vec2 {
    type Output = Vec2;
    #[inline]
    fn neg(self) -> Vec2 {
        vec2(-self.x, -self.y)
    }
}
impl AddAssign for Vec2 {
    #[inline]
    fn add_assign(&mut self, b: Vec2) {
        *self = *self + b;
    }
}
impl SubAssign for Vec2 {
    #[inline]
    fn sub_assign(&mut self, b: Vec2) {
        *self = *self - b;
    }
}
