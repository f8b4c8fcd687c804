//! Balanced states of loads that were met before: those of a similar load are close to them.

use super::system::State;
use crate::acting::Resultant;

/// So many are kept: some cases of a vehicle at several factors each.
const KEPT: usize = 24;

/// Loads are similar that are not further apart than this: see [`Known::distance`].
const SIMILAR: f64 = 8.0;

/// The last states that were balanced, each with its load.
#[derive(Debug, Clone, Default)]
pub(super) struct Near {
    known: Vec<Known>,
    next: usize,
}

/// A load, on each of the blocks, and the state that balances it times a factor.
#[derive(Debug, Clone)]
struct Known {
    load: Vec<Resultant>,
    state: State,
}

impl Near {
    /// Keeps a state, in place of the oldest.
    pub(super) fn keep(&mut self, load: &[Resultant], state: State) {
        let known = Known { load: load.to_vec(), state };
        match self.known.get_mut(self.next) {
            Some(oldest) => *oldest = known,
            None => self.known.push(known),
        }
        self.next = (self.next + 1) % KEPT;
    }

    /// The state of the load that is most similar to this one at a load factor; none where none is.
    pub(super) fn most_similar(&self, load: &[Resultant], factor: f64) -> Option<&State> {
        let apart = self.known.iter().map(|known| (known.distance(load, factor), &known.state));
        let (distance, state) = apart.min_by(|(a, _), (b, _)| a.total_cmp(b))?;
        (distance < SIMILAR).then_some(state)
    }
}

fn size(on_block: &Resultant) -> f64 {
    on_block.force.x.abs() + on_block.force.y.abs()
}

impl Known {
    /// How far another load is from this one: by how many blocks the whole of it would have to be moved on, and as much as ten blocks
    /// for each time that it is larger or smaller.
    fn distance(&self, load: &[Resultant], factor: f64) -> f64 {
        const WHOLE: f64 = 10.0;
        let (one, other) = (load.iter().map(size).sum::<f64>(), self.load.iter().map(size).sum::<f64>());
        let (mut ahead, mut moved) = (0.0, 0.0);
        for (a, b) in load.iter().zip(&self.load) {
            ahead += size(a) / one - size(b) / other;
            moved += f64::abs(ahead);
        }
        moved + WHOLE * (1.0 - self.state.factor * other / (factor * one)).abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::vec2;

    /// Loads of 1 kN on some of thirty blocks.
    fn on(blocks: &[usize]) -> Vec<Resultant> {
        let mut load = vec![Resultant::default(); 30];
        blocks.iter().for_each(|&block| load[block].force = vec2(0.0, -1e3));
        load
    }

    fn state(factor: f64) -> State {
        State { motions: Vec::new(), factor, memory: Vec::new(), pressed: 0.0 }
    }

    #[test]
    fn a_load_is_as_far_as_its_way_and_its_size_say() {
        let known = Known { load: on(&[2, 4]), state: state(2.0) };
        let is = |load: &[usize], factor: f64, distance: f64| {
            let found = known.distance(&on(load), factor);
            assert!((found - distance).abs() < 1e-12, "{load:?} {factor}: {found}, not {distance}");
        };
        is(&[2, 4], 2.0, 0.0);
        is(&[3, 5], 2.0, 1.0);
        is(&[1, 4], 2.0, 0.5);
        is(&[2, 4], 2.5, 2.0);
        is(&[3], 4.0, 1.0);
    }

    #[test]
    fn the_nearest_is_found_and_the_oldest_forgotten() {
        let mut near = Near::default();
        near.keep(&on(&[9]), state(1.0));
        assert!(near.most_similar(&on(&[0]), 1.0).is_none());
        for block in 0..KEPT {
            near.keep(&on(&[block]), state(1.0 + 0.01 * block as f64));
        }
        assert_eq!(near.most_similar(&on(&[4]), 1.0).map(|state| state.factor), Some(1.04));
        near.keep(&on(&[8]), state(7.0));
        // The load on block 0 is gone, and that on block 9 before it.
        assert_eq!(near.most_similar(&on(&[0]), 1.0).map(|state| state.factor), Some(1.01));
        assert!(near.known.len() == KEPT);
    }
}
