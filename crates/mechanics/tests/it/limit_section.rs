//! Blocks and sections with closed-form answers.

use crate::limit_models::{Ring, block, dry, model, sideways};
use mechanics::blocks::{BlockModel, ContactLaw, Held, LawTable, Loading, PointForce};
use mechanics::ids::{BlockId, Id};
use mechanics::limit::{
    ContactPoints, Friction, Ground, Least, Settings, Status, collapse_load, least_thrust, thrust_zone,
};
use mechanics::plane::{Polygon, Vec2, vec2};

fn rectangle(x: f64, y: f64, width: f64, height: f64) -> Polygon {
    Polygon::rectangle(vec2(x, y), width, height).unwrap()
}

/// A block of width 0.25 m and height 1 m on the ground.
fn standing(friction: f64) -> BlockModel {
    let ground = block(rectangle(-1.0, -0.5, 3.0, 0.5), 0.0, 1.0, Held::FIXED);
    model(vec![ground, block(rectangle(0.0, 0.0, 0.25, 1.0), 0.0, 2000.0, Held::FREE)], dry(friction))
}

#[test]
fn a_block_overturns_at_its_slenderness_or_slides_at_its_friction() {
    for (friction, expected) in [(0.7, 0.25), (0.2, 0.2)] {
        for rule in [Friction::Associated, Friction::Automatic] {
            let model = standing(friction);
            let loading = Loading { variable: sideways(&model), ..Loading::default() };
            let settings = Settings { friction: rule, ..Settings::default() };
            let outcome = collapse_load(&model, &loading, &settings).unwrap();
            assert_eq!(outcome.status, Status::Solved);
            // Exact; ten times the tolerance of the solver.
            assert!((outcome.factor.unwrap() - expected).abs() < 1e-8, "{friction} {rule:?} {:?}", outcome.factor);
            let mechanism = outcome.mechanism.unwrap();
            let slides = friction < 0.25;
            assert_eq!((mechanism.hinges.len(), mechanism.sliding.len()), (usize::from(!slides), usize::from(slides)));
            let level = slides && rule == Friction::Automatic;
            assert_eq!(outcome.friction, if level { Friction::NonAssociated } else { Friction::Associated });
            // Non-associated sliding is level, associated sliding climbs by the coefficient of friction.
            if slides {
                let (v, _) = mechanism.velocities[BlockId::new(1)];
                assert!((v.y / v.x - if level { 0.0 } else { friction }).abs() < 1e-6, "{v:?}");
            }
        }
    }
}

/// A block about to overturn touches the ground along an edge: cohesion holds it only where it is pressed, over thrust over strength,
/// which is friction larger by cohesion over strength; along the whole joint it would hold anything.
#[test]
fn cohesion_does_not_hold_a_joint_that_has_opened() {
    for (cohesion, crushing, expected) in
        [(0.0, 10e6, 0.1), (1e6, 10e6, 0.2), (1e6, f64::INFINITY, 0.1), (2e6, 10e6, 0.25)]
    {
        let law = ContactLaw { cohesion, crushing, ..dry(0.1) };
        let model = BlockModel { laws: LawTable::uniform(1, law), ..standing(0.1) };
        let loading = Loading { variable: sideways(&model), ..Loading::default() };
        let factor = collapse_load(&model, &loading, &Settings::default()).unwrap().factor.unwrap();
        assert!((factor - expected).abs() < 1e-6, "{cohesion} {crushing}: {factor}, not {expected}");
    }
}

#[test]
fn a_block_tilts_over_at_14_degrees() {
    let stands = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let model = BlockModel { gravity: vec2(9.81 * sin, -9.81 * cos), ..standing(0.7) };
        let push = PointForce { block: BlockId::new(1), at: vec2(0.1, 0.5), force: vec2(1.0, 0.0) };
        let loading = Loading { variable: vec![push], ..Loading::default() };
        let outcome = collapse_load(&model, &loading, &Settings::default()).unwrap();
        assert!(matches!(outcome.status, Status::Solved | Status::NoEquilibrium));
        outcome.status == Status::Solved
    };
    // atan(0.25) = 14.0362 degrees.
    assert!(stands(14.0361) && !stands(14.0364));
}

#[test]
fn a_cube_on_a_cube_presses_on_both_corners_alike() {
    let model = model(
        vec![
            block(rectangle(0.0, 0.0, 1.0, 1.0), 0.0, 1.0, Held::FIXED),
            block(rectangle(0.0, 1.0, 1.0, 1.0), 0.0, 1.0, Held::FREE),
        ],
        dry(0.7),
    );
    let push = PointForce { block: BlockId::new(1), at: vec2(0.5, 1.5), force: vec2(1.0, 0.0) };
    let loading = Loading { variable: vec![push], ..Loading::default() };
    let zone = thrust_zone(&model, &loading, 0.0, &Settings::default()).unwrap();
    // Statically determinate: the zone is a point, and the two corners carry half the weight each.
    let [low, high] = zone.reach[0].unwrap();
    assert!((low - vec2(0.5, 1.0)).norm() < 1e-7 && (high - low).norm() < 1e-7);
    let resultant = least_thrust(&model, &loading, 0.0, &Settings::default()).unwrap().1.unwrap()[0].unwrap();
    assert!((resultant.force - vec2(0.0, 9.81)).norm() < 1e-7);
    // Pushed at half height it would overturn under its own weight; it slides before.
    let outcome = collapse_load(&model, &loading, &Settings::default()).unwrap();
    assert!((outcome.factor.unwrap() / 9.81 - 0.7).abs() < 1e-7);
}

#[test]
fn a_load_straight_down_locks() {
    let model = standing(0.7);
    let push = PointForce { block: BlockId::new(1), at: vec2(0.1, 1.0), force: vec2(0.0, -1.0) };
    let loading = Loading { variable: vec![push], ..Loading::default() };
    let settings = Settings { friction: Friction::Associated, ..Settings::default() };
    assert_eq!(collapse_load(&model, &loading, &settings).unwrap().status, Status::Locks);
}

#[test]
fn a_section_of_finite_strength_carries_the_textbook_moment() {
    // Width 2.75 m, depth 0.6 m, strength 4.74 MPa, 1000 kN: M = N h / 2 (1 - N / Nc) = 261.641734 kNm.
    let (depth, strength, thrust) = (0.6, 4.74e6, 1e6 / 2.75);
    let mut law = dry(10.0);
    law.crushing = strength;
    let ground = block(rectangle(0.0, -1.0, depth, 1.0), 0.0, 1.0, Held::FIXED);
    let column = block(rectangle(0.0, 0.0, depth, 1.0), 0.0, 1.0, Held::FREE);
    let model = BlockModel { gravity: Vec2::ZERO, ..model(vec![ground, column], law) };
    let top = |x: f64, force: Vec2| PointForce { block: BlockId::new(1), at: vec2(x, 1.0), force };
    let settings = Settings { crushing: true, ..Settings::default() };
    // A moment as a couple of two forces, 0.6 m apart.
    let loading = Loading {
        permanent: vec![top(0.3, vec2(0.0, -thrust))],
        variable: vec![top(0.0, vec2(0.0, 1.0 / depth)), top(depth, vec2(0.0, -1.0 / depth))],
        ..Loading::default()
    };
    let outcome = collapse_load(&model, &loading, &settings).unwrap();
    assert!((outcome.factor.unwrap() * 2.75 / 261_641.734 - 1.0).abs() < 1e-6, "{:?}", outcome.factor);
    assert!((outcome.upper_bound.unwrap() * 2.75 / 261_641.734 - 1.0).abs() < 1e-6);
    // And the squash load, 7821 kN.
    let loading = Loading { variable: vec![top(0.3, vec2(0.0, -1.0))], ..Loading::default() };
    let outcome = collapse_load(&model, &loading, &settings).unwrap();
    assert!((outcome.factor.unwrap() * 2.75 / 7.821e6 - 1.0).abs() < 1e-6, "{:?}", outcome.factor);
}

#[test]
fn a_three_hinged_parabola_thrusts_by_its_closed_form() {
    // 10 kN/m over 20 m, rise 4 m: H = w L^2 / 8 f = 125 kN. Two rigid halves that touch in the crown and springings.
    let half = |points: &[(f64, f64)]| Polygon::new(points.iter().map(|&(x, y)| vec2(x, y)).collect()).unwrap();
    // Thin wedges whose tips are the hinges: each half touches its neighbours in one point.
    let y = 4.0;
    let blocks = vec![
        block(half(&[(-10.5, -1.0), (-10.0, 0.0), (-10.5, 1.0), (-11.0, 0.0)]), 0.0, 1.0, Held::FIXED),
        block(half(&[(-10.0, 0.0), (-4.8, 1.5), (0.0, y), (-5.2, 3.0)]), 0.0, 1.0, Held::FREE),
        block(half(&[(10.0, 0.0), (5.2, 3.0), (0.0, y), (4.8, 1.5)]), 0.0, 1.0, Held::FREE),
        block(half(&[(10.5, -1.0), (11.0, 0.0), (10.5, 1.0), (10.0, 0.0)]), 0.0, 1.0, Held::FIXED),
    ];
    let mut model = model(blocks, dry(2.0));
    model.gravity = Vec2::ZERO;
    let load = |i: usize, x: f64| PointForce { block: BlockId::new(i), at: vec2(x, 3.0), force: vec2(0.0, -100e3) };
    let loading = Loading { permanent: vec![load(1, -5.0), load(2, 5.0)], ..Loading::default() };
    let line = least_thrust(&model, &loading, 0.0, &Settings::default()).unwrap().1.unwrap();
    assert_eq!(line.len(), 3);
    for resultant in line {
        // The solver's tolerance on a force of the order of the load.
        assert!((resultant.unwrap().force.x.abs() - 125e3).abs() < 1e-7 * 200e3);
    }
}

#[test]
fn the_zone_of_bridgemill_closes_at_the_collapse_load() {
    let ring = Ring::bridgemill();
    let (model, loading) = (ring.model(), ring.quarter_knife());
    let settings = Settings { contact_points: ContactPoints::FullRing, ..Settings::default() };
    let outcome = collapse_load(&model, &loading, &settings).unwrap();
    let factor = outcome.factor.unwrap();
    let width = |f: f64| {
        let zone = thrust_zone(&model, &loading, f, &settings).unwrap();
        zone.reach.iter().map(|r| r.map_or(-1.0, |[a, b]| (b - a).norm())).fold(0.0, f64::max)
    };
    let (dead, half, full) = (width(0.0), width(0.5 * factor), width((1.0 - 1e-7) * factor));
    assert!(dead > 0.1 && half > 0.05 && half < dead);
    assert!(full < 1e-4);
    // Nothing is carried beyond.
    assert!(width(1.01 * factor) <= 0.0);
}

#[test]
fn a_sweep_is_the_same_as_one_load_after_the_other() {
    let ring = Ring::bridgemill();
    let model = ring.model();
    let settings = Settings::default();
    let places: Vec<f64> = (0..33).map(|i| -8.0 + 0.5 * f64::from(i)).collect();
    let loads: Vec<_> = places.iter().map(|&x| ring.dispersed_knife(x, 0.75, 0.478)).collect();
    let ground = Ground::new(&model, &Loading::default(), &settings).unwrap();
    let mut sweeper = ground.sweeper();
    let mut place = |load: &Vec<PointForce>| {
        let effect = sweeper.effect(load);
        sweeper.least(&effect, settings.friction)
    };
    let swept: Vec<Least> = loads.iter().map(&mut place).collect();
    for (place, load) in swept.iter().zip(&loads) {
        let loading = Loading { variable: load.clone(), ..Loading::default() };
        let alone = collapse_load(&model, &loading, &settings).unwrap();
        assert_eq!((place.status, place.friction), (alone.status, alone.friction));
        if let (Some(a), Some(b)) = (place.factor, alone.factor) {
            assert!((a / b - 1.0).abs() < 1e-7, "{a} {b}");
        }
    }
    // A load near the quarter point governs, the one that the other places are compared with.
    let factors = swept.iter().zip(&places).filter_map(|(found, place)| Some((found.factor?, place)));
    let governing = factors.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap().1;
    assert!((governing.abs() - 5.0).abs() < 0.6, "{governing}");
    // The ring is symmetric, so is its envelope.
    for i in 0..16 {
        let (a, b) = (swept[i].factor, swept[32 - i].factor);
        if let (Some(a), Some(b)) = (a, b) {
            assert!((a / b - 1.0).abs() < 1e-4, "{a} {b}");
        }
    }
}
