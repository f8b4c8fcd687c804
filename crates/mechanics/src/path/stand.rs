//! The first state of a path: the blocks under their own weight.

use super::correct::{Balanced, Constraint, balance};
use super::relax::{Fall, PATIENT};
use super::system::{State, advance, assemble, commit, respond};
use super::trace::Path;
use crate::watch::{Progress, Watch, Wish};

/// Whether the blocks stand under their own weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Standing {
    Balanced(Balanced),
    Falls,
    Lost,
    Stopped,
}

/// Overlap by which joints are as good as glued, and overlap that is as good as none, as shares of the largest one of glued
/// joints.
const GLUED: f64 = 10.0;
const LET_GO: f64 = 1e-3;

impl Path<'_> {
    /// The first state under self-weight. Joints without tension are alike at every load, so no small load would make it
    /// easier to find: instead they are pressed together until they are as good as glued, and are let go by degrees. Where
    /// that loses its way, or finds a state that does not stay, the blocks are let fall from there, and from where they were
    /// built: what comes to rest stands.
    pub fn stand(&mut self, state: &mut State, watch: &mut dyn Watch) -> Standing {
        let built = state.clone();
        match self.let_go(state, watch) {
            Standing::Falls => {}
            end => return end,
        }
        state.pressed = 0.0;
        let mut ends = Vec::new();
        for start in [state.clone(), built] {
            match self.fall(&start, PATIENT, watch) {
                Fall::Rests(found, balanced) => {
                    *state = found;
                    return Standing::Balanced(balanced);
                }
                Fall::Stopped => return Standing::Stopped,
                end => ends.push(end),
            }
        }
        if ends.iter().all(|end| matches!(end, Fall::Falls(_))) { Standing::Falls } else { Standing::Lost }
    }

    /// From joints that are as good as glued to those that are; falls where no next state is found.
    fn let_go(&mut self, state: &mut State, watch: &mut dyn Watch) -> Standing {
        let mut glued = state.clone();
        // As built, sides neither overlap nor gape but for rounding: any overlap makes them closed.
        state.pressed = self.model.size;
        assemble(self.model, self.settings, state, &mut self.work);
        if !self.work.tangent.factorise() {
            return Standing::Falls;
        }
        let mut change = self.work.unbalanced.clone();
        self.work.tangent.solve(&mut change);
        advance(self.model, &mut glued, &change, 0.0);
        let overlap = |k| respond(self.model, self.settings, &glued.memory[k], k, &glued).overlap;
        let widest = (0..self.model.joints.len()).flat_map(overlap).fold(0.0, |most: f64, o| most.max(o.abs()));
        let (mut pressed, mut share) = (GLUED * widest, 0.5);
        *state = glued;
        while pressed > 0.0 {
            if watch.look(&Progress { stage: "self-weight".to_owned(), fraction: None, steps: 0 }) == Wish::Stop {
                return Standing::Stopped;
            }
            let next = if pressed < widest * LET_GO { 0.0 } else { pressed * share };
            let mut guess = State { pressed: next, ..state.clone() };
            match balance(self.model, self.settings, Constraint::Load, &mut guess, &mut self.work) {
                Some(balanced) => {
                    self.iterations += balanced.iterations;
                    (*state, pressed) = (guess, next);
                    share = (share * share).max(0.1);
                    if next == 0.0 {
                        commit(self.model, self.settings, state);
                        let stays = self.heading(state, None).is_some_and(|heading| heading.sign > 0);
                        return if stays { Standing::Balanced(balanced) } else { Standing::Falls };
                    }
                }
                None if share > 0.98 => return Standing::Falls,
                None => share = share.sqrt(),
            }
        }
        Standing::Falls
    }
}
