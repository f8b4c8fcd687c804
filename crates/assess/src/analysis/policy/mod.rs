//! Conservative rule: what may help a bridge and may come and go is not counted.
//!
//! Every method and every question is answered for the bridge as its file describes it and without each of these helps; what is least leads,
//! and what the others come to stands beside it. A help may also hurt (water weighs): then it is counted. Which helps there are, and how a
//! bridge loses one, stands in [`change`]; what is compared stands in [`least`] for one load, in [`sweep`] for loads and in [`vehicles`] for
//! vehicles that move. Methods and questions know nothing of it: they are given one state of the bridge at a time.

mod change;
mod least;
mod scene;
mod standing;
mod states;
mod sweep;
mod turns;
mod vehicles;

pub(super) use least::{least, least_of};
pub(super) use scene::states_of_blocks;
pub use states::bare;
pub(super) use states::{states, states_of_moving};
pub(super) use sweep::swept;
pub(super) use turns::Turns;
pub(super) use vehicles::moved;

#[cfg(test)]
mod tests;
