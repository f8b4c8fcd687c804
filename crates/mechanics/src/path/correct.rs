//! From a guess to a balanced state: Newton's method on equilibrium and one more equation.

use super::model::Model;
use super::settings::Settings;
use super::system::{State, Workspace, advance, assemble, scale};
use serde::{Deserialize, Serialize};

/// The equation that goes with those of equilibrium.
#[derive(Debug, Clone, Copy)]
pub(super) enum Constraint<'a> {
    /// The factor stays.
    Load,
    /// The state stays in the plane that is normal to this direction.
    Plane(&'a [f64]),
}

/// A state that was balanced.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Balanced {
    pub iterations: u32,
    /// Largest out-of-balance force, relative to all acting forces.
    pub residual: f64,
}

const MOST_ITERATIONS: u32 = 20;

/// Halvings of one correction until it makes things better, or else worse by no more than this factor: what slides or opens is
/// often found out by a correction that does neither good nor harm. One that does harm however short leads nowhere.
const MOST_CUTS: u32 = 5;
const WORSE: f64 = 3.0;
const LAST_CUT: u32 = 6;

/// Balances a trial state; none where that does not succeed. What the state is left at is then of no use.
pub(super) fn balance(
    model: &Model,
    settings: &Settings,
    constraint: Constraint,
    state: &mut State,
    work: &mut Workspace,
) -> Option<Balanced> {
    assemble(model, settings, state, work);
    let mut trials = 0;
    for iterations in 0..=MOST_ITERATIONS {
        let acting = scale(model, state.factor);
        let largest = work.largest();
        if largest <= model.rounding.max(settings.tolerance * acting) {
            return Some(Balanced { iterations, residual: largest / acting });
        }
        if iterations == MOST_ITERATIONS || !work.tangent.factorise() {
            return None;
        }
        let mut change = work.unbalanced.clone();
        let mut factor = 0.0;
        if let Constraint::Plane(direction) = constraint {
            let mut growing = work.growing.clone();
            work.tangent.solve_together([&mut change, &mut growing]);
            factor = -dot(direction, &change) / dot(direction, &growing);
            for (c, g) in change.iter_mut().zip(&growing) {
                *c += factor * g;
            }
        } else {
            work.tangent.solve(&mut change);
        }
        // A joint that opens or closes on the way changes the tangent: a correction that makes things much worse is cut.
        let start = state.clone();
        let before = norm(&work.unbalanced);
        let mut share = 1.0;
        for cut in 0.. {
            state.clone_from(&start);
            let part: Vec<f64> = change.iter().map(|c| share * c).collect();
            advance(model, state, &part, share * factor);
            assemble(model, settings, state, work);
            trials += 1;
            let after = norm(&work.unbalanced);
            if after < before || cut >= MOST_CUTS && after < WORSE * before {
                break;
            }
            // A comparison that a number which is not one fails.
            if cut == LAST_CUT || trials >= settings.most_trials || !after.is_finite() {
                return None;
            }
            share *= 0.5;
        }
    }
    None
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}
