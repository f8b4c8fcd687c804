//! Where a rigid body is.

use super::vector::{Vec2, vec2};
use serde::{Deserialize, Serialize};

/// A rotation kept as cosine and sine, so that no step needs a trigonometric call.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Rotation {
    /// Cosine of the angle.
    pub cos: f64,
    /// Sine of the angle.
    pub sin: f64,
}

impl Rotation {
    /// No rotation.
    pub const NONE: Rotation = Rotation { cos: 1.0, sin: 0.0 };

    /// Rotation by `angle` [rad], counter-clockwise.
    pub fn by(angle: f64) -> Rotation {
        Rotation { cos: angle.cos(), sin: angle.sin() }
    }
    /// `v` turned.
    #[inline]
    pub fn turn(self, v: Vec2) -> Vec2 {
        vec2(self.cos * v.x - self.sin * v.y, self.sin * v.x + self.cos * v.y)
    }
    /// `v` turned back.
    #[inline]
    pub fn turn_back(self, v: Vec2) -> Vec2 {
        vec2(self.cos * v.x + self.sin * v.y, self.cos * v.y - self.sin * v.x)
    }
    /// This rotation followed by a small one, `2 atan(angle / 2)` (Cayley form): orthogonal to round-off, and equal
    /// to `angle` up to `angle^3 / 12`.
    #[inline(always)]
    pub fn advanced(self, angle: f64) -> Rotation {
        let half = 0.5 * angle;
        let square = half * half;
        // A step turns a block by microradians: the series is exact to the last bit there and spares a division.
        let scale = if square < 1e-5 { 1.0 - square * (1.0 - square * (1.0 - square)) } else { 1.0 / (1.0 + square) };
        let (c, s) = ((1.0 - square) * scale, angle * scale);
        Rotation { cos: self.cos * c - self.sin * s, sin: self.sin * c + self.cos * s }
    }
}

/// Position of a body's centre of mass and its rotation since the body was made.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Pose {
    /// Centre of mass [m].
    pub position: Vec2,
    /// Rotation from the reference placement.
    pub rotation: Rotation,
}

impl Pose {
    /// At `position`, not turned.
    pub fn at(position: Vec2) -> Pose {
        Pose { position, rotation: Rotation::NONE }
    }
    /// A point given relative to the centre of mass in the reference placement, where it is now.
    #[inline]
    pub fn place(&self, local: Vec2) -> Vec2 {
        self.position + self.rotation.turn(local)
    }
}
