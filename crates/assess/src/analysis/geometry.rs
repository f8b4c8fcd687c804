//! Joints of a discretised bridge: where they stand in it, how their sides move, which are hinges.

use mechanics::blocks::{Interface, interfaces};
use mechanics::ids::{BlockId, Id};
use mechanics::plane::{Vec2, vec2};
use outcome::picture::{ContactForce, Hinge, HingeAt, Motion, Picture, Point, ThrustPoint};
use structure::discretise::{Discretised, Origin};

/// A vector as results show it.
pub(super) fn point(v: Vec2) -> Point {
    [v.x, v.y]
}

/// Span, ring and number (0 at the left springing) of the joint between two blocks of a ring or a ring and its
/// support.
pub(super) fn joint_in_ring(d: &Discretised, a: BlockId, b: BlockId) -> Option<(usize, usize, usize)> {
    let voussoir = |o: Origin| match o {
        Origin::Voussoir { span, ring, voussoir } => Some((span, ring, voussoir)),
        _ => None,
    };
    // A brick on a voussoir's back meets no joint of the ring.
    if [a, b].iter().any(|&block| !d.origins[block].is_arch()) {
        return None;
    }
    match (voussoir(d.origins[a]), voussoir(d.origins[b])) {
        (Some((s, r, i)), Some((t, q, j))) => (s == t && r == q && i.abs_diff(j) == 1).then(|| (s, r, i.max(j))),
        (Some((s, r, i)), None) => Some((s, r, springing(d, a, b, i))),
        (None, Some((s, r, j))) => Some((s, r, springing(d, b, a, j))),
        (None, None) => None,
    }
}

/// Number of the springing joint of voussoir `i`: 0 on the left, one more than the last voussoir on the right.
fn springing(d: &Discretised, voussoir: BlockId, support: BlockId, i: usize) -> usize {
    let middle = |b: BlockId| d.model.blocks[b].outline.centroid().x;
    if middle(support) < middle(voussoir) { i } else { i + 1 }
}

/// Pier, as its support is counted, and number (0 on the foundation) of the joint between two of its courses or the lowest and the
/// foundation.
pub(super) fn joint_in_pier(d: &Discretised, a: BlockId, b: BlockId) -> Option<(usize, usize)> {
    match (d.origins[a], d.origins[b]) {
        (Origin::Pier { support: s, course: i }, Origin::Pier { support: t, course: j }) => {
            (s == t && i.abs_diff(j) == 1).then(|| (s, i.max(j)))
        }
        (Origin::Pier { support: s, course }, Origin::Foundation { support: t })
        | (Origin::Foundation { support: t }, Origin::Pier { support: s, course }) => {
            (s == t && course == 0).then_some((s, 0))
        }
        _ => None,
    }
}

/// Whether two blocks are voussoirs of different rings of one span. Rings part and slide there; a joint that opens along
/// the ring is no hinge of the mechanism.
pub(super) fn between_rings(d: &Discretised, a: BlockId, b: BlockId) -> bool {
    matches!(
        (d.origins[a], d.origins[b]),
        (Origin::Voussoir { span: s, ring: r, .. }, Origin::Voussoir { span: t, ring: q, .. }) if s == t && r != q
    )
}

/// At which edge of its ring a hinge of the joint between two blocks lies.
pub(super) fn edge_at(d: &Discretised, a: BlockId, b: BlockId, at: Vec2) -> HingeAt {
    if joint_in_ring(d, a, b).is_none() {
        return HingeAt::Other;
    }
    let Some(faces) = d.faces[a].or(d.faces[b]) else { return HingeAt::Other };
    let distance = |[p, q]: [Vec2; 2]| ((at - p).cross((q - p).unit())).abs();
    if distance(faces.bed) <= distance(faces.back) { HingeAt::Intrados } else { HingeAt::Extrados }
}

/// A joint turns when its relative rotation is at least this share of the largest one: elastic joints beside a hinge share some of its
/// rotation.
const TURNING: f64 = 0.2;
/// A joint of a ring that turns more than all joints near it is a hinge from this share on: over a long flat arm one hinge turns a tenth
/// as fast as another.
const TURNING_MOST: f64 = 0.05;
/// So many joints on either side are near.
const NEAR: usize = 4;
/// A joint slides when its relative displacement along the tangent is at least this share of the largest displacement
/// of any block.
const SLIDING: f64 = 0.05;

/// Of every joint whether it turns as a hinge does.
fn turning(d: &Discretised, joints: &[Interface], turns: &[f64]) -> Vec<bool> {
    let largest = turns.iter().copied().map(f64::abs).fold(0.0, f64::max);
    let places: Vec<_> = joints.iter().map(|j| joint_in_ring(d, j.first, j.second)).collect();
    let most_near = |at: usize| {
        let Some((span, ring, joint)) = places[at] else { return false };
        places.iter().zip(turns).all(|(place, turn)| {
            place.is_none_or(|(s, r, j)| {
                (s, r) != (span, ring) || joint.abs_diff(j) > NEAR || turn.abs() <= turns[at].abs()
            })
        })
    };
    let turn = |(at, turn): (usize, &f64)| {
        largest > 0.0 && (turn.abs() >= TURNING * largest || turn.abs() >= TURNING_MOST * largest && most_near(at))
    };
    turns.iter().enumerate().map(turn).collect()
}

/// Puts the hinges of a picture's mechanism, sorted as the joints, and the middles of the joints that slide beside it. Its motions are scaled to a
/// largest translation of 1 m.
pub(super) fn moving(d: &Discretised, joints: &[Interface], picture: &mut Picture) {
    let Some(motions) = &picture.mechanism else { return };
    let motion = |b: BlockId| motions[b.index()];
    let turns: Vec<f64> = joints.iter().map(|j| motion(j.second).rotation - motion(j.first).rotation).collect();
    let hinged = turning(d, joints, &turns);
    for ((j, &rotation), hinged) in joints.iter().zip(&turns).zip(hinged) {
        // A second side that turns counter-clockwise closes the far end along the tangent.
        let closed = if rotation > 0.0 { j.points.len() - 1 } else { 0 };
        let at = j.points[closed];
        let velocity = |b: BlockId| {
            let m = motion(b);
            vec2(m.translation[0], m.translation[1]) + (at - d.model.blocks[b].outline.centroid()).left() * m.rotation
        };
        let apart = velocity(j.second) - velocity(j.first);
        let opened = apart.dot(j.normal) > SLIDING;
        if hinged && !opened && j.points.len() == 2 && !between_rings(d, j.first, j.second) {
            let between = [j.first, j.second].map(BlockId::index);
            let edge = edge_at(d, j.first, j.second, at);
            picture.hinges.push(Hinge { point: point(at), edge, between, rotation });
        }
        if apart.dot(j.normal.left()).abs() >= SLIDING && !opened {
            let middle = j.points.iter().fold(Vec2::ZERO, |sum, &p| sum + p) * (1.0 / j.points.len() as f64);
            picture.sliding.push(point(middle));
        }
    }
}

/// Blocks as built share a joint where their gap is at most this [m]: round-off of the outlines.
const TOUCHING: f64 = 1e-6;

/// The same of the joints of the blocks as built.
pub(super) fn moving_as_built(d: &Discretised, picture: &mut Picture) {
    if picture.mechanism.is_some()
        && let Ok(joints) = interfaces(&d.model, TOUCHING)
    {
        moving(d, &joints, picture);
    }
}

/// Motions scaled so that the largest translation is 1 m; nothing where nothing moves.
pub(super) fn scaled(motions: Vec<Motion>) -> Option<Vec<Motion>> {
    let size = |m: &Motion| m.translation[0].hypot(m.translation[1]);
    let largest = motions.iter().map(size).fold(0.0, f64::max);
    (largest > 1e-12).then(|| {
        motions
            .into_iter()
            .map(|m| Motion { translation: m.translation.map(|t| t / largest), rotation: m.rotation / largest })
            .collect()
    })
}

/// Sorts points of joints into one polyline per span and ring, from left to right, and after them one per pier, from its foundation
/// up.
pub(super) fn lines<T: Copy>(d: &Discretised, points: impl Iterator<Item = (BlockId, BlockId, T)>) -> Vec<Vec<T>> {
    let place = |a, b| {
        let in_ring = joint_in_ring(d, a, b).map(|(span, ring, joint)| ((false, span, ring), joint));
        in_ring.or_else(|| joint_in_pier(d, a, b).map(|(support, joint)| ((true, support, 0), joint)))
    };
    let mut placed: Vec<_> = points.filter_map(|(a, b, value)| place(a, b).map(|place| (place, value))).collect();
    placed.sort_by_key(|(place, _)| *place);
    let line = |rest: &[(_, T)]| rest.iter().map(|(_, value)| *value).collect();
    placed.chunk_by(|a, b| a.0.0 == b.0.0).map(line).collect()
}

/// Lines of thrust through the resultants of contacts, which are sorted by blocks, in the order of their joints.
pub(super) fn thrust_lines(d: &Discretised, contacts: &[ContactForce]) -> Vec<Vec<ThrustPoint>> {
    let points = contacts.chunk_by(|a, b| a.blocks == b.blocks).filter_map(|joint| {
        let total: f64 = joint.iter().map(|c| c.compression).sum();
        if total <= 0.0 {
            return None;
        }
        let (mut at, mut force) = (Vec2::ZERO, Vec2::ZERO);
        for c in joint {
            let normal = vec2(c.normal[0], c.normal[1]);
            at += vec2(c.point[0], c.point[1]) * (c.compression / total);
            force += normal * c.compression + normal.left() * c.shear;
        }
        let [first, second] = joint[0].blocks.map(BlockId::new);
        Some((first, second, ThrustPoint { point: point(at), thrust: force.norm() }))
    });
    lines(d, points)
}

#[cfg(test)]
mod tests {
    use super::*;
    use structure::discretise::discretise;

    /// Elastic joints share the turning of a slow hinge, so that the fastest hinge turns ten times as much as any of them: the one that turns
    /// most of those near it is the hinge, and there are four.
    #[test]
    fn a_slow_hinge_that_joints_beside_it_share_is_marked_where_it_turns_most() {
        let d = discretise(&crate::samples::bridgemill()).expect("blocks");
        let joints = interfaces(&d.model, TOUCHING).expect("joints");
        let spread = [
            (0, -0.03),
            (1, -0.05),
            (2, -0.04),
            (17, 0.35),
            (18, -0.03),
            (35, -0.05),
            (36, -0.39),
            (60, 0.03),
            (62, 0.08),
        ];
        let turns: Vec<f64> = joints
            .iter()
            .map(|j| {
                let place = joint_in_ring(&d, j.first, j.second).map(|(_, _, joint)| joint);
                spread.iter().find(|(joint, _)| Some(*joint) == place).map_or(0.0, |(_, turn)| *turn)
            })
            .collect();
        let hinged = turning(&d, &joints, &turns);
        let of = joints.iter().zip(hinged).filter(|(_, hinged)| *hinged);
        let mut places: Vec<usize> = of.filter_map(|(j, _)| Some(joint_in_ring(&d, j.first, j.second)?.2)).collect();
        places.sort_unstable();
        assert_eq!(places, [1, 17, 36, 62]);
        assert!(turning(&d, &joints, &vec![0.0; joints.len()]).iter().all(|hinged| !hinged));
    }
}
