//! Loads that move over rigid blocks: the least that they come to, by one rule for the loads of a file and for vehicles under factors.
//!
//! In the order of the method: [`Stands`] tells what may stand at a place, `place` answers all of it with dilation, `level` answers cases
//! without dilation, `search` goes over every place and seeks the worst one between them, beside the places that `dips` names. `least` says which of several answers governs, `turns`
//! which cases are still to be asked without dilation, and `sections` keeps what joints carry meanwhile.

mod dips;
mod least;
mod level;
mod place;
mod search;
mod sections;
mod turns;

pub(crate) use dips::dips;
pub(crate) use least::{Answer, least};
pub(crate) use place::{FAR_ABOVE, Found, Place, Tried};
pub(crate) use search::{Line, REFINEMENTS, search};
pub(crate) use sections::{Watched, outside, watched};
pub(crate) use turns::{Turns, spaced};

use mechanics::limit::{Effect, Friction, Ground, Sweeper};

/// Cases in which joints slide count from this multiple of the least factor down: dilatancy is worth up to half of an
/// associated load in walls of blocks (docs/theory/limit-analysis.md), less in arches.
pub(crate) const DILATANCY: f64 = 2.0;

/// What stands on the bridge, by numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Key {
    /// Which vehicle, in which arrangement, driving which way.
    pub drive: usize,
    /// Which combination of factors on weights.
    pub weights: usize,
    /// Position of the first axle [m].
    pub position: f64,
    /// First and last axle on the bridge.
    pub axles: Option<[usize; 2]>,
    /// The axle with the factor of the critical one.
    pub critical: Option<usize>,
    /// First and last piece with uniform loads.
    pub uniform: Option<[usize; 2]>,
}

impl Key {
    /// Nothing with the first axle of a drive at a position [m].
    pub(crate) fn at(drive: usize, position: f64) -> Key {
        Key { drive, weights: 0, position, axles: None, critical: None, uniform: None }
    }

    /// How many axles stand on the bridge, and how many pieces with uniform loads.
    pub(crate) fn extent(&self) -> [usize; 2] {
        [self.axles, self.uniform].map(|run| run.map_or(0, |[first, last]| last + 1 - first))
    }
}

/// What may stand where.
pub(crate) trait Stands: Sync {
    /// Everything that may stand with the first axle of a drive at a position [m], under the first combination of weights. A sweeper of the
    /// first ground finds the effects.
    fn cases(&self, sweeper: &mut Sweeper<'_>, drive: usize, position: f64) -> Vec<(Key, Effect)>;
}

/// Which cases are answered without dilation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum WithoutDilation {
    /// At every place those up to [`DILATANCY`] times the least factor of all places, and those that lock, as the plan's friction says: each
    /// place has its own answer.
    Everywhere(Friction),
    /// In turn from the least factor up, as long as one may govern, and beside them those that lock: only the worst place has its own answer.
    /// Of neighbouring places those are asked that are least among them, and others no nearer together than this [m].
    InTurn(f64),
}

/// What all cases share.
pub(crate) struct Scene<'a, S> {
    /// What may stand where.
    pub stands: &'a S,
    /// The bridge under each combination of factors on weights.
    pub grounds: &'a [Ground],
    /// Joints whose forces are kept.
    pub watched: &'a [Watched],
    /// Whether slow cases are left out whose upper bound lies far above the least factor.
    pub screen: bool,
    /// Mechanisms that bound slow cases to begin with; none where cases are fast.
    pub seeds: &'a [Vec<f64>],
    /// Which cases are answered without dilation.
    pub without_dilation: WithoutDilation,
}

impl<S: Stands> Scene<'_, S> {
    /// The effect of one case at another position.
    pub(crate) fn again(&self, sweepers: &mut [Sweeper<'_>], key: &Key, position: f64) -> Option<(Key, Effect)> {
        let wanted = Key { position, ..*key };
        let cases = self.stands.cases(&mut sweepers[0], key.drive, position);
        let (_, effect) = cases.into_iter().find(|(other, _)| Key { weights: key.weights, ..*other } == wanted)?;
        Some((wanted, self.under(&effect, key.weights)))
    }

    /// An effect as the ground of other weights counts it.
    pub(crate) fn under(&self, effect: &Effect, weights: usize) -> Effect {
        self.grounds[weights].taken(effect, &self.grounds[0])
    }

    /// Sweepers of every ground that know nothing yet.
    fn sweepers(&self, token: &mechanics::watch::CancelToken) -> Vec<Sweeper<'_>> {
        self.grounds.iter().map(|ground| ground.sweeper().paced(token)).collect()
    }
}

/// Every run of neighbours among `count`.
pub(crate) fn runs(count: usize, all: bool) -> Vec<[usize; 2]> {
    match (count, all) {
        (0, _) => Vec::new(),
        (_, false) => vec![[0, count - 1]],
        (_, true) => (0..count).flat_map(|a| (a..count).map(move |b| [a, b])).collect(),
    }
}
