//! The surface on which vehicles run, where it is not level.

/// Points of a road or rail surface; straight between them, level beyond the first and the last.
#[derive(Debug, Clone, PartialEq)]
pub struct Road {
    /// From left to right, at least two: distance from the left springing of the first span, height above it [m].
    pub points: Vec<[f64; 2]>,
}

impl Road {
    /// Level at a place [m].
    pub fn level(&self, x: f64) -> f64 {
        let k = self.points.partition_point(|point| point[0] < x);
        match (k.checked_sub(1).and_then(|before| self.points.get(before)), self.points.get(k)) {
            (Some(a), Some(b)) => a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]),
            (Some(end), None) | (None, Some(end)) => end[1],
            (None, None) => 0.0,
        }
    }

    /// Its highest level [m].
    pub fn highest(&self) -> f64 {
        self.points.iter().map(|point| point[1]).fold(f64::NEG_INFINITY, f64::max)
    }
}
