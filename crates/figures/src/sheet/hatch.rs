//! The hatching of what is held: lines of its own. A pattern is drawn by interpolating a picture of it, which was a third of what all figures of a
//! small arch cost (0.11 s of 0.30 s).

use super::{Pen, Sheet, Spot};
use crate::geometry::sides;

/// Distance between two lines, across them, on the sheet.
const SPACING: f64 = 7.0;
/// Width of a line.
const WIDTH: f64 = 1.2;
/// How far a line ends inside the outline.
const INSIDE: f64 = 0.6;

impl Sheet {
    /// A closed polygon with hatching; of the pen, its outline and its class.
    pub(crate) fn hatched(&mut self, points: &[Spot], pen: Pen) {
        self.polygon(points, Pen { fill: "#e6e6e6", ..pen });
        self.open_drawn("hatch", Pen::line("#8a8a8a", WIDTH));
        self.strokes(&lines(points), WIDTH);
        self.close();
    }
}

/// Pieces within a polygon of the lines that rise to the right at 45 degrees, the same on the whole sheet.
fn lines(points: &[Spot]) -> Vec<[Spot; 2]> {
    // On such a line, x + y is constant.
    let sums = points.iter().map(|p| p[0] + p[1]);
    let (low, high) = sums.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), sum| (low.min(sum), high.max(sum)));
    let step = SPACING * std::f64::consts::SQRT_2;
    if !(low.is_finite() && high.is_finite()) {
        return Vec::new();
    }
    let mut found = Vec::new();
    for k in (low / step).ceil() as i64..=(high / step).floor() as i64 {
        let sum = k as f64 * step;
        let mut crossings: Vec<f64> = sides(points)
            .filter_map(|[a, b]| {
                let (from, to) = (a[0] + a[1] - sum, b[0] + b[1] - sum);
                ((from < 0.0) != (to < 0.0)).then(|| a[0] + (b[0] - a[0]) * from / (from - to))
            })
            .collect();
        crossings.sort_by(f64::total_cmp);
        for pair in crossings.chunks_exact(2) {
            let (left, right) = (pair[0] + INSIDE, pair[1] - INSIDE);
            if right > left {
                found.push([[left, sum - left], [right, sum - right]]);
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_lie_within_the_polygon_and_go_on_in_its_neighbour() {
        let square = |left: f64| [[left, 0.0], [left + 70.0, 0.0], [left + 70.0, 70.0], [left, 70.0]];
        let of_one = lines(&square(0.0));
        assert_eq!(of_one.len(), 14, "140 over 7 times the root of two");
        assert!(of_one.iter().flatten().flatten().all(|c| (0.0..=70.0).contains(c)));
        // A notch is left out: the line through it has two pieces.
        let notched = [
            [0.0, 0.0],
            [70.0, 0.0],
            [70.0, 70.0],
            [40.0, 70.0],
            [40.0, 20.0],
            [30.0, 20.0],
            [30.0, 70.0],
            [0.0, 70.0],
        ];
        assert!(lines(&notched).len() > of_one.len());
        assert!(lines(&notched).iter().all(|[a, b]| !(a[0] < 30.0 && b[0] > 40.0 && a[1] > 20.0 && b[1] > 20.0)));
        let length = |all: &[[Spot; 2]]| all.iter().map(|[a, b]| b[0] - a[0] + 2.0 * INSIDE).sum::<f64>();
        // Half a large square has half of its lines.
        let large = [[0.0, 0.0], [700.0, 0.0], [700.0, 700.0], [0.0, 700.0]];
        let half = [large[0], large[1], large[3]];
        assert!((length(&lines(&half)) / length(&lines(&large)) - 0.5).abs() < 0.01);
        assert!(lines(&[]).is_empty() && lines(&[[f64::NAN, 0.0], [1.0, 1.0], [0.0, 1.0]]).is_empty());
    }
}
