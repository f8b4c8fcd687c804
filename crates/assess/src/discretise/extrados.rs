//! The line on which cover and loads lie: backs of the top rings, tops of piers and abutments, from left to right.

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

/// All stretches, from left to right.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Extrados {
    /// Stretches in order of x.
    pub stretches: Vec<Stretch>,
}

impl Extrados {
    /// Highest point [m].
    pub fn crown(&self) -> f64 {
        self.stretches.iter().flat_map(|s| [s.left.y, s.right.y]).fold(f64::NEG_INFINITY, f64::max)
    }
    /// Level at `x` [m]; beyond the ends that of the nearest end.
    pub fn level(&self, x: f64) -> f64 {
        let (Some(first), Some(last)) = (self.stretches.first(), self.stretches.last()) else { return 0.0 };
        if x <= first.left.x {
            return first.left.y;
        }
        if x >= last.right.x {
            return last.right.y;
        }
        self.over(x).map_or(last.right.y, |s| s.at(x).y)
    }
    /// The stretch at `x` [m].
    pub fn over(&self, x: f64) -> Option<&Stretch> {
        self.stretches.iter().find(|s| s.left.x <= x && x <= s.right.x && s.right.x > s.left.x)
    }
    /// Where a ray from `from`, falling by `fall` per unit of x outwards in `direction` (-1 or +1), first meets the
    /// extrados.
    pub fn meet(&self, from: Vec2, direction: f64, fall: f64) -> Vec2 {
        let ray = |x: f64| from.y - fall * (x - from.x) * direction;
        let mut corners: Vec<Vec2> = self.stretches.iter().flat_map(|s| [s.left, s.right]).collect();
        corners.retain(|p| (p.x - from.x) * direction > 0.0);
        if direction < 0.0 {
            corners.reverse();
        }
        let mut before = vec2(from.x, self.level(from.x));
        for corner in corners {
            let (clear, below) = (ray(before.x) - before.y, ray(corner.x) - corner.y);
            if below <= 0.0 {
                let t = if clear - below > 0.0 { clear / (clear - below) } else { 0.0 };
                return before + (corner - before) * t.max(0.0);
            }
            before = corner;
        }
        // Beyond the last abutment the ground goes on level.
        vec2(before.x + direction * (ray(before.x) - before.y).max(0.0) / fall, before.y)
    }
}
