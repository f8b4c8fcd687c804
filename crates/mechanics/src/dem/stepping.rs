//! A run in the hands of its caller: some steps at a time, with a look at the blocks in between.

use super::account::frame;
use super::model::Model;
use super::outcome::{Frame, Outcome, PathPoint, Status};
use super::run::{Run, advance, decide, finish, start};
use super::settings::{Program, Settings};
use super::state::State;
use super::step::{Workspace, begin};
use crate::blocks::{BlockModel, Loading, ModelError};
use crate::kept;

/// A quasi-static run that goes on when it is told to. Its numbers are those of [`collapse`](super::collapse), however many steps
/// it is moved on at a time.
pub struct Stepping {
    model: Model,
    program: Program,
    settings: Settings,
    run: Run,
    work: Workspace,
    status: Option<Status>,
    /// The number of what its states belong to.
    belongs: u64,
}

impl Stepping {
    /// Blocks as they were built, before gravity acts.
    ///
    /// # Errors
    /// Those of [`collapse`](super::collapse).
    pub fn new(
        model: &BlockModel,
        loading: &Loading,
        program: &Program,
        settings: &Settings,
    ) -> Result<Stepping, ModelError> {
        let model = Model::new(model, loading)?;
        let state = begin(&model, settings);
        Stepping::from(model, state, program, settings)
    }

    /// From a state of a model that is set up: where another run has left it.
    ///
    /// # Errors
    /// A watched block that is not there.
    pub fn from(model: Model, state: State, program: &Program, settings: &Settings) -> Result<Stepping, ModelError> {
        model.check_block(program.watched.0)?;
        let run = start(&model, state, settings);
        let belongs = kept::fingerprint(&(&model, program, settings));
        let (program, settings, work) = (program.clone(), settings.clone(), Workspace::default());
        Ok(Stepping { model, program, settings, run, work, status: None, belongs })
    }

    /// Goes on for so many steps, over the ends of stages, or to the end of the run. Tells how it ended.
    pub fn advance(&mut self, steps: u64) -> Option<&Status> {
        let until = self.run.state.steps + steps;
        while self.status.is_none() && self.run.state.steps < until {
            let most = until - self.run.state.steps;
            let settled = advance(&self.model, &mut self.run, &mut self.work, &self.settings, most);
            self.status = decide(&self.model, &mut self.run, settled, &self.program);
        }
        self.status.as_ref()
    }

    /// Load factor that acts now.
    pub fn factor(&self) -> f64 {
        self.run.state.factor
    }

    /// Steps since the blocks were let go.
    pub fn steps(&self) -> u64 {
        self.run.state.steps
    }

    /// Out-of-balance force over acting force when the run looked last.
    pub fn unbalanced_ratio(&self) -> f64 {
        self.run.stage.ratio
    }

    /// Load steps that have ended.
    pub fn path(&self) -> &[PathPoint] {
        &self.run.path
    }

    /// The state of the run, from which [`take_up`](Self::take_up) goes on to the same bits.
    pub fn kept(&self) -> Vec<u8> {
        kept::write(self.belongs, &self.run)
    }

    /// Goes back, or on, to a state of the same run.
    ///
    /// # Errors
    /// Bytes of another run, or damaged ones.
    pub fn take_up(&mut self, bytes: &[u8]) -> Result<(), ModelError> {
        self.run = Run::from_bytes(&self.model, self.belongs, bytes)?;
        (self.work, self.status) = (Workspace::default(), None);
        Ok(())
    }

    /// Blocks, contacts and particles as they are now.
    pub fn frame(&self) -> Frame {
        frame(&self.model, &self.run.state)
    }

    /// What the run has found; of one that was not moved on to its end, what it has found so far.
    pub fn finish(self) -> Outcome {
        finish(&self.model, self.run, self.status.unwrap_or(Status::Cancelled))
    }
}
