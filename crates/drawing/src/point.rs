//! Points of a drawing.

/// A point [m].
pub type Point = [f64; 2];
