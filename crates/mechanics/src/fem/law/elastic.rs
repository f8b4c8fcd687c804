//! Hooke's law, isotropic.

use super::response::{Four, Law, Memory, Response};
use super::strength::Strength;

/// Share of elasticity that tangents keep where a law may have none left: at an apex, a corner, a crack. Stress has no part of
/// it, so that answers are the same; equations of balance keep an inverse.
const KEPT: f64 = 1e-6;

/// Linear elasticity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic {
    /// Young's modulus [Pa], above zero.
    pub modulus: f64,
    /// Poisson's ratio, above -1 and below 0.5.
    pub ratio: f64,
}

impl Elastic {
    /// Shear modulus G [Pa].
    #[must_use]
    pub fn shear(&self) -> f64 {
        self.modulus / (2.0 * (1.0 + self.ratio))
    }

    /// Bulk modulus K [Pa].
    #[must_use]
    pub fn bulk(&self) -> f64 {
        self.modulus / (3.0 * (1.0 - 2.0 * self.ratio))
    }

    /// Lamé's first constant [Pa].
    #[must_use]
    pub fn lame(&self) -> f64 {
        self.bulk() - self.shear() * (2.0 / 3.0)
    }

    /// Stress [Pa] of an elastic strain.
    #[must_use]
    pub fn stress(&self, strain: &Four) -> Four {
        let shear = self.shear();
        let volume = self.lame() * (strain[0] + strain[1] + strain[2]);
        let [x, y, z] = [0, 1, 2].map(|i| volume + 2.0 * shear * strain[i]);
        [x, y, z, shear * strain[3]]
    }

    /// Elastic strain of a stress [Pa].
    #[must_use]
    pub fn strain(&self, stress: &Four) -> Four {
        let trace = stress[0] + stress[1] + stress[2];
        let [x, y, z] = [0, 1, 2].map(|i| ((1.0 + self.ratio) * stress[i] - self.ratio * trace) / self.modulus);
        [x, y, z, stress[3] / self.shear()]
    }

    /// Tangent [Pa], which is the same everywhere.
    #[must_use]
    pub fn tangent(&self) -> [[f64; 4]; 4] {
        let (lame, shear) = (self.lame(), self.shear());
        let diagonal = lame + 2.0 * shear;
        [[diagonal, lame, lame, 0.0], [lame, diagonal, lame, 0.0], [lame, lame, diagonal, 0.0], [0.0, 0.0, 0.0, shear]]
    }

    /// Stress if nothing more flows than did before.
    pub(super) fn trial(&self, strain: &Four, old: &Memory) -> Four {
        self.stress(&std::array::from_fn(|i| strain[i] - old.plastic[i]))
    }

    /// The answer where nothing flows.
    pub(super) fn holds(&self, stress: Four, old: &Memory) -> Response {
        Response { stress, tangent: self.tangent(), memory: *old, yields: false }
    }

    /// Closes an answer whose tangent may vanish.
    pub(super) fn softened(&self, strain: &Four, old: &Memory, stress: Four, mut tangent: [[f64; 4]; 4]) -> Response {
        for (row, whole) in tangent.iter_mut().zip(self.tangent()) {
            for (entry, whole) in row.iter_mut().zip(whole) {
                *entry += KEPT * (whole - *entry);
            }
        }
        self.flowed(strain, old, stress, tangent)
    }

    /// Closes an answer: what of the strain is not elastic becomes the new memory.
    pub(super) fn flowed(&self, strain: &Four, old: &Memory, stress: Four, tangent: [[f64; 4]; 4]) -> Response {
        let kept = self.strain(&stress);
        let plastic: Four = std::array::from_fn(|i| strain[i] - kept[i]);
        let more: Four = std::array::from_fn(|i| plastic[i] - old.plastic[i]);
        let length = (more[0] * more[0] + more[1] * more[1] + more[2] * more[2] + 0.5 * more[3] * more[3]).sqrt();
        Response { stress, tangent, memory: Memory { plastic, hardening: old.hardening + length }, yields: true }
    }
}

impl Law for Elastic {
    fn of(elastic: Elastic, _: &Strength) -> Elastic {
        elastic
    }

    fn elastic(&self) -> Elastic {
        *self
    }

    fn respond(&self, strain: &Four, old: &Memory) -> Response {
        self.holds(self.trial(strain, old), old)
    }
}
