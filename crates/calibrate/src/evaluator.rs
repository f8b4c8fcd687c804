//! The one door to the model: looks up, evaluates what is not known, keeps it, tells how far it is.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::forward::{Evaluation, Failure, Forward, Map, Request, Response, STOPPED, Samples};
use crate::log::Log;
use crate::problem::Problem;
use crate::watch::{Progress, Stopped, Watch};

/// A problem, its model and all that is known of it.
pub struct Evaluator<'a> {
    /// What is fitted to what.
    pub problem: &'a Problem,
    pub(crate) forward: &'a dyn Forward,
    map: &'a dyn Map,
    /// Who looks on.
    pub watch: &'a mut dyn Watch,
    /// All that is known.
    pub log: Log,
    keeps: bool,
    /// What is being done now.
    pub(crate) stage: String,
    /// Evaluations of the search at hand, each point once, those that the log knew included.
    pub done: usize,
    /// Evaluations that the model really did since this door was opened.
    pub computed: usize,
    planned: Option<usize>,
}

impl<'a> Evaluator<'a> {
    /// A door with a log, which is empty or read back from an earlier run. Answers in a log that do not have the shape of the
    /// problem are dropped and found anew.
    pub fn new(
        problem: &'a Problem,
        forward: &'a dyn Forward,
        map: &'a dyn Map,
        watch: &'a mut dyn Watch,
        mut log: Log,
    ) -> Self {
        log.keep_sound(|request, axes, evaluation| {
            let shaped = evaluation.is_err() || sound(problem, forward, request, evaluation.clone()).is_ok();
            axes == problem.parameters().len() && shaped
        });
        let stage = String::new();
        Self { problem, forward, map, watch, log, keeps: true, stage, done: 0, computed: 0, planned: None }
    }

    /// A door that remembers nothing, for models that answer faster than a log, as surrogates do.
    pub fn without_log(
        problem: &'a Problem,
        forward: &'a dyn Forward,
        map: &'a dyn Map,
        watch: &'a mut dyn Watch,
    ) -> Self {
        Self { keeps: false, ..Self::new(problem, forward, map, watch, Log::new("")) }
    }

    /// A search begins, with so many evaluations planned at the most.
    pub(crate) fn begin(&mut self, planned: Option<usize>) {
        (self.done, self.planned) = (0, planned);
        self.log.begin_search();
    }

    /// Answers at many points, in their order. What the log knows is not evaluated again.
    ///
    /// # Errors
    /// A stop by the onlooker; a point without an answer is none.
    pub fn respond(&mut self, points: &[Vec<f64>], request: &Request) -> Result<Vec<Arc<Evaluation>>, Stopped> {
        if !self.keeps {
            let answers = self.evaluate(points, request)?;
            self.done += points.len();
            return Ok(answers.into_iter().map(Arc::new).collect());
        }
        let mut seen = BTreeSet::new();
        let unknown = |point: &&Vec<f64>| self.log.get(point, request).is_none();
        let unknown: Vec<&Vec<f64>> = points.iter().filter(unknown).collect();
        let fresh = |point: &&Vec<f64>| seen.insert(point.iter().map(|value| value.to_bits()).collect::<Vec<_>>());
        let unknown: Vec<Vec<f64>> = unknown.into_iter().filter(fresh).cloned().collect();
        for lot in unknown.chunks(self.map.at_once().max(1)) {
            let answers = self.evaluate(lot, request)?;
            let mut stopped = false;
            for (point, answer) in lot.iter().zip(answers) {
                if answer.as_ref().is_err_and(|failure| failure.code == STOPPED) {
                    stopped = true;
                    continue;
                }
                let wanted = self.watch.keeps();
                let line = self.log.add(point, request, answer, wanted);
                if wanted {
                    self.watch.keep(&line);
                }
            }
            if stopped {
                return Err(Stopped);
            }
        }
        let mut answers = Vec::with_capacity(points.len());
        for point in points {
            self.done += usize::from(self.log.uses(point, request));
            let absent = || Arc::new(Err(Failure::new("no-answer", "the model gave no answer")));
            answers.push(self.log.get(point, request).unwrap_or_else(absent));
        }
        Ok(answers)
    }

    fn evaluate(&mut self, points: &[Vec<f64>], request: &Request) -> Result<Vec<Evaluation>, Stopped> {
        let to_come = self.planned.map(|planned| planned.saturating_sub(self.done));
        let progress = Progress { stage: self.stage.clone(), done: self.done, to_come };
        self.watch.look(&progress)?;
        let (problem, forward, watch) = (self.problem, self.forward, &mut *self.watch);
        let mut stopped = false;
        let mut look = || {
            if !stopped && watch.look(&progress).is_err() {
                stopped = true;
                forward.stop();
            }
        };
        let work = |point: &[f64]| sound(problem, forward, request, forward.evaluate(point, request));
        let mut answers = self.map.map(points, &work, &mut look);
        let short = || Err(Failure::new("no-answer", "the caller's map lost this point"));
        answers.resize_with(points.len(), short);
        self.computed += points.len();
        Ok(answers)
    }
}

/// An answer in the shape of the request with finite values, or a failure that says what is amiss.
fn sound(problem: &Problem, forward: &dyn Forward, request: &Request, evaluation: Evaluation) -> Evaluation {
    let response: Response = evaluation?;
    let channels = problem.channels();
    let wanted = |k: usize| match &request.samples {
        Samples::All => channels[k].history.as_ref().map_or_else(|| forward.length(k), Vec::len),
        Samples::At(places) => places.get(k).map_or(0, Vec::len),
    };
    let derivatives = if request.sensitivities { problem.parameters().len() } else { 0 };
    let wrong = |message: String| Err(Failure::new("wrong-shape", message));
    if response.derivatives.len() != derivatives {
        return wrong(format!("{} sets of derivatives came for {derivatives}", response.derivatives.len()));
    }
    for table in std::iter::once(&response.values).chain(&response.derivatives) {
        if table.len() != channels.len() {
            return wrong(format!("{} channels were computed, {} are measured", table.len(), channels.len()));
        }
        for (k, row) in table.iter().enumerate() {
            let name = &channels[k].name;
            if row.len() != wanted(k) {
                return wrong(format!("channel {name}: {} values were computed for {}", row.len(), wanted(k)));
            }
            if row.iter().any(|value| !value.is_finite()) {
                return Err(Failure::new("not-finite", format!("channel {name}: a value is no finite number")));
            }
        }
    }
    Ok(response)
}
