//! Conservative rule: what may help a bridge and may come and go is not counted.
//!
//! Every method and every question is answered for the bridge as its file describes it and without each of these helps; what is least leads,
//! and what the others come to stands beside it. A help may also hurt (water weighs): then it is counted. Which helps there are, and how a
//! bridge loses one, stands in [`change`]; what is compared stands in [`least`] for one load, in [`sweep`] for loads and in [`vehicles`] for
//! vehicles that move. Methods and questions know nothing of it: they are given one state of the bridge at a time.

mod change;
mod least;
mod scene;
mod sweep;
mod vehicles;

pub(super) use least::{collapse, of_blocks};
pub(super) use sweep::swept;
pub(super) use vehicles::moved;

use super::engine::can::{self, Feature, Knows};
use super::state::{self, Change};
use bridge::{Analysis, Bridge, Method};
use outcome::help::{Help, NotCounted, WithHelp};
use outcome::note::{self, Note, Size};
use outcome::warning::{self, Warning};

/// Help that changes a result by less than this share makes no difference, and is not told.
const SAME: f64 = 1e-3;

/// A bridge with some of the helps that its file describes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct State<T> {
    pub bridge: T,
    /// Those that it counts, in the order of [`Help::ALL`].
    pub helps: Vec<Help>,
}

impl<T> State<T> {
    /// Whether it counts strength that may be lost, which only adds to a load.
    pub(super) fn counts_strength(&self) -> bool {
        self.helps.iter().any(|help| help.is_strength())
    }
}

/// Every state that may lead: the bridge without strength that may be lost and with every set of the other helps, none of them first, all of
/// them last; then the bridge as described, where that is another one. A bridge without helps has one state. Lost stone of which a part alone is
/// there does not count as help.
pub(super) fn states(bridge: &Bridge) -> Vec<State<Bridge>> {
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
pub(super) fn states_of_moving(bridge: &Bridge) -> Vec<State<Bridge>> {
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
fn sets(all: &[Help]) -> Vec<Vec<Help>> {
    let free: Vec<Help> = all.iter().copied().filter(|help| !help.is_strength()).collect();
    let mut sets: Vec<Vec<Help>> = (0..1_usize << free.len())
        .map(|set| free.iter().enumerate().filter(|(k, _)| set >> k & 1 == 1).map(|(_, help)| *help).collect())
        .collect();
    if free.len() < all.len() {
        sets.push(all.to_vec());
    }
    sets
}

/// What a state comes to: its size, by which states are compared (more is better), and its numbers for a reader.
struct Standing {
    helps: Vec<Help>,
    size: f64,
    numbers: WithHelp,
}

/// The state that leads: of those that are least to round-off, the one that counts most.
fn leading(all: &[Standing]) -> usize {
    let least = all.iter().map(|one| one.size).fold(f64::INFINITY, f64::min);
    let near = |size: f64| size <= least || (size - least).abs() <= 1e-9 * least.abs();
    (0..all.len()).rev().find(|k| near(all[*k].size)).unwrap_or(0)
}

/// Whether one is more than another, and more than round-off.
fn is_more(size: f64, than: f64) -> bool {
    size > than && (than.is_infinite() || size - than > SAME * than.abs())
}

/// What the leading state does not count, and what each state that counts more of it comes to.
fn not_counted(all: &[Standing], lead: usize) -> NotCounted {
    let counted = &all[lead].helps;
    let adds =
        |one: &&Standing| one.helps.iter().any(|help| !counted.contains(help)) && is_more(one.size, all[lead].size);
    let with_help: Vec<WithHelp> = all.iter().filter(adds).map(|one| one.numbers.clone()).collect();
    let left_out = Help::ALL
        .iter()
        .copied()
        .filter(|help| !counted.contains(help) && with_help.iter().any(|with| with.helps.contains(help)));
    NotCounted { left_out: left_out.collect(), with_help }
}

/// What is told of help that is left out of the bridge, or of a vehicle on it; fill pressure by itself has words of its own (A195). `own`
/// is what leads.
fn warned(found: &NotCounted, vehicle: Option<&str>, own: Size, size: fn(&WithHelp) -> Size) -> Option<Warning> {
    if found.left_out.iter().all(|help| *help == Help::FillPressure) {
        return None;
    }
    let with = found.with_help.iter().map(|with| (size(with), with.helps.clone())).collect();
    let (vehicle, left_out) = (vehicle.map(str::to_owned), found.left_out.clone());
    Some(warning::Loads::HelpNotCounted { vehicle, own, left_out, with }.into())
}

/// Help that hurts, and is counted.
fn hurts(all: &[Standing], lead: usize, size: fn(&WithHelp) -> Size) -> Option<Note> {
    let counted = &all[lead].helps;
    let bare = all.iter().find(|one| one.helps.is_empty())?;
    let hurts = is_more(bare.size, all[lead].size) && !counted.is_empty();
    let [without, with] = [bare, &all[lead]].map(|one| size(&one.numbers));
    hurts.then(|| note::State::Counted { helps: counted.clone(), without, with }.into())
}

#[cfg(test)]
mod tests;
