//! The ground in a closed scan: what lies under the arch, between the abutments.

use crate::extent::extent;

/// Strips of the width in which the highest point is sought.
const STRIPS: usize = 100;
/// The ground lies in this lowest share of the height of all points, this share of the width away from either end: there an arch is higher, and
/// faces of abutments stand outside.
const LOW: f64 = 0.25;
const INSIDE: f64 = 0.1;
/// The arch over it is higher by this share of the height of all points.
const OVER: f64 = 0.5;

/// Fewest points that are ground, and how near their line it goes on to the faces, as a share of the height of all points.
const FEWEST: usize = 4;
const NEAR: f64 = 0.03;

/// Points without those of the ground, and these.
pub(super) fn part(points: &[[f64; 2]]) -> (Vec<[f64; 2]>, Vec<[f64; 2]>) {
    let [[left, right], [low, high]] = [0, 1].map(|i| extent(points.iter().map(|p| p[i])));
    let (width, height) = (right - left, high - low);
    let strip = |x: f64| ((STRIPS as f64 * (x - left) / width) as usize).min(STRIPS - 1);
    let mut highest = [f64::NEG_INFINITY; STRIPS];
    for [x, y] in points {
        let top = &mut highest[strip(*x)];
        *top = top.max(*y);
    }
    let is_ground = |[x, y]: &[f64; 2]| {
        let at = strip(*x);
        let over = highest[at.saturating_sub(1)..(at + 2).min(STRIPS)].iter().fold(f64::NEG_INFINITY, |a, b| a.max(*b));
        let inside = (x - left).min(right - x) > INSIDE * width;
        inside && y - low < LOW * height && over - y > OVER * height
    };
    let seen: Vec<[f64; 2]> = points.iter().copied().filter(is_ground).collect();
    if seen.len() < FEWEST {
        return (points.to_vec(), Vec::new());
    }
    let (mean, slope) = straight(&seen, 0);
    let line = |x: f64| mean[1] + slope * (x - mean[0]);
    let (ground, others) =
        points.iter().copied().partition(|p| is_ground(p) || (p[1] - line(p[0])).abs() < NEAR * height);
    (others, ground)
}

/// The mean of points, and what the other coordinate of a straight line through them gains over one of this number, by least squares.
pub(super) fn straight(points: &[[f64; 2]], over: usize) -> ([f64; 2], f64) {
    let n = points.len() as f64;
    let mean = [0, 1].map(|i| points.iter().map(|p| p[i]).sum::<f64>() / n);
    let product = |i: usize| points.iter().map(|p| (p[over] - mean[over]) * (p[i] - mean[i])).sum::<f64>();
    (mean, product(1 - over) / product(over).max(f64::MIN_POSITIVE))
}
