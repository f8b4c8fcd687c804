//! Particles in numbers: a heap's slope, a silo's walls.

use crate::particle_support::{Chance, Moving, fill, loose, mass, regular, settings, stone, wall, world};
use mechanics::blocks::{Block, Held};
use mechanics::dem::{Body, Damping, frame};
use mechanics::plane::{Vec2, vec2};

/// A column of discs is let go on a floor of knobs and comes to rest as a heap. Nothing keeps a disc from rolling: one that
/// lies on a slope sits in a socket between two others and rolls out of it where the slope is steeper than the socket's
/// side, whatever the friction: `asin(R / (R + r))` for a disc of radius `r` on two of radius `R` that touch, 30 degrees for
/// equal discs and 37 for the smallest on two of the largest. Discs without any friction carry a tenth of the pressure as
/// shear (Peyneau and Roux 2008), 6 degrees. Between these the slope must come to rest.
#[test]
fn a_heap_of_discs_stands_as_steep_as_its_discs_lie_in_their_sockets() {
    let friction = 0.5;
    let discs: Vec<(Vec2, f64)> =
        loose(14, 26, 4).into_iter().map(|(c, r)| (c + vec2(-0.5 * 14.0 * 0.185, 0.06), r)).collect();
    let knob = |k: i32| stone(&regular(vec2(0.14 * f64::from(k), 0.0), 0.06, 8, 0.1), 0.01, Held::FIXED);
    let mut blocks: Vec<Block> = (-60..=60).map(knob).collect();
    // What rolls off stays near, for the search.
    blocks.extend([
        wall(vec2(-9.0, -0.6), 18.0, 0.57),
        wall(vec2(-8.5, 0.1), 0.3, 2.0),
        wall(vec2(8.2, 0.1), 0.3, 2.0),
    ]);
    let world = world(fill(friction), vec2(0.0, -9.81), blocks, &discs);
    let mut m = Moving::new(&world, settings(Damping::Local(0.2), 0.8));
    m.run(60_000);
    let p = m.state.particles(&m.model);
    // Highest disc in each slice of two and a half diameters; a line through the middle of each flank.
    let slice = 0.375;
    let height = |k: i32| {
        let within = p.iter().filter(|d| ((d.centre.x / slice).floor() as i32) == k);
        within.map(|d| d.centre.y + d.radius).fold(0.0, f64::max)
    };
    let heights: Vec<f64> = (-30..30).map(height).collect();
    let peak = heights.iter().copied().fold(0.0, f64::max);
    let slope = |flank: &[(f64, f64)]| {
        let n = flank.len() as f64;
        let (mx, my) = (flank.iter().map(|f| f.0).sum::<f64>() / n, flank.iter().map(|f| f.1).sum::<f64>() / n);
        let (xy, xx) = flank.iter().fold((0.0, 0.0), |(a, b), f| (a + (f.0 - mx) * (f.1 - my), b + (f.0 - mx).powi(2)));
        (xy / xx).abs().atan().to_degrees()
    };
    let top = heights.iter().position(|h| *h == peak).unwrap();
    let middle = |from: usize, to: usize| -> Vec<(f64, f64)> {
        (from..to)
            .filter(|&k| heights[k] > 0.2 * peak && heights[k] < 0.8 * peak)
            .map(|k| (k as f64 * slice, heights[k]))
            .collect()
    };
    let (left, right) = (slope(&middle(0, top)), slope(&middle(top, 60)));
    let moving = p.iter().filter(|d| d.velocity.norm() > 0.02).count();
    // Nothing slides any more; single discs still roll about on the floor.
    assert!(moving * 20 < p.len(), "{moving}");
    for angle in [left, right] {
        assert!(angle > 6.0 && angle < (0.09_f64 / 0.15).asin().to_degrees(), "{angle}");
    }
}

/// A silo of ten diameters, its floor let down a little so that friction holds on to the walls: what the walls and the floor
/// carry is the weight. With the friction that the walls mobilise and the ratio of stresses that the floor's share
/// implies, the walls' pressure follows Janssen; that ratio lies between Rankine's active one for the friction of the contacts, 0.38,
/// and one, at which nothing resists.
#[test]
fn a_silo_follows_janssen() {
    let (width, rows) = (1.5, 52);
    let mut chance = Chance(1);
    let mut discs = loose(8, rows, 12);
    discs.iter_mut().for_each(|(c, _)| *c += vec2(0.01 + 1e-3 * chance.between(0.0, 1.0), 0.0));
    let friction = 0.5;
    let blocks = vec![
        wall(vec2(0.001, -0.5), width - 0.002, 0.5),
        wall(vec2(-0.5, -1.0), 0.5, 12.0),
        wall(vec2(width, -1.0), 0.5, 12.0),
    ];
    let world = world(fill(friction), vec2(0.0, -9.81), blocks, &discs);
    let mut m = Moving::new(&world, settings(Damping::Local(0.3), 0.8));
    m.run(30_000);
    // Down by a third of a radius.
    let speed = 0.02;
    m.state.velocities[0] = [0.0, -speed, 0.0];
    m.run((0.025 / speed / m.state.time_step) as usize);
    m.state.velocities[0] = [0.0; 3];
    m.settings.damping = Damping::Local(0.7);
    m.run(80_000);

    let found = frame(&m.model, &m.state);
    let floor_at = m.state.poses[0].position.y + 0.25;
    let surface = found.particles.iter().map(|p| p.centre.y + p.radius).fold(0.0, f64::max) - 0.1;
    let height = surface - floor_at;
    let weight: f64 = discs.iter().map(|(_, r)| mass(*r) * 9.81).sum();
    let (mut floor, mut pressed, mut held) = (0.0, 0.0, 0.0);
    const SLICES: usize = 6;
    let mut walls = [0.0; SLICES];
    for c in &found.particle_contacts {
        let Body::Block(block) = c.partner else { continue };
        let force = c.force();
        if block.0 == 0 {
            floor += force.y;
        } else {
            held += force.y;
            pressed += force.x.abs();
            let slice = ((surface - c.point.y) / height * SLICES as f64).clamp(0.0, SLICES as f64 - 1.0);
            walls[slice as usize] += force.x.abs() / (2.0 * height / SLICES as f64);
        }
    }
    // At rest: what is left moves at less than a millimetre a second.
    assert!(((floor + held) / weight - 1.0).abs() < 2e-3, "{floor} {held} {weight}");
    let mobilised = held / pressed;
    assert!(mobilised > 0.3 * friction && mobilised <= friction * (1.0 + 1e-9), "{mobilised}");
    // Janssen: the floor's share f of the weight solves f = (1 - exp(-a)) / a with a = 2 mu K H / D.
    let share = floor / weight;
    let mut a = (1e-6, 100.0);
    for _ in 0..200 {
        let middle = 0.5 * (a.0 + a.1);
        if (1.0 - f64::exp(-middle)) / middle > share { a.0 = middle } else { a.1 = middle }
    }
    let ratio = a.0 * width / (2.0 * mobilised * height);
    let active = (45.0 - 0.5 * friction.atan().to_degrees()).to_radians().tan().powi(2);
    assert!(ratio > active && ratio < 1.0, "{ratio}");
    // A slice presses through some twenty contacts, whose forces scatter about as much as their mean: a standard deviation of
    // 1 / sqrt(20) = 0.22; the root mean square over six slices exceeds one and a half times that once in fifty.
    let unit = weight / (width * height);
    let saturated = unit * width / (2.0 * mobilised);
    let off = walls.iter().enumerate().map(|(k, found)| {
        let depth = (k as f64 + 0.5) / SLICES as f64 * a.0;
        let janssen = saturated * (1.0 - (-depth).exp());
        ((found - janssen) / saturated).powi(2)
    });
    let off = (off.sum::<f64>() / SLICES as f64).sqrt();
    assert!(off < 0.33, "{off}: {walls:?}");
}
