//! How likely the records are at given parameters: noise of the measurement, and an error of the model with a scale of
//! its own.
//!
//! Of a channel, the model's error is a share of the measured peak, drawn from a normal distribution and constant over
//! blocks of its history; between blocks and channels it is independent. A block of $m$ values with differences $d$ then has
//! the covariance $\sigma^2 \mathbf 1 + s^2\, \mathbf e \mathbf e^T$, whose inverse and determinant are known in closed form.

use crate::forward::Response;
use crate::misfit::{Compare, peak_place};
use crate::problem::{Finding, Problem};

/// The error that the model would have at its best parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ModelError {
    /// The model is exact.
    None,
    /// Its standard deviation is this share of each measured peak.
    Known(f64),
    /// Its standard deviation, as a share of each measured peak, is sought too: half-normal of this scale, cut off at four
    /// scales.
    Sought(f64),
}

/// How likely records are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Likelihood {
    /// The model's error.
    pub model_error: ModelError,
    /// Values of a history over which the model's error is constant; none for the whole history.
    pub block: Option<usize>,
}

impl Default for Likelihood {
    fn default() -> Self {
        Self { model_error: ModelError::Sought(0.1), block: None }
    }
}

/// Scales of the half-normal at which it is cut off.
const CUT: f64 = 4.0;

impl Likelihood {
    /// What keeps it from being computed.
    pub(crate) fn check(&self, problem: &Problem) -> Vec<Finding> {
        let mut findings = Vec::new();
        let mut say = |place: &str, message: &str, help: &str| {
            findings.push(Finding { place: place.to_owned(), message: message.to_owned(), help: help.to_owned() });
        };
        for channel in problem.channels().iter().filter(|channel| channel.counts()) {
            if channel.uncertainty.is_none() {
                let help = "give the standard deviation of one value, a least count at least";
                say(&channel.name, "a posterior needs its uncertainty", help);
            }
        }
        if let ModelError::Known(scale) | ModelError::Sought(scale) = self.model_error {
            if !(scale.is_finite() && scale > 0.0) {
                say("model error", "its scale is not above zero", "give a share of the peaks, as 0.1");
            }
        }
        if self.block == Some(0) {
            say("model error", "its block has no value", "give a count of values, or none");
        }
        findings
    }

    /// How many numbers are sought beside the parameters.
    pub(crate) fn extra(&self) -> usize {
        usize::from(matches!(self.model_error, ModelError::Sought(_)))
    }

    /// The model's error as a share of the peaks, from the number sought, 0 to 1.
    pub(crate) fn scale(&self, sought: Option<&f64>) -> f64 {
        match self.model_error {
            ModelError::None => 0.0,
            ModelError::Known(scale) => scale,
            ModelError::Sought(scale) => CUT * scale * sought.copied().unwrap_or(0.0),
        }
    }

    /// Logarithm of the density of the number sought, but for a constant.
    pub(crate) fn log_prior(&self, sought: Option<&f64>) -> f64 {
        match sought {
            Some(sought) if (0.0..=1.0).contains(sought) => -0.5 * (CUT * sought).powi(2),
            Some(_) => f64::NEG_INFINITY,
            None => 0.0,
        }
    }

    /// Logarithm of the likelihood, complete with its constants.
    pub(crate) fn log(&self, problem: &Problem, response: &Response, scale: f64) -> f64 {
        let mut sum = 0.0;
        for (k, values) in response.values.iter().enumerate().filter(|(k, _)| problem.channels()[*k].counts()) {
            let channel = &problem.channels()[k];
            let noise = channel.uncertainty.unwrap_or(f64::NAN);
            let model = scale * channel.measured_peak().unwrap_or(0.0);
            let differences: Vec<f64> = match problem.misfit().compare {
                Compare::Peaks => peak_place(problem, k, values)
                    .zip(channel.measured_peak())
                    .map(|(place, peak)| values[place] - peak)
                    .into_iter()
                    .collect(),
                Compare::Histories => {
                    values.iter().zip(channel.history.as_deref().unwrap_or(&[])).map(|(u, v)| u - v).collect()
                }
            };
            let block = self.block.unwrap_or(differences.len()).max(1);
            sum += differences.chunks(block).map(|block| log_of_block(block, noise, model)).sum::<f64>();
        }
        sum
    }
}

/// Logarithm of the normal density of differences with independent noise and one common error.
fn log_of_block(differences: &[f64], noise: f64, common: f64) -> f64 {
    let m = differences.len() as f64;
    let (sum, squares) = differences.iter().fold((0.0, 0.0), |(s, q), d| (s + d, q + d * d));
    let (noise2, common2) = (noise * noise, common * common);
    let spread = noise2 + m * common2;
    let determinant = (m - 1.0) * noise2.ln() + spread.ln();
    let quadratic = (squares - common2 * sum * sum / spread) / noise2;
    -0.5 * (quadratic + determinant + m * (2.0 * std::f64::consts::PI).ln())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_is_the_normal_density_by_its_matrix() {
        // Two values: covariance [[a, c], [c, a]] with a = noise^2 + common^2 and c = common^2.
        let (noise, common) = (0.3_f64, 0.7_f64);
        let (a, c) = (noise * noise + common * common, common * common);
        let d = [0.4, -0.2];
        let determinant = a * a - c * c;
        let quadratic = (a * d[0] * d[0] - 2.0 * c * d[0] * d[1] + a * d[1] * d[1]) / determinant;
        let by_hand = -0.5 * (quadratic + determinant.ln()) - (2.0 * std::f64::consts::PI).ln();
        assert!((log_of_block(&d, noise, common) - by_hand).abs() < 1e-13, "rounding");
    }
}
