//! What is wrong with a ring: where, and how much of it is lost.

pub use crate::sensor::Face;

use serde::{Deserialize, Serialize};

/// A defect of a span's rings over a stretch of it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Defect {
    /// What it is.
    pub kind: DefectKind,
    /// Where it begins and ends, horizontally from the span's left springing [m].
    pub from_to: [f64; 2],
    /// The same as shares of the intrados' arc length from the left springing.
    pub shares: [f64; 2],
}

/// What a defect takes away. Rings count from 0, from the intrados up.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum DefectKind {
    /// Mortar that is lost from the joints.
    LostMortar {
        /// From which face.
        face: Face,
        /// How deep [m].
        depth: f64,
    },
    /// A ring that is thinner than elsewhere: stones that spalled or were cut.
    ThinRing {
        /// On which face.
        face: Face,
        /// By how much [m].
        depth: f64,
    },
    /// A ring that has come off the one above it.
    RingSeparation {
        /// The lower of both rings.
        ring: usize,
        /// Angle of friction between both [rad]; that of their joint where none is given.
        friction_angle: Option<f64>,
    },
    /// Masonry that is weaker than elsewhere.
    WeakMasonry {
        /// The ring; none for all.
        ring: Option<usize>,
        /// Compressive strength [Pa], where it is less.
        compressive_strength: Option<f64>,
        /// Angle of friction of the joints [rad], where it is less.
        friction_angle: Option<f64>,
    },
    /// Stones that have fallen out of the lowest ring of several.
    MissingStones,
    /// One joint that stands open, as a hinge that has formed: no thrust crosses what is open.
    OpenJoint {
        /// From which face.
        face: Face,
        /// How deep [m].
        depth: f64,
    },
    /// Stones of a single ring that have slid down: their joints bear on what still overlaps.
    DroppedStones {
        /// By how much [m].
        depth: f64,
    },
}

impl DefectKind {
    /// Whether it takes weight away or changes the shape, which may also help; what only makes joints weaker never does.
    #[must_use]
    pub const fn may_help(&self) -> bool {
        matches!(self, Self::ThinRing { .. } | Self::MissingStones | Self::DroppedStones { .. })
    }
}

impl Defect {
    /// How much of its depth is lost at a share of the arc length: all within the stretch, and beyond its ends falling to nothing over
    /// the length of a voussoir of a ring of so many. That way the section of a joint follows the ends of the stretch continuously, and
    /// no stretch lies unseen between two joints.
    ///
    /// A joint that stands open is the nearest one to its place: whole up to half a voussoir away, nothing at a whole one. Halfway between
    /// two joints both are open.
    pub fn extent(&self, share: f64, voussoirs: usize) -> f64 {
        if let DefectKind::OpenJoint { .. } = self.kind {
            return (2.0 - 2.0 * (share - self.shares[0]).abs() * voussoirs as f64).clamp(0.0, 1.0);
        }
        let beyond = (self.shares[0] - share).max(share - self.shares[1]).max(0.0);
        (1.0 - beyond * voussoirs as f64).max(0.0)
    }

    /// Whether a part of the arc, from one share to another, lies in the stretch, however little of it.
    pub fn touches(&self, [from, to]: [f64; 2]) -> bool {
        self.shares[0] < to && self.shares[1] > from
    }
}

/// Depth that stones have lost from a face of a span's rings at a share of the arc length [m]: the largest of its defects.
pub fn thinned(defects: &[Defect], face: Face, share: f64, voussoirs: usize) -> f64 {
    let depth = |defect: &Defect| match defect.kind {
        DefectKind::ThinRing { face: on, depth } if on == face => depth * defect.extent(share, voussoirs),
        _ => 0.0,
    };
    defects.iter().map(depth).fold(0.0, f64::max)
}

/// Depth to which joints have lost their mortar, from the face as it is now [m]: the largest of its defects.
pub fn raked(defects: &[Defect], face: Face, share: f64, voussoirs: usize) -> f64 {
    let depth = |defect: &Defect| match defect.kind {
        DefectKind::LostMortar { face: on, depth } | DefectKind::OpenJoint { face: on, depth } if on == face => {
            depth * defect.extent(share, voussoirs)
        }
        // Stones that went down left their neighbours' upper ends bare.
        DefectKind::DroppedStones { depth } if face == Face::Extrados => depth * defect.extent(share, voussoirs),
        _ => 0.0,
    };
    defects.iter().map(depth).fold(0.0, f64::max)
}
