//! A collapse by discrete elements in the hands of its caller: some steps at a time, with a look at blocks and contacts in between.

use crate::choice::Choice;
use crate::collapse::planned;
use crate::project::Project;
use crate::refusal::Refusal;
use assess::analysis::by_dem::stepping;
use mechanics::dem;
use structure::discretise::Discretised;

/// A run that goes on when it is told to. Its numbers are those of [`collapse`](crate::collapse()) by discrete elements.
pub struct Stepping {
    blocks: Discretised,
    run: dem::Stepping,
}

impl Stepping {
    /// The blocks of a project as they were built.
    ///
    /// # Errors
    /// A file that cannot be used, or blocks that discrete elements cannot analyse (F108).
    pub fn new(project: &Project, choice: &Choice) -> Result<Stepping, Refusal> {
        let bridge = planned(project, choice)?;
        let (blocks, run) = stepping(&bridge).map_err(|error| Refusal::not_set_up(&error))?;
        Ok(Stepping { blocks, run })
    }

    /// Goes on for so many steps or to the end of the run. Tells how it ended.
    pub fn advance(&mut self, steps: u64) -> Option<&dem::Status> {
        self.run.advance(steps)
    }

    /// The load that acts now, per metre of width [N/m].
    pub fn load(&self) -> f64 {
        self.blocks.load(self.run.factor())
    }

    /// Blocks, contacts and particles as they are now.
    pub fn frame(&self) -> dem::Frame {
        self.run.frame()
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
