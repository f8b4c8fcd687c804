//! Makes the runs, several at once, and keeps each as soon as it is finished.

use super::task::{Job, Task};
use crate::cache::Cache;
use crate::clock::Clock;
use crate::failure::Failure;
use crate::results;
use crate::status::Status;
use crate::watcher::{self, Shared};
use assess::vary::{Analysis, Outcome};
use rayon::prelude::*;
use std::io;

/// What every run is made with.
pub struct Work<'a> {
    /// The analysis.
    pub analysis: &'a Analysis,
    /// Where finished runs are.
    pub cache: &'a Cache,
    /// Whether progress is unwanted.
    pub quiet: bool,
}

/// A finished run.
#[derive(Debug, Clone)]
pub struct Finished {
    /// What it gave.
    pub outcome: Outcome,
    /// How long it took when it was computed [s].
    pub seconds: f64,
    /// Whether it was there already.
    pub cached: bool,
}

/// What came of a task.
pub struct Found {
    /// For each run, what it gave; nothing where the command was interrupted.
    pub rows: Option<Vec<Finished>>,
    /// Runs that are finished.
    pub finished: usize,
    /// Runs there are.
    pub runs: usize,
    /// What kept a finished run from being kept.
    pub trouble: Option<io::Error>,
}

impl Work<'_> {
    /// All jobs of a task, in any order; their answers in the order of its runs.
    pub fn all(&self, task: &Task) -> Result<Found, Failure> {
        let bar = Shared::new(self.quiet, task.jobs.len());
        let made: Vec<Option<(Finished, io::Result<()>)>> =
            task.jobs.par_iter().with_max_len(1).map(|job| self.one(job, &bar)).collect();
        bar.finish();
        let mut trouble = None;
        let made: Vec<Option<Finished>> = made
            .into_iter()
            .map(|one| {
                let (finished, kept) = one?;
                trouble = trouble.take().or(kept.err());
                Some(finished)
            })
            .collect();
        let finished = task.job_of.iter().filter(|job| made[**job].is_some()).count();
        let all: Option<Vec<Finished>> = made.into_iter().collect();
        if let Some(message) = all.as_ref().and_then(|all| not_set_up(&all[task.job_of[0]])) {
            return Err(message);
        }
        let rows = all.map(|all| task.job_of.iter().map(|job| all[*job].clone()).collect());
        Ok(Found { rows, finished, runs: task.runs.len(), trouble })
    }

    /// One job, from the cache or computed; nothing where the command was asked to stop.
    fn one(&self, job: &Job, bar: &Shared) -> Option<(Finished, io::Result<()>)> {
        let mut onlooker = bar.onlooker();
        if let Some((outcome, seconds)) = self.cache.get(&job.key) {
            onlooker.finish();
            return Some((Finished { outcome, seconds, cached: true }, Ok(())));
        }
        if watcher::asked_to_stop() {
            return None;
        }
        let clock = Clock::start();
        let outcome = match (self.analysis.run)(&job.bridge, &mut onlooker) {
            Ok(outcome) => outcome,
            Err(error) => {
                let message = Some(error.to_string());
                let status = Status::UnusableInput.name().to_owned();
                let outcome = Outcome { status, message, ..Outcome::default() };
                onlooker.finish();
                return Some((Finished { outcome, seconds: clock.seconds(), cached: false }, Ok(())));
            }
        };
        if outcome.status == Status::Cancelled.name() {
            return None;
        }
        onlooker.finish();
        let seconds = clock.seconds();
        let kept = self.cache.put(&job.key, &outcome, seconds);
        Some((Finished { outcome, seconds, cached: false }, kept))
    }
}

/// The file's own bridge must be one that the analysis can be made of; there is nothing to compare with otherwise.
fn not_set_up(own: &Finished) -> Option<Failure> {
    own.outcome.message.as_ref().map(|message| results::cannot_be_set_up(message))
}
