//! What samples say of one quantity: mean, spread, interval.

/// A quantity in numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Summary {
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub standard_deviation: f64,
    /// Interval that holds 95 % of the samples: 2.5 % are left out on either side, or 5 % on one where the samples crowd
    /// at the bound of the other.
    pub interval_95: [f64; 2],
}

/// Share of the range next to a bound that is looked at for a crowd.
const EDGE: f64 = 0.02;
/// Share of the samples that makes a crowd there; even samples would be 2 %.
const CROWD: f64 = 0.05;

/// Sums samples up. `range` holds the bounds between which they lie, where there are any.
pub fn summary(samples: &[f64], range: Option<[f64; 2]>) -> Summary {
    let n = samples.len() as f64;
    let mean = samples.iter().sum::<f64>() / n;
    let variance = samples.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0).max(1.0);
    let mut sorted = samples.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let crowded = |range: [f64; 2]| {
        let edge = EDGE * (range[1] - range[0]);
        let at = |near: &dyn Fn(f64) -> bool| samples.iter().filter(|x| near(**x)).count() as f64 > CROWD * n;
        (at(&|x| x < range[0] + edge), at(&|x| x > range[1] - edge))
    };
    let interval_95 = match range.map(|range| (range, crowded(range))) {
        Some((range, (true, false))) => [range[0], quantile(&sorted, 0.95)],
        Some((range, (false, true))) => [quantile(&sorted, 0.05), range[1]],
        _ => [quantile(&sorted, 0.025), quantile(&sorted, 0.975)],
    };
    Summary { mean, standard_deviation: variance.sqrt(), interval_95 }
}

/// Quantile of sorted values, between them by a straight line.
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
