//! A bridge with the factors of a rule, and with one case of a vehicle as its loads.

use super::across;
use super::weights;
use crate::analysis::state::each_joint;
use crate::vehicles::Chosen;
use bridge::{Bridge, Dispersal, DispersalRule, Load, LoadKind, Method, SweepPlan};
use outcome::vehicles::Across;
use outcome::vehicles::Weights;
use outcome::vehicles::{Case, Direction};
use rules::{Pattern, Pressure, Rule};
use structure::discretise::springings::ranges;

/// The bridge with the rule's factors on strengths, and one combination of those on weights.
pub(super) fn bridge(bridge: &Bridge, rule: &Rule, weights: &Weights) -> Bridge {
    let f = &rule.factors;
    let mut b = bridge.clone();
    weights::put(weights, &mut b);
    if let Some(strength) = &mut b.masonry.compressive_strength {
        *strength /= f.masonry_strength.value;
    }
    each_joint(&mut b, |joint| {
        joint.friction_angle = (joint.friction_angle.tan() / f.friction.value).atan();
        joint.cohesion /= rule.cohesion().value;
        joint.tensile_strength /= rule.cohesion().value;
    });
    if let Some(fill) = &mut b.fill_pressure {
        fill.mobilisation /= f.fill_pressure.value;
        fill.cohesion_mobilisation /= f.fill_pressure.value;
    }
    // A factor on what fill resists is one on its strength.
    if let Some(soil) = &mut b.continuum {
        soil.mobilised_share /= f.fill_pressure.value;
    }
    b.plan.method = Method::Limit;
    b.loads.clear();
    b
}

/// Factors on what stands over one span.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OfSpan {
    /// From springing to springing [m].
    pub range: [f64; 2],
    /// Factor on axles.
    pub axles: f64,
    /// Factor on uniform loads.
    pub uniform: f64,
}

/// How an axle stands on the surface and spreads below it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Footprint {
    /// How it spreads.
    pub dispersal: Dispersal,
    /// Length on the surface [m].
    pub length: f64,
    /// How vehicles stand across the bridge.
    pub across: Across,
    /// Live load and impact, span by span: motion adds by the length of the span that is loaded.
    pub spans: Vec<OfSpan>,
    /// Further factor on the critical axle.
    pub critical: f64,
    /// Force along the bridge as a share of every load, to the right positive.
    pub horizontal: f64,
}

impl Footprint {
    /// The factors that act at a place [m]: those of the span there, over a pier the larger ones of both spans, beyond the
    /// springings those of the outer span.
    fn at(&self, x: f64) -> [f64; 2] {
        let within = |k: usize| {
            let from = if k == 0 { f64::NEG_INFINITY } else { self.spans[k - 1].range[1] };
            let to = self.spans.get(k + 1).map_or(f64::INFINITY, |next| next.range[0]);
            from - 1e-9 <= x && x <= to + 1e-9
        };
        let here = (0..self.spans.len()).filter(|k| within(*k)).map(|k| &self.spans[k]);
        here.fold([0.0, 0.0], |most, span| [span.axles.max(most[0]), span.uniform.max(most[1])])
    }

    /// Factor on an axle at a place [m].
    pub(super) fn axle_at(&self, x: f64) -> f64 {
        self.at(x)[0]
    }

    /// Pieces of a stretch with one factor on uniform loads each: from, to [m], factor.
    pub(super) fn pieces(&self, from: f64, to: f64) -> Vec<(f64, f64, f64)> {
        let inner = self.spans.iter().flat_map(|span| span.range);
        let mut borders: Vec<f64> = inner.filter(|x| *x > from + 1e-9 && *x < to - 1e-9).collect();
        borders.sort_by(f64::total_cmp);
        borders.insert(0, from);
        borders.push(to);
        let mut pieces: Vec<(f64, f64, f64)> = Vec::new();
        for pair in borders.windows(2) {
            let factor = self.at(0.5 * (pair[0] + pair[1]))[1];
            match pieces.last_mut() {
                Some(last) if last.2 == factor => last.1 = pair[1],
                _ => pieces.push((pair[0], pair[1], factor)),
            }
        }
        pieces
    }

    /// The largest factor on axles of any span.
    pub(super) fn all(&self) -> f64 {
        self.spans.iter().map(|span| span.axles).fold(0.0, f64::max)
    }
}

/// How a vehicle's axles stand and spread by a plan and a rule.
pub(super) fn footprint(bridge: &Bridge, plan: &SweepPlan, rule: &Rule, chosen: &Chosen) -> Footprint {
    let depth = bridge.cover.depth;
    let mut critical = 1.0f64;
    let spans = bridge.spans.iter().zip(ranges(bridge)).map(|(span, range)| {
        let [axles, more] = chosen.acting.axle_factors(span.span, depth);
        critical = critical.max(more);
        OfSpan { range, axles, uniform: chosen.acting.uniform_factor(span.span, depth) }
    });
    let spans = spans.collect();
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
        length: if plan.own_dispersal { chosen.vehicle.contact_length_m } else { rule.dispersal.length_base_m },
        across: across::worst(bridge, rule, chosen),
        spans,
        critical,
        horizontal: plan.braking,
    }
}

/// An arrangement of a vehicle by its name.
pub(super) fn pattern(chosen: &Chosen, arrangement: &str) -> Option<Pattern> {
    chosen.vehicle.patterns().into_iter().find(|pattern| pattern.label == arrangement)
}

/// The bridge with one case as its loads: each axle and each stretch of uniform load by itself, with its factors.
pub(super) fn with_case(bridge: &Bridge, plan: &SweepPlan, rule: &Rule, chosen: &Chosen, case: &Case) -> Bridge {
    let foot = footprint(bridge, plan, rule, chosen);
    let vehicle = &chosen.vehicle;
    let mut b = bridge.clone();
    b.dispersal = foot.dispersal;
    let Some(pattern) = pattern(chosen, &case.arrangement) else { return b };
    let sign = if case.direction == Direction::Right { 1.0 } else { -1.0 };
    let load = |part: String, kind: LoadKind, position: f64| Load {
        name: format!("{}, {part}", vehicle.title),
        kind,
        position,
        block: None,
        horizontal: case.horizontal,
        whole_length: true,
    };
    if let Some([first, last]) = case.axles {
        for (k, axle) in pattern.axles.iter().enumerate().take(last + 1).skip(first) {
            let critical = if case.critical_axle == Some(k) { foot.critical } else { 1.0 };
            let position = case.position - sign * axle.offset;
            let axles = vec![(axle.force * foot.axle_at(position) * critical, 0.0)];
            let (contact_length, effective_width) = (foot.length, foot.across.axles);
            let kind = LoadKind::Axles { axles, contact_length, effective_width };
            b.loads.push(load(format!("axle {}", k + 1), kind, position));
        }
    }
    if let Some(range) = case.uniform {
        for (from, to, pressure) in clipped(&pattern, &foot, case, range) {
            let kind = LoadKind::Patch { pressure, length: to - from };
            b.loads.push(load("uniform load".to_owned(), kind, 0.5 * (from + to)));
        }
    }
    b
}

/// Where the pattern's uniform loads stand within a range: from, to [m], and pressure with its factors on its own width [Pa].
pub(super) fn clipped(pattern: &Pattern, foot: &Footprint, case: &Case, range: [f64; 2]) -> Vec<(f64, f64, f64)> {
    let place = |behind: f64| match case.direction {
        Direction::Right => case.position - behind,
        Direction::Left => case.position + behind,
    };
    let parts = pattern.stretches.iter().enumerate().flat_map(|(k, s)| {
        let (a, b) = (place(s.from), place(s.to));
        let (from, to) = (a.min(b).max(range[0]), a.max(b).min(range[1]));
        let width = foot.across.uniform.get(k).copied().unwrap_or(foot.across.axles);
        let pieces = if to > from + 1e-9 { foot.pieces(from, to) } else { Vec::new() };
        pieces.into_iter().map(move |(from, to, factor)| (from, to, s.force * factor / width))
    });
    parts.collect()
}
