//! Supports that move.

use crate::limit_models::{Ring, block, dry, model};
use mechanics::blocks::{Held, Loading, Movement};
use mechanics::ids::{BlockId, Id};
use mechanics::limit::{Increments, MovementStatus, Settings, least_thrust, support_movement};
use mechanics::plane::{Polygon, Vec2, vec2};
use mechanics::watch::CancelToken;

#[test]
fn a_block_on_a_tilting_base_falls_at_its_slenderness() {
    let ground = Polygon::rectangle(vec2(-0.375, -1.0), 1.0, 1.0).unwrap();
    let tower = Polygon::rectangle(vec2(0.0, 0.0), 0.25, 1.0).unwrap();
    let model = model(vec![block(ground, 0.0, 1.0, Held::FIXED), block(tower, 0.0, 2000.0, Held::FREE)], dry(0.7));
    let tilt = Movement { block: BlockId::new(0), translation: Vec2::ZERO, rotation: 1.0 };
    let loading = Loading { movements: vec![tilt], ..Loading::default() };
    let increments = Increments { largest: 1.0, step: 2e-3, resolution: 1e-6 };
    let found =
        support_movement(&model, &loading, 0.0, increments, &Settings::default(), &CancelToken::default()).unwrap();
    assert_eq!(found.status, MovementStatus::Collapsed);
    // The bracket, and the tolerance of the solver on where the thrust leaves the base.
    assert!(found.stands - 1e-6 < 0.25f64.atan() && 0.25f64.atan() < found.falls.unwrap() + 1e-6);
}

fn spread(step: f64, voussoirs: usize) -> mechanics::limit::MovementOutcome {
    let ring = Ring::semicircle(voussoirs, 0.15, 2.0);
    let last = BlockId::new(voussoirs + 1);
    let apart = Movement { block: last, translation: vec2(1.0, 0.0), rotation: 0.0 };
    let loading = Loading { movements: vec![apart], ..Loading::default() };
    let increments = Increments { largest: 1.0, step, resolution: 1e-5 };
    support_movement(&ring.model(), &loading, 0.0, increments, &Settings::default(), &CancelToken::default()).unwrap()
}

#[test]
fn a_semicircle_spreads_on_three_hinges_and_falls() {
    let voussoirs = 30;
    let found = spread(2e-3, voussoirs);
    assert_eq!(found.status, MovementStatus::Collapsed);
    // Haunch intrados, crown extrados, haunch intrados.
    let hinges: Vec<(usize, usize)> = found.hinges.iter().map(|h| (h.joint, h.point)).collect();
    assert_eq!(hinges, [(5, 0), (15, 1), (25, 0)]);
    // Statics of the left half between its haunch hinge and the crown hinge, turned to where the spread takes it:
    // thrust = weight times its arm over the rise between the hinges.
    let ring = Ring::semicircle(voussoirs, 0.15, 2.0);
    let (haunch, crown) = (ring.at(5.0, ring.intrados), ring.at(15.0, ring.extrados()));
    let model = ring.model();
    let (mut weight, mut moment) = (0.0, Vec2::ZERO);
    for i in 6..=15 {
        let block = &model.blocks[BlockId::new(i)];
        weight += block.mass() * 9.81;
        moment += block.outline.centroid() * (block.mass() * 9.81);
    }
    let (centre, chord) = (moment * (1.0 / weight) - haunch, crown - haunch);
    for step in &found.path {
        let run = chord.x + 0.5 * step.factor;
        let rise = (chord.dot(chord) - run * run).sqrt();
        let turn = rise.atan2(run) - chord.y.atan2(chord.x);
        let arm = centre.x * turn.cos() - centre.y * turn.sin();
        let thrust = weight * arm / rise;
        // The square of what an increment of 2 mm turns a half of rise 0.55 m, (1.8e-3)^2 = 3e-6, a few times.
        assert!((-step.reaction.x / thrust - 1.0).abs() < 1e-5, "{} {} {thrust}", step.factor, step.reaction.x);
    }
    // At rest it thrusts as little as it can.
    let line = least_thrust(&model, &Loading::default(), 0.0, &Settings::default()).unwrap().1.unwrap();
    let least = line[0].unwrap().force.x;
    assert!(-found.path[0].reaction.x > least && -found.path[0].reaction.x < 1.01 * least);
    // The answer does not depend on the increments.
    let finer = spread(1e-3, voussoirs);
    assert!((finer.stands - found.stands).abs() < 2e-5);
}
