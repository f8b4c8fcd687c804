//! What blocks carry where sliding does not dilate, and which of the loads with and without dilation counts.
//!
//! Blocks between fixed faces may lock with dilation: any compression of their joints is a state of self-stress, and friction on it
//! carries any load. Without dilation the compression must come from somewhere. Where the loads alone are carried without any friction they
//! drive no mechanism, whatever the flow rule: the blocks lock. Where blocks stand on the friction of compressions that nothing but
//! self-stress brings about, what they carry depends on how hard they were jammed, and no load is known.

use super::collapse::{Found, locks};
use super::equilibrium::Equilibrium;
use super::joints::{Joint, Strength};
use super::nonassociated::{Settled, settle, settle_near};
use super::outcome::Status;
use super::program::Ending;
use super::rest::Rest;
use super::settings::Friction;

/// Beside a load so many times all permanent loads, these are less than what the solver can see: geometry and friction alone carry the
/// load, and would carry any other.
const LOCKED: f64 = 1e3;

/// How far below the load with dilation one without it lies that is a load of its own, relative: starts of the iteration agree to this.
const BELOW: f64 = 1e-4;

/// Loads this far below zero, scaled, are zero.
const ZERO: f64 = 1e-6;

/// A load without dilation, and what the iteration for a load that differs a little may start from. It belongs to its ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// The load factor.
    pub factor: f64,
    /// Scaled compressions of the joints at the end of the iteration.
    pub(super) compressions: Vec<f64>,
}

/// What is carried where sliding does not dilate.
pub(super) enum WithoutDilation {
    /// The lowest load of the iteration.
    Load(Settled),
    /// Every load.
    Locks,
    /// What blocks carry depends on how hard they are jammed.
    Jammed,
    /// The iteration found no end.
    Unsettled,
}

/// Which of the loads with and without dilation counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Governs {
    WithDilation,
    WithoutDilation,
}

/// The load without dilation: from the end point of a load nearby alone, where one is given and leads to an end, or the lowest from all
/// starts. `found` is the load with dilation; how blocks rest under the permanent loads is asked once for all.
pub(super) fn without_dilation(
    equilibrium: &Equilibrium,
    joints: &[Joint],
    strengths: &[Strength],
    found: &Found,
    near: Option<&[f64]>,
    at_rest: &Rest,
) -> WithoutDilation {
    let endless = found.status == Status::Locks;
    // Where any load is carried with dilation, blocks may be held by compressions that nothing brings about.
    let jammed = || match endless {
        true => !at_rest.is_sure(equilibrium, joints, strengths),
        false => at_rest.slips(equilibrium, joints, strengths),
    };
    if endless && drives_nothing(equilibrium, joints, strengths) {
        return if jammed() { WithoutDilation::Jammed } else { WithoutDilation::Locks };
    }
    let beside = near.and_then(|near| settle_near(equilibrium, joints, strengths, near));
    let associated = (found.status == Status::Solved).then_some(&found.solution.forces[..]);
    let Some(mut settled) = beside.or_else(|| settle(equilibrium, joints, strengths, associated)) else {
        return match endless && jammed() {
            true => WithoutDilation::Jammed,
            false => WithoutDilation::Unsettled,
        };
    };
    let factor = settled.solution.factor;
    let lower = endless || factor < (1.0 - BELOW) * found.solution.factor;
    if factor < -ZERO || (lower && jammed()) {
        return WithoutDilation::Jammed;
    }
    if endless && factor > LOCKED {
        return WithoutDilation::Locks;
    }
    settled.solution.factor = factor.max(0.0);
    settled.spread = settled.spread.map(|factor| factor.max(0.0));
    WithoutDilation::Load(settled)
}

impl WithoutDilation {
    /// The end of the iteration, for loads nearby; `scale` is the factor of a scaled one.
    pub(super) fn end(&self, scale: f64) -> Option<Level> {
        match self {
            WithoutDilation::Load(settled) => {
                Some(Level { factor: settled.solution.factor * scale, compressions: settled.compressions.clone() })
            }
            _ => None,
        }
    }

    /// Which load counts by the friction that is asked for, beside a load with dilation in whose mechanism joints slide or not.
    pub(super) fn governs(&self, friction: Friction, found: &Found, slides: bool) -> Governs {
        let own = match friction {
            Friction::Associated => false,
            Friction::NonAssociated => true,
            Friction::Automatic if found.status == Status::Locks => true,
            // A mechanism in which no joint slides forms without dilation as well, but another one may form below it.
            Friction::Automatic => match self {
                WithoutDilation::Load(level) => slides || level.solution.factor < (1.0 - BELOW) * found.solution.factor,
                WithoutDilation::Jammed => true,
                WithoutDilation::Locks => false,
                WithoutDilation::Unsettled => slides,
            },
        };
        if own { Governs::WithoutDilation } else { Governs::WithDilation }
    }
}

/// Whether the load alone is carried without any friction. Compressions that do so take up work wherever joints open: no motion that
/// opens joints and slides level is driven by the load, however large it is.
fn drives_nothing(equilibrium: &Equilibrium, joints: &[Joint], strengths: &[Strength]) -> bool {
    let smooth: Vec<Strength> = strengths.iter().map(|s| Strength { friction: 0.0, ..*s }).collect();
    let found = locks(equilibrium, joints, &smooth);
    found.ending == Ending::Solved && found.factor > 0.5
}
