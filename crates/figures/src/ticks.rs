//! Round numbers along an axis.

/// Ticks of an axis and how many decimals they need.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Ticks {
    /// Values, from the first at or below the range to the last at or above it.
    pub values: Vec<f64>,
    pub decimals: usize,
}

impl Ticks {
    /// About `count` steps of 1, 2 or 5 times a power of ten that cover `low` to `high`.
    pub(crate) fn over(low: f64, high: f64, count: usize) -> Ticks {
        let (low, high) = if low.is_finite() && high.is_finite() { (low.min(high), low.max(high)) } else { (0.0, 1.0) };
        let span = high - low;
        // A range without width gets one around its value.
        let size = low.abs().max(high.abs());
        let span = if span > 1e-12 * size.max(1e-300) { span } else { size.max(1.0) };
        let raw = span / count.max(1) as f64;
        let power = 10f64.powf(raw.log10().floor());
        let lead = raw / power;
        let step = power * [1.0, 2.0, 5.0].into_iter().find(|step| lead <= step + 1e-9).unwrap_or(10.0);
        let (first, last) = ((low / step + 1e-9).floor() as i64, (high / step - 1e-9).ceil() as i64);
        let last = last.max(first + 1);
        let decimals = (-(step * (1.0 + 1e-9)).log10().floor()).clamp(0.0, 12.0) as usize;
        Ticks { values: (first..=last).map(|k| k as f64 * step).collect(), decimals }
    }
    /// The same ticks, those outside a range left out.
    pub(crate) fn inside(&self, low: f64, high: f64) -> Ticks {
        let slack = 1e-9 * (high - low).abs();
        let values = self.values.iter().copied().filter(|&v| v >= low - slack && v <= high + slack).collect();
        Ticks { values, decimals: self.decimals }
    }
    /// First and last value.
    pub(crate) fn range(&self) -> [f64; 2] {
        [self.values[0], self.values[self.values.len() - 1]]
    }
    /// A value as it stands at the axis.
    pub(crate) fn words(&self, value: f64) -> String {
        let text = format!("{value:.*}", self.decimals);
        let zero = text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.');
        if zero { text.trim_start_matches('-').into() } else { text.replace('-', "−") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_cover_the_range() {
        let t = Ticks::over(0.0, 216.87, 5);
        assert_eq!(t.values, [0.0, 50.0, 100.0, 150.0, 200.0, 250.0]);
        assert_eq!(t.words(50.0), "50");
        let t = Ticks::over(-0.31, 0.12, 5);
        assert_eq!(t.range()[0], -0.4);
        assert_eq!(t.words(t.values[0]), "−0.4");
        assert_eq!(t.words(-0.0), "0.0");
    }

    #[test]
    fn ranges_without_width_and_without_sense_still_have_an_axis() {
        for (low, high) in [(0.0, 0.0), (5.0, 5.0), (f64::NAN, 1.0), (1e-9, 1e-9), (-3.0, -3.0), (1e300, 1e300)] {
            let t = Ticks::over(low, high, 5);
            assert!(t.values.len() >= 2 && t.values.len() < 30, "{low} {high} {t:?}");
            assert!(t.values.windows(2).all(|w| w[1] > w[0]), "{t:?}");
        }
    }
}
