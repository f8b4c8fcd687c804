//! Arches in a continuum: a fluid presses as block limit analysis has it, and soil carries no less than its weight would.

use crate::continuum_tools::{SMOOTH, ground, soil};
use crate::limit_models::Ring;
use mechanics::blocks::{BlockModel, Loading, PointForce};
use mechanics::ids::{BlockId, Id};
use mechanics::limit::continuum::{
    Bears, Bounds, BoundsStatus, Contact, Continuum, Region, Side, Soil, Wanted, collapse_bounds,
};
use mechanics::limit::{Friction, Settings, collapse_load};
use mechanics::plane::{Vec2, vec2};
use mechanics::watch::Pace;

const WEIGHT: f64 = 18_000.0;

/// Bridgemill's ring under soil up to a level above the crown, between plumb walls at its springings.
fn filled(ring: &Ring, above: f64, soil: Soil, contact: Contact) -> Continuum {
    let floor: Vec<Vec2> = (0..=ring.voussoirs).map(|k| ring.at(k as f64, ring.extrados())).collect();
    let top = ring.extrados() + above;
    let (left, right) = (floor[0], floor[ring.voussoirs]);
    let mut outline = floor.clone();
    outline.extend([vec2(right.x, top), vec2(left.x, top)]);
    let mut sides: Vec<Side> = floor
        .windows(2)
        .enumerate()
        .map(|(k, ends)| Side {
            ends: [ends[0], ends[1]],
            bears: Bears::Body { block: Some(BlockId::new(k + 1)), contact },
        })
        .collect();
    sides.push(ground(right, vec2(right.x, top), SMOOTH));
    sides.push(ground(vec2(left.x, top), left, SMOOTH));
    Continuum { regions: vec![Region { outline, soil }], sides, water: None }
}

fn pushed(ring: &Ring) -> Loading {
    let at = ring.at(16.5, ring.extrados());
    Loading {
        variable: vec![PointForce { block: BlockId::new(17), at, force: vec2(0.0, -1000.0) }],
        ..Loading::default()
    }
}

fn bounds(model: &BlockModel, loading: &Loading, earth: &Continuum, ratio: f64, elements: usize) -> Bounds {
    let settings = Settings { friction: Friction::Associated, ..Settings::default() };
    let wanted = Wanted { ratio, elements, first: 400 };
    collapse_bounds(model, loading, &settings, earth, &wanted, &Pace::default()).unwrap()
}

#[test]
fn a_fluid_presses_on_a_ring_as_its_depth_says() {
    let ring = Ring::bridgemill();
    let model = ring.model();
    let earth = filled(&ring, 0.5, soil(0.0, 0.0, WEIGHT), SMOOTH);
    let both = bounds(&model, &pushed(&ring), &earth, 1.0 + 1e-5, 400);
    // The same pressure as forces: linear along each back.
    let top = ring.extrados() + 0.5;
    let mut loading = pushed(&ring);
    for k in 0..ring.voussoirs {
        let (a, b) = (ring.at(k as f64, ring.extrados()), ring.at(k as f64 + 1.0, ring.extrados()));
        let inwards = (b - a).right();
        for (near, far) in [(a, b), (b, a)] {
            let force = inwards * (0.5 * WEIGHT * (top - near.y));
            let at = (near * 2.0 + far) * (1.0 / 3.0);
            loading.permanent.push(PointForce { block: BlockId::new(k + 1), at, force });
        }
    }
    let settings = Settings { friction: Friction::Associated, ..Settings::default() };
    let exact = collapse_load(&model, &loading, &settings).unwrap().factor.unwrap();
    for factor in [both.lower.unwrap().factor, both.upper.unwrap().factor] {
        assert!((factor / exact - 1.0).abs() < 1e-6, "{factor} {exact}");
    }
}

#[test]
fn soil_carries_more_than_its_weight_and_stronger_soil_more_than_weak() {
    let ring = Ring::bridgemill();
    let model = ring.model();
    let loading = pushed(&ring);
    let mut last = 0.0;
    for degrees in [5.0, 20.0, 35.0] {
        let s = soil(0.0, degrees, WEIGHT);
        let contact = Contact { friction: s.friction_angle.tan() * 0.66, cohesion: 0.0, tension: 0.0 };
        let found = bounds(&model, &loading, &filled(&ring, 0.5, s, contact), 1.1, 1500);
        assert_eq!(found.status, BoundsStatus::Bounded);
        let (lower, upper) = (found.lower.as_ref().unwrap().factor, found.upper.as_ref().unwrap().factor);
        assert!(lower <= upper && lower > last, "{degrees}: {lower} {upper} after {last}");
        assert!(found.ratio().unwrap() < 1.1, "{:?}", found.rounds);
        // The gap is spread over the triangles, and none holds less than nothing.
        let (sum, power) = (found.gaps.iter().sum::<f64>(), found.upper.as_ref().unwrap().power);
        assert!(sum / power <= (upper - lower) * (1.0 + 1e-3) + 1e-6 * upper, "{sum} {power}");
        assert!(found.gaps.iter().all(|g| *g > -1e-5 * upper * power));
        last = lower;
    }
}

#[test]
fn an_arch_without_soil_is_that_of_block_limit_analysis() {
    // Soil beside it that it never touches.
    let ring = Ring::bridgemill();
    let model = ring.model();
    let corners = [vec2(100.0, 0.0), vec2(101.0, 0.0), vec2(101.0, 1.0), vec2(100.0, 1.0)];
    let earth = Continuum {
        regions: vec![Region { outline: corners.to_vec(), soil: soil(1e4, 30.0, WEIGHT) }],
        sides: vec![ground(corners[0], corners[1], SMOOTH)],
        water: None,
    };
    let both = bounds(&model, &pushed(&ring), &earth, 1.0 + 1e-6, 200);
    let settings = Settings { friction: Friction::Associated, ..Settings::default() };
    let exact = collapse_load(&model, &pushed(&ring), &settings).unwrap().factor.unwrap();
    for factor in [both.lower.unwrap().factor, both.upper.unwrap().factor] {
        assert!((factor / exact - 1.0).abs() < 1e-6, "{factor} {exact}");
    }
}
