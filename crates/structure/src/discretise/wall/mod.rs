//! Spandrel walls: coursed bricks on the line of the extrados, cut so that every piece is convex, rests on the backs
//! below it face to face, and is nowhere thinner than a stated least thickness.
//!
//! Where the extrados is flat enough, bricks are cut by vertical joints at the corners between backs (`courses.rs`);
//! where it is so steep that these would be slivers, stones with level beds run from the backs outwards
//! (`haunch.rs`).

mod courses;
pub(super) mod haunch;
mod line;
pub mod loads;

use super::outline::polygon;
use bridge::{Bridge, CoursesFrom, SpandrelWall};
use mechanics::plane::{Core, Polygon, PolygonError, Vec2};
use thiserror::Error;

/// A face on which the wall stands, from left to right in the order of the bridge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seat {
    /// Left end [m].
    pub left: Vec2,
    /// Right end [m].
    pub right: Vec2,
    /// The span whose uppermost ring it belongs to; none for abutments and piers.
    pub span: Option<usize>,
}

impl Seat {
    /// Level at `x` [m].
    fn at(&self, x: f64) -> f64 {
        let run = self.right.x - self.left.x;
        self.left.y + (self.right.y - self.left.y) * ((x - self.left.x) / run)
    }
    /// Rise per unit of x.
    fn slope(&self) -> f64 {
        (self.right.y - self.left.y) / (self.right.x - self.left.x)
    }
}

/// Where the wall is and how it is coursed, in metres.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Layout {
    /// Left and right end.
    pub ends: [f64; 2],
    /// Level of its top.
    pub top: f64,
    /// Levels of the beds from the top down; the first is the top.
    pub beds: Vec<f64>,
    /// Length of a brick.
    pub length: f64,
    /// Height of a course.
    pub height: f64,
    /// Shift of every other course, as a share of the length.
    pub bond: f64,
    /// Place of a head joint of the uppermost course.
    pub head_joint: f64,
    /// Least thickness of a piece.
    pub least: f64,
}

/// A piece of the wall.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// Outline, counter-clockwise.
    pub outline: Polygon,
    /// The course, from the top; none for a stone of the haunches.
    pub course: Option<usize>,
}

/// Why a wall cannot be cut into bricks.
#[derive(Debug, Clone, PartialEq, Error)]
#[expect(missing_docs, reason = "the messages say what each is")]
pub enum WallError {
    #[error(
        "the spandrel wall is {height:.3} m high at x = {x:.3} m, less than the least piece of {least:.3} m: give a higher \
         `top` or a smaller `least_piece` in [spandrel_wall]"
    )]
    Low {
        /// Where [m].
        x: f64,
        /// Its height there [m].
        height: f64,
        /// Least thickness of a piece [m].
        least: f64,
    },
    #[error(
        "a piece of the spandrel wall at x = {x:.3} m, y = {y:.3} m would be {width:.3} m thick, less than the least piece of \
         {least:.3} m: use fewer voussoirs in the uppermost ring, a wider pier or abutment, or a smaller `least_piece` in \
         [spandrel_wall]"
    )]
    Sliver {
        /// Where [m].
        x: f64,
        /// Level [m].
        y: f64,
        /// Thickness of the piece [m].
        width: f64,
        /// Least thickness of a piece [m].
        least: f64,
    },
    #[error("a piece of the spandrel wall at x = {x:.3} m, y = {y:.3} m has no usable outline: {source}")]
    Outline {
        /// Where [m].
        x: f64,
        /// Level [m].
        y: f64,
        source: PolygonError,
    },
    #[error(
        "about {count:.0} bricks of {length} x {height} m make the spandrel wall, more than the {most} that are analysed: \
             describe larger ones in [spandrel_wall]"
    )]
    TooMany {
        /// About so many.
        count: f64,
        /// Length of a brick [m].
        length: f64,
        /// Height of a course [m].
        height: f64,
        /// As many as can be.
        most: usize,
    },
    #[error("the extrados leans back over x = {x:.3} m, where no wall can stand on it")]
    Overhang {
        /// Where [m].
        x: f64,
    },
    #[error(
        "the loading block at x = {x:.3} m does not stand on the spandrel wall, which runs from {from:.3} m to {to:.3} m"
    )]
    BesideWall {
        /// Middle of the block [m].
        x: f64,
        /// Left end of the wall [m].
        from: f64,
        /// Right end [m].
        to: f64,
    },
}

/// Most bricks of a wall: as many as there may be voussoirs in a bridge file.
const MOST: usize = 100_000;

/// The wall's extent and courses on these seats; `crown` and `surface` are the levels of the extrados at the highest
/// crown and of the road [m].
///
/// # Errors
/// More bricks than can be analysed.
pub fn layout(
    bridge: &Bridge,
    wall: &SpandrelWall,
    seats: &[Seat],
    crown: f64,
    surface: f64,
) -> Result<Layout, WallError> {
    let back = |seat: &Seat| (seat.right - seat.left).norm();
    // Mean length of the backs of the span with the shortest ones: pieces of cut bricks cannot be longer.
    let shortest = (0..bridge.spans.len()).filter_map(|span| {
        let backs: Vec<f64> = seats.iter().filter(|s| s.span == Some(span)).map(back).collect();
        (!backs.is_empty()).then(|| backs.iter().sum::<f64>() / backs.len() as f64)
    });
    let size = shortest.fold(wall.brick_height.min(wall.brick_length), f64::min);
    let least = wall.least_piece * size;
    let top = wall.top.map_or(surface, |above| crown + above);
    let bearing = [seats.first(), seats.last()].map(|s| s.map_or([0.0; 2], |s| [s.left.x, s.right.x]));
    let ends = match wall.extent {
        Some(extent) => [bearing[0][1] - extent, bearing[1][0] + extent],
        None => [bearing[0][0], bearing[1][1]],
    };
    let middle = 0.5 * crate::discretise::bridge_length(bridge);
    let lowest = seats.iter().map(|s| s.left.y.min(s.right.y)).fold(top, f64::min);
    let (length, height) = (wall.brick_length, wall.brick_height);
    let count = ((ends[1] - ends[0]) / length).max(1.0) * ((top - lowest) / height).max(1.0);
    if count.is_nan() || count > MOST as f64 {
        return Err(WallError::TooMany { count, length, height, most: MOST });
    }
    Ok(Layout {
        ends,
        top,
        beds: beds(top, lowest, wall, least),
        length,
        height,
        bond: wall.bond,
        head_joint: wall.head_joint.unwrap_or(middle),
        least,
    })
}

/// Levels of the beds from the top down to the lowest seat [m].
fn beds(top: f64, lowest: f64, wall: &SpandrelWall, least: f64) -> Vec<f64> {
    let height = wall.brick_height;
    let first = match wall.courses_from {
        CoursesFrom::Top => top - height,
        // What is left above the last whole course is a course of its own, or makes the last one higher.
        CoursesFrom::Springings => {
            let whole = (top / height).floor() * height;
            if top - whole < least { whole - height } else { whole }
        }
    };
    let below = ((first - lowest) / height).ceil().max(0.0) as usize;
    let mut levels = vec![top];
    levels.extend((0..=below).map(|k| first - k as f64 * height));
    levels
}

/// Cuts the wall that stands on `seats`; every piece is convex and no thinner than the layout says, and corners rounded
/// by `rounding` [m] leave something of every face.
///
/// # Errors
/// A seat that leans back, a wall that is too low, or a piece that is too thin or has no outline.
pub fn cut(seats: &[Seat], layout: &Layout, rounding: f64) -> Result<Vec<Piece>, WallError> {
    let ground = line::ground(seats, layout)?;
    let mut pieces = ground.stones;
    pieces.extend(courses::cut(&ground.line, layout)?);
    for piece in &pieces {
        sound(&piece.outline, layout.least, rounding)?;
    }
    Ok(pieces)
}

/// Refuses slivers and faces that rounding takes away.
fn sound(outline: &Polygon, least: f64, rounding: f64) -> Result<(), WallError> {
    let centre = outline.centroid();
    let width = thickness(outline);
    // Round-off of coordinates of some tens of metres.
    if width < least * (1.0 - 1e-9) - 1e-9 {
        return Err(WallError::Sliver { x: centre.x, y: centre.y, width, least });
    }
    Core::new(outline, rounding).map_err(|source| WallError::Outline { x: centre.x, y: centre.y, source })?;
    Ok(())
}

/// Least distance of two parallel lines between which the outline fits [m].
pub fn thickness(outline: &Polygon) -> f64 {
    let across = |(a, b): (Vec2, Vec2)| {
        let normal = (b - a).left().unit();
        outline.vertices().iter().map(|&p| (p - a).dot(normal)).fold(0.0, f64::max)
    };
    outline.edges().map(across).fold(f64::INFINITY, f64::min)
}

/// The outline of these corners, as [`polygon`] makes it.
fn outline(mut corners: Vec<Vec2>) -> Result<Polygon, WallError> {
    corners.dedup_by(|a, b| (*a - *b).norm() < 1e-9);
    while corners.len() > 1 && (corners[0] - corners[corners.len() - 1]).norm() < 1e-9 {
        corners.pop();
    }
    let middle = corners.iter().fold(Vec2::ZERO, |sum, &p| sum + p) * (1.0 / corners.len().max(1) as f64);
    polygon(corners).map_err(|source| WallError::Outline { x: middle.x, y: middle.y, source })
}

#[cfg(test)]
mod tests;
