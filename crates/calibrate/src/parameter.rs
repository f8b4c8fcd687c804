//! What may change: parameters with their range and where the search begins.

use crate::posterior::Prior;
use serde::{Deserialize, Serialize};

/// How a range is divided: evenly in the value or in its logarithm.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Scale {
    /// Evenly in the value, as the paper's sweeps.
    #[default]
    Linear,
    /// Evenly in the logarithm of the value, for ranges over orders of magnitude; needs a lower bound above zero.
    Logarithmic,
}

/// One parameter of the model [in its own unit].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Parameter {
    /// What it is called in reports.
    pub name: String,
    /// Unit of its values, for reports alone.
    pub unit: String,
    /// Value of the start model.
    pub start: f64,
    /// Lower end of the acceptable range.
    pub lower: f64,
    /// Upper end of the acceptable range.
    pub upper: f64,
    /// How the range is divided.
    pub scale: Scale,
    /// What is believed of it before the records are seen.
    pub prior: Prior,
}

impl Parameter {
    /// A parameter with a range, linear and with a uniform prior.
    pub fn new(name: &str, unit: &str, start: f64, lower: f64, upper: f64) -> Self {
        let (name, unit) = (name.to_owned(), unit.to_owned());
        Self { name, unit, start, lower, upper, scale: Scale::Linear, prior: Prior::Uniform }
    }

    /// The same parameter, divided evenly in its logarithm.
    pub fn logarithmic(self) -> Self {
        Self { scale: Scale::Logarithmic, ..self }
    }

    /// The value at a share of the range, 0 to 1; the ends are met exactly.
    pub fn at(&self, share: f64) -> f64 {
        if share <= 0.0 {
            return self.lower;
        }
        if share >= 1.0 {
            return self.upper;
        }
        let value = match self.scale {
            Scale::Linear => self.lower + (self.upper - self.lower) * share,
            Scale::Logarithmic => (self.lower.ln() + (self.upper / self.lower).ln() * share).exp(),
        };
        value.clamp(self.lower, self.upper)
    }

    /// Share of the range at which a value lies, 0 to 1.
    pub fn share(&self, value: f64) -> f64 {
        let share = match self.scale {
            Scale::Linear => (value - self.lower) / (self.upper - self.lower),
            Scale::Logarithmic => (value / self.lower).ln() / (self.upper / self.lower).ln(),
        };
        share.clamp(0.0, 1.0)
    }

    /// Change of the value with the share, at a share.
    pub fn slope(&self, share: f64) -> f64 {
        match self.scale {
            Scale::Linear => self.upper - self.lower,
            Scale::Logarithmic => self.at(share) * (self.upper / self.lower).ln(),
        }
    }

    /// The values of a sweep over the whole range, both ends included.
    pub fn grid(&self, points: usize) -> Vec<f64> {
        let last = points.max(2) - 1;
        (0..=last).map(|k| self.at(k as f64 / last as f64)).collect()
    }

    /// Whether a value stands on an end of the range, or so near that a search which stays inside would come no nearer.
    pub fn at_bound(&self, value: f64) -> bool {
        const NEAR: f64 = 1e-5;
        let near = NEAR * (self.upper - self.lower);
        value <= self.lower + near || value >= self.upper - near
    }
}

/// Where a search begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Start {
    /// At the start values of the parameters.
    #[default]
    Stated,
    /// At the middle of every range, as the paper recommends.
    Means,
    /// At every lower bound.
    LowerBounds,
    /// At every upper bound.
    UpperBounds,
}

impl Start {
    /// The word that files and scripts read.
    pub fn word(self) -> &'static str {
        match self {
            Start::Stated => "stated",
            Start::Means => "means",
            Start::LowerBounds => "lower-bounds",
            Start::UpperBounds => "upper-bounds",
        }
    }

    /// The values it stands for.
    pub fn point(self, parameters: &[Parameter]) -> Vec<f64> {
        let value = |parameter: &Parameter| match self {
            Start::Stated => parameter.start,
            Start::Means => 0.5 * (parameter.lower + parameter.upper),
            Start::LowerBounds => parameter.lower,
            Start::UpperBounds => parameter.upper,
        };
        parameters.iter().map(value).collect()
    }
}

/// The values at shares of the ranges.
pub(crate) fn values(parameters: &[Parameter], shares: &[f64]) -> Vec<f64> {
    parameters.iter().zip(shares).map(|(parameter, share)| parameter.at(*share)).collect()
}

/// The shares of the ranges at which values lie.
pub(crate) fn shares(parameters: &[Parameter], point: &[f64]) -> Vec<f64> {
    parameters.iter().zip(point).map(|(parameter, value)| parameter.share(*value)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_are_met_exactly_and_shares_return() {
        for parameter in
            [Parameter::new("E", "GPa", 1.25, 0.1, 0.7), Parameter::new("k", "", 3.0, 0.1, 700.0).logarithmic()]
        {
            let grid = parameter.grid(11);
            assert_eq!((grid[0], grid[10]), (parameter.lower, parameter.upper));
            for (k, value) in grid.iter().enumerate() {
                let share = k as f64 / 10.0;
                assert!((parameter.share(*value) - share).abs() < 1e-14, "rounding of one division and logarithm");
                let h = 1e-6;
                let rate = (parameter.at(share.min(1.0 - h) + h) - parameter.at(share.min(1.0 - h))) / h;
                // Forward difference: error of h/2 times the second derivative, 44 slopes at the most here.
                assert!((rate / parameter.slope(share) - 1.0).abs() < 1e-4);
            }
        }
    }
}
