//! Progress out, cancellation in. Asked at least once in every iteration that takes milliseconds.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// How far a run has come.
#[derive(Debug, Clone, PartialEq)]
pub struct Progress {
    /// What is being done now, in a few words ("self-weight", "load 120.5 kN/m").
    pub stage: String,
    /// Share of the work done, 0 to 1, where it can be told.
    pub fraction: Option<f64>,
    /// Steps or iterations so far.
    pub steps: u64,
}

/// Someone who looks on.
pub trait Watch {
    /// Tells how far the run is; an answer of [`Wish::Stop`] ends it as soon as its state is consistent.
    fn look(&mut self, progress: &Progress) -> Wish;

    /// Offers the state of the run as bytes, from which it can be resumed to the same bits. `state` is only called by an
    /// onlooker that wants to keep it.
    fn keep(&mut self, _state: &dyn Fn() -> Vec<u8>) {}
}

/// What the onlooker wants.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wish {
    /// Go on.
    GoOn,
    /// Stop at a consistent state and say so in the outcome.
    Stop,
}

/// Cancellation token with progress, shared by the threads of one run and asked in every iteration of their loops. Clones are the same token.
#[derive(Debug, Clone)]
pub struct CancelToken {
    counts: Arc<Counts>,
    /// Shares of the whole work at which the part that this clone is given begins and ends.
    part: [f64; 2],
}

#[derive(Debug, Default)]
struct Counts {
    cancelled: AtomicBool,
    steps: AtomicU64,
    iterations: AtomicU64,
    /// Bits of the share of the work that is done: those of positive numbers are in their order.
    share: AtomicU64,
    /// Iterations after which it ends by itself; zero for none.
    most: u64,
}

impl Default for CancelToken {
    fn default() -> CancelToken {
        CancelToken { counts: Arc::default(), part: [0.0, 1.0] }
    }
}

impl CancelToken {
    /// A token that is cancelled already.
    pub fn cancelled() -> CancelToken {
        let token = CancelToken::default();
        token.cancel();
        token
    }

    /// A token that is cancelled by itself after so many iterations.
    pub fn limited_to(iterations: u64) -> CancelToken {
        let counts = Counts { most: iterations.max(1), ..Counts::default() };
        CancelToken { counts: Arc::new(counts), ..CancelToken::default() }
    }

    /// Cancels the run.
    pub fn cancel(&self) {
        self.counts.cancelled.store(true, Ordering::Relaxed);
    }

    /// Whether the run is cancelled.
    pub fn is_cancelled(&self) -> bool {
        self.counts.cancelled.load(Ordering::Relaxed)
    }

    /// Counts an iteration, and says whether the work goes on.
    pub fn iterate(&self) -> bool {
        if self.counts.iterations.fetch_add(1, Ordering::Relaxed) + 1 == self.counts.most {
            self.cancel();
        }
        !self.is_cancelled()
    }

    /// Counts a step, of which the onlooker is told, and says whether the work goes on.
    pub fn step(&self) -> bool {
        self.counts.steps.fetch_add(1, Ordering::Relaxed);
        !self.is_cancelled()
    }

    /// The token of part `k` of several that take about the same time.
    #[must_use]
    pub fn part(&self, k: usize, of: usize) -> CancelToken {
        let [from, to] = self.part;
        let at = |k: usize| from + (to - from) * k as f64 / of.max(1) as f64;
        CancelToken { counts: Arc::clone(&self.counts), part: [at(k), at(k + 1)] }
    }

    /// Tells how far its part of the work is, 0 to 1.
    pub fn reach(&self, share: f64) {
        let [from, to] = self.part;
        let share = from + share.clamp(0.0, 1.0) * (to - from);
        self.counts.share.fetch_max(share.to_bits(), Ordering::Relaxed);
    }

    /// Share of the whole work that is done, as far as it was told.
    pub fn share(&self) -> f64 {
        f64::from_bits(self.counts.share.load(Ordering::Relaxed))
    }

    /// Iterations so far.
    pub fn iterations(&self) -> u64 {
        self.counts.iterations.load(Ordering::Relaxed)
    }

    /// Steps so far.
    pub fn steps(&self) -> u64 {
        self.counts.steps.load(Ordering::Relaxed)
    }
}

/// A piece of shared work is asked in its iterations; what it tells is not passed on.
impl Watch for CancelToken {
    fn look(&mut self, _: &Progress) -> Wish {
        if self.iterate() { Wish::GoOn } else { Wish::Stop }
    }
}

/// An onlooker asked again and again within one stretch of work. Whoever wished to stop once has stopped it.
pub(crate) struct Asking<'w> {
    watch: &'w mut dyn Watch,
    progress: Progress,
    /// Whether the onlooker has stopped it.
    pub stopped: bool,
}

impl<'w> Asking<'w> {
    /// Asks `watch` whenever [`Asking::stops`] is called.
    pub(crate) fn new(watch: &'w mut dyn Watch) -> Asking<'w> {
        Asking { watch, progress: Progress { stage: String::new(), fraction: None, steps: 0 }, stopped: false }
    }

    /// Tells how far the work is; whether it is to end.
    pub(crate) fn tell(&mut self, progress: Progress) -> bool {
        self.progress = progress;
        self.stops()
    }

    /// Whether the work is to end.
    pub(crate) fn stops(&mut self) -> bool {
        self.stopped = self.stopped || self.watch.look(&self.progress) == Wish::Stop;
        self.stopped
    }
}

/// Nobody looks on.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unwatched;

impl Watch for Unwatched {
    fn look(&mut self, _: &Progress) -> Wish {
        Wish::GoOn
    }
}
