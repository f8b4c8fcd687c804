//! Soil that yields as a continuum: what limit analysis found of it, and what its figures are made from.

use crate::picture::Point;
use crate::published::{kilo, list, object};
use crate::wire::published;
use serde::{Deserialize, Serialize};

published! {
    /// What only a limit analysis with a continuum reports.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct ContinuumReport |soil| {
        /// Upper over lower bound.
        pub bound_ratio: Option<f64>,
        /// Upper over lower bound at which refinement was to end.
        pub wanted_ratio: f64 [kept],
        /// Triangles of the last mesh.
        pub elements: usize,
        /// Share of cohesion and of the tangent of the friction angle that is mobilised.
        pub mobilised_share: f64,
        /// Dilatancy angle [rad].
        pub dilatancy_angle: f64 [deg],
        /// Both bounds of a soil that dilates by its friction angle, at the same share [N/m].
        pub associated: Option<[f64; 2]> [kN/m] as associated_bounds,
        /// Load at which the iteration for flow with less dilation settled [N/m]: an estimate, and no bound.
        pub iterated: Option<f64> [kN/m] as iterated_load,
        /// Lower bound in plane strain, where spandrel walls bound the stress out of the plane [N/m].
        pub plane_strain?: Option<f64> [kN/m] as plane_strain_load,
        /// How a piece of spandrel wall gives way in the mechanism: "tilts" or "slides".
        = wall_gives?: Option<String> = soil.wall.map(|wall| if wall.tilts { "tilts" } else { "slides" }),
        /// The ends of that piece along the bridge, in m.
        = wall_gives_at?: Option<[f64; 2]> = soil.wall.map(|wall| wall.ends),
        /// The piece of a spandrel wall that gives way the most in the mechanism, where walls bound the stress out of the plane.
        pub wall: Option<WallThatGives> [kept],
        /// The least and the largest share that the range is for.
        pub shares: [f64; 2] as range_shares,
        /// Lower bound at the least share and upper bound at the largest one [N/m].
        pub range: Option<[f64; 2]> [kN/m],
        /// Share of the permanent loads that is carried, where they are not.
        pub permanent_share?: Option<f64>,
        /// This share of the permanent loads is carried by stresses that were found, where none were found that carry all of them.
        pub carried_share: Option<f64> [kept],
        /// Share of the loads that stands beyond the ends of the fill and is left out.
        pub left_out: f64 as load_left_out,
        /// Largest velocity that the flow rule does not allow, relative to the fastest.
        pub flow_violation: Option<f64>,
        /// Every mesh: `elements`, `lower_bound_kn_per_m`, `upper_bound_kn_per_m`.
        pub rounds: Vec<(usize, Option<f64>, Option<f64>)> as meshes = list(&soil.rounds, |(elements, lower, upper)| object! {
            elements: *elements,
            lower_bound_kn_per_m: lower.map(kilo),
            upper_bound_kn_per_m: upper.map(kilo),
        }),
    }
}

/// A piece of a spandrel wall that gives way.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct WallThatGives {
    /// Its ends [m].
    pub ends: [f64; 2],
    /// Whether it tilts outwards; else it slides.
    pub tilts: bool,
    /// What it resists with: moment about its bed where it tilts [N m], force where it slides [N].
    pub resists: f64,
}

/// Soil as triangles, with stresses that are carried and a motion that is not.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct SoilPicture {
    /// Corners [m].
    pub points: Vec<Point>,
    /// Corners of each triangle, counter-clockwise.
    pub triangles: Vec<[usize; 3]>,
    /// The region of each triangle: layers and backing, from below upwards.
    pub regions: Vec<usize>,
    /// Stress at the corners of each triangle [Pa], tension positive: xx, yy, xy. In equilibrium at the lower bound.
    pub stresses: Vec<[[f64; 3]; 3]>,
    /// Motion of each corner in the mechanism of the upper bound, in the scale of [`crate::picture::Picture::mechanism`].
    pub motions: Vec<Point>,
    /// Power that each triangle dissipates in that mechanism, per area, relative to the largest.
    pub dissipation: Vec<f64>,
    /// Share of the gap between the bounds that each triangle holds.
    pub gaps: Vec<f64>,
    /// Pressure on the backs of blocks, from left to right.
    pub pressures: Vec<SoilPressure>,
    /// Plates under loads: their ends, and how they move: translation of the middle and rotation.
    pub plates: Vec<Plate>,
}

/// What soil exerts on a straight stretch of a block.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SoilPressure {
    /// The block: index into the shapes.
    pub block: usize,
    /// Its ends [m].
    pub ends: [Point; 2],
    /// Pressure at the ends [Pa], positive.
    pub pressure: [f64; 2],
    /// Shear stress at the ends [Pa], positive where it pulls the block from the first end to the second.
    pub shear: [f64; 2],
}

/// A rigid plate through which a load stands on the soil.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Plate {
    /// Its ends [m].
    pub ends: [Point; 2],
    /// How its ends move in the mechanism.
    pub motions: [Point; 2],
}
