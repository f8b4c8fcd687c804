//! Many loads by the fast method, against the interior-point method one by one, and against themselves.

use crate::limit_models::{Ring, wall};
use mechanics::blocks::{BlockModel, Held, Loading, PointForce, Restraint};
use mechanics::ids::{BlockId, Id};
use mechanics::limit::{Effect, Friction, Ground, Settings, Status, collapse_load};
use mechanics::plane::{Polygon, Vec2, vec2};

fn bridgemill() -> (Ring, BlockModel, Loading) {
    let ring = Ring::bridgemill();
    let model = ring.model();
    let loading = Loading { permanent: ring.fill(0.203, 1890.0), ..Loading::default() };
    (ring, model, loading)
}

fn places(ring: &Ring) -> Vec<Vec<PointForce>> {
    (0..41).map(|k| ring.dispersed_knife(-9.0 + 0.45 * k as f64, 0.75, 0.478)).collect()
}

fn agree(model: &BlockModel, loading: &Loading, loads: &[Vec<PointForce>], settings: &Settings, within: f64) {
    let ground = Ground::new(model, loading, settings).unwrap();
    assert!(ground.is_fast());
    let mut sweeper = ground.sweeper();
    for (k, load) in loads.iter().enumerate() {
        let effect = sweeper.effect(load);
        let found = sweeper.factor(&effect);
        let whole = Loading { variable: load.clone(), ..loading.clone() };
        let outcome = collapse_load(model, &whole, &Settings { friction: Friction::Associated, ..*settings }).unwrap();
        assert_eq!(found.status, outcome.status, "place {k}");
        if found.status != Status::Solved {
            continue;
        }
        let (lower, upper, factor) = (found.lower.unwrap(), found.upper.unwrap(), outcome.factor.unwrap());
        assert!(!found.by_interior_point, "place {k}");
        assert!((upper / lower - 1.0).abs() < 1e-9, "place {k}: {lower} {upper}");
        assert!((lower / factor - 1.0).abs() < within, "place {k}: {lower} {factor}");
        let own = sweeper.outcome(&effect, Friction::Associated);
        assert!(own.equilibrium_residual < 1e-10 && own.yield_violation < 1e-8, "place {k}: {own:?}");
        assert!((own.lower_bound.unwrap() / lower - 1.0).abs() < 1e-9);
        assert!((own.upper_bound.unwrap() / lower - 1.0).abs() < 1e-6, "place {k}: {:?} {lower}", own.upper_bound);
        assert!(own.flow_violation < 1e-8, "place {k}: {}", own.flow_violation);
    }
}

#[test]
fn every_place_has_the_factor_of_the_interior_point_method() {
    let (ring, model, loading) = bridgemill();
    // The interior-point method stops at 1e-9 of its own measure, which is up to 1e-7 of a factor.
    agree(&model, &loading, &places(&ring), &Settings::default(), 1e-7);
}

#[test]
fn joints_that_crush_are_met_by_tangents() {
    let (ring, mut model, loading) = bridgemill();
    model.laws.iter_mut().for_each(|law| law.crushing = 8e6);
    let settings = Settings { crushing: true, ..Settings::default() };
    agree(&model, &loading, &places(&ring), &settings, 1e-7);
}

/// As many as would make the program of a whole wall of blocks: they stand at their bounds but for a few.
#[test]
fn forces_on_every_block_leave_the_fast_method_fast() {
    let ring = Ring { voussoirs: 180, ..Ring::bridgemill() };
    let model = ring.model();
    let force = |i: usize| {
        let at = ring.at(i as f64 + 0.5, ring.extrados());
        let direction = vec2(if at.x < 0.0 { 1.0 } else { -1.0 }, 0.0);
        Restraint {
            block: BlockId::new(i + 1),
            at,
            direction,
            least: 200.0,
            most: 900.0,
            half_movement: 0.01,
            against: None,
        }
    };
    let restraints = (0..ring.voussoirs).map(force).collect();
    let loading = Loading { permanent: ring.fill(0.203, 1890.0), restraints, ..Loading::default() };
    let loads: Vec<_> = (0..9).map(|k| ring.dispersed_knife(-8.0 + 2.0 * k as f64, 0.75, 0.478)).collect();
    // At the crown the load is fifty times that at the quarter, and the interior-point method as much further off.
    agree(&model, &loading, &loads, &Settings::default(), 1e-6);
}

/// Two blocks on a floor, and a force between them that pushes both apart: nothing is left over.
#[test]
fn a_force_against_another_block_pushes_both() {
    let law = mechanics::blocks::ContactLaw {
        normal: mechanics::blocks::Stiffness::Given(1e9),
        shear: mechanics::blocks::Stiffness::Given(1e9),
        friction: 0.5,
        cohesion: 0.0,
        tension: 0.0,
        crushing: f64::INFINITY,
        fixed_length: None,
        least_length: 0.1,
    };
    let mut groups = mechanics::ids::Table::default();
    let group = groups.push("blocks".to_owned());
    let block = |x: f64, y: f64, width: f64, held| mechanics::blocks::Block {
        outline: Polygon::rectangle(vec2(x, y), width, 1.0).unwrap(),
        rounding: 0.0,
        density: 1000.0,
        group,
        held,
    };
    let model = BlockModel {
        blocks: [
            block(0.0, -1.0, 6.0, Held::FIXED),
            block(1.0, 0.0, 1.0, Held::FREE),
            block(4.0, 0.0, 1.0, Held::FREE),
        ]
        .into_iter()
        .collect(),
        particles: mechanics::ids::Table::default(),
        groups,
        laws: mechanics::blocks::LawTable::uniform(1, law),
        gravity: vec2(0.0, -10.0),
    };
    let [left, right] = [BlockId::new(1), BlockId::new(2)];
    let push = PointForce { block: left, at: vec2(1.0, 0.2), force: vec2(1e3, 0.0) };
    let between = |most: f64, against| Loading {
        variable: vec![push],
        restraints: vec![Restraint {
            block: left,
            at: vec2(2.0, 0.2),
            direction: vec2(-1.0, 0.0),
            least: 0.0,
            most,
            half_movement: 0.01,
            against,
        }],
        ..Loading::default()
    };
    let settings = Settings { friction: Friction::Associated, ..Settings::default() };
    let factor = |loading: &Loading| collapse_load(&model, loading, &settings).unwrap().factor.unwrap();
    // A block weighs 10 kN/m and slides at 5.
    let other = Some((right, vec2(4.0, 0.2)));
    assert!((factor(&between(3e3, None)) - 8.0).abs() < 1e-6, "the force stands outside");
    assert!((factor(&between(3e3, other)) - 8.0).abs() < 1e-6, "the other block holds it");
    assert!((factor(&between(30e3, other)) - 10.0).abs() < 1e-6, "no more than the other block holds");
}

#[test]
fn forces_that_answer_movement_help_and_only_against_it() {
    let (ring, model, loading) = bridgemill();
    let pushed = |least: f64, most: f64| {
        let restraints = (0..ring.voussoirs)
            .map(|i| {
                let at = ring.at(i as f64 + 0.5, ring.extrados());
                let inwards = if at.x < 0.0 { 1.0 } else { -1.0 };
                Restraint {
                    block: BlockId::new(i + 1),
                    at,
                    direction: vec2(inwards, 0.0),
                    least,
                    most,
                    half_movement: 0.01,
                    against: None,
                }
            })
            .collect();
        Loading { restraints, ..loading.clone() }
    };
    let load = ring.quarter_knife().variable;
    let factor = |loading: &Loading| {
        let ground = Ground::new(&model, loading, &Settings::default()).unwrap();
        let mut sweeper = ground.sweeper();
        let effect = sweeper.effect(&load);
        let found = sweeper.factor(&effect);
        let outcome = sweeper.outcome(&effect, Friction::Associated);
        let (lower, upper) = (found.lower.unwrap(), outcome.upper_bound.unwrap());
        assert!((lower / upper - 1.0).abs() < 1e-6, "{lower} {upper}");
        let whole = Loading { variable: load.clone(), ..loading.clone() };
        let other = collapse_load(&model, &whole, &Settings::default()).unwrap();
        assert!((lower / other.factor.unwrap() - 1.0).abs() < 1e-7, "{lower} {other:?}");
        assert!((other.upper_bound.unwrap() / other.lower_bound.unwrap() - 1.0).abs() < 1e-6);
        lower
    };
    let without = factor(&loading);
    assert_eq!(factor(&pushed(0.0, 0.0)).to_bits(), factor(&pushed(0.0, 0.0)).to_bits());
    assert!((factor(&pushed(0.0, 0.0)) / without - 1.0).abs() < 1e-9, "nothing is added by nothing");
    let with = factor(&pushed(0.0, 2e3));
    assert!(with > 1.02 * without, "{with} {without}");
    // A narrower range is a smaller set of forces: never stronger.
    assert!(factor(&pushed(1e3, 2e3)) <= with * (1.0 + 1e-9));
    // The work equation by hand: what is gained is done by the forces against their own movement.
    let small = factor(&pushed(0.0, 1e-3)) - without;
    let outcome = collapse_load(&model, &Loading { variable: load.clone(), ..loading.clone() }, &Settings::default());
    let mechanism = outcome.unwrap().mechanism.unwrap();
    let velocity = |block: BlockId, at: Vec2| {
        let (v, w) = mechanism.velocities[block];
        v + (at - model.blocks[block].outline.centroid()).left() * w
    };
    let work: f64 = load.iter().map(|f| f.force.dot(velocity(f.block, f.at))).sum();
    let against: f64 = pushed(0.0, 1e-3)
        .restraints
        .iter()
        .map(|r| r.most * (-r.direction.dot(velocity(r.block, r.at))).max(0.0))
        .sum();
    assert!((small / (against / work) - 1.0).abs() < 1e-3, "{small} {}", against / work);
}

#[test]
fn effects_add_up() {
    let (ring, model, loading) = bridgemill();
    let ground = Ground::new(&model, &loading, &Settings::default()).unwrap();
    let mut sweeper = ground.sweeper();
    let [a, b] = [-4.0, -2.8].map(|x| ring.dispersed_knife(x, 0.3, 0.478));
    let mut sum = sweeper.nothing();
    for (load, times) in [(&a, 1.0), (&b, 2.0)] {
        let effect = sweeper.effect(load);
        sum.add(&effect, times);
    }
    let twice = b.iter().map(|f| PointForce { force: f.force * 2.0, ..*f });
    let both: Vec<PointForce> = a.iter().copied().chain(twice).collect();
    let whole = sweeper.effect(&both);
    let [one, other] = [sum, whole].map(|effect| sweeper.factor(&effect).lower.unwrap());
    assert!((one / other - 1.0).abs() < 1e-9, "{one} {other}");
}

/// Other weights change nothing of what a load does but the unit of force that it is counted in.
#[test]
fn an_effect_serves_grounds_of_other_weights() {
    let (ring, model, loading) = bridgemill();
    let mut heavy = model.clone();
    heavy.blocks.iter_mut().for_each(|block| block.density *= 1.4);
    let [light, heavy] = [&model, &heavy].map(|m| Ground::new(m, &loading, &Settings::default()).unwrap());
    assert!(light.stands() && heavy.stands());
    let (mut first, mut own, mut given) = (light.sweeper(), heavy.sweeper(), heavy.sweeper());
    for load in places(&ring).iter().step_by(5) {
        let effect = first.effect(load);
        let taken = given.factor(&heavy.taken(&effect, &light)).lower.unwrap();
        let effect = own.effect(load);
        let found = own.factor(&effect).lower.unwrap();
        // Round-off of a factor that both bounds meet to 1e-9.
        assert!((taken / found - 1.0).abs() < 1e-9, "{taken} {found}");
    }
}

/// A long sweep drops tangents; what it answers late is what a fresh one answers.
#[test]
fn tangents_that_were_dropped_are_found_again() {
    let (ring, mut model, loading) = bridgemill();
    model.laws.iter_mut().for_each(|law| law.crushing = 5e6);
    let settings = Settings { crushing: true, ..Settings::default() };
    let ground = Ground::new(&model, &loading, &settings).unwrap();
    let mut long = ground.sweeper();
    for k in 0..160 {
        let load = ring.dispersed_knife(-9.0 + 0.1125 * k as f64, 0.75, 0.478);
        let effect = long.effect(&load);
        let found = long.factor(&effect);
        let mut fresh = ground.sweeper();
        let other = fresh.factor(&effect);
        let (Some(found), Some(other)) = (found.lower, other.lower) else { continue };
        assert!((found / other - 1.0).abs() < 1e-8, "{k}: {found} {other}");
        let outcome = long.outcome(&effect, Friction::Associated);
        assert!((outcome.upper_bound.unwrap() / found - 1.0).abs() < 1e-6, "{k}");
    }
}

/// Joints that slide, whichever way: a load and its mirror image have one factor, which is that of the interior-point method,
/// and both methods say that joints slide.
#[test]
fn joints_that_slide_either_way_are_met() {
    let ring = Ring::semicircle(31, 0.3, 0.42);
    let (model, loading) = (ring.model(), Loading::default());
    let loads: Vec<Vec<PointForce>> = (0..15)
        .map(|k| {
            let at = ring.at(f64::from(k) + 8.5, ring.extrados());
            vec![PointForce { block: BlockId::new(k as usize + 9), at, force: vec2(0.0, -1.0) }]
        })
        .collect();
    let settings = Settings { friction: Friction::Associated, ..Settings::default() };
    agree(&model, &loading, &loads, &settings, 1e-7);
    let ground = Ground::new(&model, &loading, &settings).unwrap();
    let mut sweeper = ground.sweeper();
    let mut sliding = 0;
    let mut factors = Vec::new();
    for load in &loads {
        let effect = sweeper.effect(load);
        let found = sweeper.factor(&effect);
        let whole = Loading { variable: load.clone(), ..Loading::default() };
        let outcome = collapse_load(&model, &whole, &settings).unwrap();
        let slides = outcome.mechanism.is_some_and(|mechanism| !mechanism.sliding.is_empty());
        assert_eq!(found.slides, slides, "{load:?}");
        sliding += usize::from(slides);
        factors.push(found.lower.unwrap());
    }
    assert!(sliding > 2, "{sliding}");
    for (a, b) in factors.iter().zip(factors.iter().rev()) {
        assert!((a / b - 1.0).abs() < 1e-8, "{factors:?}");
    }
}

/// A block on the ground: where its weight and a load beside its middle press is a lever by hand, and shear is the push.
#[test]
fn a_section_presses_where_the_lever_says() {
    let block = |x: f64, y: f64, width: f64, height: f64, held: Held| {
        crate::limit_models::block(Polygon::rectangle(vec2(x, y), width, height).unwrap(), 0.0, 2000.0, held)
    };
    let blocks = vec![block(-1.0, -0.5, 3.0, 0.5, Held::FIXED), block(0.0, 0.0, 0.5, 1.0, Held::FREE)];
    let model = crate::limit_models::model(blocks, crate::limit_models::dry(0.7));
    let ground = Ground::new(&model, &Loading::default(), &Settings::default()).unwrap();
    let weight = 2000.0 * 0.5 * 9.81;
    let sweeper = &mut ground.sweeper();
    for (x, push) in [(0.4, 0.0), (0.1, 0.0), (0.25, 300.0)] {
        let force = PointForce { block: BlockId::new(1), at: vec2(x, 1.0), force: vec2(push, -1000.0) };
        let effect = sweeper.effect(&[force]);
        let found = ground.section(&effect, 2.0, 0).unwrap();
        let joint = &ground.interfaces[0];
        assert!((found.compression / (weight + 2000.0) - 1.0).abs() < 1e-9, "{found:?}");
        // About the middle of the foot: two loads of 1000 N at their lever, and the push at the height of the block.
        let moment = 2000.0 * (x - 0.25) + 2.0 * push;
        let along = joint.normal.left();
        let at = found.eccentricity * along.x;
        assert!((at - moment / (weight + 2000.0)).abs() < 1e-9, "{x} {push}: {found:?}");
        // The ground holds the block back, and the force on the second block of the joint is told.
        let second = if joint.second == BlockId::new(1) { -1.0 } else { 1.0 };
        assert!((found.shear * along.x - second * 2.0 * push).abs() < 1e-6, "{x} {push}: {found:?}");
    }
}

/// The ring of Bridgemill as a continuous elastic arch between fixed ends, by the three forces at its left end that make the energy of
/// bending, compression and shear least. A section of the blocks has its thrust and its eccentricity; two springs at the ends of each joint
/// have a tenth less thrust.
#[test]
fn sections_are_those_of_an_elastic_arch() {
    let ring = Ring { voussoirs: 120, ..Ring::bridgemill() };
    let model = ring.model();
    let radius = 0.5 * (ring.intrados + ring.extrados());
    let n = 2400;
    let angle = |k: f64| -ring.half_angle + 2.0 * ring.half_angle * k / n as f64;
    let point = |a: f64| vec2(radius * a.sin(), radius * a.cos());
    let ds = 2.0 * ring.half_angle * radius / n as f64;
    let weight = 2100.0 * 9.81 * ring.thickness * ds;
    let start = point(angle(0.0));
    // Thrust, shear and moment at a place under unit forces at the left end (to the right, upwards, turning), and under the weight left of it.
    let state = |a: f64, right: f64, up: f64, turning: f64, at: Vec2| {
        let (along, out) = (vec2(a.cos(), -a.sin()), vec2(a.sin(), a.cos()));
        let (force, arm) = (vec2(right, up), point(a) - at);
        [force.dot(along), force.dot(out), turning + force.x * arm.y - force.y * arm.x]
    };
    let energy = |x: [f64; 3], y: [f64; 3]| {
        let d = ring.thickness;
        x[0] * y[0] / d + 2.88 * x[1] * y[1] / d + x[2] * y[2] * 12.0 / d.powi(3)
    };
    let (mut a, mut b) = ([[0.0; 3]; 3], [0.0; 3]);
    let mut places = Vec::new();
    for k in 0..n {
        let here = angle(k as f64 + 0.5);
        let units = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|u| state(here, u[0], u[1], u[2], start));
        let mut own = [0.0; 3];
        for j in 0..k {
            let part = state(here, 0.0, -weight, 0.0, point(angle(j as f64 + 0.5)));
            (0..3).for_each(|i| own[i] += part[i]);
        }
        for i in 0..3 {
            (0..3).for_each(|j| a[i][j] += energy(units[i], units[j]));
            b[i] -= energy(units[i], own);
        }
        places.push((units, own));
    }
    // Cramer's rule.
    let det = |m: [[f64; 3]; 3]| {
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    };
    let x: Vec<f64> = (0..3)
        .map(|k| {
            let mut m = a;
            (0..3).for_each(|i| m[i][k] = b[i]);
            det(m) / det(a)
        })
        .collect();
    let (units, own) = &places[n / 2];
    let [thrust, _, moment] = [0, 1, 2].map(|i| own[i] + (0..3).map(|k| x[k] * units[k][i]).sum::<f64>());
    let ground = Ground::new(&model, &Loading::default(), &Settings::default()).unwrap();
    let crown = ground.section(&ground.sweeper().nothing(), 1.0, 60).unwrap();
    assert!((crown.compression / thrust - 1.0).abs() < 5e-3, "{} {thrust}", crown.compression);
    let lever = (moment / thrust).abs();
    assert!((crown.eccentricity.abs() - lever).abs() < 0.02 * ring.thickness, "{} {lever}", crown.eccentricity);
}

/// A motion that one load found bounds every other load from above, also under other weights, and its own exactly.
#[test]
fn motions_bound_other_loads_from_above() {
    let (ring, model, loading) = bridgemill();
    let settings = Settings { friction: Friction::Associated, ..Settings::default() };
    let ground = Ground::new(&model, &loading, &settings).unwrap();
    let mut heavier = model.clone();
    heavier.gravity = vec2(0.0, -1.2 * 9.81);
    let other = Ground::new(&heavier, &loading, &settings).unwrap();
    let (mut sweeper, mut under) = (ground.sweeper(), other.sweeper());
    let places = places(&ring);
    let effects: Vec<Effect> = places.iter().map(|load| sweeper.effect(load)).collect();
    assert!(effects.iter().all(|effect| under.at_most(&other.taken(effect, &ground)) == f64::INFINITY));
    let chosen = places.len() / 4;
    let motion = sweeper.motion(&effects[chosen]);
    sweeper.learn(&motion);
    under.learn(&motion);
    let mut bounded = 0;
    for (k, effect) in effects.iter().enumerate() {
        let taken = other.taken(effect, &ground);
        let (bound, above) = (sweeper.at_most_by_newest(effect), under.at_most_by_newest(&taken));
        let (exact, heavy) = (sweeper.factor(effect), under.factor(&taken));
        bounded += usize::from(bound.is_finite());
        assert!(exact.lower.is_none_or(|factor| bound >= factor * (1.0 - 1e-9)), "{k}: {bound} {exact:?}");
        assert!(heavy.lower.is_none_or(|factor| above >= factor * (1.0 - 1e-9)), "{k}: {above} {heavy:?}");
        if k == chosen {
            assert!((bound / exact.lower.unwrap() - 1.0).abs() < 1e-6, "{bound} {exact:?}");
        }
    }
    assert!(bounded > places.len() / 4);
}

/// The first wall of Ferris and Tin-Loi under its own load and others that differ a little: what was answered before moves no answer.
#[test]
fn a_load_without_dilation_is_the_same_whatever_was_answered_before() {
    const A: &[f64] = &[0.5, 1.0, 1.0, 1.0, 1.0, 0.5];
    const B: &[f64] = &[1.0, 1.0, 1.0, 1.0, 1.0];
    let (model, loading) = wall(&[A, B, A, B, A, B], 0.4, 0.175, 0.65);
    let ground = Ground::new(&model, &loading, &Settings::default()).unwrap();
    let mut sweeper = ground.sweeper();
    let mut answer = |k: u32| {
        let push =
            |f: &PointForce| PointForce { force: f.force + vec2(0.0, -0.02 * f64::from(k) * f.force.x.abs()), ..*f };
        let load: Vec<PointForce> = loading.variable.iter().map(push).collect();
        let effect = sweeper.effect(&load);
        let dilates = sweeper.factor(&effect).lower.unwrap();
        let level = sweeper.least(&effect, Friction::NonAssociated).factor.unwrap();
        assert!(level <= dilates * (1.0 + 1e-6), "{k}: {level} {dilates}");
        let loading = Loading { variable: load, ..loading.clone() };
        let alone = collapse_load(&model, &loading, &Settings::default()).unwrap();
        assert!((alone.factor.unwrap() / level - 1.0).abs() < 1e-9, "{k}: {:?} {level}", alone.factor);
        level
    };
    let there: Vec<f64> = (0..4).map(&mut answer).collect();
    let back: Vec<f64> = (0..4).rev().map(&mut answer).collect();
    assert!(there.iter().eq(back.iter().rev()), "{there:?} {back:?}");
}

/// Of any load, joints that crush or not: no more than the largest factor is proven, and as much as is asked for below it.
#[test]
fn a_factor_below_the_largest_is_proven_to_be_carried() {
    let (ring, mut model, loading) = bridgemill();
    for crushing in [f64::INFINITY, 8e6] {
        model.laws.iter_mut().for_each(|law| law.crushing = crushing);
        let settings = Settings { crushing: crushing.is_finite(), ..Settings::default() };
        let ground = Ground::new(&model, &loading, &settings).unwrap();
        let mut sweeper = ground.sweeper();
        for (k, load) in places(&ring).iter().enumerate().step_by(7) {
            let effect = sweeper.effect(load);
            let Some(largest) = sweeper.factor(&effect).lower else { continue };
            for share in [0.3, 0.9, 3.0] {
                let carried = sweeper.proven_up_to(&effect, share * largest).unwrap();
                assert!(carried <= share.min(1.0) * largest * (1.0 + 1e-7), "{k} {share}: {carried} {largest}");
                assert!(carried >= share.min(1.0) * largest * (1.0 - 1e-3), "{k} {share}: {carried} {largest}");
            }
        }
    }
}
