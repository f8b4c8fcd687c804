//! Springings at unequal levels: what is cut, what it weighs, and the load that is carried.

use super::springings::springings;
use super::{DiscretiseError, bridge_length, discretise, mesh};
use crate::samples;
use bridge::ring::Profile;
use bridge::{Backing, BackingBody, Bridge, FillPressure, Friction, LeastPressure, Method, Pier, Ring, Span};
use mechanics::plane::{Vec2, vec2};

fn ring(thickness: f64, voussoirs: usize) -> Ring {
    Ring { crown_thickness: thickness, springing_thickness: thickness, voussoirs }
}

/// One span of 8 m whose right springing lies higher, under fill that presses.
fn sloping(profile: Profile, rise: f64, right: f64) -> Bridge {
    let mut b = samples::bridgemill();
    b.masonry.rounding = 0.0;
    b.spans[0] =
        Span { profile, span: 8.0, rise, right_springing: right, rings: vec![ring(0.5, 31)], ..b.spans[0].clone() };
    b.cover.layers = vec![samples::fill(0.4, 1800.0)];
    b.cover.depth = 0.4;
    b.loads[0].position = 2.2;
    b.fill_pressure = Some(FillPressure {
        applies: true,
        friction_angle: 30f64.to_radians(),
        cohesion: 5e3,
        mobilisation: 0.5,
        cohesion_mobilisation: 0.05,
        least: LeastPressure::AtRest,
        half_movement: 0.02,
    });
    b
}

/// Three spans on a gradient: unequal skewbacks, piers of unequal height, backing.
fn viaduct() -> Bridge {
    let mut b = sloping(Profile::Segmental, 2.0, 0.25);
    let one = b.spans[0].clone();
    let short = Span { span: 6.0, rise: 1.3, right_springing: 0.15, rings: vec![ring(0.4, 25)], ..one.clone() };
    let flat = Span { profile: Profile::Parabolic, rise: 1.6, right_springing: -0.2, ..one.clone() };
    b.spans = vec![one, short, flat];
    b.piers = vec![
        Pier { step: 0.05, ..Pier::plain(1.4, 1.8, 4.0, 4) },
        Pier { step: -0.1, base_offset: 0.1, ..Pier::plain(1.3, 1.6, 5.0, 5) },
    ];
    b.cover.backing = Some(Backing { body: BackingBody::Weight, ..samples::backing(0.7) });
    b
}

fn mirrored(b: &Bridge) -> Bridge {
    let (mut other, length) = (b.clone(), bridge_length(b));
    other.spans.reverse();
    for span in &mut other.spans {
        if let Profile::Measured { points } = &mut span.profile {
            let [end, level] = points[points.len() - 1];
            *points = points.iter().rev().map(|[x, y]| [end - x, y - level]).collect();
        }
        span.right_springing = -span.right_springing;
    }
    other.piers.reverse();
    for pier in &mut other.piers {
        (pier.step, pier.base_offset) = (-pier.step, -pier.base_offset);
    }
    other.abutments.reverse();
    other.loads.iter_mut().for_each(|load| load.position = length - load.position);
    for void in &mut other.cover.voids {
        let turn = |[a, b]: [f64; 2]| [length - b, length - a];
        (void.range, void.carried_to) = (turn(void.range), turn(void.carried_to));
    }
    other.cover.voids.reverse();
    other
}

fn load(b: &Bridge) -> f64 {
    let mut b = b.clone();
    b.plan.method = Method::Limit;
    assess::analysis::as_described(&b, None, &mut mechanics::watch::Unwatched).unwrap().collapse_load.unwrap()
}

fn profiles() -> Vec<(Profile, f64)> {
    vec![
        (Profile::Segmental, 2.0),
        (Profile::Parabolic, 2.0),
        (Profile::Elliptical, 2.0),
        (Profile::ThreeCentred { haunch_radius: 1.0 }, 2.4),
    ]
}

#[test]
fn the_load_follows_the_springings_through_zero() {
    for (profile, rise) in profiles() {
        let at = |right: f64| load(&sloping(profile.clone(), rise, right));
        let level = at(0.0);
        for right in [1e-6, -1e-6] {
            assert!((at(right) / level - 1.0).abs() < 1e-5, "{profile:?} {right}: {} {level}", at(right));
        }
        // A centimetre to either side: the load changes by a slope, without a step at zero.
        let [below, above] = [at(-0.01) / level - 1.0, at(0.01) / level - 1.0];
        assert!(below.abs() < 0.02 && above.abs() < 0.02, "{profile:?}: {below} {above}");
        assert!((below + above).abs() < 0.25 * (below - above).abs() + 1e-4, "{profile:?}: {below} {above}");
    }
}

#[test]
fn the_load_does_not_depend_on_the_hand() {
    for (profile, rise) in profiles() {
        let b = sloping(profile.clone(), rise, 0.6);
        let (one, other) = (load(&b), load(&mirrored(&b)));
        assert!((one / other - 1.0).abs() < 1e-7, "{profile:?}: {one} {other}");
    }
    let b = viaduct();
    let (one, other) = (load(&b), load(&mirrored(&b)));
    assert!((one / other - 1.0).abs() < 1e-7, "{one} {other}");
}

/// The same arch by points of its circle: a segment between unequal springings is a piece of a longer symmetric one.
#[test]
fn an_arch_cut_from_a_longer_one_is_the_arch_by_points() {
    let (radius, start, end) = (6.0f64, -0.85f64, 0.55f64);
    let point = |angle: f64| [radius * (angle.sin() - start.sin()), radius * (angle.cos() - start.cos())];
    let points: Vec<[f64; 2]> = (0..=60).map(|k| point(start + (end - start) * f64::from(k) / 60.0)).collect();
    let [span, right] = points[60];
    // Of the middle of the span above the line between the springings.
    let across = 0.5 * (start.sin() + end.sin());
    let rise = radius * ((1.0 - across * across).sqrt() - 0.5 * (start.cos() + end.cos()));
    let mut by_rise = sloping(Profile::Segmental, rise, right);
    by_rise.spans[0].span = span;
    let mut by_points = by_rise.clone();
    by_points.spans[0].profile = Profile::Measured { points };
    // And cut from a symmetric arch with springings at -0.85 and 0.85: 34 voussoirs, of which 28 are left.
    by_rise.spans[0].rings = vec![ring(0.5, 28)];
    by_points.spans[0].rings = vec![ring(0.5, 28)];
    let (one, other) = (load(&by_rise), load(&by_points));
    assert!((one / other - 1.0).abs() < 1e-6, "{one} {other}");
    let mut long = by_rise.clone();
    let half = radius * 0.85f64.sin();
    (long.spans[0].span, long.spans[0].rise, long.spans[0].right_springing) =
        (2.0 * half, radius * (1.0 - 0.85f64.cos()), 0.0);
    long.spans[0].rings = vec![ring(0.5, 34)];
    let [cut, whole] = [&by_rise, &long].map(|b| discretise(b).unwrap());
    let ring_of = |d: &super::Discretised| -> Vec<Vec2> {
        d.faces.iter().flatten().flat_map(|f| [f.bed[0], f.back[0]]).collect()
    };
    for (a, b) in ring_of(&cut).iter().zip(ring_of(&whole)) {
        assert!((*a - b).norm() < 1e-9, "{a:?} {b:?}");
    }
}

/// Virtual work over every mechanism of four hinges, as one would by hand: rigid voussoirs that do not slide, a bare ring.
#[test]
fn the_load_is_that_of_the_governing_mechanism() {
    for (right, position) in [(0.9, 2.4), (-0.9, 2.4), (0.9, 5.9)] {
        let mut b = sloping(Profile::Segmental, 1.8, right);
        (b.cover.layers, b.cover.depth, b.fill_pressure) = (Vec::new(), 0.0, None);
        b.spans[0].rings = vec![ring(0.5, 16)];
        b.joint.friction_angle = 1.4;
        b.dispersal.rule = bridge::DispersalRule::None;
        b.loads[0].position = position;
        b.loads[0].kind = bridge::LoadKind::KnifeEdge { force: 1e3, length: 0.0 };
        b.plan.friction = Friction::Associated;
        let d = discretise(&b).unwrap();
        let faces: Vec<super::Faces> = d.faces.iter().flatten().copied().collect();
        let stones: Vec<(Vec2, f64)> = d
            .model
            .blocks
            .iter()
            .zip(d.faces.iter())
            .filter(|(_, face)| face.is_some())
            .map(|(block, _)| (block.outline.centroid(), block.outline.area() * 2100.0 * 9.81))
            .collect();
        // Both edges of every joint from the left springing.
        let mut joints: Vec<[Vec2; 2]> = faces.iter().map(|f| [f.bed[0], f.back[0]]).collect();
        joints.push(faces.last().map(|f| [f.bed[1], f.back[1]]).unwrap());
        let loaded = faces.iter().position(|f| f.back[0].x <= position && position <= f.back[1].x).unwrap();
        let on = {
            let [p, q] = faces[loaded].back;
            p + (q - p) * ((position - p.x) / (q.x - p.x))
        };
        let mut least = f64::INFINITY;
        let n = joints.len();
        let meet = |[a, b]: [Vec2; 2], [c, e]: [Vec2; 2]| {
            let (u, v) = (b - a, e - c);
            a + u * ((c - a).cross(v) / u.cross(v))
        };
        for i in 0..n {
            for j in i + 1..n {
                for k in j + 1..n {
                    for l in k + 1..n {
                        for first in [0, 1] {
                            let hinges =
                                [joints[i][first], joints[j][1 - first], joints[k][first], joints[l][1 - first]];
                            let centre = meet([hinges[0], hinges[1]], [hinges[2], hinges[3]]);
                            // Rotations of the three bodies about the first hinge, the centre and the last hinge.
                            let arm = |from: Vec2, to: Vec2, about: Vec2| {
                                (about - from).dot(to - from) / (about - from).dot(about - from)
                            };
                            let share = |hinge: Vec2, pivot: Vec2| {
                                // The hinge moves alike on both bodies: rotation about the pivot over that about the centre.
                                arm(hinge, centre, pivot)
                            };
                            let [one, three] = [share(hinges[1], hinges[0]), share(hinges[2], hinges[3])];
                            for sense in [1.0, -1.0] {
                                let turns = [0.0, sense * one, sense, sense * three, 0.0];
                                let pivots = [hinges[0], hinges[0], centre, hinges[3], hinges[3]];
                                // A joint that turns counter-clockwise from its left to its right side opens at the extrados.
                                let opens = (0..4).all(|h| {
                                    let relative = turns[h + 1] - turns[h];
                                    let at_bed = (h % 2 == 0) == (first == 0);
                                    if at_bed { relative < -1e-12 } else { relative > 1e-12 }
                                });
                                if !opens {
                                    continue;
                                }
                                let sinks = |stone: usize, at: Vec2| {
                                    let body = [i, j, k, l].iter().filter(|joint| **joint <= stone).count();
                                    -turns[body] * (at - pivots[body]).x
                                };
                                let work = sinks(loaded, on);
                                let weight: f64 = stones.iter().enumerate().map(|(s, (at, w))| w * sinks(s, *at)).sum();
                                if work > 1e-9 {
                                    least = least.min(-weight / work);
                                }
                            }
                        }
                    }
                }
            }
        }
        let found = load(&b);
        assert!((found / least - 1.0).abs() < 1e-6, "{right} {position}: {found} {least}");
    }
}

#[test]
fn weights_are_those_of_areas() {
    // A segment: its ring by the angle between the springings and the mean radius, voussoirs with straight faces.
    let mut b = sloping(Profile::Segmental, 2.0, 0.8);
    b.spans[0].rings = vec![ring(0.5, 300)];
    let d = discretise(&b).unwrap();
    let area: f64 = d
        .model
        .blocks
        .iter()
        .zip(d.faces.iter())
        .filter(|(_, face)| face.is_some())
        .map(|(block, _)| block.outline.area())
        .sum();
    let intrados = b.spans[0].intrados().unwrap();
    let radius = intrados.circle().unwrap();
    let wanted = intrados.length() * (radius + 0.25) / radius * 0.5;
    assert!((area / wanted - 1.0).abs() < 1e-5, "{area} {wanted}");
    // Cover and sloping backing on the viaduct: columns summed one by one.
    let mut b = viaduct();
    b.cover.internal_walls = Some(bridge::InternalWalls { height: 1.1, density: 700.0, share: 0.3 });
    let d = discretise(&b).unwrap();
    let points: Vec<Vec2> = springings(&b).into_iter().flatten().collect();
    let line = |x: f64| {
        let k = points.partition_point(|p| p.x < x).clamp(1, points.len() - 1);
        let (a, b) = (points[k - 1], points[k]);
        if x <= points[0].x {
            points[0].y
        } else if x >= points[points.len() - 1].x {
            points[points.len() - 1].y
        } else {
            a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x)
        }
    };
    let (mut weight, mut moment) = (0.0, 0.0);
    let road = d.extrados.crown() + 0.4;
    for back in d.extrados.stretches.iter().filter(|s| !s.ground) {
        const STEPS: usize = 4000;
        let step = (back.right.x - back.left.x) / STEPS as f64;
        for k in 0..STEPS {
            let p = back.at(back.left.x + step * (k as f64 + 0.5));
            let (backing, walls) = ((line(p.x) + 0.7).max(p.y), (line(p.x) + 1.1).max(p.y));
            let density = samples::backing(0.7).density;
            let force = 9.81
                * step
                * (density * (backing - p.y)
                    + 700.0 * (walls.max(backing) - backing)
                    + 1800.0 * (road - walls.max(backing)));
            (weight, moment) = (weight + force, moment + force * p.x);
        }
    }
    let force: f64 = d.loading.permanent.iter().map(|f| -f.force.y).sum();
    let turned: f64 = d.loading.permanent.iter().map(|f| -f.force.y * f.at.x).sum();
    assert!((force / weight - 1.0).abs() < 1e-6 && (turned / moment - 1.0).abs() < 1e-6, "{force} {weight}");
}

#[test]
fn meshes_of_gradients_have_the_area_of_the_bridge_and_do_not_depend_on_the_hand() {
    let area = |m: &mesh::Meshed| -> f64 {
        let quads = m.mesh.quads.iter().map(|quad| {
            let [a, b, c, e] = quad.nodes.map(|node| m.mesh.nodes[node]);
            0.5 * (c - a).cross(e - b)
        });
        quads.sum()
    };
    let mut b = viaduct();
    b.spans.iter_mut().for_each(|span| span.rings = vec![ring(0.4, 25)]);
    let one = mesh::mesh(&b).unwrap();
    let other = mesh::mesh(&mirrored(&b)).unwrap();
    assert!((area(&one) / area(&other) - 1.0).abs() < 1e-9, "{} {}", area(&one), area(&other));
    assert_eq!(one.mesh.nodes.len(), other.mesh.nodes.len());
    assert!(one.quality.scaled_jacobian > 0.1, "{:?}", one.quality);
    let ends = springings(&b);
    for (sets, [left, right]) in one.sets.spans.iter().zip(&ends) {
        assert!((sets.springings_at[0] - *left).norm() < 1e-9 && (sets.springings_at[1] - *right).norm() < 1e-9);
    }
}

#[test]
fn springings_follow_one_another() {
    let b = viaduct();
    let ends = springings(&b);
    assert_eq!(ends[0], [Vec2::ZERO, vec2(8.0, 0.25)]);
    assert!((ends[1][0] - vec2(9.4, 0.3)).norm() < 1e-12 && (ends[1][1] - vec2(15.4, 0.45)).norm() < 1e-12);
    assert!((ends[2][0] - vec2(16.7, 0.35)).norm() < 1e-12 && (ends[2][1] - vec2(24.7, 0.15)).norm() < 1e-12);
    // Piers stand below the lower one of their springings.
    let d = discretise(&b).unwrap();
    let feet: Vec<f64> = d
        .origins
        .pairs()
        .filter(|(_, origin)| matches!(origin, super::Origin::Foundation { .. }))
        .map(|(id, _)| d.model.blocks[id].outline.bounds().1.y)
        .collect();
    assert!((feet[0] - (0.25 - 4.0)).abs() < 1e-12 && (feet[1] - (0.35 - 5.0)).abs() < 1e-12, "{feet:?}");
}

#[test]
fn what_reaches_up_to_one_level_says_so() {
    let mut b = viaduct();
    b.cover.backing = Some(Backing { body: BackingBody::Blocks, ..samples::backing(0.7) });
    assert_eq!(discretise(&b), Err(DiscretiseError::SpringingsNotLevel { what: "backing as blocks" }));
}
