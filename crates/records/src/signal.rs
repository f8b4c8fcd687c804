//! Robust measures of histories, shared by what judges and what prepares them.

use crate::Recording;

/// The middle value; 0 of none. NaN must not be among them.
pub(crate) fn median(values: &mut [f64]) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = values.len() / 2;
    let (below, upper, _) = values.select_nth_unstable_by(middle, f64::total_cmp);
    let upper = *upper;
    match below.iter().copied().reduce(f64::max) {
        Some(lower) if values.len().is_multiple_of(2) => 0.5 * (lower + upper),
        _ => upper,
    }
}

/// The value below which a share of them lies; 0 of none.
pub(crate) fn quantile(values: &mut [f64], share: f64) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let at = ((values.len() - 1) as f64 * share).round() as usize;
    *values.select_nth_unstable_by(at, f64::total_cmp).1
}

/// Missing samples bridged by straight lines over the samples' numbers, ends held. None where every sample is missing.
pub(crate) fn bridged(values: &[f64]) -> Option<Vec<f64>> {
    let mut bridged = values.to_vec();
    let finite: Vec<usize> = (0..values.len()).filter(|k| values[*k].is_finite()).collect();
    let (first, last) = (*finite.first()?, *finite.last()?);
    bridged[..first].fill(values[first]);
    bridged[last + 1..].fill(values[last]);
    if finite.len() < last + 1 - first {
        for pair in finite.windows(2) {
            for k in pair[0] + 1..pair[1] {
                let share = (k - pair[0]) as f64 / (pair[1] - pair[0]) as f64;
                bridged[k] = values[pair[0]] + share * (values[pair[1]] - values[pair[0]]);
            }
        }
    }
    Some(bridged)
}

/// The median of each sample and its three neighbours on either side, at the ends of the seven outermost: what is shorter than
/// four samples is gone.
pub(crate) fn smoothed(values: &[f64]) -> Vec<f64> {
    let n = values.len();
    let width = 7.min(n);
    (0..n)
        .map(|k| {
            let from = k.saturating_sub(3).min(n - width);
            let mut near = [0.0; 7];
            let near = &mut near[..width];
            near.copy_from_slice(&values[from..from + width]);
            near.sort_unstable_by(f64::total_cmp);
            near[width / 2]
        })
        .collect()
}

/// Greatest less least value.
pub(crate) fn range(values: &[f64]) -> f64 {
    let [low, high] = values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| [l.min(*v), h.max(*v)]);
    if low <= high { high - low } else { 0.0 }
}

/// Smallest step between neighbouring values that differ: the least count of a record that was rounded to one. 0 of a constant.
pub(crate) fn least_count(values: &[f64]) -> f64 {
    let steps = values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).filter(|step| *step > 0.0);
    steps.reduce(f64::min).unwrap_or(0.0)
}

/// Standard deviation of noise, from the median size of second differences, which a smooth history hardly has.
pub(crate) fn noise(values: &[f64]) -> f64 {
    let mut sizes: Vec<f64> = values.windows(3).map(|three| (three[0] - 2.0 * three[1] + three[2]).abs()).collect();
    // The median size of a normal variable is 0.6745 of its deviation; a second difference has the variance of six samples.
    median(&mut sizes) / (0.6745 * 6.0_f64.sqrt())
}

/// Straight line by least squares: value at the middle, slope, and the slope's standard error.
pub(crate) fn line(times: &[f64], values: &[f64]) -> [f64; 3] {
    let n = times.len().min(values.len()) as f64;
    if n < 3.0 {
        return [values.first().copied().unwrap_or(0.0), 0.0, 0.0];
    }
    let mean = |list: &[f64]| list.iter().sum::<f64>() / n;
    let (t0, v0) = (mean(times), mean(values));
    let tt: f64 = times.iter().map(|t| (t - t0).powi(2)).sum();
    let tv: f64 = times.iter().zip(values).map(|(t, v)| (t - t0) * (v - v0)).sum();
    if tt <= 0.0 {
        return [v0, 0.0, 0.0];
    }
    let slope = tv / tt;
    let rest: f64 = times.iter().zip(values).map(|(t, v)| (v - v0 - slope * (t - t0)).powi(2)).sum();
    [v0, slope, (rest / (n - 2.0) / tt).sqrt()]
}

/// The channels of a run without what is shorter than four samples; None where nothing was measured.
pub(crate) type Smooth = [Option<Vec<f64>>];

/// Where in a run the train is on the bridge, in samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Loaded {
    /// Samples of the quiet start; 0 where there is none.
    pub quiet: usize,
    /// First and last sample at which channels answer.
    pub on: [usize; 2],
    /// First sample of the quiet end; the number of samples where there is none.
    pub after: usize,
}

/// A channel answers from where it leaves its first level by this share of its range to where it comes as near to its last.
const ANSWERS: f64 = 0.2;
/// A quiet stretch has at least so many samples: the level of fewer is not known to a third of their scatter.
const QUIET: usize = 10;

/// Where the train is on the bridge, by the middle one of the channels, so that a bad channel does not say it. The quiet start
/// is the first half of what comes before, for an axle is felt before it stands on the span; the quiet end is the last half.
pub(crate) fn loaded(run: &Recording, smooth: &Smooth) -> Loaded {
    let n = run.times.len();
    let (mut arrivals, mut departures) = (Vec::new(), Vec::new());
    for (channel, values) in run.channels.iter().zip(smooth) {
        let Some(values) = values.as_ref().filter(|_| channel.used()) else { continue };
        let start = (n / 20).clamp(1.min(n), 200);
        let [first, last] = [&values[..start], &values[n - start..]].map(|part| median(&mut part.to_vec()));
        let threshold = ANSWERS * range(values);
        if threshold <= 0.0 {
            continue;
        }
        let leaves = |level: f64| move |value: &f64| (value - level).abs() > threshold;
        arrivals.extend(values.iter().position(leaves(first)));
        departures.extend(values.iter().rposition(leaves(last)));
    }
    arrivals.sort_unstable();
    departures.sort_unstable();
    let middle = |list: &[usize]| list.get(list.len() / 2).copied();
    let on = match (middle(&arrivals), middle(&departures)) {
        (Some(first), Some(last)) if first <= last => [first, last],
        _ => [0, n.saturating_sub(1)],
    };
    let start = on[0] / 2;
    let end = n - n.saturating_sub(1 + on[1]) / 2;
    let [mut starts, mut ends] = [(0, start), (end, n)].map(|(a, b)| b >= a + QUIET && silent(run, smooth, a, b));
    if starts && ends && apart(run, smooth, start, end) {
        // Not every channel drifts at once: one of the two stands under the train, and the shorter one is it.
        (starts, ends) = (start > n - end, start <= n - end);
    }
    Loaded { quiet: if starts { start } else { 0 }, on, after: if ends { end } else { n } }
}

/// Whether at least half of the channels have other levels at the start than at the end.
fn apart(run: &Recording, smooth: &Smooth, start: usize, end: usize) -> bool {
    let [apart, all] = counted(run, smooth, |values| {
        let levels = [median(&mut values[..start].to_vec()), median(&mut values[end..].to_vec())];
        (levels[1] - levels[0]).abs() > ANSWERS * range(values)
    });
    all > 1 && 2 * apart >= all
}

/// Whether at least half of the channels hardly move over some samples: by noise, by rounding, or by three hundredths of their
/// range. A record that begins under the train has a first level too, but moves.
fn silent(run: &Recording, smooth: &Smooth, from: usize, to: usize) -> bool {
    let [still, all] = counted(run, smooth, |values| {
        let allowed = (0.03 * range(values)).max(3.0 * least_count(values)).max(8.0 * noise(values));
        range(&values[from..to]) <= allowed
    });
    all > 0 && 2 * still >= all
}

/// Of how many used channels something holds, and how many there are.
fn counted(run: &Recording, smooth: &Smooth, holds: impl Fn(&[f64]) -> bool) -> [usize; 2] {
    let used = run.channels.iter().zip(smooth).filter(|(channel, _)| channel.used());
    used.filter_map(|(_, values)| values.as_ref())
        .fold([0, 0], |[of, all], values| [of + usize::from(holds(values)), all + 1])
}

impl Loaded {
    /// Level of a channel while nothing loads the span: at the quiet start, else at the quiet end, else zero as recorded.
    pub(crate) fn level(&self, values: &[f64]) -> f64 {
        let quiet = if self.quiet > 0 { &values[..self.quiet] } else { &values[self.after.min(values.len())..] };
        median(&mut quiet.to_vec())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measures_of_short_histories() {
        assert_eq!(median(&mut [3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(&mut [4.0, 1.0, 2.0, 3.0]), 2.5);
        assert_eq!(median(&mut []), 0.0);
        assert_eq!(quantile(&mut [0.0, 1.0, 2.0, 3.0, 4.0], 0.95), 4.0);
        assert_eq!(bridged(&[f64::NAN, 1.0, f64::NAN, 3.0, f64::NAN]), Some(vec![1.0, 1.0, 2.0, 3.0, 3.0]));
        assert_eq!(bridged(&[f64::NAN]), None);
        assert_eq!(smoothed(&[0.0, 0.0, 0.0, 9.0, 9.0, 9.0, 0.0, 0.0, 0.0])[3..6], [0.0, 0.0, 0.0]);
        assert_eq!(least_count(&[0.0, 0.5, 0.5, 0.75]), 0.25);
        let [middle, slope, error] = line(&[0.0, 1.0, 2.0, 3.0], &[1.0, 3.0, 5.0, 7.0]);
        assert!((middle - 4.0).abs() < 1e-12 && (slope - 2.0).abs() < 1e-12 && error < 1e-12);
    }

    #[test]
    fn noise_is_seen_beside_a_smooth_history() {
        // A triangle of noise with deviation 1 (uniform over ±√3) upon a slow wave a hundred times as large.
        let wave = |k: usize| 100.0 * (k as f64 * 1e-3).sin();
        let mut seed = 1_u64;
        let mut uniform = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5) * 12.0_f64.sqrt()
        };
        let values: Vec<f64> = (0..20_000).map(|k| wave(k) + uniform()).collect();
        // Uniform noise has another median than normal noise; a tenth is enough to see a dead sensor.
        assert!((noise(&values) - 1.0).abs() < 0.1, "{}", noise(&values));
    }
}
