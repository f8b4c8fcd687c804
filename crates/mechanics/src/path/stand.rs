//! The first state of a path: the blocks under their own weight.
//!
//! Joints without tension are alike at every load, so no small load would make it easier to find: instead they are pressed
//! together until they are as good as glued, and are let go by degrees. Where that loses its way, or finds a state that does
//! not stay, the blocks are let fall from there, and from where glued joints would hold them: what comes to rest stands.

use super::correct::{Constraint, balance};
use super::outcome::Status;
use super::relax::{Fall, Falling, PATIENT};
use super::system::{State, advance, assemble, commit, respond};
use super::trace::{Next, Path, Stage};
use serde::{Deserialize, Serialize};

/// Overlap by which joints are as good as glued, and overlap that is as good as none, as shares of the largest one of glued
/// joints.
const GLUED: f64 = 10.0;
const LET_GO: f64 = 1e-3;

/// Joints that are let go by degrees.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct LetGo {
    /// Overlap by which they are pressed together in the present state [m], and the share of it that the next one keeps.
    pub pressed: f64,
    pub share: f64,
    /// Largest overlap of glued joints [m].
    pub widest: f64,
}

/// Blocks that fall under their own weight.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Settle {
    /// Whether the blocks fell for good from where their joints had been let go; none while they are on their way from there.
    pub fell_before: Option<bool>,
    pub falling: Falling,
}

impl Path<'_> {
    /// Where glued joints hold the blocks; none where they do not.
    fn glued(&mut self) -> Option<State> {
        let mut glued = State::as_built(self.model);
        // As built, sides neither overlap nor gape but for rounding: any overlap makes them closed.
        let closed = State { pressed: self.model.size, ..glued.clone() };
        assemble(self.model, self.settings, &closed, &mut self.work);
        if !self.work.tangent.factorise() {
            return None;
        }
        let mut change = self.work.unbalanced.clone();
        self.work.tangent.solve(&mut change);
        advance(self.model, &mut glued, &change, 0.0);
        Some(glued)
    }

    /// Glues the joints of the blocks as built.
    pub(super) fn glue(&mut self) -> Stage {
        let Some(glued) = self.glued() else { return self.settle() };
        let overlap = |k| respond(self.model, self.settings, &glued.memory[k], k, &glued).meeting.overlap;
        let widest = (0..self.model.joints.len()).flat_map(overlap).fold(0.0, |most: f64, o| most.max(o.abs()));
        self.state = glued;
        Stage::LetGo(LetGo { pressed: GLUED * widest, share: 0.5, widest })
    }

    /// Lets joints go by one degree more.
    pub(super) fn let_go(&mut self, mut joints: LetGo) -> Next {
        if joints.pressed <= 0.0 {
            return Next::Continue(self.settle());
        }
        let next = if joints.pressed < joints.widest * LET_GO { 0.0 } else { joints.pressed * joints.share };
        let mut guess = State { pressed: next, ..self.state.clone() };
        let found = balance(self.model, self.settings, Constraint::Load, &mut guess, &mut self.work);
        // Joints that slide while they are let go are judged at the end, when they remember what has slid.
        match found.filter(|_| self.work.slides || self.work.is_stable()) {
            Some(balanced) => {
                self.iterations += balanced.iterations;
                (self.state, joints.pressed) = (guess, next);
                joints.share = (joints.share * joints.share).max(0.1);
                if next == 0.0 {
                    commit(self.model, self.settings, &mut self.state);
                    let state = self.state.clone();
                    let stays = self.is_stable(&state);
                    return Next::Continue(if stays { Stage::Stood(balanced) } else { self.settle() });
                }
            }
            None if joints.share > 0.98 => return Next::Continue(self.settle()),
            None => joints.share = joints.share.sqrt(),
        }
        Next::Continue(Stage::LetGo(joints))
    }

    /// Lets the blocks fall from where they are.
    fn settle(&mut self) -> Stage {
        self.state.pressed = 0.0;
        Stage::Settle(Settle { fell_before: None, falling: Falling::new(self.state.clone(), PATIENT) })
    }

    /// One step of blocks that fall under their own weight.
    pub(super) fn fall_at_first(&mut self, mut settle: Settle) -> Next {
        let Some(end) = self.fall(&mut settle.falling) else { return Next::Continue(Stage::Settle(settle)) };
        let falls = match end {
            Fall::Rests(found, balanced) => {
                self.state = found;
                return Next::Continue(Stage::Stood(balanced));
            }
            end => matches!(end, Fall::Falls(_)),
        };
        match settle.fell_before {
            None => {
                // As built, rounding decides which joints are closed, and what a tangent makes of that may lead nowhere.
                let from = self.glued().unwrap_or_else(|| State::as_built(self.model));
                let falling = Falling::new(from, PATIENT);
                Next::Continue(Stage::Settle(Settle { fell_before: Some(falls), falling }))
            }
            Some(before) => {
                Next::Break(if before && falls { Status::UnstableUnderSelfWeight } else { Status::NotConverged })
            }
        }
    }
}
