//! What peaks tell: do they depend on speed, do lines across the barrel differ?
//!
//! Each question has two tests, since the failure to see an effect is no proof that there is none. An F test says whether group
//! means differ beyond their scatter. Two one-sided t tests say whether an effect as large as would matter can be excluded. "Not seen"
//! is answered only where the F test sees nothing *and* the one-sided tests exclude what matters; otherwise the answer is that
//! the records cannot tell.

mod anova;
mod dynamics;
mod plane_strain;

pub use anova::Test;
pub use dynamics::{ChannelTest, Dynamics, dynamics};
pub use plane_strain::{LineTest, PlaneStrain, plane_strain};
use serde::{Deserialize, Serialize};

/// Chance of seeing an effect where there is none [-].
const LEVEL: f64 = 0.05;

/// The effect that matters, as a share of the peak [-]. A tenth is the norm that a good calibration reaches: smaller effects drown
/// in its misfit.
const MATTERS: f64 = 0.1;

/// Speeds up to this ratio are one class [-].
const SAME_SPEED: f64 = 1.15;

/// An answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Answer {
    /// No effect seen, and one that matters would have been.
    NotSeen,
    /// An effect beyond the scatter, but smaller than what matters.
    SeenButSmall,
    /// An effect beyond the scatter, as large as what matters or not proven smaller.
    Seen,
    /// The records are too few or scatter too much.
    CannotTell,
}

impl Answer {
    /// The word that scripts read.
    pub fn word(self) -> &'static str {
        match self {
            Answer::NotSeen => "not-seen",
            Answer::SeenButSmall => "seen-but-small",
            Answer::Seen => "seen",
            Answer::CannotTell => "cannot-tell",
        }
    }

    fn of(seen: bool, excluded: bool) -> Answer {
        match (seen, excluded) {
            (false, true) => Answer::NotSeen,
            (true, true) => Answer::SeenButSmall,
            (true, false) => Answer::Seen,
            (false, false) => Answer::CannotTell,
        }
    }
}
