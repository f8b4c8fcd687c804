//! Mohr-Coulomb: friction and cohesion on the worst plane.

use super::elastic::Elastic;
use super::polyhedron::{Face, respond, tension};
use super::response::{Four, Law, Memory, Response};
use super::strength::Strength;

/// Elastic, perfectly plastic on (σ₁ − σ₃) + (σ₁ + σ₃) sin φ ≤ 2 c cos φ, tension positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MohrCoulomb {
    /// Elasticity.
    pub elastic: Elastic,
    /// Cohesion c [Pa], not below zero.
    pub cohesion: f64,
    /// Angle of friction φ [rad], from 0 to below a quarter turn. With 0 this is Tresca's law.
    pub friction_angle: f64,
    /// Angle of dilatancy ψ [rad], from 0 to φ. Flow is associated where the two are the same.
    pub dilatancy_angle: f64,
    /// Greatest principal stress it takes in tension [Pa]; none leaves the pyramid up to its apex at c cot φ.
    pub tension_cutoff: Option<f64>,
}

impl MohrCoulomb {
    /// The three faces that a stress with its principal values in order can meet: between the greatest and the least, and the
    /// two that meet it at the edges.
    fn faces(&self) -> [Face; 3] {
        let (friction, dilatancy) = (self.friction_angle.sin(), self.dilatancy_angle.sin());
        let bound = 2.0 * self.cohesion * self.friction_angle.cos();
        [(0, 2), (0, 1), (1, 2)].map(|(great, small)| {
            let along = |sine: f64| {
                let mut direction = [0.0; 3];
                direction[great] = 1.0 + sine;
                direction[small] = sine - 1.0;
                direction
            };
            Face { normal: along(friction), flow: along(dilatancy), bound }
        })
    }
}

impl Law for MohrCoulomb {
    fn of(elastic: Elastic, strength: &Strength) -> MohrCoulomb {
        let Strength { cohesion, friction_angle, dilatancy_angle, tension_cutoff, .. } = *strength;
        MohrCoulomb { elastic, cohesion, friction_angle, dilatancy_angle, tension_cutoff }
    }

    fn elastic(&self) -> Elastic {
        self.elastic
    }

    fn symmetric(&self) -> bool {
        self.dilatancy_angle.to_bits() == self.friction_angle.to_bits()
    }

    fn respond(&self, strain: &Four, old: &Memory) -> Response {
        let [a, b, c] = self.faces();
        match self.tension_cutoff.map(tension) {
            None => respond(&self.elastic, strain, old, &[a, b, c]),
            Some([d, e, f]) => respond(&self.elastic, strain, old, &[a, b, c, d, e, f]),
        }
    }
}
