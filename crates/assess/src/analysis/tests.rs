//! Analyses of published bridges.

use super::*;
use crate::outcome::HingeAt;
use crate::samples::{bridgemill, case_two, semicircle};
use bridge::{ContactPoints, Method};

fn limit_load(mut b: Bridge, points: ContactPoints) -> f64 {
    b.plan.method = Method::Limit;
    b.plan.contact_points = points;
    collapse_by_limit(&b).unwrap().collapse_load.unwrap() / 1e3
}

#[test]
fn bridgemill_by_limit_analysis_carries_what_independent_programs_say() {
    // Independent linear programs print 231.46 and 219.37 (case 1): half a unit of their last digit. Theirs for case 2,
    // 398.8 and 376.5, put each column of fill in the middle of its voussoir; in its own place it carries 0.03 to 0.05 %
    // less.
    let cases = [
        (bridgemill(), ContactPoints::FullRing, 231.46, 5e-3),
        (bridgemill(), ContactPoints::Rounded, 219.37, 5e-3),
        (case_two(), ContactPoints::FullRing, 398.8, 0.4),
        (case_two(), ContactPoints::Rounded, 376.5, 0.4),
    ];
    for (bridge, points, expected, digit) in cases {
        let load = limit_load(bridge, points);
        assert!((load - expected).abs() <= digit, "{points:?}: {load} for {expected}");
    }
}

#[test]
fn the_mechanism_of_bridgemill_has_four_hinges_that_alternate() {
    let mut b = bridgemill();
    b.plan.method = Method::Limit;
    let c = collapse_by_limit(&b).unwrap();
    assert_eq!(c.status, Status::Collapsed);
    let edges: Vec<_> = c.hinges.iter().map(|h| h.edge).collect();
    let x: Vec<_> = c.hinges.iter().map(|h| h.point[0]).collect();
    assert!(x.windows(2).all(|w| w[0] < w[1]), "{x:?}");
    use HingeAt::{Extrados, Intrados};
    // The part between the left springing and the load turns down about the springing's intrados.
    assert_eq!(edges, [Intrados, Extrados, Intrados, Extrados], "{:?}", c.hinges);
    assert_eq!(c.picture.thrust_lines.len(), 1);
    assert_eq!(c.picture.thrust_lines[0].len(), 63);
    let codes: Vec<_> = c.warnings.iter().map(|w| w.code).collect();
    assert_eq!(codes, ["A102", "A110", "A104"]);
}

#[test]
fn the_least_thickness_of_a_semicircle_is_the_one_of_milankovitch() {
    let mut b = semicircle(10.0, 1.2, 200);
    b.plan.method = Method::Limit;
    b.plan.analysis = bridge::Analysis::Thickness;
    let c = collapse(&b, None, &mut mechanics::watch::Unwatched).unwrap();
    let t = c.thickness.unwrap();
    // 0.107478 for the curved ring; 200 sectors lie 0.01 % below it and flat faces change the weights' places by as
    // much: 0.2 % is the target.
    let ratio = t.over_mean_radius.unwrap();
    assert!((ratio / 0.107478 - 1.0).abs() < 2e-3, "{ratio}");
    // Five hinges: springings, haunches, crown. The haunch lies 54.484 degrees from the crown; joints are 0.9 degrees
    // apart.
    let angle = |p: [f64; 2]| (p[0] - 5.0).atan2(p[1]).to_degrees().abs();
    let haunches: Vec<_> = c.hinges.iter().filter(|h| h.edge == HingeAt::Intrados).map(|h| angle(h.point)).collect();
    assert!(!haunches.is_empty() && haunches.iter().all(|a| (a - 54.484).abs() < 0.9), "{:?}", c.hinges);
}

#[test]
fn a_sweep_finds_the_worst_place_and_does_not_depend_on_threads() {
    let mut b = bridgemill();
    b.plan.method = Method::Limit;
    let swept = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| sweep(&b, None, 41, true).unwrap())
    };
    let one = swept(1);
    assert_eq!(one, swept(2));
    let worst = &one.points[one.governing.unwrap()];
    // Symmetric bridge, knife edge: the worst place is near a quarter of the span.
    let share = worst.position / 18.3;
    assert!((0.15..0.35).contains(&share) || (0.65..0.85).contains(&share), "{share}");
    let (a, z) = (&one.points[10], &one.points[30]);
    // Mirror images: only the tolerance of the two programs apart.
    assert!((a.collapse_load.unwrap() / z.collapse_load.unwrap() - 1.0).abs() < 1e-6);
}

#[test]
fn a_bridge_without_loads_is_told_so() {
    let mut b = bridgemill();
    b.loads.clear();
    assert_eq!(collapse_by_limit(&b), Err(AnalysisError::NoLoad));
}

#[test]
fn a_joint_without_stiffness_is_named() {
    let mut b = bridgemill();
    b.joint.shear_stiffness = None;
    let got = collapse_by_dem(&b, None, &mut mechanics::watch::Unwatched);
    assert_eq!(got, Err(AnalysisError::NoStiffness { joint: "joints" }));
}

#[test]
fn bridgemill_by_discrete_elements_carries_the_published_loads() {
    // Printed to two decimals; loads are whole steps of 100 kN over 8.3 m, so the step decides and half a unit of the
    // last digit is room enough.
    for (b, stable, collapse) in [(bridgemill(), 204.82, 216.87), (case_two(), 325.30, 337.35)] {
        let c = collapse_by_dem(&b, None, &mut mechanics::watch::Unwatched).unwrap();
        assert_eq!(c.status, Status::Collapsed);
        assert!((c.last_stable_load.unwrap() / 1e3 - stable).abs() < 0.005);
        assert!((c.collapse_load.unwrap() / 1e3 - collapse).abs() < 0.005);
        use HingeAt::{Extrados, Intrados};
        let edges: Vec<_> = c.hinges.iter().map(|h| h.edge).collect();
        assert_eq!(edges, [Intrados, Extrados, Intrados, Extrados], "{:?}", c.hinges);
        assert!(c.sliding_joints.is_empty());
        assert_eq!(c.picture.thrust_lines[0].len(), 63);
    }
}
