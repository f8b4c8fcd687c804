//! Dynamic effects of moving loads.

use crate::{Factor, Source};
use serde::{Deserialize, Serialize};

/// By what a load at rest is increased because it moves.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
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
        /// How fill reduces what it adds, where it does.
        #[serde(default)]
        fill: Option<FillReduction>,
    },
    /// A factor that falls with the root of the determinant length: `numerator / (sqrt(share L) - subtrahend) + constant`,
    /// between `least` and `most`.
    Root {
        /// See above [m^0.5].
        numerator: f64,
        /// See above [m^0.5].
        subtrahend: f64,
        /// See above.
        constant: f64,
        /// Determinant length over the span.
        share: f64,
        /// Smallest factor.
        least: f64,
        /// Largest factor.
        most: f64,
        /// How cover reduces it, where it does.
        #[serde(default)]
        cover: Option<CoverReduction>,
        /// Where it is from.
        source: Source,
    },
    /// The loads of the model contain what motion adds: nothing comes on top.
    Included {
        /// Where that is said.
        source: Source,
    },
    /// A factor on the one axle where it does most harm; 1 on the others.
    CriticalAxle {
        /// The factor.
        factor: Factor,
    },
}

/// How fill above the crown reduces dynamic effects: `(1 - (1 - share) d / d1)` down to the depth `d1`, then linear to zero
/// over `vanishing` more.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
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

/// How deep cover reduces a dynamic factor: by so much a metre below a depth, never under 1.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct CoverReduction {
    /// Depth from which on it reduces [m].
    pub from_m: f64,
    /// What it takes off for every metre below [1/m].
    pub per_m: f64,
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
            Impact::AllAxles { factor, fill } => {
                let share = fill.as_ref().map_or(1.0, |fill| fill.share_at(depth));
                [1.0 + share * (factor.value - 1.0), 1.0]
            }
            Impact::CriticalAxle { factor } => [1.0, factor.value],
            Impact::Root { cover, .. } => {
                let off = cover.as_ref().map_or(0.0, |cover| cover.per_m * (depth - cover.from_m).max(0.0));
                [(self.root(length) - off).max(1.0), 1.0]
            }
            Impact::Included { .. } => [1.0, 1.0],
        }
    }

    /// The factor of [`Impact::Root`] without cover.
    fn root(&self, length: f64) -> f64 {
        let Impact::Root { numerator, subtrahend, constant, share, least, most, .. } = self else { return 1.0 };
        let below = (share * length).sqrt() - subtrahend;
        // So short a length that the formula has no value: its largest factor.
        if below > 0.0 { (numerator / below + constant).clamp(*least, *most) } else { *most }
    }

    /// Where it is from: every source of it.
    pub fn sources(&self) -> Vec<&Source> {
        match self {
            Impact::Augment { source, fill, .. } => {
                std::iter::once(source).chain(fill.as_ref().map(|fill| &fill.source)).collect()
            }
            Impact::AllAxles { factor, fill } => {
                std::iter::once(&factor.source).chain(fill.as_ref().map(|fill| &fill.source)).collect()
            }
            Impact::CriticalAxle { factor } => vec![&factor.source],
            Impact::Root { source, cover, .. } => {
                std::iter::once(source).chain(cover.as_ref().map(|cover| &cover.source)).collect()
            }
            Impact::Included { source } => vec![source],
        }
    }

    /// In a few words: "coefficient of dynamic augment", "1.8 on the critical axle".
    pub fn told(&self) -> String {
        match self {
            Impact::Augment { base, numerator_m, addend_m, most, .. } => {
                format!("1 + {base} + {numerator_m}/({addend_m} + L), at most {}", 1.0 + most)
            }
            Impact::AllAxles { factor, fill: None } => format!("{} on all axles", factor.value),
            Impact::AllAxles { factor, fill: Some(_) } => format!("{} on all axles, less under fill", factor.value),
            Impact::CriticalAxle { factor } => format!("{} on the critical axle", factor.value),
            Impact::Root { numerator, subtrahend, constant, share, most, .. } => {
                format!("{numerator}/(sqrt({share} L) - {subtrahend}) + {constant}, at most {most}")
            }
            Impact::Included { .. } => "contained in the loads".to_owned(),
        }
    }
}
