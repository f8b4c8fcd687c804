//! What a law answers to strain: stress, tangent and new memory.

use super::elastic::Elastic;
use super::strength::Strength;

/// Strain or stress: `[xx, yy, zz, xy]`.
pub type Four = [f64; 4];

/// What a point remembers of its past; laws use of it what they need.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Memory {
    /// Plastic (or cracking) strain.
    pub plastic: Four,
    /// Accumulated plastic strain: the sum over steps of the length of its increment (engineering shear counted half).
    pub hardening: f64,
}

/// Answer of a law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response {
    /// Stress [Pa].
    pub stress: Four,
    /// Consistent tangent [Pa]: `d stress[i] / d strain[j]`. Unsymmetric where flow is not associated.
    pub tangent: [[f64; 4]; 4],
    /// Memory if this strain is kept.
    pub memory: Memory,
    /// Whether the point flows, cracks or slips at this strain.
    pub yields: bool,
}

/// A law of a solid: what each says of itself, in its file.
pub trait Law {
    /// The law of a solid of this elasticity and strength.
    fn of(elastic: Elastic, strength: &Strength) -> Self;

    /// The elasticity that it starts from.
    fn elastic(&self) -> Elastic;

    /// Whether its tangent is symmetric wherever it stands.
    fn symmetric(&self) -> bool {
        true
    }

    /// Answers a total strain from the memory at the end of the last step that was kept.
    fn respond(&self, strain: &Four, old: &Memory) -> Response;
}
