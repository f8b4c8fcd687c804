//! Many pieces of work side by side, one onlooker. Results come in the order of the work, whoever did it.

use crate::analysis::{AnalysisError, parallel};
use mechanics::watch::{Progress, Watch, Wish};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;

/// Why the work of a calibration ends before its end.
#[derive(Debug)]
pub(super) enum Halt {
    /// The onlooker stopped it.
    Stopped,
    Failed(AnalysisError),
}

impl<E: Into<AnalysisError>> From<E> for Halt {
    fn from(error: E) -> Halt {
        Halt::Failed(error.into())
    }
}

/// The onlooker, and how much of the work is done.
pub(super) struct Crowd<'a> {
    watch: &'a mut dyn Watch,
    done: f64,
    all: f64,
    steps: u64,
}

/// What a worker tells.
enum Said<R> {
    /// It took so many steps more.
    Going { steps: u64 },
    /// A piece is finished: its number, and what came out.
    Finished(usize, R),
}

impl<'a> Crowd<'a> {
    /// For so much work in all, in the unit of `weight` below.
    pub(super) fn new(watch: &'a mut dyn Watch, all: f64) -> Crowd<'a> {
        Crowd { watch, done: 0.0, all, steps: 0 }
    }

    /// Corrects how much work there is in all.
    pub(super) fn plan(&mut self, all: f64) {
        self.all = all;
    }

    /// Does `work` on every item; each counts as `weight`.
    pub(super) fn each<T: Sync, R: Send, E: Send>(
        &mut self,
        stage: &str,
        weight: f64,
        items: &[T],
        work: impl Fn(&T, &mut dyn Watch) -> Result<R, E> + Sync,
    ) -> Result<Vec<R>, Halt>
    where
        Halt: From<E>,
    {
        let stop = AtomicBool::new(false);
        let mut found: Vec<Option<Result<R, E>>> = items.iter().map(|_| None).collect();
        let mut finished = 0;
        let mut hear = |said: Option<Said<Result<R, E>>>| {
            match said {
                Some(Said::Going { steps }) => self.steps += steps,
                Some(Said::Finished(k, result)) => {
                    found[k] = Some(result);
                    finished += 1;
                    self.done += weight;
                }
                None => {}
            }
            let progress = Progress {
                stage: format!("{stage} {finished} of {}", items.len()),
                fraction: Some((self.done / self.all).clamp(0.0, 1.0)),
                steps: self.steps,
            };
            if self.watch.look(&progress) == Wish::Stop {
                stop.store(true, Ordering::Relaxed);
            }
        };
        parallel::told(items, &mut hear, |k, item, tell| {
            if !stop.load(Ordering::Relaxed) {
                let result = work(item, &mut Member { tell, stop: &stop, told: 0 });
                // Nobody listens only where the crowd itself is gone.
                let _ = tell.send(Said::Finished(k, result));
            }
        });
        if stop.load(Ordering::Relaxed) {
            return Err(Halt::Stopped);
        }
        found.into_iter().flatten().map(|result| Ok(result?)).collect()
    }
}

/// The onlooker as one worker sees it.
struct Member<'a, R> {
    tell: &'a Sender<Said<R>>,
    stop: &'a AtomicBool,
    told: u64,
}

impl<R> Watch for Member<'_, R> {
    fn look(&mut self, progress: &Progress) -> Wish {
        // A new stage may count from the beginning.
        let steps = progress.steps.checked_sub(self.told).unwrap_or(progress.steps);
        self.told = progress.steps;
        let _ = self.tell.send(Said::Going { steps });
        if self.stop.load(Ordering::Relaxed) { Wish::Stop } else { Wish::GoOn }
    }
}
