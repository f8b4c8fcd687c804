//! What is believed of a parameter before the records are seen.

use crate::parameter::Parameter;
use serde::{Deserialize, Serialize};

/// A prior over the range of a parameter; nothing is believed outside it.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub enum Prior {
    /// Even over the range, in the parameter's scale.
    #[default]
    Uniform,
    /// Normal, cut off at the range.
    Normal {
        /// Mean [unit of the parameter].
        mean: f64,
        /// Standard deviation [unit of the parameter].
        standard_deviation: f64,
    },
    /// Normal in the logarithm, cut off at the range.
    LogNormal {
        /// Mean of the logarithm.
        mean: f64,
        /// Standard deviation of the logarithm.
        standard_deviation: f64,
    },
}

impl Prior {
    /// What is wrong with its numbers.
    pub(crate) fn complaint(&self) -> Option<String> {
        let (Self::Normal { mean, standard_deviation } | Self::LogNormal { mean, standard_deviation }) = *self else {
            return None;
        };
        let sound = mean.is_finite() && standard_deviation.is_finite() && standard_deviation > 0.0;
        (!sound).then(|| format!("the prior has mean {mean} and standard deviation {standard_deviation}"))
    }

    /// Logarithm of the density over the share of the range, but for a constant; minus infinity outside.
    pub(crate) fn log_density(&self, parameter: &Parameter, share: f64) -> f64 {
        if !(0.0..=1.0).contains(&share) {
            return f64::NEG_INFINITY;
        }
        let value = parameter.at(share);
        let normal = |x: f64, mean: f64, deviation: f64| -0.5 * ((x - mean) / deviation).powi(2);
        match *self {
            Self::Uniform => 0.0,
            Self::Normal { mean, standard_deviation } => {
                normal(value, mean, standard_deviation) + parameter.slope(share).ln()
            }
            Self::LogNormal { .. } if !(value > 0.0) => f64::NEG_INFINITY,
            Self::LogNormal { mean, standard_deviation } => {
                normal(value.ln(), mean, standard_deviation) - value.ln() + parameter.slope(share).ln()
            }
        }
    }

    /// Cumulated density over even cells of the range, from 0 to 1, for drawing by one even number.
    pub(crate) fn cumulated(&self, parameter: &Parameter) -> Vec<f64> {
        let cells = if *self == Self::Uniform { 1 } else { 4096 };
        let middle = |k: usize| (k as f64 + 0.5) / cells as f64;
        let logs: Vec<f64> = (0..cells).map(|k| self.log_density(parameter, middle(k))).collect();
        let top = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        // A prior that lies wholly outside the range says nothing inside it.
        let density = |log: f64| if top.is_finite() { (log - top).exp() } else { 1.0 };
        let mut sums = vec![0.0];
        for log in logs {
            sums.push(sums[sums.len() - 1] + density(log));
        }
        let total = sums[cells];
        sums.into_iter().map(|sum| sum / total).collect()
    }
}

/// The share at which a cumulated density reaches `even`, 0 to 1.
pub(crate) fn invert(cumulated: &[f64], even: f64) -> f64 {
    let cells = cumulated.len() - 1;
    let cell = cumulated.partition_point(|sum| *sum <= even).clamp(1, cells) - 1;
    let (low, high) = (cumulated[cell], cumulated[cell + 1]);
    let inside = if high > low { (even - low) / (high - low) } else { 0.5 };
    ((cell as f64 + inside) / cells as f64).clamp(0.0, 1.0)
}
