//! A bridge with the factors of a rule, and with one case of a vehicle as its loads.

use super::weights::{self, Weights};
use super::{Case, Direction};
use bridge::{Bridge, Dispersal, DispersalRule, Load, LoadKind, Method, SweepPlan};
use rules::{Pattern, Pressure, Rule, Vehicle};

/// The bridge with the rule's factors on strengths, and one combination of those on weights.
pub fn bridge(bridge: &Bridge, rule: &Rule, weights: &Weights) -> Bridge {
    let f = &rule.factors;
    let mut b = bridge.clone();
    weights::put(weights, &mut b);
    if let Some(strength) = &mut b.masonry.compressive_strength {
        *strength /= f.masonry_strength.value;
    }
    for joint in [&mut b.joint, &mut b.ring_joint] {
        joint.friction_angle = (joint.friction_angle.tan() / f.friction.value).atan();
    }
    if let Some(fill) = &mut b.fill_pressure {
        fill.mobilisation /= f.fill_pressure.value;
        fill.cohesion_mobilisation /= f.fill_pressure.value;
    }
    b.plan.method = Method::Limit;
    b.loads.clear();
    b
}

/// How an axle stands on the surface and spreads below it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footprint {
    /// How it spreads.
    pub dispersal: Dispersal,
    /// Length on the surface [m].
    pub length: f64,
    /// Width of the barrel that carries it [m].
    pub width: f64,
    /// Factor on every axle.
    pub all: f64,
    /// Further factor on the critical one.
    pub critical: f64,
}

/// How a vehicle's axles stand and spread by a plan and a rule.
pub fn footprint(bridge: &Bridge, plan: &SweepPlan, rule: &Rule, vehicle: &Vehicle) -> Footprint {
    let depth = bridge.cover.depth;
    let shortest = bridge.spans.iter().map(|s| s.span).fold(f64::INFINITY, f64::min);
    let [all, critical] = rule.load_factors(shortest, depth);
    let by_rule = Dispersal {
        rule: match rule.dispersal.pressure {
            _ if rule.dispersal.length_per_depth == 0.0 => DispersalRule::None,
            Pressure::InverseDepth if depth > 0.0 => DispersalRule::InverseDepth,
            Pressure::Boussinesq if depth > 0.0 => DispersalRule::Boussinesq,
            _ => DispersalRule::Uniform,
        },
        slope: rule.dispersal.slope(),
    };
    Footprint {
        dispersal: if plan.own_dispersal { bridge.dispersal } else { by_rule },
        length: if plan.own_dispersal { vehicle.contact_length_m } else { rule.dispersal.length_base_m },
        width: rule.effective_width(vehicle.wheel_track_m, depth, bridge.width),
        all,
        critical,
    }
}

/// The bridge with one case as its loads: each axle and each stretch of uniform load by itself, with its factors.
pub fn with_case(bridge: &Bridge, plan: &SweepPlan, rule: &Rule, vehicle: &Vehicle, case: &Case) -> Bridge {
    let foot = footprint(bridge, plan, rule, vehicle);
    let mut b = bridge.clone();
    b.dispersal = foot.dispersal;
    let Some(pattern) = vehicle.patterns().into_iter().find(|p| p.label == case.arrangement) else { return b };
    let sign = if case.direction == Direction::Right { 1.0 } else { -1.0 };
    if let Some([first, last]) = case.axles {
        for (k, axle) in pattern.axles.iter().enumerate().take(last + 1).skip(first) {
            let critical = if case.critical_axle == Some(k) { foot.critical } else { 1.0 };
            b.loads.push(Load {
                name: format!("{}, axle {}", vehicle.title, k + 1),
                kind: LoadKind::Axles {
                    axles: vec![(axle.force * foot.all * critical, 0.0)],
                    contact_length: foot.length,
                    effective_width: foot.width,
                },
                position: case.position - sign * axle.offset,
                block: None,
            });
        }
    }
    if let Some([from, to]) = case.uniform {
        for (a, b_, force) in clipped(&pattern, case, [from, to]) {
            b.loads.push(Load {
                name: format!("{}, uniform load", vehicle.title),
                kind: LoadKind::Patch { pressure: force * foot.all / foot.width, length: b_ - a },
                position: 0.5 * (a + b_),
                block: None,
            });
        }
    }
    b
}

/// Where the pattern's uniform loads stand within a range: from, to [m], and force [N/m along the bridge].
pub fn clipped(pattern: &Pattern, case: &Case, range: [f64; 2]) -> Vec<(f64, f64, f64)> {
    let place = |behind: f64| match case.direction {
        Direction::Right => case.position - behind,
        Direction::Left => case.position + behind,
    };
    let parts = pattern.stretches.iter().filter_map(|s| {
        let (a, b) = (place(s.from), place(s.to));
        let (from, to) = (a.min(b).max(range[0]), a.max(b).min(range[1]));
        (to > from + 1e-9).then_some((from, to, s.force))
    });
    parts.collect()
}
