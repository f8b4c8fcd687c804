//! Predictions: one run for each test, method and end of the intervals.

use super::corpus::{Corpus, Test};
use super::document::{Level, Side, bridge_of, document};
use super::priors::Priors;
use super::statistics::bias;
use assess::analysis;
use mechanics::watch::Watch;
use outcome::collapse::{Collapse, Status};
use outcome::validation::{Prediction, Predictor, Tested, Validation};
use serde::{Deserialize, Serialize};
use std::time::Instant;

/// One analysis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Job {
    /// Number of the test.
    pub test: usize,
    /// The method.
    pub by: Predictor,
    /// At which end of the intervals: of priors, and of remembered dimensions.
    pub at: (Level, Option<Side>),
    /// Of particles: the seed of the packing.
    pub seed: u64,
}

/// What one analysis gave: loads on the whole width.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Answer {
    /// How it ended, or why it could not begin.
    pub ended: String,
    /// Load that is carried [N].
    pub load: Option<f64>,
    /// Whether the bridge does not stand under its own weight.
    pub falls: bool,
    /// The same where joints never crush [N], of limit analysis.
    #[serde(default)]
    pub without_crushing: Option<f64>,
    /// Of a continuum: upper bound [N].
    pub upper_bound: Option<f64>,
    /// Of a continuum: lower bound with half of the strength [N].
    pub half_strength: Option<f64>,
    /// Of a continuum: lower bound where soil dilates by its friction angle [N].
    pub dilating: Option<f64>,
    /// Time [s].
    pub seconds: f64,
    /// The bridge file that was analysed.
    pub bridge_file: String,
}

impl Job {
    /// How long it takes, roughly, in runs by weight alone.
    pub fn effort(&self) -> u64 {
        match self.by {
            Predictor::Weight | Predictor::Pressure => 1,
            Predictor::Path => 10,
            Predictor::Movement => 20,
            Predictor::Continuum if self.at == (Level::Expected, None) => 250,
            Predictor::Continuum => 100,
            Predictor::Particles => 3000,
        }
    }
}

/// Ends of the intervals of a test: as expected, priors at both ends, and remembered dimensions with them.
pub(super) fn ends(test: &Test) -> Vec<(Level, Option<Side>)> {
    let mut ends = vec![(Level::Expected, None), (Level::Least, None), (Level::Most, None)];
    if test.field.recalled().next().is_some() {
        ends.extend([(Level::Least, Some(Side::Weak)), (Level::Most, Some(Side::Strong))]);
    }
    ends
}

/// Every run for these methods, the long ones first. Particles run with expected values alone, in several packings.
pub fn jobs(corpus: &Corpus, methods: &[Predictor]) -> Vec<Job> {
    let mut jobs = Vec::new();
    for (number, test) in corpus.tests.iter().enumerate() {
        for &by in methods {
            if by == Predictor::Particles {
                let at = (Level::Expected, None);
                jobs.extend((1..=corpus.priors.stated.packings).map(|seed| Job { test: number, by, at, seed }));
            } else {
                jobs.extend(ends(test).into_iter().map(|at| Job { test: number, by, at, seed: 1 }));
            }
        }
    }
    jobs.sort_by_key(|job| std::cmp::Reverse(job.effort()));
    jobs
}

/// Makes one run.
pub fn predict(corpus: &Corpus, job: &Job, watch: &mut dyn Watch) -> Answer {
    let start = Instant::now();
    let mut answer = match analysed(&corpus.tests[job.test], &corpus.priors, job, watch) {
        Ok((found, bridge_file)) => Answer { bridge_file, ..answered(&found) },
        Err(reason) => Answer { ended: reason, ..Answer::default() },
    };
    answer.seconds = start.elapsed().as_secs_f64();
    answer
}

fn analysed(test: &Test, priors: &Priors, job: &Job, watch: &mut dyn Watch) -> Result<(Collapse, String), String> {
    let mut document = document(test, priors, job.by, job.at)?;
    if job.by == Predictor::Particles {
        stepped(test, priors, job, &mut document, watch)?;
    }
    let bridge = bridge_of(&document)?;
    let found = match (job.by, job.at) {
        (Predictor::Continuum, at) if at != (Level::Expected, None) => {
            analysis::engine::continuum::with_strength_of_the_file(&bridge, watch)
        }
        // With the help that the method counts on: the prediction is the method's.
        _ => analysis::as_described(&bridge, None, watch),
    };
    let found = found.map_err(|error| error.to_string())?;
    Ok((found, toml::to_string(&document).map_err(|error| error.to_string())?))
}

/// Load steps of discrete elements over the load that fill as weight carries, and how far they go over it.
const STEP: f64 = 0.05;
const FARTHEST: f64 = 10.0;

/// Seed and load steps for discrete elements, these by the load that fill as weight carries: never by that of the test.
fn stepped(
    test: &Test,
    priors: &Priors,
    job: &Job,
    document: &mut toml::Table,
    watch: &mut dyn Watch,
) -> Result<(), String> {
    let plain = bridge_of(&super::document::document(test, priors, Predictor::Weight, job.at)?)?;
    let found = analysis::collapse(&plain, None, watch).map_err(|error| error.to_string())?;
    let load = found.headline().ok_or("the ring carries no load with fill as weight: there is no load step")?.load;
    let plan = document.get_mut("analysis").and_then(toml::Value::as_table_mut).ok_or("there is no plan")?;
    for (key, times) in [("load_step", STEP), ("load_limit", FARTHEST)] {
        plan.insert(key.into(), format!("{:.4} kN/m", times * load / 1e3).into());
    }
    plan.insert("seed".into(), toml::Value::Integer(job.seed as i64));
    Ok(())
}

fn answered(found: &Collapse) -> Answer {
    let soil = found.limit().and_then(|limit| limit.continuum.as_ref());
    Answer {
        ended: found.status.word().to_owned(),
        load: found.headline().map(|headline| headline.whole),
        falls: found.status == Status::UnstableUnderSelfWeight,
        without_crushing: found.limit().and_then(|limit| limit.unlimited_strength_load).map(|load| load * found.width),
        upper_bound: soil.and(found.collapse_load).map(|load| load * found.width),
        half_strength: soil.and_then(|soil| soil.range).map(|range| range[0] * found.width),
        dilating: soil.and_then(|soil| soil.associated).map(|bounds| bounds[0] * found.width),
        ..Answer::default()
    }
}

/// Puts answers together: predictions of every test, and what they come to.
pub fn gather(corpus: &Corpus, methods: &[Predictor], answers: &[(Job, Answer)]) -> Validation {
    let tests = corpus.tests.iter().enumerate().map(|(number, test)| {
        let of = |by: Predictor| answers.iter().filter(move |(job, _)| job.test == number && job.by == by);
        let predictions = methods.iter().filter_map(|&by| prediction(by, &of(by).collect::<Vec<_>>()));
        Tested {
            name: test.name.clone(),
            title: test.field.title.clone(),
            carried: 1e3 * test.field.failure_load_kn,
            carried_mark: test.field.failure_load_mark.word().to_owned(),
            failed: test.field.failed.clone(),
            doubt: test.field.doubt.clone(),
            recalled: test.field.recalled().map(|one| one.key.clone()).collect(),
            predictions: predictions.collect(),
        }
    });
    let tests: Vec<Tested> = tests.collect();
    let statistics = methods.iter().map(|&by| bias(by, &tests)).collect();
    Validation { tests, statistics }
}

fn prediction(by: Predictor, answers: &[&(Job, Answer)]) -> Option<Prediction> {
    let at = |level, side| answers.iter().find(|(job, _)| job.at == (level, side)).map(|(_, answer)| answer);
    let expected = at(Level::Expected, None)?;
    let priors = [("least priors", at(Level::Least, None)), ("largest priors", at(Level::Most, None))];
    let dimensions = [
        ("least priors and weak dimensions", at(Level::Least, Some(Side::Weak))),
        ("largest priors and strong dimensions", at(Level::Most, Some(Side::Strong))),
    ];
    let load = |answer: &Answer| answer.load.or(answer.falls.then_some(0.0));
    let span = |ends: &[(&str, Option<&Answer>)]| {
        let loads = || ends.iter().filter_map(|(_, answer)| load((*answer)?)).chain(load(expected));
        Some([loads().reduce(f64::min)?, loads().reduce(f64::max)?])
    };
    let asked = |ends: &[(&str, Option<&Answer>)]| ends.iter().any(|(_, answer)| answer.is_some());
    let every = [priors, dimensions].concat();
    let without = priors.iter().chain(&dimensions).filter_map(|(words, answer)| Some((words, (*answer)?)));
    let without = without.filter(|(_, answer)| answer.load.is_none());
    let packings: Vec<&(Job, Answer)> =
        answers.iter().copied().filter(|(job, _)| job.by == Predictor::Particles).collect();
    let by_packings: Vec<f64> = packings.iter().filter_map(|(_, answer)| answer.load).collect();
    let failed = packings.iter().filter(|(_, answer)| answer.load.is_none() && packings.len() > 1);
    let failed = failed.map(|(job, answer)| format!("seed {}: {}", job.seed, answer.ended));
    let mean = by_packings.iter().sum::<f64>() / by_packings.len() as f64;
    let least_and_most = [f64::min, f64::max].map(|by| by_packings.iter().copied().reduce(by).unwrap_or(0.0));
    Some(Prediction {
        by,
        load: if by_packings.is_empty() { expected.load } else { Some(mean) },
        ended: expected.ended.clone(),
        by_priors: asked(&priors).then(|| span(&priors)).flatten(),
        by_dimensions: asked(&dimensions).then(|| span(&every)).flatten(),
        by_packings: (by_packings.len() > 1).then_some(least_and_most),
        without: without.map(|(words, answer)| format!("{words}: {}", answer.ended)).chain(failed).collect(),
        without_crushing: expected.without_crushing,
        upper_bound: expected.upper_bound,
        half_strength: expected.half_strength,
        dilating: expected.dilating,
        seconds: answers.iter().map(|(_, answer)| answer.seconds).sum(),
        bridge_file: expected.bridge_file.clone(),
    })
}
