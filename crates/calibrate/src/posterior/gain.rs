//! A gain that all channels share: the records are those of the model times one uncertain factor.
//!
//! Axle loads that differ from the assumed ones, the width that carries them and the share of a track scale every channel alike, to first
//! order. The gain is normal about one with standard deviation $c$. Integrated out, it adds $c^2\, \mathbf u \mathbf u^T$ over the values
//! of all channels together to their covariance, $\mathbf u$ being the model's response; given the parameters it is left as a normal
//! distribution in closed form (Sherman and Morrison; Woodbury). What moves every channel in proportion, as a common factor of all
//! stiffnesses does, cannot be told from it.

use crate::parameter::Parameter;
use crate::posterior::summary::{self, Summary};
use serde::{Deserialize, Serialize};

/// Sums over the channels, $\mathbf A$ being the covariance of the differences $\mathbf d$ without the common gain.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Sums {
    /// $\mathbf d^T \mathbf A^{-1} \mathbf d$.
    pub differences: f64,
    /// $\mathbf u^T \mathbf A^{-1} \mathbf d$.
    pub along: f64,
    /// $\mathbf u^T \mathbf A^{-1} \mathbf u$.
    pub response: f64,
    /// Logarithm of the determinant of $2 \pi \mathbf A$.
    pub determinant: f64,
}

impl Sums {
    /// Adds those of an independent channel.
    pub(crate) fn add(&mut self, other: Self) {
        self.differences += other.differences;
        self.along += other.along;
        self.response += other.response;
        self.determinant += other.determinant;
    }

    /// Those with a gain of this standard deviation in the covariance.
    pub(crate) fn with_gain(self, deviation: f64) -> Self {
        let gain2 = deviation * deviation;
        let answered = 1.0 + gain2 * self.response;
        Self {
            differences: self.differences - gain2 * self.along * self.along / answered,
            along: self.along / answered,
            response: self.response / answered,
            determinant: self.determinant + answered.ln(),
        }
    }

    /// Logarithm of the normal density of the differences.
    pub(crate) fn log_density(self) -> f64 {
        -0.5 * (self.differences + self.determinant)
    }

    /// A gain of this standard deviation as the differences (model less record) leave it.
    pub(crate) fn gain(self, deviation: f64) -> Gain {
        let variance = deviation * deviation / (1.0 + deviation * deviation * self.response);
        Gain { mean: 1.0 - variance * self.along, variance }
    }
}

/// A gain at one point of the parameters: a normal distribution.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Gain {
    /// Its mean; one, where records are as large as the model's.
    pub mean: f64,
    /// Its variance.
    pub variance: f64,
}

/// The common gain and what each parameter has to do with it, over all that is left open.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CommonGain {
    /// Standard deviation before the records are seen.
    pub prior_deviation: f64,
    /// Mean with the records.
    pub mean: f64,
    /// Standard deviation with the records.
    pub standard_deviation: f64,
    /// By parameter, its change with the gain [unit of the parameter for a gain of one].
    pub slopes: Vec<f64>,
    /// By parameter, the share of its variance that grows with the variance of the gain's prior, 0 to 1: where it is large the prior of
    /// the gain sets the interval, and not the records.
    pub shares: Vec<f64>,
}

/// Share of a variance from which a parameter counts as not told apart from the gain.
const NOT_TOLD_APART: f64 = 0.5;

impl CommonGain {
    /// From samples of the parameters, by parameter, and the gain at each; none where the gain is known exactly.
    pub(crate) fn of(columns: &[Vec<f64>], gains: &[Gain], prior_deviation: f64) -> Option<Self> {
        if !(prior_deviation > 0.0) || gains.is_empty() {
            return None;
        }
        let means: Vec<f64> = gains.iter().map(|gain| gain.mean).collect();
        let among = summary::summary(&means, None);
        let within = gains.iter().map(|gain| gain.variance).sum::<f64>() / gains.len() as f64;
        let variance = within + among.standard_deviation.powi(2);
        let with = |column: &Vec<f64>| {
            let deviation = summary::summary(column, None).standard_deviation;
            let covariance = summary::correlation(column, &means) * deviation * among.standard_deviation;
            // d Var(x) / d c² times c² / Var(x) for a normal distribution: a change of the prior reaches x through the gain alone.
            let share = (covariance / (deviation * prior_deviation)).powi(2);
            (covariance / variance, if share.is_finite() { share.min(1.0) } else { 0.0 })
        };
        let (slopes, shares) = columns.iter().map(with).unzip();
        Some(Self { prior_deviation, mean: among.mean, standard_deviation: variance.sqrt(), slopes, shares })
    }

    /// Whether the records tell a parameter apart from the gain.
    pub fn told_apart(&self, parameter: usize) -> bool {
        self.shares.get(parameter).is_none_or(|share| *share < NOT_TOLD_APART)
    }
}

/// What the gain takes from the parameters, in words; or that it is taken to be known.
pub(crate) fn words(gain: Option<&CommonGain>, parameters: &[Parameter], summaries: &[Summary]) -> Vec<String> {
    let Some(gain) = gain else {
        return vec![
            "Axle loads and the width that carries them count as exact (common gain of 0 %): an error of theirs moves the parameters, and no \
             interval holds it."
                .to_owned(),
        ];
    };
    let (prior, left) = ((1e5 * gain.prior_deviation).round() / 1e3, 100.0 * gain.standard_deviation);
    let told = if left < 0.5 * prior { "they tell it" } else { "they hardly tell it from the parameters" };
    let mut words = vec![format!(
        "A gain common to all channels (axle loads, the width that carries them) is uncertain by {prior} %. The records leave it at {:.3} \
         with a standard deviation of {left:.2} %: {told}.",
        gain.mean
    )];
    for (k, parameter) in parameters.iter().enumerate().filter(|(k, _)| !gain.told_apart(*k)) {
        let Parameter { name, unit, .. } = parameter;
        let Some(Summary { mean, .. }) = summaries.get(k) else { continue };
        let other = mean + gain.slopes[k] * gain.prior_deviation;
        words.push(format!(
            "{name} is not told apart from a gain common to all channels: were the axle loads {prior} % above those of the file, or the \
             width that carries them as much smaller, the same records would mean {other:.4} {unit} in place of {mean:.4}. {:.0} % of its \
             variance is that of the gain, which more records of the same vehicle do not reduce; a weighed one does.",
            100.0 * gain.shares[k]
        ));
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gain_is_what_the_whole_matrix_gives() {
        // Two independent values with variances 4 and 9, responses 2 and 3, differences 1 and -1; the gain's variance is 0.25.
        let sums = Sums {
            differences: 1.0 / 4.0 + 1.0 / 9.0,
            along: 2.0 / 4.0 - 3.0 / 9.0,
            response: 4.0 / 4.0 + 9.0 / 9.0,
            determinant: 36.0_f64.ln(),
        };
        // 4 + 0.25 * 4, 0.25 * 6, 9 + 0.25 * 9.
        let (a, b, c): (f64, f64, f64) = (5.0, 1.5, 11.25);
        let determinant = a * c - b * b;
        let inverse = [[c / determinant, -b / determinant], [-b / determinant, a / determinant]];
        let form = |x: [f64; 2], y: [f64; 2]| -> f64 {
            (0..2).map(|i| (0..2).map(|j| x[i] * inverse[i][j] * y[j]).sum::<f64>()).sum()
        };
        let (d, u) = ([1.0, -1.0], [2.0, 3.0]);
        let with = sums.with_gain(0.5);
        assert!((with.differences - form(d, d)).abs() < 1e-14, "rounding");
        assert!((with.along - form(u, d)).abs() < 1e-14 && (with.response - form(u, u)).abs() < 1e-14);
        assert!((with.determinant - determinant.ln()).abs() < 1e-14);
        // Regression of the gain on the records, v - u = -d: 1 - 0.25 u C^-1 d, variance 0.25 - 0.0625 u C^-1 u.
        let gain = sums.gain(0.5);
        assert!((gain.mean - (1.0 - 0.25 * form(u, d))).abs() < 1e-14, "{gain:?}");
        assert!((gain.variance - (0.25 - 0.0625 * form(u, u))).abs() < 1e-14, "{gain:?}");
    }
}
