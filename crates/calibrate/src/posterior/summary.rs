//! What samples say of one quantity: mean, spread, interval.

use crate::parameter::Parameter;
use serde::{Deserialize, Serialize};

/// A quantity in numbers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub standard_deviation: f64,
    /// Interval that holds 95 % of the samples: the shortest of those that leave out 2.5 % on either side or, between bounds, 5 % on one side up to the
    /// bound of the other.
    pub interval_95: [f64; 2],
}

/// Sums samples up. `range` holds the bounds between which they lie, where there are any.
pub fn summary(samples: &[f64], range: Option<[f64; 2]>) -> Summary {
    let n = samples.len() as f64;
    let mean = samples.iter().sum::<f64>() / n;
    let variance = samples.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0).max(1.0);
    let mut sorted = samples.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let within = [quantile(&sorted, 0.025), quantile(&sorted, 0.975)];
    let at_bounds = range.map(|[low, high]| [[low, quantile(&sorted, 0.95)], [quantile(&sorted, 0.05), high]]);
    let length = |interval: &[f64; 2]| interval[1] - interval[0];
    let shortest = |a: [f64; 2], b: [f64; 2]| if length(&b) < length(&a) { b } else { a };
    let interval_95 = at_bounds.into_iter().flatten().fold(within, shortest);
    Summary { mean, standard_deviation: variance.sqrt(), interval_95 }
}

/// Whether an interval tells a parameter: it is narrower, in the parameter's scale, than half of what an even prior's over the whole range would
/// be, and it ends on no bound of the range: where it does, the range limits it there and not the data.
pub fn tells(parameter: &Parameter, interval_95: [f64; 2]) -> bool {
    let [low, high] = interval_95.map(|value| parameter.share(value));
    // Over an even range an interval of 95 % is 0.95 wide.
    high - low < 0.5 * 0.95 && !ends_on_bound(parameter, interval_95)
}

/// Whether an interval ends on a bound of the range.
pub fn ends_on_bound(parameter: &Parameter, interval_95: [f64; 2]) -> bool {
    interval_95.iter().any(|end| parameter.at_bound(*end))
}

/// Quantile of values in ascending order, between them by a straight line; not a number where there are none.
pub fn quantile(sorted: &[f64], share: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else {
        return f64::NAN;
    };
    let place = share.clamp(0.0, 1.0) * last as f64;
    let low = place.floor() as usize;
    let high = (low + 1).min(last);
    sorted[low] + (place - low as f64) * (sorted[high] - sorted[low])
}

/// Correlation of two sets of samples; zero where either does not vary.
pub fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let n = a.len() as f64;
    let (ma, mb) = (a.iter().sum::<f64>() / n, b.iter().sum::<f64>() / n);
    let sum = |f: &dyn Fn(f64, f64) -> f64| a.iter().zip(b).map(|(x, y)| f(x - ma, y - mb)).sum::<f64>();
    let product = (sum(&|x, _| x * x) * sum(&|_, y| y * y)).sqrt();
    if product > 0.0 { sum(&|x, y| x * y) / product } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_interval_reaches_a_bound_that_the_samples_rise_to() {
        // Quantiles of a density that rises in a straight line from nothing at 0: the square roots of even shares. Between two of them lie 2.2e-3.
        let rising: Vec<f64> = (0..1000).map(|k| ((k as f64 + 0.5) / 1000.0).sqrt()).collect();
        let [low, high] = summary(&rising, Some([0.0, 1.0])).interval_95;
        assert!((low - 0.05_f64.sqrt()).abs() < 2.2e-3 && high == 1.0, "{low} to {high}");
        let falling: Vec<f64> = rising.iter().map(|x| 1.0 - x).collect();
        let [low, high] = summary(&falling, Some([0.0, 1.0])).interval_95;
        assert!(low == 0.0 && (high - (1.0 - 0.05_f64.sqrt())).abs() < 2.2e-3, "{low} to {high}");
    }

    #[test]
    fn an_interval_inside_the_bounds_leaves_out_as_much_on_either_side() {
        // Even and narrow, in the middle of the range.
        let even: Vec<f64> = (0..1000).map(|k| 0.4 + 0.2 * (k as f64 + 0.5) / 1000.0).collect();
        for range in [Some([0.0, 1.0]), None] {
            let [low, high] = summary(&even, range).interval_95;
            assert!((low - 0.405).abs() < 1e-3 && (high - 0.595).abs() < 1e-3, "{low} to {high}");
        }
    }
}
