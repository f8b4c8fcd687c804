//! How far a wheel's or sleeper's load has spread at a depth below the surface.

use crate::Source;
use serde::{Deserialize, Serialize};

/// Length and width over which an axle's load has spread at a depth: a base, plus so much of the depth.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Dispersal {
    /// Length along the bridge at the surface [m].
    pub length_base_m: f64,
    /// Growth of the length with depth, both sides together.
    pub length_per_depth: f64,
    /// Added to the distance between the wheels of an axle at the surface [m].
    pub width_base_m: f64,
    /// Growth of the width with depth, both sides together.
    pub width_per_depth: f64,
    /// Whether the widths above are those of one rail's or wheel line's strip, in place of the axle's: two strips then stand
    /// beside one another, each at most so wide [m].
    #[serde(default)]
    pub strip_at_most_m: Option<f64>,
    /// Depth of cover above the crown from which on loads spread through it; above a shallower one they keep their base [m].
    #[serde(default)]
    pub least_depth_m: f64,
    /// How the pressure is shared out over the length.
    pub pressure: Pressure,
    /// Where it is from.
    pub source: Source,
}

/// How pressure is shared out over a dispersed length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Pressure {
    /// Alike everywhere.
    Uniform,
    /// At the ends inversely proportional to their depth, linear in between.
    InverseDepth,
    /// As Boussinesq's strip, cut off at the slope.
    Boussinesq,
}

impl Dispersal {
    /// Length along the bridge at a depth [m].
    pub fn length_at(&self, depth: f64) -> f64 {
        self.length_base_m + self.length_per_depth * self.spreading(depth)
    }

    /// Width across the bridge at a depth for wheels so far apart [m].
    pub fn width_at(&self, depth: f64, wheel_track: f64) -> f64 {
        let strip = self.strip_at(depth);
        match self.strip_at_most_m {
            // Strips that meet share the width between them.
            Some(most) => (2.0 * strip.min(most)).min(wheel_track + strip),
            None => wheel_track + strip,
        }
    }

    /// How far the spread load reaches beyond the middle of an outer wheel or rail at a depth [m].
    pub fn overhang_at(&self, depth: f64) -> f64 {
        let strip = self.strip_at(depth);
        0.5 * self.strip_at_most_m.map_or(strip, |most| strip.min(most))
    }

    /// The depth over which loads spread [m]: none where the cover is shallower than the rule asks.
    pub fn spreading(&self, depth: f64) -> f64 {
        if depth < self.least_depth_m { 0.0 } else { depth }
    }

    /// Width of what one wheel or rail has spread to [m], by itself.
    fn strip_at(&self, depth: f64) -> f64 {
        self.width_base_m + self.width_per_depth * self.spreading(depth)
    }

    /// Vertical to one horizontal, on each side along the bridge; infinite where the length does not grow.
    pub fn slope(&self) -> f64 {
        2.0 / self.length_per_depth
    }
}
