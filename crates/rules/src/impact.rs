//! Dynamic effects of moving loads.

use crate::shape::{forms, table};
use crate::{Factor, Source};

forms! {
    /// By what a load at rest is increased because it moves.
    pub enum Impact {
        /// The loads of the model contain what motion adds: nothing comes on top.
        Included = "included" {
            must source: Source, "where it is said that the loads contain what motion adds";
        }
        /// One factor on all axles.
        AllAxles = "all-axles" {
            must factor: Factor, "factor on every axle";
            may fill: Option<FillReduction>, "how fill lessens what it adds";
        }
        /// A factor on the one axle where it does most harm; 1 on the others.
        CriticalAxle = "critical-axle" {
            must factor: Factor, "factor on the one axle where it harms most; 1 on the others";
        }
        /// A coefficient of dynamic augment that falls with the loaded length: `base + numerator / (addend + L)`, at most `most`.
        Augment = "augment" {
            must base: f64, "coefficient base + numerator_m / (addend_m + L) over the loaded span L";
            must numerator_m: f64, "see base [m]";
            must addend_m: f64, "see base [m]";
            must most: f64, "largest coefficient";
            may fill: Option<FillReduction>, "how fill lessens it";
            must source: Source, "where it is from";
        }
        /// A factor that falls with the root of the determinant length: `numerator / (sqrt(share L) - subtrahend) + constant`,
        /// between `least` and `most`.
        Root = "root" {
            /// It is in m^0.5, and so is the subtrahend.
            must numerator: f64, "factor numerator / (sqrt(share L) - subtrahend) + constant over the loaded span L";
            must subtrahend: f64, "see numerator";
            must constant: f64, "see numerator";
            must share: f64, "determinant length over the span";
            must least: f64, "smallest factor";
            must most: f64, "largest factor";
            may cover: Option<CoverReduction>, "how cover lessens it";
            must source: Source, "where it is from";
        }
    }
}

table! {
    /// How fill above the crown reduces dynamic effects: `(1 - (1 - share) d / d1)` down to the depth `d1`, then linear to zero
    /// over `vanishing` more.
    pub struct FillReduction = "fill" {
        must depth_m: f64, "depth of fill down to which the share falls linearly from 1 [m]";
        must share: f64, "what is left of the dynamic effect there";
        must vanishing_m: f64, "further depth at which nothing is left [m]";
        must source: Source, "where it is from";
    }
}

table! {
    /// How deep cover reduces a dynamic factor: by so much a metre below a depth, never under 1.
    pub struct CoverReduction = "cover" {
        must from_m: f64, "depth from which on cover lessens the factor [m]";
        must per_m: f64, "what it takes off for every metre below; the factor stays 1 at least";
        must source: Source, "where it is from";
    }
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

    /// Factor on all axles, and further factor on the critical one, over a loaded length under fill of a depth [m].
    pub fn factors(&self, length: f64, depth: f64) -> [f64; 2] {
        let left = |fill: &Option<FillReduction>| fill.as_ref().map_or(1.0, |fill| fill.share_at(depth));
        match self {
            Impact::Augment { fill, .. } => [1.0 + self.total_augment(length).unwrap_or(0.0) * left(fill), 1.0],
            Impact::AllAxles { factor, fill } => [1.0 + left(fill) * (factor.value - 1.0), 1.0],
            Impact::CriticalAxle { factor } => [1.0, factor.value],
            Impact::Root { numerator, subtrahend, constant, share, least, most, cover, .. } => {
                let below = (share * length).sqrt() - subtrahend;
                // So short a length that the formula has no value: its largest factor.
                let bare = if below > 0.0 { (numerator / below + constant).clamp(*least, *most) } else { *most };
                let off = cover.as_ref().map_or(0.0, |cover| cover.per_m * (depth - cover.from_m).max(0.0));
                [(bare - off).max(1.0), 1.0]
            }
            Impact::Included { .. } => [1.0, 1.0],
        }
    }

    /// Where it is from: every source of it.
    pub fn sources(&self) -> Vec<&Source> {
        let (first, more) = match self {
            Impact::Augment { source, fill, .. } => (source, fill.as_ref().map(|fill| &fill.source)),
            Impact::AllAxles { factor, fill } => (&factor.source, fill.as_ref().map(|fill| &fill.source)),
            Impact::Root { source, cover, .. } => (source, cover.as_ref().map(|cover| &cover.source)),
            Impact::CriticalAxle { factor } => (&factor.source, None),
            Impact::Included { source } => (source, None),
        };
        std::iter::once(first).chain(more).collect()
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
