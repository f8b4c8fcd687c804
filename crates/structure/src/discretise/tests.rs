//! Geometry and loads of the discretised bridge against hand calculations and published figures.

use super::*;
use crate::samples::{bridgemill, semicircle, spans};
use bridge::{DispersalRule, Layer, LayerKind, Load, LoadKind, Ring};
use mechanics::blocks::Held;
use mechanics::ids::BlockId;
use mechanics::plane::vec2;

/// Reading of eq. 2 at the published bridge; the figures are printed to four decimals, so 1e-3 is their last digit
/// with room for the flat faces.
const PRINTED: f64 = 1e-3;

#[test]
fn the_bridgemill_load_spreads_as_its_paper_says() {
    let d = discretise(&bridgemill()).unwrap();
    let s = &d.spreads[0];
    let f = s.strip.force;
    let found = [s.depths[0], s.depths[1], s.ends[1].x - s.ends[0].x, s.pressures[0] / f, s.pressures[1] / f];
    for (value, expected) in found.iter().zip([1.4671, 0.9011, 1.9341, 0.3935, 0.6406]) {
        assert!((value - expected).abs() < PRINTED, "{found:?}");
    }
}

#[test]
fn the_bridgemill_ring_has_the_published_spacing_weight_and_blocks() {
    let d = discretise(&bridgemill()).unwrap();
    assert_eq!(d.model.blocks.len(), 64);
    let (a, b) = (&d.model.blocks[BlockId(30)].outline, &d.model.blocks[BlockId(31)].outline);
    // d_cm of Table 1: 0.3208 m, four printed digits; the flat faces take some 1e-5 m off the curve's own spacing.
    let spacing = (a.centroid() - b.centroid()).norm();
    assert!((spacing - 0.3208).abs() < 1e-4, "{spacing}");
    // 291.33 kN/m: an independent calculation, printed to five digits.
    assert!((d.model.free_weight() / 291.33e3 - 1.0).abs() < 1e-4, "{}", d.model.free_weight());
}

#[test]
fn every_rule_hands_on_the_whole_load() {
    for rule in [DispersalRule::None, DispersalRule::Uniform, DispersalRule::InverseDepth, DispersalRule::Boussinesq] {
        for position in [-3.0, -1.0, 0.2, 4.575, 9.15, 18.0, 25.0] {
            let mut b = bridgemill();
            b.dispersal.rule = rule;
            b.loads[0].position = position;
            let d = discretise(&b).unwrap();
            let s = &d.spreads[0];
            let down: f64 = s.forces.iter().map(|f| -f.force.y).sum();
            // Only round-off: every piece of the pressure is integrated exactly, or scaled to the whole.
            assert!((down + s.to_ground - s.strip.force).abs() < 1e-9 * s.strip.force, "{rule:?} at {position}");
            if s.to_ground == 0.0 {
                let moment: f64 = s.forces.iter().map(|f| -f.force.y * f.at.x).sum();
                let at = s.strip.middle + s.shift;
                assert!((moment - s.strip.force * at).abs() < 1e-9 * s.strip.force * 18.3, "{rule:?} at {position}");
            }
            if rule == DispersalRule::None {
                assert!(s.shift.abs() < 1e-9);
            }
        }
    }
}

#[test]
fn a_trapezoid_moves_the_load_towards_its_shallow_end_by_what_its_centroid_says() {
    let d = discretise(&bridgemill()).unwrap();
    let s = &d.spreads[0];
    let (q1, q2) = (s.pressures[0], s.pressures[1]);
    let length = s.ends[1].x - s.ends[0].x;
    let centroid = 0.5 * (s.ends[0].x + s.ends[1].x) + length / 6.0 * (q2 - q1) / (q1 + q2);
    assert!((centroid - s.strip.middle - s.shift).abs() < 1e-12);
    // The published rule is not in moment equilibrium with the load: 6 cm here.
    assert!(s.shift < -0.05 && s.shift > -0.08, "{}", s.shift);
}

#[test]
fn a_strip_partly_behind_the_abutment_goes_to_the_ground_in_part() {
    let mut b = bridgemill();
    b.dispersal.rule = DispersalRule::None;
    b.loads[0].position = d_edge();
    let d = discretise(&b).unwrap();
    // Half of the strip stands on the abutment: round-off only.
    assert!((d.spreads[0].to_ground / d.spreads[0].strip.force - 0.5).abs() < 1e-9);
}

fn d_edge() -> f64 {
    discretise(&bridgemill()).unwrap().extrados.stretches[0].right.x
}

#[test]
fn a_load_does_not_run_down_a_steep_haunch() {
    let load = |rule: DispersalRule| {
        let mut b = semicircle(4.0, 0.35, 41);
        b.cover = bridgemill().cover;
        b.cover.layers = vec![crate::samples::fill(0.75, 1900.0)];
        b.cover.depth = 0.75;
        b.dispersal.rule = rule;
        b.loads = bridgemill().loads;
        b.loads[0].kind = LoadKind::KnifeEdge { force: 1e3, length: 0.3 };
        b.loads[0].position = 1.0;
        let spread = discretise(&b).unwrap().spreads[0].clone();
        b.plan.method = bridge::Method::Limit;
        (
            spread,
            assess::analysis::collapse_by_limit(&b, &mut mechanics::watch::Unwatched).unwrap().collapse_load.unwrap(),
        )
    };
    let (uniform, carried) = load(DispersalRule::Uniform);
    let down: f64 = uniform.forces.iter().map(|f| -f.force.y).sum();
    assert!((down / uniform.strip.force - 1.0).abs() < 1e-9, "all of it reaches the ring: {uniform:?}");
    // CS 454: the contact length and the depth, 2 to 1 on either side; 0.97 m of cover lie below the middle.
    let length = uniform.ends[1].x - uniform.ends[0].x;
    assert!(length > 0.3 && length < 0.3 + 0.97, "{length}");
    let (_, below) = load(DispersalRule::None);
    assert!(carried > below && carried < 2.0 * below, "{carried} {below}");
    for rule in [DispersalRule::InverseDepth, DispersalRule::Boussinesq] {
        let (spread, _) = load(rule);
        assert!(spread.to_ground.abs() < 1e-9 * spread.strip.force, "{rule:?}: {spread:?}");
    }
}

#[test]
fn axles_that_share_a_voussoir_add() {
    let mut b = bridgemill();
    b.loads = vec![Load {
        name: "bogie".into(),
        kind: LoadKind::Axles { axles: vec![(100e3, 0.0), (100e3, 0.2)], contact_length: 0.3, effective_width: 4.0 },
        position: 6.0,
        block: None,
        horizontal: 0.0,
        whole_length: false,
    }];
    let d = discretise(&b).unwrap();
    assert_eq!(d.spreads.len(), 2);
    assert!((d.spreads[0].strip.middle - d.spreads[1].strip.middle - 0.2).abs() < 1e-12);
    let down: f64 = d.loading.variable.iter().map(|f| -f.force.y).sum();
    assert!((down - 50e3).abs() < 1e-6);
    assert!((d.reference_load - 50e3).abs() < 1e-9);
}

#[test]
fn the_cover_weighs_what_the_area_above_the_ring_weighs() {
    let mut b = bridgemill();
    b.cover.depth = 0.478;
    let layer = |name, thickness, density| Layer {
        name,
        thickness,
        density,
        weighs: true,
        elastic_modulus: None,
        friction_angle: None,
        cohesion: None,
        particles: false,
        slabs: None,
        continuum: false,
        tensile_strength: None,
    };
    b.cover.layers = vec![layer(LayerKind::Fill, 0.203, 1890.0), layer(LayerKind::SubBase, 0.125, 2000.0)];
    let d = discretise(&b).unwrap();
    let free: Vec<_> = d.extrados.stretches.iter().filter(|s| !s.ground).collect();
    let top = d.extrados.crown() + 0.203;
    let mut expected = Vec2::ZERO;
    for s in &free {
        let (a, c, run) = (top - s.left.y, top - s.right.y, s.right.x - s.left.x);
        let force = 9.81 * run * (1890.0 * 0.5 * (a + c) + 2000.0 * 0.125);
        expected.x += force;
    }
    let down: f64 = d.loading.permanent.iter().map(|f| -f.force.y).sum();
    assert!((down / expected.x - 1.0).abs() < 1e-12);
    // Symmetric about the crown: the moment about it vanishes up to round-off of the sums.
    let moment: f64 = d.loading.permanent.iter().map(|f| -f.force.y * (f.at.x - 9.15)).sum();
    assert!(moment.abs() < 1e-6 * down);
    b.cover.layers[1].weighs = false;
    let lighter: f64 = discretise(&b).unwrap().loading.permanent.iter().map(|f| -f.force.y).sum();
    let span: f64 = free.iter().map(|s| s.right.x - s.left.x).sum();
    assert!(((down - lighter) / (9.81 * 250.0 * span) - 1.0).abs() < 1e-9);
}

#[test]
fn backing_takes_the_place_of_fill_below_its_level() {
    let mut b = bridgemill();
    b.cover.layers = vec![Layer {
        name: LayerKind::Fill,
        thickness: 0.2,
        density: 1000.0,
        weighs: true,
        elastic_modulus: None,
        friction_angle: None,
        cohesion: None,
        particles: false,
        slabs: None,
        continuum: false,
        tensile_strength: None,
    }];
    let weight = |b: &Bridge| -> f64 { discretise(b).unwrap().loading.permanent.iter().map(|f| -f.force.y).sum() };
    let without = weight(&b);
    b.cover.backing = Some(bridge::Backing {
        height: 1.5,
        density: 1000.0,
        width_share: 1.0,
        elastic_modulus: None,
        poisson_ratio: None,
        body: bridge::BackingBody::Weight,
        tensile_strength: None,
        compressive_strength: None,
        friction_angle: None,
        cohesion: None,
    });
    assert!((weight(&b) / without - 1.0).abs() < 1e-12, "equal densities weigh the same");
    b.cover.backing = Some(crate::samples::backing(1.5));
    assert!(weight(&b) > 1.05 * without);
}

#[test]
fn rings_with_different_numbers_of_voussoirs_fit_without_gap_or_overlap() {
    let mut b = bridgemill();
    let ring = |voussoirs| Ring { crown_thickness: 0.25, springing_thickness: 0.3, voussoirs };
    b.spans[0].rings = vec![ring(40), ring(43), ring(47)];
    let d = discretise(&b).unwrap();
    // The rings together: area between the lowest beds and the uppermost backs, which tile it exactly.
    let mut boundary: Vec<Vec2> = Vec::new();
    let (mut low, mut high) = (Vec::new(), Vec::new());
    for (id, o) in d.origins.pairs() {
        if let (Origin::Voussoir { ring, .. }, Some(f)) = (*o, d.faces[id]) {
            if ring == 0 {
                low.push(f.bed[0]);
                low.push(f.bed[1]);
            }
            if ring == 2 {
                high.push(f.back[0]);
                high.push(f.back[1]);
            }
        }
    }
    boundary.extend(low);
    boundary.extend(high.into_iter().rev());
    let n = boundary.len();
    let area = 0.5 * (0..n).map(|i| boundary[i].cross(boundary[(i + 1) % n])).sum::<f64>();
    let sum: f64 = d.model.blocks.iter().filter(|b| b.held == Held::FREE).map(|b| b.outline.area()).sum();
    // Round-off of a sum of some hundred products.
    assert!((area - sum).abs() < 1e-10, "{area} {sum}");
    // Ring joints carry the ring law's name: contacts between groups of one span differ where it differs.
    let touching = mechanics::blocks::interfaces(&d.model, 1e-9).unwrap();
    let across = touching.iter().filter(|t| d.model.blocks[t.first].group != d.model.blocks[t.second].group);
    assert!(across.count() >= 40 + 43 + 43 + 47 - 4);
}

#[test]
fn a_semicircle_springs_from_level_skewbacks() {
    let d = discretise(&semicircle(10.0, 1.0, 60)).unwrap();
    let touching = mechanics::blocks::interfaces(&d.model, 1e-9).unwrap();
    assert_eq!(touching.len(), 61);
    assert!(touching.iter().all(|t| t.points.len() == 2));
    // The skewback is level: its normal is vertical up to round-off of the normals.
    assert!(touching.iter().any(|t| t.normal.x.abs() < 1e-12));
}

#[test]
fn piers_carry_both_springings_and_stand_on_their_foundations() {
    for span in [semicircle(6.0, 0.4, 30).spans[0].clone(), bridgemill().spans[0].clone()] {
        let b = spans(vec![span.clone(), span.clone(), span], 1.6, 1.8, 5.0, 4);
        let d = discretise(&b).unwrap();
        let touching = mechanics::blocks::interfaces(&d.model, 1e-9).unwrap();
        let voussoirs = 3 * b.spans[0].rings[0].voussoirs;
        // Joints: each span has one more than voussoirs, each pier one per course.
        assert_eq!(touching.len(), voussoirs + 3 + 2 * 4);
        assert!(touching.iter().all(|t| t.points.len() == 2));
        let free = d.extrados.stretches.windows(2).all(|w| (w[0].right.x - w[1].left.x).abs() < 1e-9);
        assert!(free, "the extrados has a hole");
    }
}

#[test]
fn a_pier_too_narrow_for_its_rings_is_an_error_with_a_number() {
    let span = semicircle(6.0, 0.9, 30).spans[0].clone();
    let b = spans(vec![span.clone(), span], 1.6, 1.8, 5.0, 4);
    assert!(matches!(discretise(&b), Err(DiscretiseError::RingsCross { support: 1, .. })));
}

#[test]
fn a_turning_abutment_moves_its_centroid_along() {
    let mut b = bridgemill();
    b.plan.support_movement = Some(bridge::SupportMovement {
        support: 1,
        horizontal: 0.0,
        vertical: 0.0,
        rotation: 1.0,
        before: None,
        increment: None,
        limit: None,
    });
    let d = discretise(&b).unwrap();
    let m = d.loading.movements[0];
    let centre = d.model.blocks[m.block].outline.centroid();
    let pivot = vec2(18.3, 0.0);
    let at_pivot = m.translation + (pivot - centre).left() * m.rotation;
    assert!(at_pivot.norm() < 1e-12);
    b.plan.support_movement.as_mut().unwrap().support = 2;
    assert!(matches!(discretise(&b), Err(DiscretiseError::NoSuchSupport { support: 2, last: 1 })));
}
