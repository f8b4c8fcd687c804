//! Whether blocks rest under the permanent loads by compressions that these loads bring about.
//!
//! Friction needs compression. Between faces that do not give, any compression is a state of self-stress, and a block that could drop
//! out is held by friction if its neighbours press it hard enough: an equilibrium, but whether it comes about depends on how blocks were
//! put together. Nothing of statics tells; what is sure is what stands without friction, and, by comparison with discrete elements that begin
//! without any compression, what stands with a part of it.

use super::collapse::TOLERANCE;
use super::equilibrium::Equilibrium;
use super::joints::{Joint, Strength};
use super::nonassociated::{DAMPING, QUADRATIC_WEIGHT, REACH, compressions, level};
use super::program::{Ending, Interpretation, Program, Solution};
use std::sync::OnceLock;

/// Part of the friction with which blocks that may lock must rest. Of 2,000 drawn boxes of one to four blocks (`limit_jammed`) discrete
/// elements let 96 fall that rest with all of it from the compressions of the whole weight, 16 with two thirds, 1 where compressions that
/// wander do not count as rest, and none where these have to grow from half of the weight.
const SURELY: f64 = 2.0 / 3.0;
/// The part of the whole weight from which compressions must grow.
const HALF: f64 = 0.5;
/// Rounds within which compressions come to rest, and in which those that nothing brings about fall to 1e-5 of the whole weight.
const ROUNDS: usize = 25;
/// From this round on the weight of the newest compressions falls.
const CALMED: usize = 8;
/// Share of the permanent loads below which blocks slip.
const SLIPPED: f64 = 0.5;
/// Largest change of a scaled compression from one round to the next at which blocks rest.
const RESTS: f64 = 1e-4;

/// How blocks rest under the permanent loads, asked once for all variable ones.
#[derive(Debug, Default)]
pub(super) struct Rest {
    slips: OnceLock<bool>,
    sure: OnceLock<bool>,
}

/// What the compressions come to from those of the whole weight.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Compressions {
    Rest,
    Vanish,
    Wander,
}

impl Rest {
    /// Whether blocks slip once joints lose the compressions that nothing but self-stress brings about.
    pub(super) fn slips(&self, equilibrium: &Equilibrium, joints: &[Joint], strengths: &[Strength]) -> bool {
        *self.slips.get_or_init(|| followed(equilibrium, joints, strengths, 1.0) == Compressions::Vanish)
    }

    /// Whether blocks rest however they were put together: without friction, or well within it.
    pub(super) fn is_sure(&self, equilibrium: &Equilibrium, joints: &[Joint], strengths: &[Strength]) -> bool {
        *self.sure.get_or_init(|| {
            let with = |share: f64| {
                let part = strengths.iter().map(|s| Strength { friction: s.friction * share, ..*s });
                part.collect::<Vec<_>>()
            };
            let smooth = share(equilibrium, joints, &with(0.0), 0.0, 1e-8);
            (smooth.ending == Ending::Solved && smooth.factor > SLIPPED)
                || followed(equilibrium, joints, &with(SURELY), HALF) == Compressions::Rest
        })
    }
}

/// Follows compressions from round to round, from this part of the whole weight in every joint: the share of the permanent loads that the fictitious
/// surfaces carry falls where friction needs compression and compression needs friction.
fn followed(equilibrium: &Equilibrium, joints: &[Joint], strengths: &[Strength], begin: f64) -> Compressions {
    let mut compression = vec![begin; joints.len()];
    for round in 0..ROUNDS {
        let pressed = strengths.iter().zip(&compression);
        let fictitious: Vec<Strength> =
            pressed.map(|(s, c): (_, &f64)| level(s, REACH, c.max(0.0) * equilibrium.force)).collect();
        let found = share(equilibrium, joints, &fictitious, QUADRATIC_WEIGHT, TOLERANCE);
        if found.ending == Ending::Unknown {
            return Compressions::Wander;
        }
        if found.factor < SLIPPED {
            return Compressions::Vanish;
        }
        let new = compressions(equilibrium, joints, &found.forces);
        let change = compression.iter().zip(&new).map(|(old, new)| (old - new).abs()).fold(0.0, f64::max);
        if change <= RESTS {
            return Compressions::Rest;
        }
        let (calmed, beyond) = (CALMED as f64, round.saturating_sub(CALMED) as f64);
        let newest = DAMPING * calmed / (calmed + 2.0 * beyond);
        for (old, new) in compression.iter_mut().zip(new) {
            *old += newest * (new - *old);
        }
    }
    Compressions::Wander
}

/// The largest share of the permanent loads, up to all, that the joints carry. Always solvable: without loads no joint needs any force.
/// Without cohesion and crushing the answer is all or nothing.
pub(super) fn share(
    equilibrium: &Equilibrium,
    joints: &[Joint],
    strengths: &[Strength],
    quadratic_weight: f64,
    tolerance: f64,
) -> Solution {
    Program {
        equilibrium,
        joints,
        strengths,
        scaled_loads: &equilibrium.permanent,
        constant_loads: &vec![0.0; equilibrium.rows],
        cap: Some(1.0),
        objective: Vec::new(),
        quadratic_weight,
        interpretation: Interpretation::Factor,
    }
    .solve(tolerance)
}
