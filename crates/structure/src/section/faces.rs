//! Faces of abutments in a scan: what lies below the springings on upright lines at the ends of the section.
//!
//! A scan commonly goes on from the intrados down the abutments. One curve through all of it has a kink, or a straight piece, at each springing, and
//! takes the faces for a part of the arch. So the section is tried with every level of the springings: a straight line on each side below
//! it and a smooth curve above. Schwarz's criterion (1978) says whether the lines are worth their parameters.

use super::fit::{FEWEST, Polar, chosen, in_order, robust, robust_circle};
use super::ground::straight;
use crate::extent::extent;
use outcome::section::Face;

/// Levels that are tried, and how many more about the best one.
const LEVELS: usize = 60;
const FINER: usize = 20;
/// Springings lie below this share of the height of all points.
const HIGHEST: f64 = 0.85;
/// Points that are tried at every level: what stands out from more than these stands out from these. About the best one more are.
const MOST: usize = 400;
const MOST_FINER: usize = 3000;
/// Fewest points of a face.
const FACE: usize = 4;
/// A face leans no more than this (run over height).
const BATTER: f64 = 0.15;
/// A face is no lower than this where the curve meets it with a kink [m], nor than this share of the height of all points.
const LOWEST: f64 = 0.10;
const SHARE: f64 = 0.05;
/// Nor than this where it meets it without one [m]: the steep feet of a pointed arch scatter about a straight line over some 0.3 m.
const LOWEST_SMOOTH: f64 = 0.50;
/// Angle between the curve and the face from which on they meet with a kink [rad].
const KINK: f64 = 0.17;
/// A face does not bend towards the arch with a radius of less than so many spans, seen at so many times its standard error: that is the steep foot
/// of an arch.
const BENT: f64 = 5.0;
const SEEN_BENT: f64 = 3.0;
/// Scatter of the stones of a face about a line that no wall exceeds [m], and from which on a point tells no more than that it is off.
const ROUGH: f64 = 0.02;
/// Scatter below which a curve is no better [m].
const LEAST: f64 = 1e-3;
/// By how much the criterion must be better: "very strong" (Kass and Raftery, Bayes Factors, 1995).
const CLEARLY: f64 = 10.0;

/// The points of the arch, and the faces below it.
pub(super) fn cut(points: &[[f64; 2]]) -> (Vec<[f64; 2]>, Vec<Face>) {
    let whole = || (points.to_vec(), Vec::new());
    let [low, high] = extent(points.iter().map(|point| point[1]));
    let height = high - low;
    if !(height > 2.0 * LOWEST) {
        return whole();
    }
    let [left, right] = extent(points.iter().map(|point| point[0]));
    let radius = BENT * (right - left);
    let best = |tried: &[[f64; 2]], levels: &mut dyn Iterator<Item = f64>| {
        let at = |level: f64| {
            let (arch, faces) = split(tried, level);
            let is_face =
                |face: &Line, least: f64| face.is_upright(radius) && face.height() >= least.max(SHARE * height);
            let all = |least: f64| !faces.is_empty() && faces.iter().all(|face| is_face(face, least));
            let (score, kinks) = all(LOWEST).then(|| score(&arch, &faces))??;
            let has_kinks = faces.iter().all(|face| kinks[usize::from(face.is_right)] - face.batter.abs() > KINK);
            (has_kinks || all(LOWEST_SMOOTH)).then_some((score, level))
        };
        levels.filter_map(at).min_by(|a, b| a.0.total_cmp(&b.0))
    };
    let tried = thinned(points, MOST);
    let without = score(&tried, &[]).map_or(f64::INFINITY, |(score, _)| score);
    let step = HIGHEST * height / LEVELS as f64;
    let coarse = best(&tried, &mut (1..=LEVELS).map(|k| low + step * k as f64));
    let Some((_, coarse)) = coarse.filter(|(found, _)| *found < without - CLEARLY) else { return whole() };
    let finer = 2.0 * step / FINER as f64;
    let more = thinned(points, MOST_FINER);
    let Some((_, level)) = best(&more, &mut (0..=FINER).map(|k| coarse - step + finer * k as f64)) else {
        return whole();
    };
    let (arch, lines) = split(points, level);
    let face = |line: &Line| Face {
        x: line.at(line.ends[1]),
        foot: line.at(line.ends[0]),
        bottom: line.ends[0],
        top: line.ends[1],
        points: line.count,
    };
    (arch, lines.iter().map(face).collect())
}

/// So many points at most, evenly taken in the order of their heights.
fn thinned(points: &[[f64; 2]], most: usize) -> Vec<[f64; 2]> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[1].total_cmp(&b[1]).then(a[0].total_cmp(&b[0])));
    let step = sorted.len().div_ceil(most).max(1);
    sorted.into_iter().step_by(step).collect()
}

/// A straight line through the points of one side.
struct Line {
    count: usize,
    is_right: bool,
    /// The mean of its points [m].
    mean: [f64; 2],
    /// Lowest and highest point [m].
    ends: [f64; 2],
    batter: f64,
    /// Curvature of a parabola through the same points, positive where it bends towards the arch, and its standard error [1/m].
    bend: [f64; 2],
    /// Sum of squared deviations, none counted beyond what tells [m^2].
    squares: f64,
}

impl Line {
    fn through(points: &[[f64; 2]], is_right: bool) -> Line {
        let (mean, batter) = straight(points, 1);
        let off = |p: &[f64; 2]| (p[0] - mean[0]) - batter * (p[1] - mean[1]);
        Line {
            count: points.len(),
            is_right,
            mean,
            ends: extent(points.iter().map(|p| p[1])),
            batter,
            bend: bend(points, mean, batter, if is_right { -1.0 } else { 1.0 }),
            squares: points.iter().map(|p| off(p).powi(2).min(ROUGH * ROUGH)).sum(),
        }
    }
    /// Where it stands at a height [m].
    fn at(&self, y: f64) -> f64 {
        self.mean[0] + self.batter * (y - self.mean[1])
    }
    fn height(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }
    fn is_upright(&self, radius: f64) -> bool {
        let [bend, error] = self.bend;
        let is_foot = bend > (1.0 / radius).max(SEEN_BENT * error);
        !is_foot
            && self.count >= FACE
            && self.batter.abs() <= BATTER
            && self.squares < 0.25 * ROUGH * ROUGH * self.count as f64
    }
}

/// Curvature of what points deviate from a line, and its standard error [1/m]: least squares on a quadratic of the height that is orthogonal to the
/// line.
fn bend(points: &[[f64; 2]], mean: [f64; 2], batter: f64, inwards: f64) -> [f64; 2] {
    let n = points.len() as f64;
    let up = |p: &[f64; 2]| p[1] - mean[1];
    let moment = |power: i32| points.iter().map(|p| up(p).powi(power)).sum::<f64>() / n;
    let (second, third) = (moment(2), moment(3));
    let shape = |p: &[f64; 2]| up(p).powi(2) - third / second.max(f64::MIN_POSITIVE) * up(p) - second;
    let off = |p: &[f64; 2]| inwards * (p[0] - mean[0] - batter * up(p));
    let size = points.iter().map(|p| shape(p).powi(2)).sum::<f64>();
    let share = points.iter().map(|p| shape(p) * off(p)).sum::<f64>() / size;
    let left = points.iter().map(|p| (off(p) - share * shape(p)).powi(2)).sum::<f64>() / (n - 3.0).max(1.0);
    [2.0 * share, 2.0 * (left / size).sqrt()]
}

/// Points at and above a level, and lines through those below it on either side.
fn split(points: &[[f64; 2]], level: f64) -> (Vec<[f64; 2]>, Vec<Line>) {
    let (below, arch): (Vec<[f64; 2]>, Vec<[f64; 2]>) = points.iter().copied().partition(|point| point[1] < level);
    let [from, to] = extent(points.iter().map(|point| point[0]));
    let middle = 0.5 * (from + to);
    let (left, right): (Vec<[f64; 2]>, Vec<[f64; 2]>) = below.into_iter().partition(|point| point[0] < middle);
    let sides = [(left, false), (right, true)];
    (arch, sides.iter().filter(|(side, _)| !side.is_empty()).map(|(side, right)| Line::through(side, *right)).collect())
}

/// Schwarz's criterion of a smooth curve through the points of an arch and lines through those of faces, and the angles of the curve's ends with an
/// upright line [rad]; none where no curve is one.
fn score(arch: &[[f64; 2]], faces: &[Line]) -> Option<(f64, [f64; 2])> {
    if arch.len() < FEWEST {
        return None;
    }
    let polar = Polar { centre: robust_circle(arch)?.centre };
    let seen = in_order(&polar, arch)?;
    let kept = robust(&seen)?;
    let curve = chosen(&seen, &kept)?;
    let squares: f64 = seen.iter().map(|(polar, _)| curve.deviation(*polar).powi(2).min(ROUGH * ROUGH)).sum();
    let all = arch.len() + faces.iter().map(|face| face.count).sum::<usize>();
    let squares = squares + faces.iter().map(|face| face.squares).sum::<f64>();
    // Two for each line, and the level that they share.
    let lines = if faces.is_empty() { 0 } else { 2 * faces.len() + 1 };
    let n = all as f64;
    Some((
        n * (squares / n).max(LEAST * LEAST).ln() + (curve.terms.len() + lines) as f64 * n.ln(),
        polar.steepness(&curve),
    ))
}
