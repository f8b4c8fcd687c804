//! Whether blocks rest under the permanent loads by compressions that these loads bring about.
//!
//! Friction needs compression. Between faces that do not give, any compression is a state of self-stress, and a block that could drop
//! out is held by friction if its neighbours press it hard enough: an equilibrium, but whether it comes about depends on how blocks were
//! put together. Nothing of statics tells; what is sure is what stands without friction, and, by comparison with discrete elements that begin
//! without any compression, what comes to rest with a part of it.

use super::equilibrium::Equilibrium;
use super::joints::Strength;
use super::program::{Program, Solution};
use super::stiff::{Stood, stood};
use crate::watch::CancelToken;
use std::sync::OnceLock;

/// Part of the friction with which blocks that may lock must come to rest, as well as with all of it. Of 7,000 drawn boxes of one to four blocks
/// (`limit_jammed`) discrete elements let 1 of 1,359 fall that rest so, with a quarter 3 of 2,024, with a third 8 of 2,285.
const SURELY: f64 = 0.1;
/// Share of the permanent loads below which blocks slip.
const SLIPPED: f64 = 0.5;

/// How blocks rest under the permanent loads, asked once for all variable ones.
#[derive(Debug, Default)]
pub(super) struct Rest {
    stood: OnceLock<Option<Stood>>,
    sure: OnceLock<bool>,
}

impl Rest {
    /// Blocks at rest between stiff joints; none where they do not come to rest.
    pub(super) fn stood(&self, equilibrium: &Equilibrium) -> Option<&Stood> {
        self.stood.get_or_init(|| stood(equilibrium)).as_ref()
    }

    /// Whether blocks rest however they were put together: without friction, or well within it.
    pub(super) fn is_sure(&self, equilibrium: &Equilibrium) -> bool {
        *self.sure.get_or_init(|| {
            let with = |share: f64| equilibrium.with_strengths(|s| Strength { friction: s.friction * share, ..*s });
            // What is kept for all loads does not hang on when one of them was cancelled.
            let smooth = share(&Equilibrium { token: CancelToken::default(), ..with(0.0) });
            (smooth.solved && smooth.factor > SLIPPED)
                || (stood(&with(SURELY)).is_some() && self.stood(equilibrium).is_some())
        })
    }
}

/// The largest share of the permanent loads, up to all, that the joints carry. Always solvable: without loads no joint needs any force.
/// Without cohesion and crushing the answer is all or nothing.
pub(super) fn share(equilibrium: &Equilibrium) -> Solution {
    Program {
        scaled_loads: &equilibrium.permanent,
        constant_loads: &vec![0.0; equilibrium.rows],
        cap: Some(1.0),
        ..Program::of_the_factor(equilibrium)
    }
    .solve(1e-8)
}
