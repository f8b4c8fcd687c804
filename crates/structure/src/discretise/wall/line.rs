//! The line on which the coursed part of a wall stands: seats from end to end, with stones in place of steep haunches.

use super::haunch::stones;
use super::{Layout, Piece, Seat, WallError};
use mechanics::plane::{Vec2, vec2};

/// What the courses stand on.
pub(super) struct Ground {
    /// Faces that follow one another in x; levels may jump between them.
    pub line: Vec<Seat>,
    /// Stones of the haunches below the line.
    pub stones: Vec<Piece>,
}

/// Shortest flat part that is drawn [m]: where two rings meet above a pier there is none.
const NOTHING: f64 = 1e-9;

/// The line between the ends of the wall, and the stones on steep haunches.
pub(super) fn ground(seats: &[Seat], layout: &Layout) -> Result<Ground, WallError> {
    let mut ground = Ground { line: Vec::new(), stones: Vec::new() };
    let mut groups = seats.chunk_by(|a, b| a.span == b.span).peekable();
    // Steep backs of the right springing that the last span left for the valley behind it.
    let mut before: Vec<Vec2> = Vec::new();
    let mut flat: Option<Seat> = None;
    while let Some(group) = groups.next() {
        if group[0].span.is_none() {
            let (first, last) = (group[0].left, group[group.len() - 1].right);
            let inside = |p: Vec2| vec2(p.x.clamp(layout.ends[0], layout.ends[1]), p.y);
            let here = between(inside(first), inside(last));
            flat = Some(here);
            if groups.peek().is_none() {
                valley(here, [&before, &[]], layout, &mut ground)?;
            }
            continue;
        }
        let steep = |s: &Seat| s.right.x - s.left.x < layout.least;
        let half = group.len() / 2;
        let rising = group[..half].iter().rposition(steep).map_or(0, |k| k + 1);
        let falling = group[half..].iter().position(steep).map_or(group.len(), |k| half + k);
        let up = corners(group[..rising].iter().map(|s| (s.left, s.right)));
        valley(flat.take().unwrap_or(between(group[0].left, group[0].left)), [&before, &up], layout, &mut ground)?;
        for seat in &group[rising..falling] {
            if seat.right.x - seat.left.x < NOTHING {
                return Err(WallError::Overhang { x: seat.left.x });
            }
            ground.line.push(*seat);
        }
        before = corners(group[falling..].iter().rev().map(|s| (s.right, s.left)));
    }
    Ok(ground)
}

fn between(left: Vec2, right: Vec2) -> Seat {
    Seat { left, right, span: None }
}

/// Corners of steep backs from the springing up.
fn corners(backs: impl Iterator<Item = (Vec2, Vec2)>) -> Vec<Vec2> {
    let mut chain = Vec::new();
    for (low, high) in backs {
        if chain.is_empty() {
            chain.push(low);
        }
        chain.push(high);
    }
    chain
}

/// Between two spans, or between a span and the end of the wall: a flat part and the steep backs on both sides of it, each from the springing
/// up. Fills its foot with stones where its sides are steep, and draws the line above.
fn valley(flat: Seat, [left, right]: [&[Vec2]; 2], layout: &Layout, ground: &mut Ground) -> Result<(), WallError> {
    let room = flat.right.x - flat.left.x;
    let whole = layout.length;
    let on = |x: f64| if room > NOTHING { vec2(x, flat.at(x)) } else { flat.left };
    // A plumb face from the flat part up to the head of a chain, at most a brick away from its foot.
    let plumb = |x: f64, head: &[Vec2]| [on(x), vec2(on(x).x, head[head.len() - 1].y)];
    let mut level = |from: Vec2, to: Vec2| {
        if to.x - from.x > NOTHING {
            ground.line.push(between(from, to));
        }
    };
    match (left.last().copied(), right.last().copied()) {
        (None, None) => level(flat.left, flat.right),
        (None, Some(head)) => {
            let x = if room >= whole + layout.least { flat.right.x - whole } else { flat.left.x };
            level(flat.left, on(x));
            level(vec2(x, head.y), head);
            ground.stones.extend(stones(&plumb(x, right), right, layout)?);
        }
        (Some(head), None) => {
            let x = if room >= whole + layout.least { flat.left.x + whole } else { flat.right.x };
            level(head, vec2(x, head.y));
            level(on(x), flat.right);
            ground.stones.extend(stones(left, &plumb(x, left), layout)?);
        }
        (Some(a), Some(b)) if room >= 2.0 * whole + layout.least => {
            let x = [flat.left.x + whole, flat.right.x - whole];
            level(a, vec2(x[0], a.y));
            level(on(x[0]), on(x[1]));
            level(vec2(x[1], b.y), b);
            ground.stones.extend(stones(left, &plumb(x[0], left), layout)?);
            ground.stones.extend(stones(&plumb(x[1], right), right, layout)?);
        }
        (Some(a), Some(b)) => {
            level(a, b);
            ground.stones.extend(stones(left, right, layout)?);
        }
    }
    Ok(())
}
