//! What a bridge has been through before the loads come: joints that stand open, stones that dropped, supports that moved, water in the fill.

use super::*;
use crate::samples;
use bridge::defect::{Defect, DefectKind, Face};
use bridge::ring::Profile;
use bridge::{Dispersal, DispersalRule, PoreWater, Ring, Span, SupportMovement};
use mechanics::watch::Unwatched;
use outcome::collapse::Status;
use outcome::note::{Note, State};

/// Bridgemill by limit analysis, with points at the edges of sharp stones.
fn sound() -> Bridge {
    let mut b = samples::case_two();
    b.plan.method = Method::Limit;
    b.plan.friction = bridge::Friction::Associated;
    b.masonry.rounding = 0.0;
    b.masonry.compressive_strength = None;
    b.dispersal = Dispersal { rule: DispersalRule::Uniform, slope: 2.0 };
    b
}

fn load(b: &Bridge) -> f64 {
    let found = collapse(b, None, &mut Unwatched).unwrap();
    match found.status {
        Status::Collapsed => found.carried().unwrap(),
        Status::UnstableUnderSelfWeight => 0.0,
        other => panic!("{other:?}"),
    }
}

fn with(b: &Bridge, kind: DefectKind, shares: [f64; 2]) -> Bridge {
    let mut b = b.clone();
    let from_to = shares.map(|share| share * b.spans[0].span);
    b.spans[0].defects.push(Defect { kind, from_to, shares });
    b
}

fn near(found: f64, expected: f64, share: f64) {
    assert!((found / expected - 1.0).abs() < share, "{found} in place of {expected}");
}

fn open(at: f64, face: Face, depth: f64) -> impl Fn(&Bridge) -> Bridge {
    move |b| with(b, DefectKind::OpenJoint { face, depth }, [at, at])
}

/// A joint that stands open never helps, opens no jump where its place passes the middle of a stone, and has no side.
#[test]
fn an_open_joint_never_helps_and_moves_without_jumps() {
    let b = sound();
    let (all, n) = (load(&b), b.spans[0].rings[0].voussoirs as f64);
    let mut loads: Vec<f64> = Vec::new();
    for step in 0..=16 {
        let at = 0.25 + f64::from(step) / (8.0 * n);
        let found = load(&open(at, Face::Extrados, 0.4)(&b));
        assert!(found <= all * (1.0 + 1e-6), "{at}: {found} of {all}");
        loads.push(found);
    }
    assert!(loads.iter().any(|found| *found < 0.98 * all), "{loads:?} of {all}");
    // An eighth of a stone closes at most a quarter of the depth.
    assert!(loads.windows(2).all(|pair| (pair[1] / pair[0] - 1.0).abs() < 0.2), "{loads:?}");
    let mut before = all;
    for depth in [0.1, 0.3, 0.5, 0.65] {
        let found = load(&open(0.25, Face::Extrados, depth)(&b));
        assert!(found <= before * (1.0 + 1e-6), "{depth}: {found} after {before}");
        before = found;
    }
    let mut mirrored = b.clone();
    mirrored.loads[0].position = b.spans[0].span - b.loads[0].position;
    near(load(&open(0.3, Face::Intrados, 0.3)(&b)), load(&open(0.7, Face::Intrados, 0.3)(&mirrored)), 1e-7);
}

/// A ring that is open to all but a sliver at three joints is an arch of three hinges, and the load that it carries follows from statics: a
/// fourth hinge forms where the line of thrust through the three reaches an edge.
#[test]
fn open_joints_take_the_thrust_to_their_edges() {
    let b = sound();
    let joints = b.spans[0].rings[0].voussoirs;
    let t = b.spans[0].rings[0].crown_thickness;
    let sliver = 0.02;
    let deep = t - sliver;
    // At the crown's extrados and the springings' intrados: hinges of an arch that has spread.
    let crown = (joints / 2) as f64 / joints as f64;
    let mut spread = open(crown, Face::Intrados, deep)(&b);
    spread = open(0.0, Face::Extrados, deep)(&spread);
    spread = open(1.0, Face::Extrados, deep)(&spread);
    let found = collapse(&spread, None, &mut Unwatched).unwrap();
    let three = found.carried().unwrap();
    assert!(three < load(&b), "{three}");
    // By hand: the thrust through the three hinges under dead load and load P, and the load at which it touches an edge, by bisection on the
    // blocks of the model.
    let d = structure::discretise::discretise(&spread).unwrap();
    let hand = by_hand(&d, t, sliver);
    near(three, hand, 0.01);
}

/// Largest load that an arch of three hinges carries, wherever in the slivers that its springings' intrados and its crown's extrados leave they
/// lie: it is largest with each of them at an end of its sliver, or in between.
fn by_hand(d: &structure::discretise::Discretised, thickness: f64, sliver: f64) -> f64 {
    let places = [0.0, 0.5, 1.0].map(|share| share * sliver);
    let mut most = 0.0f64;
    for a in places {
        for c in places {
            for e in places {
                most = most.max(three_hinges(d, thickness, [a, thickness - c, e]));
            }
        }
    }
    most
}

/// Load at which the thrust through three hinges, so far above the intrados, touches an edge elsewhere.
fn three_hinges(d: &structure::discretise::Discretised, thickness: f64, above: [f64; 3]) -> f64 {
    use mechanics::plane::Vec2;
    let is_stone =
        |origin: &structure::discretise::Origin| matches!(origin, structure::discretise::Origin::Voussoir { .. });
    let stones: Vec<_> = d.origins.pairs().filter(|(_, origin)| is_stone(origin)).map(|(id, _)| id).collect();
    // Joints from left to right: lower and upper ends.
    let faces: Vec<_> = stones.iter().map(|id| d.faces[*id].unwrap()).collect();
    let mut joints: Vec<[Vec2; 2]> = faces.iter().map(|f| [f.bed[0], f.back[0]]).collect();
    let last = faces[faces.len() - 1];
    joints.push([last.bed[1], last.back[1]]);
    let (crown, end) = ((joints.len() - 1) / 2, joints.len() - 1);
    let at = |k: usize, above: f64| joints[k][0] + (joints[k][1] - joints[k][0]) * (above / thickness);
    let [a, c, e] = [at(0, above[0]), at(crown, above[1]), at(end, above[2])];
    // Vertical forces: stone, place, size.
    let acting = |factor: f64| -> Vec<(usize, f64, f64)> {
        let of = |(k, id): (usize, &mechanics::ids::BlockId)| {
            let block = &d.model.blocks[*id];
            let own = (k, block.outline.centroid().x, -block.mass() * d.model.gravity.y);
            let on = |forces: &[mechanics::blocks::PointForce], factor: f64| -> Vec<(usize, f64, f64)> {
                forces.iter().filter(|f| f.block == *id).map(|f| (k, f.at.x, -factor * f.force.y)).collect()
            };
            [vec![own], on(&d.loading.permanent, 1.0), on(&d.loading.variable, factor)].concat()
        };
        stones.iter().enumerate().flat_map(of).collect()
    };
    let stands = |factor: f64| {
        let forces = acting(factor);
        let moment = |about: Vec2, upto: usize| -> f64 {
            forces.iter().filter(|f| f.0 < upto).map(|f| f.2 * (about.x - f.1)).sum()
        };
        // Vertical reaction and thrust at the left hinge: moments about the other two.
        let (p, q) = (e - a, c - a);
        let (whole, left) = (moment(e, end), moment(c, crown));
        let det = -p.x * q.y + p.y * q.x;
        let (vertical, thrust) = ((-whole * q.y + p.y * left) / det, (p.x * left - q.x * whole) / det);
        (1..end).filter(|k| *k != crown).all(|k| {
            let [low, high] = joints[k];
            let below: f64 = forces.iter().filter(|f| f.0 < k).map(|f| f.2).sum();
            let about = vertical * (low.x - a.x) - thrust * (low.y - a.y) - moment(low, k);
            let across = (high - low) * (1.0 / thickness);
            let normal = thrust * across.y - (vertical - below) * across.x;
            let place = about / normal;
            normal > 0.0 && place > -1e-9 && place < thickness + 1e-9
        })
    };
    if !stands(0.0) {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, 1e4);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if stands(middle) { low = middle } else { high = middle }
    }
    low * d.reference_load
}

/// Stones that dropped bear on what overlaps: over the whole ring that is the same ring without its upper part, as heavy as before.
#[test]
fn dropped_stones_bear_on_what_overlaps() {
    let b = sound();
    let dropped = with(&b, DefectKind::DroppedStones { depth: 0.12 }, [0.4, 0.6]);
    let bare = with(&b, DefectKind::LostMortar { face: Face::Extrados, depth: 0.12 }, [0.4, 0.6]);
    near(load(&dropped), load(&bare), 1e-12);
    assert!(load(&dropped) < load(&b));
}

fn moved(b: &Bridge, horizontal: f64, vertical: f64, by: f64) -> Bridge {
    let mut b = b.clone();
    b.plan.support_movement = Some(SupportMovement {
        support: 1,
        horizontal,
        vertical,
        rotation: 0.0,
        before: Some(by),
        increment: None,
        limit: None,
    });
    b
}

/// A deep arch whose support can move far.
fn semicircle() -> Bridge {
    let mut b = sound();
    let ring = Ring { crown_thickness: 0.9, springing_thickness: 0.9, voussoirs: 36 };
    b.spans[0] = Span {
        right_springing: 0.0,
        profile: Profile::Semicircular,
        span: 9.0,
        rise: 4.5,
        rings: vec![ring],
        defects: Vec::new(),
        skew: 0.0,
    };
    b.cover.layers.clear();
    b.cover.depth = 0.0;
    b.loads[0].position = 2.5;
    b
}

/// The load follows the movement from that of the bridge as built, without a jump: abutments that come nearer lower it more and more, what
/// helps is not counted, and a bridge that the movement alone brings down is refused.
#[test]
fn the_load_falls_with_a_support_that_has_moved() {
    for b in [sound(), semicircle()] {
        let all = load(&b);
        near(load(&moved(&b, -1.0, 0.0, 1e-6)), all, 1e-4);
        let mut before = all;
        for by in [0.02, 0.04, 0.08] {
            let found = load(&moved(&b, -1.0, 0.0, by));
            assert!(found < before && found > 0.8 * before, "{by}: {found} after {before}");
            before = found;
        }
        assert!(load(&moved(&b, 1.0, 0.0, 0.05)) <= all * (1.0 + 1e-9));
    }
    let b = semicircle();
    let mut fall = moved(&b, 1.0, 0.0, 1.0);
    fall.plan.analysis = bridge::Analysis::SupportMovement;
    fall.plan.support_movement.as_mut().unwrap().limit = Some(5.0);
    let falls = collapse(&fall, None, &mut Unwatched).unwrap();
    let stands = falls.support().unwrap().last_stable.unwrap();
    assert!(collapse(&moved(&b, 1.0, 0.0, 0.9 * stands), None, &mut Unwatched).is_ok());
    let beyond = collapse(&moved(&b, 1.0, 0.0, 1.05 * stands), None, &mut Unwatched);
    assert!(beyond.is_err_and(|error| error.to_string().contains("falls before its support has moved")));
}

/// A joint that stands open and a support that has moved, together: neither takes the other's effect away.
#[test]
fn a_moved_bridge_may_have_open_joints() {
    let b = sound();
    let open = open(0.27, Face::Extrados, 0.4);
    let both = load(&open(&moved(&b, -1.0, 0.0, 0.05)));
    assert!(both < load(&open(&b)) && both < load(&moved(&b, -1.0, 0.0, 0.05)), "{both}");
}

/// The mirrored bridge whose left abutment gives carries the same; what helps is not counted.
#[test]
fn a_moved_support_has_no_side_and_never_helps() {
    let b = sound();
    let mut left = moved(&b, 1.0, 0.0, 0.05);
    left.plan.support_movement.as_mut().unwrap().support = 0;
    left.loads[0].position = b.spans[0].span - b.loads[0].position;
    near(load(&moved(&b, -1.0, 0.0, 0.05)), load(&left), 1e-6);
    let all = load(&b);
    for (x, y) in [(-1.0, 0.0), (0.0, -1.0), (0.0, 1.0), (1.0, -1.0)] {
        let found = collapse(&moved(&b, x, y, 0.03), None, &mut Unwatched).unwrap();
        assert!(found.carried().unwrap() <= all * (1.0 + 1e-9), "{x} {y}");
        let told = &found.not_counted;
        let hurts = found.assumptions.iter().any(|said| {
            matches!(said, Note::State(State::Counted { helps, .. }) if helps[..] == [outcome::help::Help::Movement])
        });
        assert!(told.left_out == [outcome::help::Help::Movement] || hurts || told.left_out.is_empty(), "{told:?}");
    }
}

fn wet(b: &Bridge, level: f64, saturated_density: f64) -> Bridge {
    let mut b = b.clone();
    b.cover.water = Some(PoreWater { level, saturated_density });
    b
}

/// Water in the pores up to a level: the weight of the saturated column and the thrust of still water on a wall as high, by hand.
#[test]
fn water_weighs_and_presses_as_water_does() {
    let b = sound();
    let d = structure::discretise::discretise(&b).unwrap();
    let backs: Vec<_> = d.extrados.stretches.iter().filter(|stretch| !stretch.ground).collect();
    let low = backs[0].left.y;
    let level = low + 1.4;
    let saturated = b.cover.layers[0].density + 250.0;
    let w = structure::discretise::discretise(&wet(&b, level, saturated)).unwrap();
    let sum = |d: &structure::discretise::Discretised| d.loading.permanent.iter().map(|f| -f.force.y).sum::<f64>();
    // Area between the level and the backs, on both sides.
    let area: f64 = backs
        .iter()
        .map(|s| {
            let (a, b) = ((level - s.left.y), (level - s.right.y));
            let run = s.right.x - s.left.x;
            match (a > 0.0, b > 0.0) {
                (true, true) => 0.5 * (a + b) * run,
                (true, false) => 0.5 * a * run * a / (a - b),
                (false, true) => 0.5 * b * run * b / (b - a),
                _ => 0.0,
            }
        })
        .sum();
    near(sum(&w) - sum(&d), 250.0 * b.gravity * area, 1e-9);
    let rightwards: f64 = w.loading.permanent.iter().map(|f| f.force.x.max(0.0)).sum();
    near(rightwards, 0.5 * 1000.0 * b.gravity * 1.4 * 1.4, 1e-9);
    let all: f64 = w.loading.permanent.iter().map(|f| f.force.x).sum();
    assert!(all.abs() < 1e-9 * rightwards, "{all}");
}

/// Water never counts as help, and a level below every back changes nothing. With fill that presses, grains press with what the water leaves
/// of the weight: fill of one and a half times the density of water's excess is checked against coefficients by hand.
#[test]
fn water_that_helps_is_not_counted() {
    let mut b = sound();
    let dry = load(&b);
    near(load(&wet(&b, -5.0, 2200.0)), dry, 1e-12);
    let raised = collapse(&wet(&b, 3.0, 2200.0), None, &mut Unwatched).unwrap();
    assert!(raised.carried().unwrap() <= dry * (1.0 + 1e-12));
    assert_eq!(raised.not_counted.left_out, [outcome::help::Help::Water]);
    assert!(raised.not_counted.with_help[0].headline.unwrap() > dry);
    b.fill_pressure = Some(bridge::FillPressure {
        applies: true,
        friction_angle: 30f64.to_radians(),
        cohesion: 0.0,
        mobilisation: 0.5,
        cohesion_mobilisation: 0.0,
        least: bridge::LeastPressure::AtRest,
        half_movement: 0.02,
    });
    let level = 100.0;
    // Under water throughout, fill of saturated density s presses as drained fill of density s - 1000, beside the water itself.
    let drowned = wet(&b, level, 1900.0);
    let mut light = b.clone();
    light.cover.layers[0].density = 900.0;
    let of = |b: &Bridge| {
        let d = structure::discretise::discretise(b).unwrap();
        structure::discretise::pressure::restraints(b, &d.extrados)
    };
    let (wet, dry) = (of(&drowned), of(&light));
    assert_eq!(wet.len(), dry.len());
    for (one, other) in wet.iter().zip(&dry) {
        near(one.least, other.least, 1e-9);
        near(one.most, other.most, 1e-9);
    }
}
