//! Stones on steep haunches: level beds run from the corners between backs to a plumb face, or to the haunch on the
//! other side of a pier.

use super::{Layout, Piece, WallError, outline};
use mechanics::plane::Vec2;

/// A bed: its left and right end.
type Bed = [Vec2; 2];

/// Stones between two sides of a stack: backs of voussoirs from the springing up, or a plumb face from its foot to its head. Beds start at all
/// corners between.
pub(crate) fn stones(left: &[Vec2], right: &[Vec2], layout: &Layout) -> Result<Vec<Piece>, WallError> {
    let mut beds = vec![[left[0], right[0]]];
    let [mut a, mut b] = [left, right].map(|side| side[1..side.len() - 1].iter().peekable());
    loop {
        let bed = match (a.peek(), b.peek()) {
            (None, None) => break,
            // Corners at nearly one level share a bed, so that no stone becomes a sliver.
            (Some(p), Some(q)) if (p.y - q.y).abs() < layout.least => [**p, **q],
            (Some(p), Some(q)) if p.y < q.y => [**p, at(right, p.y)],
            (Some(_), Some(q)) => [at(left, q.y), **q],
            (Some(p), None) => [**p, at(right, p.y)],
            (None, Some(q)) => [at(left, q.y), **q],
        };
        a.next_if(|p| **p == bed[0]);
        b.next_if(|q| **q == bed[1]);
        beds.push(bed);
    }
    beds.push([left[left.len() - 1], right[right.len() - 1]]);
    let beds = thinned(beds, layout);
    let mut pieces = Vec::new();
    for (row, pair) in beds.windows(2).enumerate() {
        bricks(pair[0], pair[1], row, layout, &mut pieces)?;
    }
    Ok(pieces)
}

/// The point of a side at a level [m].
fn at(side: &[Vec2], y: f64) -> Vec2 {
    let k = side.partition_point(|p| p.y < y).clamp(1, side.len() - 1);
    let (a, b) = (side[k - 1], side[k]);
    let t = if b.y > a.y { ((y - a.y) / (b.y - a.y)).clamp(0.0, 1.0) } else { 1.0 };
    a + (b - a) * t
}

/// More beds where voussoirs are much higher than courses.
fn thinned(beds: Vec<Bed>, layout: &Layout) -> Vec<Bed> {
    let mut all = vec![beds[0]];
    for pair in beds.windows(2) {
        let rise = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
        let rows = (rise[0].y.max(rise[1].y) / (1.5 * layout.height)).ceil().max(1.0);
        for k in 1..=rows as usize {
            let share = k as f64 / rows;
            all.push([pair[0][0] + rise[0] * share, pair[0][1] + rise[1] * share]);
        }
    }
    all
}

/// One row, cut by plumb head joints where it is much longer than a brick.
fn bricks(low: Bed, high: Bed, row: usize, layout: &Layout, pieces: &mut Vec<Piece>) -> Result<(), WallError> {
    let inside = [low[0].x.max(high[0].x) + layout.least, low[1].x.min(high[1].x) - layout.least];
    let (start, length) = (low[0].x.min(high[0].x), low[1].x.max(high[1].x) - low[0].x.min(high[0].x));
    let count = (length / layout.length).round().max(1.0);
    let shift = if row % 2 == 1 { layout.bond } else { 0.0 };
    let at = |bed: Bed, x: f64| bed[0] + (bed[1] - bed[0]) * ((x - bed[0].x) / (bed[1].x - bed[0].x));
    let mut from = [low[0], high[0]];
    for k in 0..=count as usize {
        let x = start + (k as f64 + shift) * length / count;
        if length > 1.5 * layout.length && x > inside[0] && x < inside[1] {
            let to = [at(low, x), at(high, x)];
            pieces.push(Piece { outline: outline(vec![from[0], to[0], to[1], from[1]])?, course: None });
            from = to;
        }
    }
    pieces.push(Piece { outline: outline(vec![from[0], low[1], high[1], from[1]])?, course: None });
    Ok(())
}
