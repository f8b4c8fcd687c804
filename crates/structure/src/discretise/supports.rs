//! Outlines of abutments, piers and their foundations.
//!
//! A pier's uppermost course carries the two skewbacks as its shoulders: a hexagon of the course, the two springings
//! and the two upper ends of the skewbacks, convex as long as the rings above do not cross.

use super::DiscretiseError;
use super::cover::{Column, Resultant};
use super::extrados::Extrados;
use super::outline::polygon;
use bridge::{Abutment, AbutmentBody, Bridge, Pier};
use mechanics::blocks::PointForce;
use mechanics::ids::BlockId;
use mechanics::plane::{Polygon, Vec2, vec2};

/// A skewback: the joint on which a span's rings spring, from the intrados to the extrados [m].
#[derive(Debug, Clone, Copy)]
pub(super) struct Skewback {
    /// At the intrados.
    pub intrados: Vec2,
    /// At the extrados of the uppermost ring.
    pub extrados: Vec2,
}

/// The fixed block behind a skewback; `side` is -1 for the left abutment and +1 for the right one. Returns its
/// outline and its upper face, left to right.
pub(super) fn abutment(
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
pub(super) struct PierCut {
    /// The fixed block it stands on.
    pub foundation: Polygon,
    /// Courses from the foundation up, steps of the footing first; the last carries the skewbacks.
    pub courses: Vec<Course>,
    /// Upper face between the two rings, left to right.
    pub top: [Vec2; 2],
}

/// A course of a pier.
pub(super) struct Course {
    pub outline: Polygon,
    /// Width across the bridge at its lower and its upper bed [m], where it is not that of the barrel.
    pub across: Option<[f64; 2]>,
}

/// The courses of a pier between the right skewback of one span and the left skewback of the next.
pub(super) fn pier(support: usize, pier: &Pier, left: Skewback, right: Skewback) -> Result<PierCut, DiscretiseError> {
    let wrong = |source| DiscretiseError::Support { support, source };
    if left.extrados.x > right.extrados.x {
        return Err(DiscretiseError::RingsCross {
            support,
            overlap: left.extrados.x - right.extrados.x,
            width: pier.width,
        });
    }
    let middle = 0.5 * (left.intrados.x + right.intrados.x);
    let springing = left.intrados.y.min(right.intrados.y);
    // Corners at a level, given as a share of the height: 0 at the foundation, 1 at the springings.
    let level = |share: f64| {
        let half = 0.5 * (pier.base_width + (pier.width - pier.base_width) * share);
        let middle = middle + pier.base_offset * (1.0 - share);
        let y = springing - pier.height * (1.0 - share);
        [vec2(middle - half, y), vec2(middle + half, y)]
    };
    let across = |share: f64| pier.across.map(|[top, base]| base + (top - base) * share);
    let n = pier.courses.max(1);
    let mut courses = Vec::with_capacity(n + pier.footings.len());
    for i in 0..n {
        let ends = [i as f64 / n as f64, (i + 1) as f64 / n as f64];
        let low = level(ends[0]);
        let outline = if i + 1 < n {
            let high = level(ends[1]);
            vec![low[0], low[1], high[1], high[0]]
        } else {
            vec![low[0], low[1], right.intrados, right.extrados, left.extrados, left.intrados]
        };
        let across = across(ends[0]).zip(across(ends[1])).map(|(low, high)| [low, high]);
        courses.push(Course { outline: polygon(outline).map_err(wrong)?, across });
    }
    // Drawn only: it is fixed.
    let [mut a, mut b] = level(0.0);
    let mut wide = b.x - a.x;
    if !pier.footings.is_empty() {
        let middle = middle + pier.base_offset;
        let mut steps = Vec::with_capacity(pier.footings.len());
        for footing in &pier.footings {
            let corner = vec2(middle - 0.5 * footing.width, a.y - footing.height);
            let outline = Polygon::rectangle(corner, footing.width, footing.height).map_err(wrong)?;
            let across = footing.across.or(across(0.0)).map(|width| [width; 2]);
            steps.push(Course { outline, across });
            (a, b, wide) = (corner, corner + vec2(footing.width, 0.0), footing.width);
        }
        steps.reverse();
        steps.append(&mut courses);
        courses = steps;
    }
    let toe = 0.25 * if pier.footings.is_empty() { pier.base_width } else { wide };
    let foundation =
        Polygon::rectangle(vec2(a.x - toe, a.y - 2.0 * toe), b.x - a.x + 2.0 * toe, 2.0 * toe).map_err(wrong)?;
    Ok(PierCut { foundation, courses, top: [left.extrados, right.extrados] })
}

/// An abutment that can move.
pub(super) struct MovableCut {
    /// The ground it stands on, which is fixed.
    pub ground: Polygon,
    /// Courses from the ground up with the lower and upper end of their backs; the last carries the skewback.
    pub courses: Vec<(Polygon, [Vec2; 2])>,
    /// Upper face, left to right.
    pub top: [Vec2; 2],
}

/// The courses of an abutment behind a skewback: a plumb front face under the springing, a straight back from the end of its upper face to
/// that of its bottom. `side` is -1 for the left abutment and +1 for the right one.
pub(super) fn movable(
    support: usize,
    abutment: &Abutment,
    body: &AbutmentBody,
    skewback: Skewback,
    side: f64,
) -> Result<MovableCut, DiscretiseError> {
    let wrong = |source| DiscretiseError::Support { support, source };
    let Skewback { intrados: a, extrados: b } = skewback;
    let head = vec2(b.x + side * abutment.top_width, b.y);
    let low = a.y - abutment.height;
    let width = body.base_width.unwrap_or((head.x - a.x).abs());
    let heel = vec2(a.x + side * width, low);
    let back = |y: f64| heel + (head - heel) * ((y - low) / (head.y - low));
    let n = body.courses.max(1);
    let mut courses = Vec::with_capacity(n);
    for i in 0..n {
        let [bottom, top] = [i, i + 1].map(|k| low + abutment.height * (k as f64 / n as f64));
        let foot = back(bottom);
        let (mut outline, upper) = if i + 1 < n {
            let upper = back(top);
            (vec![foot, vec2(a.x, bottom), vec2(a.x, top), upper], upper)
        } else {
            (vec![foot, vec2(a.x, bottom), a, b, head], head)
        };
        if side > 0.0 {
            outline.reverse();
        }
        courses.push((polygon(outline).map_err(wrong)?, [foot, upper]));
    }
    // Drawn only: it is fixed.
    let toe = 0.25 * width;
    let ground = Polygon::rectangle(vec2(heel.x.min(a.x) - toe, low - 2.0 * toe), width + 2.0 * toe, 2.0 * toe)
        .map_err(wrong)?;
    Ok(MovableCut { ground, courses, top: if side < 0.0 { [head, b] } else { [b, head] } })
}

/// The back of a course on which soil presses.
pub(super) struct Back {
    pub block: BlockId,
    /// Its lower and upper end [m].
    pub ends: [Vec2; 2],
    /// Which way soil presses along x: -1 or +1.
    pub inwards: f64,
    /// The upper end of the whole back [m].
    pub top: Vec2,
}

/// What soil presses with on the backs of abutments that can move: its vertical stress behind the head of the back, times the coefficient of
/// the file. Soil reaches up to the cover's layers, which weigh on it, or to the abutment's top where there is no cover; what lies on a
/// sloping back is left out.
pub(super) fn earth(bridge: &Bridge, extrados: &Extrados, backs: &[Back]) -> Vec<PointForce> {
    let cover = &bridge.cover;
    let column = Column::of(bridge, extrados);
    let on = |back: &Back| {
        let body = bridge.abutments[usize::from(back.inwards < 0.0)].body?;
        let lowest = cover.layers.first().map_or(0.0, |layer| layer.density);
        let unit = body.earth_density.unwrap_or(lowest) * bridge.gravity;
        let level = column.top(back.top.x).max(back.top.y);
        let stress = |y: f64| body.earth_coefficient * (unit * (level - y) + column.above());
        let [low, high] = back.ends;
        let mut sum = Resultant::default();
        sum.trapezoid(low.y, stress(low.y), high.y, stress(high.y));
        let y = sum.place()?;
        let at = low + (high - low) * ((y - low.y) / (high.y - low.y));
        Some(PointForce { block: back.block, at, force: vec2(back.inwards * sum.force, 0.0) })
    };
    backs.iter().filter_map(on).collect()
}
