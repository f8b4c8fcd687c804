//! Arches in a continuum: a fluid presses as block limit analysis has it, and soil carries no less than its weight would.

use crate::continuum_tools::{SMOOTH, ends, ground, soil};
use crate::limit_models::{Ring, block, dry};
use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, PointForce};
use mechanics::ids::{BlockId, GroupId, Id};
use mechanics::limit::continuum::{
    Bears, Bounds, BoundsStatus, Contact, Continuum, Region, Setting, Side, Soil, Wanted, Which, bound_on,
    collapse_bounds,
};
use mechanics::limit::{Friction, Settings, collapse_load};
use mechanics::plane::{Polygon, Vec2, vec2};
use mechanics::watch::CancelToken;

const WEIGHT: f64 = 18_000.0;

/// A ring under layers of soil between plumb walls at its springings; each has a thickness [m], the lowest that above the crown.
pub(crate) fn layered(ring: &Ring, layers: &[(f64, Soil)], contact: Contact) -> Continuum {
    let floor: Vec<Vec2> = (0..=ring.voussoirs).map(|k| ring.at(k as f64, ring.extrados())).collect();
    let mut sides: Vec<Side> = floor
        .windows(2)
        .enumerate()
        .map(|(k, ends)| Side {
            ends: [ends[0], ends[1]],
            bears: Bears::Body { block: Some(BlockId::new(k + 1)), contact },
        })
        .collect();
    let (mut regions, mut below, mut level) = (Vec::new(), floor, ring.extrados());
    for &(thickness, soil) in layers {
        level += thickness;
        let (left, right) = (below[0], below[below.len() - 1]);
        let top = [left, right].map(|end| vec2(end.x, level));
        sides.extend([ground(right, top[1], SMOOTH), ground(top[0], left, SMOOTH)]);
        let mut outline = std::mem::replace(&mut below, top.to_vec());
        outline.extend([top[1], top[0]]);
        regions.push(Region { outline, soil });
    }
    Continuum { regions, sides, water: None, panels: Vec::new() }
}

/// A ring under soil up to a level above the crown, between plumb walls at its springings.
fn filled(ring: &Ring, above: f64, soil: Soil, contact: Contact) -> Continuum {
    layered(ring, &[(above, soil)], contact)
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
    let wanted = Wanted { ratio, elements, first: 400, ..Wanted::default() };
    let setting = Setting::new(model, loading, &settings, earth).unwrap();
    collapse_bounds(&setting, &wanted, &CancelToken::default()).unwrap()
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
        panels: Vec::new(),
    };
    let both = bounds(&model, &pushed(&ring), &earth, 1.0 + 1e-6, 200);
    let settings = Settings { friction: Friction::Associated, ..Settings::default() };
    let exact = collapse_load(&model, &pushed(&ring), &settings).unwrap().factor.unwrap();
    for factor in [both.lower.unwrap().factor, both.upper.unwrap().factor] {
        assert!((factor / exact - 1.0).abs() < 1e-6, "{factor} {exact}");
    }
}

#[test]
fn layers_of_one_soil_are_one_layer_and_a_stronger_one_carries_no_less() {
    let ring = Ring::bridgemill();
    let (model, loading) = (ring.model(), pushed(&ring));
    let weak = soil(0.0, 25.0, WEIGHT);
    let contact = Contact { friction: 0.3, cohesion: 0.0, tension: 0.0 };
    let two = |top: Soil| layered(&ring, &[(0.25, weak), (0.25, top)], contact);
    let whole = bounds(&model, &loading, &filled(&ring, 0.5, weak, contact), 1.05, 1500);
    let cut = bounds(&model, &loading, &two(weak), 1.05, 1500);
    // The same body on two meshes: each bound holds for both.
    let [[a, b], [c, d]] = [ends(&whole), ends(&cut)];
    assert!(a <= d && c <= b && b <= 1.05 * a && d <= 1.05 * c, "{a} {b} {c} {d}");
    // On one mesh neither bound falls where a layer grows stronger: what was within strength still is.
    let settings = Settings { friction: Friction::Associated, ..Settings::default() };
    let (mut last, mesh) = ([c, d], &cut.mesh);
    for top in [soil(0.0, 35.0, WEIGHT), soil(5e3, 35.0, WEIGHT), soil(50e3, 35.0, WEIGHT)] {
        let earth = two(top);
        let setting = Setting::new(&model, &loading, &settings, &earth).unwrap();
        let lower = bound_on(Which::Lower, &setting, mesh, &CancelToken::default()).unwrap();
        let upper = bound_on(Which::Upper, &setting, mesh, &CancelToken::default()).unwrap();
        assert!(lower > last[0] && upper > last[1] && lower <= upper, "{lower} {upper} after {last:?}");
        last = [lower, upper];
    }
}

/// A ring of 4 m of span and 1 m of rise of its intrados, of sharp-edged voussoirs.
fn small() -> Ring {
    let half_angle = 0.8f64.asin();
    Ring { intrados: 2.5, thickness: 0.25, half_angle, voussoirs: 12, rounding: 0.0, density: 2000.0, friction: 0.7 }
}

/// A load on the back of the fourth voussoir of that ring; a factor of one is 1 kN/m.
fn on_the_quarter(ring: &Ring) -> Loading {
    let at = ring.at(3.5, ring.extrados());
    let force = vec2(0.0, -1000.0);
    Loading { variable: vec![PointForce { block: BlockId::new(4), at, force }], ..Loading::default() }
}

/// Soil rubs on stone and takes no tension there.
const RUBS: Contact = Contact { friction: 0.4, cohesion: 0.0, tension: 0.0 };

/// The load factor of block limit analysis.
fn of_blocks(model: &BlockModel, loading: &Loading) -> f64 {
    let settings = Settings { friction: Friction::Associated, ..Settings::default() };
    collapse_load(model, loading, &settings).unwrap().factor.unwrap()
}

/// The ring with a column of fill on each voussoir up to a level above the crown, free at the ends. The columns are glued: one body.
fn under_a_rigid_body(ring: &Ring, above: f64) -> BlockModel {
    let mut model = ring.model();
    let (stone, fill) = (GroupId(0), model.groups.push("fill".to_string()));
    model.laws = LawTable::uniform(2, ContactLaw { cohesion: 1e9, tension: 1e9, ..dry(1.0) });
    model.laws.set(stone, stone, dry(ring.friction));
    model.laws.set(stone, fill, dry(RUBS.friction));
    let top = ring.extrados() + above;
    for k in 0..ring.voussoirs {
        let [a, b] = [k, k + 1].map(|joint| ring.at(joint as f64, ring.extrados()));
        let outline = Polygon::new(vec![a, b, vec2(b.x, top), vec2(a.x, top)]).unwrap();
        model.blocks.push(Block { group: fill, ..block(outline, 0.0, WEIGHT / 9.81, Held::FREE) });
    }
    model
}

#[test]
fn fill_too_strong_to_yield_is_one_more_rigid_block() {
    let ring = small();
    let loading = on_the_quarter(&ring);
    let rigid = of_blocks(&under_a_rigid_body(&ring, 0.3), &loading);
    assert!(rigid > 5.0 * of_blocks(&ring.model(), &loading), "{rigid}");
    let mut last = 0.0;
    for cohesion in [1e5, 3e5, 1e6] {
        let mut earth = filled(&ring, 0.3, soil(cohesion, 30.0, WEIGHT), RUBS);
        // Its ends are free: held between walls it would lock.
        earth.sides.truncate(ring.voussoirs);
        let found = bounds(&ring.model(), &loading, &earth, 1.01, 1500);
        let [lower, upper] = ends(&found);
        // The motion of rigid blocks is one of the soil's, whatever its strength.
        assert!(upper <= rigid * (1.0 + 1e-5) && lower > last, "{cohesion}: {lower} {upper} {rigid} after {last}");
        last = lower;
    }
    // The gap that was asked for, and what this strength still yields.
    assert!(last > 0.98 * rigid, "{last} {rigid}");
}

#[test]
fn fill_without_weight_is_lifted_off_whatever_its_strength() {
    let ring = small();
    let loading = on_the_quarter(&ring);
    let bare = of_blocks(&ring.model(), &loading);
    for (cohesion, degrees) in [(0.0, 0.0), (0.0, 20.0), (0.0, 35.0), (1e3, 20.0)] {
        // Between smooth walls it rises as one body: nothing is dissipated, and no work done.
        let light = filled(&ring, 0.3, soil(cohesion, degrees, 0.0), RUBS);
        let [lower, upper] = ends(&bounds(&ring.model(), &loading, &light, 1.01, 400));
        assert!(lower > bare * (1.0 - 1e-3) && lower < bare * (1.0 + 1e-5), "{lower} {bare}");
        assert!(upper < bare * (1.0 + 1e-5) && upper > bare * (1.0 - 1e-5), "{upper} {bare}");
        // With weight it is not.
        let heavy = filled(&ring, 0.3, soil(cohesion, degrees, WEIGHT), RUBS);
        let [lower, _] = ends(&bounds(&ring.model(), &loading, &heavy, 1.01, 400));
        assert!(lower > 1.5 * bare, "{cohesion}, {degrees}: {lower} {bare}");
    }
}
