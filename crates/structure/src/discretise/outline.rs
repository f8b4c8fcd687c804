//! Outlines of blocks from their corners.

use mechanics::plane::{Polygon, PolygonError, Vec2};

/// The outline without corners that coincide or lie on a straight edge: a face must be one edge for the blocks that
/// rest on it.
pub(super) fn polygon(mut corners: Vec<Vec2>) -> Result<Polygon, PolygonError> {
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
