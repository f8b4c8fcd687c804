//! Who looks on: one trait for every analysis.

pub use mechanics::watch::{Progress, Wish};

use crate::shelf::Shelf;
use calibrate::Watch as Searching;
use std::sync::{Mutex, PoisonError};

/// Someone who looks on. It hears how far the work is and may end it; it is offered the state of a run.
pub trait Watch: Send {
    /// A part of the work begins, such as a stage of an assessment.
    fn begin(&mut self, _part: &str) {}

    /// Tells how far the work is; after [`Wish::Stop`] it ends as soon as its state is consistent, and says so in the outcome.
    fn look(&mut self, progress: &Progress) -> Wish;

    /// Offers the state of a collapse as bytes, from which it goes on to the same bits. `state` is only called by who wants to keep it.
    fn keep(&mut self, _state: &dyn Fn() -> Vec<u8>) {}
}

/// Nobody looks on.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unwatched;

impl Watch for Unwatched {
    fn look(&mut self, _: &Progress) -> Wish {
        Wish::GoOn
    }
}

/// A function that is told how far the work is.
impl<F: FnMut(&Progress) -> Wish + Send> Watch for F {
    fn look(&mut self, progress: &Progress) -> Wish {
        self(progress)
    }
}

/// An onlooker as the analyses of [`crate::results`] know one.
pub struct Looking<'a>(pub &'a mut dyn Watch);

impl mechanics::watch::Watch for Looking<'_> {
    fn look(&mut self, progress: &Progress) -> Wish {
        self.0.look(progress)
    }

    fn keep(&mut self, state: &dyn Fn() -> Vec<u8>) {
        self.0.keep(state);
    }
}

/// An onlooker as searches for parameters know one; finished evaluations go to a shelf.
pub(crate) struct Seeking<'a> {
    pub watch: &'a mut dyn Watch,
    pub shelf: &'a dyn Shelf,
}

impl Searching for Seeking<'_> {
    fn look(&mut self, progress: &calibrate::Progress) -> Result<(), calibrate::Stopped> {
        let left = progress.to_come.map_or(String::new(), |left| format!(", at most {left} to come"));
        let whole = progress.to_come.map(|left| (progress.done + left).max(1) as f64);
        let told = Progress {
            stage: format!("{}: {}{left}", progress.stage, outcome::counted(progress.done, "evaluation")),
            fraction: whole.map(|whole| progress.done as f64 / whole),
            steps: 0,
        };
        match self.watch.look(&told) {
            Wish::GoOn => Ok(()),
            Wish::Stop => Err(calibrate::Stopped),
        }
    }

    fn keep(&mut self, line: &str) {
        self.shelf.append(line);
    }

    fn keeps(&self) -> bool {
        self.shelf.appends()
    }
}

/// An onlooker that several runs share: it hears how far all of them are together.
pub(crate) struct Crowd<'a>(Mutex<Together<'a>>);

struct Together<'a> {
    watch: &'a mut dyn Watch,
    shares: f64,
    runs: usize,
    stopped: bool,
}

impl<'a> Crowd<'a> {
    /// For so many runs.
    pub(crate) fn new(watch: &'a mut dyn Watch, runs: usize) -> Crowd<'a> {
        Crowd(Mutex::new(Together { watch, shares: 0.0, runs, stopped: false }))
    }

    /// Who looks on one of the runs.
    pub(crate) fn member(&self) -> Member<'_, 'a> {
        Member { crowd: self, share: 0.0 }
    }

    /// Whether the work is to end.
    pub(crate) fn stopped(&self) -> bool {
        self.tell(0.0) == Wish::Stop
    }

    fn tell(&self, more: f64) -> Wish {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        all.shares += more;
        let stage = format!("{} of {} runs", (all.shares + 1e-9).floor(), all.runs);
        let fraction = Some(all.shares / all.runs.max(1) as f64);
        // Who stopped has stopped all of them.
        all.stopped |= all.watch.look(&Progress { stage, fraction, steps: 0 }) == Wish::Stop;
        if all.stopped { Wish::Stop } else { Wish::GoOn }
    }
}

/// Looks on one run of several.
pub(crate) struct Member<'c, 'a> {
    crowd: &'c Crowd<'a>,
    share: f64,
}

impl Member<'_, '_> {
    /// The run is done.
    pub(crate) fn finish(&mut self) {
        self.come_to(1.0);
    }

    fn come_to(&mut self, share: f64) -> Wish {
        let more = (share - self.share).max(0.0);
        self.share += more;
        self.crowd.tell(more)
    }
}

impl mechanics::watch::Watch for Member<'_, '_> {
    fn look(&mut self, progress: &Progress) -> Wish {
        // The end is told by who finishes.
        self.come_to(progress.fraction.map_or(0.0, |fraction| fraction.clamp(0.0, 0.999)))
    }
}

/// An onlooker that remembers whether it wished to stop.
pub(crate) struct Remembering<'a> {
    pub watch: &'a mut dyn Watch,
    pub stopped: bool,
}

impl Watch for Remembering<'_> {
    fn begin(&mut self, part: &str) {
        self.watch.begin(part);
    }

    fn look(&mut self, progress: &Progress) -> Wish {
        self.stopped |= self.watch.look(progress) == Wish::Stop;
        if self.stopped { Wish::Stop } else { Wish::GoOn }
    }

    fn keep(&mut self, state: &dyn Fn() -> Vec<u8>) {
        self.watch.keep(state);
    }
}
