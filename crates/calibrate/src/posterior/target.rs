//! The density that is sampled: prior times likelihood, over the shares and the scale of the model's error.

use rand_chacha::ChaCha8Rng;

use crate::basis::Basis;
use crate::evaluator::Evaluator;
use crate::parameter::values;
use crate::posterior::draw::even;
use crate::posterior::gain::Gain;
use crate::posterior::likelihood::Likelihood;
use crate::posterior::prior::invert;
use crate::watch::Stopped;

/// A point with the logarithms of its densities.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Draw {
    /// Shares of the ranges, and the number sought for the model's error where it is.
    pub place: Vec<f64>,
    /// Prior, but for a constant.
    pub prior: f64,
    /// Likelihood; minus infinity where the model fails.
    pub likelihood: f64,
    /// The common gain there, as the records leave it.
    pub gain: Gain,
}

/// The density.
pub(super) struct Target<'e, 'a> {
    pub evaluator: &'e mut Evaluator<'a>,
    basis: &'e Basis,
    likelihood: Likelihood,
    cumulated: Vec<Vec<f64>>,
}

impl<'e, 'a> Target<'e, 'a> {
    pub(super) fn new(evaluator: &'e mut Evaluator<'a>, basis: &'e Basis, likelihood: Likelihood) -> Self {
        let cumulated = evaluator.problem.parameters().iter().map(|p| p.prior.cumulated(p)).collect();
        Self { evaluator, basis, likelihood, cumulated }
    }

    /// Count of numbers sought.
    pub(super) fn axes(&self) -> usize {
        self.cumulated.len() + self.likelihood.extra()
    }

    /// Places drawn from the prior.
    pub(super) fn prior_places(&self, rng: &mut ChaCha8Rng, count: usize) -> Vec<Vec<f64>> {
        let half_normal = |rng: &mut ChaCha8Rng| loop {
            let (sought, height) = (even(rng), even(rng));
            if height.ln() <= self.likelihood.log_prior(Some(&sought)) {
                break sought;
            }
        };
        let mut one = || {
            let mut place: Vec<f64> = self.cumulated.iter().map(|sums| invert(sums, even(rng))).collect();
            if self.likelihood.extra() > 0 {
                place.push(half_normal(rng));
            }
            place
        };
        (0..count).map(|_| one()).collect()
    }

    fn prior(&self, place: &[f64]) -> f64 {
        let parameters = self.evaluator.problem.parameters();
        let sum: f64 = parameters.iter().zip(place).map(|(p, share)| p.prior.log_density(p, *share)).sum();
        sum + self.likelihood.log_prior(place.get(parameters.len()))
    }

    /// The model's error at a place, as a share of the peaks.
    pub(super) fn scale(&self, place: &[f64]) -> f64 {
        self.likelihood.scale(place.get(self.evaluator.problem.parameters().len()))
    }

    /// Densities at many places; the model is only asked inside the ranges.
    pub(super) fn draws(&mut self, places: Vec<Vec<f64>>) -> Result<Vec<Draw>, Stopped> {
        let parameters = self.evaluator.problem.parameters();
        let priors: Vec<f64> = places.iter().map(|place| self.prior(place)).collect();
        let inside: Vec<usize> = (0..places.len()).filter(|k| priors[*k] > f64::NEG_INFINITY).collect();
        let points: Vec<Vec<f64>> = inside.iter().map(|k| values(parameters, &places[*k])).collect();
        let answers = self.evaluator.respond(&points, &self.basis.request(false))?;
        let mut likelihoods = vec![(f64::NEG_INFINITY, Gain { mean: 1.0, variance: 0.0 }); places.len()];
        for (k, answer) in inside.into_iter().zip(answers) {
            if let Ok(response) = answer.as_ref() {
                let held = &self.basis.held;
                let (log, gain) = self.likelihood.log(self.evaluator.problem, held, response, self.scale(&places[k]));
                likelihoods[k] = (if log.is_nan() { f64::NEG_INFINITY } else { log }, gain);
            }
        }
        let all = places.into_iter().zip(priors).zip(likelihoods);
        Ok(all.map(|((place, prior), (likelihood, gain))| Draw { place, prior, likelihood, gain }).collect())
    }
}
