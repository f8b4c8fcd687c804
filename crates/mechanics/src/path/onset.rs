//! States that a load should not bring about in service.

use super::outcome::PathPoint;

/// What of a balanced state is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// [`PathPoint::eccentricity`].
    Eccentricity,
    /// [`PathPoint::opened`].
    Opened,
    /// [`PathPoint::stress`].
    Stress,
    /// How many times as far as at first the place that moves most does for a little more load: [`PathPoint::rate`].
    Softening,
}

/// The states in which a measure is greater than this.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Onset {
    /// What is looked at.
    pub measure: Measure,
    /// Its largest value before.
    pub most: f64,
}

impl Onset {
    /// How far a state lies beyond, positive where it does; `first` is the rate under self-weight.
    pub(super) fn excess(&self, point: &PathPoint, first: Option<f64>) -> f64 {
        match self.measure {
            Measure::Eccentricity => point.eccentricity / self.most - 1.0,
            Measure::Opened => point.opened / self.most - 1.0,
            Measure::Stress => point.stress / self.most - 1.0,
            // In stiffness: that falls to nothing at the largest load, in nearly a straight line.
            Measure::Softening => match (first, point.rate) {
                (Some(first), Some(now)) => 1.0 - self.most * first / now,
                _ => -1.0,
            },
        }
    }
}
