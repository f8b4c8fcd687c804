//! Convex polygons and the cores that round their corners.

use super::vector::{Vec2, vec2};
use serde::Serialize;
use std::borrow::Borrow;
use thiserror::Error;

/// A convex polygon, counter-clockwise.
#[derive(Debug, Clone, PartialEq)]
pub struct Polygon {
    vertices: Vec<Vec2>,
}

/// Why a list of points is no block outline.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[expect(missing_docs, reason = "the messages say what each is")]
pub enum PolygonError {
    #[error("an outline needs at least three vertices, this one has {0}")]
    TooFewVertices(usize),
    #[error("vertex {0} has a coordinate that is not finite")]
    NotFinite(usize),
    #[error("vertices {0} and {1} coincide")]
    Coincident(usize, usize),
    #[error("the outline is not convex and counter-clockwise at vertex {0}")]
    NotConvex(usize),
    #[error("corners rounded by {radius} m leave nothing of edge {edge}")]
    RoundedAway {
        /// The edge that vanishes.
        edge: usize,
        /// Rounding radius [m].
        radius: f64,
    },
}

impl Polygon {
    /// Checks that `vertices` [m] run counter-clockwise around a convex outline.
    ///
    /// # Errors
    /// Fewer than three vertices, some that coincide or are not finite, or an outline that is not convex or runs clockwise.
    pub fn new(vertices: Vec<Vec2>) -> Result<Polygon, PolygonError> {
        let n = vertices.len();
        if n < 3 {
            return Err(PolygonError::TooFewVertices(n));
        }
        if let Some(i) = vertices.iter().position(|v| !v.is_finite()) {
            return Err(PolygonError::NotFinite(i));
        }
        let (low, high) = bounds(&vertices);
        let size = (high - low).norm();
        let edge = |i: usize| vertices[(i + 1) % n] - vertices[i];
        let mut turned = 0.0;
        for i in 0..n {
            if edge(i).norm() <= 1e-12 * size {
                return Err(PolygonError::Coincident(i, (i + 1) % n));
            }
            let (before, after) = (edge((i + n - 1) % n), edge(i));
            if before.cross(after) < -1e-12 * size * size || before.unit().dot(after.unit()) < -0.999_999 {
                return Err(PolygonError::NotConvex(i));
            }
            turned += before.cross(after).atan2(before.dot(after));
        }
        // A star that winds twice turns left everywhere and is still no outline.
        if (turned - std::f64::consts::TAU).abs() > 1e-6 {
            return Err(PolygonError::NotConvex(0));
        }
        Ok(Polygon { vertices })
    }

    /// Axis-parallel rectangle from its lower left corner, width and height [m].
    ///
    /// # Errors
    /// A width or a height that is next to nothing or not finite, or one of the two below 0.
    pub fn rectangle(corner: Vec2, width: f64, height: f64) -> Result<Polygon, PolygonError> {
        Polygon::new(vec![corner, corner + vec2(width, 0.0), corner + vec2(width, height), corner + vec2(0.0, height)])
    }

    /// The vertices, counter-clockwise [m].
    pub fn vertices(&self) -> &[Vec2] {
        &self.vertices
    }
    /// Edges from vertex `i` to vertex `i + 1`.
    pub fn edges(&self) -> impl Iterator<Item = (Vec2, Vec2)> {
        edges(&self.vertices)
    }
    /// Area [m^2].
    pub fn area(&self) -> f64 {
        let o = self.vertices[0];
        0.5 * self.edges().map(|(a, b)| (a - o).cross(b - o)).sum::<f64>()
    }
    /// Centroid [m].
    pub fn centroid(&self) -> Vec2 {
        let o = self.vertices[0];
        let (mut area, mut moment) = (0.0, Vec2::ZERO);
        for (a, b) in self.edges() {
            let c = (a - o).cross(b - o);
            area += c;
            moment += (a - o + (b - o)) * (c / 3.0);
        }
        o + moment * (1.0 / area)
    }
    /// Polar second moment of area about the centroid [m^4].
    pub fn polar_moment(&self) -> f64 {
        let o = self.centroid();
        self.edges()
            .map(|(a, b)| {
                let (a, b) = (a - o, b - o);
                a.cross(b) * (a.dot(a) + a.dot(b) + b.dot(b)) / 12.0
            })
            .sum()
    }
    /// Smallest box around the polygon: lower left and upper right corner [m].
    pub fn bounds(&self) -> (Vec2, Vec2) {
        bounds(&self.vertices)
    }
}

/// From each corner of an outline to the next.
pub(crate) fn edges(outline: &[Vec2]) -> impl Iterator<Item = (Vec2, Vec2)> {
    outline.iter().copied().zip(outline.iter().copied().cycle().skip(1))
}

/// Area of a simple outline [m^2]; negative where it is clockwise.
pub(crate) fn area(outline: &[Vec2]) -> f64 {
    0.5 * edges(outline).map(|(a, b)| a.cross(b)).sum::<f64>()
}

/// Whether a point lies inside of a simple outline: a ray to the right crosses it an odd number of times.
pub(crate) fn holds(outline: &[Vec2], point: Vec2) -> bool {
    let crosses = |(a, b): &(Vec2, Vec2)| {
        (a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)
    };
    edges(outline).filter(crosses).count() % 2 == 1
}

/// Smallest box around some points.
pub(crate) fn bounds<P: Borrow<Vec2>>(points: impl IntoIterator<Item = P>) -> (Vec2, Vec2) {
    let mut low = vec2(f64::INFINITY, f64::INFINITY);
    let mut high = -low;
    for p in points {
        let p = p.borrow();
        low = vec2(low.x.min(p.x), low.y.min(p.y));
        high = vec2(high.x.max(p.x), high.y.max(p.y));
    }
    (low, high)
}

/// Pairs of boxes that overlap when they are grown by `margin` [m] in all; sorted. Sweeps along x.
pub(crate) fn overlapping(boxes: &[(Vec2, Vec2)], margin: f64) -> Vec<(usize, usize)> {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by(|&i, &j| boxes[i].0.x.total_cmp(&boxes[j].0.x).then(i.cmp(&j)));
    let mut pairs = Vec::with_capacity(3 * boxes.len());
    for (k, &i) in order.iter().enumerate() {
        for &j in &order[k + 1..] {
            if boxes[j].0.x > boxes[i].1.x + margin {
                break;
            }
            if boxes[j].0.y <= boxes[i].1.y + margin && boxes[i].0.y <= boxes[j].1.y + margin {
                pairs.push((i.min(j), i.max(j)));
            }
        }
    }
    pairs.sort_unstable();
    pairs
}

/// A polygon with rounded corners: the polygon inset by `radius`, dilated by a disc of that radius. The faces stay
/// where they are; each corner becomes an arc that touches its two faces `radius / tan(angle / 2)` away from the
/// sharp corner. Coordinates are relative to the centre of mass.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Core {
    /// Corners of the inset polygon, counter-clockwise [m]: the centres of the arcs.
    pub vertices: Vec<Vec2>,
    /// Unit vector along each edge, from vertex `i` to vertex `i + 1`.
    pub directions: Vec<Vec2>,
    /// Length of each inset edge [m].
    pub lengths: Vec<f64>,
    /// Radius of the rounded corners [m].
    pub radius: f64,
    /// Distance of the farthest point of the rounded polygon from the centre of mass [m].
    pub reach: f64,
}

impl Core {
    /// The core of `outline` with corners rounded by `radius` [m], relative to the outline's centroid.
    ///
    /// # Errors
    /// A radius that leaves nothing of an edge.
    pub fn new(outline: &Polygon, radius: f64) -> Result<Core, PolygonError> {
        let centre = outline.centroid();
        let v = outline.vertices();
        let n = v.len();
        let direction = |i: usize| (v[(i + 1) % n] - v[i]).unit();
        let vertices: Vec<Vec2> = (0..n)
            .map(|i| {
                let (before, after) = (direction((i + n - 1) % n), direction(i));
                // Meeting point of the two neighbouring edges, both moved inwards by the radius.
                let bisector = (before.left() + after.left()) * (1.0 / (1.0 + before.dot(after)));
                v[i] - centre + bisector * radius
            })
            .collect();
        let directions: Vec<Vec2> = (0..n).map(direction).collect();
        let lengths: Vec<f64> = (0..n).map(|i| (vertices[(i + 1) % n] - vertices[i]).dot(directions[i])).collect();
        if let Some(edge) = lengths.iter().position(|&l| l <= 0.0) {
            return Err(PolygonError::RoundedAway { edge, radius });
        }
        let reach = radius + vertices.iter().map(|p| p.norm()).fold(0.0, f64::max);
        Ok(Core { vertices, directions, lengths, radius, reach })
    }

    /// Number of corners.
    pub(crate) fn len(&self) -> usize {
        self.vertices.len()
    }
    /// The corner after corner `i`.
    #[inline]
    pub fn next(&self, i: usize) -> usize {
        if i + 1 == self.vertices.len() { 0 } else { i + 1 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rectangle_has_its_textbook_moments() {
        let p = Polygon::rectangle(vec2(3.0, -1.0), 2.0, 0.5).unwrap();
        assert!((p.area() - 1.0).abs() < 1e-14);
        assert!((p.centroid() - vec2(4.0, -0.75)).norm() < 1e-14);
        // b h (b^2 + h^2) / 12
        assert!((p.polar_moment() - (4.0 + 0.25) / 12.0).abs() < 1e-14);
    }

    #[test]
    fn outlines_that_are_no_blocks_are_named() {
        let square = |v: &[(f64, f64)]| Polygon::new(v.iter().map(|&(x, y)| vec2(x, y)).collect());
        assert_eq!(square(&[(0., 0.), (1., 0.)]), Err(PolygonError::TooFewVertices(2)));
        assert_eq!(square(&[(0., 0.), (0., 1.), (1., 1.), (1., 0.)]), Err(PolygonError::NotConvex(0)));
        assert_eq!(square(&[(0., 0.), (1., 0.), (1., 0.), (0., 1.)]), Err(PolygonError::Coincident(1, 2)));
        assert_eq!(square(&[(0., 0.), (f64::NAN, 0.), (0., 1.)]), Err(PolygonError::NotFinite(1)));
        assert!(matches!(square(&[(0., 0.), (2., 0.), (1., 0.1), (1., 2.)]), Err(PolygonError::NotConvex(_))));
    }

    #[test]
    fn rounding_a_right_angle_insets_the_contact_point_by_the_radius() {
        let p = Polygon::rectangle(Vec2::ZERO, 1.0, 0.711).unwrap();
        let core = Core::new(&p, 0.01).unwrap();
        assert!((core.vertices[0] - vec2(-0.49, -0.3455)).norm() < 1e-14);
        assert!((core.lengths[1] - 0.691).abs() < 1e-14);
        assert!(matches!(Core::new(&p, 0.4), Err(PolygonError::RoundedAway { .. })));
    }
}
