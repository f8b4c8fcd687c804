//! Von Mises: a strength in shear that knows no pressure.

use super::cone;
use super::elastic::Elastic;
use super::response::{Four, Law, Memory, Response};
use super::strength::Strength;

/// Elastic, perfectly plastic where the square root of J2 reaches a strength. Flow is associated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VonMises {
    /// Elasticity.
    pub elastic: Elastic,
    /// Strength k in pure shear [Pa]: √J2 ≤ k. It is the undrained strength of a clay, and the yield stress over √3.
    pub strength: f64,
}

impl Law for VonMises {
    fn of(elastic: Elastic, strength: &Strength) -> VonMises {
        VonMises { elastic, strength: strength.cohesion }
    }

    fn elastic(&self) -> Elastic {
        self.elastic
    }

    fn respond(&self, strain: &Four, old: &Memory) -> Response {
        let trial = self.elastic.trial(strain, old);
        match cone::back(&self.elastic, &trial, 0.0, 0.0, self.strength) {
            None => self.elastic.holds(trial, old),
            Some((stress, tangent)) => self.elastic.flowed(strain, old, stress, tangent),
        }
    }
}
