//! Outlines of abutments, piers and their foundations.
//!
//! A pier's uppermost course carries the two skewbacks as its shoulders: a hexagon of the course, the two springings
//! and the two upper ends of the skewbacks, convex as long as the rings above do not cross.

use super::DiscretiseError;
use bridge::{Abutment, Pier};
use mechanics::plane::{Polygon, Vec2, vec2};

/// A skewback: the joint on which a span's rings spring, from the intrados to the extrados [m].
#[derive(Debug, Clone, Copy)]
pub struct Skewback {
    /// At the intrados.
    pub intrados: Vec2,
    /// At the extrados of the uppermost ring.
    pub extrados: Vec2,
}

/// The fixed block behind a skewback; `side` is -1 for the left abutment and +1 for the right one. Returns its
/// outline and its upper face, left to right.
pub fn abutment(
    support: usize,
    abutment: &Abutment,
    skewback: Skewback,
    side: f64,
) -> Result<(Polygon, [Vec2; 2]), DiscretiseError> {
    let Skewback { intrados: a, extrados: b } = skewback;
    let back = vec2(b.x + side * abutment.top_width, b.y);
    let low = a.y - abutment.height;
    let mut outline = vec![vec2(back.x, low), vec2(a.x, low), a, b, back];
    if side > 0.0 {
        outline.reverse();
    }
    let outline = polygon(outline).map_err(|source| DiscretiseError::Support { support, source })?;
    let top = if side < 0.0 { [back, b] } else { [b, back] };
    Ok((outline, top))
}

/// A pier's blocks.
pub struct PierCut {
    /// The fixed block it stands on.
    pub foundation: Polygon,
    /// Courses from the foundation up; the last carries the skewbacks.
    pub courses: Vec<Polygon>,
    /// Upper face between the two rings, left to right.
    pub top: [Vec2; 2],
}

/// The courses of a pier between the right skewback of one span and the left skewback of the next.
pub fn pier(support: usize, pier: &Pier, left: Skewback, right: Skewback) -> Result<PierCut, DiscretiseError> {
    let wrong = |source| DiscretiseError::Support { support, source };
    if left.extrados.x > right.extrados.x {
        return Err(DiscretiseError::RingsCross {
            support,
            overlap: left.extrados.x - right.extrados.x,
            width: pier.width,
        });
    }
    let middle = 0.5 * (left.intrados.x + right.intrados.x);
    let springing = 0.5 * (left.intrados.y + right.intrados.y);
    // Corners at a level, given as a share of the height: 0 at the foundation, 1 at the springings.
    let level = |share: f64| {
        let half = 0.5 * (pier.base_width + (pier.width - pier.base_width) * share);
        let y = springing - pier.height * (1.0 - share);
        [vec2(middle - half, y), vec2(middle + half, y)]
    };
    let n = pier.courses.max(1);
    let mut courses = Vec::with_capacity(n);
    for i in 0..n {
        let low = level(i as f64 / n as f64);
        let outline = if i + 1 < n {
            let high = level((i + 1) as f64 / n as f64);
            vec![low[0], low[1], high[1], high[0]]
        } else {
            vec![low[0], low[1], right.intrados, right.extrados, left.extrados, left.intrados]
        };
        courses.push(polygon(outline).map_err(wrong)?);
    }
    // Drawn only: it is fixed.
    let [a, b] = level(0.0);
    let toe = 0.25 * pier.base_width;
    let foundation =
        Polygon::rectangle(vec2(a.x - toe, a.y - 2.0 * toe), b.x - a.x + 2.0 * toe, 2.0 * toe).map_err(wrong)?;
    Ok(PierCut { foundation, courses, top: [left.extrados, right.extrados] })
}

/// The outline without corners that coincide or lie on a straight edge: a face must be one edge for the blocks that
/// rest on it.
fn polygon(mut corners: Vec<Vec2>) -> Result<Polygon, mechanics::plane::PolygonError> {
    corners.dedup_by(|a, b| (*a - *b).norm() < 1e-9);
    let straight = |before: Vec2, at: Vec2, after: Vec2| {
        let (u, v) = ((at - before).unit(), (after - at).unit());
        u.cross(v).abs() < 1e-9 && u.dot(v) > 0.0
    };
    let n = corners.len();
    let kept = (0..n)
        .filter(|&i| !straight(corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]))
        .map(|i| corners[i])
        .collect();
    Polygon::new(kept)
}
