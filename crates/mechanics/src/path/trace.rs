//! The path from self-weight to the largest load and past it, a step at a time: between two steps a run can be kept.

use super::beyond::{Descend, Push};
use super::correct::{Balanced, Constraint, balance, dot, norm};
use super::frame::{frame, point};
use super::model::Model;
use super::outcome::{Outcome, PathPoint, Status};
use super::rise::Rise;
use super::settings::{Program, Settings};
use super::stand::{LetGo, Settle};
use super::system::{State, Workspace, advance, assemble, commit};
use crate::banded::Banded;
use crate::blocks::{BlockModel, Loading, ModelError};
use crate::kept;
use crate::watch::{Progress, Watch, Wish};
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;

/// The load at which equilibrium ends, with deformable joints: the path of balanced states from the blocks' own weight through
/// the largest load. `resume` takes up a run that [`Watch::keep`] was offered, for the same blocks, loads, settings and program;
/// the numbers are those of an undisturbed run.
///
/// # Errors
/// A model that cannot be analysed, and a state that was kept for another one.
pub fn collapse(
    blocks: &BlockModel,
    loading: &Loading,
    (settings, program): (&Settings, &Program),
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
) -> Result<Outcome, ModelError> {
    let model = Model::new(blocks, loading, settings)?;
    let mut path = Path::new(&model, settings, program);
    path.keeps = true;
    let belongs = kept::fingerprint(&(&model, settings, program));
    if let Some(bytes) = resume {
        path.take_up(belongs, bytes)?;
    }
    let status = path.run(Some(belongs), watch);
    let onsets = path.onsets(&[]);
    Ok(Outcome { onsets, ..path.outcome(blocks, status) })
}

/// What a run does next.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) enum Stage {
    /// Begins.
    Built,
    /// Lets joints go that are pressed together.
    LetGo(LetGo),
    /// Lets the blocks fall under their own weight.
    Settle(Settle),
    /// The blocks stand under their own weight.
    Stood(Balanced),
    /// Follows the path up.
    Rise(Rise),
    /// Lets the blocks fall under a little more load.
    Push(Push),
    /// Follows the path past its peak.
    Descend(Descend),
}

/// What follows a step: the next thing to do, or the end of the path.
pub(super) type Next = ControlFlow<Status, Stage>;

/// Where the path goes at a balanced state, per unit of its length.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Heading {
    pub direction: Vec<f64>,
    pub factor: f64,
    /// Whether the blocks stand there.
    pub stable: bool,
}

impl Heading {
    /// Whether another one, close by, has the same direction.
    fn is_like(&self, other: &Heading) -> bool {
        let turned = 1.0 - dot(&self.direction, &other.direction);
        turned < ALIKE && (other.factor / self.factor - 1.0).abs() < ALIKE
    }
}

/// Headings and forces are alike that differ by no more than this share of them.
const ALIKE: f64 = 1e-2;

pub(super) struct Path<'m> {
    pub model: &'m Model,
    pub settings: &'m Settings,
    pub program: &'m Program,
    pub work: Workspace,
    /// Whether the tangent of the state that the last step led to stands in the workspace.
    pub assembled: bool,
    /// What falls are resisted by, once there was one.
    pub dashpots: Option<Banded>,
    /// Whether all states are kept.
    pub keeps: bool,
    /// The last balanced state, and what comes next.
    pub state: State,
    pub stage: Stage,
    /// Length of the last step on the way up.
    pub length: Option<f64>,
    /// The load that is added where balance is lost, in units of the resolution.
    pub push: f64,
    /// The balanced states in their order: their numbers, and all of them where they are kept.
    pub points: Vec<PathPoint>,
    pub states: Vec<State>,
    pub iterations: u32,
    pub mechanism: Vec<f64>,
    /// How often balance was lost and found again.
    pub snaps: u32,
}

impl<'m> Path<'m> {
    pub(super) fn new(model: &'m Model, settings: &'m Settings, program: &'m Program) -> Path<'m> {
        Path {
            model,
            settings,
            program,
            work: Workspace::new(model),
            assembled: false,
            dashpots: None,
            keeps: false,
            state: State::as_built(model),
            stage: Stage::Built,
            length: None,
            push: 1.0,
            points: Vec::new(),
            states: Vec::new(),
            iterations: 0,
            mechanism: Vec::new(),
            snaps: 0,
        }
    }

    /// Brings the blocks to stand under their own weight; or how that ends.
    pub(super) fn stand(&mut self, watch: &mut dyn Watch) -> Result<Balanced, Status> {
        loop {
            if let Stage::Stood(balanced) = self.stage {
                return Ok(balanced);
            }
            if let ControlFlow::Break(end) = self.go_on(None, watch) {
                return Err(end);
            }
        }
    }

    /// Follows the path from the last balanced state to its end.
    pub(super) fn follow(&mut self, watch: &mut dyn Watch) -> Status {
        (self.length, self.push) = (None, 1.0);
        match self.begin_rise() {
            Next::Break(end) => end,
            Next::Continue(stage) => {
                self.stage = stage;
                self.run(None, watch)
            }
        }
    }

    /// Follows the path from the last balanced state to where it no longer rises.
    pub(super) fn follow_up(&mut self, watch: &mut dyn Watch) -> Status {
        let Some(mut rise) = self.rising() else { return Status::NotConverged };
        loop {
            if watch.look(&self.progress()) == Wish::Stop {
                return Status::Cancelled;
            }
            if let Some(end) = self.climb(&mut rise) {
                return end;
            }
        }
    }

    /// What a stopped run goes on from, as bytes.
    fn kept(&self, belongs: u64) -> Vec<u8> {
        let Path { state, stage, length, push, points, states, iterations, mechanism, snaps, .. } = self;
        kept::write(belongs, &(state, stage, length, push, points, states, iterations, mechanism, snaps))
    }

    /// Puts the path to where a run was stopped.
    fn take_up(&mut self, belongs: u64, bytes: &[u8]) -> Result<(), ModelError> {
        let Path { state, stage, length, push, points, states, iterations, mechanism, snaps, .. } = self;
        (*state, *stage, *length, *push, *points, *states, *iterations, *mechanism, *snaps) =
            kept::read(belongs, bytes)?;
        Ok(())
    }

    /// Goes on to the end. Where its state may be kept, the number of what it belongs to is given.
    fn run(&mut self, belongs: Option<u64>, watch: &mut dyn Watch) -> Status {
        loop {
            if let ControlFlow::Break(end) = self.go_on(belongs, watch) {
                return end;
            }
        }
    }

    /// One step; how the path ends, where it does.
    fn go_on(&mut self, belongs: Option<u64>, watch: &mut dyn Watch) -> ControlFlow<Status> {
        let keep = |path: &Path, watch: &mut dyn Watch| {
            if let Some(belongs) = belongs {
                watch.keep(&|| path.kept(belongs));
            }
        };
        keep(self, watch);
        if watch.look(&self.progress()) == Wish::Stop {
            keep(self, watch);
            return ControlFlow::Break(Status::Cancelled);
        }
        let next = match std::mem::replace(&mut self.stage, Stage::Built) {
            Stage::Built => Next::Continue(self.glue()),
            Stage::LetGo(joints) => self.let_go(joints),
            Stage::Settle(settle) => self.fall_at_first(settle),
            Stage::Stood(balanced) => {
                self.keep(balanced);
                self.begin_rise()
            }
            Stage::Rise(rise) => self.rise(rise),
            Stage::Push(push) => self.pushed(push),
            Stage::Descend(descend) => self.descend(descend),
        };
        self.stage = next?;
        ControlFlow::Continue(())
    }

    fn progress(&self) -> Progress {
        let (limit, factor) = (self.program.limit, self.state.factor);
        let share = (limit.is_finite() && limit > 0.0).then(|| (factor / limit).clamp(0.0, 1.0));
        let (stage, fraction, steps) = match &self.stage {
            Stage::Rise(rise) => (format!("load factor {factor:.4}"), share, rise.step),
            Stage::Push(push) => {
                let stage = format!("balance lost at load factor {:.4}", push.falling.state.factor);
                (stage, None, push.falling.corrections)
            }
            Stage::Descend(descend) => ("past the peak".to_owned(), None, descend.step),
            Stage::Settle(settle) => ("self-weight, let fall".to_owned(), None, settle.falling.corrections),
            Stage::Built | Stage::LetGo(_) | Stage::Stood(_) => ("self-weight".to_owned(), None, 0),
        };
        Progress { stage, fraction, steps: u64::from(steps) }
    }

    pub(super) fn is_long(&self) -> bool {
        self.points.len() as u32 >= self.settings.most_steps
    }

    /// The load factor that counts as nothing here.
    pub(super) fn unseen(&self) -> f64 {
        let increment = self.program.increment;
        self.settings.resolution * self.state.factor.abs().max(self.settings.resolution * increment)
    }

    /// A balanced state a step along the heading.
    pub(super) fn step(
        &mut self,
        constraint: Constraint,
        (heading, length): (&Heading, f64),
    ) -> Option<(State, Balanced)> {
        self.assembled = false;
        let mut next = self.state.clone();
        let change: Vec<f64> = heading.direction.iter().map(|d| d * length).collect();
        advance(self.model, &mut next, &change, heading.factor * length);
        let balanced = balance(self.model, self.settings, constraint, &mut next, &mut self.work)?;
        self.iterations += balanced.iterations;
        commit(self.model, self.settings, &mut next);
        // Joints that hold have the same tangent before and after they remember the state.
        self.assembled = !(self.work.slides || self.work.cracks);
        Some((next, balanced))
    }

    /// Sets up the tangent of a balanced state, where the last step did not leave it.
    fn assemble(&mut self, state: &State) {
        if !std::mem::take(&mut self.assembled) {
            assemble(self.model, self.settings, state, &mut self.work);
        }
    }

    /// Whether the blocks stand in a balanced state.
    pub(super) fn is_stable(&mut self, state: &State) -> bool {
        self.assemble(state);
        self.work.is_stable()
    }

    /// Where the path goes at a balanced state, on from where it came; none where the tangent is singular.
    pub(super) fn heading(&mut self, state: &State, before: Option<&Heading>) -> Option<Heading> {
        self.assemble(state);
        let stable = self.work.is_stable();
        if !self.work.tangent.factorise() {
            return None;
        }
        let mut direction = self.work.growing.clone();
        self.work.tangent.solve(&mut direction);
        let length = norm(&direction);
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        let on = before.is_none_or(|before| dot(&before.direction, &direction) >= 0.0);
        let factor = if on { 1.0 } else { -1.0 } / length;
        direction.iter_mut().for_each(|d| *d *= factor);
        Some(Heading { direction, factor, stable })
    }

    /// Whether the path has no corner on the way to a state close by, where a joint opens, closes or cracks: it has the same heading there, or a motion
    /// that balanced a little more load does so there as well. The heading alone does not tell, for near a fork it turns along the motion that gives way.
    pub(super) fn goes_on_to(&mut self, next: &State, [heading, on]: [&Heading; 2]) -> bool {
        assemble(self.model, self.settings, next, &mut self.work);
        // Whether a crack grows is not known beforehand.
        if self.work.cracks {
            return false;
        }
        let load: Vec<f64> = self.work.growing.iter().map(|growing| heading.factor * growing).collect();
        let resisted = self.work.tangent.times(&heading.direction);
        let left: Vec<f64> = resisted.iter().zip(&load).map(|(r, l)| r - l).collect();
        heading.is_like(on) || norm(&left) < ALIKE * norm(&load)
    }

    pub(super) fn accept(&mut self, next: State, balanced: Balanced) {
        self.state = next;
        self.keep(balanced);
    }

    /// The last balanced state becomes part of the path.
    pub(super) fn keep(&mut self, balanced: Balanced) {
        let numbers = (balanced.iterations, balanced.residual);
        self.points.push(point(self.model, (self.settings, self.program), &self.state, numbers));
        if self.keeps {
            self.states.push(self.state.clone());
        }
    }

    fn outcome(self, blocks: &BlockModel, status: Status) -> Outcome {
        let stands = !matches!(status, Status::UnstableUnderSelfWeight);
        let most = self.points.iter().map(|p| p.factor).fold(f64::NEG_INFINITY, f64::max);
        let collapse_factor = matches!(status, Status::LimitPoint | Status::Bifurcation).then_some(most);
        let peak = (0..self.states.len()).rev().find(|&k| self.states[k].factor == most);
        let cause = collapse_factor.and(peak).map(|k| self.cause(&self.points[k]));
        let drawn = |(k, state): (usize, &State)| frame(self.model, self.settings, state, k);
        Outcome {
            status,
            cause,
            collapse_factor,
            last_stable_factor: (stands && most.is_finite()).then_some(most),
            peak,
            mechanism: self.motions(blocks),
            frames: self.states.iter().enumerate().map(drawn).collect(),
            onsets: Vec::new(),
            path: self.points,
            interfaces: self.model.interfaces.clone(),
            iterations: self.iterations,
            snaps: self.snaps,
        }
    }
}
