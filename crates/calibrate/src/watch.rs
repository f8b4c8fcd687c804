//! Progress out, a wish to stop in, finished evaluations offered for keeping.

/// How far a search has come.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Progress {
    /// What is being done now, in a few words.
    pub stage: String,
    /// Evaluations of this search so far, those read back from a log included.
    pub done: usize,
    /// Evaluations still to come, at the most where it cannot be told exactly; none where it cannot be told at all.
    pub to_come: Option<usize>,
}

/// Someone who looks on.
pub trait Watch {
    /// Called between lots of evaluations.
    ///
    /// # Errors
    /// The wish that the search ends after the lot of evaluations at hand.
    fn look(&mut self, progress: &Progress) -> Result<(), Stopped>;

    /// A finished evaluation as one line of the log, without its line break; whoever appends these lines to a file can
    /// resume from it.
    fn keep(&mut self, _line: &str) {}

    /// Whether lines are wanted at all.
    fn keeps(&self) -> bool {
        false
    }
}

/// Nobody looks on.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unwatched;

impl Watch for Unwatched {
    fn look(&mut self, _: &Progress) -> Result<(), Stopped> {
        Ok(())
    }
}

/// The onlooker wanted it to end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stopped;
