//! Vehicles on a bridge under the factors of a rule: what every method starts from.

use super::AnalysisError;
use super::factored::{self, Footprint, footprint};
use crate::analysis::engine::rigid;
use crate::vehicles::Chosen;
use bridge::{Bridge, SweepPlan};
use outcome::vehicles::{Case, EnvelopePoint, Swept, Weights};
use rules::{Pattern, Rule};
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

/// A vehicle whose loads are a multiple of those of an earlier one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Twin {
    /// The earlier one.
    pub of: usize,
    /// How many times its loads.
    pub times: f64,
}

/// For each vehicle the first one that it is a multiple of, units of HB or numbers of RA: the same cases govern both.
fn twins(vehicles: &[Chosen], feet: &[Footprint]) -> Vec<Option<Twin>> {
    let patterns: Vec<Vec<Pattern>> = vehicles.iter().map(|chosen| chosen.vehicle.patterns()).collect();
    let mut twins: Vec<Option<Twin>> = Vec::with_capacity(vehicles.len());
    for k in 0..vehicles.len() {
        let twin = (0..k).filter(|&of| twins[of].is_none() && feet[of] == feet[k]).find_map(|of| {
            let alike = vehicles[of].vehicle.axles_may_be_dropped == vehicles[k].vehicle.axles_may_be_dropped
                && patterns[of].len() == patterns[k].len();
            let times = patterns[k].first()?.force() / patterns[of].first()?.force();
            let multiple = patterns[k].iter().zip(&patterns[of]).all(|(this, other)| this.is_multiple(other, times));
            (alike && multiple).then_some(Twin { of, times })
        });
        twins.push(twin);
    }
    twins
}
