//! What blocks carry where sliding does not dilate, and which of the loads with and without dilation counts.
//!
//! Blocks between fixed faces may lock with dilation: any compression of their joints is a state of self-stress, and friction on it
//! carries any load. Without dilation the compression must come from somewhere. Where the loads alone are carried without any friction they
//! drive no mechanism, whatever the flow rule: the blocks lock. Where blocks stand on the friction of compressions that nothing but
//! self-stress brings about, what they carry depends on how hard they were jammed, and no load is known.

use super::collapse::locks;
use super::equilibrium::Equilibrium;
use super::joints::Strength;
use super::outcome::Status;
use super::program::Solution;
use super::rest::Rest;
use super::settings::Friction;
use super::stiff::WithoutDilation;

/// Beside a load so many times all permanent loads, these are less than what the solver can see: geometry and friction alone carry the
/// load, and would carry any other.
const LOCKED: f64 = 1e3;

/// How far below the load with dilation one without it lies that is a load of its own: relative, ten times what the chords of crushing take; and
/// beside all permanent loads.
const BELOW: [f64; 2] = [4e-4, 1e-8];

/// Loads this far below zero, scaled, are zero.
const ZERO: f64 = 1e-6;

/// The load with dilation beside it.
#[derive(Debug, Clone, Copy)]
pub(super) struct WithDilation {
    /// Solved, or every load is carried.
    pub status: Status,
    /// Its scaled factor, where it is solved.
    pub factor: f64,
    /// Whether joints slide in its mechanism.
    pub slides: bool,
}

/// The load without dilation, beside one with it; how blocks rest under the permanent loads is asked once for all.
pub(super) fn without_dilation(equilibrium: &Equilibrium, beside: &WithDilation, at_rest: &Rest) -> WithoutDilation {
    let endless = beside.status == Status::Locks;
    // Where any load is carried with dilation, blocks may be held by compressions that nothing brings about.
    if endless && !at_rest.is_sure(equilibrium) {
        return WithoutDilation::Jammed;
    }
    if endless && drives_nothing(equilibrium) {
        return WithoutDilation::Locks;
    }
    let Some(stood) = at_rest.stood(equilibrium) else { return WithoutDilation::Jammed };
    match stood.under(equilibrium, if endless { LOCKED } else { f64::INFINITY }) {
        WithoutDilation::Load { solution, .. } if solution.factor < -ZERO => WithoutDilation::Jammed,
        WithoutDilation::Load { mut solution, spread, comes_and_goes } => {
            solution.factor = solution.factor.max(0.0);
            let spread = spread.map(|factor| factor.max(0.0));
            WithoutDilation::Load { solution, spread, comes_and_goes }
        }
        other => other,
    }
}

impl WithoutDilation {
    /// Whether this counts by the friction that is asked for, and not the load with dilation.
    pub(super) fn governs(&self, friction: Friction, beside: &WithDilation) -> bool {
        let WithDilation { status, factor, slides } = *beside;
        let below = |solution: &Solution| solution.factor < (1.0 - BELOW[0]) * factor - BELOW[1];
        match friction {
            Friction::Associated => false,
            Friction::NonAssociated => true,
            Friction::Automatic if status == Status::Locks => true,
            // A mechanism in which no joint slides forms without dilation as well, but another one may form below it.
            Friction::Automatic => match self {
                WithoutDilation::Load { solution, .. } => slides || below(solution),
                WithoutDilation::Jammed => true,
                WithoutDilation::Locks => false,
                WithoutDilation::Unsettled => slides,
            },
        }
    }
}

/// Whether the load alone is carried without any friction. Compressions that do so take up work wherever joints open: no motion that
/// opens joints and slides level is driven by the load, however large it is.
fn drives_nothing(equilibrium: &Equilibrium) -> bool {
    let found = locks(&equilibrium.with_strengths(|s| Strength { friction: 0.0, ..*s }));
    found.solved && found.factor > 0.5
}
