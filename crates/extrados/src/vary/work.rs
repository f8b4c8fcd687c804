//! Makes the runs, several at once, and keeps each as soon as it is finished.

use super::Studied;
use super::runs::{Job, Runs};
use crate::means::Means;
use crate::refusal::Refusal;
use crate::watch::{Crowd, Watch};
use assess::vary::Analysis;
use outcome::collapse::Status;
use outcome::published;
use outcome::study::Outcome;
use rayon::prelude::*;
use std::io;

/// What every run is made with.
pub(super) struct Work<'a> {
    pub analysis: &'a Analysis,
    /// The shelf and the clock.
    pub means: &'a Means<'a>,
}

/// A finished run.
#[derive(Debug, Clone)]
pub(super) struct Finished {
    /// What it gave.
    pub outcome: Outcome,
    /// How long it took when it was computed [s].
    pub seconds: f64,
    /// Whether it was there already.
    pub cached: bool,
}

impl Work<'_> {
    /// All jobs, in any order: for each run what it gave, nothing where the work was stopped; and what came of them.
    pub(super) fn all(&self, runs: &Runs, watch: &mut dyn Watch) -> Result<(Option<Vec<Finished>>, Studied), Refusal> {
        let (made, trouble) = self.some(&runs.jobs.iter().collect::<Vec<_>>(), watch);
        let finished = runs.job_of.iter().filter(|job| made[**job].is_some()).count();
        let all: Option<Vec<Finished>> = made.into_iter().collect();
        // The file's own bridge must be one that the analysis can be made of; there is nothing to compare with otherwise.
        if let Some(message) = all.as_ref().and_then(|all| all[runs.job_of[0]].outcome.message.as_ref()) {
            return Err(Refusal::not_set_up(message));
        }
        let rows = all.map(|all| runs.job_of.iter().map(|job| all[*job].clone()).collect());
        Ok((rows, Studied { study: None, finished, runs: runs.list.len(), trouble }))
    }

    /// These jobs: what each gave, nothing where the work was stopped; and what kept a finished one from being kept.
    pub(super) fn some(&self, jobs: &[&Job], watch: &mut dyn Watch) -> (Vec<Option<Finished>>, Option<io::Error>) {
        let crowd = Crowd::new(watch, jobs.len());
        let made: Vec<Option<(Finished, io::Result<()>)>> =
            jobs.par_iter().with_max_len(1).map(|job| self.one(job, &crowd)).collect();
        let mut trouble = None;
        let made = made.into_iter().map(|one| {
            let (finished, kept) = one?;
            trouble = trouble.take().or(kept.err());
            Some(finished)
        });
        (made.collect(), trouble)
    }

    /// One job, from the shelf or computed; nothing where the work was stopped.
    fn one(&self, job: &Job, crowd: &Crowd<'_>) -> Option<(Finished, io::Result<()>)> {
        let mut member = crowd.member();
        let kept = self.means.shelf.find(&job.key).and_then(|bytes| published::run_from_record(&bytes));
        if let Some((outcome, seconds)) = kept {
            member.finish();
            return Some((Finished { outcome, seconds, cached: true }, Ok(())));
        }
        if crowd.stopped() {
            return None;
        }
        let begun = (self.means.clock)();
        let seconds = || (self.means.clock)() - begun;
        let outcome = match (self.analysis.run)(&job.bridge, &mut member) {
            Ok(outcome) => outcome,
            Err(error) => {
                let (status, message) = ("unusable-input".to_owned(), Some(error.to_string()));
                member.finish();
                let outcome = Outcome { status, message, ..Outcome::default() };
                return Some((Finished { outcome, seconds: seconds(), cached: false }, Ok(())));
            }
        };
        if outcome.status == Status::Cancelled.word() {
            return None;
        }
        member.finish();
        let seconds = seconds();
        let kept = self.means.shelf.put(&job.key, published::run_record(&outcome, seconds).as_bytes());
        Some((Finished { outcome, seconds, cached: false }, kept))
    }
}
