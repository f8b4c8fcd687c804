//! Where two convex polygons with rounded corners meet.
//!
//! A rounded polygon is its core dilated by a disc, so two of them touch when their cores come closer than the sum
//! of the two radii: the gap is known without an overlap test, and the contact normal stays smooth.

use super::polygon::Core;
use super::pose::Pose;
use super::vector::Vec2;
use serde::{Deserialize, Serialize};

/// Which features of two bodies face each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Meeting {
    /// An edge of one body (the reference) against an edge of the other (the incident); two contact points, at the
    /// ends of their common stretch.
    Face {
        /// Whether the reference edge belongs to the second body.
        flipped: bool,
        /// Edge of the reference body.
        reference: u32,
        /// Edge of the incident body.
        incident: u32,
    },
    /// A corner of the first body against a corner of the second; one contact point.
    Corner {
        /// Corner of the first body.
        first: u32,
        /// Corner of the second body.
        second: u32,
    },
}

/// Contact points of one meeting, in the plane as it is now.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Manifold {
    /// Unit normal from the first to the second body.
    pub normal: Vec2,
    /// Contact points [m], midway between the two surfaces; ordered along `normal.left()`.
    pub points: [Vec2; 2],
    /// Gap at each point [m]; negative when the bodies overlap.
    pub gaps: [f64; 2],
    /// How many of the two points count.
    pub count: usize,
}

/// One edge, placed.
#[derive(Clone, Copy)]
struct Edge {
    start: Vec2,
    direction: Vec2,
    length: f64,
}

fn edge(core: &Core, pose: &Pose, i: usize) -> Edge {
    Edge {
        start: pose.place(core.vertices[i]),
        direction: pose.rotation.turn(core.directions[i]),
        length: core.lengths[i],
    }
}

/// Largest distance by which an edge line of `a` separates the two cores, and that edge [m].
fn separation(a: &Core, pose_a: &Pose, b: &Core, pose_b: &Pose) -> (f64, usize) {
    let mut best = (f64::NEG_INFINITY, 0);
    for i in 0..a.len() {
        let e = edge(a, pose_a, i);
        let normal = e.direction.right();
        let normal_in_b = pose_b.rotation.turn_back(normal);
        let offset = (pose_b.position - e.start).dot(normal);
        let nearest = b.vertices.iter().map(|v| v.dot(normal_in_b)).fold(f64::INFINITY, f64::min);
        if offset + nearest > best.0 {
            best = (offset + nearest, i);
        }
    }
    best
}

/// The features of `a` and `b` that face each other. `previous` is kept where a new choice would be no better than
/// `1e-6` of the body's size, so that round-off never makes the choice flicker.
pub fn meet(a: &Core, pose_a: &Pose, b: &Core, pose_b: &Pose, previous: Option<Meeting>) -> Meeting {
    let (gap_a, edge_a) = separation(a, pose_a, b, pose_b);
    let (gap_b, edge_b) = separation(b, pose_b, a, pose_a);
    let was_flipped = matches!(previous, Some(Meeting::Face { flipped: true, .. }));
    let tie = 1e-6 * a.reach.min(b.reach);
    let flipped = if was_flipped { gap_b + tie >= gap_a } else { gap_b > gap_a + tie };
    let (reference, pose_r, incident, pose_i, r) =
        if flipped { (b, pose_b, a, pose_a, edge_b) } else { (a, pose_a, b, pose_b, edge_a) };
    let e = edge(reference, pose_r, r);
    let normal_in_incident = pose_i.rotation.turn_back(e.direction.right());
    let facing = |i: usize| -incident.directions[i].right().dot(normal_in_incident);
    let mut k = 0;
    for i in 1..incident.len() {
        if facing(i) > facing(k) {
            k = i;
        }
    }
    if let Some(Meeting::Face { flipped: f, reference: pr, incident: pi }) = previous
        && f == flipped
        && pr as usize == r
        && (pi as usize) < incident.len()
        && facing(pi as usize) + 1e-9 >= facing(k)
    {
        k = pi as usize;
    }
    let along = |i: usize| (pose_i.place(incident.vertices[i]) - e.start).dot(e.direction);
    // The incident edge runs against the reference edge: its start lies at the high end.
    let (start, end) = (k, incident.next(k));
    let corner = |at_reference: usize, at_incident: usize| {
        let (first, second) = if flipped { (at_incident, at_reference) } else { (at_reference, at_incident) };
        Meeting::Corner { first: first as u32, second: second as u32 }
    };
    if along(end) >= e.length {
        corner(reference.next(r), end)
    } else if along(start) <= 0.0 {
        corner(r, start)
    } else {
        Meeting::Face { flipped, reference: r as u32, incident: k as u32 }
    }
}

impl Meeting {
    /// Contact points of this meeting for the bodies as they are placed now.
    #[inline]
    pub fn manifold(self, a: &Core, pose_a: &Pose, b: &Core, pose_b: &Pose) -> Manifold {
        let radii = a.radius + b.radius;
        match self {
            Meeting::Face { flipped: false, reference, incident } => {
                face(a, pose_a, reference as usize, b, pose_b, incident as usize)
            }
            Meeting::Face { flipped: true, reference, incident } => {
                let m = face(b, pose_b, reference as usize, a, pose_a, incident as usize);
                // Seen from the other side the normal turns round, and with it the order of the points.
                Manifold { normal: -m.normal, points: [m.points[1], m.points[0]], gaps: [m.gaps[1], m.gaps[0]], ..m }
            }
            Meeting::Corner { first, second } => {
                let p = pose_a.place(a.vertices[first as usize]);
                let q = pose_b.place(b.vertices[second as usize]);
                let distance = (q - p).norm();
                let normal = if distance > 1e-300 {
                    (q - p) * (1.0 / distance)
                } else {
                    (pose_b.position - pose_a.position).unit()
                };
                let gap = distance - radii;
                let point = p + normal * (a.radius + 0.5 * gap);
                Manifold { normal, points: [point; 2], gaps: [gap; 2], count: 1 }
            }
        }
    }
}

#[inline]
fn face(a: &Core, pose_a: &Pose, i: usize, b: &Core, pose_b: &Pose, j: usize) -> Manifold {
    let e = edge(a, pose_a, i);
    let normal = e.direction.right();
    let high = pose_b.place(b.vertices[j]) - e.start;
    let low = pose_b.place(b.vertices[b.next(j)]) - e.start;
    let (s_high, g_high) = (high.dot(e.direction), high.dot(normal));
    let (s_low, g_low) = (low.dot(e.direction), low.dot(normal));
    let slope = (g_high - g_low) / (s_high - s_low).max(1e-300);
    let at = |s: f64| g_low + (s - s_low) * slope;
    let (s0, g0) = if s_low < 0.0 { (0.0, at(0.0)) } else { (s_low, g_low) };
    let (s1, g1) = if s_high > e.length { (e.length, at(e.length)) } else { (s_high, g_high) };
    let radii = a.radius + b.radius;
    let point = |s: f64, g: f64| e.start + e.direction * s + normal * (a.radius + 0.5 * (g - radii));
    // `normal.left()` is the edge's direction: low first.
    Manifold { normal, points: [point(s0, g0), point(s1, g1)], gaps: [g0 - radii, g1 - radii], count: 2 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::{Polygon, Rotation, vec2};

    fn unit_square() -> Core {
        Core::new(&Polygon::rectangle(Vec2::ZERO, 1.0, 1.0).unwrap(), 0.05).unwrap()
    }

    #[test]
    fn stacked_squares_meet_in_two_points_inset_by_the_rounding() {
        let core = unit_square();
        let (a, b) = (Pose::at(Vec2::ZERO), Pose::at(vec2(0.2, 1.001)));
        let m = meet(&core, &a, &core, &b, None).manifold(&core, &a, &core, &b);
        assert_eq!(m.count, 2);
        assert!((m.normal - vec2(0.0, 1.0)).norm() < 1e-15);
        assert!((m.points[0] - vec2(0.45, 0.5005)).norm() < 1e-12);
        assert!((m.points[1] - vec2(-0.25, 0.5005)).norm() < 1e-12);
        assert!((m.gaps[0] - 0.001).abs() < 1e-12 && (m.gaps[1] - 0.001).abs() < 1e-12);
    }

    #[test]
    fn squares_corner_to_corner_meet_along_the_line_of_their_arcs() {
        let core = unit_square();
        let (a, b) = (Pose::at(Vec2::ZERO), Pose::at(vec2(1.0, 1.0)));
        let m = meet(&core, &a, &core, &b, None).manifold(&core, &a, &core, &b);
        assert_eq!(m.count, 1);
        assert!((m.normal - vec2(0.5, 0.5).unit()).norm() < 1e-15);
        assert!((m.gaps[0] - (0.1 * 2f64.sqrt() - 0.1)).abs() < 1e-12);
    }

    #[test]
    fn the_answer_does_not_depend_on_which_body_comes_first() {
        let core = unit_square();
        for k in 0..360 {
            let angle = f64::from(k).to_radians();
            let a = Pose { position: Vec2::ZERO, rotation: Rotation::by(0.3) };
            let b = Pose {
                position: vec2(1.02 * (0.37 + angle).cos(), 1.02 * (0.37 + angle).sin()),
                rotation: Rotation::by(1.7 * angle),
            };
            let ab = meet(&core, &a, &core, &b, None).manifold(&core, &a, &core, &b);
            let ba = meet(&core, &b, &core, &a, None).manifold(&core, &b, &core, &a);
            let least = |m: &Manifold| m.gaps[..m.count].iter().copied().fold(f64::INFINITY, f64::min);
            assert!((least(&ab) - least(&ba)).abs() < 1e-9, "{k}");
            assert!((ab.normal + ba.normal).norm() < 1e-9, "{k}: {:?} {:?}", ab, ba);
        }
    }
}
