//! States that a bridge should not come to in service: which ones are sought, and the least load factors at which they are met.

use mechanics::path::{Measure, Onset};
use outcome::collapse::Criterion;

/// So many states are sought, in the order in which they are told.
pub(super) const SOUGHT: usize = Criterion::ALL.len();

/// What a path is asked for, where joints crush at a strength [Pa]; infinite for none.
pub(super) fn sought(strength: f64) -> Vec<Onset> {
    let of = |criterion| match criterion {
        Criterion::MiddleThird => Onset { measure: Measure::Eccentricity, most: 1.0 / 6.0 },
        Criterion::HalfOpen => Onset { measure: Measure::Opened, most: 0.5 },
        Criterion::HalfStrength => Onset { measure: Measure::Stress, most: 0.5 * strength },
        Criterion::HalfStiffness => Onset { measure: Measure::Softening, most: 2.0 },
    };
    Criterion::ALL.iter().copied().map(of).collect()
}

/// The states that a path meets, each with its load factor.
pub(super) fn met(onsets: &[Option<f64>]) -> impl Iterator<Item = (Criterion, f64)> {
    Criterion::ALL.iter().copied().zip(onsets).filter_map(|(criterion, factor)| Some((criterion, (*factor)?)))
}

/// The least load factors at which loads that move bring the states about, as far as they are known.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Service {
    /// Factors below which each state is still sought, in the order of [`sought`].
    pub factors: [f64; SOUGHT],
    /// Positions of the loads there [m]; none while the factor is but the one below which a state counts.
    positions: [Option<f64>; SOUGHT],
}

impl Service {
    /// Nothing is known, and only what is met below a load factor counts.
    pub(super) fn below(factor: f64) -> Service {
        Service { factors: [factor; SOUGHT], positions: [None; SOUGHT] }
    }

    /// Takes what a load at a position [m] came to.
    pub(super) fn take(&mut self, onsets: &[Option<f64>], position: f64) {
        for (k, factor) in onsets.iter().enumerate() {
            if let Some(factor) = factor.filter(|factor| *factor < self.factors[k]) {
                (self.factors[k], self.positions[k]) = (factor, Some(position));
            }
        }
    }

    /// Takes what others found; of two that are alike the one that was there first stays.
    pub(super) fn merge(&mut self, other: &Service) {
        for k in 0..SOUGHT {
            if other.positions[k].is_some() && other.factors[k] < self.factors[k] {
                (self.factors[k], self.positions[k]) = (other.factors[k], other.positions[k]);
            }
        }
    }

    /// The states that were met, with the load factor and the position [m].
    pub(super) fn told(&self) -> impl Iterator<Item = (Criterion, f64, f64)> {
        let each = Criterion::ALL.iter().copied().zip(self.factors).zip(self.positions);
        each.filter_map(|((criterion, factor), position)| Some((criterion, factor, position?)))
    }
}
