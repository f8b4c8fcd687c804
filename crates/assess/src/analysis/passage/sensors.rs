//! A sensor as a linear functional of the displacements: nodes and factors. Stresses are asked of the element instead.

use super::PassageError;
use bridge::passage::{Direction, Face, Sensor, SensorKind, SensorPosition};
use mechanics::fem::Mesh;
use mechanics::ids::{NodeId, QuadId};
use mechanics::plane::{Vec2, vec2};
use outcome::passage::Measurand;
use outcome::picture::Point;

/// Nodes of one span's ring.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RingNodes {
    /// Lower face of each stone of the lowest ring, from left to right.
    pub intrados: Vec<Vec<NodeId>>,
    /// Upper face of each stone of the uppermost ring, from left to right.
    pub extrados: Vec<Vec<NodeId>>,
    /// Joints of the lowest ring from the left springing to the right: facing nodes on the left and on the right, each from
    /// the intrados up.
    pub joints: Vec<[Vec<NodeId>; 2]>,
}

/// What a sensor reads.
#[derive(Debug, Clone, PartialEq)]
pub enum Reading {
    /// A sum of displacement components, each times a factor.
    Displacements(Vec<(NodeId, [f64; 2])>),
    /// Normal stress of an element along a direction.
    Stress {
        /// The element.
        quad: QuadId,
        /// Unit vector.
        along: [f64; 2],
    },
}

impl Reading {
    /// The value for displacements and element stresses (xx, yy, xy) in tension positive.
    pub fn value(&self, displacement: impl Fn(NodeId) -> [f64; 2], stress: impl Fn(QuadId) -> [f64; 3]) -> f64 {
        match self {
            Reading::Displacements(terms) => terms
                .iter()
                .map(|(node, factors)| {
                    let moved = displacement(*node);
                    factors[0] * moved[0] + factors[1] * moved[1]
                })
                .sum(),
            Reading::Stress { quad, along: [x, y] } => {
                let [xx, yy, xy] = stress(*quad);
                xx * x * x + yy * y * y + 2.0 * xy * x * y
            }
        }
    }
}

/// A sensor that has found its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// Name of its channel.
    pub name: String,
    /// What it records.
    pub quantity: Measurand,
    /// What it reads.
    pub reading: Reading,
    /// Where it sits and what its sign means.
    pub about: String,
}

/// Finds the place of a sensor on the mesh.
///
/// # Errors
/// A place outside the bridge, one that is on no stone or joint where its kind needs one, or a gauge longer than its stone.
pub fn place(sensor: &Sensor, mesh: &Mesh, rings: &[RingNodes]) -> Result<Placed, PassageError> {
    let name = sensor.name.clone();
    let needs_ring = || PassageError::NeedsRing { name: name.clone() };
    let (span, share) = match (sensor.place, sensor.kind) {
        (SensorPosition::Span { span, share }, _) => (span, share),
        (SensorPosition::Point(at), SensorKind::Displacement(direction)) => {
            let terms = inside(mesh, at).ok_or(PassageError::Outside { name: name.clone(), at })?;
            let (towards, sign) = direction_of(direction, share_at(mesh, rings, at[0]));
            let about = format!("point at x = {:.3} m, y = {:.3} m, {sign} positive", at[0], at[1]);
            return Ok(Placed { name, quantity: Measurand::Displacement, reading: along(&terms, towards), about });
        }
        (SensorPosition::Point(_), _) => return Err(needs_ring()),
    };
    let ring = rings.get(span).filter(|ring| is_usable(ring)).ok_or_else(needs_ring)?;
    let stones = match sensor.face {
        Face::Intrados => &ring.intrados,
        Face::Extrados => &ring.extrados,
    };
    let site = site(span, share, sensor.face);
    let of_stone = |stone: usize| format!("stone {} of {}, {site}", stone + 1, stones.len());
    let (quantity, reading, about) = match sensor.kind {
        SensorKind::Displacement(direction) => {
            let (towards, sign) = direction_of(direction, share);
            let reading = along(&on_face(mesh, stones, share), towards);
            (Measurand::Displacement, reading, format!("{site}, {sign} positive"))
        }
        SensorKind::Strain { gauge_length } => {
            let stone = stone_at(mesh, stones, share);
            let reading = gauge(mesh, &stones[stone], gauge_length).map_err(|stone| PassageError::LongGauge {
                name: name.clone(),
                gauge: gauge_length,
                stone,
            })?;
            let about = format!("{}, over {:.0} mm, tension positive", of_stone(stone), 1e3 * gauge_length);
            (Measurand::Strain, reading, about)
        }
        SensorKind::JointOpening | SensorKind::JointSliding => {
            let joint = joint_at(mesh, ring, share);
            let (quantity, sign) = match sensor.kind {
                SensorKind::JointOpening => (Measurand::JointOpening, "apart positive"),
                _ => (Measurand::JointSliding, "its right side outwards positive"),
            };
            let opening = quantity == Measurand::JointOpening;
            let reading = across(mesh, &ring.joints[joint], sensor.face, opening).ok_or_else(needs_ring)?;
            (quantity, reading, format!("joint {joint} of {}, {site}, {sign}", ring.joints.len() - 1))
        }
        SensorKind::Stress => {
            let stone = stone_at(mesh, stones, share);
            let (at, along) = middle(mesh, &stones[stone]);
            let quad = nearest_of(mesh, &stones[stone], at).ok_or_else(needs_ring)?;
            let reading = Reading::Stress { quad, along: [along.x, along.y] };
            (Measurand::Stress, reading, format!("{}, along the ring, tension positive", of_stone(stone)))
        }
    };
    Ok(Placed { name, quantity, reading, about })
}

/// Whether a ring has both faces and joints on the mesh.
fn is_usable(ring: &RingNodes) -> bool {
    let whole = |faces: &[Vec<NodeId>]| !faces.is_empty() && faces.iter().all(|face| face.len() > 1);
    whole(&ring.intrados) && whole(&ring.extrados) && !ring.joints.is_empty()
}

/// A place in words.
fn site(span: usize, share: f64, face: Face) -> String {
    let where_ = match share {
        0.0 => "left springing".to_owned(),
        1.0 => "right springing".to_owned(),
        0.5 => "crown".to_owned(),
        other => format!("{:.1} %", 100.0 * other),
    };
    format!("{where_} of span {}, {}", span + 1, if face == Face::Intrados { "intrados" } else { "extrados" })
}

/// Direction of a displacement, and what is positive.
fn direction_of(direction: Direction, share: f64) -> (Vec2, &'static str) {
    match direction {
        Direction::Vertical => (vec2(0.0, 1.0), "up"),
        Direction::Horizontal => (vec2(1.0, 0.0), "to the right"),
        Direction::Lateral if share < 0.5 => (vec2(-1.0, 0.0), "to the left, away from the middle of the span"),
        Direction::Lateral => (vec2(1.0, 0.0), "to the right, away from the middle of the span"),
    }
}

fn along(weights: &[(NodeId, f64)], direction: Vec2) -> Reading {
    Reading::Displacements(weights.iter().map(|(node, w)| (*node, [w * direction.x, w * direction.y])).collect())
}

/// Position of a share of the span [m], by the ends of the intrados.
fn place_of(mesh: &Mesh, stones: &[Vec<NodeId>], share: f64) -> f64 {
    let end = |node: Option<&NodeId>| node.map_or(0.0, |node| mesh.nodes[*node].x);
    let left = end(stones.first().and_then(|stone| stone.first()));
    let right = end(stones.last().and_then(|stone| stone.last()));
    left + share * (right - left)
}

/// Share of the span nearest to a place [m].
fn share_at(mesh: &Mesh, rings: &[RingNodes], x: f64) -> f64 {
    let ends = rings.iter().map(|ring| (place_of(mesh, &ring.intrados, 0.0), place_of(mesh, &ring.intrados, 1.0)));
    let distance = |(left, right): &(f64, f64)| (x - 0.5 * (left + right)).abs();
    let nearest = ends.min_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest.map_or(0.5, |(left, right)| (x - left) / (right - left))
}

/// Weights of the nodes of a face at a share of its span; where two stones meet there, half of each.
fn on_face(mesh: &Mesh, stones: &[Vec<NodeId>], share: f64) -> Vec<(NodeId, f64)> {
    let x = place_of(mesh, stones, share);
    let ends = |stone: &[NodeId]| (mesh.nodes[stone[0]].x, mesh.nodes[stone[stone.len() - 1]].x);
    let (first, last) = (ends(&stones[0]).0, ends(&stones[stones.len() - 1]).1);
    // A hair's breadth: the two nodes of a joint coincide up to rounding.
    let slack = 1e-9 * (last - first).abs();
    let met: Vec<&Vec<NodeId>> = stones
        .iter()
        .filter(|stone| {
            let (left, right) = ends(stone);
            x >= left - slack && x <= right + slack
        })
        .collect();
    let mut weights = Vec::new();
    for stone in &met {
        let part = 1.0 / met.len() as f64;
        let segment = stone.windows(2).find(|pair| x <= mesh.nodes[pair[1]].x).unwrap_or(&stone[stone.len() - 2..]);
        let (left, right) = (mesh.nodes[segment[0]].x, mesh.nodes[segment[1]].x);
        let t = ((x - left) / (right - left)).clamp(0.0, 1.0);
        weights.extend([(segment[0], part * (1.0 - t)), (segment[1], part * t)].into_iter().filter(|(_, w)| *w > 0.0));
    }
    weights
}

/// The stone at a share of the span; the right one of two that meet there, but the last one at the right springing.
fn stone_at(mesh: &Mesh, stones: &[Vec<NodeId>], share: f64) -> usize {
    let x = place_of(mesh, stones, share);
    let slack = 1e-9 * (place_of(mesh, stones, 1.0) - place_of(mesh, stones, 0.0)).abs();
    let right = |stone: &Vec<NodeId>| mesh.nodes[stone[stone.len() - 1]].x;
    stones.iter().position(|stone| right(stone) > x + slack).unwrap_or(stones.len() - 1)
}

/// The joint nearest to a share of the span.
fn joint_at(mesh: &Mesh, ring: &RingNodes, share: f64) -> usize {
    let x = place_of(mesh, &ring.intrados, share);
    let foot = |joint: &[Vec<NodeId>; 2]| {
        joint[1].first().or(joint[0].first()).map_or(f64::INFINITY, |node| (mesh.nodes[*node].x - x).abs())
    };
    let nearest = ring.joints.iter().enumerate().min_by(|(_, a), (_, b)| foot(a).total_cmp(&foot(b)));
    nearest.map_or(0, |(k, _)| k)
}

/// Mean strain between two points of a face, a gauge length apart about its middle. `Err` is the length of the face [m].
fn gauge(mesh: &Mesh, face: &[NodeId], gauge: f64) -> Result<Reading, f64> {
    let lengths: Vec<f64> = face.windows(2).map(|pair| (mesh.nodes[pair[1]] - mesh.nodes[pair[0]]).norm()).collect();
    let whole: f64 = lengths.iter().sum();
    // Rounding of a stone exactly as long as its gauge.
    if gauge > whole * (1.0 + 1e-9) {
        return Err(whole);
    }
    let at = |distance: f64| -> (Vec<(NodeId, f64)>, Vec2) {
        let mut from = 0.0;
        for (pair, length) in face.windows(2).zip(&lengths) {
            if distance <= from + length || pair[1] == face[face.len() - 1] {
                let t = ((distance - from) / length).clamp(0.0, 1.0);
                let place = mesh.nodes[pair[0]] + (mesh.nodes[pair[1]] - mesh.nodes[pair[0]]) * t;
                return (vec![(pair[0], 1.0 - t), (pair[1], t)], place);
            }
            from += length;
        }
        (Vec::new(), Vec2::ZERO)
    };
    let (start, end) = (at(0.5 * (whole - gauge)), at(0.5 * (whole + gauge)));
    let chord = end.1 - start.1;
    let (length, direction) = (chord.norm(), chord.unit());
    let mut terms = Vec::new();
    for (weights, sign) in [(start.0, -1.0), (end.0, 1.0)] {
        for (node, weight) in weights {
            let factor = sign * weight / length;
            terms.push((node, [factor * direction.x, factor * direction.y]));
        }
    }
    Ok(Reading::Displacements(terms))
}

/// Opening or sliding of a joint at a face.
fn across(mesh: &Mesh, joint: &[Vec<NodeId>; 2], face: Face, opening: bool) -> Option<Reading> {
    let [left, right] = joint;
    let end = |side: &[NodeId]| match face {
        Face::Intrados => side.first().copied(),
        Face::Extrados => side.last().copied(),
    };
    // Along the joint, outwards; its right turn points to the right side.
    let outwards = (mesh.nodes[*left.last()?] - mesh.nodes[*left.first()?]).unit();
    let direction = if opening { outwards.right() } else { outwards };
    let (one, two) = (end(left)?, end(right)?);
    Some(Reading::Displacements(vec![(one, [-direction.x, -direction.y]), (two, [direction.x, direction.y])]))
}

/// Middle of a face [m], and its direction from left to right.
fn middle(mesh: &Mesh, face: &[NodeId]) -> (Vec2, Vec2) {
    let (first, last) = (mesh.nodes[face[0]], mesh.nodes[face[face.len() - 1]]);
    ((first + last) * 0.5, (last - first).unit())
}

/// The element nearest to a point among those that have an edge on a face.
fn nearest_of(mesh: &Mesh, face: &[NodeId], at: Vec2) -> Option<QuadId> {
    let on_face = |nodes: &[NodeId; 4]| nodes.iter().filter(|node| face.contains(node)).count() > 1;
    let centre = |nodes: &[NodeId; 4]| nodes.iter().fold(Vec2::ZERO, |sum, node| sum + mesh.nodes[*node]) * 0.25;
    mesh.quads
        .pairs()
        .filter(|(_, quad)| on_face(&quad.nodes))
        .min_by(|(_, a), (_, b)| (centre(&a.nodes) - at).norm().total_cmp(&(centre(&b.nodes) - at).norm()))
        .map(|(id, _)| id)
}

/// Weights of the corners of the element that a point lies in, by the element's own shape functions.
fn inside(mesh: &Mesh, at: Point) -> Option<Vec<(NodeId, f64)>> {
    let at = vec2(at[0], at[1]);
    for quad in mesh.quads.iter() {
        let corners = quad.nodes.map(|node| mesh.nodes[node]);
        let low = corners.iter().fold(corners[0], |a, b| vec2(a.x.min(b.x), a.y.min(b.y)));
        let high = corners.iter().fold(corners[0], |a, b| vec2(a.x.max(b.x), a.y.max(b.y)));
        // A point on an edge belongs to either element.
        let slack = 1e-9 * (high - low).norm();
        if at.x < low.x - slack || at.x > high.x + slack || at.y < low.y - slack || at.y > high.y + slack {
            continue;
        }
        if let Some(weights) = weights(&corners, at) {
            return Some(quad.nodes.into_iter().zip(weights).filter(|(_, w)| *w != 0.0).collect());
        }
    }
    None
}

/// Bilinear weights of a point in a convex quadrilateral, by Newton's method; none where it lies outside.
fn weights(corners: &[Vec2; 4], at: Vec2) -> Option<[f64; 4]> {
    let shape = |r: f64, s: f64| {
        [(1.0 - r) * (1.0 - s), (1.0 + r) * (1.0 - s), (1.0 + r) * (1.0 + s), (1.0 - r) * (1.0 + s)].map(|n| 0.25 * n)
    };
    let sum = |weights: [f64; 4]| corners.iter().zip(weights).fold(Vec2::ZERO, |sum, (corner, w)| sum + *corner * w);
    let (mut r, mut s) = (0.0, 0.0);
    for _ in 0..20 {
        let miss = at - sum(shape(r, s));
        let by_r = sum([s - 1.0, 1.0 - s, 1.0 + s, -1.0 - s].map(|n| 0.25 * n));
        let by_s = sum([r - 1.0, -1.0 - r, 1.0 + r, 1.0 - r].map(|n| 0.25 * n));
        let size = by_r.cross(by_s);
        let (dr, ds) = (miss.cross(by_s) / size, by_r.cross(miss) / size);
        (r, s) = (r + dr, s + ds);
        if dr.abs() + ds.abs() < 1e-13 {
            break;
        }
    }
    // Rounding at the edges of the element.
    let within = |v: f64| v.abs() <= 1.0 + 1e-9;
    (within(r) && within(s)).then(|| shape(r, s))
}

#[cfg(test)]
mod tests {
    use super::*;
    use mechanics::fem::Quad;

    /// Two straight stones of 0.4 m by 0.2 m between two springings, each of 2 x 1 elements, side by side with a joint at 0.4 m.
    fn two_stones() -> (Mesh, Vec<RingNodes>) {
        let mut mesh = Mesh::default();
        let zone = mesh.zones.push("voussoirs span 1".into());
        let mut ring = RingNodes::default();
        let mut sides = Vec::new();
        for stone in 0..2 {
            let x = 0.4 * f64::from(stone);
            let row = |mesh: &mut Mesh, y: f64| -> Vec<NodeId> {
                (0..3).map(|k| mesh.nodes.push(vec2(x + 0.2 * f64::from(k), y))).collect()
            };
            let (lower, upper) = (row(&mut mesh, 0.0), row(&mut mesh, 0.2));
            for k in 0..2 {
                mesh.quads.push(Quad { nodes: [lower[k], lower[k + 1], upper[k + 1], upper[k]], zone });
            }
            sides.push([vec![lower[0], upper[0]], vec![lower[2], upper[2]]]);
            ring.intrados.push(lower);
            ring.extrados.push(upper);
        }
        ring.joints = vec![
            [sides[0][0].clone(), sides[0][0].clone()],
            [sides[0][1].clone(), sides[1][0].clone()],
            [sides[1][1].clone(), sides[1][1].clone()],
        ];
        (mesh, vec![ring])
    }

    fn sensor(kind: SensorKind, place: SensorPosition, face: Face) -> Sensor {
        Sensor { name: "test".into(), kind, place, face }
    }

    /// A homogeneous deformation is read exactly by every gauge: strain along the face, displacement at the point.
    #[test]
    fn a_homogeneous_deformation_is_read_exactly() {
        let (mesh, rings) = two_stones();
        let moved = |node: NodeId| {
            let p = mesh.nodes[node];
            [1e-3 + 2e-4 * p.x + 3e-4 * p.y, -2e-3 + 5e-4 * p.x - 1e-4 * p.y]
        };
        let no_stress = |_: QuadId| [0.0; 3];
        let read = |sensor: &Sensor| place(sensor, &mesh, &rings).unwrap().reading.value(moved, no_stress);
        let crown = SensorPosition::Span { span: 0, share: 0.5 };
        // Rounding of factors of 1 / 0.12 m.
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-15 * 100.0, "{a} {b}");
        near(read(&sensor(SensorKind::Strain { gauge_length: 0.12 }, crown, Face::Intrados)), 2e-4);
        near(read(&sensor(SensorKind::Strain { gauge_length: 0.4 }, crown, Face::Extrados)), 2e-4);
        let vertical = SensorKind::Displacement(Direction::Vertical);
        near(read(&sensor(vertical, crown, Face::Intrados)), -2e-3 + 5e-4 * 0.4);
        near(
            read(&sensor(vertical, SensorPosition::Span { span: 0, share: 0.3 }, Face::Extrados)),
            -2e-3 + 5e-4 * 0.24 - 2e-5,
        );
        near(read(&sensor(vertical, SensorPosition::Point([0.53, 0.07]), Face::Intrados)), -2e-3 + 5e-4 * 0.53 - 7e-6);
        let lateral = SensorKind::Displacement(Direction::Lateral);
        near(read(&sensor(lateral, SensorPosition::Span { span: 0, share: 0.0 }, Face::Intrados)), -1e-3);
        near(read(&sensor(lateral, SensorPosition::Span { span: 0, share: 1.0 }, Face::Intrados)), 1e-3 + 2e-4 * 0.8);
        // Nodes that coincide and move alike neither open nor slide.
        near(read(&sensor(SensorKind::JointOpening, crown, Face::Extrados)), 0.0);
    }

    /// A stone that moves as a rigid body, turned as well, has no strain; the joint beside it opens and slides by what it moved.
    #[test]
    fn a_rigid_stone_opens_its_joint_and_is_not_strained() {
        let (mesh, rings) = two_stones();
        let right: Vec<NodeId> = rings[0].intrados[1].iter().chain(&rings[0].extrados[1]).copied().collect();
        let moved = |node: NodeId| {
            let p = mesh.nodes[node];
            if right.contains(&node) { [2e-3 - 1e-3 * p.y, 7e-4 + 1e-3 * (p.x - 0.4)] } else { [0.0; 2] }
        };
        let read = |kind, face| {
            let one = sensor(kind, SensorPosition::Span { span: 0, share: 0.5 }, face);
            place(&one, &mesh, &rings).unwrap().reading.value(moved, |_| [0.0; 3])
        };
        assert!((read(SensorKind::JointOpening, Face::Intrados) - 2e-3).abs() < 1e-15);
        assert!((read(SensorKind::JointOpening, Face::Extrados) - 1.8e-3).abs() < 1e-15);
        assert!((read(SensorKind::JointSliding, Face::Intrados) - 7e-4).abs() < 1e-15);
        assert!(read(SensorKind::Strain { gauge_length: 0.12 }, Face::Intrados).abs() < 1e-15);
        let stress = sensor(SensorKind::Stress, SensorPosition::Span { span: 0, share: 0.5 }, Face::Extrados);
        let placed = place(&stress, &mesh, &rings).unwrap();
        assert_eq!(placed.reading.value(moved, |_| [-3.0, 1.0, 9.0]), -3.0);
    }

    #[test]
    fn what_has_no_place_says_so() {
        let (mesh, rings) = two_stones();
        let crown = SensorPosition::Span { span: 0, share: 0.5 };
        let long = sensor(SensorKind::Strain { gauge_length: 0.41 }, crown, Face::Intrados);
        assert!(matches!(place(&long, &mesh, &rings), Err(PassageError::LongGauge { .. })));
        let vertical = SensorKind::Displacement(Direction::Vertical);
        let outside = sensor(vertical, SensorPosition::Point([3.0, 0.1]), Face::Intrados);
        assert!(matches!(place(&outside, &mesh, &rings), Err(PassageError::Outside { .. })));
        let gauge = sensor(SensorKind::Stress, SensorPosition::Point([0.1, 0.1]), Face::Intrados);
        assert!(matches!(place(&gauge, &mesh, &rings), Err(PassageError::NeedsRing { .. })));
        let elsewhere = sensor(vertical, SensorPosition::Span { span: 4, share: 0.5 }, Face::Intrados);
        assert!(matches!(place(&elsewhere, &mesh, &rings), Err(PassageError::NeedsRing { .. })));
    }
}
