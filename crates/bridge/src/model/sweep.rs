//! Loads and vehicles that move, and the width that they share.

use crate::choice::choice;

/// Vehicles that are moved over the bridge by limit analysis.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepPlan {
    /// The rule of the library, unless a file is given.
    pub rule: String,
    /// A file with a rule, relative to the bridge file.
    pub rule_file: Option<String>,
    /// Vehicles, load models or trains of the library, by their codes; empty for all.
    pub vehicles: Vec<String>,
    /// Files of vehicles, relative to the bridge file.
    pub vehicle_files: Vec<String>,
    /// Distance between positions [m]; from the spans where the file gives none.
    pub step: Option<f64>,
    /// Which ways vehicles drive.
    pub directions: Directions,
    /// Whether every run of neighbouring axles is tried.
    pub subsets: bool,
    /// Whether loads spread by the file's [dispersal] in place of the rule's.
    pub own_dispersal: bool,
    /// Force along the bridge as a share of each axle and uniform load, to the right and to the left: braking and traction.
    pub braking: f64,
    /// Whether the file writes that share, be it 0.
    pub braking_given: bool,
    /// Why it is what it is, as the file says.
    pub braking_reason: Option<String>,
    /// Whether the governing case is made by discrete elements too.
    pub discrete_elements: bool,
    /// Names and texts of the files, the rule's first; empty until somebody reads them.
    pub texts: Vec<(String, String)>,
}

/// Where vehicles may stand across the bridge, and what divides its barrel.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Carriageway {
    /// How many vehicles may stand abreast: lanes of a road, tracks of a railway.
    pub lanes: Option<usize>,
    /// Distance between the middles of two of them [m].
    pub lane_width: Option<f64>,
    /// Distance from an edge of the barrel to the middle of the nearest wheel or rail [m].
    pub edge_distance: Option<f64>,
    /// Angle between the bridge's axis and the normal of its springings [rad], of spans that give none of their own: 0 for a square bridge.
    pub skew: Option<f64>,
    /// Distances of longitudinal cracks through the barrel from one of its edges, from the least [m].
    pub cracks: Vec<f64>,
    /// What moves the resultant of a vehicle sideways.
    pub sideways: Sideways,
}

/// What moves the resultant of a vehicle away from the middle between its wheels or rails.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sideways {
    /// Radius of the curve and speed on it [m, m/s].
    pub curve: Option<(f64, f64)>,
    /// Level of the outer rail above the inner one [m].
    pub cant: f64,
    /// Force across the bridge as a share of the weight, to either side.
    pub side_force: f64,
    /// Height above the rail or the road at which both act [m].
    pub height: f64,
    /// Distance between the middles of both rails, or of the wheels on an axle [m].
    pub gauge: f64,
}

impl Default for Sideways {
    fn default() -> Sideways {
        Sideways { curve: None, cant: 0.0, side_force: 0.0, height: GRAVITY_HEIGHT, gauge: GAUGE }
    }
}

/// Least distance between places of a sweep [m]: closer ones tell nothing more, and a slip in the unit would take days.
pub const LEAST_STEP: f64 = 1e-3;

/// Height of a vehicle's centre of gravity above the rail [m], where the file gives none.
pub const GRAVITY_HEIGHT: f64 = 1.8;
/// Distance between the middles of both rails [m], where the file gives none.
pub const GAUGE: f64 = 1.5;

impl Sideways {
    /// Largest distance of the resultant from the middle between the rails [m], and whether it is that of a vehicle that moves: with speed v on
    /// radius r, cant c, gauge s and side force w at height h it is h (|v^2 / (g r) - c / s| + w); standing, h (c / s + w).
    pub fn eccentricity(&self, gravity: f64) -> (f64, bool) {
        let outwards = self.curve.map_or(0.0, |(radius, speed)| speed * speed / (gravity * radius));
        let inwards = self.cant / self.gauge;
        let [moving, standing] =
            [(outwards - inwards).abs(), inwards].map(|share| self.height * (share + self.side_force));
        if moving > standing { (moving, true) } else { (standing, false) }
    }
}

/// The strips that longitudinal cracks leave of a barrel so wide, from one edge to the other [m]; cracks from the least distance on.
pub fn strips(width: f64, cracks: &[f64]) -> Vec<[f64; 2]> {
    let inner = cracks.iter().copied().filter(|crack| *crack > 0.0 && *crack < width);
    let borders: Vec<f64> = std::iter::once(0.0).chain(inner).chain([width]).collect();
    borders.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// Width of the widest of them [m].
pub fn widest_strip(width: f64, cracks: &[f64]) -> f64 {
    strips(width, cracks).iter().map(|[from, to]| to - from).fold(0.0, f64::max)
}

choice! {
    /// Which ways vehicles drive.
    pub enum Directions {
        /// to the right and to the left
        Both = "both",
        /// to the right
        Right = "right",
        /// to the left
        Left = "left",
    }
}
