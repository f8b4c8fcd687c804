//! How a load on the road reaches the extrados.

use super::cover::{Resultant, Surface};
use super::extrados::Extrados;
use super::voids;
use bridge::{Dispersal, DispersalRule, Load, LoadKind};
use mechanics::blocks::PointForce;
use mechanics::plane::{Vec2, vec2};
use std::f64::consts::PI;

/// A strip of uniform vertical pressure on the road surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip {
    /// Middle along the bridge [m].
    pub middle: f64,
    /// Length along the bridge [m]; zero for a line.
    pub length: f64,
    /// Force per metre of width [N/m], downwards positive.
    pub force: f64,
    /// Force along the bridge as a share of it, to the right positive; it acts at the surface.
    pub horizontal: f64,
    /// Whether it is a pressure that follows the ground; else a body stands on it, as stiff as a wheel or a beam.
    pub is_pressure: bool,
}

/// The strips of a load so far from its own place [m]; axles in the order of the file.
pub fn strips(load: &Load, offset: f64) -> Vec<Strip> {
    let (position, horizontal) = (load.position + offset, load.horizontal);
    let is_pressure = matches!(load.kind, LoadKind::Patch { .. });
    let strip = |middle: f64, length: f64, force: f64| Strip { middle, length, force, horizontal, is_pressure };
    match &load.kind {
        LoadKind::KnifeEdge { force, length } => vec![strip(position, *length, *force)],
        LoadKind::Patch { pressure, length } => vec![strip(position, *length, pressure * length)],
        LoadKind::Axles { axles, contact_length, effective_width } => {
            let axle =
                |&(force, behind): &(f64, f64)| strip(position - behind, *contact_length, force / effective_width);
            axles.iter().map(axle).collect()
        }
    }
}

impl Strip {
    /// Adds what acts along the bridge to the vertical forces of its parts: at the surface, with its lever.
    pub(super) fn pull(&self, forces: &mut [PointForce], surface: &Surface) {
        if self.horizontal != 0.0 {
            for one in forces {
                one.at.y = surface.at(one.at.x);
                one.force.x -= self.horizontal * one.force.y;
            }
        }
    }
}

/// A strip where it reaches the extrados.
#[derive(Debug, Clone, PartialEq)]
pub struct Spread {
    /// The strip.
    pub strip: Strip,
    /// Where its left and right border meet the extrados [m].
    pub ends: [Vec2; 2],
    /// Depth of the ends below the road [m].
    pub depths: [f64; 2],
    /// Pressure at the ends [Pa].
    pub pressures: [f64; 2],
    /// Resultant on each block.
    pub forces: Vec<PointForce>,
    /// Force that reaches the abutments and the ground behind them [N/m].
    pub to_ground: f64,
    /// Distance by which the rule moves the resultant along the bridge [m]: a trapezoid's is not under the load.
    pub shift: f64,
}

/// Spreads a strip on the road through the cover.
pub fn spread(strip: Strip, rule: Dispersal, surface: &Surface, extrados: &Extrados) -> Spread {
    let half = 0.5 * strip.length;
    let corners = [strip.middle - half, strip.middle + half].map(|x| vec2(x, surface.at(x)));
    let ends = match rule.rule {
        DispersalRule::None => corners.map(|c| vec2(c.x, extrados.level(c.x))),
        _ => [end(corners[0], -1.0, rule.slope, extrados), end(corners[1], 1.0, rule.slope, extrados)],
    };
    let depths = [0, 1].map(|k| (corners[k].y - ends[k].y).max(0.0));
    let mut found = gather(strip, rule.rule, (ends, depths), surface.at(strip.middle), extrados);
    strip.pull(&mut found.forces, surface);
    found
}

/// Fall of an extrados per unit of x beyond which it is a haunch: lines at the slope would run down along it.
const HAUNCH: f64 = 1.0;

/// Where the line from a border of a strip meets the extrados, or ends before: on a haunch steeper than 45 degrees it goes no
/// further than the depth of cover under that border allows, which is the depth in rules that give a length, such as CS 454,
/// 7.3: 300 mm + depth.
fn end(from: Vec2, direction: f64, slope: f64, extrados: &Extrados) -> Vec2 {
    let met = extrados.meet(from, direction, slope);
    let depth = (from.y - extrados.level(from.x)).max(0.0);
    let haunch = extrados.steeper(from.x, direction, HAUNCH).map_or(f64::INFINITY, |x| (x - from.x).abs());
    let reach = haunch.max(depth / slope);
    if (met.x - from.x).abs() <= reach {
        return met;
    }
    let x = from.x + direction * reach;
    vec2(x, extrados.level(x))
}

fn gather(
    strip: Strip,
    rule: DispersalRule,
    (ends, depths): ([Vec2; 2], [f64; 2]),
    surface: f64,
    extrados: &Extrados,
) -> Spread {
    let (x1, x2) = (ends[0].x, ends[1].x);
    let (roofs, beyond) = (extrados.stretches.len(), extrados.stretches.len() + extrados.voids.len());
    // What comes to each stretch, then to each roof of a void, and beyond the extrados.
    let mut shares = vec![Resultant::default(); beyond + 1];
    let mut pressures = [0.0; 2];
    let length = x2 - x1;
    if length <= 0.0 {
        let here = extrados.stretches.iter().position(|s| s.left.x <= x1 && x1 <= s.right.x);
        let roof = voids::over(&extrados.voids, x1).map(|void| roofs + void);
        shares[roof.or(here).unwrap_or(beyond)].point(x1, strip.force);
    } else if rule == DispersalRule::Boussinesq && depths[0].min(depths[1]) > 0.0 {
        let stress = |x: f64| strip_stress(strip, x, surface - extrados.level(x));
        each_part(extrados, x1, x2, |on, a, b| {
            let sum = quadrature(a, b, stress);
            shares[on].force += sum.force;
            shares[on].moment += sum.moment;
        });
        let on_roofs: f64 = shares[roofs..beyond].iter().fold(0.0, |sum, s| sum + s.force);
        let total: f64 = shares[..roofs].iter().map(|s| s.force).sum::<f64>() + shares[beyond].force + on_roofs;
        let scale = strip.force / total;
        for s in &mut shares {
            s.force *= scale;
            s.moment *= scale;
        }
        pressures = [x1, x2].map(|x| stress(x) * scale);
    } else {
        pressures = if rule == DispersalRule::InverseDepth && depths[0] + depths[1] > 0.0 {
            // Rouxinol, Providência and Lemos, equation (2).
            let q = 2.0 * strip.force / (length * (depths[0] + depths[1]));
            [q * depths[1], q * depths[0]]
        } else {
            // Uniform, and all where there is no depth to divide by.
            [strip.force / length; 2]
        };
        let [q1, q2] = pressures;
        let q = |x: f64| q1 + (q2 - q1) * (x - x1) / (x2 - x1);
        each_part(extrados, x1, x2, |on, a, b| shares[on].trapezoid(a, q(a), b, q(b)));
    }
    for (k, void) in extrados.voids.iter().enumerate() {
        let on_roof = shares[roofs + k];
        if on_roof.force == 0.0 {
            continue;
        }
        for (side, (x, force)) in voids::carried(void, &on_roof).into_iter().enumerate() {
            shares[voids::bearing(&extrados.stretches, void, side).unwrap_or(beyond)].point(x, force);
        }
    }
    let mut sum = shares[beyond];
    let (mut forces, mut to_ground) = (Vec::new(), sum.force);
    for (stretch, share) in extrados.stretches.iter().zip(&shares) {
        sum.force += share.force;
        sum.moment += share.moment;
        let Some(x) = share.place() else { continue };
        if stretch.ground {
            to_ground += share.force;
        } else {
            forces.push(PointForce { block: stretch.block, at: stretch.at(x), force: vec2(0.0, -share.force) });
        }
    }
    let shift = sum.place().map_or(0.0, |x| x - strip.middle);
    Spread { strip, ends, depths, pressures, forces, to_ground, shift }
}

/// Calls `part` for each piece of [x1, x2] with the place among the shares of what it comes to: the stretch or the roof of a void it lies on, or
/// what lies beyond the extrados.
fn each_part(extrados: &Extrados, x1: f64, x2: f64, mut part: impl FnMut(usize, f64, f64)) {
    let (roofs, beyond) = (extrados.stretches.len(), extrados.stretches.len() + extrados.voids.len());
    let (first, last) = match (extrados.stretches.first(), extrados.stretches.last()) {
        (Some(a), Some(b)) => (a.left.x, b.right.x),
        _ => (x2, x2),
    };
    if x1 < first {
        part(beyond, x1, first.min(x2));
    }
    for (k, s) in extrados.stretches.iter().enumerate() {
        let (a, b) = (s.left.x.max(x1), s.right.x.min(x2));
        if !(b > a) {
            continue;
        }
        let mut ends: Vec<f64> = voids::ends(&extrados.voids, a, b).collect();
        ends.sort_by(f64::total_cmp);
        let mut from = a;
        for to in ends.into_iter().chain([b]) {
            let on = voids::over(&extrados.voids, 0.5 * (from + to)).map_or(k, |void| roofs + void);
            part(on, from, to);
            from = to;
        }
    }
    if x2 > last {
        part(beyond, last.max(x1), x2);
    }
}

/// Vertical stress under a strip on an elastic half plane [Pa] (Boussinesq; Flamant where the strip is a line).
fn strip_stress(strip: Strip, x: f64, depth: f64) -> f64 {
    let z = depth.max(1e-9);
    let u = x - strip.middle;
    if strip.length <= 0.0 {
        let r2 = u * u + z * z;
        return 2.0 * strip.force * z * z * z / (PI * r2 * r2);
    }
    let (b1, b2) = (((u - 0.5 * strip.length) / z).atan(), ((u + 0.5 * strip.length) / z).atan());
    let alpha = b2 - b1;
    strip.force / strip.length / PI * (alpha + alpha.sin() * (b1 + b2).cos())
}

/// Five-point Gauss-Legendre on eight pieces: force and first moment of a smooth pressure on [a, b].
fn quadrature(a: f64, b: f64, pressure: impl Fn(f64) -> f64) -> Resultant {
    const NODES: [(f64, f64); 5] = [
        (0.0, 0.568_888_888_888_888_9),
        (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
        (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
        (0.906_179_845_938_664, 0.236_926_885_056_189_1),
    ];
    const PIECES: usize = 8;
    let mut sum = Resultant::default();
    let half = 0.5 * (b - a) / PIECES as f64;
    for piece in 0..PIECES {
        let middle = a + half * (2 * piece + 1) as f64;
        for (t, w) in NODES {
            let x = middle + half * t;
            sum.point(x, half * w * pressure(x));
        }
    }
    sum
}
