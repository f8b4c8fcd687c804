//! Roads that are not level: the weight below them, how loads spread, and the load that is carried.

use super::cover::{Surface, surface};
use super::{DiscretiseError, bridge_length, discretise};
use crate::samples;
use bridge::road::Road;
use bridge::{Bridge, FillPressure, LeastPressure, Method};
use mechanics::plane::vec2;

/// A bridge under a road of these points, its layers as they are.
fn under(mut b: Bridge, points: &[[f64; 2]]) -> Bridge {
    b.cover.road = Some(Road { points: points.to_vec() });
    b
}

/// Case 2 with fill that presses, and with a semicircle's deep haunches.
fn filled() -> Bridge {
    let mut b = samples::case_two();
    b.fill_pressure = Some(FillPressure {
        applies: true,
        friction_angle: 30f64.to_radians(),
        cohesion: 5e3,
        mobilisation: 0.5,
        cohesion_mobilisation: 0.05,
        least: LeastPressure::AtRest,
        half_movement: 0.02,
    });
    b
}

fn load(b: &Bridge) -> f64 {
    let mut b = b.clone();
    b.plan.method = Method::Limit;
    assess::analysis::as_described(&b, None, &mut mechanics::watch::Unwatched).unwrap().collapse_load.unwrap()
}

fn mirrored(b: &Bridge) -> Bridge {
    let (mut other, length) = (b.clone(), bridge_length(b));
    other.spans.reverse();
    other.piers.reverse();
    other.loads.iter_mut().for_each(|load| load.position = length - load.position);
    if let Some(road) = &mut other.cover.road {
        road.points = road.points.iter().rev().map(|[x, y]| [length - x, *y]).collect();
    }
    other
}

/// Level of the road over Bridgemill, by its cover [m].
const LEVEL: f64 = 2.85 + 0.711 + 0.478;

/// A hump with two gradients.
const HUMP: [[f64; 2]; 3] = [[-4.0, LEVEL - 0.45], [8.0, LEVEL + 0.1], [24.0, LEVEL - 0.3]];

#[test]
fn a_road_of_equal_levels_is_the_level_road() {
    let (plain, level) = (load(&filled()), load(&under(filled(), &[[-5.0, LEVEL], [4.0, LEVEL], [25.0, LEVEL]])));
    assert!((level / plain - 1.0).abs() < 1e-9, "{level} {plain}");
}

#[test]
fn the_weight_on_the_backs_is_that_of_the_area_below_the_road() {
    let b = under(samples::case_two(), &HUMP);
    let d = discretise(&b).unwrap();
    let road = surface(&b, &d.extrados);
    // The fill weighs, the two layers above it do not.
    let top = |x: f64| road.at(x) - 0.275;
    let backs: Vec<_> = d.extrados.stretches.iter().filter(|s| !s.ground).collect();
    let (mut weight, mut moment) = (0.0, 0.0);
    for back in &backs {
        const STEPS: usize = 2000;
        let step = (back.right.x - back.left.x) / STEPS as f64;
        for k in 0..STEPS {
            let x = back.left.x + step * (k as f64 + 0.5);
            let force = 1890.0 * 9.81 * (top(x) - back.at(x).y) * step;
            (weight, moment) = (weight + force, moment + force * x);
        }
    }
    let force: f64 = d.loading.permanent.iter().map(|f| -f.force.y).sum();
    let turned: f64 = d.loading.permanent.iter().map(|f| -f.force.y * f.at.x).sum();
    assert!((force / weight - 1.0).abs() < 1e-7 && (turned / moment - 1.0).abs() < 1e-7, "{force} {weight}");
}

#[test]
fn the_load_does_not_depend_on_the_hand() {
    let b = under(filled(), &HUMP);
    let (one, other) = (load(&b), load(&mirrored(&b)));
    assert!((one / other - 1.0).abs() < 1e-6, "{one} {other}");
    // Nor over a valley between two unlike spans.
    let span = b.spans[0].clone();
    let mut shorter = span.clone();
    (shorter.span, shorter.rise) = (12.0, 1.9);
    let two =
        Bridge { piers: samples::spans(vec![span.clone(), shorter.clone()], 2.0, 2.0, 3.0, 4).piers, ..b.clone() };
    let two = Bridge { spans: vec![span, shorter], ..two };
    let two = under(two, &[[-4.0, LEVEL], [15.0, LEVEL + 0.2], [40.0, LEVEL - 0.5]]);
    let (one, other) = (load(&two), load(&mirrored(&two)));
    assert!((one / other - 1.0).abs() < 1e-6, "{one} {other}");
}

#[test]
fn the_load_follows_the_levels_continuously() {
    let start = load(&under(filled(), &HUMP));
    for (point, along) in [(0, 0), (1, 0), (1, 1), (2, 1)] {
        let mut moved = HUMP;
        moved[point][along] += 1e-3;
        let load = load(&under(filled(), &moved));
        assert!((load / start - 1.0).abs() < 3e-3, "point {point}: {load} {start}");
    }
}

#[test]
fn fill_under_a_road_presses_by_the_depth_below_it() {
    let b = under(filled(), &HUMP);
    let d = discretise(&b).unwrap();
    let road = surface(&b, &d.extrados);
    let all = super::pressure::restraints(&b, &d.extrados);
    let backs = || d.extrados.stretches.iter().filter(|s| !s.ground && s.right.y > s.left.y);
    let mut least = 0.0;
    for back in backs() {
        const STEPS: usize = 500;
        let step = (back.right - back.left) * (1.0 / STEPS as f64);
        for k in 0..STEPS {
            let p = back.left + step * (k as f64 + 0.5);
            least += 0.5 * 1890.0 * 9.81 * (road.at(p.x) - 0.275 - p.y) * step.y;
        }
    }
    let found: f64 = all.iter().filter(|r| r.direction.x > 0.0).map(|r| r.least).sum();
    assert!((found / least - 1.0).abs() < 1e-6, "{found} {least}");
}

#[test]
fn loads_spread_from_the_level_on_which_they_stand() {
    let b = under(samples::case_two(), &[[0.0, LEVEL - 0.2], [18.3, LEVEL + 0.2]]);
    let d = discretise(&b).unwrap();
    let spread = &d.spreads[0];
    let from = d.surface.at(4.575 - 0.375);
    assert!((spread.depths[0] - (from - spread.ends[0].y)).abs() < 1e-12, "{spread:?}");
    assert!((spread.ends[0].x - (4.2 - 0.5 * spread.depths[0])).abs() < 1e-9, "two vertical to one horizontal");
    let force: f64 = spread.forces.iter().map(|f| -f.force.y).sum();
    assert!((force / 1e3 - 1.0).abs() < 1e-12);
}

#[test]
fn a_surface_has_its_corners() {
    let d = discretise(&under(samples::case_two(), &HUMP)).unwrap();
    assert_eq!(d.surface.line(0.0, 10.0)[1], vec2(8.0, LEVEL + 0.1));
    assert_eq!(d.surface.line(8.0, 24.0).len(), 2);
    assert_eq!(Surface::level(2.0).line(0.0, 1.0), [vec2(0.0, 2.0), vec2(1.0, 2.0)]);
    assert!((d.surface.at(-9.0) - (LEVEL - 0.45)).abs() < 1e-12 && (d.surface.highest() - LEVEL - 0.1).abs() < 1e-12);
}

#[test]
fn what_knows_a_level_road_alone_says_so() {
    let mut b = under(samples::case_two(), &HUMP);
    b.plan.strip = bridge::Strip::Wall;
    b.spandrel_wall = Some(samples::spandrel_wall(&b));
    assert_eq!(discretise(&b), Err(DiscretiseError::WallUnderRoad));
    b.spandrel_wall.as_mut().unwrap().top = Some(0.5);
    assert!(discretise(&b).is_ok());
}
