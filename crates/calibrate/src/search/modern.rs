//! Nonlinear least squares by a reflective trust region (Branch, Coleman and Li 1999), from many starts.

use basin::{Executor, TerminationCode, TrustRegionReflective};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::basis::{Basis, Halt};
use crate::evaluator::Evaluator;
use crate::forward::{Failure, Samples};
use crate::parameter::{shares, values};
use crate::posterior::draw::latin_hypercube;
use crate::report::{Found, verify};
use crate::search::jacobian::STEP;
use crate::search::refined;
use crate::search::replay::{Known, Missing, Sought, broken_off, replay};
use serde::{Deserialize, Serialize};

/// What the search may do.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Settings {
    /// How many starts in all; those after the first, which is the stated one, fill the ranges evenly.
    pub starts: usize,
    /// Seed of their places.
    pub seed: u64,
    /// Step of differences as a share of the range, where the model offers no derivatives.
    pub step: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self { starts: 8, seed: 1, step: STEP }
    }
}

/// How it ended.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub enum Status {
    /// The best run met its criterion.
    Converged,
    /// The best run ended otherwise, in the solver's words.
    NotConverged(String),
    /// The onlooker wanted it to end.
    Stopped,
    /// The model failed where it must not.
    Failed(Failure),
}

/// Where a search that knows one end alone came to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct End {
    /// How it ended.
    pub status: Status,
    /// Its end, verified.
    pub found: Option<Found>,
}

impl From<Halt> for End {
    fn from(halt: Halt) -> Self {
        let status = match halt {
            Halt::Stopped => Status::Stopped,
            Halt::Failed(failure) => Status::Failed(failure),
        };
        Self { status, found: None }
    }
}

/// One run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RunEnd {
    /// Where it began.
    pub start: Vec<f64>,
    /// Where it ended.
    pub end: Vec<f64>,
    /// Norm there; infinite where the model failed.
    pub norm: f64,
    /// Whether it met its criterion.
    pub converged: bool,
    /// How it ended, in the solver's words.
    pub ended: String,
}

/// What the search did and where it ended.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// How it ended.
    pub status: Status,
    /// All runs, best first.
    pub runs: Vec<RunEnd>,
    /// The best end, verified.
    pub found: Option<Found>,
}

/// Most iterations of a run.
const ITERATIONS: u64 = 100;

/// Stopping tolerances: relative reduction of the squared norm by a step, and relative size of the step. Synthetic records are asked for to half a
/// per cent; measured ones do not justify less.
const ENOUGH: [f64; 2] = [1e-7, 1e-6];

/// The same where full passages go on from the end.
const ENOUGH_OF_SLICES: [f64; 2] = [1e-4, 3e-4];

/// How often a step that does not descend is shortened, to a quarter each time. Peaks jump from place to place, joints open: the norm has kinks, and on one of
/// them no length of the step descends.
const ATTEMPTS: usize = 10;

/// How a run ends there.
const KINK: &str = "a kink of the norm: no step lowers it";

/// Ends nearer to a bound than this share of the range are tried on it.
const SAME: f64 = 1e-3;

/// Searches from many starts.
pub fn search(evaluator: &mut Evaluator, basis: &Basis, settings: &Settings) -> Outcome {
    let mut outcome = Outcome { status: Status::Stopped, runs: Vec::new(), found: None };
    if let Err(halt) = run(evaluator, basis, settings, &mut outcome) {
        outcome.status = End::from(halt).status;
    }
    outcome
}

fn run(evaluator: &mut Evaluator, basis: &Basis, settings: &Settings, outcome: &mut Outcome) -> Result<(), Halt> {
    evaluator.begin(None);
    evaluator.stage = "trust region, all starts".into();
    let starts = starts(evaluator, settings);
    let slices = basis.samples != Samples::All;
    let searched = basis.corrected(evaluator, &starts[0])?;
    outcome.runs = solve(evaluator, &searched, settings, &starts)?;
    // The best end by slices is not yet one by full passages.
    if let Some(best) = outcome.runs.first().filter(|run| slices && run.norm.is_finite()).cloned() {
        outcome.runs[0] = refined::settle(evaluator, basis, &best)?;
    }
    let Some(best) = outcome.runs.first().filter(|run| run.norm.is_finite()).cloned() else {
        return Err(Halt::Failed(Failure::new("no-start", "the model fails at every start")));
    };
    let End { status, found } = end(evaluator, basis, (&best.end, best.norm), best.converged, best.ended)?;
    (outcome.status, outcome.found) = (status, found);
    Ok(())
}

/// Verifies a point and the norm that a search saw there; `ended` says in the solver's words how it came to it.
pub(super) fn end(
    evaluator: &mut Evaluator,
    basis: &Basis,
    (point, norm): (&[f64], f64),
    converged: bool,
    ended: String,
) -> Result<End, Halt> {
    let parameters = evaluator.problem.parameters();
    let found = verify(evaluator, basis, parameters, point, norm, &vec![converged; point.len()])?;
    let status = if converged { Status::Converged } else { Status::NotConverged(ended) };
    Ok(End { status, found: Some(found) })
}

fn starts(evaluator: &Evaluator, settings: &Settings) -> Vec<Vec<f64>> {
    let parameters = evaluator.problem.parameters();
    let mut rng = ChaCha8Rng::seed_from_u64(settings.seed);
    let rest = latin_hypercube(&mut rng, settings.starts.max(1) - 1, parameters.len());
    std::iter::once(evaluator.problem.start()).chain(rest.iter().map(|z| values(parameters, z))).collect()
}

/// Runs from all starts together; the best end first.
pub(super) fn solve(
    evaluator: &mut Evaluator,
    basis: &Basis,
    settings: &Settings,
    starts: &[Vec<f64>],
) -> Result<Vec<RunEnd>, Halt> {
    let parameters = evaluator.problem.parameters();
    // Full passages go on where slices end.
    let [enough, nowhere] = if basis.samples == Samples::All { ENOUGH } else { ENOUGH_OF_SLICES };
    let one = |run: usize, known: &Known| -> Result<RunEnd, Missing> {
        let begin = shares(parameters, &starts[run]);
        let solver = TrustRegionReflective::new()
            .with_absolute_scaled_gradient_tolerance(1e-10)
            .with_relative_cost_change_tolerance(enough)
            .with_relative_step_tolerance::<Vec<f64>, f64>(nowhere)
            .with_max_inner_attempts(ATTEMPTS);
        let ended =
            Executor::from_start(Sought::new(known), solver, begin).max_iter(ITERATIONS).run().map_err(broken_off)?;
        let code = ended.report.code();
        let ends_at_kink = code == TerminationCode::SolverFailed && ended.cost().is_finite();
        let converged =
            ended.report.termination.is_converged() || code == TerminationCode::NumericalNoProgress || ends_at_kink;
        let end = values(parameters, ended.param());
        let norm = (2.0 * ended.cost()).sqrt();
        let norm = if norm.is_finite() { norm } else { f64::INFINITY };
        Ok(RunEnd {
            start: starts[run].clone(),
            end,
            norm,
            converged,
            ended: if ends_at_kink { KINK.to_owned() } else { format!("{code:?}") },
        })
    };
    let mut runs = replay(evaluator, basis, settings.step, starts.len(), one)?;
    meet_bounds(evaluator, basis, &mut runs)?;
    runs.sort_by(|a, b| a.norm.total_cmp(&b.norm));
    Ok(runs)
}

/// The solver stays strictly inside. An end within a thousandth of a bound is put on it where that is no worse.
fn meet_bounds(evaluator: &mut Evaluator, basis: &Basis, runs: &mut [RunEnd]) -> Result<(), Halt> {
    let parameters = evaluator.problem.parameters();
    let met = |end: &Vec<f64>| -> Vec<f64> {
        let near = |share: f64| if share < SAME { 0.0 } else { 1.0 };
        let outer = |share: &f64| *share < SAME || *share > 1.0 - SAME;
        let pairs = parameters.iter().zip(end).map(|(parameter, value)| (parameter, value, parameter.share(*value)));
        pairs.map(|(p, value, share)| if outer(&share) { p.at(near(share)) } else { *value }).collect()
    };
    let points: Vec<Vec<f64>> = runs.iter().map(|run| met(&run.end)).collect();
    let fits = basis.fits(evaluator, &points)?;
    for ((run, point), fit) in runs.iter_mut().zip(points).zip(fits) {
        // No worse: within the rounding of a norm.
        if let Some(fit) = fit.filter(|fit| fit.norm <= run.norm * (1.0 + 1e-9) + 1e-12) {
            (run.end, run.norm) = (point, fit.norm);
        }
    }
    Ok(())
}
