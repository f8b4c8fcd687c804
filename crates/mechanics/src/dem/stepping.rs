//! A run in the hands of its caller: some steps at a time, with a look at the blocks in between.

use super::account::frame;
use super::model::Model;
use super::outcome::{Frame, Outcome, Status};
use super::relax::Settled;
use super::run::{Run, advance, decide, finish, record, start};
use super::settings::{Program, Settings};
use super::state::State;
use super::step::{Workspace, begin};
use crate::blocks::{BlockModel, Loading, ModelError};

/// A quasi-static run that goes on when it is told to. Its numbers are those of [`collapse`](super::collapse), however many steps
/// it is moved on at a time.
pub struct Stepping {
    model: Model,
    program: Program,
    settings: Settings,
    run: Run,
    work: Workspace,
    status: Option<Status>,
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
        model.check_block(program.watched.0)?;
        let run = start(&model, begin(&model, settings), settings);
        let (program, settings, work) = (program.clone(), settings.clone(), Workspace::default());
        Ok(Stepping { model, program, settings, run, work, status: None })
    }

    /// Goes on for so many steps, over the ends of stages, or to the end of the run. Tells how it ended.
    pub fn advance(&mut self, steps: u64) -> Option<&Status> {
        let until = self.run.state.steps + steps;
        while self.status.is_none() && self.run.state.steps < until {
            let most = until - self.run.state.steps;
            let settled = advance(&self.model, &mut self.run, &mut self.work, &self.settings, most);
            if settled != Settled::Going {
                record(&self.model, &mut self.run, settled, &self.program);
                self.status = decide(&self.model, &mut self.run, settled, &self.program, &self.settings);
            }
        }
        self.status.as_ref()
    }

    /// Load factor that acts now.
    pub fn factor(&self) -> f64 {
        self.run.state.factor
    }

    /// Positions, velocities and forces as they lie in memory.
    pub fn state(&self) -> &State {
        &self.run.state
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
