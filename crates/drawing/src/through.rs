//! The curve through the fit points of a spline that gives nothing else.
//!
//! A cubic with continuous curvature passes through every point. Its parameter is the length of the chords, its ends have no curvature
//! where no tangent is given: what CAD programs draw (de Boor, A Practical Guide to Splines, chapters IV and XVI).

use crate::Point;
use crate::curve::{self, off};

/// No spline has more fit points.
const MOST: usize = 4096;

/// Points of a closed curve that are repeated before its start and after its end. The curvature of an end falls by 2 - sqrt(3) from point to point:
/// after twenty it is 4e-12 of what it was.
const WRAPPED: usize = 20;

/// Chords of a piece by which two curves are compared.
const COMPARED: usize = 16;

/// A piecewise cubic.
pub(crate) struct Through {
    lengths: Vec<f64>,
    points: Vec<Point>,
    slopes: Vec<Point>,
    /// Pieces that are drawn; those of a closed curve have others before and after them.
    pieces: std::ops::Range<usize>,
}

/// Fit points with what is known of the ends.
pub(crate) struct Fit<'a> {
    pub(crate) points: &'a [Point],
    pub(crate) closed: bool,
    /// Directions at start and end.
    pub(crate) tangents: [Option<Point>; 2],
}

impl Fit<'_> {
    /// Why no curve can be drawn, if none can.
    pub(crate) fn defect(&self) -> Option<String> {
        let count = self.distinct().len();
        match count {
            0 | 1 => Some("fewer than two fit points".to_owned()),
            2 if self.closed => Some("two fit points and is closed".to_owned()),
            _ if count > MOST => Some(format!("{count} fit points")),
            _ => None,
        }
    }

    /// Points that differ from the one before; the last of a closed curve is not the first again.
    fn distinct(&self) -> Vec<Point> {
        let mut points = self.points.to_vec();
        points.dedup();
        while self.closed && points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        points
    }

    /// The curve by the length of its chords, in chords that keep within the tolerance; and how far from it the curve lies whose parameter is
    /// the root of that length, which other programs draw.
    pub(crate) fn curve(&self, tolerance: f64) -> (Vec<Point>, f64) {
        let points = self.distinct();
        let by_length = self.through(&points, 1.0);
        (by_length.points(tolerance), by_length.apart(&self.through(&points, 0.5)))
    }

    fn through(&self, points: &[Point], power: f64) -> Through {
        let n = points.len();
        let wrapped: Vec<Point> = match self.closed {
            true => (0..n + 2 * WRAPPED + 1).map(|k| points[(k + n * WRAPPED - WRAPPED) % n]).collect(),
            false => points.to_vec(),
        };
        let pieces = if self.closed { WRAPPED..WRAPPED + n } else { 0..n - 1 };
        let lengths: Vec<f64> =
            wrapped.windows(2).map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1]).powf(power)).collect();
        let unit = |t: Point| {
            let size = t[0].hypot(t[1]);
            (size > 0.0).then_some([t[0] / size, t[1] / size])
        };
        // At the speed at which the parameter grows along the first and the last chord.
        let speed = |k: usize| lengths[k].powf(1.0 / power - 1.0);
        let [start, end] = self.tangents.map(|tangent| tangent.and_then(unit).filter(|_| !self.closed));
        let ends = [start.map(|t| t.map(|x| x * speed(0))), end.map(|t| t.map(|x| x * speed(lengths.len() - 1)))];
        let slopes = slopes(&wrapped, &lengths, ends);
        Through { lengths, points: wrapped, slopes, pieces }
    }
}

/// Slopes at every point, by the continuity of curvature; ends without a slope have no curvature.
fn slopes(points: &[Point], lengths: &[f64], ends: [Option<Point>; 2]) -> Vec<Point> {
    let last = points.len() - 1;
    let rise = |k: usize| [0, 1].map(|i| (points[k + 1][i] - points[k][i]) / lengths[k]);
    // Rows (below, diagonal, above, right), solved from top to bottom and back (Thomas).
    let row = |k: usize| -> (f64, f64, f64, Point) {
        match k {
            0 => ends[0].map_or_else(|| (0.0, 2.0, 1.0, rise(0).map(|x| 3.0 * x)), |slope| (0.0, 1.0, 0.0, slope)),
            k if k == last => {
                ends[1].map_or_else(|| (1.0, 2.0, 0.0, rise(last - 1).map(|x| 3.0 * x)), |slope| (0.0, 1.0, 0.0, slope))
            }
            k => {
                let (before, after) = (1.0 / lengths[k - 1], 1.0 / lengths[k]);
                let right = [0, 1].map(|i| 3.0 * (rise(k - 1)[i] * before + rise(k)[i] * after));
                (before, 2.0 * (before + after), after, right)
            }
        }
    };
    let mut above = vec![0.0; points.len()];
    let mut slopes = vec![[0.0; 2]; points.len()];
    for k in 0..=last {
        let (a, b, c, right) = row(k);
        let (up, before) = if k == 0 { (0.0, [0.0; 2]) } else { (above[k - 1], slopes[k - 1]) };
        let pivot = b - a * up;
        above[k] = c / pivot;
        slopes[k] = [0, 1].map(|i| (right[i] - a * before[i]) / pivot);
    }
    for k in (0..last).rev() {
        slopes[k] = [0, 1].map(|i| slopes[k][i] - above[k] * slopes[k + 1][i]);
    }
    slopes
}

impl Through {
    /// The point of a piece at a share of it (cubic of Hermite).
    fn at(&self, k: usize, u: f64) -> Point {
        let (v, h) = (1.0 - u, self.lengths[k]);
        [0, 1].map(|i| {
            let ends = v * v * (1.0 + 2.0 * u) * self.points[k][i] + u * u * (3.0 - 2.0 * u) * self.points[k + 1][i];
            ends + h * u * v * (v * self.slopes[k][i] - u * self.slopes[k + 1][i])
        })
    }

    fn points(&self, tolerance: f64) -> Vec<Point> {
        let mut out = vec![self.points[self.pieces.start]];
        for k in self.pieces.clone() {
            // A piece may bend both ways.
            for part in 0..4 {
                let share = |part: u32| f64::from(part) / 4.0;
                curve::refine(&|u| self.at(k, u), share(part), share(part + 1), tolerance, 8, &mut out);
            }
        }
        out
    }

    /// The farthest that another curve through the same points lies from this one.
    fn apart(&self, other: &Through) -> f64 {
        let share = |part: usize| part as f64 / COMPARED as f64;
        let nearest = |k: usize, p: Point| {
            let chord = |part: usize| off(self.at(k, share(part)), self.at(k, share(part + 1)), p);
            (0..COMPARED).map(chord).fold(f64::INFINITY, f64::min)
        };
        let of_piece = |k: usize| (1..COMPARED).map(move |part| nearest(k, other.at(k, share(part))));
        self.pieces.clone().flat_map(of_piece).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_passes_through_its_points_and_keeps_its_tangents() {
        let points = [[0.0, 0.0], [1.0, 0.8], [2.0, 1.0], [3.0, 0.8], [4.0, 0.0]];
        let fit = Fit { points: &points, closed: false, tangents: [Some([0.0, 2.0]), None] };
        assert_eq!(fit.defect(), None);
        let (drawn, apart) = fit.curve(1e-4);
        assert!(points.iter().all(|p| drawn.contains(p)), "{drawn:?}");
        assert!(drawn[1][0].abs() < 0.2 * drawn[1][1], "upright at its start: {:?}", drawn[1]);
        assert!(apart > 0.0 && apart < 0.05, "{apart}");
    }

    #[test]
    fn the_natural_cubic_is_that_of_its_second_derivatives() {
        let points = [[0.0, 0.0], [1.0, 0.8], [2.0, 1.0], [3.0, 0.8], [4.0, 0.0]];
        let through = Fit { points: &points, closed: false, tangents: [None; 2] }.through(&points, 1.0);
        // Solved for second derivatives instead of slopes, by a program of its own.
        for (k, [x, y]) in
            [(0, [0.473_304_368_211_469, 0.449_687_736_066_492]), (1, [1.483_071_062_768_249, 0.953_254_648_021_083])]
        {
            let at = through.at(k, 0.5);
            assert!((at[0] - x).hypot(at[1] - y) < 1e-13, "{at:?}");
        }
    }

    #[test]
    fn a_line_comes_back_whatever_the_parameter() {
        let line = [[0.0, 0.0], [1.0, 2.0], [1.5, 3.0], [4.0, 8.0]];
        let (drawn, apart) = Fit { points: &line, closed: false, tangents: [None; 2] }.curve(1e-6);
        assert!(drawn.iter().all(|p| (p[1] - 2.0 * p[0]).abs() < 1e-12) && apart < 1e-12);
    }

    #[test]
    fn a_closed_curve_through_points_of_a_circle_is_one_but_for_a_thousandth() {
        for n in [8_usize, 16] {
            let point = |k: usize| (std::f64::consts::TAU * k as f64 / n as f64).sin_cos();
            let points: Vec<Point> = (0..=n).map(|k| point(k % n)).map(|(s, c)| [c, s]).collect();
            let (drawn, apart) = Fit { points: &points, closed: true, tangents: [None; 2] }.curve(1e-6);
            let off = drawn.iter().map(|p| (p[0].hypot(p[1]) - 1.0).abs()).fold(0.0, f64::max);
            // The error of a periodic cubic spline is 5/384 of h^4 times the fourth derivative (Hall and Meyer 1976).
            let bound = 5.0 / 384.0 * (std::f64::consts::TAU / n as f64).powi(4) * std::f64::consts::SQRT_2;
            assert!(off < bound && off > 0.01 * bound, "{n}: {off} {bound}");
            assert!(apart < 1e-9, "equal chords have one parameter: {apart}");
            assert_eq!(
                drawn.first().map(|p| p.map(|x| (x * 1e9).round())),
                drawn.last().map(|p| p.map(|x| (x * 1e9).round()))
            );
        }
    }

    #[test]
    fn too_few_points_are_none() {
        let fit = |points, closed| Fit { points, closed, tangents: [None; 2] }.defect();
        assert!(fit(&[[0.0, 0.0], [0.0, 0.0]], false).is_some());
        assert!(fit(&[[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]], true).is_some());
        assert!(fit(&[[0.0, 0.0], [1.0, 0.0]], false).is_none());
    }
}
