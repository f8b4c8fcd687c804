//! Loads that act along the bridge: mirrored, moved down their line of action, convex in their direction, and with vehicles.

use super::*;
use crate::samples;
use bridge::{Dispersal, DispersalRule, Friction, LoadKind};
use mechanics::watch::Unwatched;
use outcome::note::{Moving, Note};

/// Bridgemill by limit analysis under a narrow load with so much of it to the right, on weightless cover.
fn pushed(x: f64, horizontal: f64, depth: f64) -> Bridge {
    let mut b = samples::case_two();
    b.plan.method = Method::Limit;
    b.plan.friction = Friction::Associated;
    b.masonry.compressive_strength = None;
    b.dispersal = Dispersal { rule: DispersalRule::None, slope: 1.0 };
    b.spans[0].rings[0].voussoirs = 15;
    b.cover.layers.truncate(1);
    (b.cover.layers[0].thickness, b.cover.layers[0].weighs, b.cover.depth) = (depth, false, depth);
    let load = &mut b.loads[0];
    (load.position, load.horizontal) = (x, horizontal);
    load.kind = LoadKind::KnifeEdge { force: 1e3, length: 1e-3 };
    b
}

fn factor(b: &Bridge) -> f64 {
    collapse(b, None, &mut Unwatched).unwrap().load_factor().unwrap()
}

#[test]
fn a_force_may_be_moved_along_its_line() {
    for share in [-0.3, 0.2, 0.4] {
        let high = factor(&pushed(5.0, share, 0.9));
        let low = factor(&pushed(5.0 + share * 0.4, share, 0.5));
        assert!((high / low - 1.0).abs() < 1e-6, "{share}: {high} {low}");
        // And it is not the same as on the surface below without the way.
        assert!((high / factor(&pushed(5.0, share, 0.5)) - 1.0).abs() > 1e-3);
    }
}

#[test]
fn what_pushes_is_mirrored_and_its_gauge_is_convex() {
    let span = pushed(0.0, 0.0, 0.5).spans[0].span;
    let mut gauges = Vec::new();
    for k in -4..=4 {
        let share = 0.1 * f64::from(k);
        let here = factor(&pushed(4.5, share, 0.5));
        let there = factor(&pushed(span - 4.5, -share, 0.5));
        assert!((here / there - 1.0).abs() < 1e-7, "{share}: {here} {there}");
        gauges.push(1.0 / here);
    }
    // What a direction of loads needs of the bridge's strength is a gauge: convex in the direction.
    for three in gauges.windows(3) {
        assert!(three[1] <= 0.5 * (three[0] + three[2]) * (1.0 + 1e-9), "{gauges:?}");
    }
    assert!(gauges[8] > 1.05 * gauges[0], "the way it pushes matters: {gauges:?}");
}

#[test]
fn vehicles_that_brake_are_never_lighter() {
    let mut b = samples::case_two();
    b.plan.method = Method::Limit;
    b.sweep = Some(bridge::SweepPlan { step: Some(2.0), ..vehicles::tests::plan(&["cs454-single"]) });
    let still = vehicle_sweep(&b, &mut Unwatched).unwrap();
    b.sweep.as_mut().unwrap().braking = 0.25;
    let brakes = vehicle_sweep(&b, &mut Unwatched).unwrap();
    let of = |found: &outcome::vehicles::VehicleSweep| found.vehicles[0].adequacy.unwrap();
    assert!(of(&brakes) < 0.999 * of(&still), "{} {}", of(&brakes), of(&still));
    let case = brakes.vehicles[0].case.clone().unwrap();
    assert!((case.horizontal.abs() - 0.25).abs() < 1e-12, "{case:?}");
    // The governing case by itself carries what the sweep says.
    let again = brakes.collapse.as_ref().unwrap().load_factor().unwrap();
    assert!((again / of(&brakes) - 1.0).abs() < 0.02, "{again} {}", of(&brakes));
    let codes: Vec<&str> = brakes.warnings.iter().map(|warning| warning.code()).collect();
    let told = |said: &Note| matches!(said, Note::Moving(Moving::Braking { share: 0.25, .. }));
    assert!(!codes.contains(&outcome::warning::NO_LONGITUDINAL) && brakes.assumptions.iter().any(told));
    // Fill as a continuum knows vertical loads only.
    let mut soft = b.clone();
    soft.sweep = None;
    soft.plan.method = Method::Fe;
    soft.loads[0].horizontal = 0.1;
    assert!(collapse(&soft, None, &mut Unwatched).is_err());
}
