//! From the prior to the posterior by degrees (transitional Monte Carlo; Ching and Chen 2007, Del Moral et al. 2006): the
//! likelihood is raised to powers from 0 to 1; particles are weighted, resampled and moved. The mean weights multiply to the
//! evidence, and separate modes keep their shares of the particles.

use rand_chacha::ChaCha8Rng;

use crate::posterior::draw::{even, normal, place};
use crate::posterior::target::{Draw, Target};
use crate::watch::Stopped;

/// Most powers; with the half of the particles kept at each, 200 would do for a likelihood of e^-130 in the prior's mean.
const STAGES: usize = 200;

/// Brings `count` particles from the prior to the posterior, each moved `moves` times at each power. Gives them, all of the same weight, and
/// the logarithm of the evidence; minus infinity where no particle had a likelihood.
pub(super) fn temper(
    target: &mut Target,
    rng: &mut ChaCha8Rng,
    count: usize,
    moves: usize,
) -> Result<(Vec<Draw>, f64), Stopped> {
    let first = target.prior_places(rng, count);
    let mut particles = target.draws(first)?;
    let (mut power, mut log_evidence, mut stages, mut stride) = (0.0, 0.0, 0, 1.0);
    while power < 1.0 && stages < STAGES {
        target.evaluator.stage = format!("from prior to posterior, power {power:.3}");
        let step = next_step(&particles, power);
        let Some((weights, log_mean)) = weights(&particles, step) else {
            return Ok((particles, f64::NEG_INFINITY));
        };
        log_evidence += log_mean;
        power = if power + step >= 1.0 { 1.0 } else { power + step };
        let spread = covariance_root(&particles, &weights);
        particles = resample(&particles, &weights, even(rng));
        for _ in 0..moves {
            stride = walk(target, rng, &mut particles, &spread, power, stride)?;
        }
        stages += 1;
    }
    Ok((particles, log_evidence))
}

/// Largest rise of the power at which half of the particles still count.
fn next_step(particles: &[Draw], power: f64) -> f64 {
    let rest = 1.0 - power;
    let enough = |step: f64| {
        let share = |(weights, _): (Vec<f64>, f64)| 1.0 / weights.iter().map(|w| w * w).sum::<f64>();
        weights(particles, step).map(share).is_some_and(|effective| effective >= 0.5 * particles.len() as f64)
    };
    if enough(rest) {
        return rest;
    }
    let (mut low, mut high) = (0.0, rest);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if enough(middle) { low = middle } else { high = middle }
    }
    // Where many particles fail, no step leaves half of them: a small one still goes on.
    low.max(1e-6 * rest)
}

/// Weights of a rise of the power, in all one, and the logarithm of their mean before that.
fn weights(particles: &[Draw], step: f64) -> Option<(Vec<f64>, f64)> {
    let logs: Vec<f64> = particles.iter().map(|draw| step * draw.likelihood).collect();
    let top = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if !top.is_finite() {
        return None;
    }
    let raw: Vec<f64> = logs.iter().map(|log| (log - top).exp()).collect();
    let sum: f64 = raw.iter().sum();
    Some((raw.iter().map(|w| w / sum).collect(), top + (sum / raw.len() as f64).ln()))
}

/// Systematic resampling by one even number.
fn resample(particles: &[Draw], weights: &[f64], start: f64) -> Vec<Draw> {
    let count = particles.len();
    let (mut sum, mut k) = (weights[0], 0);
    let mut chosen = Vec::with_capacity(count);
    for tick in 0..count {
        let mark = (tick as f64 + start) / count as f64;
        while sum < mark && k + 1 < count {
            k += 1;
            sum += weights[k];
        }
        chosen.push(particles[k].clone());
    }
    chosen
}

/// One step of a random walk for every particle; gives the stride for the next, which holds a quarter accepted.
fn walk(
    target: &mut Target,
    rng: &mut ChaCha8Rng,
    particles: &mut [Draw],
    spread: &[Vec<f64>],
    power: f64,
    stride: f64,
) -> Result<f64, Stopped> {
    let axes = target.axes();
    let scale = stride * 2.38 / (axes as f64).sqrt();
    let step = |rng: &mut ChaCha8Rng, draw: &Draw| -> Vec<f64> {
        let z: Vec<f64> = (0..axes).map(|_| normal(rng)).collect();
        let along = |row: usize| (0..=row).map(|k| spread[row][k] * z[k]).sum::<f64>();
        (0..axes).map(|row| draw.place[row] + scale * along(row)).collect()
    };
    let places = particles.iter().map(|draw| step(rng, draw)).collect();
    let proposed = target.draws(places)?;
    let mut accepted = 0;
    for (draw, next) in particles.iter_mut().zip(proposed) {
        let gain = next.prior - draw.prior + power * (next.likelihood - draw.likelihood);
        if even(rng).ln() < gain {
            *draw = next;
            accepted += 1;
        }
    }
    let share = f64::from(accepted) / particles.len() as f64;
    Ok((stride * (share - 0.25).exp()).clamp(0.05, 2.0))
}

/// Lower triangular root of the weighted covariance of the particles, with a floor that keeps it regular.
fn covariance_root(particles: &[Draw], weights: &[f64]) -> Vec<Vec<f64>> {
    let axes = particles[0].place.len();
    let mean = |axis: usize| particles.iter().zip(weights).map(|(draw, w)| w * draw.place[axis]).sum::<f64>();
    let means: Vec<f64> = (0..axes).map(mean).collect();
    let covariance = |a: usize, b: usize| {
        let pairs = particles.iter().zip(weights);
        pairs.map(|(draw, w)| w * (draw.place[a] - means[a]) * (draw.place[b] - means[b])).sum::<f64>()
    };
    let mut root = vec![vec![0.0; axes]; axes];
    for row in 0..axes {
        for column in 0..=row {
            let floor = if row == column { 1e-12 } else { 0.0 };
            let known: f64 = (0..column).map(|k| root[row][k] * root[column][k]).sum();
            let rest = covariance(row, column) + floor - known;
            root[row][column] = if row == column { rest.max(1e-12).sqrt() } else { rest / root[column][column] };
        }
    }
    root
}

/// Different particles, spread over all of them, as the beginning of chains.
pub(super) fn beginnings(rng: &mut ChaCha8Rng, particles: &[Draw], count: usize) -> Vec<Draw> {
    let first = place(rng, particles.len());
    let order = |k: usize| (first + k * particles.len() / count.max(1)) % particles.len();
    (0..count).map(|k| particles[order(k)].clone()).collect()
}
