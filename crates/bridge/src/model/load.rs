//! Loads of the file, and how cover spreads them.

use crate::choice::choice;

/// A load on the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// What it is called.
    pub name: String,
    /// Its shape.
    pub kind: LoadKind,
    /// Position of its reference point (middle of a knife edge or patch, first axle of a pattern) along the
    /// bridge, from the left springing of the first span, at the intrados [m].
    pub position: f64,
    /// The block that brings it onto the surface, where there is one.
    pub block: Option<LoadingBlock>,
    /// Force along the bridge as a share of the load, to the right positive: braking, traction, wind along the road.
    pub horizontal: f64,
    /// Whether a pressure acts over its whole length; otherwise it may be shorter, where that does more harm.
    pub whole_length: bool,
}

/// A rigid block of the load's length that stands on the surface, held against rotation and sideways movement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadingBlock {
    /// Its weight [N/m]; counted in the load.
    pub weight: f64,
}

/// Shape and size of a load. Forces are vertical, downwards positive.
#[derive(Debug, Clone, PartialEq)]
pub enum LoadKind {
    /// A strip across the whole width: total force per metre of width [N/m] over `length` [m] along the bridge.
    KnifeEdge {
        /// Force [N/m].
        force: f64,
        /// Length along the bridge [m].
        length: f64,
    },
    /// A pressure [Pa] over `length` [m] along the bridge, across the whole width.
    Patch {
        /// Pressure [Pa].
        pressure: f64,
        /// Length along the bridge [m].
        length: f64,
    },
    /// Axles, each a total force [N] over the effective width, at offsets from the reference point, to the left
    /// (a vehicle that drives to the right).
    Axles {
        /// Force [N] and offset behind the first axle [m].
        axles: Vec<(f64, f64)>,
        /// Length of a wheel's footprint along the bridge [m].
        contact_length: f64,
        /// Width of the barrel that carries one axle [m].
        effective_width: f64,
    },
}

/// How a load spreads from the surface to the extrados.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dispersal {
    /// Which rule.
    pub rule: DispersalRule,
    /// Vertical to horizontal slope on each side (2 means 2 vertical to 1 horizontal).
    pub slope: f64,
}

choice! {
    /// The rule by which pressure is distributed over the dispersed length.
    pub enum DispersalRule {
        /// straight down onto the extrados
        None = "none",
        /// uniform over the dispersed length
        Uniform = "uniform",
        /// intensity at the ends inversely proportional to their depth (Rouxinol, Providência and Lemos, eq. 2)
        InverseDepth = "inverse-depth",
        /// Boussinesq's strip, cut off at the slope and scaled to the whole force
        Boussinesq = "boussinesq",
    }
}
