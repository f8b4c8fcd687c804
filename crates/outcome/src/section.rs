//! A surveyed section of an intrados, and the smooth curve fitted to it.

/// A point of the survey, in the order along the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surveyed {
    /// Where it is, as surveyed but for the unit [m].
    pub at: [f64; 2],
    /// Its distance from the curve, positive outwards, into the masonry [m].
    pub deviation: f64,
    /// Whether it was left out of the fit: further from the curve than the others scatter.
    pub is_left_out: bool,
}

/// A circle fitted to the same points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// Centre [m].
    pub centre: [f64; 2],
    /// Radius [m].
    pub radius: f64,
    /// Root mean square distance of the points that were kept from it [m].
    pub scatter: f64,
}

/// The upright face of an abutment that was surveyed with the intrados.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Face {
    /// Where its top stands along the bridge, as surveyed [m].
    pub x: f64,
    /// Where its bottom stands [m].
    pub foot: f64,
    /// Its lowest point, as surveyed [m].
    pub bottom: f64,
    /// Its highest point [m].
    pub top: f64,
    /// Points on it.
    pub points: usize,
}

/// The section with its curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Every point of the intrados that was read, once, from left to right along the curve.
    pub points: Vec<Surveyed>,
    /// How many more were read that repeat one of them.
    pub repeated: usize,
    /// Faces of abutments below the springings, whose points were left out.
    pub faces: Vec<Face>,
    /// Points of the curve from the left to the right springing, both at one level: what a bridge file takes as a measured profile,
    /// with the left springing at zero [m].
    pub curve: Vec<[f64; 2]>,
    /// The same curve where it was surveyed, close enough to be drawn [m].
    pub drawn: Vec<[f64; 2]>,
    /// Root mean square deviation of the points that were kept [m].
    pub scatter: f64,
    /// What neighbouring points scatter, whatever the curve [m].
    pub noise: f64,
    /// Terms of the curve.
    pub terms: usize,
    /// By how much the right end lies above the left one [m]; the curve was turned by this to be level.
    pub tilt: f64,
    /// The circle.
    pub circle: Circle,
    /// The longest stretch without a point [m], and where it begins and ends along the bridge, as surveyed.
    pub gap: (f64, [f64; 2]),
}

impl Section {
    /// Horizontal distance of the springings [m].
    pub fn span(&self) -> f64 {
        self.curve.last().map_or(0.0, |end| end[0])
    }
    /// Height of the highest point above them [m].
    pub fn rise(&self) -> f64 {
        self.curve.iter().map(|point| point[1]).fold(0.0, f64::max)
    }
    /// Points that were left out.
    pub fn left_out(&self) -> impl Iterator<Item = &Surveyed> {
        self.points.iter().filter(|point| point.is_left_out)
    }
    /// Whether points depart from the curve by clearly more than neighbours scatter: the intrados has a kink or steps.
    pub fn has_steps(&self) -> bool {
        self.scatter > 1.3 * self.noise.max(1e-4)
    }
}
