//! Masonry as a body without any strength in tension.

use super::elastic::Elastic;
use super::polyhedron::{respond, tension};
use super::response::{Four, Law, Memory, Response};
use super::strength::Strength;

/// Elastic under compression; no principal stress is in tension (Del Piero 1989).
///
/// Cracking strain is whatever of the strain is not elastic, and closes again: stress follows from the strain alone, by the
/// closest point in energy, so that it has a potential and no memory. The memory it gives holds the cracking strain, for
/// those who show cracks. Where all three directions are cracked the tangent is next to nought.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NoTension {
    /// Elasticity.
    pub elastic: Elastic,
}

impl Law for NoTension {
    fn of(elastic: Elastic, _: &Strength) -> NoTension {
        NoTension { elastic }
    }

    fn elastic(&self) -> Elastic {
        self.elastic
    }

    fn respond(&self, strain: &Four, _old: &Memory) -> Response {
        respond(&self.elastic, strain, &Memory::default(), &tension(0.0))
    }
}
