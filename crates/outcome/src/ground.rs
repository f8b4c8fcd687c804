//! A bridge from above and cut across its crown: what its drawings in plan and in cross-section are made of.

use serde::{Deserialize, Serialize};

/// What stands at the edges of the road and on it, as drawings show it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Edges {
    /// Height of a parapet above the road, and its thickness [m].
    pub parapet: Option<[f64; 2]>,
    /// Distance of a kerb's face from the edge of the barrel, and its height above the road [m].
    pub kerb: Option<[f64; 2]>,
    /// Middles of tracks, from the edge from which cracks are measured [m]; none on roads.
    pub tracks: Vec<f64>,
    /// Distance between the middles of both rails [m].
    pub gauge: f64,
}

/// A defect of the first span at its crown, cut across.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CrownDefect {
    /// What it is, in a few words.
    pub what: String,
    /// From and to which height above the intrados it reaches [m].
    pub heights: [f64; 2],
}

/// Plan and cross-section.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct GroundPlan {
    /// Name of the bridge.
    pub bridge: String,
    /// Width of the barrel [m].
    pub width: f64,
    /// Whether the file gives its skew, be it 0.
    pub skew_given: bool,
    /// Spans from left to right.
    pub spans: Vec<SpanInPlan>,
    /// Piers from left to right.
    pub piers: Vec<PierInPlan>,
    /// Longitudinal cracks, from one edge [m].
    pub cracks: Vec<f64>,
    /// Thickness of each ring at the crown of the first span, from the intrados [m].
    pub rings: Vec<f64>,
    /// Layers above that crown, from the extrados up: name and thickness [m].
    pub layers: Vec<(String, f64)>,
    /// Thickness of one of two spandrel walls [m]; none where the file has none.
    pub wall: Option<f64>,
    /// What stands at the edges and on the road.
    pub edges: Edges,
    /// Defects of the first span at its crown.
    pub defects: Vec<CrownDefect>,
    /// The governing vehicle and how it stands across, where vehicles were moved.
    pub vehicle: Option<VehicleAcross>,
}

/// A span from above.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SpanInPlan {
    /// Its springings along the road's axis [m].
    pub from_to: [f64; 2],
    /// Its skew [rad].
    pub skew: f64,
}

/// A pier from above.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PierInPlan {
    /// Its outline with its cutwaters at the springings, as if the bridge were square: along and across the road's axis [m].
    pub outline: Vec<[f64; 2]>,
    /// Its skew, the mean of its spans [rad].
    pub skew: f64,
    /// How many cutwaters it has.
    pub cutwaters: usize,
}

/// A vehicle across the bridge.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct VehicleAcross {
    /// Its code.
    pub code: String,
    /// Lines of wheels or rails, from the edge from which cracks are measured [m].
    pub wheels: Vec<f64>,
    /// The strip that carries it, where cracks divide the barrel [m].
    pub strip: Option<[f64; 2]>,
    /// Width of the barrel that carries an axle [m].
    pub width: f64,
    /// How that width was found.
    pub derivation: String,
}
