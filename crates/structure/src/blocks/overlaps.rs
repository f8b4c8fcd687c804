//! Circles that are drawn into one another, or into blocks.

use super::Said;
use super::bodies::{Body, Particle};
use crate::extent::extent;
use bridge::TextRange;

/// Particles that press on one another overlap by their deflection, and a packing that was written down keeps it. Beyond
/// this share of the smaller radius a circle is drawn over another body, and would be thrown off it.
const PRESSED: f64 = 0.1;
/// Overlaps reported in one go.
const MOST: usize = 200;
/// Pairs looked at; a drawing with more is no heap of particles side by side.
const MOST_PAIRS: usize = 4_000_000;

/// Reports circles that overlap others or blocks by more than a tenth of the smaller radius. `places` says where each
/// circle stands in the file, and as what in its drawing.
pub(super) fn check(bodies: &[Body], particles: &[Particle], places: &[(TextRange, String)], said: &mut Said) {
    let wide = |p: &Particle| [p.centre[0] - p.radius, p.centre[0] + p.radius];
    let wide_body = |b: &Body| extent(b.outline.iter().map(|p| p[0]));
    // Circles come first, blocks after them.
    let spans: &[[f64; 2]] = &particles.iter().map(wide).chain(bodies.iter().map(wide_body)).collect::<Vec<_>>();
    let mut order: Vec<usize> = (0..spans.len()).collect();
    order.sort_by(|&i, &j| spans[i][0].total_cmp(&spans[j][0]).then(i.cmp(&j)));
    let pairs = order.iter().enumerate().flat_map(|(k, &i)| {
        let reached = order[k + 1..].iter().take_while(move |&&j| spans[j][0] < spans[i][1]);
        reached.map(move |&j| (i.min(j), i.max(j)))
    });
    let reaches = |(first, other): (usize, usize)| {
        let p = particles.get(first)?;
        let (depth, radius) = match particles.get(other) {
            Some(q) => (p.radius + q.radius - distance(p.centre, q.centre), p.radius.min(q.radius)),
            None => (p.radius - from_outline(p.centre, &bodies[other - particles.len()].outline), p.radius),
        };
        (depth > PRESSED * radius).then_some((first, other, depth))
    };
    let mut found: Vec<_> = pairs.take(MOST_PAIRS).filter_map(reaches).take(MOST).collect();
    found.sort_by_key(|&(first, other, _)| (first, other));
    for (first, other, depth) in found {
        let (range, place) = &places[first];
        let with = match particles.get(other) {
            Some(_) => format!("the circle {}", places[other].1),
            None => format!("the block {}", bodies[other - particles.len()].name),
        };
        let message = format!("the circle {place} reaches {:.1} mm into {with}", 1e3 * depth);
        let help = "let particles touch, or overlap by a tenth of the smaller radius at most".to_owned();
        said.error("D407", *range, message, "has circles drawn over other bodies", help);
    }
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Distance of a point from a convex outline [m], negative inside.
fn from_outline(at: [f64; 2], outline: &[[f64; 2]]) -> f64 {
    let (mut inside, mut nearest) = (f64::NEG_INFINITY, f64::INFINITY);
    for (k, &p) in outline.iter().enumerate() {
        let q = outline[(k + 1) % outline.len()];
        let (edge, arm) = ([q[0] - p[0], q[1] - p[1]], [at[0] - p[0], at[1] - p[1]]);
        let length = edge[0].hypot(edge[1]);
        // Outlines run counter-clockwise: outside is to the right.
        inside = inside.max((edge[1] * arm[0] - edge[0] * arm[1]) / length);
        let along = ((edge[0] * arm[0] + edge[1] * arm[1]) / (length * length)).clamp(0.0, 1.0);
        nearest = nearest.min(distance(at, [p[0] + along * edge[0], p[1] + along * edge[1]]));
    }
    if inside <= 0.0 { inside } else { nearest }
}
