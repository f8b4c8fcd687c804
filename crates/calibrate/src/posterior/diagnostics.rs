//! Whether chains have told enough: rank-normalised effective sample size (Vehtari, Gelman, Simpson, Carpenter and Bürkner
//! 2021, Bayesian Analysis 16(2), 667-718) and nested R-hat (Margossian, Hoffman, Sountsov, Riou-Durand, Vehtari and Gelman
//! 2024, Bayesian Analysis), which compares runs of many short chains as wholes.

use serde::{Deserialize, Serialize};

/// R-hat and effective sample size of one quantity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Mixing {
    /// Larger of the nested R-hats of place and of spread, over the first and second halves of all runs; 1 where all tell
    /// the same.
    pub r_hat: f64,
    /// Effective count of independent samples for means.
    pub effective_samples: f64,
}

/// Judges one quantity by its values in runs of chains (by run and chain), all chains of one length; not a number where they are shorter than four.
pub fn mixing(runs: &[Vec<Vec<f64>>]) -> Mixing {
    let length = runs.iter().flatten().map(Vec::len).min().unwrap_or(0);
    let half = length / 2;
    if half < 2 {
        return Mixing { r_hat: f64::NAN, effective_samples: f64::NAN };
    }
    // Half chains, run by run: all first halves, then all second ones.
    let sides = [0..half, length - half..length];
    let halves: Vec<&[f64]> = runs
        .iter()
        .flat_map(|run| sides.iter().flat_map(|side| run.iter().map(|chain| &chain[side.clone()])))
        .collect();
    let sizes: Vec<usize> = runs.iter().flat_map(|run| [run.len(), run.len()]).collect();
    let groups = |ranked: &[Vec<f64>]| -> Vec<Vec<f64>> {
        let mut rest = ranked.iter();
        sizes.iter().map(|size| rest.by_ref().take(*size).flatten().copied().collect()).collect()
    };
    let ranked = by_ranks(&halves);
    let mut all: Vec<f64> = halves.concat();
    let middle = all.len() / 2;
    let median = *all.select_nth_unstable_by(middle, f64::total_cmp).1;
    let folded: Vec<Vec<f64>> =
        halves.iter().map(|half| half.iter().map(|value| (value - median).abs()).collect()).collect();
    let folded = by_ranks(&folded.iter().map(Vec::as_slice).collect::<Vec<_>>());
    let r_hat = r_hat(&groups(&ranked)).max(r_hat(&groups(&folded)));
    Mixing { r_hat, effective_samples: effective_samples(&ranked) }
}

/// Every value replaced by the normal quantile of its rank among all; equal values share their mean rank.
fn by_ranks(chains: &[&[f64]]) -> Vec<Vec<f64>> {
    let all: Vec<f64> = chains.concat();
    let mut order: Vec<usize> = (0..all.len()).collect();
    // Equal values share their rank, so that their order does not matter.
    order.sort_unstable_by(|a, b| all[*a].total_cmp(&all[*b]));
    let mut scores = vec![0.0; all.len()];
    let mut first = 0;
    while first < order.len() {
        let mut last = first;
        while last + 1 < order.len() && all[order[last + 1]] == all[order[first]] {
            last += 1;
        }
        let rank = 0.5 * (first + last) as f64 + 1.0;
        for place in &order[first..=last] {
            scores[*place] = normal_quantile((rank - 0.375) / (all.len() as f64 + 0.25));
        }
        first = last + 1;
    }
    let mut rest = scores.into_iter();
    chains.iter().map(|chain| rest.by_ref().take(chain.len()).collect()).collect()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn variance(values: &[f64]) -> f64 {
    let mean = mean(values);
    values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (values.len() as f64 - 1.0)
}

/// Nested R-hat: the variance between groups beside that within them.
fn r_hat(groups: &[Vec<f64>]) -> f64 {
    let within = mean(&groups.iter().map(|group| variance(group)).collect::<Vec<_>>());
    let between = variance(&groups.iter().map(|group| mean(group)).collect::<Vec<_>>());
    if within > 0.0 { (1.0 + between / within).sqrt() } else { f64::NAN }
}

/// By the sum of the autocorrelations, broken off after Geyer's monotone positive pairs; not a number for fewer than two values.
pub(crate) fn effective_samples(chains: &[Vec<f64>]) -> f64 {
    let (m, n) = (chains.len(), chains[0].len());
    let within = mean(&chains.iter().map(|chain| variance(chain)).collect::<Vec<_>>());
    let between = if m > 1 { variance(&chains.iter().map(|c| mean(c)).collect::<Vec<_>>()) } else { 0.0 };
    let whole = within * (n as f64 - 1.0) / n as f64 + between;
    if n < 2 || !(whole > 0.0) {
        return f64::NAN;
    }
    let centred: Vec<Vec<f64>> = chains
        .iter()
        .map(|chain| {
            let mean = mean(chain);
            chain.iter().map(|v| v - mean).collect()
        })
        .collect();
    let correlation = |lag: usize| {
        let product = |chain: &Vec<f64>| chain[lag..].iter().zip(chain).map(|(a, b)| a * b).sum::<f64>() / n as f64;
        let autocovariance = centred.iter().map(product).sum::<f64>() / m as f64;
        1.0 - (within - autocovariance * n as f64 / (n as f64 - 1.0)) / whole
    };
    let (mut sum, mut last) = (0.0, f64::INFINITY);
    for lag in (0..n.saturating_sub(1)).step_by(2) {
        let pair = if lag == 0 { 1.0 + correlation(1) } else { correlation(lag) + correlation(lag + 1) };
        if !(pair > 0.0) {
            break;
        }
        last = pair.min(last);
        sum += last;
    }
    let count = (m * n) as f64;
    // Better than independent by a factor of log10 of the count is taken for chance.
    count / (2.0 * sum - 1.0).max(1.0 / count.log10().max(1.0))
}

/// Normal quantile of a probability (Acklam's rational approximation, relative error 1.2e-9).
pub fn normal_quantile(probability: f64) -> f64 {
    const A: [f64; 6] = [
        -3.969_683_028_665_376e1,
        2.209_460_984_245_205e2,
        -2.759_285_104_469_687e2,
        1.383_577_518_672_69e2,
        -3.066_479_806_614_716e1,
        2.506_628_277_459_239,
    ];
    const B: [f64; 5] = [
        -5.447_609_879_822_406e1,
        1.615_858_368_580_409e2,
        -1.556_989_798_598_866e2,
        6.680_131_188_771_972e1,
        -1.328_068_155_288_572e1,
    ];
    const C: [f64; 6] = [
        -7.784_894_002_430_293e-3,
        -3.223_964_580_411_365e-1,
        -2.400_758_277_161_838,
        -2.549_732_539_343_734,
        4.374_664_141_464_968,
        2.938_163_982_698_783,
    ];
    const D: [f64; 4] =
        [7.784_695_709_041_462e-3, 3.224_671_290_700_398e-1, 2.445_134_137_142_996, 3.754_408_661_907_416];
    let tail = |q: f64| {
        (((((C[0] * q + C[1]) * q + C[2]) * q + C[3]) * q + C[4]) * q + C[5])
            / ((((D[0] * q + D[1]) * q + D[2]) * q + D[3]) * q + 1.0)
    };
    if probability < 0.02425 {
        return tail((-2.0 * probability.ln()).sqrt());
    }
    if probability > 1.0 - 0.02425 {
        return -tail((-2.0 * (1.0 - probability).ln()).sqrt());
    }
    let q = probability - 0.5;
    let r = q * q;
    (((((A[0] * r + A[1]) * r + A[2]) * r + A[3]) * r + A[4]) * r + A[5]) * q
        / (((((B[0] * r + B[1]) * r + B[2]) * r + B[3]) * r + B[4]) * r + 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::posterior::draw::normal;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;

    fn chains(correlation: f64, shift: f64) -> Vec<Vec<f64>> {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let mut chain = |k: usize| {
            let mut x = normal(&mut rng);
            let mut step = || {
                x = correlation * x + (1.0 - correlation * correlation).sqrt() * normal(&mut rng);
                x + shift * k as f64
            };
            (0..2000).map(|_| step()).collect()
        };
        (0..4).map(&mut chain).collect()
    }

    #[test]
    fn effective_samples_of_a_chain_of_known_correlation() {
        // An autoregressive chain of correlation r has n (1 - r) / (1 + r) effective samples; 15 % is three standard
        // deviations of the estimate at this length.
        for r in [0.0, 0.5, 0.9] {
            let mixing = mixing(&chains(r, 0.0).chunks(2).map(<[Vec<f64>]>::to_vec).collect::<Vec<_>>());
            let expected = 8000.0 * (1.0 - r) / (1.0 + r);
            assert!((mixing.effective_samples / expected - 1.0).abs() < 0.15, "{r}: {mixing:?} for {expected}");
            assert!(mixing.r_hat < 1.02, "{mixing:?}");
        }
    }

    #[test]
    fn chains_in_different_places_are_found() {
        let apart: Vec<Vec<Vec<f64>>> = chains(0.5, 1.0).into_iter().map(|chain| vec![chain]).collect();
        assert!(mixing(&apart).r_hat > 1.2);
    }

    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (p, z) in [(0.975, 1.959_963_984_540_054), (0.5, 0.0), (0.001, -3.090_232_306_167_813_5)] {
            assert!((normal_quantile(p) - z).abs() < 1e-8);
        }
    }
}
