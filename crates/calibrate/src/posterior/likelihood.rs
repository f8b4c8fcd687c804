//! How likely the records are at given parameters: noise of the measurement, a gain that all channels share ([`super::gain`]), and an
//! error of the model with a scale of its own.
//!
//! The model's error of a channel is a gain of its own: a share of the model's response, drawn from a normal distribution once for the
//! channel. Where a block is given, a local part of the same scale joins it: a share of the model's peak, constant over
//! each block of the history and independent between blocks. But for the common gain channels are independent. The covariance of the differences
//! of a channel is then that of its blocks, $\mathbf D = \tau \sigma^2 \mathbf 1 + \ell^2\, \mathbf e \mathbf e^T$ each, with
//! $g^2\, \mathbf u \mathbf u^T$ over all; its inverse and determinant are known in closed form.
//!
//! The gain goes with the response $\mathbf u$ and not with the record: the record's own noise in the covariance pulls
//! amplitudes down (Peelle's puzzle), to $1/(1 + g^2 N)$ of the truth for $N$ values. The covariance changes with the
//! parameters, and so its determinant belongs to the density.
//!
//! Where $\tau$ values of a record tell as much as one, its noise counts with $\tau$ times its variance: exact for responses that are
//! slow beside the correlation of the noise, as those that a low pass lets through.

use crate::forward::Response;
use crate::misfit::{Compare, Held, compared_of, peak_place, record};
use crate::posterior::gain::{Gain, Sums};
use crate::problem::{Flaw, Problem};
use serde::{Deserialize, Serialize};

/// The error that the model would have at its best parameters.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum ModelError {
    /// The model is exact.
    None,
    /// Its standard deviation is this share of the model's response.
    Known(f64),
    /// Its standard deviation, as a share of the model's response, is sought too: half-normal of this scale, cut off at four
    /// scales.
    Sought(f64),
}

/// How likely records are.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Likelihood {
    /// The model's error.
    pub model_error: ModelError,
    /// Values of a history over which the local part of the model's error is constant; none for a gain alone.
    pub block: Option<usize>,
    /// Standard deviation of the gain that all channels share; zero where it is known to be one.
    pub common_gain: f64,
}

impl Default for Likelihood {
    fn default() -> Self {
        Self { model_error: ModelError::Sought(0.1), block: None, common_gain: 0.1 }
    }
}

/// Scales of the half-normal at which it is cut off.
const CUT: f64 = 4.0;

impl Likelihood {
    /// What keeps it from being computed.
    pub(crate) fn check(&self, problem: &Problem) -> Vec<Flaw> {
        let mut findings = Vec::new();
        let mut say = |place: &str, message: &str, help: &str| {
            findings.push(Flaw { place: place.to_owned(), message: message.to_owned(), help: help.to_owned() });
        };
        for channel in problem.channels().iter().filter(|channel| channel.counts()) {
            if channel.uncertainty.is_none() {
                let help = "give the standard deviation of one value, a least count at least";
                say(&channel.name, "a posterior needs its uncertainty", help);
            }
        }
        let scale = match self.model_error {
            ModelError::None => None,
            ModelError::Known(scale) | ModelError::Sought(scale) => Some(scale),
        };
        if scale.is_some_and(|scale| !(scale.is_finite() && scale > 0.0)) {
            say("model error", "its scale is not above zero", "give a share of the peaks, as 0.1");
        }
        if !(self.common_gain.is_finite() && self.common_gain >= 0.0) {
            say("common gain", "its standard deviation is below zero", "give a share of the response, as 0.1, or zero");
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

    /// Logarithm of the likelihood, complete with its constants, and the common gain as the records leave it at these parameters. What full
    /// passages give beyond slices is added to the values.
    pub(crate) fn log(&self, problem: &Problem, held: &Held, response: &Response, scale: f64) -> (f64, Gain) {
        let mut all = Sums::default();
        for (k, values) in response.values.iter().enumerate().filter(|(k, _)| problem.channels()[*k].counts()) {
            let model = compared_of(problem, held, k, values);
            let differences: Vec<f64> = model.iter().zip(&*record(problem, k)).map(|(u, v)| u - v).collect();
            let peak = || peak_place(problem, k, values).map_or(f64::NAN, |place| model[place]);
            let local = match (problem.compare(k), self.block) {
                (Compare::Histories, Some(_)) => scale * peak(),
                _ => 0.0,
            };
            let noise = Noise::of(problem, k);
            all.add(sums(&differences, &model, noise, local, self.block.unwrap_or(usize::MAX)).with_gain(scale));
        }
        (all.with_gain(self.common_gain).log_density(), all.gain(self.common_gain))
    }
}

/// Noise of the measurement of one channel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Noise {
    /// Variance of one value.
    variance: f64,
    /// Values that together tell as much as one that is independent.
    over: f64,
}

impl Noise {
    /// As the channel states it, a peak being one value alone; not a number where it does not.
    pub(crate) fn of(problem: &Problem, channel: usize) -> Self {
        let compare = problem.compare(channel);
        let channel = &problem.channels()[channel];
        let deviation = channel.uncertainty.unwrap_or(f64::NAN);
        let over = match compare {
            Compare::Peaks => 1.0,
            Compare::Histories => channel.correlated_over.unwrap_or(1.0).max(1.0),
        };
        Self { variance: deviation * deviation, over }
    }

    /// Variance with which every value counts.
    pub(crate) fn each(self) -> f64 {
        self.over * self.variance
    }
}

/// Sums over one channel with its noise and a local error that is constant over blocks.
fn sums(differences: &[f64], response: &[f64], noise: Noise, local: f64, block: usize) -> Sums {
    let (noise2, local2) = (noise.each(), local * local);
    let independent = differences.len() as f64 / noise.over;
    let mut all =
        Sums { determinant: independent * (2.0 * std::f64::consts::PI * noise.variance).ln(), ..Sums::default() };
    for (d, u) in differences.chunks(block).zip(response.chunks(block)) {
        let spread = noise2 + d.len() as f64 * local2;
        let (sum_d, sum_u) = (d.iter().sum::<f64>(), u.iter().sum::<f64>());
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let through = |product: f64, sums: f64| (product - local2 * sums / spread) / noise2;
        all.add(Sums {
            differences: through(dot(d, d), sum_d * sum_d),
            along: through(dot(u, d), sum_u * sum_d),
            response: through(dot(u, u), sum_u * sum_u),
            determinant: (spread / noise2).ln(),
        });
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::Mat;
    use faer::linalg::solvers::Solve;

    #[test]
    fn the_density_is_that_of_the_whole_matrix() {
        let d = [0.4, -0.2, 0.3, 0.1, -0.5];
        let v = [0.1, 0.5, 0.9, 0.4, 0.2];
        let (noise, local, block) = (0.3, 0.7, 2);
        let covariance = Mat::from_fn(5, 5, |i, j| {
            let same = if i == j { noise * noise } else { 0.0 };
            let together = if i / block == j / block { local * local } else { 0.0 };
            same + together + v[i] * v[j]
        });
        let right = Mat::from_fn(5, 1, |i, _| d[i]);
        let factor = covariance.partial_piv_lu();
        let solved = factor.solve(&right);
        let quadratic: f64 = (0..5).map(|i| d[i] * solved[(i, 0)]).sum();
        let by_matrix = -0.5 * (quadratic + covariance.determinant().ln() + 5.0 * (2.0 * std::f64::consts::PI).ln());
        let response = v.map(|v| v / 0.2);
        let sums = sums(&d, &response, Noise { variance: noise * noise, over: 1.0 }, local, block);
        let found = sums.with_gain(0.2).log_density();
        assert!((found - by_matrix).abs() < 1e-12, "rounding: {found} {by_matrix}");
    }
}
