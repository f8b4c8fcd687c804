//! Runs that survive, and the same bits whatever the map.

use std::fmt::Debug;

use crate::common::{five_model, five_problem};
use calibrate::misfit::Misfit;
use calibrate::posterior::{self, Likelihood, ModelError};
use calibrate::search::{gradient, hierarchical, modern, referee};
use calibrate::{Basis, Evaluation, Evaluator, Log, Map, Problem, Progress, Serial, Start, Stopped, Unwatched, Watch};
use rayon::prelude::*;

const TRUTH: [f64; 5] = [1.2, 0.8, 1.1, 0.7, 1.3];

/// Keeps the log as a file would, and stops after so many lots.
struct File {
    text: String,
    lots: usize,
}

impl Watch for File {
    fn look(&mut self, progress: &Progress) -> Result<(), Stopped> {
        assert!(!progress.stage.is_empty());
        self.lots = self.lots.saturating_sub(1);
        if self.lots == 0 { Err(Stopped) } else { Ok(()) }
    }

    fn keep(&mut self, line: &str) {
        self.text += line;
        self.text.push('\n');
    }

    fn keeps(&self) -> bool {
        true
    }
}

/// Threads, in lots of some size.
struct Threads(usize);

impl Map for Threads {
    fn map(
        &self,
        points: &[Vec<f64>],
        work: &(dyn Fn(&[f64]) -> Evaluation + Sync),
        _: &mut dyn FnMut(),
    ) -> Vec<Evaluation> {
        points.par_iter().map(|point| work(point)).collect()
    }

    fn at_once(&self) -> usize {
        self.0
    }
}

fn problem() -> Problem {
    five_problem(&TRUTH, Misfit { slices: true, ..Misfit::default() })
}

/// A search with everything that it reports as one text.
type Search = fn(&mut Evaluator, &Basis) -> String;

fn searches() -> Vec<(&'static str, Search)> {
    fn text(outcome: impl Debug) -> String {
        format!("{outcome:?}")
    }
    vec![
        ("hierarchical", |e, b| text(hierarchical::search(e, b, &hierarchical::Settings::default()))),
        ("modern", |e, b| text(modern::search(e, b, &modern::Settings::default()))),
        ("referee", |e, b| text(referee::search(e, b, 1, 12))),
        ("gradient", |e, b| text(gradient::search(e, b, Start::Means, 30))),
    ]
}

#[test]
fn a_search_killed_at_any_place_ends_in_the_same_numbers_and_does_nothing_twice() {
    let (problem, model) = (problem(), five_model());
    for (name, search) in searches() {
        let mut watch = Unwatched;
        let mut evaluator = Evaluator::new(&problem, &model, &Serial, &mut watch, Log::new("five"));
        let basis = Basis::at(&mut evaluator, &problem.start()).unwrap();
        let whole = search(&mut evaluator, &basis);
        let computed = evaluator.computed;
        for share in [0.1, 0.5, 0.9] {
            let lots = 2 + (share * computed as f64) as usize;
            let mut file = File { text: Log::new("five").head() + "\n", lots };
            let mut killed = Evaluator::new(&problem, &model, &Serial, &mut file, Log::new("five"));
            let basis = Basis::at(&mut killed, &problem.start()).unwrap();
            assert_ne!(search(&mut killed, &basis), whole, "{name} was stopped");
            let before = killed.computed;
            // The last line is torn, as by a kill.
            let torn = &file.text[..file.text.len() - 5];
            let (log, broken) = Log::read("five", torn).unwrap();
            assert_eq!((log.len(), broken), (before - 1, 1), "{name}");
            let mut watch = Unwatched;
            let mut resumed = Evaluator::new(&problem, &model, &Serial, &mut watch, log);
            let basis = Basis::at(&mut resumed, &problem.start()).unwrap();
            assert_eq!(search(&mut resumed, &basis), whole, "{name} at {share}");
            assert_eq!(resumed.computed + before - 1, computed, "{name}: no evaluation twice");
        }
    }
}

#[test]
fn every_search_gives_the_same_bits_whatever_the_map() {
    let (problem, model) = (problem(), five_model());
    for (name, search) in searches() {
        let by = |map: &dyn Map| {
            let mut watch = Unwatched;
            let mut evaluator = Evaluator::new(&problem, &model, map, &mut watch, Log::new("five"));
            let basis = Basis::at(&mut evaluator, &problem.start()).unwrap();
            (search(&mut evaluator, &basis), evaluator.log.text())
        };
        for lot in [2, 7, 1000] {
            assert!(by(&Serial) == by(&Threads(lot)), "{name} in lots of {lot}");
        }
    }
}

#[test]
fn a_posterior_is_the_same_by_threads_and_after_a_kill() {
    let mut channels = problem().channels().to_vec();
    for channel in &mut channels {
        channel.uncertainty = Some(0.05 * channel.measured_peak().unwrap().abs());
    }
    let problem = Problem::new(problem().parameters().to_vec(), channels, Misfit::default()).unwrap();
    let settings = posterior::Settings {
        likelihood: Likelihood { model_error: ModelError::Sought(0.05), block: None, common_gain: 0.0 },
        particles: 48,
        moves: 2,
        walkers: 14,
        steps: 60,
        ..posterior::Settings::default()
    };
    let model = five_model();
    let by = |map: &dyn Map, watch: &mut dyn Watch, log: Log| {
        let mut evaluator = Evaluator::new(&problem, &model, map, watch, log);
        let basis = Basis::at(&mut evaluator, &problem.start()).unwrap();
        let found = posterior::sample(&mut evaluator, &basis, &settings).unwrap();
        (found.status, format!("{found:?}"), evaluator.computed)
    };
    let whole = by(&Serial, &mut Unwatched, Log::new("five"));
    assert_eq!(by(&Threads(7), &mut Unwatched, Log::new("five")), whole);
    let mut file = File { text: Log::new("five").head() + "\n", lots: whole.2 / 2 };
    let killed = by(&Serial, &mut file, Log::new("five"));
    assert_eq!(killed.0, posterior::Status::Stopped);
    let resumed = by(&Serial, &mut Unwatched, Log::read("five", &file.text).unwrap().0);
    assert_eq!((resumed.1, resumed.2 + killed.2), (whole.1, whole.2));
}

#[test]
fn answers_of_another_shape_are_dropped_from_a_log() {
    let (problem, model) = (problem(), five_model());
    let mut watch = Unwatched;
    let mut evaluator = Evaluator::new(&problem, &model, &Serial, &mut watch, Log::new("five"));
    Basis::at(&mut evaluator, &problem.start()).unwrap();
    let text = evaluator.log.text();
    let fewer =
        Problem::new(problem.parameters().to_vec(), problem.channels()[..4].to_vec(), Misfit::default()).unwrap();
    let four =
        crate::common::Function { channels: 4, length: 60, values: |x: &[f64]| crate::common::five(x)[..4].to_vec() };
    let mut watch = Unwatched;
    let (log, _) = Log::read("five", &text).unwrap();
    let mut evaluator = Evaluator::new(&fewer, &four, &Serial, &mut watch, log);
    Basis::at(&mut evaluator, &fewer.start()).unwrap();
    assert_eq!((evaluator.computed, evaluator.log.len()), (1, 1));
}
