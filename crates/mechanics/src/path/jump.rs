//! Where blocks come to rest that have lost their balance under a load that stays: the nearest stable state, or none.
//!
//! They move as in a viscous fluid: each step balances the forces with those of a drag, which fades as the forces do
//! (pseudo-transient continuation; Kelley and Keyes 1998). No step is balanced by an unstable state, as Newton's method would be.

use super::model::Model;
use super::settings::Settings;
use super::system::{State, Workspace, advance, assemble, commit, scale};

/// Most steps of one fall.
const MOST_STEPS: u32 = 400;

/// Largest motion of one step, as a share of the size of the blocks.
const LONGEST: f64 = 0.005;

/// The stable state that the blocks fall into, with the steps that it took; none where they go on falling.
pub(super) fn fall(model: &Model, settings: &Settings, state: &State, work: &mut Workspace) -> Option<(State, u32)> {
    let mut state = state.clone();
    let start = state.motions.clone();
    let stiffest = model.joints.iter().map(|j| j.resistance.normal * j.built_length()).fold(0.0, f64::max);
    assemble(model, settings, &state, work);
    let mut drag = 1e-4 * stiffest;
    for step in 0..MOST_STEPS {
        let balanced = work.largest() <= model.rounding.max(settings.tolerance * scale(model, state.factor));
        let undamped = work.tangent.clone();
        // The least drag that keeps the motion from running away within a step.
        drag = if balanced { 0.0 } else { (0.1 * drag).max(1e-12 * stiffest) };
        loop {
            work.tangent.clone_from(&undamped);
            work.tangent.add_to_diagonal(drag);
            if work.tangent.factorise() && work.tangent.sign > 0 {
                break;
            }
            drag = (3.0 * drag).max(1e-9 * stiffest);
            if drag > stiffest {
                return None;
            }
        }
        // A balanced state that needs a drag is left again.
        if balanced && drag == 0.0 {
            return Some((state, step));
        }
        let mut change = work.unbalanced.clone();
        work.tangent.solve(&mut change);
        let longest = change.iter().fold(0.0, |most: f64, c| most.max(c.abs()));
        let share = (LONGEST * model.size / longest).min(1.0);
        change.iter_mut().for_each(|c| *c *= share);
        advance(model, &mut state, &change, 0.0);
        commit(model, settings, &mut state);
        assemble(model, settings, &state, work);
        let far = |(now, then): (&[f64; 3], &[f64; 3])| (now[0] - then[0]).hypot(now[1] - then[1]);
        let moved = state.motions.iter().zip(&start).map(far).fold(0.0, f64::max);
        if !work.largest().is_finite() || moved > settings.fallen * model.size {
            return None;
        }
    }
    None
}
