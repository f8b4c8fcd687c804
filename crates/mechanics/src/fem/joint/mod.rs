//! What a pair of facing points answers to being moved apart: traction, tangent, new memory and state. Pure functions.
//!
//! Components run `[normal, tangential]`. Opening is positive normally where the points are apart, and tangentially where the
//! point of side `two` has moved, relative to that of side `one`, along the way walked. Traction is what works on
//! that opening: positive normally in tension. Memory is that at the end of the last step that was kept.

mod breaking;
mod contact;
mod mortar;

pub(super) use breaking::weakest;
pub use contact::Contact;
pub use mortar::{LiftOff, Mortar, Shear};

/// Whether a pair touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PairState {
    /// It carries and holds.
    #[default]
    Closed,
    /// It has come apart.
    Open,
    /// It touches, and its shear is at its strength.
    Sliding,
}

/// What a pair remembers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PairMemory {
    /// Tangential opening at which the shear would vanish [m].
    pub slip: f64,
    /// Normal opening at which the compression would vanish [m]; below zero where the joint was crushed.
    pub crush: f64,
    /// Whether what strength it had in tension is lost.
    pub broken: bool,
    /// State at the end of the step.
    pub state: PairState,
}

/// Answer of a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairResponse {
    /// Traction [Pa]: normal (tension positive), shear.
    pub traction: [f64; 2],
    /// Consistent tangent [Pa/m]: `d traction[i] / d opening[j]`. Unsymmetric where friction slides.
    pub tangent: [[f64; 2]; 2],
    /// Memory if this opening is kept.
    pub memory: PairMemory,
    /// State at this opening.
    pub state: PairState,
}

/// The law of one kind of interface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum JointLaw {
    /// A mortar bed: springs that lift off, and shear up to a strength or to friction.
    Mortar(Mortar),
    /// Coulomb friction.
    Contact(Contact),
}

impl JointLaw {
    /// Whether its tangent is symmetric wherever it stands.
    #[must_use]
    pub fn symmetric(&self) -> bool {
        match self {
            JointLaw::Mortar(law) => !law.shear.frictional(),
            JointLaw::Contact(law) => law.friction <= 0.0,
        }
    }

    /// Stiffness per area [Pa/m] while it is closed and holds: normal, tangential.
    #[must_use]
    pub fn stiffness(&self) -> [f64; 2] {
        match self {
            JointLaw::Mortar(law) => [law.normal, law.tangential],
            JointLaw::Contact(law) => [law.normal, law.tangential],
        }
    }

    /// Tension over the strength of a pair that lets go of it at once when it breaks; nothing of others and of those that are broken. Beyond one the
    /// pair still answers as if it were whole: whoever seeks balance marks the pairs that break ([`PairMemory::broken`]).
    #[must_use]
    pub fn overstress(&self, tension: f64, area: f64, memory: &PairMemory) -> f64 {
        match self {
            JointLaw::Mortar(law) => law.overstress(tension, area, memory),
            JointLaw::Contact(_) => 0.0,
        }
    }

    /// Whether a closed pair provably stays closed and keeps its memory at all `L` openings [m], so that it answers with the
    /// stiffness of [`JointLaw::stiffness`]. `false` proves nothing: the law has to be evaluated.
    #[inline(always)]
    pub(super) fn provably_linear<const L: usize>(&self, opening: &[[f64; L]; 2], area: f64, old: &PairMemory) -> bool {
        let holds = match self {
            JointLaw::Mortar(law) => law.provably_linear(opening, area, old),
            JointLaw::Contact(law) => law.provably_linear(opening, old),
        };
        holds & (old.state == PairState::Closed) & (old.slip.is_finite() & old.crush.is_finite())
    }

    /// Answers an opening [m] of a pair that stands for an area [m² per metre of width, so m].
    #[must_use]
    pub fn respond(&self, opening: [f64; 2], area: f64, old: &PairMemory) -> PairResponse {
        match self {
            JointLaw::Mortar(law) => law.respond(opening, area, old),
            JointLaw::Contact(law) => law.respond(opening, old),
        }
    }
}
