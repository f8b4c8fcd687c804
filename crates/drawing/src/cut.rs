//! A concave outline cut into convex pieces.

use crate::Point;
use crate::outline::straightened;
use geo::Line;
use geo::algorithm::line_intersection::line_intersection;

/// Cuts a simple counter-clockwise outline along diagonals from its reflex corners until every piece is convex. Of the
/// diagonals of a corner the shortest is taken among those that leave no reflex angle there, and the shortest of all
/// where none does. A reflex corner of a simple outline always sees another corner, so that every piece can be cut.
pub(crate) fn convex(points: Vec<Point>) -> Vec<Vec<Point>> {
    let mut open = vec![points];
    let mut done = Vec::new();
    while let Some(piece) = open.pop() {
        let (piece, _) = straightened(piece);
        match diagonal(&piece) {
            Some((i, j)) => {
                let (low, high) = (i.min(j), i.max(j));
                let inner = piece[low..=high].to_vec();
                let outer = piece[high..].iter().chain(&piece[..=low]).copied().collect();
                open.push(outer);
                open.push(inner);
            }
            None => done.push(piece),
        }
    }
    done
}

fn turn(a: Point, b: Point, c: Point) -> f64 {
    (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
}

/// The cut of the first reflex corner; none for a convex outline.
fn diagonal(points: &[Point]) -> Option<(usize, usize)> {
    let n = points.len();
    let at = |i: usize| points[i % n];
    // Round-off of a straight corner is no reason to cut.
    let size = |a: Point, b: Point| (a[0] - b[0]).hypot(a[1] - b[1]);
    let reflex = |a: Point, b: Point, c: Point| turn(a, b, c) < -1e-9 * size(a, b) * size(b, c);
    let i = (0..n).find(|&i| reflex(at(i + n - 1), at(i), at(i + 1)))?;
    let (before, corner, after) = (at(i + n - 1), at(i), at(i + 1));
    let sees = |j: usize| {
        let inside = turn(before, corner, at(j)) > 0.0 || turn(corner, after, at(j)) > 0.0;
        let sight = Line::new(corner, at(j));
        inside
            && (0..n).all(|k| {
                let shares = [k, (k + 1) % n].iter().any(|&e| e == i || e == j);
                shares || line_intersection(sight, Line::new(at(k), at(k + 1))).is_none()
            })
    };
    let others = (0..n).filter(|&j| j != i && j != (i + 1) % n && (j + 1) % n != i);
    let resolves = |j: usize| !reflex(before, corner, at(j)) && !reflex(at(j), corner, after);
    let best = others.filter(|&j| sees(j)).min_by(|&a, &b| {
        let key = |j: usize| (!resolves(j), size(corner, at(j)));
        let ((p, x), (q, y)) = (key(a), key(b));
        p.cmp(&q).then(x.total_cmp(&y))
    })?;
    Some((i, best))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outline::signed_area;

    #[test]
    fn pieces_are_convex_and_fill_the_outline() {
        let shapes: [&[Point]; 3] = [
            &[[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]],
            &[[0.0, 0.0], [2.0, 1.0], [4.0, 0.0], [3.0, 2.0], [4.0, 4.0], [2.0, 3.0], [0.0, 4.0], [1.0, 2.0]],
            &[[0.0, 0.0], [5.0, 0.0], [5.0, 3.0], [4.0, 3.0], [4.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]],
        ];
        for shape in shapes {
            let pieces = convex(shape.to_vec());
            assert!(pieces.len() >= 2);
            let total: f64 = pieces.iter().map(|p| signed_area(p)).sum();
            assert!((total - signed_area(shape)).abs() < 1e-12);
            for piece in &pieces {
                assert_eq!(diagonal(piece), None);
                assert!(signed_area(piece) > 0.0);
            }
        }
    }
}
