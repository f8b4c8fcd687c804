//! Abutments, piers and their foundations.
//!
//! A pier's uppermost course carries the two skewbacks as its shoulders: a hexagon of the course, the two springings
//! and the two upper ends of the skewbacks, convex as long as the rings above do not cross.

use super::build::Build;
use super::cover::{Column, Resultant};
use super::extrados::Extrados;
use super::outline::polygon;
use super::wall::Seat;
use super::{DiscretiseError, Origin};
use bridge::{AbutmentBody, Bridge, Pier};
use mechanics::blocks::{Held, PointForce};
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

impl Build<'_> {
    /// What stands behind a skewback: a fixed block, or courses on the ground; `side` is -1 for the left abutment and +1 for the right one.
    pub(super) fn abutment(&mut self, support: usize, skewback: Skewback, side: f64) -> Result<(), DiscretiseError> {
        let described = &self.bridge.abutments[usize::from(side > 0.0)];
        let Skewback { intrados: a, extrados: b } = skewback;
        let head = vec2(b.x + side * described.top_width, b.y);
        let top = if side < 0.0 { [head, b] } else { [b, head] };
        if let Some(body) = &described.body {
            let block = self.movable_abutment(support, body, [a, b, head], side)?;
            self.stretch(block, top, false);
        } else {
            let low = a.y - described.height;
            let outline = turned(support, vec![vec2(head.x, low), vec2(a.x, low), a, b, head], side)?;
            let origin = Origin::Abutment { support };
            let group = self.groups.push(origin.name());
            let block = self.block(outline, group, Held::FIXED, origin);
            self.stretch(block, top, true);
        }
        self.seats.push(Seat { left: top[0], right: top[1], span: None });
        self.extrados.line.extend(top);
        Ok(())
    }

    /// An abutment of blocks on the ground behind a skewback from `a` to `b`: a plumb front face under the springing, a straight back from
    /// the end of its upper face, `head`, to that of its bottom. Gives the uppermost block.
    fn movable_abutment(
        &mut self,
        support: usize,
        body: &AbutmentBody,
        [a, b, head]: [Vec2; 3],
        side: f64,
    ) -> Result<BlockId, DiscretiseError> {
        let height = self.bridge.abutments[usize::from(side > 0.0)].height;
        let low = a.y - height;
        let width = body.base_width.unwrap_or((head.x - a.x).abs());
        let heel = vec2(a.x + side * width, low);
        let back = |y: f64| heel + (head - heel) * ((y - low) / (head.y - low));
        let n = body.courses.max(1);
        let mut courses = Vec::with_capacity(n);
        for i in 0..n {
            let [bottom, top] = [i, i + 1].map(|k| low + height * (k as f64 / n as f64));
            let (foot, front) = (back(bottom), vec2(a.x, bottom));
            let (outline, upper) = if i + 1 < n {
                let upper = back(top);
                (vec![foot, front, vec2(a.x, top), upper], upper)
            } else {
                (vec![foot, front, a, b, head], head)
            };
            courses.push((turned(support, outline, side)?, [foot, upper]));
        }
        // Drawn only: it is fixed.
        let toe = 0.25 * width;
        let ground = Polygon::rectangle(vec2(heel.x.min(a.x) - toe, low - 2.0 * toe), width + 2.0 * toe, 2.0 * toe)
            .map_err(|source| DiscretiseError::Support { support, source })?;
        let origin = Origin::AbutmentGround { support };
        let group = self.groups.push(origin.name());
        self.grounds.push((group, body.ground_friction_angle.tan()));
        let mut block = self.block(ground, group, Held::FIXED, origin);
        let group = self.groups.push(Origin::Abutment { support }.name());
        for (course, (outline, ends)) in courses.into_iter().enumerate() {
            block = self.block(outline, group, Held::FREE, Origin::AbutmentCourse { support, course });
            self.pressed.push(Back { block, ends, inwards: -side, top: head });
        }
        Ok(block)
    }

    /// The foundation and the courses of a pier between the right skewback of one span and the left skewback of the next.
    pub(super) fn pier(
        &mut self,
        support: usize,
        pier: &Pier,
        left: Skewback,
        right: Skewback,
    ) -> Result<(), DiscretiseError> {
        let wrong = |source| DiscretiseError::Support { support, source };
        let top = [left.extrados, right.extrados];
        if top[0].x > top[1].x {
            return Err(DiscretiseError::RingsCross { support, overlap: top[0].x - top[1].x, width: pier.width });
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
        // Width across the bridge at the lower and the upper bed of each course [m], where it is not that of the barrel.
        let across = |share: f64| pier.across.map(|[top, base]| base + (top - base) * share);
        let n = pier.courses.max(1);
        let mut courses = Vec::with_capacity(n);
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
            courses.push((polygon(outline).map_err(wrong)?, across));
        }
        let [mut a, mut b] = level(0.0);
        let (mut wide, middle) = (pier.base_width, middle + pier.base_offset);
        let mut steps = Vec::with_capacity(pier.footings.len());
        for footing in &pier.footings {
            let corner = vec2(middle - 0.5 * footing.width, a.y - footing.height);
            let outline = Polygon::rectangle(corner, footing.width, footing.height).map_err(wrong)?;
            steps.push((outline, footing.across.or(across(0.0)).map(|width| [width; 2])));
            (a, b, wide) = (corner, corner + vec2(footing.width, 0.0), footing.width);
        }
        // Drawn only: it is fixed.
        let toe = 0.25 * wide;
        let foundation =
            Polygon::rectangle(vec2(a.x - toe, a.y - 2.0 * toe), b.x - a.x + 2.0 * toe, 2.0 * toe).map_err(wrong)?;
        let mut group = self.groups.push(format!("pier {support}"));
        let mut block = self.block(foundation, group, Held::FIXED, Origin::Foundation { support });
        for (course, (outline, across)) in steps.into_iter().rev().chain(courses).enumerate() {
            let ratios = across.map(|ends| ends.map(|width| width / self.bridge.width));
            if ratios.is_some() {
                group = self.groups.push(format!("pier {support} course {}", course + 1));
            }
            block = self.block(outline, group, Held::FREE, Origin::Pier { support, course });
            if let Some([low, high]) = ratios {
                self.blocks[block].density *= 0.5 * (low + high);
                if low.min(high) < 1.0 {
                    self.shares.push((group, low.min(high)));
                }
            }
        }
        self.stretch(block, top, false);
        if top[1].x > top[0].x {
            self.seats.push(Seat { left: top[0], right: top[1], span: None });
        }
        Ok(())
    }
}

/// The outline of an abutment's block from its corners on the left side, or the mirror images of these.
fn turned(support: usize, mut corners: Vec<Vec2>, side: f64) -> Result<Polygon, DiscretiseError> {
    if side > 0.0 {
        corners.reverse();
    }
    polygon(corners).map_err(|source| DiscretiseError::Support { support, source })
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
        let stress = |y: f64| body.earth_coefficient * (unit * (level - y) + column.above);
        let [low, high] = back.ends;
        let mut sum = Resultant::default();
        sum.trapezoid(low.y, stress(low.y), high.y, stress(high.y));
        let y = sum.place()?;
        let at = low + (high - low) * ((y - low.y) / (high.y - low.y));
        Some(PointForce { block: back.block, at, force: vec2(back.inwards * sum.force, 0.0) })
    };
    backs.iter().filter_map(on).collect()
}
