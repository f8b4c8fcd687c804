//! Plane geometry of drawings: how blocks have moved, how large they are, and how metres become places on the sheet.

use crate::sheet::{Area, Spot};
use outcome::picture::{Motion, Point, Shape};

/// A rectangle in the bridge's own metres, y up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extent {
    /// Smallest x and y [m].
    pub low: Point,
    /// Largest x and y [m].
    pub high: Point,
}

impl Extent {
    /// Around points; points that are not finite do not count.
    pub(crate) fn of(points: impl IntoIterator<Item = Point>) -> Option<Extent> {
        let finite = points.into_iter().filter(|p| p[0].is_finite() && p[1].is_finite());
        finite.map(|p| Extent { low: p, high: p }).reduce(|extent, p| extent.with(p))
    }
    /// Width and height [m].
    pub(crate) fn size(&self) -> Point {
        [self.high[0] - self.low[0], self.high[1] - self.low[1]]
    }
    /// Around both.
    pub(crate) fn with(&self, other: Extent) -> Extent {
        Extent {
            low: [self.low[0].min(other.low[0]), self.low[1].min(other.low[1])],
            high: [self.high[0].max(other.high[0]), self.high[1].max(other.high[1])],
        }
    }
    /// What both have in common.
    pub(crate) fn within(&self, other: Extent) -> Extent {
        Extent {
            low: [self.low[0].max(other.low[0]), self.low[1].max(other.low[1])],
            high: [self.high[0].min(other.high[0]), self.high[1].min(other.high[1])],
        }
    }
    /// Larger on all sides [m].
    pub(crate) fn grown(&self, by: f64) -> Extent {
        Extent { low: [self.low[0] - by, self.low[1] - by], high: [self.high[0] + by, self.high[1] + by] }
    }
}

/// The extent of the blocks as built; none without any.
pub(crate) fn as_built(shapes: &[Shape]) -> Option<Extent> {
    Extent::of(shapes.iter().flat_map(|s| s.outline.iter().copied()))
}

/// From metres to the sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct View {
    /// Units of the sheet per metre.
    pub scale: f64,
    /// Where the origin is drawn.
    pub origin: Spot,
}

impl View {
    /// Shows `extent` as large as fits into `area`, in the middle of its width and at its top.
    pub(crate) fn fit(extent: Extent, area: Area) -> View {
        let [w, h] = extent.size().map(|d| d.max(1e-9));
        let scale = ((area.right - area.left) / w).min((area.bottom - area.top) / h);
        let spare = (area.right - area.left) - scale * w;
        View { scale, origin: [area.left + 0.5 * spare - scale * extent.low[0], area.top + scale * extent.high[1]] }
    }
    /// Where a point is drawn.
    pub(crate) fn spot(&self, p: Point) -> Spot {
        [self.origin[0] + self.scale * p[0], self.origin[1] - self.scale * p[1]]
    }
    /// Where an extent is drawn.
    pub(crate) fn area(&self, extent: Extent) -> Area {
        let ([left, bottom], [right, top]) = (self.spot(extent.low), self.spot(extent.high));
        Area { left, top, right, bottom }
    }
    /// Where points are drawn.
    pub(crate) fn spots(&self, points: &[Point]) -> Vec<Spot> {
        points.iter().map(|&p| self.spot(p)).collect()
    }
}

/// The sides of a polygon, each from corner to corner.
pub(crate) fn sides<T: Copy>(corners: &[T]) -> impl Iterator<Item = [T; 2]> {
    corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| [*a, *b])
}

/// Centre of mass of a polygon [m]; the mean of its corners where it has no area.
pub(crate) fn centroid(outline: &[Point]) -> Point {
    let Some(&origin) = outline.first() else { return [0.0, 0.0] };
    let (mut area, mut sum) = (0.0, [0.0, 0.0]);
    for [p, q] in sides(outline) {
        let (a, b) = ([p[0] - origin[0], p[1] - origin[1]], [q[0] - origin[0], q[1] - origin[1]]);
        let cross = a[0] * b[1] - a[1] * b[0];
        area += cross;
        sum = [sum[0] + cross * (a[0] + b[0]), sum[1] + cross * (a[1] + b[1])];
    }
    if area.abs() > 1e-300 {
        return [origin[0] + sum[0] / (3.0 * area), origin[1] + sum[1] / (3.0 * area)];
    }
    let n = outline.len() as f64;
    [outline.iter().map(|p| p[0]).sum::<f64>() / n, outline.iter().map(|p| p[1]).sum::<f64>() / n]
}

/// How a motion is applied to the points of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Turn {
    /// Rotation as a finite angle: states of a run.
    Finite,
    /// Rotation as a velocity, which grows the block by a hair but keeps hinges closed: mechanisms.
    Small,
}

/// Displacement [m] of a point that belongs to a block with centroid `centre`.
pub(crate) fn displacement(point: Point, centre: Point, motion: Motion, turn: Turn) -> Point {
    let r = [point[0] - centre[0], point[1] - centre[1]];
    let [tx, ty] = motion.translation;
    match turn {
        Turn::Small => [tx - motion.rotation * r[1], ty + motion.rotation * r[0]],
        Turn::Finite => {
            // cos - 1 written so that small angles keep their digits.
            let (s, less) = (motion.rotation.sin(), -2.0 * (0.5 * motion.rotation).sin().powi(2));
            [tx + less * r[0] - s * r[1], ty + s * r[0] + less * r[1]]
        }
    }
}

/// The point as built that has come to `point` [m].
pub(crate) fn back(point: Point, centre: Point, motion: Motion) -> Point {
    let r = [point[0] - centre[0] - motion.translation[0], point[1] - centre[1] - motion.translation[1]];
    let (s, c) = motion.rotation.sin_cos();
    [centre[0] + c * r[0] + s * r[1], centre[1] - s * r[0] + c * r[1]]
}

/// Corners of a moved block, its displacements drawn `scale` times as large [m].
pub(crate) fn moved(shape: &Shape, motion: Motion, scale: f64, turn: Turn) -> Vec<Point> {
    let centre = centroid(&shape.outline);
    shape.outline.iter().map(|&p| exaggerated(p, centre, motion, scale, turn)).collect()
}

/// A point of a moved block, its displacement drawn `scale` times as large [m].
pub(crate) fn exaggerated(point: Point, centre: Point, motion: Motion, scale: f64, turn: Turn) -> Point {
    let u = displacement(point, centre, motion, turn);
    [point[0] + scale * u[0], point[1] + scale * u[1]]
}

/// Largest displacement of any corner [m].
pub(crate) fn largest_displacement(shapes: &[Shape], motions: &[Motion], turn: Turn) -> f64 {
    let of_block = |(shape, &motion): (&Shape, &Motion)| {
        let centre = centroid(&shape.outline);
        let size = |&p: &Point| {
            let [x, y] = displacement(p, centre, motion, turn);
            x.hypot(y)
        };
        shape.outline.iter().map(size).fold(0.0, f64::max)
    };
    shapes.iter().zip(motions).map(of_block).filter(|d| d.is_finite()).fold(0.0, f64::max)
}

/// The largest of 1, 2, 5, 10, 20, ... that is not above `x`; 0.1, 0.2, 0.5, ... below one.
pub(crate) fn round_down(x: f64) -> f64 {
    if !(x.is_finite() && x > 0.0) {
        return 1.0;
    }
    let power = 10f64.powf(x.log10().floor());
    // The allowance takes 1.9999999 of a rounded product for 2.
    let lead = x / power * (1.0 + 1e-9);
    [5.0, 2.0].into_iter().find(|step| lead >= *step).unwrap_or(1.0) * power
}

/// Distance from a point to a polygon's area [m]; zero inside.
pub(crate) fn distance(point: Point, outline: &[Point]) -> f64 {
    let mut inside = true;
    let mut least = f64::INFINITY;
    for [p, q] in sides(outline) {
        let (e, r) = ([q[0] - p[0], q[1] - p[1]], [point[0] - p[0], point[1] - p[1]]);
        inside &= e[0] * r[1] - e[1] * r[0] >= 0.0;
        let along = ((e[0] * r[0] + e[1] * r[1]) / (e[0] * e[0] + e[1] * e[1]).max(1e-300)).clamp(0.0, 1.0);
        least = least.min((r[0] - along * e[0]).hypot(r[1] - along * e[1]));
    }
    if inside { 0.0 } else { least }
}

/// The free block on which a point lies, or which is nearest to it.
pub(crate) fn block_at(shapes: &[Shape], point: Point) -> Option<usize> {
    let mut best: Option<(f64, usize)> = None;
    for (k, shape) in shapes.iter().enumerate().filter(|(_, s)| !s.held) {
        let d = distance(point, &shape.outline);
        if d.is_finite() && best.is_none_or(|b| d < b.0) {
            best = Some((d, k));
        }
    }
    best.map(|b| b.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Shape {
        let outline = vec![[10.0, 5.0], [12.0, 5.0], [12.0, 7.0], [10.0, 7.0]];
        Shape { outline, role: "block".into(), held: false }
    }

    #[test]
    fn a_quarter_turn_moves_the_corners_round() {
        let motion = Motion { translation: [1.0, 0.0], rotation: std::f64::consts::FRAC_PI_2 };
        let corners = moved(&square(), motion, 1.0, Turn::Finite);
        for (got, want) in corners.iter().zip([[13.0, 5.0], [13.0, 7.0], [11.0, 7.0], [11.0, 5.0]]) {
            assert!((got[0] - want[0]).abs() < 1e-12 && (got[1] - want[1]).abs() < 1e-12, "{got:?} {want:?}");
        }
        let built = back(corners[2], [11.0, 6.0], motion);
        assert!((built[0] - 12.0).abs() < 1e-12 && (built[1] - 7.0).abs() < 1e-12);
    }

    #[test]
    fn exaggeration_is_a_round_number_below() {
        assert_eq!([4.99, 5.0, 0.03, 1234.0, 1.0].map(round_down), [2.0, 5.0, 0.02, 1000.0, 1.0]);
        assert_eq!(round_down(f64::NAN), 1.0);
    }

    #[test]
    fn a_view_keeps_proportions_and_fits() {
        let extent = Extent { low: [-1.0, 2.0], high: [9.0, 4.0] };
        let view = View::fit(extent, Area { left: 0.0, top: 0.0, right: 100.0, bottom: 100.0 });
        assert_eq!(view.scale, 10.0);
        assert_eq!(view.spot([-1.0, 4.0]), [0.0, 0.0]);
        assert_eq!(view.spot([9.0, 2.0]), [100.0, 20.0]);
    }

    #[test]
    fn the_nearest_free_block_carries_a_load() {
        let mut far = square();
        far.outline.iter_mut().for_each(|p| p[0] += 3.0);
        let mut support = square();
        support.held = true;
        assert_eq!(block_at(&[support, square(), far.clone()], [11.0, 7.1]), Some(1));
        assert_eq!(block_at(&[square(), far], [14.0, 7.0]), Some(1));
        assert_eq!(block_at(&[], [0.0, 0.0]), None);
    }
}
