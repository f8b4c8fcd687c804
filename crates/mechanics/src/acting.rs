//! What acts on one rigid block: forces that keep their direction.

use crate::plane::{Pose, Vec2};
use serde::Serialize;

/// Forces on one block that keep their direction while their points of application move with the block. The moment
/// of force `F` at arm `a`, turned by `(cos, sin)`, is `cos (a x F) - sin (a . F)`, so two sums stand for any number
/// of forces.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub(crate) struct Resultant {
    /// Sum of the forces [N/m].
    pub force: Vec2,
    /// Sum of `a x F` as built [N].
    pub cross: f64,
    /// Sum of `a . F` as built [N].
    pub dot: f64,
}

impl Resultant {
    /// Adds a force at an arm from the centre of mass.
    pub(crate) fn add(&mut self, arm: Vec2, force: Vec2) {
        self.force += force;
        self.cross += arm.cross(force);
        self.dot += arm.dot(force);
    }
    /// This resultant plus `factor` times another.
    pub(crate) fn plus(&self, other: &Resultant, factor: f64) -> Resultant {
        Resultant {
            force: self.force + other.force * factor,
            cross: self.cross + other.cross * factor,
            dot: self.dot + other.dot * factor,
        }
    }
    /// Work done since the block was built [J/m].
    pub(crate) fn work(&self, built: Vec2, now: &Pose) -> f64 {
        let c = now.rotation.cos - 1.0;
        self.force.dot(now.position - built) + c * self.dot + now.rotation.sin * self.cross
    }
}
