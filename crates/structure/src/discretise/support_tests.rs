//! Piers with batter, width across and footings; abutments that slide and overturn.

use super::{Discretised, Origin, discretise};
use crate::samples;
use bridge::{Abutment, AbutmentBody, Bridge, Footing, Friction, Method, Pier};
use mechanics::blocks::{BlockModel, Loading, PointForce};
use mechanics::ids::{BlockId, Id, Table};
use mechanics::limit;
use mechanics::plane::{Vec2, vec2};

fn settings() -> limit::Settings {
    limit::Settings {
        friction: limit::Friction::Associated,
        contact_points: limit::ContactPoints::FullRing,
        ..limit::Settings::default()
    }
}

/// The blocks of which `keep` says so, by themselves, with what lies on them where `with_cover`.
fn alone(d: &Discretised, keep: impl Fn(Origin) -> bool) -> (BlockModel, Loading, Vec<BlockId>) {
    let kept: Vec<BlockId> = d.origins.pairs().filter(|(_, origin)| keep(**origin)).map(|(id, _)| id).collect();
    let mut blocks = Table::default();
    for id in &kept {
        blocks.push(d.model.blocks[*id].clone());
    }
    let place = |block: BlockId| kept.iter().position(|id| *id == block).map(BlockId::new);
    let permanent =
        d.loading.permanent.iter().filter_map(|f| Some(PointForce { block: place(f.block)?, ..*f })).collect();
    let new = (0..kept.len()).map(BlockId::new).collect();
    (BlockModel { blocks, ..d.model.clone() }, Loading { permanent, ..Loading::default() }, new)
}

/// The horizontal force at a point of the last block that topples or shifts what stands [N/m].
fn push(model: &BlockModel, loading: &Loading, block: BlockId, at: Vec2, direction: f64) -> f64 {
    let variable = vec![PointForce { block, at, force: vec2(direction * 1e3, 0.0) }];
    let found = limit::collapse_load(model, &Loading { variable, ..loading.clone() }, &settings()).unwrap();
    1e3 * found.factor.unwrap()
}

fn twin() -> Bridge {
    let mut b = samples::bridgemill();
    b.masonry.rounding = 0.0;
    let span = b.spans[0].clone();
    b.spans = vec![span.clone(), span];
    b.piers = vec![Pier::plain(2.4, 2.4, 6.0, 6)];
    b.cover.layers = vec![samples::fill(0.478, 1890.0)];
    b.width = 8.0;
    b
}

fn stands(b: &Bridge) -> bool {
    let mut b = b.clone();
    (b.plan.method, b.plan.friction) = (Method::Limit, Friction::Associated);
    let found = assess::analysis::collapse_by_limit(&b, &mut mechanics::watch::Unwatched);
    found.is_ok_and(|found| found.collapse_load.is_some_and(|load| load > 0.0))
}

fn load(b: &Bridge) -> f64 {
    let mut b = b.clone();
    (b.plan.method, b.plan.friction) = (Method::Limit, Friction::Associated);
    assess::analysis::collapse_by_limit(&b, &mut mechanics::watch::Unwatched).unwrap().collapse_load.unwrap()
}

/// The example as its file has it: its abutments are wide enough not to govern, and the void takes weight off the haunch away from the load.
#[test]
fn the_example_on_a_gradient_carries_what_its_test_says() {
    let read = bridge::read(include_str!("../../../../examples/gradient/bridge.toml").as_bytes());
    let mut b = read.bridge.unwrap();
    let as_blocks = load(&b);
    b.abutments.iter_mut().for_each(|abutment| abutment.body = None);
    let fixed = load(&b);
    b.cover.voids.clear();
    let filled = load(&b);
    assert!(as_blocks <= fixed * (1.0 + 1e-9), "{as_blocks} {fixed}");
    for (found, wanted) in [(as_blocks, 239.638e3), (fixed, 239.638e3), (filled, 232.036e3)] {
        assert!((found / wanted - 1.0).abs() < 1e-4, "{found} {wanted}");
    }
}

/// A pier of two courses, battered unevenly, wider across at its bottom, on a stepped footing: weight, centre, and the force at its top that
/// topples it about the toe of the footing or of the pier, whichever is less.
#[test]
fn a_battered_pier_topples_by_its_weight_per_metre_of_the_barrel() {
    let mut b = twin();
    // A shear strength that does not govern: what is asked is toppling.
    b.joint.friction_angle = 1.4;
    b.piers = vec![Pier {
        base_width: 3.2,
        base_offset: 0.2,
        across: Some([9.0, 11.0]),
        footings: vec![
            Footing { width: 4.0, height: 0.5, across: Some(12.0) },
            Footing { width: 5.0, height: 0.6, across: None },
        ],
        ..Pier::plain(2.4, 3.2, 6.0, 40)
    }];
    let d = discretise(&b).unwrap();
    let is_pier = |origin| matches!(origin, Origin::Pier { .. } | Origin::Foundation { .. });
    let (model, loading, ids) = alone(&d, is_pier);
    let loading = Loading { permanent: Vec::new(), ..loading };
    let free: Vec<BlockId> = ids.iter().copied().filter(|id| !model.blocks[*id].held.is_fixed()).collect();
    let [weight, moment] = free.iter().fold([0.0, 0.0], |[w, m], id| {
        let own = model.blocks[*id].mass() * 9.81;
        [w + own, m + own * model.blocks[*id].outline.centroid().x]
    });
    // By integration: courses of the pier below its springings, its head by its polygon, and the two steps.
    let middle = 18.3 + 1.2;
    let unit = 2100.0 * 9.81;
    let (mut wanted, mut turned) = (0.0, 0.0);
    let mut add = |area: f64, x: f64, across: f64| {
        wanted += unit * area * across / 8.0;
        turned += unit * area * across / 8.0 * x;
    };
    const STEPS: usize = 39 * 100;
    for k in 0..STEPS {
        let share = (k as f64 + 0.5) / 4000.0;
        let width = 3.2 - 0.8 * share;
        add(width * 6.0 / 4000.0, middle + 0.2 * (1.0 - share), 11.0 - 2.0 * share);
    }
    let head = &model.blocks[free[free.len() - 1]].outline;
    add(head.area(), head.centroid().x, 11.0 - 2.0 * (39.5 / 40.0));
    add(4.0 * 0.5, middle + 0.2, 12.0);
    add(5.0 * 0.6, middle + 0.2, 11.0);
    // Courses have one density each: the rest is that of forty steps.
    assert!((weight / wanted - 1.0).abs() < 1e-4, "{weight} {wanted}");
    assert!((moment / turned - 1.0).abs() < 1e-4, "{moment} {turned}");
    // To the right, about the right toes: the whole about that of the lowest step, the pier about that of its own bottom, and so on.
    let top = free[free.len() - 1];
    let at = vec2(middle, 0.0);
    let joints: Vec<(f64, f64, f64)> = (0..free.len())
        .map(|k| {
            let (low, _) = model.blocks[free[k]].outline.bounds();
            let toe = model.blocks[free[k]]
                .outline
                .vertices()
                .iter()
                .filter(|p| p.y < low.y + 1e-9)
                .map(|p| p.x)
                .fold(f64::MIN, f64::max);
            let above = free[k..].iter().fold([0.0, 0.0], |[w, m], id| {
                let own = model.blocks[*id].mass() * 9.81;
                [w + own, m + own * model.blocks[*id].outline.centroid().x]
            });
            ((above[0] * toe - above[1]) / (at.y - low.y), toe, low.y)
        })
        .collect();
    let least = joints.iter().map(|joint| joint.0).fold(f64::INFINITY, f64::min);
    let found = push(&model, &loading, top, at, 1.0);
    assert!((found / least - 1.0).abs() < 1e-6, "{found} {least} {joints:?}");
}

#[test]
fn a_wider_pier_carries_more_and_a_narrower_one_less() {
    let mut b = twin();
    b.masonry.compressive_strength = Some(4e6);
    b.joint.cohesion = 0.0;
    b.piers = vec![Pier::plain(2.4, 2.4, 9.0, 9)];
    let plain = load(&b);
    let with = |across: f64| {
        let mut b = b.clone();
        b.piers[0].across = Some([across; 2]);
        load(&b)
    };
    // As wide as the barrel is no change, to the last digits; it is a group for each course.
    assert!((with(8.0) / plain - 1.0).abs() < 1e-9, "{} {plain}", with(8.0));
    let (wide, narrow) = (with(10.0), with(6.0));
    assert!(narrow < plain && plain < wide, "{narrow} {plain} {wide}");
}

fn movable(body: AbutmentBody, top_width: f64, height: f64) -> Bridge {
    let mut b = samples::bridgemill();
    b.masonry.rounding = 0.0;
    b.abutments = [Abutment { top_width, height, body: Some(body) }; 2];
    b.cover.layers = vec![samples::fill(0.478, 1890.0)];
    b
}

const BODY: AbutmentBody = AbutmentBody {
    base_width: None,
    courses: 1,
    ground_friction_angle: 0.6,
    earth_coefficient: 0.0,
    earth_density: None,
};

/// A gravity wall pushed at its springing as an arch does: it slides with friction times weight plus earth pressure, and topples about its heel.
#[test]
fn an_abutment_slides_and_topples_as_a_gravity_wall() {
    // The soil alone must not push the wall over: the arch stands before it.
    for (coefficient, friction, courses) in
        [(0.0, 0.3f64, 1), (0.2, 0.3, 1), (0.0, 1.3, 1), (0.2, 1.3, 1), (0.2, 1.3, 5)]
    {
        let body = AbutmentBody {
            earth_coefficient: coefficient,
            ground_friction_angle: friction,
            courses,
            base_width: Some(3.4),
            ..BODY
        };
        let mut b = movable(body, 2.0, 4.0);
        b.joint.friction_angle = 1.4;
        let d = discretise(&b).unwrap();
        for support in [0, 1] {
            let (model, loading, ids) = alone(
                &d,
                |origin| matches!(origin, Origin::AbutmentCourse { support: s, .. } | Origin::AbutmentGround { support: s } if s == support),
            );
            let outwards = if support == 0 { -1.0 } else { 1.0 };
            let springing = vec2(if support == 0 { 0.0 } else { 18.3 }, 0.0);
            let free = &ids[1..];
            let stretches = &d.extrados.stretches;
            let skewback = [stretches[0].right, stretches[stretches.len() - 1].left][support];
            let (cover, over) =
                loading.permanent.iter().fold((0.0, 0.0), |(w, m), f| (w - f.force.y, m - f.force.y * f.at.x));
            // Above every bed: weights, and soil from the road down by hand, a trapezoid.
            let road = d.extrados.crown() + 0.478;
            let head = d.extrados.stretches.iter().map(|s| s.left.y.min(s.right.y)).fold(f64::MAX, f64::min);
            let unit = 1890.0 * 9.81 * coefficient;
            let top_width = 2.0 + (springing.x - skewback.x).abs();
            let on_bed = |k: usize| {
                let low = model.blocks[free[k]].outline.bounds().0.y;
                let (upper, lower) = (unit * (road - head), unit * (road - low));
                let earth = 0.5 * (upper + lower) * (head - low);
                let moment = (head - low) * (head - low) * (2.0 * upper + lower) / 6.0;
                let own = free[k..].iter().fold([0.0, 0.0], |[w, m], id| {
                    let own = model.blocks[*id].mass() * 9.81;
                    [w + own, m + own * model.blocks[*id].outline.centroid().x]
                });
                // The back runs straight from the end of the bottom to that of the upper face.
                let share = (low + 4.0) / (head + 4.0);
                let heel = springing.x + outwards * (3.4 + (top_width - 3.4) * share);
                let lever = (heel * (own[0] + cover) - own[1] - over) * outwards;
                (own[0] + cover, earth, (lever + moment) / -low)
            };
            let (vertical, earth, _) = on_bed(0);
            let sliding = vertical * friction.tan() + earth;
            let toppling = (0..free.len()).map(|k| on_bed(k).2).fold(f64::INFINITY, f64::min);
            let wanted = sliding.min(toppling);
            assert!((friction < 1.0) == (sliding < toppling), "{sliding} {toppling}");
            let found = push(&model, &loading, free[free.len() - 1], springing, outwards);
            assert!(
                (found / wanted - 1.0).abs() < 1e-6,
                "{coefficient} {friction} {courses} {support}: {found} {wanted}"
            );
        }
    }
}

/// The whole bridge stands on its abutments where friction carries the least thrust of the arch, and not where it does not.
#[test]
fn the_least_thrust_of_the_arch_decides_whether_its_abutments_stand() {
    let mut fixed = movable(BODY, 2.0, 3.0);
    fixed.abutments.iter_mut().for_each(|abutment| abutment.body = None);
    fixed.joint.friction_angle = 1.2;
    let d = discretise(&fixed).unwrap();
    let own = Loading { variable: Vec::new(), ..d.loading.clone() };
    let (joints, line) = limit::least_thrust(&d.model, &own, 0.0, &settings()).unwrap();
    let line = line.unwrap();
    // The thrust is the same in every joint of a ring under vertical loads: that of the joint in the middle.
    let crown = (0..joints.len()).min_by(|a, b| {
        let far = |k: &usize| (joints[*k].points[0].x - 9.15).abs();
        far(a).total_cmp(&far(b))
    });
    let crown = crown.unwrap();
    let normal = line[crown].unwrap().force;
    let thrust = normal.x.abs();
    let total: f64 = {
        let with = movable(BODY, 2.0, 3.0);
        let d = discretise(&with).unwrap();
        let own: f64 =
            d.model.blocks.iter().filter(|block| !block.held.is_fixed()).map(|block| block.mass() * 9.81).sum();
        own + d.loading.permanent.iter().map(|f| -f.force.y).sum::<f64>()
    };
    let least = thrust / (0.5 * total);
    let stands = |friction: f64| {
        let mut b = movable(AbutmentBody { ground_friction_angle: friction.atan(), ..BODY }, 2.0, 3.0);
        b.joint.friction_angle = 1.2;
        let d = discretise(&b).unwrap();
        // A load so small that it asks whether the bridge stands.
        let mut loading = d.loading.clone();
        loading.variable.iter_mut().for_each(|f| f.force = f.force * 1e-3);
        limit::collapse_load(&d.model, &loading, &settings()).unwrap().status != limit::Status::NoEquilibrium
    };
    assert!(stands(1.001 * least) && !stands(0.999 * least), "{least}");
}

#[test]
fn abutments_that_cannot_move_carry_the_fixed_load_and_mirrored_ones_the_same() {
    let mut heavy = movable(AbutmentBody { ground_friction_angle: 1.2, courses: 3, ..BODY }, 8.0, 1.0);
    heavy.joint.friction_angle = 1.0;
    let mut fixed = heavy.clone();
    fixed.abutments.iter_mut().for_each(|abutment| abutment.body = None);
    let (one, other) = (load(&heavy), load(&fixed));
    assert!((one / other - 1.0).abs() < 1e-7, "{one} {other}");
    // One that gives lowers the load, whichever side it stands on: with the least friction on which the bridge stands.
    let mut left = fixed.clone();
    left.loads[0].position = 4.0;
    let held = load(&left);
    let body = |friction: f64| AbutmentBody { ground_friction_angle: friction, ..BODY };
    let with = |friction: f64| {
        let mut b = left.clone();
        b.abutments[0] = Abutment { top_width: 5.0, height: 2.0, body: Some(body(friction)) };
        b
    };
    let least = (20..65).map(|k| 0.02 * f64::from(k)).find(|friction| stands(&with(*friction))).unwrap();
    let mut left = with(least);
    let mut right = left.clone();
    right.abutments.reverse();
    right.loads[0].position = 18.3 - 4.0;
    let (one, other) = (load(&left), load(&right));
    assert!((one / other - 1.0).abs() < 1e-7 && one < 0.9 * held, "{one} {other} {held}");
    // Earth holds it against the thrust.
    left.abutments[0].body.as_mut().unwrap().earth_coefficient = 0.2;
    assert!(load(&left) > 1.01 * one, "{} {one}", load(&left));
}
