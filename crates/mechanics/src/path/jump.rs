//! Where blocks come to rest that have lost their balance under a load that stays: the nearest stable state, or none.
//!
//! They move as in a viscous fluid: each step balances the forces with those of a drag, which fades as the forces do
//! (pseudo-transient continuation; Kelley and Keyes 1998). No step is balanced by an unstable state, as Newton's method would be.

use super::model::Model;
use super::settings::Settings;
use super::system::{State, Workspace, advance, assemble, commit, scale};

/// Most steps of one fall, and corrections of one step.
const MOST_STEPS: u32 = 200;
const MOST_CORRECTIONS: u32 = 8;

/// Largest motion of one step, as a share of the size of the blocks.
const LONGEST: f64 = 0.005;

/// The stable state that the blocks fall into, with the corrections that it took; none where they go on falling.
pub(super) fn fall(model: &Model, settings: &Settings, state: &State, work: &mut Workspace) -> Option<(State, u32)> {
    let start = &state.motions;
    let mut state = state.clone();
    let stiffest = model.joints.iter().map(|j| j.resistance.normal * j.bearing_length()).fold(0.0, f64::max);
    let (mut drag, mut corrections) = (1e-4 * stiffest, 0);
    for _ in 0..MOST_STEPS {
        assemble(model, settings, &state, work);
        let balanced = work.largest() <= model.rounding.max(settings.tolerance * scale(model, state.factor));
        // A balanced state that needs a drag is left again.
        if balanced && work.tangent.factorise() && work.tangent.sign > 0 {
            return Some((state, corrections));
        }
        // The least drag that keeps the motion from running away within a step.
        drag = (0.1 * drag).max(1e-12 * stiffest);
        let next = loop {
            match dragged(model, settings, &state, drag, work) {
                Some((next, took)) => {
                    corrections += took;
                    break next;
                }
                None if drag > stiffest => return None,
                None => drag = (3.0 * drag).max(1e-9 * stiffest),
            }
        };
        state = next;
        let far = |(now, then): (&[f64; 3], &[f64; 3])| (now[0] - then[0]).hypot(now[1] - then[1]);
        let moved = state.motions.iter().zip(start).map(far).fold(0.0, f64::max);
        // A comparison that a number which is not one fails.
        if !(moved <= settings.fallen * model.size) {
            return None;
        }
    }
    None
}

/// One step against a drag [N/m^2]; none where it takes more of it. A step that goes too far is cut short.
fn dragged(model: &Model, settings: &Settings, from: &State, drag: f64, work: &mut Workspace) -> Option<(State, u32)> {
    let mut state = from.clone();
    let mut moved = vec![0.0; model.equations];
    for correction in 1..=MOST_CORRECTIONS {
        assemble(model, settings, &state, work);
        let mut change: Vec<f64> = work.unbalanced.iter().zip(&moved).map(|(f, m)| f - drag * m).collect();
        let left = change.iter().fold(0.0, |most: f64, f| most.max(f.abs()));
        let done = left <= model.rounding.max(settings.tolerance * scale(model, state.factor));
        work.tangent.add_to_diagonal(drag);
        if !work.tangent.factorise() || work.tangent.sign <= 0 {
            return None;
        }
        work.tangent.solve(&mut change);
        let longest = moved.iter().zip(&change).fold(0.0, |most: f64, (m, c)| most.max((m + c).abs()));
        let share = (LONGEST * model.size / longest).min(1.0);
        change.iter_mut().for_each(|c| *c *= share);
        advance(model, &mut state, &change, 0.0);
        moved.iter_mut().zip(&change).for_each(|(m, c)| *m += c);
        if done || share < 1.0 || correction == MOST_CORRECTIONS {
            commit(model, settings, &mut state);
            return Some((state, correction));
        }
    }
    None
}
