//! Dynamic effects of moving loads.

use crate::{Factor, Source};
use serde::Deserialize;

/// By what a load at rest is increased because it moves.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Impact {
    /// A coefficient of dynamic augment that falls with the loaded length: `base + numerator / (addend + L)`, at most `most`.
    Augment {
        /// The part that does not depend on the length.
        base: f64,
        /// See above [m].
        numerator_m: f64,
        /// See above [m].
        addend_m: f64,
        /// Largest coefficient.
        most: f64,
        /// How fill reduces it, where it does.
        fill: Option<FillReduction>,
        /// Where it is from.
        source: Source,
    },
    /// One factor on all axles.
    AllAxles {
        /// The factor.
        factor: Factor,
    },
    /// A factor on the one axle where it does most harm; 1 on the others.
    CriticalAxle {
        /// The factor.
        factor: Factor,
    },
}

/// How fill above the crown reduces dynamic effects: `(1 - (1 - share) d / d1)` down to the depth `d1`, then linear to zero
/// over `vanishing` more.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FillReduction {
    /// Depth `d1` [m].
    pub depth_m: f64,
    /// What is left at that depth.
    pub share: f64,
    /// Depth below `d1` at which nothing is left [m].
    pub vanishing_m: f64,
    /// Where it is from.
    pub source: Source,
}

impl FillReduction {
    /// What is left of a dynamic effect under so much fill [m].
    pub fn share_at(&self, depth: f64) -> f64 {
        let d = depth.max(0.0);
        if d <= self.depth_m {
            1.0 - (1.0 - self.share) * d / self.depth_m
        } else {
            self.share * (1.0 - (d - self.depth_m) / self.vanishing_m).max(0.0)
        }
    }
}

impl Impact {
    /// The coefficient of dynamic augment over a loaded length [m], without fill; none for rules that have no such thing.
    pub fn total_augment(&self, length: f64) -> Option<f64> {
        match self {
            Impact::Augment { base, numerator_m, addend_m, most, .. } => {
                Some((base + numerator_m / (addend_m + length)).min(*most))
            }
            _ => None,
        }
    }

    /// The coefficient of dynamic augment over a loaded length under fill of a depth above the crown [m].
    pub fn design_augment(&self, length: f64, depth: f64) -> Option<f64> {
        let total = self.total_augment(length)?;
        match self {
            Impact::Augment { fill: Some(fill), .. } => Some(total * fill.share_at(depth)),
            _ => Some(total),
        }
    }

    /// Factor on all axles, and further factor on the critical one, over a loaded length under fill of a depth [m].
    pub fn factors(&self, length: f64, depth: f64) -> [f64; 2] {
        match self {
            Impact::Augment { .. } => [1.0 + self.design_augment(length, depth).unwrap_or(0.0), 1.0],
            Impact::AllAxles { factor } => [factor.value, 1.0],
            Impact::CriticalAxle { factor } => [1.0, factor.value],
        }
    }
}
