//! Solid backing as blocks: stones with level beds on steep haunches, a column on every flatter back.
//!
//! A column on a steep back would slide off it and leave a gap beside the abutment. Where backs are steeper than 45 degrees,
//! stones with level beds therefore reach from back to back over a pier, and over an abutment's top to a plumb face. What
//! stands behind that face is not masonry: stones rest on the abutment by friction, and fill presses on the face where the
//! file says that fill presses.

use super::build::Build;
use super::extrados::{Face, Stretch};
use super::springings::are_level;
use super::wall::Layout;
use super::wall::haunch::stones;
use super::{DiscretiseError, Origin};
use crate::extent::extent;
use bridge::Backing;
use mechanics::blocks::Held;
use mechanics::ids::{BlockId, GroupId};
use mechanics::plane::{Polygon, Vec2, vec2};

/// Least thickness and width of a piece that the backing's level cuts [m].
const LEAST: f64 = 0.05;

/// Points nearer than this are one [m].
const NEAR: f64 = 1e-9;

/// The foot of the backing between two spans, or between a span and the end of an abutment.
struct Valley {
    /// Upper face of the pier or abutment, from left to right; ends in one point where two rings meet.
    flat: [Vec2; 2],
    /// The flat part's stretch, where it has a length.
    seat: Option<Stretch>,
    /// Backs on the left and on the right, each from the springing up, as places among the stretches.
    sides: [Vec<usize>; 2],
    /// Level up to which stones have level beds [m].
    head: f64,
}

impl Build<'_> {
    /// Lays backing up to a level [m] on the extrados. Gives the upper faces of the backing and the backs that it leaves bare, from left to right,
    /// and the plumb faces at its ends, with fill behind them.
    pub(super) fn backed(
        &mut self,
        backing: &Backing,
        level: f64,
    ) -> Result<(Vec<Stretch>, Vec<Face>), DiscretiseError> {
        if !are_level(self.bridge) {
            return Err(DiscretiseError::SpringingsNotLevel { what: "backing as blocks" });
        }
        let group = self.groups.push("backing".into());
        if backing.width_share < 1.0 {
            self.shares.push((group, backing.width_share));
        }
        let stretches = self.extrados.stretches.clone();
        let mut laying = Laying { build: self, backing, level, group, pieces: 0, upper: Vec::new(), faces: Vec::new() };
        // Level below which stones cover a stretch already.
        let mut covered = vec![f64::NEG_INFINITY; stretches.len()];
        for valley in laying.valleys(&stretches) {
            for &k in valley.sides.iter().flatten() {
                covered[k] = valley.head;
            }
            laying.fill(&valley, &stretches)?;
        }
        for (k, stretch) in stretches.iter().enumerate() {
            if laying.span(stretch).is_some()
                && let Some(rest) = above(stretch, covered[k])
            {
                laying.on(&rest, None);
            }
        }
        let (mut upper, faces) = (laying.upper, laying.faces);
        upper.sort_by(|a, b| a.left.x.total_cmp(&b.left.x));
        Ok((upper, faces))
    }
}

/// The part of a back above a level; none where it lies below.
fn above(stretch: &Stretch, level: f64) -> Option<Stretch> {
    let (a, b) = (stretch.left, stretch.right);
    if a.y.max(b.y) <= level + NEAR {
        return None;
    }
    if a.y.min(b.y) >= level - NEAR {
        return Some(*stretch);
    }
    let cut = a + (b - a) * ((level - a.y) / (b.y - a.y));
    Some(if a.y < b.y { Stretch { left: cut, ..*stretch } } else { Stretch { right: cut, ..*stretch } })
}

/// Whether a back is steeper than 45 degrees.
fn steep(stretch: &Stretch) -> bool {
    (stretch.right.y - stretch.left.y).abs() > stretch.right.x - stretch.left.x
}

struct Laying<'a, 'b> {
    build: &'a mut Build<'b>,
    backing: &'a Backing,
    level: f64,
    group: GroupId,
    pieces: usize,
    upper: Vec<Stretch>,
    faces: Vec<Face>,
}

impl Laying<'_, '_> {
    /// The span whose ring a stretch belongs to.
    fn span(&self, stretch: &Stretch) -> Option<usize> {
        match self.build.origins[stretch.block] {
            Origin::Voussoir { span, .. } => Some(span),
            _ => None,
        }
    }

    fn valleys(&self, stretches: &[Stretch]) -> Vec<Valley> {
        let mut valleys = vec![Valley { flat: [Vec2::ZERO; 2], seat: None, sides: [vec![], vec![]], head: 0.0 }];
        let mut first = 0;
        for run in stretches.chunk_by(|a, b| self.span(a) == self.span(b)) {
            let places: Vec<usize> = (first..first + run.len()).collect();
            first += run.len();
            let Some(valley) = valleys.last_mut() else { continue };
            if self.span(&run[0]).is_none() {
                (valley.seat, valley.flat) = (Some(run[0]), [run[0].left, run[run.len() - 1].right]);
                continue;
            }
            if valley.seat.is_none() {
                valley.flat = [run[0].left; 2];
            }
            let (rising, falling) = places.split_at(run.len() / 2);
            valley.sides[1] = rising.to_vec();
            let end = run[run.len() - 1].right;
            let falling = falling.iter().rev().copied().collect();
            valleys.push(Valley { flat: [end; 2], seat: None, sides: [falling, vec![]], head: 0.0 });
        }
        for valley in &mut valleys {
            for side in &mut valley.sides {
                let reach = side.iter().take_while(|&&k| steep(&stretches[k])).count();
                side.truncate(reach);
            }
            valley.head = self.head(valley, stretches);
        }
        valleys
    }

    /// Level up to which stones have level beds: that of the steep backs on both sides, and of the backing. A stone thinner than
    /// [`LEAST`] is left out.
    fn head(&self, valley: &Valley, stretches: &[Stretch]) -> f64 {
        let steep: Vec<&Vec<usize>> = valley.sides.iter().filter(|side| !side.is_empty()).collect();
        if steep.is_empty() {
            return f64::NEG_INFINITY;
        }
        let corner = |k: usize| stretches[k].left.y.max(stretches[k].right.y);
        let tops = steep.iter().map(|side| corner(side[side.len() - 1]));
        let head = tops.fold(self.level, f64::min);
        let foot = valley.flat[0].y.max(valley.flat[1].y);
        let mut corners = steep.iter().flat_map(|side| side.iter().map(|&k| corner(k))).chain([foot]);
        corners.find(|y| head > y + NEAR && head - y < LEAST).unwrap_or(head)
    }

    /// Stones with level beds in a valley, and the block on them up to the backing's level.
    fn fill(&mut self, valley: &Valley, stretches: &[Stretch]) -> Result<(), DiscretiseError> {
        let foot = valley.flat[0].y.max(valley.flat[1].y);
        let is_left = |seat: &Stretch| seat.right.x < stretches[stretches.len() / 2].left.x;
        // Backing ends at the top of an abutment.
        let is_abutment = |origin| matches!(origin, Origin::Abutment { .. } | Origin::AbutmentCourse { .. });
        let last = valley.seat.filter(|seat| is_abutment(self.build.origins[seat.block]));
        let end = last.map(|seat| valley.flat[usize::from(!is_left(&seat))].x);
        if !(valley.head > foot + NEAR) {
            if let Some(seat) = valley.seat {
                self.on(&Stretch { left: valley.flat[0], right: valley.flat[1], ..seat }, end);
            }
            return Ok(());
        }
        let chain = |side: usize| {
            let backs = &valley.sides[side];
            if backs.is_empty() {
                return vec![valley.flat[side], vec2(valley.flat[side].x, valley.head)];
            }
            let mut corners = vec![valley.flat[side]];
            for &k in backs {
                let (a, b) = (stretches[k].left, stretches[k].right);
                let (low, high) = if a.y < b.y { (a, b) } else { (b, a) };
                if low.y >= valley.head - NEAR {
                    break;
                }
                corners.push(if high.y > valley.head {
                    low + (high - low) * ((valley.head - low.y) / (high.y - low.y))
                } else {
                    high
                });
            }
            corners
        };
        let [left, right] = [chain(0), chain(1)];
        let bed = [left[left.len() - 1], right[right.len() - 1]];
        // Whole stones: they overhang what they rest on by no more than their height.
        let layout = Layout { length: f64::INFINITY, height: f64::INFINITY, least: LEAST, ..Layout::default() };
        let mut top = None;
        for stone in stones(&left, &right, &layout).map_err(DiscretiseError::Backing)? {
            top = Some(self.piece(stone.outline, end));
        }
        if self.level - valley.head >= LEAST
            && let Ok(outline) = Polygon::rectangle(bed[0], bed[1].x - bed[0].x, self.level - valley.head)
        {
            let block = self.piece(outline, end);
            let at = |p: Vec2| vec2(p.x, self.level);
            self.upper.push(Stretch { block, left: at(bed[0]), right: at(bed[1]), ground: false });
        } else if let Some(block) = top {
            self.upper.push(Stretch { block, left: bed[0], right: bed[1], ground: false });
        }
        Ok(())
    }

    /// A column on a flat back, and what it leaves bare.
    fn on(&mut self, stretch: &Stretch, end: Option<f64>) {
        let Some((left, right, outline)) = column(stretch, self.level) else {
            self.upper.push(*stretch);
            return;
        };
        let part = |left: f64, right: f64| Stretch { left: stretch.at(left), right: stretch.at(right), ..*stretch };
        if left > stretch.left.x {
            self.upper.push(part(stretch.left.x, left));
        }
        let block = self.piece(outline, end);
        let [a, b] = [left, right].map(|x| vec2(x, self.level));
        self.upper.push(Stretch { block, left: a, right: b, ground: false });
        if right < stretch.right.x {
            self.upper.push(part(right, stretch.right.x));
        }
    }

    /// A piece, and its plumb face where it reaches an end of the backing.
    fn piece(&mut self, outline: Polygon, end: Option<f64>) -> BlockId {
        let face = end.and_then(|x| {
            let [low, high] = extent(outline.vertices().iter().filter(|p| (p.x - x).abs() < NEAR).map(|p| p.y));
            (high - low > NEAR).then_some((x, [low, high], (outline.centroid().x - x).signum()))
        });
        let origin = Origin::Backing { column: self.pieces };
        self.pieces += 1;
        let block = self.build.block(outline, self.group, Held::FREE, origin);
        self.build.blocks[block].density = self.backing.density;
        self.faces.extend(face.map(|(x, levels, inwards)| Face { block, x, levels, inwards }));
        block
    }
}

/// The column between a back and a level above it, with its ends; none where the level leaves less than [`LEAST`] of it.
fn column(stretch: &Stretch, level: f64) -> Option<(f64, f64, Polygon)> {
    let (a, b) = (stretch.left, stretch.right);
    let most = level - LEAST;
    if a.y.min(b.y) >= most {
        return None;
    }
    // Where the back comes within the least thickness of the level.
    let end = a.x + (b.x - a.x) * ((most - a.y) / (b.y - a.y));
    let (left, right) = if a.y > most {
        (end, b.x)
    } else if b.y > most {
        (a.x, end)
    } else {
        (a.x, b.x)
    };
    if right - left < LEAST.min(0.5 * (b.x - a.x)) {
        return None;
    }
    let corners = vec![stretch.at(left), stretch.at(right), vec2(right, level), vec2(left, level)];
    Some((left, right, Polygon::new(corners).ok()?))
}
