//! One particle as the steps see it: everything that a contact asks of it in one cache line.

use crate::plane::{Vec2, vec2};
use serde::{Deserialize, Serialize};

/// A particle's place, motion and size.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[repr(C, align(64))]
pub struct Disc {
    /// Centre [m].
    pub x: f64,
    /// Centre [m].
    pub y: f64,
    /// Velocity of the centre [m/s], half a step before the place.
    pub vx: f64,
    /// Velocity of the centre [m/s].
    pub vy: f64,
    /// Speed of the rim, radius times angular velocity [m/s], counter-clockwise positive.
    pub rim: f64,
    /// Radius [m].
    pub radius: f64,
    /// Reciprocal of the mass [m/kg].
    pub inverse_mass: f64,
    /// Length that the rim has turned [m]: radius times angle.
    pub rolled: f64,
}

impl Disc {
    /// The centre.
    pub fn centre(&self) -> Vec2 {
        vec2(self.x, self.y)
    }
    /// Angle turned since the particle was made [rad].
    pub fn angle(&self) -> f64 {
        self.rolled / self.radius
    }
    /// Kinetic energy [J/m]; the moment of inertia of a disc is `m r^2 / 2`.
    pub fn kinetic_energy(&self) -> f64 {
        0.5 * (self.vx * self.vx + self.vy * self.vy + 0.5 * self.rim * self.rim) / self.inverse_mass
    }
}
