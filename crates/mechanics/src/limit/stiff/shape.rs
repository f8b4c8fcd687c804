//! The compressions that a joint of two points can carry, as a convex polygon, and the nearest of them to any others.
//!
//! Beyond its edges elastic compressions are drawn back square to the edge: then the joint opens or crushes as an associated flow rule has it.
//! The nearest point is linear in pieces: within the polygon, beside an edge, about a corner.
//! Compressions stand as points of a plane.

use crate::plane::{Vec2, vec2};

/// Edges of each parabola of crushing. The share of compression at corner `k` is `(k / CHORDS)^2`, which makes all of them miss the parabola by
/// the same `1 / (2 CHORDS^2)` of the eccentricity, to the safe side: 4e-5.
const CHORDS: usize = 112;
/// Below this share of its unit a side of the polygon is none.
const NOTHING: f64 = 1e-12;

/// Which part of the polygon is nearest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// The compressions are within.
    Inside,
    Edge(u16),
    Corner(u16),
}

/// The next change of the nearest part.
#[derive(Debug, Clone, Copy)]
pub(super) struct Change {
    /// After how much of the way.
    pub after: f64,
    pub to: Part,
    /// Grows by the compressions on the way to the change and beyond.
    pub onward: Vec2,
}

/// A convex polygon, counter-clockwise. An open one begins and ends with a ray.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shape {
    corners: Vec<Vec2>,
    /// Direction of each edge, which ends in the corner of the same number. An open polygon has one edge more than corners.
    along: Vec<Vec2>,
    closed: bool,
    /// Crushing parabolas: the shift by tension, and the least share of compression. None otherwise.
    parabolas: Option<[f64; 2]>,
}

impl Shape {
    /// Each compression above `-tension`, their sum above `-least`.
    pub(super) fn of_tension(tension: f64, least: f64) -> Shape {
        let cut = (2.0 * tension - least).max(0.0);
        let corners = match cut > NOTHING {
            true => vec![vec2(-tension, cut - tension), vec2(cut - tension, -tension)],
            false => vec![vec2(-tension, -tension)],
        };
        let mut along = vec![vec2(0.0, -1.0)];
        if corners.len() == 2 {
            let half = std::f64::consts::FRAC_1_SQRT_2;
            along.push(vec2(half, -half));
        }
        along.push(vec2(1.0, 0.0));
        Shape { corners, along, closed: false, parabolas: None }
    }

    /// The same with crushing, in units of the largest shifted compression: `n' >= total'^2 / 2`.
    pub(super) fn of_crushing(tension: f64, least: f64) -> Shape {
        let from = (2.0 * tension - least).max(0.0);
        let from = if from > NOTHING { from } else { 0.0 };
        let share = |k: usize| from + (1.0 - from) * (k as f64 / CHORDS as f64).powi(2);
        let lower = |x: f64| vec2(x - 0.5 * x * x - tension, 0.5 * x * x - tension);
        let mut corners: Vec<Vec2> = (0..=CHORDS).map(|k| lower(share(k))).collect();
        let last = if from > 0.0 { 0 } else { 1 };
        corners.extend((last..CHORDS).rev().map(|k| lower(share(k))).map(|at| vec2(at.y, at.x)));
        let count = corners.len();
        let along = (0..count).map(|k| unit(corners[k] - corners[(k + count - 1) % count])).collect();
        Shape { corners, along, closed: true, parabolas: Some([tension, from]) }
    }

    /// Whether it has parabolas of crushing.
    pub(super) fn crushes(&self) -> bool {
        self.parabolas.is_some()
    }

    /// The corner that an edge begins in.
    fn begins(&self, edge: usize) -> Option<usize> {
        match (edge, self.closed) {
            (0, true) => Some(self.corners.len() - 1),
            (0, false) => None,
            (edge, _) => Some(edge - 1),
        }
    }

    fn ends(&self, edge: usize) -> Option<usize> {
        (edge < self.corners.len()).then_some(edge)
    }

    /// A corner on the line of an edge.
    fn on(&self, edge: usize) -> Vec2 {
        self.corners[edge.min(self.corners.len() - 1)]
    }

    /// How far within an edge [`at`] lies.
    fn within(&self, edge: usize, at: Vec2) -> f64 {
        // The polygon lies to the left.
        self.along[edge].left().dot(at - self.on(edge))
    }

    /// The part nearest to any compressions.
    pub(super) fn nearest(&self, at: Vec2) -> Part {
        if (0..self.along.len()).all(|edge| self.within(edge, at) >= 0.0) {
            return Part::Inside;
        }
        let beside = |edge: &usize| {
            let along = self.along[*edge];
            let before = self.begins(*edge).is_none_or(|c| along.dot(at - self.corners[c]) >= 0.0);
            let behind = self.ends(*edge).is_none_or(|c| along.dot(at - self.corners[c]) <= 0.0);
            self.within(*edge, at) < 0.0 && before && behind
        };
        let distance = |corner: &usize| {
            let apart = at - self.corners[*corner];
            apart.dot(apart)
        };
        let corner = (0..self.corners.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        match (0..self.along.len()).filter(beside).max_by(|a, b| self.within(*a, at).total_cmp(&self.within(*b, at))) {
            Some(edge) if corner.is_none_or(|c| self.within(edge, at).powi(2) <= distance(&c)) => {
                Part::Edge(edge as u16)
            }
            _ => Part::Corner(corner.unwrap_or(0) as u16),
        }
    }

    /// The nearest compressions, where the part is known.
    pub(super) fn drawn_back(&self, part: Part, at: Vec2) -> Vec2 {
        match part {
            Part::Inside => at,
            Part::Edge(edge) => {
                let (along, on) = (self.along[edge as usize], self.on(edge as usize));
                on + along * along.dot(at - on)
            }
            Part::Corner(corner) => self.corners[corner as usize],
        }
    }

    /// How the nearest compressions change by any.
    pub(super) fn slope(&self, part: Part) -> [[f64; 2]; 2] {
        match part {
            Part::Inside => [[1.0, 0.0], [0.0, 1.0]],
            Part::Edge(edge) => {
                let Vec2 { x: a, y: b } = self.along[edge as usize];
                [[a * a, a * b], [a * b, b * b]]
            }
            Part::Corner(_) => [[0.0; 2]; 2],
        }
    }

    /// The next change of the nearest part within `most` of the way from compressions that change by `rate`.
    pub(super) fn next(&self, part: Part, at: Vec2, rate: Vec2, most: f64) -> Option<Change> {
        let mut next: Option<Change> = None;
        let mut meet = |value: f64, onward: Vec2, to: Part| {
            let speed = onward.dot(rate);
            if speed > 0.0 {
                let after = (-value / speed).max(0.0);
                if after < most && next.is_none_or(|n| after < n.after) {
                    next = Some(Change { after, to, onward });
                }
            }
        };
        match part {
            Part::Inside => {
                if !self.holds(at + rate * most) {
                    for edge in 0..self.along.len() {
                        meet(-self.within(edge, at), -self.along[edge].left(), Part::Edge(edge as u16));
                    }
                }
            }
            Part::Edge(edge) => {
                let edge = edge as usize;
                let along = self.along[edge];
                meet(self.within(edge, at), along.left(), Part::Inside);
                if let Some(corner) = self.ends(edge) {
                    meet(along.dot(at - self.corners[corner]), along, Part::Corner(corner as u16));
                }
                if let Some(corner) = self.begins(edge) {
                    meet((-along).dot(at - self.corners[corner]), -along, Part::Corner(corner as u16));
                }
            }
            Part::Corner(corner) => {
                let corner = corner as usize;
                let apart = at - self.corners[corner];
                let after = (corner + 1) % self.along.len();
                meet(self.along[after].dot(apart), self.along[after], Part::Edge(after as u16));
                let back = -self.along[corner];
                meet(back.dot(apart), back, Part::Edge(corner as u16));
            }
        }
        next
    }

    /// How far compressions may surely go, in sum, before the nearest part changes.
    pub(super) fn room(&self, part: Part, at: Vec2) -> f64 {
        match (part, self.parabolas) {
            (Part::Inside, Some([tension, from])) => {
                let shifted = at + vec2(tension, tension);
                let share = shifted.x + shifted.y;
                // Neither slope of the parabola's distance is above two, and chords miss it by less than this.
                let within = shifted.x.min(shifted.y) - 0.5 * share * share - 1.0 / (CHORDS * CHORDS) as f64;
                (0.5 * within).min(share - from).max(0.0)
            }
            (Part::Inside, None) => {
                (0..self.along.len()).map(|edge| self.within(edge, at)).fold(f64::INFINITY, f64::min).max(0.0)
            }
            (Part::Edge(edge), _) => {
                let edge = edge as usize;
                let before = |corner: Option<usize>, sign: f64| {
                    corner.map_or(f64::INFINITY, |corner| sign * self.along[edge].dot(self.corners[corner] - at))
                };
                (-self.within(edge, at)).min(before(self.ends(edge), 1.0)).min(before(self.begins(edge), -1.0)).max(0.0)
            }
            (Part::Corner(corner), _) => {
                let corner = corner as usize;
                let apart = at - self.corners[corner];
                let after = (corner + 1) % self.along.len();
                (-self.along[after].dot(apart)).min(self.along[corner].dot(apart)).max(0.0)
            }
        }
    }

    /// Whether compressions surely lie within. A way that ends there crosses no edge.
    fn holds(&self, at: Vec2) -> bool {
        if !at.is_finite() {
            return false;
        }
        let Some([tension, from]) = self.parabolas else {
            return (0..self.along.len()).all(|edge| self.within(edge, at) >= 0.0);
        };
        let shifted = at + vec2(tension, tension);
        let share = shifted.x + shifted.y;
        if share <= from || share >= 1.0 {
            return false;
        }
        let chord = (CHORDS as f64 * ((share - from) / (1.0 - from)).sqrt()) as usize;
        let wider = vec2(shifted.x.max(shifted.y) - tension, shifted.x.min(shifted.y) - tension);
        let edge = |k: usize| self.within(k.clamp(1, CHORDS), wider);
        edge(chord + 1) >= 0.0 && edge(chord) >= 0.0
    }
}

fn unit(a: Vec2) -> Vec2 {
    let size = a.norm();
    vec2(a.x / size, a.y / size)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shapes() -> [Shape; 5] {
        [
            Shape::of_tension(0.0, 0.0),
            Shape::of_tension(0.2, 0.1),
            Shape::of_tension(0.2, f64::INFINITY),
            Shape::of_crushing(0.0, 0.0),
            Shape::of_crushing(0.1, 0.05),
        ]
    }

    /// Points about all of the polygons.
    fn points() -> impl Iterator<Item = Vec2> {
        (0..40).flat_map(|i| (0..40).map(move |j| vec2(-0.55 + 0.0413 * f64::from(i), -0.55 + 0.0417 * f64::from(j))))
    }

    #[test]
    fn what_is_drawn_back_lies_within_and_nothing_within_is_nearer() {
        for shape in shapes() {
            for at in points() {
                let back = shape.drawn_back(shape.nearest(at), at);
                let apart = at - back;
                for edge in 0..shape.along.len() {
                    assert!(shape.within(edge, back) > -1e-12, "{at:?} {back:?}");
                }
                // The nearest of a convex set: every corner and ray lies behind it.
                assert!(shape.corners.iter().all(|c| apart.dot(*c - back) < 1e-12), "{at:?} {back:?}");
                if !shape.closed {
                    assert!(apart.x < 1e-12 && apart.y < 1e-12);
                }
                assert!(!shape.holds(at) || shape.nearest(at) == Part::Inside);
                assert!(shape.holds(at) || shape.nearest(at) != Part::Inside);
            }
        }
    }

    #[test]
    fn a_straight_way_goes_from_part_to_part_and_ends_in_the_nearest_of_its_end() {
        for shape in shapes() {
            for (k, (from, to)) in points().zip(points().skip(777)).enumerate().filter(|(k, _)| k % 7 == 0) {
                let rate = to - from;
                let (mut at, mut part, mut left) = (from, shape.nearest(from), 1.0);
                let mut count = 0;
                while let Some(change) = shape.next(part, at, rate, left) {
                    assert!(change.onward.dot(rate) > 0.0);
                    let gone = change.after * (rate.x.abs() + rate.y.abs());
                    assert!(shape.room(part, at) <= gone + 1e-12, "{from:?} {to:?} {part:?}");
                    at += rate * change.after;
                    let (before, behind) = (shape.drawn_back(part, at), shape.drawn_back(change.to, at));
                    assert!((before - behind).norm() < 1e-10, "no jump {k} {at:?}");
                    (part, left, count) = (change.to, left - change.after, count + 1);
                    assert!(count < 2000);
                }
                let (found, nearest) = (shape.drawn_back(part, to), shape.drawn_back(shape.nearest(to), to));
                assert!((found - nearest).norm() < 1e-10, "{from:?} {to:?} {part:?}");
            }
        }
    }

    #[test]
    fn chords_of_crushing_miss_the_parabola_by_four_hundred_thousandths_to_the_safe_side() {
        let shape = Shape::of_crushing(0.0, 0.0);
        for k in 1..5000 {
            let x = f64::from(k) / 5000.0;
            let reached = |share: f64| {
                // On the parabola and a share of its distance from the middle.
                let least = 0.5 * x * x + share * (0.5 * x - 0.5 * x * x);
                vec2(x - least, least)
            };
            assert!(!shape.holds(reached(-1e-9)) && shape.holds(reached(8e-5 / (1.0 - x))), "{x}");
        }
    }
}
