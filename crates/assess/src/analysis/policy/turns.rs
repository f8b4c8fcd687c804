//! States of a bridge that are analysed one after the other under one onlooker.

use super::states::State;
use crate::analysis::AnalysisError;
use mechanics::blocks::ModelError;
use mechanics::kept;
use mechanics::watch::{Progress, Watch, Wish};
use outcome::help::Help;

/// The turns of the states. What is kept starts with the number of the state that was at work; on resuming, those before it are made again,
/// to the same bits. One state alone is analysed as if there were no turns.
pub(in crate::analysis) struct Turns<'a> {
    count: usize,
    kept: Option<(usize, &'a [u8])>,
}

impl<'a> Turns<'a> {
    /// The turns of so many states, from the first on or from where a run was broken off.
    ///
    /// # Errors
    /// What was kept of another run.
    pub(in crate::analysis) fn new(count: usize, resume: Option<&'a [u8]>) -> Result<Turns<'a>, AnalysisError> {
        let kept = match (count, resume) {
            (1, alone) => alone.map(|state| (0, state)),
            (_, several) => several.map(kept::split::<usize>).transpose()?,
        };
        match kept {
            Some((at, _)) if at >= count => Err(ModelError::ForeignState.into()),
            kept => Ok(Turns { count, kept }),
        }
    }

    /// What was kept of a state.
    pub(in crate::analysis) fn kept(&self, number: usize) -> Option<&'a [u8]> {
        self.kept.and_then(|(at, own)| (at == number).then_some(own))
    }

    /// The onlooker as the analysis of a state sees it.
    pub(in crate::analysis) fn watch<'w, T>(
        &self,
        (number, state): (usize, &State<T>),
        watch: &'w mut dyn Watch,
    ) -> Turn<'w> {
        let what = match &state.helps[..] {
            [] => "without what may come and go".to_owned(),
            helps => format!("with {}", Help::all_told(helps)),
        };
        Turn { watch, number, count: self.count, what }
    }
}

/// The onlooker of one state.
pub(in crate::analysis) struct Turn<'w> {
    watch: &'w mut dyn Watch,
    number: usize,
    count: usize,
    what: String,
}

impl Watch for Turn<'_> {
    fn look(&mut self, progress: &Progress) -> Wish {
        if self.count == 1 {
            return self.watch.look(progress);
        }
        self.watch.look(&Progress {
            stage: format!("{}: {}", self.what, progress.stage),
            fraction: progress.fraction.map(|share| (share + self.number as f64) / self.count as f64),
            ..progress.clone()
        })
    }

    fn keep(&mut self, state: &dyn Fn() -> Vec<u8>) {
        match self.count {
            1 => self.watch.keep(state),
            _ => self.watch.keep(&|| kept::join(&self.number, &state())),
        }
    }
}
