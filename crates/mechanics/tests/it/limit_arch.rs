//! The Bridgemill arch.

use crate::limit_models::Ring;
use mechanics::blocks::{Loading, PointForce};
use mechanics::ids::{BlockId, Id};
use mechanics::limit::{ContactPoints, Friction, Outcome, Settings, Status, collapse_load};
use mechanics::plane::vec2;

fn settings(contact_points: ContactPoints) -> Settings {
    Settings { contact_points, friction: Friction::Associated, ..Settings::default() }
}

fn solved(ring: &Ring, loading: &Loading, contact_points: ContactPoints) -> Outcome {
    let outcome = collapse_load(&ring.model(), loading, &settings(contact_points)).unwrap();
    assert_eq!(outcome.status, Status::Solved);
    outcome
}

fn assert_bounds(outcome: &Outcome) {
    let factor = outcome.factor.unwrap();
    let (lower, upper) = (outcome.lower_bound.unwrap(), outcome.upper_bound.unwrap());
    println!("factor {factor:.9} lower {lower:.9} upper {upper:.9} residual {:e} yield {:e} flow {:e} iterations {}",
        outcome.equilibrium_residual, outcome.yield_violation, outcome.flow_violation, outcome.iterations);
    assert!((lower - factor).abs() < 1e-6 * factor);
    assert!((upper - factor).abs() < 1e-6 * factor);
    assert!(outcome.equilibrium_residual < 1e-8 && outcome.yield_violation < 1e-8 && outcome.flow_violation < 1e-6);
}

#[test]
fn bridgemill_under_the_dispersed_knife() {
    let ring = Ring::bridgemill();
    for (points, expected) in [(ContactPoints::Rounded, 219.37e3), (ContactPoints::FullRing, 231.46e3)] {
        let outcome = solved(&ring, &ring.quarter_knife(), points);
        assert_bounds(&outcome);
        // Printed to two decimals of a kilonewton.
        assert!((outcome.factor.unwrap() - expected).abs() < 0.01e3, "{:?}", outcome.factor);
        let mechanism = outcome.mechanism.unwrap();
        println!("{:?} {:?}", mechanism.hinges, mechanism.sliding);
        assert_eq!(mechanism.hinges.len(), 4);
        assert!(mechanism.sliding.is_empty());
    }
}

#[test]
fn bridgemill_under_a_point_load() {
    let ring = Ring::bridgemill();
    let x = 4.575 - 9.15;
    let k = ((x / ring.extrados()).asin() + ring.half_angle) / (2.0 * ring.half_angle) * 62.0;
    let (p, q) = (ring.at(k.floor(), ring.extrados()), ring.at(k.floor() + 1.0, ring.extrados()));
    let at = vec2(x, p.y + (q.y - p.y) * (x - p.x) / (q.x - p.x));
    let force = PointForce { block: BlockId::new(k as usize + 1), at, force: vec2(0.0, -1.0) };
    let loading = Loading { variable: vec![force], ..Loading::default() };
    let outcome = solved(&ring, &loading, ContactPoints::FullRing);
    assert_bounds(&outcome);
    assert!((outcome.factor.unwrap() - 196.97e3).abs() < 0.01e3, "{:?}", outcome.factor);
}

#[test]
fn time() {
    let ring = Ring::bridgemill();
    let model = ring.model();
    let loading = ring.quarter_knife();
    for _ in 0..5 {
        let start = std::time::Instant::now();
        for _ in 0..20 {
            std::hint::black_box(collapse_load(&model, &loading, &settings(ContactPoints::FullRing)).unwrap());
        }
        println!("{:?}", start.elapsed() / 20);
        let start = std::time::Instant::now();
        for _ in 0..20 {
            std::hint::black_box(mechanics::blocks::interfaces(&model, 1e-6).unwrap());
        }
        println!("  interfaces {:?}", start.elapsed() / 20);
    }
}
