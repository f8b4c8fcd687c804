//! A polynomial in the place of a slow model: every value of every channel by least squares, its degree chosen and its
//! error stated by points that were held out.
//!
//! Its variables are the shares of the ranges, in the logarithm of every parameter whose range lies above zero: a flexibility
//! falls with the reciprocal of a modulus, over a decade of which a polynomial in the modulus itself follows badly.

use faer::Mat;
use faer::linalg::solvers::SolveLstsq;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::basis::{Basis, Halt};
use crate::evaluator::Evaluator;
use crate::forward::{Evaluation, Failure, Forward, Request, Response, Samples};
use crate::misfit::{Compare, peak_place};
use crate::parameter::{Parameter, shares, values};
use crate::posterior::draw::latin_hypercube;
use crate::problem::Problem;

/// Highest total degree that is tried.
const DEGREE: usize = 4;

/// The polynomial and its error.
#[derive(Debug, Clone, PartialEq)]
pub struct Surrogate {
    parameters: Vec<Parameter>,
    samples: Samples,
    lengths: Vec<usize>,
    /// Values by channel of one answer.
    widths: Vec<usize>,
    exponents: Vec<Vec<u8>>,
    /// Coefficients by value, one row for every exponent.
    coefficients: Vec<Vec<f64>>,
    /// Total degree that was chosen.
    pub degree: usize,
    /// Points that the fit is made of.
    pub fitted: usize,
    /// Points that it was judged by.
    pub judged: usize,
    /// Largest error of a channel's peak over the held-out points, as a share of its measured peak.
    pub largest_error: Vec<f64>,
    /// Root mean square of the same.
    pub mean_error: Vec<f64>,
    /// Root mean square error of one value of a channel over the held-out points [unit of the channel].
    pub value_error: Vec<f64>,
}

impl Surrogate {
    /// The problem with the polynomial's own error joined to the uncertainties of the channels, for a posterior by it.
    pub fn widen(&self, problem: &Problem) -> Problem {
        let error = |k: usize| match problem.compare(k) {
            Compare::Peaks => self.mean_error[k] * problem.channels()[k].measured_peak().unwrap_or(0.0).abs(),
            Compare::Histories => self.value_error[k],
        };
        let joined = |k: usize| problem.channels()[k].uncertainty.map_or(f64::NAN, |noise| noise.hypot(error(k)));
        problem.with_uncertainties(&(0..problem.channels().len()).map(joined).collect::<Vec<_>>())
    }

    /// The error in words.
    pub fn words(&self) -> String {
        let worst = self.largest_error.iter().copied().fold(0.0, f64::max);
        let mean = self.mean_error.iter().copied().fold(0.0, f64::max);
        format!(
            "A polynomial of degree {} was fitted to {} points of the model; over {} points that it never saw, the \
             peak of the worst channel is off by {:.3} % in the mean and {:.3} % at the most.",
            self.degree,
            self.fitted,
            self.judged,
            100.0 * mean,
            100.0 * worst
        )
    }

    /// What it gives at shares of the ranges, by channel.
    fn values(&self, shares: &[f64]) -> Vec<Vec<f64>> {
        let monomials = monomials(shares, &self.exponents);
        let mut rows = self.coefficients.iter();
        let value = |row: &Vec<f64>| row.iter().zip(&monomials).map(|(a, b)| a * b).sum::<f64>();
        self.widths.iter().map(|width| rows.by_ref().take(*width).map(value).collect()).collect()
    }
}

/// Fits polynomials of rising degree to so many points, placed by a seed, and keeps the one with the least error at others that were held out.
///
/// # Errors
/// A stop by the onlooker, or a model that answers at too few of the points.
pub fn build(
    evaluator: &mut Evaluator,
    basis: &Basis,
    [fitted, held_out]: [usize; 2],
    seed: u64,
) -> Result<Surrogate, Halt> {
    evaluator.begin(Some(fitted + held_out));
    evaluator.stage = "points of the surrogate".into();
    let problem = evaluator.problem;
    let n = problem.parameters().len();
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let drawn = [fitted.max(2 * n + 2), held_out.max(2)].map(|k| latin_hypercube(&mut rng, k, n));
    let by_logarithm = |own: Parameter| if own.lower > 0.0 { own.logarithmic() } else { own };
    let parameters: Vec<Parameter> = problem.parameters().iter().cloned().map(by_logarithm).collect();
    let points: Vec<Vec<f64>> = drawn.concat().iter().map(|z| values(&parameters, z)).collect();
    let answers = evaluator.respond(&points, &basis.request(false))?;
    let known = |range: std::ops::Range<usize>| -> Vec<(Vec<f64>, &Response)> {
        let pairs = range.filter_map(|k| answers[k].as_ref().as_ref().ok().map(|response| (k, response)));
        pairs.map(|(k, response)| (drawn.concat()[k].clone(), response)).collect()
    };
    let first = drawn[0].len();
    let (training, held_out) = (known(0..first), known(first..points.len()));
    if training.len() < 2 * n + 2 || held_out.is_empty() {
        let message = format!("the model answers at {} of {} points, too few", training.len(), first);
        return Err(Halt::Failed(Failure::new("no-surrogate", message)));
    }
    let lengths: Vec<usize> = (0..problem.channels().len()).map(|k| evaluator.forward.length(k)).collect();
    let mut best: Option<Surrogate> = None;
    for degree in 1..=DEGREE {
        let exponents = exponents(n, degree);
        // Two points for every coefficient: with fewer, the fit follows its points and nothing between.
        if degree > 1 && training.len() < 2 * exponents.len() {
            break;
        }
        let mut surrogate = Surrogate {
            parameters: parameters.clone(),
            samples: basis.samples.clone(),
            lengths: lengths.clone(),
            widths: training[0].1.values.iter().map(Vec::len).collect(),
            coefficients: fit(&training, &exponents),
            exponents,
            degree,
            fitted: training.len(),
            judged: held_out.len(),
            largest_error: Vec::new(),
            mean_error: Vec::new(),
            value_error: Vec::new(),
        };
        judge(&mut surrogate, evaluator, &held_out);
        let worst = |s: &Surrogate| s.mean_error.iter().copied().fold(0.0, f64::max);
        if best.as_ref().is_none_or(|best| worst(&surrogate) < worst(best)) {
            best = Some(surrogate);
        }
    }
    best.ok_or_else(|| Halt::Failed(Failure::new("no-surrogate", "no polynomial could be fitted")))
}

/// Exponents of all monomials up to a total degree.
fn exponents(n: usize, degree: usize) -> Vec<Vec<u8>> {
    let mut all = vec![vec![0_u8; n]];
    let mut last = all.clone();
    for _ in 0..degree {
        let mut next = Vec::new();
        for exponent in &last {
            // Only from the last raised variable on, so that every monomial comes once.
            let from = exponent.iter().rposition(|power| *power > 0).unwrap_or(0);
            for k in from..n {
                let mut raised = exponent.clone();
                raised[k] += 1;
                next.push(raised);
            }
        }
        all.extend(next.iter().cloned());
        last = next;
    }
    all
}

/// Products of Legendre polynomials over the ranges: well conditioned where plain powers are not.
fn monomials(shares: &[f64], exponents: &[Vec<u8>]) -> Vec<f64> {
    let top = exponents.iter().flatten().copied().max().unwrap_or(0);
    let legendre = |share: f64| {
        let x = 2.0 * share - 1.0;
        let mut values = vec![1.0, x];
        for k in 1..usize::from(top) {
            let n = k as f64;
            values.push(((2.0 * n + 1.0) * x * values[k] - n * values[k - 1]) / (n + 1.0));
        }
        values
    };
    let tables: Vec<Vec<f64>> = shares.iter().map(|share| legendre(*share)).collect();
    let product = |powers: &Vec<u8>| powers.iter().zip(&tables).map(|(power, t)| t[usize::from(*power)]).product();
    exponents.iter().map(product).collect()
}

fn fit(training: &[(Vec<f64>, &Response)], exponents: &[Vec<u8>]) -> Vec<Vec<f64>> {
    let rows: Vec<Vec<f64>> = training.iter().map(|(shares, _)| monomials(shares, exponents)).collect();
    let values: Vec<Vec<f64>> = training.iter().map(|(_, response)| response.values.concat()).collect();
    let matrix = Mat::from_fn(rows.len(), exponents.len(), |i, j| rows[i][j]);
    let right = Mat::from_fn(rows.len(), values[0].len(), |i, j| values[i][j]);
    let solution = matrix.col_piv_qr().solve_lstsq(&right);
    (0..values[0].len()).map(|value| (0..exponents.len()).map(|k| solution[(k, value)]).collect()).collect()
}

fn judge(surrogate: &mut Surrogate, evaluator: &Evaluator, held_out: &[(Vec<f64>, &Response)]) {
    let problem = evaluator.problem;
    let channels = problem.channels().len();
    let (mut largest, mut squares, mut value_squares) =
        (vec![0.0_f64; channels], vec![0.0; channels], vec![0.0; channels]);
    for (shares, response) in held_out {
        let predicted = surrogate.values(shares);
        for k in (0..channels).filter(|k| problem.channels()[*k].counts()) {
            let pairs = predicted[k].iter().zip(&response.values[k]);
            value_squares[k] += pairs.map(|(p, v)| (p - v).powi(2)).sum::<f64>() / predicted[k].len().max(1) as f64;
            let peak = |values: &Vec<f64>| peak_place(problem, k, values).map(|place| values[place]);
            if let Some((predicted, computed)) = peak(&predicted[k]).zip(peak(&response.values[k])) {
                let scale = problem.channels()[k].measured_peak().filter(|peak| *peak != 0.0).unwrap_or(1.0);
                let error = ((predicted - computed) / scale).abs();
                largest[k] = largest[k].max(error);
                squares[k] += error * error;
            }
        }
    }
    let mean = |squares: Vec<f64>| squares.into_iter().map(|sum| (sum / held_out.len() as f64).sqrt()).collect();
    (surrogate.largest_error, surrogate.mean_error, surrogate.value_error) =
        (largest, mean(squares), mean(value_squares));
}

impl Forward for Surrogate {
    fn evaluate(&self, point: &[f64], request: &Request) -> Evaluation {
        if request.samples != self.samples || request.sensitivities {
            return Err(Failure::new("not-this-surrogate", "it was fitted to other samples of the channels"));
        }
        Ok(Response { values: self.values(&shares(&self.parameters, point)), derivatives: Vec::new() })
    }

    fn length(&self, channel: usize) -> usize {
        self.lengths.get(channel).copied().unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn monomials_come_once_each() {
        // Binomial of 5 + 4 over 4.
        let all = exponents(5, 4);
        assert_eq!(all.len(), 126);
        let mut sorted = all.clone();
        sorted.sort();
        sorted.dedup();
        assert_eq!(sorted.len(), 126);
    }
}
