//! What was measured: channels with a peak, a history, or both.

/// One measured channel [in its own unit].
#[derive(Debug, Clone, PartialEq, Default)]
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

    /// A channel with its history.
    pub fn history(name: &str, unit: &str, history: Vec<f64>) -> Self {
        Self { name: name.to_owned(), unit: unit.to_owned(), history: Some(history), ..Self::default() }
    }

    /// The signed measured peak: as given, else the value of largest magnitude.
    pub fn measured_peak(&self) -> Option<f64> {
        self.peak.or_else(|| self.history.as_deref().and_then(largest))
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

/// Shape correlation factor of two histories (railway paper, eq. 4), -1 to 1; none where either is zero throughout.
pub fn shape_correlation(computed: &[f64], measured: &[f64]) -> Option<f64> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    // The norms are rooted one by one, as printed: their product may not be representable.
    let factor = dot(computed, measured) / (dot(computed, computed).sqrt() * dot(measured, measured).sqrt());
    factor.is_finite().then_some(factor)
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
    fn the_peak_keeps_its_sign() {
        assert_eq!(largest(&[0.1, -0.3, 0.2]), Some(-0.3));
        assert_eq!(largest(&[]), None);
    }
}
