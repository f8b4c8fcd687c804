//! A smooth curve through the scatter of a survey.
//!
//! A circle gives the centre from which every point is seen once. The distance from it is a sum of Legendre polynomials of the angle: as many
//! terms as the scatter justifies by Schwarz's criterion. Points further from the curve than five times the scatter are left
//! out and told, and the fit is made again without them.

use super::{SectionError, faces, ground};
use faer::Mat;
use faer::linalg::solvers::SolveLstsq;
use outcome::section::{Circle, Face, Section, Surveyed};

/// Fewest points of a section.
pub(super) const FEWEST: usize = 12;

/// Most terms of the curve, and least points for each.
const MOST_TERMS: usize = 17;
const POINTS_A_TERM: usize = 6;

/// Distance from the curve over the scatter from which on a point is left out.
const OUTLYING: f64 = 5.0;

/// Points of the profile that is written, evenly spaced along it: with 25 the smooth curve through points of an ellipse of 9 m carried 2.2 %
/// more than the ellipse, with 49 it carried 0.3 % more.
const WRITTEN: usize = 81;

/// Points of the curve that is drawn.
const DRAWN: usize = 800;

/// Scatter that no survey of masonry is below [m]: what lies within five times of it is no outlier.
const ROUGH: f64 = 1e-3;

/// Scatter below which more terms are no better [m].
const LEAST: f64 = 1e-5;

/// Inclination of the line between the springings from which on they are not level.
const LEVEL: f64 = 0.005;

/// Points nearer than this in both directions are one that was given twice [m]: less than any survey resolves.
const SAME: f64 = 1e-5;

/// Share of the points that may be slips; what leaves out more is another line, as that of a parapet in a whole scan.
const MOST_LEFT_OUT: f64 = 0.1;

/// How far a curve is drawn out to the face of an abutment [m].
const FARTHEST: f64 = 0.15;

/// Rounds of refitting.
const ROUNDS: usize = 30;

/// Fits a curve to the points of a section [m], in any order. A point that is given twice counts once; the ground under the arch and upright faces of
/// abutments below the springings are left out.
///
/// # Errors
/// Too few points, or points that lie on no arch between level springings.
pub fn fit(points: &[[f64; 2]]) -> Result<Section, SectionError> {
    let too_few = |count: usize| SectionError::TooFew { count, least: FEWEST };
    let all = distinct(points);
    let repeated = points.len() - all.len();
    if all.len() < FEWEST {
        return Err(too_few(all.len()));
    }
    let (all, ground) = ground::part(&all);
    let (points, faces) = faces::cut(&all);
    if !ground.is_empty() && faces.is_empty() {
        return Err(SectionError::NoArch {
            why: "it holds the ground under the arch, and no faces of abutments are told from it",
        });
    }
    let circle = robust_circle(&points).ok_or(SectionError::NoArch { why: "they lie on a straight line" })?;
    let polar = Polar { centre: circle.centre };
    let seen = in_order(&polar, &points)
        .ok_or(SectionError::NoArch { why: "some lie below the centre of the circle through the others" })?;
    let mut kept = robust(&seen).ok_or(SectionError::NoArch { why: "no smooth curve passes through them" })?;
    let mut curve = None;
    for _ in 0..5 {
        if kept.iter().filter(|kept| **kept).count() < FEWEST {
            return Err(too_few(kept.iter().filter(|kept| **kept).count()));
        }
        let found = chosen(&seen, &kept).ok_or(SectionError::NoArch { why: "no smooth curve passes through them" })?;
        let again = inlying(&seen, &found);
        let settled = again == kept;
        (kept, curve) = (again, Some(found));
        if settled {
            break;
        }
    }
    let curve = polar.up_to(curve.ok_or(too_few(0))?, &faces);
    let mut found = section(&polar, &curve, &seen, &kept)?;
    let deviation = |at: [f64; 2]| curve.deviation(polar.of(at));
    found.points.extend(ground.into_iter().map(|at| Surveyed { at, deviation: deviation(at), is_left_out: true }));
    Ok(Section { repeated, faces, ..found })
}

/// Points without those that are given again, from left to right.
fn distinct(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut kept: Vec<[f64; 2]> = Vec::with_capacity(sorted.len());
    for point in sorted {
        let near = |other: &&[f64; 2]| point[0] - other[0] <= SAME;
        if !kept.iter().rev().take_while(near).any(|other| (point[1] - other[1]).abs() <= SAME) {
            kept.push(point);
        }
    }
    kept
}

/// Points in the order along the curve, with their directions; none where some lie below the centre.
pub(super) fn in_order(polar: &Polar, points: &[[f64; 2]]) -> Option<Vec<Seen>> {
    let mut seen: Vec<Seen> = points.iter().map(|&point| (polar.of(point), point)).collect();
    seen.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]).then(a.0[1].total_cmp(&b.0[1])));
    seen.iter().all(|([angle, _], _)| angle.abs() <= 0.75 * std::f64::consts::PI).then_some(seen)
}

/// Directions from a centre: angle from the vertical, clockwise [rad], and distance [m].
pub(super) struct Polar {
    pub(super) centre: [f64; 2],
}

impl Polar {
    fn of(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (dx, dy) = (x - self.centre[0], y - self.centre[1]);
        [dx.atan2(dy), dx.hypot(dy)]
    }
    fn point(&self, angle: f64, radius: f64) -> [f64; 2] {
        [self.centre[0] + radius * angle.sin(), self.centre[1] + radius * angle.cos()]
    }
    /// Angles between the ends of a curve and an upright line [rad].
    pub(super) fn steepness(&self, curve: &Radius) -> [f64; 2] {
        const STEP: f64 = 1e-3;
        [[0, 1], [1, 0]].map(|[end, other]| {
            let angle = curve.ends[end];
            let inside = angle + STEP * (curve.ends[other] - angle);
            let (a, b) = (self.point(angle, curve.at(angle)), self.point(inside, curve.at(inside)));
            (b[0] - a[0]).abs().atan2((b[1] - a[1]).abs())
        })
    }
    /// A curve from face to face: its last points lie some way above the springings, at whose level the faces end. It is drawn out to where
    /// it meets them, no further than [`FARTHEST`]; a curve that meets none within it ends at its last point.
    fn up_to(&self, curve: Radius, faces: &[Face]) -> Radius {
        const STEPS: usize = 200;
        let [from, to] = curve.ends;
        let x = |angle: f64| self.point(angle, curve.at(angle))[0];
        let middle = 0.5 * (x(from) + x(to));
        let end = |angle: f64, outwards: f64| {
            let face = faces.iter().find(|face| (face.x - middle) * outwards > 0.0);
            let step = outwards * FARTHEST / STEPS as f64 / curve.at(angle);
            let reached = |k: &usize| face.is_some_and(|face| (x(angle + *k as f64 * step) - face.x) * outwards >= 0.0);
            (0..=STEPS).find(reached).map_or(angle, |k| angle + k as f64 * step)
        };
        let drawn = [end(from, -1.0), end(to, 1.0)];
        Radius { drawn, ..curve }
    }
}

/// Distance from the centre over the angle.
pub(super) struct Radius {
    /// Angles of the first and the last point that it passes [rad].
    ends: [f64; 2],
    /// Angles of its own ends [rad].
    drawn: [f64; 2],
    pub(super) terms: Vec<f64>,
}

impl Radius {
    fn share(ends: [f64; 2], angle: f64) -> f64 {
        2.0 * (angle - ends[0]) / (ends[1] - ends[0]) - 1.0
    }
    fn at(&self, angle: f64) -> f64 {
        legendre(Radius::share(self.ends, angle), self.terms.len()).iter().zip(&self.terms).map(|(p, c)| p * c).sum()
    }
    /// Distance of a point from the curve, outwards [m]: along the ray, by the slope of the curve against it.
    pub(super) fn deviation(&self, [angle, radius]: [f64; 2]) -> f64 {
        const STEP: f64 = 1e-5;
        let slope = (self.at(angle + STEP) - self.at(angle - STEP)) / (2.0 * STEP);
        let at = self.at(angle);
        (radius - at) / (1.0 + (slope / at).powi(2)).sqrt()
    }
}

/// Values of the first polynomials of Legendre.
fn legendre(x: f64, count: usize) -> Vec<f64> {
    let mut values = vec![1.0, x];
    for n in 1..count.max(2) {
        let n_ = n as f64;
        values.push(((2.0 * n_ + 1.0) * x * values[n] - n_ * values[n - 1]) / (n_ + 1.0));
    }
    values.truncate(count);
    values
}

/// A point by its direction from the centre, and as it was surveyed.
pub(super) type Seen = ([f64; 2], [f64; 2]);

/// Least squares with so many terms and these weights; none where it has no solution.
fn radius(seen: &[Seen], weights: &[f64], terms: usize) -> Option<Radius> {
    let used: Vec<usize> = (0..seen.len()).filter(|&k| weights[k] > 0.0).collect();
    let ends = [seen[*used.first()?].0[0], seen[*used.last()?].0[0]];
    if !(ends[1] - ends[0] > 1e-3) {
        return None;
    }
    let rows: Vec<Vec<f64>> = used.iter().map(|&k| legendre(Radius::share(ends, seen[k].0[0]), terms)).collect();
    let matrix = Mat::from_fn(used.len(), terms, |i, j| weights[used[i]].sqrt() * rows[i][j]);
    let right = Mat::from_fn(used.len(), 1, |i, _| weights[used[i]].sqrt() * seen[used[i]].0[1]);
    let found = matrix.col_piv_qr().solve_lstsq(&right);
    let terms: Vec<f64> = (0..terms).map(|k| found[(k, 0)]).collect();
    terms.iter().all(|term| term.is_finite()).then_some(Radius { ends, drawn: ends, terms })
}

/// Median of sizes; from that of deviations follows the scatter of those that are normally distributed.
fn median(mut sizes: Vec<f64>) -> f64 {
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied().unwrap_or(0.0)
}

fn scatter(deviations: &[f64]) -> f64 {
    (1.4826 * median(deviations.iter().map(|d| d.abs()).collect())).max(ROUGH)
}

/// Tukey's weights: nothing beyond some five times the scatter.
fn weights(deviations: &[f64]) -> Vec<f64> {
    let limit = 4.685 * scatter(deviations);
    deviations.iter().map(|d| (1.0 - (d / limit).powi(2)).max(0.0).powi(2)).collect()
}

/// A circle that outliers do not move; none where the points lie on a line.
pub(super) fn robust_circle(points: &[[f64; 2]]) -> Option<Circle> {
    let mut weights_ = vec![1.0; points.len()];
    let mut found = None;
    for _ in 0..ROUNDS {
        let circle = circle(points, &weights_)?;
        let off = |p: &[f64; 2]| (p[0] - circle.centre[0]).hypot(p[1] - circle.centre[1]) - circle.radius;
        weights_ = weights(&points.iter().map(off).collect::<Vec<_>>());
        found = Some(circle);
    }
    found
}

/// The circle x^2 + y^2 + d x + e y + f = 0 by least squares (Kasa 1976), about the mean of the points.
fn circle(points: &[[f64; 2]], weights: &[f64]) -> Option<Circle> {
    let sum: f64 = weights.iter().sum();
    let mean = [0, 1].map(|i| points.iter().zip(weights).map(|(p, w)| w * p[i]).sum::<f64>() / sum);
    let at = |k: usize| [points[k][0] - mean[0], points[k][1] - mean[1]];
    let matrix = Mat::from_fn(points.len(), 3, |i, j| weights[i].sqrt() * [at(i)[0], at(i)[1], 1.0][j]);
    let square = |i: usize| at(i)[0].powi(2) + at(i)[1].powi(2);
    let right = Mat::from_fn(points.len(), 1, |i, _| -weights[i].sqrt() * square(i));
    let found = matrix.col_piv_qr().solve_lstsq(&right);
    let [d, e, f] = [0, 1, 2].map(|k| found[(k, 0)]);
    let radius = (0.25 * (d * d + e * e) - f).sqrt();
    let size = points.iter().map(|p| (p[0] - mean[0]).hypot(p[1] - mean[1])).fold(0.0, f64::max);
    (radius.is_finite() && radius < 1e3 * size && size > 0.0).then_some(Circle {
        centre: [mean[0] - 0.5 * d, mean[1] - 0.5 * e],
        radius,
        scatter: 0.0,
    })
}

/// Which points lie near a curve of few terms that outliers do not move.
pub(super) fn robust(seen: &[Seen]) -> Option<Vec<bool>> {
    let terms = (seen.len() / POINTS_A_TERM).clamp(2, 9);
    let mut weights_ = vec![1.0; seen.len()];
    let mut deviations = Vec::new();
    for _ in 0..ROUNDS {
        let curve = radius(seen, &weights_, terms)?;
        deviations = seen.iter().map(|(polar, _)| curve.deviation(*polar)).collect();
        weights_ = weights(&deviations);
    }
    let limit = OUTLYING * scatter(&deviations);
    Some(deviations.iter().map(|d| d.abs() <= limit).collect())
}

fn inlying(seen: &[Seen], curve: &Radius) -> Vec<bool> {
    let deviations: Vec<f64> = seen.iter().map(|(polar, _)| curve.deviation(*polar)).collect();
    let limit = OUTLYING * scatter(&deviations);
    deviations.iter().map(|d| d.abs() <= limit).collect()
}

/// The curve with as many terms as the points that are kept justify (Schwarz 1978).
pub(super) fn chosen(seen: &[Seen], kept: &[bool]) -> Option<Radius> {
    let weights: Vec<f64> = kept.iter().map(|kept| f64::from(u8::from(*kept))).collect();
    let count = kept.iter().filter(|kept| **kept).count();
    let most = (count / POINTS_A_TERM).clamp(1, MOST_TERMS);
    let score = |curve: &Radius| {
        let kept = seen.iter().zip(kept).filter(|(_, kept)| **kept);
        let squares: f64 = kept.map(|((polar, _), _)| curve.deviation(*polar).powi(2)).sum();
        let n = count as f64;
        n * (squares / n).max(LEAST * LEAST).ln() + curve.terms.len() as f64 * n.ln()
    };
    let curves = (1..=most).filter_map(|terms| radius(seen, &weights, terms));
    curves.map(|curve| (score(&curve), curve)).min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, curve)| curve)
}

fn section(polar: &Polar, curve: &Radius, seen: &[Seen], kept: &[bool]) -> Result<Section, SectionError> {
    let [from, to] = curve.drawn;
    let along = |count: usize| {
        (0..=count).map(move |k| from + (to - from) * k as f64 / count as f64).map(|a| polar.point(a, curve.at(a)))
    };
    let drawn: Vec<[f64; 2]> = along(DRAWN).collect();
    let (left, right) = (drawn[0], drawn[DRAWN]);
    let (span, tilt) = (right[0] - left[0], right[1] - left[1]);
    if !(span > 0.0) {
        return Err(SectionError::NoArch { why: "the right end lies to the left of the left one" });
    }
    if tilt.abs() > LEVEL * span {
        return Err(SectionError::NotLevel { tilt, span });
    }
    let (sine, cosine) = (tilt / span.hypot(tilt), span / span.hypot(tilt));
    let level = |[x, y]: [f64; 2]| {
        let (dx, dy) = (x - left[0], y - left[1]);
        [dx * cosine + dy * sine, dy * cosine - dx * sine]
    };
    let mut written: Vec<[f64; 2]> = even(&drawn, WRITTEN).into_iter().map(level).collect();
    // Level to the last bit.
    (written[0], written[WRITTEN - 1][1]) = ([0.0; 2], 0.0);
    if written[1..WRITTEN - 1].iter().any(|point| !(point[1] > 0.0)) {
        return Err(SectionError::NoArch { why: "the curve sinks below the line between its ends" });
    }
    let deviations: Vec<f64> = seen.iter().map(|(polar, _)| curve.deviation(*polar)).collect();
    let points = seen.iter().zip(&deviations).zip(kept);
    let points: Vec<Surveyed> = points
        .map(|(((_, at), deviation), kept)| Surveyed { at: *at, deviation: *deviation, is_left_out: !kept })
        .collect();
    let used: Vec<&Surveyed> = points.iter().filter(|point| !point.is_left_out).collect();
    if (points.len() - used.len()) as f64 > MOST_LEFT_OUT * points.len() as f64 {
        return Err(SectionError::NoArch { why: "more than a tenth of them lie beside the curve through the others" });
    }
    let rms = |squares: f64| (squares / used.len() as f64).sqrt();
    let at: Vec<[f64; 2]> = used.iter().map(|point| point.at).collect();
    let circle =
        circle(&at, &vec![1.0; at.len()]).ok_or(SectionError::NoArch { why: "they lie on a straight line" })?;
    let off = |p: &[f64; 2]| (p[0] - circle.centre[0]).hypot(p[1] - circle.centre[1]) - circle.radius;
    let circle = Circle { scatter: rms(at.iter().map(|p| off(p).powi(2)).sum()), ..circle };
    let gap = at.windows(2).map(|p| ((p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1]), [p[0][0], p[1][0]]));
    let gap = gap.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((0.0, [left[0], right[0]]));
    let scatter = rms(used.iter().map(|point| point.deviation.powi(2)).sum());
    Ok(Section {
        scatter,
        noise: noise(&used),
        terms: curve.terms.len(),
        tilt,
        circle,
        gap,
        curve: written,
        drawn,
        points,
        repeated: 0,
        faces: Vec::new(),
    })
}

/// So many points of a line, evenly spaced along it, both ends among them.
fn even(line: &[[f64; 2]], count: usize) -> Vec<[f64; 2]> {
    let mut lengths = vec![0.0];
    for pair in line.windows(2) {
        lengths.push(lengths[lengths.len() - 1] + (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]));
    }
    let last = line.len() - 1;
    let point = |k: usize| {
        let wanted = lengths[last] * k as f64 / (count - 1) as f64;
        let end = lengths.partition_point(|length| *length < wanted).clamp(1, last);
        let share = (wanted - lengths[end - 1]) / (lengths[end] - lengths[end - 1]);
        [0, 1].map(|i| line[end - 1][i] + (line[end][i] - line[end - 1][i]) * share)
    };
    (0..count).map(point).collect()
}

/// What neighbouring points scatter [m]: second differences of independent deviations have one and a half times their variance.
fn noise(used: &[&Surveyed]) -> f64 {
    let second = used.windows(3).map(|w| w[1].deviation - 0.5 * (w[0].deviation + w[2].deviation));
    let squares: f64 = second.map(|d| d * d).sum();
    (squares / (1.5 * (used.len().max(3) - 2) as f64)).sqrt()
}
