//! Outlines that share more than their edges.

use crate::Point;
use crate::finding::Findings;
use crate::outline::signed_area;
use crate::shapes::Outline;
use geo::{Area, BooleanOps, Centroid, LineString, Polygon};

/// Blocks may be drawn into one another by this share of the smaller one's half diagonal: what coordinates with six
/// digits leave between blocks that are meant to touch.
const ROUND_OFF: f64 = 1e-5;
/// Overlaps reported in one go.
const MOST: usize = 200;
/// Pairs looked at; a drawing with more is no wall of blocks side by side.
const MOST_PAIRS: usize = 4_000_000;

type Bounds = (Point, Point);

/// Reports every pair of outlines that overlap, on whatever layers they lie.
pub(crate) fn check(outlines: &[Outline], findings: &mut Findings) {
    let boxes: &[Bounds] = &outlines.iter().map(|o| bounds(&o.points)).collect::<Vec<_>>();
    let mut order: Vec<usize> = (0..outlines.len()).collect();
    order.sort_by(|&i, &j| boxes[i].0[0].total_cmp(&boxes[j].0[0]).then(i.cmp(&j)));
    let pairs = order.iter().enumerate().flat_map(|(k, &i)| {
        let reached = order[k + 1..].iter().take_while(move |&&j| boxes[j].0[0] < boxes[i].1[0]);
        reached.map(move |&j| (i.min(j), i.max(j)))
    });
    let overlaps = |&(i, j): &(usize, usize)| {
        let apart = boxes[j].0[1] >= boxes[i].1[1] || boxes[i].0[1] >= boxes[j].1[1];
        let half = |b: &Bounds| 0.5 * (b.1[0] - b.0[0]).hypot(b.1[1] - b.0[1]);
        let allowed = ROUND_OFF * half(&boxes[i]).min(half(&boxes[j]));
        !apart && depth(&outlines[i].points, &outlines[j].points) > allowed
    };
    let mut found: Vec<_> = pairs.take(MOST_PAIRS).filter(overlaps).take(MOST).collect();
    found.sort_unstable();
    for (i, j) in found {
        report(&outlines[i], &outlines[j], findings);
    }
}

fn bounds(points: &[Point]) -> Bounds {
    let fold = |pick: fn(f64, f64) -> f64, start: f64| {
        points.iter().fold([start; 2], |m, p| [pick(m[0], p[0]), pick(m[1], p[1])])
    };
    (fold(f64::min, f64::INFINITY), fold(f64::max, f64::NEG_INFINITY))
}

/// How far two convex outlines reach into one another [m], not positive where an edge separates them.
fn depth(a: &[Point], b: &[Point]) -> f64 {
    let reach = |edge_of: &[Point], other: &[Point]| {
        let n = edge_of.len();
        let mut least = f64::INFINITY;
        for i in 0..n {
            let (p, q) = (edge_of[i], edge_of[(i + 1) % n]);
            let length = (q[0] - p[0]).hypot(q[1] - p[1]);
            let inside = |v: &Point| ((q[0] - p[0]) * (v[1] - p[1]) - (q[1] - p[1]) * (v[0] - p[0])) / length;
            let deepest = other.iter().map(inside).fold(f64::NEG_INFINITY, f64::max);
            least = least.min(deepest);
        }
        least
    };
    reach(a, b).min(reach(b, a))
}

fn report(a: &Outline, b: &Outline, findings: &mut Findings) {
    let polygon = |o: &Outline| Polygon::new(LineString::from(o.points.clone()), Vec::new());
    let common = polygon(a).intersection(&polygon(b));
    let shared = common.unsigned_area();
    let at = common.centroid().map_or(a.points[0], Point::from);
    let smaller = signed_area(&a.points).min(signed_area(&b.points));
    let larger = signed_area(&a.points).max(signed_area(&b.points));
    let other = crate::Place { at: None, ..b.place.clone() }.to_string();
    // To a thousandth of the area: drawn over one another by hand, they are still the same block.
    let (message, help) = if shared >= 0.999 * larger {
        (format!("the same outline is drawn twice: here and as {other}"), "delete one of them")
    } else if shared >= 0.999 * smaller {
        (
            format!("one outline lies inside another: here and {other}"),
            "a hole cannot be drawn: cut the outer block in two",
        )
    } else {
        let message = format!("two outlines overlap by {shared:.3e} m^2: here and {other}");
        (message, "let blocks touch along their edges; move or trim one of them")
    };
    findings.error("D305", a.place.at(at), message, help);
}
