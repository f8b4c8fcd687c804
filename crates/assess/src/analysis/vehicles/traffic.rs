//! Vehicles on a bridge under the factors of a rule: what every method starts from.

use super::AnalysisError;
use super::factored::{self, Footprint, footprint};
use super::twins::{Twin, twins};
use crate::analysis::engine::rigid;
use crate::vehicles::Chosen;
use bridge::{Bridge, SweepPlan};
use outcome::vehicles::{Case, EnvelopePoint, Swept, Weights};
use rules::Rule;
use structure::discretise::Discretised;

/// See above.
pub(super) struct Traffic<'a> {
    pub rule: &'a Rule,
    pub plan: &'a SweepPlan,
    pub vehicles: &'a [Chosen],
    /// Combinations of factors on weights.
    pub weights: &'a [Weights],
    /// The bridge under each of them, without loads, and its blocks.
    pub bridges: Vec<Bridge>,
    pub built: Vec<Discretised>,
    /// How the axles of each vehicle stand.
    pub feet: Vec<Footprint>,
    /// Of each vehicle the one that it is a multiple of.
    pub twins: Vec<Option<Twin>>,
}

impl<'a> Traffic<'a> {
    /// Cuts the bridge into blocks.
    pub(super) fn new(
        bridge: &Bridge,
        (rule, plan): (&'a Rule, &'a SweepPlan),
        (vehicles, weights): (&'a [Chosen], &'a [Weights]),
    ) -> Result<Traffic<'a>, AnalysisError> {
        let bridges: Vec<Bridge> = weights.iter().map(|w| factored::bridge(bridge, rule, w)).collect();
        let built = bridges.iter().map(rigid::prepared).collect::<Result<_, _>>()?;
        let feet: Vec<Footprint> = vehicles.iter().map(|v| footprint(bridge, plan, rule, v)).collect();
        let twins = twins(vehicles, &feet);
        Ok(Traffic { rule, plan, vehicles, weights, bridges, built, feet, twins })
    }

    /// Vehicles that are answered by themselves.
    pub(super) fn own(&self) -> Vec<usize> {
        (0..self.vehicles.len()).filter(|&k| self.twins[k].is_none()).collect()
    }

    /// Lets twins be told as those that they are multiples of.
    pub(super) fn told_alike(&self, swept: &mut [Swept], alike: fn(&mut Swept, &Swept, f64)) {
        for (k, twin) in self.twins.iter().enumerate() {
            if let Some(twin) = twin {
                let of = swept[twin.of].clone();
                alike(&mut swept[k], &of, twin.times);
            }
        }
    }

    /// What governs at a point of an envelope, without its load.
    pub(super) fn governing(&self, point: &EnvelopePoint) -> Case {
        let weights = point.weights.unwrap_or(self.weights[0]);
        Case { weights, horizontal: self.plan.braking, load: 0.0, ..point.case.clone() }
    }
}
