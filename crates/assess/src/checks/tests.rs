//! Checks on facts made by hand.

use super::*;
use crate::wire::{AugmentFacts, JointFacts, PlaceFacts, ServiceFacts, ServiceLoadFacts, UltimateFacts};
use bridge::assess::{Assess, Limits};

fn place(place: &str, quantity: &str, self_weight: f64, minimum: f64, maximum: f64) -> PlaceFacts {
    PlaceFacts {
        place: place.into(),
        quantity: quantity.into(),
        about: format!("{place} of span 1"),
        span: 1,
        face: "intrados".into(),
        self_weight,
        minimum,
        minimum_at_m: 3.0,
        maximum,
        maximum_at_m: 9.0,
    }
}

/// The numbers of the railway paper's first two rows: live load at rest is the printed column over 1 + CDA.
fn assessment() -> Assessment {
    let bridge = crate::samples::bridgemill();
    let live = -0.67 / 1.817;
    let load = ServiceLoadFacts {
        name: "25t".into(),
        places: vec![
            place("crown", "deflection", 0.09, live, 0.01),
            place("crown", "stress", 0.009, -0.04, 0.001),
            place("abutment", "stress", -0.83, -0.37, 0.1),
        ],
        joints: vec![JointFacts {
            reading: "total".into(),
            augment: 0.817,
            shear_mpa: 0.4,
            eccentricity: 0.2,
            ..JointFacts::default()
        }],
        ..ServiceLoadFacts::default()
    };
    let augment = AugmentFacts { total: 0.817, design: 0.6, ..AugmentFacts::default() };
    let service = ServiceFacts { augment, loads: vec![load], ..ServiceFacts::default() };
    let ultimate = UltimateFacts { status: "collapsed".into(), load_factor: Some(4.0), ..UltimateFacts::default() };
    let limits = Limits {
        deflection: Some(1.25e-3),
        compression: Some(2.589e6),
        tension: Some(0.2589e6),
        joint_shear: Some(1e6),
        thrust_zone: Some(0.5),
        adequacy_factor: Some(2.0),
        permissible_share: Some(0.5),
        movement_factor: 1.0,
        ..Limits::default()
    };
    Assessment {
        bridge,
        asked: Assess { limits, ..Assess::default() },
        update: Stage::NotAsked("no records".into()),
        service: Stage::Made(service),
        ultimate: Stage::Made(ultimate),
        vehicles: Stage::NotAsked("no sweep".into()),
        movement: Stage::NotAsked("no support moves".into()),
        sensitivity: Stage::NotAsked("later".into()),
    }
}

#[test]
fn the_crown_has_the_columns_of_table_7() {
    let found = crown_deflection::CrownDeflection.run(&assessment()).unwrap();
    let [own, design, sum, total, whole] = found[1].columns.unwrap();
    // Printed to hundredths: -0.59, -0.50, -0.67, -0.58 mm.
    for (ours, printed) in [(own, 0.09), (design, -0.59), (sum, -0.50), (total, -0.67), (whole, -0.58)] {
        assert!((ours - printed).abs() < 0.006, "{ours} {printed}");
    }
    assert!((found[1].utilisation - 0.58 / 1.25).abs() < 1e-9 && found[1].met());
}

#[test]
fn codes_are_unique_and_in_order_and_say_something() {
    let cards: Vec<Card> = cards().collect();
    assert!(cards.windows(2).all(|pair| pair[0].code < pair[1].code));
    assert!(cards.iter().all(|card| card.text.len() > 100 && !card.source.is_empty() && !card.clause.is_empty()));
}

#[test]
fn the_largest_utilisation_governs_and_failures_leave_nothing_settled() {
    let mut a = assessment();
    let checked = run(&a);
    let (check, finding) = governing(&checked).unwrap();
    let worst = &checked[check].outcome.as_ref().unwrap()[finding];
    // 0.2 of the depth against 0.25.
    assert_eq!((checked[check].card.code, worst.utilisation), ("C106", 0.8));
    assert_eq!(verdict(&checked).status, "adequate");
    a.ultimate = Stage::Failed("no answer".into());
    assert_eq!(verdict(&run(&a)).status, "undetermined");
    a.asked.limits.joint_shear = Some(0.3e6);
    assert_eq!(verdict(&run(&a)).status, "inadequate");
    a.asked = Assess::default();
    a.ultimate = Stage::NotAsked("no load".into());
    assert_eq!(verdict(&run(&a)).status, "undetermined");
}

#[test]
fn the_stress_range_follows_its_bound() {
    let mut a = assessment();
    a.asked.limits.load_cycles = Some(1e6);
    let why = fatigue::StressRange.run(&a).unwrap_err();
    assert!(why.why.contains("compressive_strength"), "{}", why.why);
    a.bridge.masonry.compressive_strength = Some(10e6);
    let found = fatigue::StressRange.run(&a).unwrap();
    // Abutment: most 0.83 + 1.6 x 0.37 = 1.422, least 0.83 - 0.16 = 0.67; root of 0.752 x 1.422 over 10.
    assert!((found[0].value - (0.752_f64 * 1.422).sqrt() / 10.0).abs() < 1e-12);
    assert!((found[0].limit - 0.4).abs() < 1e-12);
}

#[test]
fn a_limit_of_nothing_is_met_by_nothing_else() {
    assert_eq!((used(0.0, 0.0), used(-1.0, 0.0), used(1.0, 0.0)), (0.0, 0.0, f64::MAX));
}

#[test]
fn a_thrust_without_a_zone_is_told_and_not_judged() {
    let mut a = assessment();
    a.asked.limits.thrust_zone = None;
    let why = thrust::ThrustZone.run(&a).unwrap_err();
    assert!(!why.failed && why.why.contains("thrust_zone =") && why.why.contains("0.200 of the depth"), "{}", why.why);
    a.service = Stage::NotAsked("no train".into());
    assert!(!thrust::ThrustZone.run(&a).unwrap_err().why.contains("in service"));
}
