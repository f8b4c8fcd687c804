//! Defects take away what they say: beside the same bridge described without them, and beside a sound one.

use super::*;
use crate::samples;
use bridge::defect::{Defect, DefectKind, Face};
use bridge::{Dispersal, DispersalRule, Ring, Span};
use mechanics::watch::Unwatched;
use outcome::collapse::Status;

/// Bridgemill by limit analysis, with points at the edges of sharp stones.
fn sound() -> Bridge {
    let mut b = samples::case_two();
    b.plan.method = Method::Limit;
    b.plan.friction = bridge::Friction::Associated;
    b.masonry.rounding = 0.0;
    b.masonry.compressive_strength = None;
    b.dispersal = Dispersal { rule: DispersalRule::Uniform, slope: 2.0 };
    b
}

/// Two rings that are bonded, of stones that crush.
fn two_rings() -> Bridge {
    let mut b = sound();
    let ring = Ring { crown_thickness: 0.3, springing_thickness: 0.3, voussoirs: 40 };
    b.spans[0] = Span { span: 8.0, rise: 2.0, rings: vec![ring; 2], ..b.spans[0].clone() };
    b.loads[0].position = 2.0;
    b.masonry.compressive_strength = Some(5e6);
    b.ring_joint.cohesion = 100e3;
    b
}

fn load(b: &Bridge) -> f64 {
    let found = as_described(b, None, &mut Unwatched).unwrap();
    match found.status {
        Status::Collapsed => found.carried().unwrap(),
        Status::UnstableUnderSelfWeight => 0.0,
        other => panic!("{other:?}"),
    }
}

fn with(b: &Bridge, kind: DefectKind, shares: [f64; 2]) -> Bridge {
    let mut b = b.clone();
    let from_to = shares.map(|share| share * b.spans[0].span);
    b.spans[0].defects.push(Defect { kind, from_to, shares });
    b
}

const WHOLE: [f64; 2] = [0.0, 1.0];

fn near(found: f64, expected: f64, share: f64) {
    assert!((found / expected - 1.0).abs() < share, "{found} in place of {expected}");
}

#[test]
fn a_ring_that_is_thinner_throughout_is_the_thinner_ring() {
    let (b, lost) = (sound(), 0.08);
    let above = with(&b, DefectKind::ThinRing { face: Face::Extrados, depth: lost }, WHOLE);
    let mut thinner = b.clone();
    (thinner.spans[0].rings[0].crown_thickness, thinner.spans[0].rings[0].springing_thickness) = (0.631, 0.631);
    // The surface stays where it is: the fill is that much deeper.
    thinner.cover.depth += lost;
    thinner.cover.layers[0].thickness += lost;
    near(load(&above), load(&thinner), 1e-9);

    // From below: the concentric arc.
    let below = with(&b, DefectKind::ThinRing { face: Face::Intrados, depth: lost }, WHOLE);
    let (half, rise) = (0.5 * b.spans[0].span, b.spans[0].rise);
    let radius = (half * half + rise * rise) / (2.0 * rise);
    let grown = (radius + lost) / radius;
    let mut arc = b.clone();
    let ring = Ring { crown_thickness: 0.631, springing_thickness: 0.631, ..b.spans[0].rings[0].clone() };
    arc.spans[0] = Span { span: 2.0 * half * grown, rise: rise * grown, rings: vec![ring], ..arc.spans[0].clone() };
    arc.loads[0].position += half * (grown - 1.0);
    near(load(&below), load(&arc), 1e-9);
    assert!(load(&below) < load(&b) && load(&above) < load(&b));
}

#[test]
fn joints_without_mortar_touch_where_it_begins() {
    let b = sound();
    let depth = 0.04;
    let both = [Face::Intrados, Face::Extrados]
        .into_iter()
        .fold(b.clone(), |b, face| with(&b, DefectKind::LostMortar { face, depth }, WHOLE));
    // Contact points that lie this far inside the edges, by another road: rounded stones.
    let mut rounded = b.clone();
    rounded.masonry.rounding = depth;
    rounded.plan.contact_points = bridge::ContactPoints::Rounded;
    // The corners that mortar leaves free weigh less than a thousandth of the ring.
    near(load(&both), load(&rounded), 1e-3);
    assert!(load(&both) < 0.9 * load(&b));
}

#[test]
fn weak_masonry_throughout_is_a_weak_bridge() {
    let b = two_rings();
    let kind = DefectKind::WeakMasonry { ring: None, compressive_strength: Some(2e6), friction_angle: Some(0.45) };
    let mut weak = b.clone();
    weak.masonry.compressive_strength = Some(2e6);
    weak.joint.friction_angle = 0.45;
    weak.ring_joint.friction_angle = 0.45;
    // The bond falls with the strength.
    weak.ring_joint.cohesion *= 2.0 / 5.0;
    near(load(&with(&b, kind, WHOLE)), load(&weak), 1e-7);
    let strong = DefectKind::WeakMasonry { ring: None, compressive_strength: Some(50e6), friction_angle: Some(1.2) };
    near(load(&with(&b, strong, WHOLE)), load(&b), 1e-9);
}

#[test]
fn rings_that_are_separated_throughout_have_no_bond() {
    let b = two_rings();
    let mut apart = b.clone();
    apart.ring_joint.cohesion = 0.0;
    let kind = DefectKind::RingSeparation { ring: 0, friction_angle: None };
    near(load(&with(&b, kind, WHOLE)), load(&apart), 1e-7);
    assert!(load(&apart) < 0.995 * load(&b), "{} {}", load(&apart), load(&b));
}

#[test]
fn a_lower_ring_that_is_gone_leaves_the_upper_one() {
    let mut b = two_rings();
    b.masonry.compressive_strength = None;
    let gone = with(&b, DefectKind::MissingStones, WHOLE);
    let radius = (16.0 + 4.0) / 4.0;
    let grown = (radius + 0.3) / radius;
    let mut upper = b.clone();
    let rings = vec![b.spans[0].rings[1].clone()];
    upper.spans[0] = Span { span: 8.0 * grown, rise: 2.0 * grown, rings, ..b.spans[0].clone() };
    upper.loads[0].position += 4.0 * (grown - 1.0);
    near(load(&gone), load(&upper), 1e-9);
}

/// Limit analysis with associated friction can only lose by less strength and less contact. A ring that is thinner weighs less too, and that
/// may help: it is not among these.
#[test]
fn a_defect_over_a_stretch_never_helps_and_grows_with_it() {
    let b = two_rings();
    let kinds = [
        DefectKind::LostMortar { face: Face::Intrados, depth: 0.06 },
        DefectKind::LostMortar { face: Face::Extrados, depth: 0.06 },
        DefectKind::WeakMasonry { ring: Some(1), compressive_strength: Some(1.5e6), friction_angle: None },
        DefectKind::RingSeparation { ring: 0, friction_angle: Some(0.4) },
    ];
    let all = load(&b);
    for kind in kinds {
        let mut before = all;
        for end in [0.22, 0.4, 0.7] {
            let found = load(&with(&b, kind, [0.2, end]));
            // The corners that mortar leaves free weigh something, and weight that goes may help by as much.
            assert!(found <= before * (1.0 + 1e-4), "{kind:?} to {end}: {found} after {before}");
            before = found;
        }
        assert!(before < 0.995 * all, "{kind:?} is felt: {before} of {all}");
    }
}

/// The load follows the place and the depth of a defect without jumps.
#[test]
fn the_load_follows_the_ends_of_a_stretch() {
    let b = sound();
    let at = |from: f64, depth: f64| {
        load(&with(&b, DefectKind::LostMortar { face: Face::Extrados, depth }, [from, from + 0.11]))
    };
    let loads: Vec<f64> = (0..12).map(|k| at(0.2 + 0.002 * f64::from(k), 0.1)).collect();
    for pair in loads.windows(2) {
        assert!((pair[1] / pair[0] - 1.0).abs() < 0.02, "{loads:?}");
    }
    assert!(at(0.2, 0.1) < at(0.2, 0.05) && at(0.2, 0.05) < load(&b));
}

/// The mirrored bridge with the mirrored defect carries the same.
#[test]
fn defects_have_no_side() {
    let b = sound();
    let mut mirrored = b.clone();
    mirrored.loads[0].position = b.spans[0].span - b.loads[0].position;
    let kinds = [
        DefectKind::LostMortar { face: Face::Intrados, depth: 0.07 },
        DefectKind::ThinRing { face: Face::Extrados, depth: 0.07 },
        DefectKind::ThinRing { face: Face::Intrados, depth: 0.07 },
    ];
    for kind in kinds {
        near(load(&with(&b, kind, [0.13, 0.37])), load(&with(&mirrored, kind, [0.63, 0.87])), 1e-7);
    }
}

/// Discrete elements and the equilibrium path feel them too.
#[test]
fn every_method_of_blocks_feels_a_defect() {
    let mut b = samples::bridgemill();
    b.plan.method = Method::Path;
    let kind = DefectKind::LostMortar { face: Face::Intrados, depth: 0.1 };
    let thin = DefectKind::ThinRing { face: Face::Extrados, depth: 0.1 };
    let (all, less, least) = (load(&b), load(&with(&b, kind, [0.6, 0.9])), load(&with(&b, thin, [0.6, 0.9])));
    assert!(less < 0.97 * all && least < 0.97 * all, "{all} {less} {least}");
}
