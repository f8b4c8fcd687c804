//! Progress out, cancellation in. Called a few times a second at most, never inside a step.

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

    /// Offers the state of the run, from which it can be resumed to the same bits. `words` is only called by an
    /// onlooker that wants to keep it.
    fn keep(&mut self, _words: &dyn Fn() -> Vec<u64>) {}
}

/// What the onlooker wants.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wish {
    /// Go on.
    GoOn,
    /// Stop at a consistent state and say so in the outcome.
    Stop,
}

/// Nobody looks on.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unwatched;

impl Watch for Unwatched {
    fn look(&mut self, _: &Progress) -> Wish {
        Wish::GoOn
    }
}
