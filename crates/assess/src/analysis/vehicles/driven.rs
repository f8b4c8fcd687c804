//! One vehicle in its first arrangement, whole, wherever somebody puts it.

use super::cases::reach;
use super::factored::{self, footprint, with_case};
use super::weights;
use crate::vehicles::{Chosen, Refused, chosen};
use bridge::{Bridge, SweepPlan};
use outcome::vehicles::{Case, Direction, Weights};
use rules::{Pattern, Rule};
use structure::discretise::Discretised;

/// A vehicle with the rule whose factors its loads have.
#[derive(Debug, Clone)]
pub struct Driven {
    /// The rule.
    pub rule: Rule,
    /// The vehicle.
    pub vehicle: Chosen,
    /// Which way it drives.
    pub direction: Direction,
    plan: SweepPlan,
    pattern: Pattern,
    weights: Vec<Weights>,
}

impl Driven {
    /// A vehicle by its code, or the first of those that the plan moves. The plan says which rule, whose dispersal, which braking.
    ///
    /// # Errors
    /// A vehicle or a rule that is not known, or that do not go together.
    pub fn new(bridge: &Bridge, plan: &SweepPlan, vehicle: &str, direction: Direction) -> Result<Driven, Refused> {
        let mut plan = plan.clone();
        if !vehicle.is_empty() {
            plan.vehicles = vec![vehicle.to_owned()];
        }
        let (rule, all) = chosen(bridge, &plan)?;
        let vehicle = all.into_iter().next().ok_or_else(Refused::default)?;
        let pattern = vehicle.vehicle.patterns().into_iter().next().ok_or_else(Refused::default)?;
        let weights = weights::combinations(bridge, &rule);
        Ok(Driven { rule, vehicle, direction, plan, pattern, weights })
    }

    /// The bridge under every combination of the rule's factors on weights, without loads.
    pub(in crate::analysis) fn bridges(&self, bridge: &Bridge) -> Vec<Bridge> {
        self.weights.iter().map(|weights| factored::bridge(bridge, &self.rule, weights)).collect()
    }

    /// The factored bridge with the vehicle's first axle at a place [m].
    pub(in crate::analysis) fn placed(&self, bridge: &Bridge, position: f64) -> Bridge {
        let last = self.pattern.axles.len().checked_sub(1);
        let case = Case {
            position,
            direction: self.direction,
            arrangement: self.pattern.label.clone(),
            axles: last.map(|last| [0, last]),
            critical_axle: None,
            uniform: (!self.pattern.stretches.is_empty()).then(|| {
                let length = structure::discretise::bridge_length(bridge);
                [-length, 2.0 * length]
            }),
            weights: self.weights[0],
            horizontal: self.plan.braking,
            load: 0.0,
        };
        with_case(bridge, &self.plan, &self.rule, &self.vehicle, &case)
    }

    /// Places of the first axle at which something stands over the arches [m].
    pub(in crate::analysis) fn range(&self, d: &Discretised) -> [f64; 2] {
        let foot = footprint_length(&self.plan, &self.rule, &self.vehicle);
        let [from, to] = reach(d, foot, 2.0);
        match self.direction {
            Direction::Right => [from, to + self.pattern.length()],
            Direction::Left => [from - self.pattern.length(), to],
        }
    }

    /// Force [N] of each axle without factors, and how far it stands behind the first [m].
    pub fn axles(&self) -> Vec<(f64, f64)> {
        self.pattern.axles.iter().map(|axle| (axle.force, axle.offset)).collect()
    }

    /// The width of the barrel that carries an axle [m].
    pub fn width(&self, bridge: &Bridge) -> f64 {
        footprint(bridge, &self.plan, &self.rule, &self.vehicle).across.axles
    }
}

/// Length of an axle's footprint on the road [m].
fn footprint_length(plan: &SweepPlan, rule: &Rule, vehicle: &Chosen) -> f64 {
    if plan.own_dispersal { vehicle.vehicle.contact_length_m } else { rule.dispersal.length_base_m }
}
