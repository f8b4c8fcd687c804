//! Supports that move.

use crate::limit_models::{Ring, block, dry, model};
use mechanics::blocks::{Held, Loading, Movement};
use mechanics::ids::{BlockId, Id};
use mechanics::limit::{Increments, MovementStatus, Settings, support_movement, thrust_zone};
use mechanics::plane::{Polygon, Vec2, vec2};

#[test]
fn a_block_on_a_tilting_base_falls_at_its_slenderness() {
    let ground = Polygon::rectangle(vec2(-0.375, -1.0), 1.0, 1.0).unwrap();
    let tower = Polygon::rectangle(vec2(0.0, 0.0), 0.25, 1.0).unwrap();
    let model = model(vec![block(ground, 0.0, 1.0, Held::FIXED), block(tower, 0.0, 2000.0, Held::FREE)], dry(0.7));
    let tilt = Movement { block: BlockId::new(0), translation: Vec2::ZERO, rotation: 1.0 };
    let loading = Loading { movements: vec![tilt], ..Loading::default() };
    let increments = Increments { largest: 1.0, step: 2e-3, resolution: 1e-6 };
    let found = support_movement(&model, &loading, 0.0, increments, &Settings::default()).unwrap();
    println!("{:?} {} {:?} {} {:?}", found.status, found.stands, found.falls, 0.25f64.atan(), found.poses);
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
    support_movement(&ring.model(), &loading, 0.0, increments, &Settings::default()).unwrap()
}

#[test]
fn a_semicircle_spreads_on_three_hinges_and_falls() {
    for (step, n) in [(2e-3, 30), (1e-3, 30), (5e-4, 30)] {
        let start = std::time::Instant::now();
        let found = spread(step, n);
        println!(
            "{step} {n} {:?} {} {:?} {} {:?}",
            found.status,
            found.stands,
            found.falls,
            found.path.len(),
            start.elapsed()
        );
        for h in &found.hinges {
            println!("   {} {} {:?} {}", h.joint, h.point, h.at, h.rotation);
        }
        for p in found.path.iter().step_by(1 + found.path.len() / 10) {
            println!("   {} {:?}", p.factor, p.reaction);
        }
    }
    let ring = Ring::semicircle(30, 0.15, 2.0);
    let zone = thrust_zone(&ring.model(), &Loading::default(), 0.0, &Settings::default()).unwrap();
    println!("{:?}", zone.least_thrust.unwrap()[0]);
}
