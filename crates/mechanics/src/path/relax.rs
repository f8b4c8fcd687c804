//! Where blocks come to rest that are not in balance under a load that stays: the nearest stable state, or none.
//!
//! They move as if every joint held a dashpot, its resistance in proportion to the stiffness that the joint has when it is
//! closed: each step balances the forces with those of the dashpots, which fade as the forces do (pseudo-transient continuation;
//! Kelley and Keyes 1998). The dashpots take work out of the motion in every step, so blocks that go on moving are driven by
//! their load, and no step is balanced by an unstable state, as Newton's method would be.

use super::correct::{Balanced, norm};
use super::model::Model;
use super::settings::Settings;
use super::system::{State, Workspace, advance, assemble, commit, scale};
use crate::banded::Banded;
use serde::{Deserialize, Serialize};

/// Most corrections of a fall that another one may stand for, and of one that nothing else does: rings that begin to slide do so
/// slowly. The most of one step.
pub(super) const BRIEF: u32 = 4000;
pub(super) const PATIENT: u32 = 20_000;
const MOST_CORRECTIONS: u32 = 12;

/// Halvings of one correction.
const MOST_CUTS: u32 = 6;

/// What slid is taken to hold at the begin of a step: the first corrections find out what slides on, and may make things worse by
/// this factor.
const FIRST_CORRECTIONS: u32 = 3;
const WORSE: f64 = 3.0;

/// Largest motion of one step, as a share of the size of the blocks: contacts change by a part of a joint at most.
const LONGEST: f64 = 0.05;

/// Share of the forces at its begin that a step may leave out of balance; the last one leaves none.
const LEFT: f64 = 1e-2;

/// Drag of the first step, and the largest and the least, relative to the stiffness of closed joints: with the largest, a step
/// is shorter than any that the joints' elasticity takes, and with the least they are as if there was none.
const FIRST: f64 = 1e-2;
const MOST: f64 = 1e4;
const LEAST: f64 = 1e-12;

/// Corrections of a step that may as well be taken with much less drag.
const QUICK: u32 = 4;

/// How a fall ends.
#[derive(Debug, Clone)]
pub(super) enum Fall {
    /// In a stable state.
    Rests(State, Balanced),
    /// Not within the distance that is taken as a fall for good; where the blocks were then.
    Falls(State),
    /// Unknown: no step was found, or they were too many.
    Lost,
}

/// Joints that are closed, as built: what dashpots are in proportion to.
pub(super) fn dashpots(model: &Model, settings: &Settings) -> Banded {
    let mut work = Workspace::new(model);
    let glued = State { pressed: model.size, ..State::as_built(model) };
    assemble(model, settings, &glued, &mut work);
    work.tangent
}

/// Blocks that were let go: where from, where they are, and what their next step is resisted by.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Falling {
    pub from: State,
    pub state: State,
    pub drag: f64,
    /// Corrections so far, and the most of them.
    pub corrections: u32,
    pub granted: u32,
}

impl Falling {
    /// Lets the blocks of a state go, for as many corrections as are granted.
    pub(super) fn new(from: State, granted: u32) -> Falling {
        Falling { state: from.clone(), from, drag: FIRST, corrections: 0, granted }
    }

    /// One step; how the fall ends, where it does.
    pub(super) fn go_on(
        &mut self,
        model: &Model,
        settings: &Settings,
        dashpots: &Banded,
        work: &mut Workspace,
    ) -> Option<Fall> {
        if self.corrections >= self.granted {
            return Some(Fall::Lost);
        }
        assemble(model, settings, &self.state, work);
        let acting = scale(model, self.state.factor);
        let largest = work.largest();
        let balanced = largest <= model.rounding.max(settings.tolerance * acting);
        // A balanced state that needs a drag is left again.
        if balanced && work.is_stable() {
            let found = Balanced { iterations: self.corrections, residual: largest / acting };
            return Some(Fall::Rests(self.state.clone(), found));
        }
        loop {
            let (next, took) = dragged(model, settings, (dashpots, self.drag), &self.state, work);
            self.corrections += took;
            if let Some(next) = next {
                self.state = next;
                // The least drag that keeps the motion from running away within a step.
                self.drag = (self.drag * if took <= QUICK { 0.1 } else { 0.5 }).max(LEAST);
                break;
            }
            if self.drag > MOST || self.corrections >= self.granted {
                return Some(Fall::Lost);
            }
            self.drag = (4.0 * self.drag).max(1e-6);
        }
        // A comparison that a number which is not one fails.
        let stays = farthest(&self.state, &self.from) <= settings.fallen * model.size;
        (!stays).then(|| Fall::Falls(self.state.clone()))
    }
}

/// How far the block has moved that moved farthest [m].
fn farthest(now: &State, then: &State) -> f64 {
    let far = |(now, then): (&[f64; 3], &[f64; 3])| (now[0] - then[0]).hypot(now[1] - then[1]);
    now.motions.iter().zip(&then.motions).map(far).fold(0.0, f64::max)
}

/// One step against dashpots, with its corrections; no state where it takes more drag.
fn dragged(
    model: &Model,
    settings: &Settings,
    (dashpots, drag): (&Banded, f64),
    from: &State,
    work: &mut Workspace,
) -> (Option<State>, u32) {
    let mut state = from.clone();
    let mut moved = vec![0.0; model.equations];
    let enough = model.rounding.max(settings.tolerance * scale(model, state.factor));
    assemble(model, settings, &state, work);
    let mut left = work.unbalanced.clone();
    let largest = |left: &[f64]| left.iter().fold(0.0, |most: f64, f| most.max(f.abs()));
    let enough = enough.max(LEFT * largest(&left));
    for correction in 1..=MOST_CORRECTIONS {
        work.tangent.add_times(dashpots, drag);
        // Where joints slide, motions that do not happen would seem to take no work: there the determinant alone is asked. The first correction finds them
        // holding, and so does the state in which the blocks come to rest.
        let stays = work.slides || work.may_be_stable();
        if !(stays && work.tangent.factorise() && work.tangent.sign > 0) {
            return (None, correction);
        }
        let mut change = left.clone();
        work.tangent.solve(&mut change);
        let before = norm(&left);
        let (start, start_moved) = (state.clone(), moved.clone());
        let mut share = 1.0;
        for cut in 0..=MOST_CUTS {
            state.clone_from(&start);
            let part: Vec<f64> = change.iter().map(|c| share * c).collect();
            moved = start_moved.iter().zip(&part).map(|(m, p)| m + p).collect();
            advance(model, &mut state, &part, 0.0);
            assemble(model, settings, &state, work);
            let resisted = dashpots.times(&moved);
            left = work.unbalanced.iter().zip(&resisted).map(|(f, r)| f - drag * r).collect();
            let slack = if correction <= FIRST_CORRECTIONS { WORSE } else { 1.0 };
            if norm(&left) < slack * before {
                break;
            }
            if cut == MOST_CUTS {
                return (None, correction);
            }
            share *= 0.5;
        }
        if !(largest(&moved) <= LONGEST * model.size) {
            return (None, correction);
        }
        if largest(&left) <= enough {
            commit(model, settings, &mut state);
            return (Some(state), correction);
        }
    }
    (None, MOST_CORRECTIONS)
}
