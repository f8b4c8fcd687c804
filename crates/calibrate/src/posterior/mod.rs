//! Posterior distribution of the parameters (Bayes), with a model-error term.
//!
//! Particles go from the prior to the posterior by degrees (`tempering.rs`), which gives the evidence; from there walkers go
//! on (`ensemble.rs`) until the effective sample size is reached ([`diagnostics`]).

pub mod diagnostics;
pub mod draw;
mod ensemble;
pub mod gain;
pub mod likelihood;
mod prior;
pub mod summary;
mod target;
mod tempering;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::basis::Basis;
use crate::evaluator::Evaluator;
use crate::parameter::values;
use crate::problem::Flaw;
use crate::watch::Stopped;

pub use diagnostics::Mixing;
pub use gain::CommonGain;
pub use likelihood::{Likelihood, ModelError};
pub use prior::Prior;
pub use summary::Summary;

use ensemble::{Ensemble, Kept};
use gain::Gain;
use serde::{Deserialize, Serialize};
use target::Target;

/// What the sampling may cost.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Settings {
    /// Noise and model error.
    pub likelihood: Likelihood,
    /// Particles of a tempering run, at least 8 for each parameter are taken.
    pub particles: usize,
    /// Moves of each particle at each power.
    pub moves: usize,
    /// Runs from the prior, each with walkers of its own, at least 2.
    pub runs: usize,
    /// Walkers of a run; at least twice the parameters and two more are taken, an even number.
    pub walkers: usize,
    /// Effective samples that are wanted of every parameter.
    pub effective_samples: f64,
    /// Most steps of a walker.
    pub steps: usize,
    /// Seed.
    pub seed: u64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            likelihood: Likelihood::default(),
            particles: 400,
            moves: 5,
            runs: 2,
            walkers: 40,
            effective_samples: 10_000.0,
            steps: 200_000,
            seed: 1,
        }
    }
}

/// How it ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Status {
    /// The effective samples were reached and the runs agree (R-hat below 1.01).
    Completed,
    /// The most steps were made first, or the runs do not agree.
    StepLimit,
    /// The model fails, or has no likelihood, wherever the prior looked.
    NoLikelihood,
    /// The onlooker wanted it to end.
    Stopped,
}

/// One parameter as the data leave it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Marginal {
    /// Its name.
    pub name: String,
    /// Mean, spread and interval [unit of the parameter].
    pub summary: Summary,
    /// R-hat and effective samples.
    pub mixing: Mixing,
    /// Whether the interval, measured in the parameter's scale, is narrower than half of what the prior's would be over the
    /// whole range and ends on no bound of it, and the parameter is told apart from the common gain.
    pub identifiable: bool,
}

/// What the data leave open.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Posterior {
    /// How it ended.
    pub status: Status,
    /// Parameters, in order.
    pub parameters: Vec<Marginal>,
    /// The model's error as a share of the peaks, where it was sought.
    pub model_error: Option<Summary>,
    /// The gain that all channels share, where it is uncertain.
    pub common_gain: Option<CommonGain>,
    /// Correlation of the parameters.
    pub correlation: Vec<Vec<f64>>,
    /// Logarithm of the evidence: mean over the runs, and the standard deviation of that mean.
    pub log_evidence: Option<(f64, f64)>,
    /// Least effective sample size over the parameters and the model's error.
    pub effective_samples: f64,
    /// Largest R-hat over the same.
    pub r_hat: f64,
    /// Steps of a walker.
    pub steps: usize,
    /// Evaluations, each point once where the evaluator keeps a log.
    pub evaluations: usize,
    /// Samples of the parameters, evenly taken from all [units of the parameters].
    pub samples: Vec<Vec<f64>>,
    /// What is left open, in words.
    pub words: Vec<String>,
}

/// Most samples that are handed back, for pictures.
const KEEP: usize = 5_000;
/// R-hat below which runs are said to agree (Vehtari et al. 2021).
const AGREE: f64 = 1.01;

/// Samples the posterior, or says what keeps it from being posed.
///
/// # Errors
/// All that is wrong with the likelihood; a stop by the onlooker is a status.
pub fn sample(evaluator: &mut Evaluator, basis: &Basis, settings: &Settings) -> Result<Posterior, Vec<Flaw>> {
    let findings = settings.likelihood.check(evaluator.problem);
    if !findings.is_empty() {
        return Err(findings);
    }
    evaluator.begin(None);
    let mut run = Run::default();
    let mut target = Target::new(evaluator, basis, settings.likelihood);
    let status = run.go(&mut target, settings).unwrap_or(Status::Stopped);
    Ok(run.report(evaluator, settings, status))
}

/// The sampling on its way.
#[derive(Default)]
struct Run {
    ensembles: Vec<Ensemble>,
    evidences: Vec<f64>,
    /// The model's error of every sample, chain by chain.
    scales: Vec<Vec<f64>>,
    /// How the chains mixed, by number sought, when they ended.
    mixed: Vec<Mixing>,
}

impl Run {
    fn go(&mut self, target: &mut Target, settings: &Settings) -> Result<Status, Stopped> {
        let axes = target.axes();
        let walkers = settings.walkers.max(2 * axes + 2).next_multiple_of(2);
        let particles = settings.particles.max(8 * axes).max(walkers);
        let mut rngs = Vec::new();
        for number in 0..settings.runs.max(2) {
            let mut rng = ChaCha8Rng::seed_from_u64(settings.seed);
            rng.set_stream(number as u64);
            let (tempered, log_evidence) = tempering::temper(target, &mut rng, particles, settings.moves.max(1))?;
            self.evidences.push(log_evidence);
            if log_evidence == f64::NEG_INFINITY {
                return Ok(Status::NoLikelihood);
            }
            self.ensembles.push(Ensemble::new(tempering::beginnings(&mut rng, &tempered, walkers)));
            rngs.push(rng);
        }
        let (mut steps, mut more) = (0, 50);
        loop {
            more = more.min(settings.steps.max(50) - steps);
            for (ensemble, rng) in self.ensembles.iter_mut().zip(&mut rngs) {
                target.evaluator.stage = format!("walkers, step {steps}");
                ensemble.walk(target, rng, more)?;
            }
            steps += more;
            more = steps / 2;
            let last = steps >= settings.steps.max(50);
            self.mixed.clear();
            let mut enough = true;
            for axis in 0..axes {
                // The first number that is not told well enough decides; the rest is looked at only at the end.
                if enough || last {
                    let mixing = self.mixing(axis);
                    enough &= mixing.effective_samples >= settings.effective_samples && mixing.r_hat < AGREE;
                    self.mixed.push(mixing);
                }
            }
            if enough || last {
                let scale = |chain: &Vec<Kept>| chain.iter().map(|kept| target.scale(&kept.place)).collect();
                self.scales = self.ensembles.iter().flat_map(|e| &e.chains).map(scale).collect();
                return Ok(if enough { Status::Completed } else { Status::StepLimit });
            }
        }
    }

    fn mixing(&self, axis: usize) -> Mixing {
        let chain = |chain: &Vec<Kept>| chain.iter().map(|kept| kept.place[axis]).collect::<Vec<f64>>();
        let run = |ensemble: &Ensemble| ensemble.chains.iter().map(chain).collect::<Vec<_>>();
        diagnostics::mixing(&self.ensembles.iter().map(run).collect::<Vec<_>>())
    }

    fn report(&self, evaluator: &Evaluator, settings: &Settings, status: Status) -> Posterior {
        let parameters = evaluator.problem.parameters();
        let kept: Vec<&Kept> = self.ensembles.iter().flat_map(|ensemble| &ensemble.chains).flatten().collect();
        let points: Vec<Vec<f64>> = kept.iter().map(|kept| values(parameters, &kept.place)).collect();
        let axes = if points.is_empty() { 0 } else { parameters.len() + settings.likelihood.extra() };
        let column = |k: usize| points.iter().map(|point| point[k]).collect::<Vec<f64>>();
        let columns: Vec<Vec<f64>> = (0..axes.min(parameters.len())).map(column).collect();
        let gains: Vec<Gain> = kept.iter().map(|kept| kept.gain).collect();
        let common_gain = CommonGain::of(&columns, &gains, settings.likelihood.common_gain);
        let unknown = Mixing { r_hat: f64::NAN, effective_samples: f64::NAN };
        let mixing: Vec<Mixing> = (0..axes).map(|k| self.mixed.get(k).copied().unwrap_or(unknown)).collect();
        let marginal = |k: usize| {
            let parameter = &parameters[k];
            let summary = summary::summary(&columns[k], Some([parameter.lower, parameter.upper]));
            let told_apart = common_gain.as_ref().is_none_or(|gain| gain.told_apart(k));
            let identifiable = told_apart && summary::tells(parameter, summary.interval_95);
            Marginal { name: parameter.name.clone(), summary, mixing: mixing[k], identifiable }
        };
        let marginals: Vec<Marginal> = (0..columns.len()).map(marginal).collect();
        let correlation: Vec<Vec<f64>> =
            columns.iter().map(|a| columns.iter().map(|b| summary::correlation(a, b)).collect()).collect();
        let scales: Vec<f64> = self.scales.concat();
        let sought = settings.likelihood.extra() > 0 && !scales.is_empty();
        let stride = points.len().div_ceil(KEEP).max(1);
        let mut posterior = Posterior {
            status,
            model_error: sought.then(|| summary::summary(&scales, None)),
            common_gain,
            log_evidence: self.evidence(),
            effective_samples: mixing.iter().map(|m| m.effective_samples).fold(f64::INFINITY, f64::min),
            r_hat: mixing.iter().map(|m| m.r_hat).fold(1.0, f64::max),
            steps: self.ensembles.iter().map(|ensemble| ensemble.steps).min().unwrap_or(0),
            evaluations: evaluator.done,
            samples: points.iter().step_by(stride).cloned().collect(),
            words: Vec::new(),
            parameters: marginals,
            correlation,
        };
        if posterior.parameters.is_empty() {
            posterior.effective_samples = 0.0;
        }
        posterior.words = words(&posterior, parameters);
        posterior
    }

    fn evidence(&self) -> Option<(f64, f64)> {
        let n = self.evidences.len() as f64;
        if self.evidences.contains(&f64::NEG_INFINITY) || self.evidences.len() < 2 {
            return None;
        }
        // The estimates of the evidence itself are unbiased; their mean is taken, and its spread by the delta method.
        let top = self.evidences.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let ratios: Vec<f64> = self.evidences.iter().map(|log| (log - top).exp()).collect();
        let summary = summary::summary(&ratios, None);
        Some((top + summary.mean.ln(), summary.standard_deviation / n.sqrt() / summary.mean))
    }
}

/// What is said of an interval that ends on a bound.
pub(crate) fn bounded(parameter: &crate::parameter::Parameter, [low, high]: [f64; 2]) -> String {
    let crate::parameter::Parameter { name, unit, lower, upper, .. } = parameter;
    format!(
        "{name}: 95 % of what is left lies between {low:.4} and {high:.4} {unit} and ends on a bound of the range of {lower} to {upper}: the \
         range limits it there, and not the data."
    )
}

fn words(posterior: &Posterior, parameters: &[crate::parameter::Parameter]) -> Vec<String> {
    let mut words = Vec::new();
    for (marginal, parameter) in posterior.parameters.iter().zip(parameters) {
        let [low, high] = marginal.summary.interval_95;
        if summary::ends_on_bound(parameter, marginal.summary.interval_95) {
            words.push(bounded(parameter, marginal.summary.interval_95));
        } else if !summary::tells(parameter, marginal.summary.interval_95) {
            words.push(format!(
                "{} is hardly determined by the data: its 95 % interval lies between {low:.4} and {high:.4} {}, of a \
                 range of {} to {}.",
                marginal.name, parameter.unit, parameter.lower, parameter.upper
            ));
        }
    }
    let summaries: Vec<Summary> = posterior.parameters.iter().map(|marginal| marginal.summary).collect();
    words.extend(gain::words(posterior.common_gain.as_ref(), parameters, &summaries));
    for a in 0..posterior.correlation.len() {
        for b in a + 1..posterior.correlation.len() {
            let correlation = posterior.correlation[a][b];
            if correlation.abs() >= 0.9 {
                let (one, two) = (&posterior.parameters[a].name, &posterior.parameters[b].name);
                words.push(format!(
                    "{one} and {two} are strongly correlated ({correlation:.2}): a change of one can be compensated by \
                     the other."
                ));
            }
        }
    }
    if posterior.status == Status::StepLimit {
        words.push(format!(
            "The sampling ended at its limit of steps with {:.0} effective samples and R-hat {:.3}.",
            posterior.effective_samples, posterior.r_hat
        ));
    }
    words
}
