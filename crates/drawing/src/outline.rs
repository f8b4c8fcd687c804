//! From a closed strand to convex outlines: repairs, each said, and what cannot be repaired.

use crate::Point;
use crate::curve::off;
use crate::cut;
use crate::entities::Strand;
use crate::finding::{Findings, Place};
use crate::options::{Concave, Options};
use crate::shapes::Outline;
use ::findings::words::counted;
use geo::Line;
use geo::algorithm::line_intersection::{LineIntersection, line_intersection};

/// Points this close are the same [m], and a point this near the line between its neighbours is no corner: a micrometre
/// is far below what is drawn, and far above the round-off of coordinates in kilometres.
pub(crate) const COINCIDE: f64 = 1e-6;

/// Corners of one block, from where it is no block but a contour line: every pair of its edges is looked at.
const MOST_CORNERS: usize = 4096;

/// The convex outlines that a closed strand stands for; none where it cannot be used.
pub(crate) fn check(strand: Strand, options: &Options, findings: &mut Findings) -> Vec<Outline> {
    let Strand { place, points, flattened, .. } = strand;
    let drawn = points.len();
    let points = without_duplicates(points, &place, findings);
    if flattened {
        let tolerance = 1e3 * options.chord_tolerance;
        let message = format!("curves made into chords that lie within {tolerance} mm of them, {drawn} points in all");
        findings.note("D203", place.clone(), message);
    }
    if points.len() > MOST_CORNERS {
        let message = format!("an outline of {} points is no block", points.len());
        findings.error("D106", place, message, "state a larger chord_tolerance, or draw fewer points");
        return Vec::new();
    }
    let mut points = without_collinear(points, &place, findings);
    let area = signed_area(&points);
    let perimeter: f64 = edges(&points).map(|(a, b)| (b[0] - a[0]).hypot(b[1] - a[1])).sum();
    let crossing = if is_line(&points) { None } else { crossing(&points) };
    if let Some(at) = crossing {
        let help = "draw the outline so that it runs around the block once";
        findings.error("D302", place.at(at), "the outline crosses or touches itself", help);
        return Vec::new();
    }
    if points.len() < 3 || area.abs() <= 0.5 * COINCIDE * perimeter {
        let message = format!("the outline has no area: {:.3e} m^2", area.abs());
        findings.error("D304", place, message, "take it out, or draw the whole block");
        return Vec::new();
    }
    if area < 0.0 {
        points.reverse();
        findings.note("D206", place.clone(), "a clockwise outline turned round");
    }
    let outline = |points: Vec<Point>| Outline { layer: place.layer.clone(), place: place.clone(), points };
    let reflex = reflex_corners(&points);
    let Some(&(corner, depth)) = reflex.iter().max_by(|a, b| a.1.total_cmp(&b.1)) else { return vec![outline(points)] };
    match options.concave {
        Concave::Refuse => {
            let others = match reflex.len() {
                1 => String::new(),
                n => format!(", the deepest of {n} such corners"),
            };
            let message = format!("the outline is concave here, by {:.3} mm{others}", 1e3 * depth);
            let help = if flattened {
                "state a chord_tolerance that makes one chord of the hollow arc, cut the block in two, or state concave = \"cut\""
            } else {
                "cut the block into convex ones, or state concave = \"cut\""
            };
            findings.error("D303", place.at(points[corner]), message, help);
            Vec::new()
        }
        Concave::Cut => {
            let pieces = cut::convex(points.clone());
            let message = format!(
                "a concave outline cut into {} convex pieces, which are blocks of their own: the cuts are joints like any other",
                pieces.len()
            );
            findings.warning("D207", place.at(points[corner]), message, "see that the cuts may open and slide");
            pieces.into_iter().map(outline).collect()
        }
    }
}

fn without_duplicates(points: Vec<Point>, place: &Place, findings: &mut Findings) -> Vec<Point> {
    let near = |a: Point, b: Point| (a[0] - b[0]).hypot(a[1] - b[1]) <= COINCIDE;
    let before = points.len();
    let mut kept: Vec<Point> = Vec::with_capacity(before);
    let mut at = None;
    for p in points {
        match kept.last() {
            Some(&last) if near(last, p) => at = Some(p),
            _ => kept.push(p),
        }
    }
    while kept.len() > 1 && near(kept[0], kept[kept.len() - 1]) {
        at = kept.pop();
    }
    if let Some(at) = at {
        let removed = counted(before - kept.len(), "duplicate point");
        findings.note("D201", place.at(at), format!("{removed} removed"));
    }
    kept
}

fn without_collinear(points: Vec<Point>, place: &Place, findings: &mut Findings) -> Vec<Point> {
    let before = points.len();
    let (points, at) = straightened(points);
    if let Some(at) = at {
        let count = before - points.len();
        let words = if count == 1 { "point on a straight edge" } else { "points on straight edges" };
        findings.note("D202", place.at(at), format!("{count} {words} dropped"));
    }
    points
}

/// Drops points that lie on the line between their neighbours; gives one of them.
pub(crate) fn straightened(points: Vec<Point>) -> (Vec<Point>, Option<Point>) {
    let mut kept: Vec<Point> = Vec::with_capacity(points.len());
    // Points dropped since the last corner must stay near the edge that replaces them all.
    let mut skipped: Vec<Point> = Vec::new();
    let mut dropped = None;
    let n = points.len();
    if n < 4 {
        return (points, None);
    }
    // Start at a corner that is certainly one: the lowest of the leftmost points.
    let start =
        (0..n).min_by(|&i, &j| points[i][0].total_cmp(&points[j][0]).then(points[i][1].total_cmp(&points[j][1])));
    let start = start.unwrap_or(0);
    kept.push(points[start]);
    for k in 1..n {
        let (p, next) = (points[(start + k) % n], points[(start + k + 1) % n]);
        let last = kept[kept.len() - 1];
        skipped.push(p);
        if skipped.iter().all(|&s| off(last, next, s) <= COINCIDE) {
            dropped = Some(p);
        } else {
            kept.push(p);
            skipped.clear();
        }
    }
    // Where there is nothing to do, the order of the file stays.
    if kept.len() < 3 || dropped.is_none() { (points, None) } else { (kept, dropped) }
}

fn edges(points: &[Point]) -> impl Iterator<Item = (Point, Point)> {
    (0..points.len()).map(|i| (points[i], points[(i + 1) % points.len()]))
}

/// Area [m^2], positive counter-clockwise.
pub(crate) fn signed_area(points: &[Point]) -> f64 {
    let Some(&o) = points.first() else { return 0.0 };
    0.5 * edges(points).map(|(a, b)| (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])).sum::<f64>()
}

/// Whether all points lie on one line.
fn is_line(points: &[Point]) -> bool {
    let Some(&first) = points.first() else { return true };
    let reach = |p: &Point| (p[0] - first[0]).hypot(p[1] - first[1]);
    let farthest = points.iter().copied().max_by(|a, b| reach(a).total_cmp(&reach(b))).unwrap_or(first);
    points.iter().all(|&p| off(first, farthest, p) <= COINCIDE)
}

/// Where the outline crosses or touches itself, if it does. Predicates are exact (Shewchuk), so that no crossing is
/// missed and none is found where there is none.
fn crossing(points: &[Point]) -> Option<Point> {
    let n = points.len();
    let line = |i: usize| Line::new(points[i], points[(i + 1) % n]);
    for i in 0..n {
        // An edge that runs back over the one before it.
        let (a, b) = (line(i), line((i + 1) % n));
        let back = a.dx() * b.dx() + a.dy() * b.dy() < 0.0;
        if back && (a.dx() * b.dy() - a.dy() * b.dx()).abs() <= 1e-12 * (a.dx().hypot(a.dy()) * b.dx().hypot(b.dy())) {
            return Some(b.start.into());
        }
        for j in i + 2..n {
            if i == 0 && j == n - 1 {
                continue;
            }
            match line_intersection(line(i), line(j)) {
                Some(LineIntersection::SinglePoint { intersection, .. }) => return Some(intersection.into()),
                Some(LineIntersection::Collinear { intersection }) => return Some(intersection.start.into()),
                None => {}
            }
        }
    }
    None
}

/// Corners of a counter-clockwise outline that turn right, each with its depth below the line between its neighbours [m].
fn reflex_corners(points: &[Point]) -> Vec<(usize, f64)> {
    let n = points.len();
    let corner = |i: usize| {
        let (a, p, b) = (points[(i + n - 1) % n], points[i], points[(i + 1) % n]);
        let turn = (p[0] - a[0]) * (b[1] - p[1]) - (p[1] - a[1]) * (b[0] - p[0]);
        (turn < 0.0).then(|| (i, off(a, b, p)))
    };
    (0..n).filter_map(corner).filter(|&(_, depth)| depth > COINCIDE).collect()
}
