//! A drawing as it was understood: outlines and circles.

use crate::Point;
use crate::finding::Place;

/// A closed convex outline, counter-clockwise.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// Its layer.
    pub layer: String,
    /// What it was drawn as.
    pub place: Place,
    /// Corners [m]; the last is not the first again.
    pub points: Vec<Point>,
}

/// A circle.
#[derive(Debug, Clone, PartialEq)]
pub struct Circle {
    /// Its layer.
    pub layer: String,
    /// What it was drawn as.
    pub place: Place,
    /// Centre [m].
    pub centre: Point,
    /// Radius [m].
    pub radius: f64,
}

/// A drawing as outlines and circles in metres, in the order of the file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawing {
    /// Closed outlines.
    pub outlines: Vec<Outline>,
    /// Circles.
    pub circles: Vec<Circle>,
    /// Layers on which something was drawn that is, or should be, an outline or a circle; in order of first use.
    pub layers: Vec<String>,
    /// Metres in one unit of the drawing.
    pub unit: f64,
}
