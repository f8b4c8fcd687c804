//! Tests of meshes: they fill the bridge once, their faces fit, and any bridge has one.

use super::*;
use crate::samples::{Dice, bridgemill, spans};
use bridge::ring::Profile;
use bridge::*;
use mechanics::ids::NodeId;
use mechanics::plane::{Vec2, vec2};

fn ring(thickness: f64, voussoirs: usize) -> Ring {
    Ring { crown_thickness: thickness, springing_thickness: thickness, voussoirs }
}

/// Four spans of 6 m like those of the railway paper.
fn railway() -> Bridge {
    let span = Span {
        profile: Profile::Segmental,
        span: 6.0,
        rise: 1.5,
        rings: vec![ring(0.54, 25)],
        defects: Vec::new(),
        skew: 0.0,
        right_springing: 0.0,
    };
    let mut b = spans(vec![span; 4], 1.5, 1.8, 3.0, 6);
    b.cover.depth = 0.48;
    b.abutments = [Abutment { top_width: 1.5, height: 3.0, body: None }; 2];
    b.service.haunch_fill = Some(HaunchFill { height: 1.0, soil: Service::default().fill });
    b
}

fn area(corners: &[Vec2]) -> f64 {
    let n = corners.len();
    0.5 * (0..n).map(|k| corners[k].cross(corners[(k + 1) % n])).sum::<f64>()
}

/// The sum of the elements' areas, and the area between base, sides and surface less what is open under the arches and beside
/// the piers.
fn areas(bridge: &Bridge, m: &Meshed) -> [f64; 2] {
    let sum = m.mesh.quads.ids().map(|q| area(&corners(&m.mesh, q))).sum();
    let at = |n: NodeId| m.mesh.nodes[n];
    let [left, right] = [&m.sets.left, &m.sets.right].map(|side| at(side[0]).x);
    // Above the springings.
    let mut expected = (right - left) * m.surface;
    let mut edges = Vec::new();
    for set in &m.sets.spans {
        let mut under: Vec<Vec2> = set.voussoirs[0].iter().flat_map(Voussoir::intrados).map(at).collect();
        under.reverse();
        expected -= area(&under);
        edges.extend(set.springings_at.map(|p| p.x));
    }
    // Below them.
    expected += (edges[0] - left) * bridge.abutments[0].height;
    expected += (right - edges[edges.len() - 1]) * bridge.abutments[1].height;
    expected += bridge.piers.iter().map(|p| 0.5 * (p.width + p.base_width) * p.height).sum::<f64>();
    [sum, expected]
}

/// Facing nodes coincide, and side `two` lies to the left of the way walked, side `one` to the right.
fn faces_fit(m: &Meshed) {
    let mesh = &m.mesh;
    let mut around: Vec<Vec<Vec2>> = vec![Vec::new(); mesh.nodes.len()];
    for q in mesh.quads.ids() {
        let c = corners(mesh, q);
        for n in mesh.quads[q].nodes {
            around[n.0 as usize].push((c[0] + c[1] + c[2] + c[3]) * 0.25);
        }
    }
    for (id, face) in mesh.interfaces.pairs() {
        assert_eq!(face.one.len(), face.two.len());
        let name = &mesh.kinds[face.kind];
        assert!(face.one.len() >= 2, "{name} {id:?}");
        for (a, b) in face.one.iter().zip(&face.two) {
            assert_ne!(a, b);
            assert!((mesh.nodes[*a] - mesh.nodes[*b]).norm() < 1e-9, "{name} {id:?}");
        }
        for k in 1..face.one.len() {
            let from = mesh.nodes[face.one[k - 1]];
            let way = mesh.nodes[face.one[k]] - from;
            // An element that has both nodes of a side of the face lies on that side.
            let sides = [(&face.one, -1.0), (&face.two, 1.0)];
            for (nodes, sign) in sides {
                let pair = [nodes[k - 1], nodes[k]];
                let elements: Vec<_> =
                    mesh.quads.iter().filter(|q| pair.iter().all(|n| q.nodes.contains(n))).take(2).collect();
                assert_eq!(elements.len(), 1, "{name} {id:?}: a face is the side of one element");
                let middle = elements[0].nodes.iter().fold(Vec2::ZERO, |s, n| s + mesh.nodes[*n]) * 0.25;
                assert!(sign * way.cross(middle - from) > 0.0, "{name} {id:?} lies the wrong way round");
            }
        }
    }
    assert!(around.iter().all(|elements| !elements.is_empty()), "every node belongs to an element");
}

/// Whatever is cheap to check on any mesh.
fn is_sound(bridge: &Bridge, m: &Meshed) {
    let [sum, expected] = areas(bridge, m);
    // The only difference is rounding, and the chord between the last two points of an intrados.
    assert!((sum - expected).abs() < 1e-9 * expected, "area {sum} instead of {expected}");
    assert!(m.quality.scaled_jacobian >= LEAST_JACOBIAN);
    let at = |n: NodeId| m.mesh.nodes[n];
    assert!(m.sets.surface.windows(2).all(|w| at(w[0]).x < at(w[1]).x));
    assert!(m.sets.surface.iter().all(|n| at(*n).y == m.surface));
    for side in [&m.sets.left, &m.sets.right] {
        assert!(side.windows(2).all(|w| at(w[0]).y < at(w[1]).y && (at(w[0]).x - at(w[1]).x).abs() < 1e-9));
        assert_eq!(at(side[side.len() - 1]).y, m.surface);
    }
    let mut zones: Vec<_> = m.mesh.quads.iter().map(|q| q.zone).collect();
    zones.dedup();
    assert_eq!(zones, m.mesh.zones.ids().collect::<Vec<_>>(), "elements of a zone stand together");
    let arches = layout::arches(bridge).unwrap();
    for (i, set) in m.sets.spans.iter().enumerate() {
        for (k, ring) in bridge.spans[i].rings.iter().enumerate() {
            assert_eq!(set.voussoirs[k].len(), ring.voussoirs);
            assert_eq!(set.joints[k].len(), ring.voussoirs + 1);
            for (joint, id) in set.joints[k].iter().enumerate() {
                let face = &m.mesh.interfaces[*id];
                assert_eq!((face.kind, face.one.len()), (0, m.options.ring_nodes));
                // The voussoirs on both sides of it.
                let holds = |voussoir: Option<&Voussoir>, side: &[NodeId]| {
                    voussoir.is_none_or(|voussoir| side.iter().all(|node| voussoir.nodes.contains(node)))
                };
                assert!(holds(set.voussoirs[k].get(joint), &face.one), "span {i} ring {k} joint {joint}");
                let before = joint.checked_sub(1).map(|left| &set.voussoirs[k][left]);
                assert!(holds(before, &face.two), "span {i} ring {k} joint {joint}");
            }
        }
        let crown = arches[i].intrados(0.5);
        assert!(set.voussoirs[0].iter().flat_map(Voussoir::intrados).any(|n| (at(n) - crown).norm() < 1e-9));
    }
}

#[test]
fn railway_bridge() {
    let bridge = railway();
    let m = mesh(&bridge).unwrap();
    is_sound(&bridge, &m);
    faces_fit(&m);
    let names: Vec<&str> = m.mesh.zones.iter().map(String::as_str).collect();
    assert_eq!(names[0], "voussoirs span 1");
    for name in ["pier 3", "abutment left", "fill", "haunch fill", "abutment fill right"] {
        assert!(names.contains(&name), "{names:?}");
    }
    // The haunch fill's upper face is level.
    let zone = m.roles.pairs().find(|(_, role)| **role == Role::HaunchFill).unwrap().0;
    let top = m.mesh.quads.iter().filter(|q| q.zone == zone).flat_map(|q| q.nodes).map(|n| m.mesh.nodes[n].y);
    assert!((top.fold(f64::NEG_INFINITY, f64::max) - 1.0).abs() < 0.05, "within a quarter of a voussoir");
    assert!(m.quality.scaled_jacobian > 0.4, "{:?}", m.quality);
}

/// Zones over a pier are cut along one row, however fine the rows: the haunch fill has the same area for any size.
#[test]
fn haunch_fill_ends_at_one_row() {
    let area_of = |size: f64| {
        let mut bridge = railway();
        bridge.service.mesh.size = Some(size);
        let m = mesh(&bridge).unwrap();
        let zone = m.roles.pairs().find(|(_, role)| **role == Role::HaunchFill).unwrap().0;
        m.mesh.quads.ids().filter(|q| m.mesh.quads[*q].zone == zone).map(|q| area(&corners(&m.mesh, q))).sum::<f64>()
    };
    let coarse = area_of(0.3);
    for size in [0.15, 0.06, 0.03] {
        // What is left is the chords of the extrados: the sagitta of an element of 0.3 m on a radius of 4.3 m, 3 mm.
        assert!((area_of(size) / coarse - 1.0).abs() < 0.01, "{size}: {} {coarse}", area_of(size));
    }
}

#[test]
fn the_same_file_gives_the_same_mesh() {
    assert_eq!(mesh(&railway()), mesh(&railway()));
}

#[test]
fn a_doubled_boundary_changes_nothing_else() {
    let near = mesh(&railway()).unwrap();
    let edge = |m: &Meshed| m.mesh.nodes[m.sets.right[0]].x;
    let back = 6.0 * 4.0 + 1.5 * 3.0 + 0.54 * 0.8 + 1.5;
    let doubled = Some(2.0 * (edge(&near) - back));
    let far = mesh_with(&railway(), MeshOptions { side_distance: doubled, ..near.options }).unwrap();
    assert!((edge(&far) - back - 2.0 * (edge(&near) - back)).abs() < 1e-9);
    for (a, b) in far.sets.spans.iter().zip(&near.sets.spans) {
        assert_eq!(a.voussoirs, b.voussoirs);
    }
}

#[test]
fn half_the_size_gives_about_four_times_the_fill() {
    let coarse = mesh(&railway()).unwrap();
    let fine = mesh_with(&railway(), MeshOptions { size: 0.5 * coarse.options.size, ..coarse.options }).unwrap();
    let fill = |m: &Meshed| {
        let zone = m.roles.pairs().find(|(_, role)| **role == Role::Fill).unwrap().0;
        m.mesh.quads.iter().filter(|q| q.zone == zone).count() as f64
    };
    let ratio = fill(&fine) / fill(&coarse);
    assert!((2.5..=5.0).contains(&ratio), "{ratio}");
    assert!(fine.quality.scaled_jacobian > 0.4);
}

fn random_span(dice: &mut Dice) -> Span {
    let span = dice.between(2.0, 20.0);
    let half = 0.5 * span;
    let (profile, rise) = match (dice.roll() * 7.0) as usize {
        0 => (Profile::Segmental, dice.between(0.1, 0.5) * span),
        1 => (Profile::Semicircular, half),
        2 => (Profile::Parabolic, dice.between(0.1, 0.5) * span),
        3 => (Profile::Elliptical, dice.between(0.15, 0.5) * span),
        4 => {
            let rise = dice.between(0.5, 0.98) * half;
            (Profile::ThreeCentred { haunch_radius: dice.between(0.5, 0.9) * rise }, rise)
        }
        5 => (Profile::Pointed, dice.between(1.02, 1.5) * half),
        _ => {
            let rise = dice.between(0.15, 0.45) * span;
            let points = (0..=12).map(|k| {
                let t = k as f64 / 12.0;
                let off = if k == 0 || k == 12 { 0.0 } else { 0.01 * rise * (dice.roll() - 0.5) };
                [t * span, 4.0 * rise * t * (1.0 - t) + off]
            });
            (Profile::Measured { points: points.collect() }, rise)
        }
    };
    let thickness = span / dice.between(8.0, 25.0);
    let springing = thickness * dice.between(1.0, 1.4);
    let voussoirs = dice.between(7.0, 60.0) as usize;
    let rings = dice.choose(&[1, 1, 2, 3]);
    let rings = (0..rings).map(|k| Ring {
        crown_thickness: thickness / rings as f64,
        springing_thickness: springing / rings as f64,
        voussoirs: voussoirs + k,
    });
    Span { profile, span, rise, rings: rings.collect(), defects: Vec::new(), skew: 0.0, right_springing: 0.0 }
}

fn random_bridge(dice: &mut Dice) -> Bridge {
    let count = dice.choose(&[1, 2, 3, 4, 5]);
    let (one, same) = (random_span(dice), dice.roll() < 0.6);
    let mut list = vec![one.clone()];
    for _ in 1..count {
        list.push(if same { one.clone() } else { random_span(dice) });
    }
    let skew = list.iter().map(|s| s.rings.iter().map(|r| r.springing_thickness).sum::<f64>()).fold(0.0, f64::max);
    let width = 2.0 * skew + dice.between(0.05, 2.0);
    let mut b = spans(list, width, width * dice.between(1.0, 1.4), dice.between(0.5, 12.0), 3);
    b.cover.depth = dice.between(0.2, 3.0);
    b.abutments =
        [0, 1].map(|_| Abutment { top_width: dice.between(0.3, 4.0), height: dice.between(0.3, 6.0), body: None });
    let rise = b.spans[0].rise;
    if dice.roll() < 0.5 {
        b.service.haunch_fill =
            Some(HaunchFill { height: rise * dice.between(0.1, 1.2), soil: Service::default().fill });
    }
    if dice.roll() < 0.3 {
        b.service.abutment_fill.extent = Some(dice.between(0.5, 8.0));
    }
    b.service.mesh.ring_nodes = dice.choose(&[2, 3, 7, 11]);
    b.service.mesh.size = Some(dice.between(0.1, 0.6));
    b
}

/// Convex elements, no gap and no overlap, for every profile, from flat to steep, and for spans that differ.
#[test]
fn random_bridges_have_sound_meshes() {
    let mut dice = Dice(7);
    let (mut least, mut aspect, mut refused, mut poor) = (f64::INFINITY, 0.0f64, Vec::new(), Vec::new());
    for k in 0..150 {
        let bridge = random_bridge(&mut dice);
        let profiles: Vec<String> = bridge
            .spans
            .iter()
            .map(|s| format!("{:?} {:.2}/{:.2}", s.profile, s.rise, s.span).chars().take(40).collect())
            .collect();
        match mesh(&bridge) {
            Ok(m) => {
                is_sound(&bridge, &m);
                if k % 20 == 0 {
                    faces_fit(&m);
                }
                if m.quality.scaled_jacobian < 0.15 {
                    poor.push(format!("{k}: {profiles:?} {:?}", m.quality));
                }
                least = least.min(m.quality.scaled_jacobian);
                aspect = aspect.max(m.quality.aspect_ratio);
            }
            Err(error) => refused
                .push(format!("{k}: {profiles:?} haunch {:?}: {error}", bridge.service.haunch_fill.map(|h| h.height))),
        }
    }
    // Poor elements come where a flat ring and a steep one spring from one narrow pier, which is seldom built: the fill there
    // ends in a wedge.
    assert!(
        poor.len() <= 12,
        "{} poor:
{}",
        poor.len(),
        poor.join(
            "
"
        )
    );
    assert!(least >= LEAST_JACOBIAN);
    // Where rings all but meet on a pier, or many nodes stand across a thin ring.
    assert!(aspect < 1000.0, "{aspect}");
    assert!(refused.is_empty(), "{} refused:\n{}", refused.len(), refused.join("\n"));
}

#[test]
fn what_has_no_mesh_says_why() {
    let mut bare = bridgemill();
    bare.cover.depth = 0.0;
    assert_eq!(mesh(&bare), Err(MeshError::NoFill));
    let mut tight = railway();
    tight.piers.iter_mut().for_each(|p| p.width = 0.8);
    assert!(matches!(mesh(&tight), Err(MeshError::RingsMeet { support: 1, .. })));
    let mut fine = railway();
    fine.service.mesh.size = Some(0.005);
    fine.service.mesh.ring_nodes = 100;
    assert!(matches!(mesh(&fine), Err(MeshError::TooFine { .. })));
}

#[test]
fn scaled_jacobians_of_known_quadrilaterals() {
    let square = [vec2(0.0, 0.0), vec2(1.0, 0.0), vec2(1.0, 1.0), vec2(0.0, 1.0)];
    assert_eq!(scaled_jacobian(square), 1.0);
    let rhombus = [vec2(0.0, 0.0), vec2(1.0, 0.0), vec2(1.5, 0.75f64.sqrt()), vec2(0.5, 0.75f64.sqrt())];
    assert!((scaled_jacobian(rhombus) - 0.75f64.sqrt()).abs() < 1e-12);
    let dart = [vec2(0.0, 0.0), vec2(1.0, 0.0), vec2(0.2, 0.2), vec2(0.0, 1.0)];
    assert!(scaled_jacobian(dart) < 0.0);
}

#[test]
fn any_size_and_any_number_of_nodes_across() {
    for (size, nodes) in [(0.05, 2), (0.1, 15), (1.0, 7), (5.0, 3)] {
        let mut bridge = railway();
        bridge.service.mesh.size = Some(size);
        bridge.service.mesh.ring_nodes = nodes;
        let m = mesh(&bridge).unwrap();
        is_sound(&bridge, &m);
        assert!(m.quality.scaled_jacobian > 0.3, "{size}: {:?}", m.quality);
        // A sleeper's length along the rail is met by at least two elements where the mesh is fine.
        let longest = |m: &Meshed| {
            let span = &m.sets.spans;
            let (a, b) = (span[0].springings_at[0].x, span[3].springings_at[1].x);
            let xs: Vec<f64> =
                m.sets.surface.iter().map(|n| m.mesh.nodes[*n].x).filter(|x| (a..=b).contains(x)).collect();
            xs.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max)
        };
        assert!(longest(&m) <= 1.5 * size + 1e-9, "{size}: {}", longest(&m));
    }
}

/// Ballast on top is a pressure, and no part of the mesh.
#[test]
fn ballast_lies_on_the_surface() {
    let mut bridge = railway();
    let layer = |name, thickness| Layer { name, ..crate::samples::fill(thickness, 1800.0) };
    bridge.cover.layers = vec![layer(LayerKind::Fill, 0.28), layer(LayerKind::Ballast, 0.20)];
    let m = mesh(&bridge).unwrap();
    assert!((m.surface - (1.5 + 0.54 + 0.28)).abs() < 1e-9);
    assert!((m.ballast_pressure - 0.2 * 1800.0 * 9.81).abs() < 1e-9);
    bridge.cover.layers.remove(0);
    bridge.cover.depth = 0.20;
    assert_eq!(mesh(&bridge), Err(MeshError::NoFill));
}
