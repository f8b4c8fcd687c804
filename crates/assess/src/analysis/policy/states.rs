//! States of a bridge: which of the helps that its file describes it counts.

use super::change;
use crate::analysis::engine::can::{self, Feature, Knows};
use crate::analysis::state::{self, Change};
use bridge::{Analysis, Bridge, Method};
use outcome::help::Help;

/// A bridge with some of the helps that its file describes.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::analysis) struct State<T> {
    pub bridge: T,
    /// Those that it counts, in the order of [`Help::ALL`].
    pub helps: Vec<Help>,
}

impl<T> State<T> {
    /// Whether it counts strength that may be lost, which only adds to a load.
    pub(in crate::analysis) fn counts_strength(&self) -> bool {
        self.helps.iter().any(|help| help.is_strength())
    }
}

/// Every state that may lead: the bridge without strength that may be lost and with every set of the other helps, none of them first, all of
/// them last; then the bridge as described, where that is another one. A bridge without helps has one state. Lost stone of which a part alone is
/// there does not count as help.
pub(in crate::analysis) fn states(bridge: &Bridge) -> Vec<State<Bridge>> {
    let all = change::helps(bridge);
    let of_set = |helps: Vec<Help>| {
        let bridges = match all.contains(&Help::LostStone) && !helps.contains(&Help::LostStone) {
            false => Vec::new(),
            true => change::with_some_lost_stone(bridge),
        };
        let within: Vec<Help> = helps.iter().copied().chain([Help::LostStone]).collect();
        let whole = State { bridge: change::with_only(bridge, &all, &helps), helps: helps.clone() };
        let parts = bridges.into_iter().map(|some| change::with_only(&some, &all, &within));
        [whole].into_iter().chain(parts.map(|bridge| State { bridge, helps: helps.clone() })).collect::<Vec<_>>()
    };
    sets(&all).into_iter().flat_map(of_set).collect()
}

/// The same for loads that are moved over the bridge, which limit analysis does where the plan's method does not.
pub(in crate::analysis) fn states_of_moving(bridge: &Bridge) -> Vec<State<Bridge>> {
    let by_limit = can::knows(bridge.plan.method, Feature::LoadSweep) == Knows::ByLimit;
    let method = if by_limit { Method::Limit } else { bridge.plan.method };
    let moving = state::with(bridge, &[Change::Analysis(Analysis::Load), Change::Method(method)]);
    let mut states = states(&moving);
    states.iter_mut().for_each(|state| {
        (state.bridge.plan.analysis, state.bridge.plan.method) = (bridge.plan.analysis, bridge.plan.method);
    });
    states
}

/// The bridge without anything that may come and go: what leads unless a help hurts. Stone that is lost mostly hurts, and stays lost.
pub fn bare(bridge: &Bridge) -> Bridge {
    change::with_only(bridge, &change::helps(bridge), &[Help::LostStone])
}

/// The sets of helps that are counted together.
pub(super) fn sets(all: &[Help]) -> Vec<Vec<Help>> {
    let free: Vec<Help> = all.iter().copied().filter(|help| !help.is_strength()).collect();
    let mut sets: Vec<Vec<Help>> = (0..1_usize << free.len())
        .map(|set| free.iter().enumerate().filter(|(k, _)| set >> k & 1 == 1).map(|(_, help)| *help).collect())
        .collect();
    if free.len() < all.len() {
        sets.push(all.to_vec());
    }
    sets
}
