//! Where the fill between two extrados, or between an extrados and the line over an abutment's back, is meshed in level
//! rows, and above which level in columns.
//!
//! Columns lean on a steep extrados at a sharp angle, rows on a flat one. Rows reach up to the levels at which materials
//! change, and further where the extrados is steep, as far as gives the best angles.

use super::arch::{Arch, End};
use mechanics::plane::{Vec2, vec2};

/// Rows do not reach where the extrados rises by less than this [rad]: 12 degrees.
const FLATTEST: f64 = 12.0 / 180.0 * std::f64::consts::PI;

/// Rows end before this share of the arc length from the springing: the crown belongs to the columns.
const LAST: f64 = 0.42;

/// Columns alone do where they meet the extrados with at least this sine.
const GOOD: f64 = 0.55;

/// The top of a layer of rows.
pub(super) struct Layer {
    /// Shares of the arc length from the springing: up the right end of the span on the left, and up the left end of the span on the right.
    pub shares: [f64; 2],
    /// The level that it reaches up to [m]; none for the one that follows the steepness of the extrados.
    pub level: Option<f64>,
}

/// One side of a support: the arch that springs there, or the line over an abutment's back at this x.
pub(super) enum Side<'a> {
    Arch(&'a Arch<'a>, End),
    /// An abutment's back [m].
    Back(f64),
}

impl Side<'_> {
    /// Point at a share from the springing; that of a back lies on the level of the other side's.
    fn at(&self, share: f64, level: f64) -> Vec2 {
        match self {
            Side::Arch(arch, end) => arch.extrados(end.share(share)),
            Side::Back(x) => vec2(*x, level),
        }
    }
    fn rising(&self, share: f64) -> Vec2 {
        match self {
            Side::Arch(arch, end) => arch.rising(*end, share),
            Side::Back(_) => vec2(0.0, 1.0),
        }
    }
    fn is_arch(&self) -> bool {
        matches!(self, Side::Arch(..))
    }
    /// The share at which the extrados reaches a level, or where rows end below it.
    fn reach(&self, level: f64) -> f64 {
        match self {
            Side::Back(_) => 0.0,
            Side::Arch(arch, end) => {
                let flat = |rising: Vec2| rising.y < FLATTEST.sin();
                arch.first(*end, LAST, |p, rising| p.y >= level || flat(rising)).unwrap_or(LAST)
            }
        }
    }
}

/// Rows that would meet an extrados with a smaller sine do not follow a level.
const POOR: f64 = 0.25;

/// The layers over a support, from below. `levels` [m] are those at which materials change, from below; `size` [m] is the least
/// height of a layer. `steep` says whether rows reach further where the extrados is steep.
pub(super) fn layers(left: &Side<'_>, right: &Side<'_>, levels: &[f64], steep: bool, size: f64) -> Vec<Layer> {
    let mut found = Vec::new();
    let mut from = [0.0, 0.0];
    let mut foot = left.at(0.0, f64::NEG_INFINITY).y.max(right.at(0.0, f64::NEG_INFINITY).y);
    for &level in levels {
        if level < foot + 0.4 * size {
            continue;
        }
        let next = [left.reach(level), right.reach(level)];
        let climbs = |side: &Side<'_>, k: usize| !side.is_arch() || next[k] > from[k] + 1e-6;
        if climbs(left, 0) && climbs(right, 1) && rows(left, right, from, next) > POOR {
            found.push(Layer { shares: next, level: Some(level) });
            (from, foot) = (next, level);
        }
    }
    let without = lean(left, right, from);
    if steep
        && without < GOOD
        && let Some((best, top)) = highest(left, right, from)
        && best > without + 0.05
    {
        found.push(Layer { shares: top, level: None });
    }
    found
}

/// The least sine at which columns meet the extrados above these shares.
fn lean(left: &Side<'_>, right: &Side<'_>, from: [f64; 2]) -> f64 {
    let of = |side: &Side<'_>, share| if side.is_arch() { side.rising(share).x.abs() } else { 1.0 };
    of(left, from[0]).min(of(right, from[1]))
}

/// The layer above these shares whose rows, and the columns above it, have the best angles: their least sine and its top.
fn highest(left: &Side<'_>, right: &Side<'_>, from: [f64; 2]) -> Option<(f64, [f64; 2])> {
    const TRIED: usize = 20;
    let tries = |side: &Side<'_>, k: usize| -> Vec<f64> {
        match side {
            Side::Back(_) => vec![0.0],
            Side::Arch(..) => (1..=TRIED).map(|i| from[k] + (LAST - from[k]) * i as f64 / TRIED as f64).collect(),
        }
    };
    let mut best: Option<(f64, [f64; 2])> = None;
    for l in tries(left, 0) {
        for r in tries(right, 1) {
            // Among equals the lower one.
            let angles = lean(left, right, [l, r]).min(rows(left, right, from, [l, r]));
            let value = angles - 0.02 * (l + r);
            if best.is_none_or(|(known, _)| value > known) {
                best = Some((value, [l, r]));
            }
        }
    }
    best
}

/// The least sine of the angles in a layer of rows.
fn rows(left: &Side<'_>, right: &Side<'_>, from: [f64; 2], to: [f64; 2]) -> f64 {
    const ROWS: usize = 6;
    let mut least = 1.0f64;
    for k in 0..=ROWS {
        let t = k as f64 / ROWS as f64;
        let (l, r) = (from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t);
        let level = if left.is_arch() { left.at(l, 0.0).y } else { right.at(r, 0.0).y };
        let row = (right.at(r, level) - left.at(l, level)).unit();
        // Rows rise together; the lowest follows the support, not the extrados.
        least = least.min(row.cross(left.rising(l))).min(row.cross(right.rising(r)));
        if k == ROWS {
            least = least.min(row.x);
        }
    }
    least
}
