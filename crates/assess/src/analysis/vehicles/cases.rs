//! What may stand where: positions of a vehicle, and borders of half spans with uniform loads.

use super::factored::Footprint;
use bridge::{Bridge, Directions, SweepPlan};
use outcome::vehicles::Direction;
use rules::{Pattern, Vehicle};
use structure::discretise::Discretised;

/// A vehicle in one arrangement, driving one way.
pub(super) struct Drive {
    pub vehicle: usize,
    /// The arrangement, as the vehicle drives: its first axle first.
    pub pattern: Pattern,
    /// Which way.
    pub direction: Direction,
    /// Whether every run of neighbouring axles is tried.
    pub subsets: bool,
    /// Places of the first axle [m].
    pub positions: Vec<f64>,
}

/// What the arches and their cover reach over [m]: where an axle acts on them.
pub(super) fn reach(d: &Discretised, foot: &Footprint) -> [f64; 2] {
    let free = || d.extrados.stretches.iter().filter(|s| !s.ground);
    let from = free().map(|s| s.left.x).fold(f64::INFINITY, f64::min);
    let to = free().map(|s| s.right.x).fold(f64::NEG_INFINITY, f64::max);
    let lowest = free().map(|s| s.left.y.min(s.right.y)).fold(f64::INFINITY, f64::min);
    let below = (d.surface.highest() - lowest).max(0.0);
    let margin = 0.5 * foot.length + below / foot.dispersal.slope.max(0.1);
    [from - margin, to + margin]
}

/// Distance between the positions of a sweep [m]. Rings on one another, each position of which takes a hundred times as long, have half as many;
/// the worst one is sought between them.
pub(super) fn places_apart(bridge: &Bridge, plan: &SweepPlan) -> f64 {
    let several = bridge.spans.iter().any(|span| span.rings.len() > 1);
    plan.step.unwrap_or(shortest(bridge) / if several { 30.0 } else { 60.0 })
}

/// Distance between positions at which cases are answered without dilation [m], before the least of them is sought between: with it and without
/// it a load changes alike along the bridge, and one answer may take seconds.
pub(super) fn asked_apart(bridge: &Bridge, step: f64) -> f64 {
    step.max(shortest(bridge) / 20.0)
}

fn shortest(bridge: &Bridge) -> f64 {
    bridge.spans.iter().map(|s| s.span).fold(f64::INFINITY, f64::min)
}

/// Every drive of a vehicle. A vehicle that looks the same from both ends drives one way only.
pub(super) fn drives(index: usize, vehicle: &Vehicle, plan: &SweepPlan, [from, to]: [f64; 2], step: f64) -> Vec<Drive> {
    let mut drives = Vec::new();
    for pattern in vehicle.patterns() {
        let ways: &[Direction] = match plan.directions {
            Directions::Right => &[Direction::Right],
            Directions::Left => &[Direction::Left],
            Directions::Both if pattern.is_symmetric() => &[Direction::Right],
            Directions::Both => &[Direction::Right, Direction::Left],
        };
        for &direction in ways {
            let length = pattern.length();
            let count = ((to - from + length) / step).ceil().max(1.0) as usize;
            let positions = (0..=count).map(|k| match direction {
                Direction::Right => from + step * k as f64,
                Direction::Left => to - step * k as f64,
            });
            drives.push(Drive {
                vehicle: index,
                pattern: pattern.clone(),
                direction,
                subsets: plan.subsets && vehicle.axles_may_be_dropped,
                positions: positions.collect(),
            });
        }
    }
    drives
}

impl Drive {
    /// Position of an axle when the first one stands at `position` [m].
    pub(super) fn axle_at(&self, position: f64, axle: usize) -> f64 {
        let behind = self.pattern.axles[axle].offset;
        match self.direction {
            Direction::Right => position - behind,
            Direction::Left => position + behind,
        }
    }
}

/// What all of several reach over [m].
pub(super) fn range(d: &Discretised, feet: &[Footprint]) -> [f64; 2] {
    let wider = |all: [f64; 2], own: [f64; 2]| [all[0].min(own[0]), all[1].max(own[1])];
    feet.iter().map(|foot| reach(d, foot)).fold([f64::INFINITY, f64::NEG_INFINITY], wider)
}

/// Borders of half spans, and of what lies beside the spans [m].
pub(super) fn borders(bridge: &Bridge, [from, to]: [f64; 2]) -> Vec<f64> {
    let mut borders = vec![from];
    let mut x = 0.0;
    for (k, span) in bridge.spans.iter().enumerate() {
        borders.push(x + 0.5 * span.span);
        x += span.span;
        if let Some(pier) = bridge.piers.get(k) {
            borders.push(x + 0.5 * pier.width);
            x += pier.width;
        }
    }
    borders.push(to);
    borders
}
