//! Where squares fit into the fill without touching one another, the rings, the end walls or the road.

use mechanics::plane::{Vec2, vec2};
use structure::discretise::fill::FillRegion;

/// Lower left corners [m] of squares of side `size` that lie at least `margin` inside the region: particles beside smooth
/// walls stand in rows and are no sample of the fill. From both ends towards the middle, and upwards.
pub(super) fn squares(region: &FillRegion, size: f64, margin: f64) -> Vec<Vec2> {
    let (left, right) = bounds(region.outline.iter().map(|p| p.x));
    let top = region.layers.last().map_or(f64::NEG_INFINITY, |layer| layer.top) - margin;
    let middle = 0.5 * (left + right);
    let pace = size / 20.0;
    let mut corners = Vec::new();
    // The left half from the left, the right half from the right; a square on the middle line is the left half's.
    let (mut x, mut reached) = (left + margin, left);
    while x + size <= right - margin && x + 0.5 * size <= middle {
        let column = column(region, x, size, margin, top);
        let filled = !column.is_empty();
        corners.extend(column);
        reached = if filled { x + size } else { reached };
        x += if filled { size } else { pace };
    }
    let mut x = right - margin - size;
    while x >= reached.max(left + margin) && x + 0.5 * size > middle {
        let column = column(region, x, size, margin, top);
        let filled = !column.is_empty();
        corners.extend(column);
        x -= if filled { size } else { pace };
    }
    corners
}

/// Squares above one another from `x` to `x + size`.
fn column(region: &FillRegion, x: f64, size: f64, margin: f64, top: f64) -> Vec<Vec2> {
    let floor = floor(region, x - margin, x + size + margin) + margin;
    let count = ((top - floor) / size).floor().max(0.0);
    // From the top down: the loose end lies on the extrados.
    (0..count as usize).map(|k| vec2(x, top - (k + 1) as f64 * size)).collect()
}

/// Highest point of the rings' backs between `from` and `to` [m].
fn floor(region: &FillRegion, from: f64, to: f64) -> f64 {
    // The last two corners are those of the road.
    let backs = &region.outline[..region.outline.len().saturating_sub(2)];
    let mut highest = f64::NEG_INFINITY;
    for pair in backs.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        if b.x < from || a.x > to {
            continue;
        }
        let at = |x: f64| {
            let x = x.clamp(a.x, b.x);
            if b.x > a.x { a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x) } else { a.y.max(b.y) }
        };
        highest = highest.max(at(from)).max(at(to));
    }
    highest
}

fn bounds(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use mechanics::ids::GroupId;
    use structure::discretise::fill::FillLayer;

    fn region(outline: &[(f64, f64)], top: f64) -> FillRegion {
        let layer = FillLayer { group: GroupId(0), top, density: 1890.0, friction_angle: None, cohesion: None };
        FillRegion {
            outline: outline.iter().map(|&(x, y)| vec2(x, y)).collect(),
            area: 1.0,
            layers: vec![layer],
            slabs: false,
        }
    }

    #[test]
    fn a_rectangle_takes_what_it_has_room_for() {
        let region = region(&[(0.0, 0.0), (10.0, 0.0), (10.0, 3.5), (0.0, 3.5)], 3.5);
        let found = squares(&region, 1.0, 0.2);
        assert_eq!(found.len(), 9 * 3, "{found:?}");
        assert!(apart(&found, 1.0));
        assert!(found.iter().all(|c| c.x >= 0.2 - 1e-12 && c.x <= 8.8 + 1e-12 && c.y >= 0.2 && c.y <= 2.3 + 1e-12));
        assert!(squares(&region, 3.2, 0.2).is_empty());
    }

    #[test]
    fn squares_keep_off_a_hump() {
        let back: Vec<(f64, f64)> =
            (0..=40).map(|k| (k as f64 * 0.5, 3.0 - 0.03 * (k as f64 * 0.5 - 10.0).powi(2))).collect();
        let outline: Vec<(f64, f64)> = back.iter().copied().chain([(20.0, 4.0), (0.0, 4.0)]).collect();
        let region = region(&outline, 4.0);
        let found = squares(&region, 1.0, 0.1);
        assert!(found.len() >= 8 && found.len().is_multiple_of(2), "{found:?}");
        assert!(apart(&found, 1.0));
        for corner in &found {
            let under = back.iter().filter(|p| p.0 >= corner.x - 0.1 && p.0 <= corner.x + 1.1).map(|p| p.1);
            assert!(under.fold(0.0, f64::max) <= corner.y - 0.1 + 1e-9, "{corner:?}");
        }
    }

    fn apart(corners: &[Vec2], size: f64) -> bool {
        let touch = |a: &Vec2, b: &Vec2| (a.x - b.x).abs() < size - 1e-9 && (a.y - b.y).abs() < size - 1e-9;
        (0..corners.len()).all(|i| (0..i).all(|j| !touch(&corners[i], &corners[j])))
    }
}
