//! Strength of fill: what is wanted, what was found, and whether the one meets the other.

use super::moduli::Spread;
use serde::{Deserialize, Serialize};

/// The wanted friction angle is met within this [rad]: half a degree.
pub const ANGLE: f64 = 0.0087;
/// The wanted cohesion is met within this share of itself, and within [`COHESION`] of nothing.
pub const SHARE: f64 = 0.05;
/// Cohesion that counts as none [Pa].
pub const COHESION: f64 = 500.0;

/// What contacts between particles resist with.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Contact {
    /// Friction angle [rad].
    pub friction_angle: f64,
    /// Cohesion [Pa].
    pub cohesion: f64,
}

/// What the fill resists with, over all samples.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Strength {
    /// Contacts that it was measured with.
    pub contact: Contact,
    /// Friction angle of the fill [rad].
    pub friction_angle: Spread,
    /// Cohesion of the fill [Pa].
    pub cohesion: Spread,
    /// Confining pressure and mean stress at the peak [Pa].
    pub peaks: Vec<[f64; 2]>,
    /// Samples that did not come to rest under the confining pressure, or did not give way.
    pub left_out: usize,
}

/// What is wanted of the fill.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TargetStrength {
    /// Friction angle [rad].
    pub friction_angle: Option<f64>,
    /// Cohesion [Pa].
    pub cohesion: Option<f64>,
}

impl TargetStrength {
    /// Whether the strength of other packings bears out what is wanted: twice what a search leaves.
    pub fn checked_by(&self, strength: &Strength) -> bool {
        self.is_near(strength, 4.0 * ANGLE)
    }

    /// Whether a strength is what is wanted.
    pub fn met_by(&self, strength: &Strength) -> bool {
        self.is_near(strength, 2.0 * ANGLE)
    }

    fn is_near(&self, strength: &Strength, apart: f64) -> bool {
        let enough = |c: f64| (strength.cohesion.mean - c).abs() <= 2.0 * (SHARE * c).max(COHESION);
        self.friction_angle.is_none_or(|a| (strength.friction_angle.mean - a).abs() <= apart)
            && self.cohesion.is_none_or(enough)
    }
}
