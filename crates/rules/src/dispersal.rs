//! How far a wheel's or sleeper's load has spread at a depth below the surface.

use crate::Source;
use crate::shape::{table, words};

table! {
    /// Length and width over which an axle's load has spread at a depth: a base, plus so much of the depth.
    pub struct Dispersal = "dispersal" {
        must length_base_m: f64, "length along the bridge at the surface [m]";
        must length_per_depth: f64, "its growth with depth, both sides together";
        must width_base_m: f64, "added to the distance of the wheels at the surface [m]; with strip_at_most_m the strip of one rail";
        must width_per_depth: f64, "its growth with depth, both sides together";
        /// Two strips then stand beside one another.
        may strip_at_most_m: Option<f64>, "widths are those of one rail's or wheel line's strip, each at most so wide [m]";
        may[default] least_depth_m: f64,
            "depth of cover at the crown from which on loads spread through it; above a shallower one they do not [m]";
        must pressure: Pressure, "how it is shared out over the length";
        must source: Source, "where it is from";
    }
}

words! {
    /// How pressure is shared out over a dispersed length.
    pub enum Pressure {
        /// Alike everywhere.
        Uniform = "uniform",
        /// At the ends inversely proportional to their depth, linear in between.
        InverseDepth = "inverse-depth",
        /// As Boussinesq's strip, cut off at the slope.
        Boussinesq = "boussinesq",
    }
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
