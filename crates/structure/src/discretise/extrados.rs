//! The line on which cover and loads lie: backs of the top rings, tops of piers and abutments, from left to right.

use bridge::Void;
use mechanics::ids::BlockId;
use mechanics::plane::{Vec2, vec2};

/// A stretch of the extrados that belongs to one block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// The block.
    pub block: BlockId,
    /// Left end [m].
    pub left: Vec2,
    /// Right end [m].
    pub right: Vec2,
    /// Whether the block is a support: what reaches it goes to the ground.
    pub ground: bool,
}

impl Stretch {
    /// The point above or below `x` [m].
    pub fn at(&self, x: f64) -> Vec2 {
        let run = self.right.x - self.left.x;
        let t = if run > 0.0 { (x - self.left.x) / run } else { 0.5 };
        vec2(x, self.left.y + (self.right.y - self.left.y) * t)
    }
}

/// A plumb face at an end of solid backing, with fill behind it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Face {
    /// The block.
    pub block: BlockId,
    /// Where it is [m].
    pub x: f64,
    /// Levels of its lower and upper end [m].
    pub levels: [f64; 2],
    /// Direction of x that points into the block: -1 or +1.
    pub inwards: f64,
}

/// All stretches, from left to right.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Extrados {
    /// Flat backs in order of x: what carries cover and loads.
    pub stretches: Vec<Stretch>,
    /// The curve of which the backs are chords, in points close together: what loads disperse to. It does not depend on
    /// the number of voussoirs.
    pub line: Vec<Vec2>,
    /// Plumb faces at the ends of backing that is blocks.
    pub faces: Vec<Face>,
    /// Voids above it, from left to right.
    pub voids: Vec<Void>,
    /// How much lower the crown lies than it was built, where stones have lost their backs [m]: layers keep their levels.
    pub lost: f64,
}

impl Extrados {
    /// Highest point of the curve as it was built [m].
    pub fn crown(&self) -> f64 {
        self.line.iter().map(|p| p.y).fold(f64::NEG_INFINITY, f64::max) + self.lost
    }
    /// Level of the curve at `x` [m]; beyond the ends that of the nearest end.
    pub fn level(&self, x: f64) -> f64 {
        let k = self.line.partition_point(|p| p.x < x);
        match (k.checked_sub(1).and_then(|k| self.line.get(k)), self.line.get(k)) {
            (Some(a), Some(b)) if b.x > a.x => a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x),
            (_, Some(p)) | (Some(p), None) => p.y,
            (None, None) => 0.0,
        }
    }
    /// Where the curve first falls by more than `fall` per unit of x, seen from `from` outwards in `direction` (-1 or +1) [m].
    pub fn steeper(&self, from: f64, direction: f64, fall: f64) -> Option<f64> {
        let ahead = |p: &Vec2| (p.x - from) * direction;
        let falls = |pair: &[Vec2]| {
            let (near, far) = if ahead(&pair[0]) < ahead(&pair[1]) { (pair[0], pair[1]) } else { (pair[1], pair[0]) };
            let steep = near.y - far.y > fall * (far.x - near.x).abs();
            (steep && ahead(&far) > 0.0).then_some(ahead(&near).max(0.0))
        };
        // The points are in order of x: the first one found on the way outwards is the nearest.
        let first = if direction > 0.0 {
            let next = self.line.partition_point(|p| p.x <= from);
            self.line[next.saturating_sub(1)..].windows(2).find_map(falls)
        } else {
            let next = self.line.partition_point(|p| p.x < from);
            self.line[..self.line.len().min(next + 1)].windows(2).rev().find_map(falls)
        }?;
        Some(from + direction * first)
    }
    /// Where a ray from `from`, falling by `fall` per unit of x outwards in `direction` (-1 or +1), first meets the
    /// curve.
    pub fn meet(&self, from: Vec2, direction: f64, fall: f64) -> Vec2 {
        let clearance = |p: Vec2| from.y - fall * (p.x - from.x) * direction - p.y;
        let mut before = vec2(from.x, self.level(from.x));
        let start = self.line.partition_point(|p| p.x < from.x);
        let mut left = self.line[..start].iter().rev();
        let mut right = self.line[start..].iter();
        let outwards: &mut dyn Iterator<Item = &Vec2> = if direction < 0.0 { &mut left } else { &mut right };
        for &point in outwards {
            let (clear, below) = (clearance(before), clearance(point));
            if below <= 0.0 {
                let t = if clear > below { clear / (clear - below) } else { 0.0 };
                return before + (point - before) * t.max(0.0);
            }
            before = point;
        }
        // Beyond the last abutment the ground goes on level.
        vec2(before.x + direction * clearance(before).max(0.0) / fall, before.y)
    }
}
