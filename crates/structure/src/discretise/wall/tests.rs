//! Walls on random bridges are partitions into convex pieces; slivers are refused with their place.

use super::*;
use crate::discretise::{DiscretiseError, Discretised, Origin, discretise};
use crate::samples::{Dice, bridgemill, spans};
use bridge::ring::Profile;
use bridge::{Ring, Span, Strip};
use mechanics::blocks::interfaces;

/// Bricks of 0.40 x 0.60 m in half bond, from the road down.
pub(super) fn wall() -> SpandrelWall {
    SpandrelWall {
        brick_length: 0.6,
        brick_height: 0.4,
        thickness: 0.44,
        bond: 0.5,
        density: 2100.0,
        rounding: 0.01,
        joint: bridge::Joint { fixed_length: None, ..bridgemill().joint },
        top: None,
        extent: None,
        end_walls: false,
        courses_from: CoursesFrom::Top,
        head_joint: None,
        loaded_bricks: None,
        least_piece: 0.25,
    }
}

fn walled(mut bridge: Bridge, wall: SpandrelWall) -> Bridge {
    bridge.spandrel_wall = Some(wall);
    bridge.plan.strip = Strip::Wall;
    bridge
}

fn bricks(d: &Discretised) -> Vec<Polygon> {
    let is_brick = |o: &Origin| matches!(o, Origin::Brick { .. });
    d.origins.pairs().filter(|(_, o)| is_brick(o)).map(|(id, _)| d.model.blocks[id].outline.clone()).collect()
}

/// Area between the extrados and the wall's top, column by column.
fn region(d: &Discretised, ends: [f64; 2], top: f64) -> f64 {
    let column = |s: &crate::discretise::extrados::Stretch| {
        let (a, b) = (s.left.x.clamp(ends[0], ends[1]), s.right.x.clamp(ends[0], ends[1]));
        (b - a) * (top - 0.5 * (s.at(a).y + s.at(b).y))
    };
    d.extrados.stretches.iter().map(column).sum()
}

fn length(s: &crate::discretise::extrados::Stretch) -> f64 {
    (s.right - s.left).norm()
}

/// Area that two convex outlines share: one clipped by the edges of the other.
fn shared(a: &Polygon, b: &Polygon) -> f64 {
    let mut rest = a.vertices().to_vec();
    for (from, to) in b.edges() {
        let inside = |p: Vec2| (p - from).dot((to - from).left());
        let mut kept = Vec::new();
        for i in 0..rest.len() {
            let (p, q) = (rest[i], rest[(i + 1) % rest.len()]);
            if inside(p) >= 0.0 {
                kept.push(p);
            }
            if (inside(p) < 0.0) != (inside(q) < 0.0) {
                kept.push(p + (q - p) * (inside(p) / (inside(p) - inside(q))));
            }
        }
        rest = kept;
    }
    0.5 * (0..rest.len()).map(|i| rest[i].cross(rest[(i + 1) % rest.len()])).sum::<f64>()
}

/// Convexity is what a polygon is; the rest is checked here. Gives the number of pieces.
fn is_partition(bridge: &Bridge, d: &Discretised) -> usize {
    let road = d.road.as_ref().unwrap();
    let pieces = bricks(d);
    let (ends, top) = ([road.line[0].x, road.line[1].x], road.line[0].y);
    // Round-off of some hundred sums of products of coordinates of some tens of metres.
    let (sum, whole) = (pieces.iter().map(Polygon::area).sum::<f64>(), region(d, ends, top));
    assert!((sum - whole).abs() < 1e-9, "{sum} {whole}");
    let wall = bridge.spandrel_wall.as_ref().unwrap();
    // The least thickness as the input reference states it: a share of a brick or of a back, the mean of its span.
    let mut size = wall.brick_height.min(wall.brick_length);
    for span in 0..bridge.spans.len() {
        let own = |o: Origin| matches!(o, Origin::Voussoir { span: s, .. } if s == span);
        let backs: Vec<f64> = d.extrados.stretches.iter().filter(|s| own(d.origins[s.block])).map(length).collect();
        size = size.min(backs.iter().sum::<f64>() / backs.len() as f64);
    }
    let least = wall.least_piece * size;
    for piece in &pieces {
        assert!(thickness(piece) > least * (1.0 - 1e-6), "{piece:?}");
        assert!(piece.area() > least * least * (1.0 - 1e-6), "{piece:?}");
    }
    let all: Vec<&Polygon> = d.model.blocks.iter().map(|b| &b.outline).collect();
    for (i, a) in all.iter().enumerate() {
        let (low, high) = a.bounds();
        for b in &all[i + 1..] {
            let (l, h) = b.bounds();
            if l.x < high.x && low.x < h.x && l.y < high.y && low.y < h.y {
                assert!(shared(a, b) < 1e-9, "{a:?} {b:?}");
            }
        }
    }
    pieces.len()
}

fn random_span(dice: &mut Dice, kind: usize) -> Span {
    let span = dice.between(4.0, 20.0);
    let half = 0.5 * span;
    let (profile, rise) = match kind {
        0 => (Profile::Segmental, dice.between(0.3, 0.95) * half),
        1 => (Profile::Semicircular, half),
        2 => (Profile::Parabolic, dice.between(0.3, 1.0) * half),
        3 => (Profile::Elliptical, dice.between(0.4, 1.0) * half),
        4 => {
            let rise = dice.between(0.5, 0.9) * half;
            (Profile::ThreeCentred { haunch_radius: dice.between(0.4, 0.8) * rise }, rise)
        }
        _ => (Profile::Pointed, dice.between(1.1, 1.6) * half),
    };
    let thickness = span / dice.between(12.0, 25.0);
    let courses = dice.choose(&[1, 2]);
    // Backs between a third of a metre and as long as a brick.
    let voussoirs = (1.3 * span / dice.between(0.3, 0.6)) as usize;
    let ring = Ring { crown_thickness: thickness, springing_thickness: thickness * dice.between(1.0, 1.3), voussoirs };
    Span { profile, span, rise, rings: vec![ring; courses], defects: Vec::new(), skew: 0.0, right_springing: 0.0 }
}

fn random_bridge(dice: &mut Dice) -> Bridge {
    let count = dice.choose(&[1, 1, 2, 3]);
    let kind = dice.choose(&[0, 1, 2, 3, 4, 5]);
    let (one, same) = (random_span(dice, kind), dice.roll() < 0.5);
    let mut list = vec![one.clone()];
    for _ in 1..count {
        list.push(if same { one.clone() } else { random_span(dice, kind) });
    }
    let skew: f64 = list.iter().flat_map(|s| &s.rings).map(|r| r.springing_thickness).fold(0.0, f64::max);
    let width = 4.2 * skew + dice.between(0.2, 2.0);
    let mut bridge = spans(list, width, 1.1 * width, 3.0, 3);
    bridge.cover.depth = dice.between(0.2, 1.2);
    let small = dice.roll() < 0.4;
    let wall = SpandrelWall {
        brick_length: if small { 0.3 } else { dice.between(0.4, 0.8) },
        brick_height: if small { 0.2 } else { dice.between(0.25, 0.5) },
        bond: dice.choose(&[0.0, 1.0 / 3.0, 0.5]),
        courses_from: dice.choose(&[CoursesFrom::Top, CoursesFrom::Springings]),
        extent: dice.choose(&[None, Some(1.1)]),
        rounding: 0.005,
        ..wall()
    };
    walled(bridge, wall)
}

#[test]
fn random_walls_are_partitions_without_slivers() {
    let mut dice = Dice(20_260);
    let (mut cut, mut refused, mut reasons) = (0, 0, Vec::new());
    while cut + refused < 200 {
        let bridge = random_bridge(&mut dice);
        match discretise(&bridge) {
            Ok(d) => {
                is_partition(&bridge, &d);
                cut += 1;
            }
            Err(DiscretiseError::Wall(reason)) => {
                refused += 1;
                reasons.push(format!("{:?}: {reason}", bridge.spans[0].profile));
            }
            // Rings that cross above a pier, or curves that do not exist, are no bridge.
            Err(_) => {}
        }
    }
    assert!(refused <= 0, "{refused} refused:\n{}", reasons.join("\n"));
}

#[test]
fn bridgemill_walls_touch_every_back_below_them() {
    for (size, few, many) in [((0.6, 0.4), 180, 330), ((0.3, 0.2), 600, 1000)] {
        let bridge = walled(bridgemill(), SpandrelWall { brick_length: size.0, brick_height: size.1, ..wall() });
        let d = discretise(&bridge).unwrap();
        let pieces = is_partition(&bridge, &d);
        assert!((few..many).contains(&pieces), "{pieces}");
        let joints = interfaces(&d.model, 1e-9).unwrap();
        for (id, origin) in d.origins.pairs() {
            let touches = |want: fn(&Origin) -> bool| {
                joints.iter().any(|j| {
                    j.points.len() == 2
                        && ((j.first == id && want(&d.origins[j.second]))
                            || (j.second == id && want(&d.origins[j.first])))
                })
            };
            match origin {
                Origin::Voussoir { .. } => assert!(touches(|o| matches!(o, Origin::Brick { .. })), "{}", origin.name()),
                Origin::Brick { .. } => assert!(touches(|_| true), "{}", origin.name()),
                _ => {}
            }
        }
        // Weight of the wall: its area times density, 2100 kg/m^3; round-off of the sums.
        let road = d.road.as_ref().unwrap();
        let area = region(&d, [road.line[0].x, road.line[1].x], road.line[0].y);
        let ring: f64 = discretise(&bridgemill()).unwrap().model.free_weight();
        assert!((d.model.free_weight() - ring - 2100.0 * 9.81 * area).abs() < 1e-3);
        assert!(d.loading.permanent.is_empty());
    }
}

#[test]
fn walls_that_cannot_be_are_refused_with_a_reason() {
    let refused = |change: fn(&mut SpandrelWall)| {
        let mut wall = wall();
        change(&mut wall);
        match discretise(&walled(bridgemill(), wall)) {
            Err(DiscretiseError::Wall(reason)) => reason,
            other => panic!("{:?}", other.map(|d| d.model.blocks.len())),
        }
    };
    assert!(matches!(refused(|w| w.brick_length = 1e-6), WallError::TooMany { .. }));
    assert!(matches!(refused(|w| w.brick_height = 1e-9), WallError::TooMany { .. }));
    assert!(matches!(refused(|w| w.top = Some(0.01)), WallError::Low { x, .. } if (x - 9.15).abs() < 0.35));
    // Corners rounded by 80 mm leave nothing of pieces of 84 mm.
    assert!(matches!(refused(|w| w.rounding = 0.08), WallError::Outline { .. }));
}
