//! Hollow spandrels: voids, internal walls, backing over a share of the width.

use super::{DiscretiseError, Origin, discretise};
use crate::samples;
use bridge::{BackingBody, Bridge, InternalWalls, Method, Void};
use mechanics::blocks::PointForce;

fn filled() -> Bridge {
    let mut b = samples::case_two();
    b.loads[0].position = 2.6;
    b
}

const VOID: Void = Void { range: [1.0, 3.4], levels: [1.9, 3.1], carried_to: [0.8, 3.6] };

fn sums(forces: &[PointForce]) -> [f64; 2] {
    forces.iter().fold([0.0, 0.0], |[force, moment], f| [force - f.force.y, moment - f.force.y * f.at.x])
}

fn load(b: &Bridge) -> f64 {
    let mut b = b.clone();
    b.plan.method = Method::Limit;
    assess::analysis::collapse_by_limit(&b, &mut mechanics::watch::Unwatched).unwrap().collapse_load.unwrap()
}

/// What a void takes off is the weight of the fill in it, and its roof keeps force and moment of what lies on it.
#[test]
fn a_void_weighs_nothing_and_hands_on_what_lies_over_it() {
    let (solid, mut hollow) = (filled(), filled());
    hollow.cover.voids = vec![VOID];
    let [solid, hollow] = [&solid, &hollow].map(|b| discretise(b).unwrap());
    let ([before, turned_before], [after, turned_after]) =
        (sums(&solid.loading.permanent), sums(&hollow.loading.permanent));
    let (mut weight, mut moment) = (0.0, 0.0);
    const STEPS: usize = 4000;
    let step = (VOID.range[1] - VOID.range[0]) / STEPS as f64;
    for k in 0..STEPS {
        let x = VOID.range[0] + step * (k as f64 + 0.5);
        let back = solid.extrados.stretches.iter().find(|s| s.left.x <= x && x <= s.right.x).unwrap().at(x).y;
        let force = 1890.0 * 9.81 * step * (VOID.levels[1] - VOID.levels[0].max(back));
        (weight, moment) = (weight + force, moment + force * x);
    }
    assert!(((before - after) / weight - 1.0).abs() < 1e-6, "{before} {after} {weight}");
    assert!(((turned_before - turned_after) / moment - 1.0).abs() < 1e-6, "{moment}");
}

/// A load over a void reaches the two places as under a beam, with its force and its moment, and nothing reaches the ring between them.
#[test]
fn a_load_over_a_void_is_carried_beside_it() {
    for rule in [bridge::DispersalRule::None, bridge::DispersalRule::Uniform, bridge::DispersalRule::Boussinesq] {
        let mut solid = filled();
        solid.dispersal.rule = rule;
        let mut hollow = solid.clone();
        hollow.cover.voids = vec![VOID];
        let [solid, hollow] = [&solid, &hollow].map(|b| discretise(b).unwrap());
        let ([force, moment], [kept, turned]) = (sums(&solid.spreads[0].forces), sums(&hollow.spreads[0].forces));
        assert!((kept / force - 1.0).abs() < 1e-9 && (turned / moment - 1.0).abs() < 1e-9, "{rule:?}");
        let inside = hollow.spreads[0].forces.iter().filter(|f| f.at.x > VOID.range[0] && f.at.x < VOID.range[1]);
        assert_eq!(inside.count(), 0, "{rule:?}");
    }
}

#[test]
fn an_empty_void_changes_nothing_and_a_growing_one_the_load_continuously() {
    let at = |roof: f64| {
        let mut b = filled();
        b.cover.voids = vec![Void { range: [1.0, 1.0 + roof], ..VOID }];
        load(&b)
    };
    let solid = load(&filled());
    assert!((at(1e-7) / solid - 1.0).abs() < 1e-5, "{} {solid}", at(1e-7));
    let (one, other) = (at(1.0), at(1.001));
    assert!((one / other - 1.0).abs() < 3e-3, "{one} {other}");
}

#[test]
fn the_load_with_a_void_does_not_depend_on_the_hand() {
    let mut b = filled();
    b.cover.voids = vec![VOID];
    let mut other = b.clone();
    let turn = |[from, to]: [f64; 2]| [18.3 - to, 18.3 - from];
    other.cover.voids[0] = Void { range: turn(VOID.range), carried_to: turn(VOID.carried_to), ..VOID };
    other.loads[0].position = 18.3 - b.loads[0].position;
    let (one, other) = (load(&b), load(&other));
    assert!((one / other - 1.0).abs() < 1e-7, "{one} {other}");
}

#[test]
fn voids_that_cannot_be_are_named() {
    let refused = |void: Void| {
        let mut b = filled();
        b.cover.voids = vec![void];
        discretise(&b).unwrap_err()
    };
    assert!(matches!(refused(Void { levels: [0.2, 1.0], ..VOID }), DiscretiseError::VoidInRing { void: 1, .. }));
    assert!(matches!(refused(Void { levels: [1.9, 3.9], ..VOID }), DiscretiseError::VoidAboveFill { void: 1, .. }));
    assert!(matches!(
        refused(Void { carried_to: [-9.0, 3.6], ..VOID }),
        DiscretiseError::VoidBesideBridge { void: 1, .. }
    ));
}

/// Walls over a share of the width weigh as a layer of their mean density; backing of blocks over a share has its share of cohesion.
#[test]
fn walls_and_backing_are_means_over_the_width() {
    let mut walled = filled();
    walled.cover.internal_walls = Some(InternalWalls { height: 2.0, density: 900.0, share: 0.3 });
    let mut backed = filled();
    backed.cover.backing = Some(bridge::Backing { density: 900.0, ..samples::backing(2.0) });
    let [one, other] = [&walled, &backed].map(|b| discretise(b).unwrap());
    assert_eq!(one.loading.permanent, other.loading.permanent);
    let mut blocks = filled();
    blocks.joint.cohesion = 100e3;
    blocks.masonry.compressive_strength = Some(5e6);
    blocks.cover.backing =
        Some(bridge::Backing { body: BackingBody::Blocks, width_share: 0.3, ..samples::backing(1.5) });
    let d = discretise(&blocks).unwrap();
    let group = |wanted: fn(&Origin) -> bool| {
        let block = d.origins.pairs().find(|(_, origin)| wanted(origin)).unwrap().0;
        d.model.blocks[block].group
    };
    let backing = group(|origin| matches!(origin, Origin::Backing { .. }));
    let voussoir = group(|origin| matches!(origin, Origin::Voussoir { .. }));
    for other in [backing, voussoir] {
        let law = d.model.laws.between(backing, other);
        assert_eq!((law.cohesion, law.crushing, law.friction), (30e3, 1.5e6, 35.6f64.to_radians().tan()));
    }
    assert_eq!(d.model.laws.between(voussoir, voussoir).cohesion, 100e3);
}
