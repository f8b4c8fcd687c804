//! Draws from normal distributions cut off at the ranges, mixed over the size of the model's error: Gibbs steps along the axes of each
//! normal and along the parameters.

use super::Linearised;
use super::quadratic::{GainLine, Likelihoods, Quadratic};
use crate::posterior::draw::{even, normal};
use crate::posterior::gain::Gain;
use crate::posterior::likelihood::{Likelihood, ModelError};
use crate::problem::Problem;
use faer::{Mat, Side};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// What was drawn.
pub(super) struct Drawn {
    /// Shares of the ranges.
    pub shares: Vec<Vec<f64>>,
    /// The common gain at each, as the records leave it.
    pub gains: Vec<Gain>,
    /// Mean size of the model's error.
    pub model_error: f64,
}

/// Sizes of the model's error between zero and the end of its prior.
const SIZES: usize = 80;
/// Draws; their chance disturbs intervals by about one part in the root of a quarter of them.
const DRAWS: usize = 20_000;
/// Steps before the first draw that counts.
const RUN_IN: usize = 1000;

/// A normal distribution for one size of the model's error.
struct Normal {
    size: f64,
    /// Logarithm of the share of the prior that the size stands for.
    prior: f64,
    density: Quadratic,
    /// The common gain.
    gain: GainLine,
    /// Directions along which it falls apart into independent ones, and their precisions.
    axes: Vec<(Vec<f64>, f64)>,
}

pub(super) fn draw(model: &Linearised, problem: &Problem, likelihood: &Likelihood, seed: u64) -> Drawn {
    let likelihoods = Likelihoods::new(model, problem);
    let normals: Vec<Normal> = sizes(likelihood)
        .into_iter()
        .map(|(size, prior)| {
            let (density, gain) = likelihoods.with_gains(size, likelihood.common_gain);
            Normal { size, prior, axes: axes(&density), density, gain }
        })
        .collect();
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (mut x, mut shares, mut gains, mut sum) = (vec![0.0; model.at.len()], Vec::new(), Vec::new(), 0.0);
    for step in 0..RUN_IN + DRAWS {
        let normal = pick(&mut rng, &normals, &x);
        for (axis, precision) in &normal.axes {
            along(&mut rng, model, normal, axis, *precision, &mut x);
        }
        for k in 0..x.len() {
            let mut axis = vec![0.0; x.len()];
            axis[k] = 1.0;
            along(&mut rng, model, normal, &axis, normal.density.matrix[k][k], &mut x);
        }
        if step >= RUN_IN {
            shares.push(x.iter().zip(&model.at).map(|(x, at)| (x + at).clamp(0.0, 1.0)).collect());
            gains.push(normal.gain.at(&x));
            sum += normal.size;
        }
    }
    Drawn { model_error: sum / shares.len() as f64, shares, gains }
}

/// Sizes of the model's error with the logarithms of the shares of the prior that they stand for: closer together towards zero.
fn sizes(likelihood: &Likelihood) -> Vec<(f64, f64)> {
    match likelihood.model_error {
        ModelError::None => vec![(0.0, 0.0)],
        ModelError::Known(size) => vec![(size, 0.0)],
        ModelError::Sought(_) => {
            let one = |k: usize| {
                let root = (k as f64 + 0.5) / SIZES as f64;
                let sought = root * root;
                (likelihood.scale(Some(&sought)), likelihood.log_prior(Some(&sought)) + root.ln())
            };
            (0..SIZES).map(one).collect()
        }
    }
}

fn axes(density: &Quadratic) -> Vec<(Vec<f64>, f64)> {
    let n = density.vector.len();
    let matrix = Mat::from_fn(n, n, |i, j| density.matrix[i][j]);
    let Ok(eigen) = matrix.self_adjoint_eigen(Side::Lower) else { return Vec::new() };
    let (vectors, precisions) = (eigen.U(), eigen.S());
    (0..n).map(|k| ((0..n).map(|i| vectors[(i, k)]).collect(), precisions[k].max(0.0))).collect()
}

/// The normal of one size of the model's error, drawn with the density that each has at `x`.
fn pick<'n>(rng: &mut ChaCha8Rng, normals: &'n [Normal], x: &[f64]) -> &'n Normal {
    if normals.len() == 1 {
        return &normals[0];
    }
    let logs: Vec<f64> = normals.iter().map(|normal| normal.prior - normal.density.at(x)).collect();
    let top = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let weights: Vec<f64> = logs.iter().map(|log| (log - top).exp()).collect();
    let mut left = even(rng) * weights.iter().sum::<f64>();
    let chosen = weights.iter().position(|weight| {
        left -= weight;
        left <= 0.0
    });
    &normals[chosen.unwrap_or(normals.len() - 1)]
}

/// Moves along a direction, inside the ranges, to a place drawn with its density.
fn along(rng: &mut ChaCha8Rng, model: &Linearised, normal: &Normal, axis: &[f64], precision: f64, x: &mut [f64]) {
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for ((x, at), a) in x.iter().zip(&model.at).zip(axis).filter(|(_, a)| a.abs() > 1e-12) {
        let ends = [(-at - x) / a, (1.0 - at - x) / a];
        low = low.max(ends[0].min(ends[1]));
        high = high.min(ends[0].max(ends[1]));
    }
    if !(low < high) {
        return;
    }
    let fall: f64 = normal.density.fall(x).iter().zip(axis).map(|(fall, a)| fall * a).sum();
    let way = cut_normal(rng, fall, precision, [low, high]);
    x.iter_mut().zip(axis).for_each(|(x, a)| *x += way * a);
}

/// A number between two ends with the density exp(fall t - precision t²/2): by rejection from an even, a normal or an exponential
/// distribution (Robert 1995, Statistics and Computing 5, 121-125).
fn cut_normal(rng: &mut ChaCha8Rng, fall: f64, precision: f64, [low, high]: [f64; 2]) -> f64 {
    let deviation = 1.0 / precision.sqrt();
    let mean = fall / precision;
    let (a, b) = ((low - mean) / deviation, (high - mean) / deviation);
    if !(precision > 0.0 && a.is_finite() && b.is_finite()) {
        return even_or_steep(rng, fall, [low, high]);
    }
    // The tail nearer to the mean is looked at from zero upwards.
    let (near, far, sign) = if b < 0.0 { (-b, -a, -1.0) } else { (a, b, 1.0) };
    let z = loop {
        let (z, log) = if near > 0.45 {
            // The exponential under which a tail fits best.
            let rate = 0.5 * (near + (near * near + 4.0).sqrt());
            let z = near + exponential(rng, rate, far - near);
            (z, -0.5 * (z - rate) * (z - rate))
        } else if far - near < 2.5 {
            let z = near + (far - near) * even(rng);
            (z, -0.5 * z * z)
        } else {
            let z = normal(rng);
            (z, if (near..=far).contains(&z) { 0.0 } else { f64::NEG_INFINITY })
        };
        if even(rng).ln() <= log {
            break z;
        }
    };
    (mean + sign * z * deviation).clamp(low, high)
}

/// A number between zero and `length` whose density falls as exp(-rate t).
fn exponential(rng: &mut ChaCha8Rng, rate: f64, length: f64) -> f64 {
    let most = -(-rate * length).exp_m1();
    let t = if rate > 0.0 { -(-even(rng) * most).ln_1p() / rate } else { even(rng) * length };
    if rate * length < 1e-9 { even(rng) * length } else { t.min(length) }
}

/// The same where there is no precision: the density is an exponential between the ends, or even.
fn even_or_steep(rng: &mut ChaCha8Rng, fall: f64, [low, high]: [f64; 2]) -> f64 {
    let t = exponential(rng, fall.abs(), high - low);
    if fall > 0.0 { high - t } else { low + t }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cut_normals_have_their_means() {
        let mut rng = ChaCha8Rng::seed_from_u64(2);
        // Means of the standard normal between two ends, (phi(a) - phi(b)) / (Phi(b) - Phi(a)), from tables.
        for (low, high, mean) in [
            (0.0, 40.0, 0.797_885),
            (2.0, 40.0, 2.373_216),
            (-1.0, 1.0, 0.0),
            (-3.0, -2.0, -2.315_821),
            (1.0, 1.5, 1.224_339),
        ] {
            let count = 40_000;
            let sum: f64 = (0..count).map(|_| cut_normal(&mut rng, 0.0, 1.0, [low, high])).sum();
            // Deviations are at most 0.6: four of those of the mean are 0.012.
            assert!((sum / f64::from(count) - mean).abs() < 0.012, "{low} to {high}: {}", sum / f64::from(count));
        }
        let (fall, count) = (3.0, 40_000);
        let sum: f64 = (0..count).map(|_| cut_normal(&mut rng, fall, 0.0, [0.0, 1.0])).sum();
        // An exponential that rises at three over a length of one: 1/(1 - e^-3) - 1/3.
        let mean = 1.0 / (1.0 - (-fall).exp()) - 1.0 / fall;
        assert!((sum / f64::from(count) - mean).abs() < 0.01);
    }
}
