//! Curves as chords that lie within a tolerance of them.

use crate::Point;
use std::f64::consts::TAU;

/// No curve has more chords than this, however small the tolerance.
const MOST: usize = 4096;

/// Points along an ellipse from parameter `from` over `sweep` [rad]; both ends are included. No chord lies farther from
/// the curve than `tolerance`, in the unit of the axes.
pub(crate) fn ellipse(centre: Point, major: Point, minor: Point, from: f64, sweep: f64, tolerance: f64) -> Vec<Point> {
    // An ellipse is the image of a circle, whose sagitta 1 - cos(step/2) grows at most by the longer half axis.
    let longest = major[0].hypot(major[1]).max(minor[0].hypot(minor[1]));
    let count = chords(longest, sweep, tolerance);
    (0..=count)
        .map(|k| {
            let t = from + sweep * k as f64 / count as f64;
            let (s, c) = t.sin_cos();
            [centre[0] + c * major[0] + s * minor[0], centre[1] + c * major[1] + s * minor[1]]
        })
        .collect()
}

/// Points along a circular arc, angles in radians, counter-clockwise for a positive sweep.
pub(crate) fn arc(centre: Point, radius: f64, from: f64, sweep: f64, tolerance: f64) -> Vec<Point> {
    ellipse(centre, [radius, 0.0], [0.0, radius], from, sweep, tolerance)
}

/// How many chords keep within the tolerance: the sagitta of a chord is r (1 - cos(step / 2)).
fn chords(radius: f64, sweep: f64, tolerance: f64) -> usize {
    let cosine = 1.0 - tolerance / radius;
    let step = if cosine > -1.0 { 2.0 * cosine.acos() } else { TAU };
    // A chord over more than half a circle says nothing; a full circle needs three of them.
    let step = step.clamp(1e-9, TAU / 3.0);
    let count = (sweep.abs() / step * (1.0 - 1e-12)).ceil();
    if count.is_finite() { (count as usize).clamp(1, MOST) } else { 1 }
}

/// Sweep of an arc from one angle to another, counter-clockwise, in (0, 2 pi].
pub(crate) fn sweep(from: f64, to: f64) -> f64 {
    let sweep = (to - from).rem_euclid(TAU);
    if sweep <= 1e-12 { TAU } else { sweep }
}

/// Points after `a` up to `b` along the arc whose bulge (tangent of a quarter of its angle, positive to the right of the
/// chord, so that the arc turns left) is given.
pub(crate) fn bulge(a: Point, b: Point, bulge: f64, tolerance: f64) -> Vec<Point> {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let chord = dx.hypot(dy);
    let flat = bulge.abs() * chord * 0.5 <= tolerance;
    if flat || chord == 0.0 || !bulge.is_finite() {
        return vec![b];
    }
    let sweep = 4.0 * bulge.atan();
    let radius = chord * (1.0 + bulge * bulge) / (4.0 * bulge.abs());
    // From the middle of the chord towards the centre: left of the chord for a small positive bulge.
    let off = chord * (1.0 - bulge * bulge) / (4.0 * bulge);
    let centre = [0.5 * (a[0] + b[0]) - off * dy / chord, 0.5 * (a[1] + b[1]) + off * dx / chord];
    let from = (a[1] - centre[1]).atan2(a[0] - centre[0]);
    let mut points = arc(centre, radius, from, sweep, tolerance);
    points.remove(0);
    if let Some(last) = points.last_mut() {
        *last = b;
    }
    points
}

/// A rational B-spline.
pub(crate) struct Spline<'a> {
    pub(crate) degree: usize,
    pub(crate) knots: &'a [f64],
    pub(crate) points: &'a [Point],
    /// One weight a point, or none at all.
    pub(crate) weights: &'a [f64],
}

impl Spline<'_> {
    /// Why it cannot be evaluated, if it cannot.
    pub(crate) fn defect(&self) -> Option<String> {
        let (n, p) = (self.points.len(), self.degree);
        if !(1..=11).contains(&p) {
            return Some(format!("a degree of {p}"));
        }
        if n <= p || n > MOST {
            return Some(format!("{n} control points with a degree of {p}"));
        }
        if self.knots.len() != n + p + 1 {
            return Some(format!("{} knots where {} belong", self.knots.len(), n + p + 1));
        }
        if self.knots.windows(2).any(|k| k[0] > k[1]) || self.knots[p] >= self.knots[n] {
            return Some("knots that do not rise".into());
        }
        let weights = self.weights.is_empty() || self.weights.len() == n;
        if !weights || self.weights.iter().any(|w| *w <= 0.0) {
            return Some("weights that are missing or not positive".into());
        }
        None
    }

    /// Points along the whole curve; each piece between knots is halved until its chords keep within the tolerance.
    pub(crate) fn points(&self, tolerance: f64) -> Vec<Point> {
        let (p, n) = (self.degree, self.points.len());
        let mut out = vec![self.at(self.knots[p])];
        for k in p..n {
            let (from, to) = (self.knots[k], self.knots[k + 1]);
            if to > from {
                // A piece may bend both ways: it starts as twice as many chords as its degree.
                let parts = 2 * p;
                for part in 0..parts {
                    let t = |i: usize| from + (to - from) * i as f64 / parts as f64;
                    refine(&|t| self.at(t), t(part), t(part + 1), tolerance, 8, &mut out);
                }
            }
        }
        out
    }

    /// The point at a parameter, by de Boor's algorithm in homogeneous coordinates.
    fn at(&self, t: f64) -> Point {
        let (p, n) = (self.degree, self.points.len());
        let k = self.knots[p + 1..n].partition_point(|&knot| knot <= t) + p;
        let mut d: Vec<[f64; 3]> = (0..=p)
            .map(|j| {
                let i = j + k - p;
                let w = self.weights.get(i).copied().unwrap_or(1.0);
                [w * self.points[i][0], w * self.points[i][1], w]
            })
            .collect();
        for r in 1..=p {
            for j in (r..=p).rev() {
                let (low, high) = (self.knots[j + k - p], self.knots[j + 1 + k - r]);
                let share = if high > low { (t - low) / (high - low) } else { 0.0 };
                let before = d[j - 1];
                for (value, before) in d[j].iter_mut().zip(before) {
                    *value = (1.0 - share) * before + share * *value;
                }
            }
        }
        [d[p][0] / d[p][2], d[p][1] / d[p][2]]
    }
}

/// Appends the points of a curve after the parameter `from` up to `to`, halved until chords keep within the tolerance.
pub(crate) fn refine(at: &dyn Fn(f64) -> Point, from: f64, to: f64, tolerance: f64, depth: u32, out: &mut Vec<Point>) {
    let (a, b) = (at(from), at(to));
    let probe = |share: f64| off(a, b, at(from + share * (to - from)));
    let farthest = probe(0.25).max(probe(0.5)).max(probe(0.75));
    if farthest <= tolerance || depth == 0 || out.len() >= MOST {
        out.push(b);
        return;
    }
    let middle = 0.5 * (from + to);
    refine(at, from, middle, tolerance, depth - 1, out);
    refine(at, middle, to, tolerance, depth - 1, out);
}

/// Distance of a point from the chord between two others.
pub(crate) fn off(a: Point, b: Point, p: Point) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let length = dx.hypot(dy);
    let (px, py) = (p[0] - a[0], p[1] - a[1]);
    if length == 0.0 {
        return px.hypot(py);
    }
    let along = (px * dx + py * dy) / length;
    if along < 0.0 {
        px.hypot(py)
    } else if along > length {
        (p[0] - b[0]).hypot(p[1] - b[1])
    } else {
        ((px * dy - py * dx) / length).abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chords_of_an_arc_keep_within_the_tolerance() {
        for (radius, tolerance) in [(1.0, 1e-3), (16.1, 1e-3), (0.01, 1e-3), (250.0, 0.05)] {
            let points = arc([3.0, -2.0], radius, 0.3, 4.0, tolerance);
            for pair in points.windows(2) {
                let middle = [0.5 * (pair[0][0] + pair[1][0]), 0.5 * (pair[0][1] + pair[1][1])];
                let sagitta = radius - (middle[0] - 3.0).hypot(middle[1] + 2.0);
                // A chord spans at most a third of a circle, whatever the tolerance.
                assert!(sagitta <= tolerance * (1.0 + 1e-9) || points.len() <= 4, "{sagitta} {tolerance}");
            }
        }
    }

    #[test]
    fn a_bulge_of_one_is_a_half_circle_to_the_right_of_the_chord() {
        let points = bulge([0.0, 0.0], [2.0, 0.0], 1.0, 1e-4);
        assert!(points.iter().all(|p| ((p[0] - 1.0).hypot(p[1]) - 1.0).abs() < 1e-12));
        assert!(points.iter().all(|p| p[1] <= 1e-15), "counter-clockwise from left to right runs below");
        assert_eq!(points.last(), Some(&[2.0, 0.0]));
        let left = bulge([0.0, 0.0], [2.0, 0.0], -0.5, 1e-4);
        assert!(left[..left.len() - 1].iter().all(|p| p[1] > 0.0));
    }

    #[test]
    fn a_rational_spline_draws_a_quarter_circle() {
        // The textbook weights: Piegl and Tiller, The NURBS Book, example 7.1.
        let half = 0.5f64.sqrt();
        let spline = Spline {
            degree: 2,
            knots: &[0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
            points: &[[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            weights: &[1.0, half, 1.0],
        };
        assert_eq!(spline.defect(), None);
        let points = spline.points(1e-5);
        assert!(points.iter().all(|p| (p[0].hypot(p[1]) - 1.0).abs() < 1e-14));
        for pair in points.windows(2) {
            let middle = (0.5 * (pair[0][0] + pair[1][0])).hypot(0.5 * (pair[0][1] + pair[1][1]));
            assert!(1.0 - middle <= 1e-5);
        }
    }
}
