//! A collapse by discrete elements in the hands of its caller: some steps at a time, with a look at blocks and contacts in between.

use crate::choice::Choice;
use crate::collapse::planned;
use crate::project::Project;
use crate::refusal::Refusal;
use crate::watch::{Looking, Watch};
use assess::analysis;
use bridge::Bridge;
use mechanics::dem;
use outcome::collapse::Status;
use outcome::picture::Picture;
use structure::discretise::Discretised;

/// A run that goes on when it is told to. Its numbers are those of [`collapse`](crate::collapse()) by discrete elements.
pub struct Stepping {
    bridge: Bridge,
    blocks: Discretised,
    run: dem::Stepping,
}

impl Stepping {
    /// The blocks of a project as they were built.
    ///
    /// # Errors
    /// A file that cannot be used, or blocks that discrete elements cannot analyse (F108); fill that is particles, which takes
    /// [`with_fill`](Self::with_fill).
    pub fn new(project: &Project, choice: &Choice) -> Result<Stepping, Refusal> {
        let bridge = planned(project, choice)?;
        let (blocks, run) = analysis::stepping_of_blocks(&bridge)?;
        Ok(Stepping { bridge, blocks, run })
    }

    /// The same with the fill as particles where the file has it so: packed, at rest, and the loading blocks on it. None where the onlooker
    /// wished to stop on the way.
    ///
    /// # Errors
    /// Those of [`new`](Self::new), or fill that does not come to rest (F108).
    pub fn with_fill(project: &Project, choice: &Choice, watch: &mut dyn Watch) -> Result<Option<Stepping>, Refusal> {
        let bridge = planned(project, choice)?;
        let made = analysis::stepping(&bridge, &mut Looking(watch))?;
        Ok(made.map(|(blocks, run)| Stepping { bridge, blocks, run }))
    }

    /// Goes on for so many steps or to the end of the run. Tells how it ended.
    pub fn advance(&mut self, steps: u64) -> Option<&dem::Status> {
        self.run.advance(steps)
    }

    /// How the run ended, as results have it: broken off is not converged.
    pub fn ended(status: &dem::Status) -> Status {
        analysis::engine::dem::ended(*status).0
    }

    /// The load that acts now, per metre of width [N/m].
    pub fn load(&self) -> f64 {
        self.blocks.load(self.run.factor())
    }

    /// Blocks, contacts and particles as they are now.
    pub fn frame(&self) -> dem::Frame {
        self.run.frame()
    }

    /// Steps so far; out-of-balance force over acting force when the run looked last.
    pub fn progress(&self) -> (u64, f64) {
        (self.run.steps(), self.run.unbalanced_ratio())
    }

    /// The load steps that have ended: load [N/m] and what is known of it.
    pub fn path(&self) -> impl Iterator<Item = (f64, &dem::PathPoint)> {
        self.run.path().iter().map(|point| (self.blocks.load(point.factor), point))
    }

    /// The state of the run, to come back to with [`take_up`](Self::take_up) and go on from to the same bits.
    pub fn state(&self) -> Vec<u8> {
        self.run.kept()
    }

    /// Goes back, or on, to a state of this run, or of another of the same project.
    ///
    /// # Errors
    /// A state of something else (F108).
    pub fn take_up(&mut self, state: &[u8]) -> Result<(), Refusal> {
        self.run.take_up(state).map_err(|error| Refusal::not_set_up(&error))
    }

    /// The bridge before its blocks move: what [`frame`](Self::frame) moves.
    pub fn picture(&self) -> Picture {
        analysis::built(&self.bridge, &self.blocks)
    }

    /// What the run has found so far; load factors are those of [`blocks`](Self::blocks).
    pub fn finish(self) -> dem::Outcome {
        self.run.finish()
    }

    /// The blocks as they were built, and what a load factor means.
    pub fn blocks(&self) -> &Discretised {
        &self.blocks
    }
}
