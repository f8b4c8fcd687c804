//! What was measured: channels with a peak, a history, or both.

use crate::posterior::diagnostics::effective_samples;
use serde::{Deserialize, Serialize};

/// One measured channel [in its own unit].
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Channel {
    /// Name, as in the records.
    pub name: String,
    /// Unit of its values, for reports alone.
    pub unit: String,
    /// Signed peak; the value of largest magnitude of the history where it is not given.
    pub peak: Option<f64>,
    /// Values over the passage, at the times at which the model answers too; responses to the train alone.
    pub history: Option<Vec<f64>>,
    /// Standard deviation of the measurement of one value, in the channel's unit.
    pub uncertainty: Option<f64>,
    /// Values of the history that together tell as much as one whose error is independent: one and twice the sum of the
    /// autocorrelations of the measurement's error. One, where not given.
    pub correlated_over: Option<f64>,
    /// Whether its history is a list of single readings: each is compared, in units of its uncertainty, and counts as much as a channel's peak,
    /// whatever is said of other channels. Without an uncertainty, that unit is a hundredth of the largest reading.
    pub readings: bool,
    /// Weight where weights are given and not found from shapes.
    pub weight: Option<f64>,
    /// Why the channel takes no part in the norm; it is still reported.
    pub left_out: Option<String>,
}

impl Channel {
    /// A channel of which the peak alone is known.
    pub fn peak(name: &str, unit: &str, peak: f64) -> Self {
        Self { name: name.to_owned(), unit: unit.to_owned(), peak: Some(peak), ..Self::default() }
    }

    /// A channel with its history, in `unit`.
    pub fn history(name: &str, unit: &str, history: Vec<f64>) -> Self {
        Self { name: name.to_owned(), unit: unit.to_owned(), history: Some(history), ..Self::default() }
    }

    /// A channel of single readings, in `unit`.
    pub fn readings(name: &str, unit: &str, readings: Vec<f64>) -> Self {
        Self { readings: true, ..Self::history(name, unit, readings) }
    }

    /// The signed measured peak: as given, else the value of largest magnitude.
    pub fn measured_peak(&self) -> Option<f64> {
        self.peak.or_else(|| self.history.as_deref().and_then(largest))
    }

    /// The factor on a response that suits the history best; one where there is nothing to compare.
    pub fn gain_over(&self, response: &[f64]) -> f64 {
        let [along, square] = self.products(response);
        if square > 0.0 { along / square } else { 1.0 }
    }

    /// Products of a response with the history and with itself; zero where there is no history of its length.
    pub fn products(&self, response: &[f64]) -> [f64; 2] {
        let history = self.history.as_deref().filter(|history| history.len() == response.len()).unwrap_or(&[]);
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        [dot(response, history), if history.is_empty() { 0.0 } else { dot(response, response) }]
    }

    /// The channel with noise that is no smaller than what a response times `gain` leaves of its history, slow deviations counting with the
    /// values over which they last. A channel without a stated uncertainty gets that of what is left.
    pub fn with_noise_of(&self, response: &[f64], gain: f64) -> Self {
        let Some(history) = self.history.as_deref().filter(|history| history.len() == response.len()) else {
            return self.clone();
        };
        let left: Vec<f64> = history.iter().zip(response).map(|(v, u)| v - gain * u).collect();
        let square = left.iter().map(|left| left * left).sum::<f64>();
        // Readings are taken one by one: their order is no time.
        let over = if self.readings { 1.0 } else { correlated_over(&left) };
        let deviation = (square / left.len().max(1) as f64).sqrt();
        let stated = self.uncertainty.map(|noise| noise * noise * self.correlated_over.unwrap_or(1.0).max(1.0));
        if stated.is_some_and(|stated| stated >= deviation * deviation * over) || !(deviation > 0.0) {
            return self.clone();
        }
        Self { uncertainty: Some(deviation), correlated_over: Some(over), ..self.clone() }
    }

    /// Whether it counts in the norm.
    pub fn counts(&self) -> bool {
        self.left_out.is_none()
    }
}

/// The value of largest magnitude, with its sign; the first where several are equal.
pub fn largest(values: &[f64]) -> Option<f64> {
    values.iter().copied().reduce(|best, value| if value.abs() > best.abs() { value } else { best })
}

/// Shape correlation factor of two histories of one length (railway paper, eq. 4), -1 to 1; none where either is zero throughout.
pub fn shape_correlation(computed: &[f64], measured: &[f64]) -> Option<f64> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    // The norms are rooted one by one, as printed: their product may not be representable.
    let factor = dot(computed, measured) / (dot(computed, computed).sqrt() * dot(measured, measured).sqrt());
    factor.is_finite().then_some(factor)
}

/// How many values of an error tell as much as one that is independent, from the error itself: one and twice the sum of its
/// autocorrelations, broken off where they fade into noise (Geyer 1992, Statistical Science 7(4), 473-483). Between 1 and the
/// count of values; 1 where the error does not vary.
pub fn correlated_over(error: &[f64]) -> f64 {
    let count = error.len() as f64;
    let independent = effective_samples(&[error.to_vec()]);
    if independent.is_finite() { (count / independent).clamp(1.0, count.max(1.0)) } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_are_compared_without_their_size() {
        let wave: Vec<f64> = (0..100).map(|k| (0.1 * f64::from(k)).sin()).collect();
        let twice: Vec<f64> = wave.iter().map(|v| -2.0 * v).collect();
        assert!((shape_correlation(&wave, &wave).unwrap() - 1.0).abs() < 1e-14, "rounding of a sum of 100");
        assert!((shape_correlation(&twice, &wave).unwrap() + 1.0).abs() < 1e-14);
        assert_eq!(shape_correlation(&[1.0, 0.0], &[0.0, 1.0]), Some(0.0));
        assert_eq!(shape_correlation(&[0.0, 0.0], &[0.0, 1.0]), None);
    }

    #[test]
    fn what_a_model_leaves_counts_as_noise_where_it_is_larger() {
        let wave = |k: usize| (0.1 * k as f64).sin();
        let history: Vec<f64> = (0..400).map(|k| wave(k) + 0.1 * wave(7 * k)).collect();
        let response: Vec<f64> = (0..400).map(|k| 0.8 * wave(k)).collect();
        let channel = Channel { uncertainty: Some(0.01), ..Channel::history("crown", "mm", history) };
        let gain = channel.gain_over(&response);
        let wider = channel.with_noise_of(&response, gain);
        // A sine of 0.1 has a deviation of 0.071; the gain takes the rest.
        assert!((wider.uncertainty.unwrap() - 0.0707).abs() < 0.001, "{wider:?}");
        assert!(channel.with_noise_of(&response, 1.0).uncertainty.unwrap() > 0.1);
        let noisy = Channel { uncertainty: Some(1.0), ..channel };
        assert_eq!(noisy.with_noise_of(&response, gain), noisy);
    }

    #[test]
    fn the_peak_keeps_its_sign() {
        assert_eq!(largest(&[0.1, -0.3, 0.2]), Some(-0.3));
        assert_eq!(largest(&[]), None);
    }
}
