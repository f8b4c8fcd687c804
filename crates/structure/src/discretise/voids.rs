//! Voids above the extrados: what lies over their roofs is carried to two places beside them.

use super::DiscretiseError;
use super::cover::{Column, Resultant};
use super::extrados::{Extrados, Stretch};
use bridge::{Bridge, Void};

/// The void over a place, if there is one.
pub(super) fn over(voids: &[Void], x: f64) -> Option<usize> {
    voids.iter().position(|void| void.range[0] < x && x < void.range[1])
}

/// Ends of voids between two places [m].
pub(super) fn ends(voids: &[Void], from: f64, to: f64) -> impl Iterator<Item = f64> {
    voids.iter().flat_map(|void| void.range).filter(move |x| from < *x && *x < to)
}

/// What the two places carry of a force on the roof, as under a beam: the same force and the same moment [N/m].
pub(super) fn carried(void: &Void, on_roof: &Resultant) -> [(f64, f64); 2] {
    let [left, right] = void.carried_to;
    let share = (on_roof.moment - on_roof.force * left) / (right - left);
    [(left, on_roof.force - share), (right, share)]
}

/// The stretch that carries the roof of a void on its left (`side` 0) or right: where two meet, the one away from the void.
pub(super) fn bearing(stretches: &[Stretch], void: &Void, side: usize) -> Option<usize> {
    let x = void.carried_to[side];
    stretches.iter().position(
        |s| {
            if side == 0 { s.left.x < x && x <= s.right.x } else { s.left.x <= x && x < s.right.x }
        },
    )
}

/// Voids must lie between the extrados and the top of the lowest layer, and their roofs on the bridge.
pub(super) fn check(bridge: &Bridge, extrados: &Extrados) -> Result<(), DiscretiseError> {
    let column = Column::of(bridge, extrados);
    for (k, void) in extrados.voids.iter().enumerate() {
        let [from, to] = void.range;
        let roof = void.levels[1];
        for stretch in extrados.stretches.iter().filter(|s| s.right.x > from && s.left.x < to) {
            for x in [stretch.left.x.max(from), stretch.right.x.min(to)] {
                let above = stretch.at(x).y - roof;
                if above > 1e-9 {
                    return Err(DiscretiseError::VoidInRing { void: k + 1, x, above });
                }
            }
        }
        let places = [from, to].into_iter().chain(column.kinks(from, to));
        let top = places.map(|x| column.top(x)).fold(f64::INFINITY, f64::min);
        if !(top >= roof) {
            return Err(DiscretiseError::VoidAboveFill { void: k + 1, top });
        }
        for side in [0, 1] {
            if bearing(&extrados.stretches, void, side).is_none() {
                return Err(DiscretiseError::VoidBesideBridge { void: k + 1, x: void.carried_to[side] });
            }
        }
    }
    Ok(())
}

/// Refuses what cover that is a body does not know: a road that is not level, what is hollow, abutments that move and, some of it, loads along
/// the bridge.
pub(super) fn solid(bridge: &Bridge, what: &'static str, only_vertical: bool) -> Result<(), DiscretiseError> {
    let hollow = if !bridge.cover.voids.is_empty() {
        Some("[[void]]")
    } else {
        bridge.cover.internal_walls.map(|_| "[internal_walls]")
    };
    if bridge.cover.road.is_some() {
        Err(DiscretiseError::RoadNotLevel { what })
    } else if only_vertical && bridge.loads.iter().any(|load| load.horizontal != 0.0) {
        Err(DiscretiseError::Horizontal { what })
    } else if let Some(part) = hollow {
        Err(DiscretiseError::Hollow { part, what })
    } else if bridge.abutments.iter().any(|abutment| abutment.body.is_some()) {
        Err(DiscretiseError::MovableAbutment { what })
    } else {
        Ok(())
    }
}
