//! Many walkers that learn the shape of the posterior from one another: stretch moves (Goodman and Weare 2010) and
//! differences of two others (ter Braak 2006), of which every tenth is taken whole so that walkers cross between modes.
//! The two halves move in turn, each from the other, so that a half is one batch of evaluations.

use rand_chacha::ChaCha8Rng;

use crate::posterior::draw::{even, normal, place};
use crate::posterior::gain::Gain;
use crate::posterior::target::{Draw, Target};
use crate::watch::Stopped;

/// Places of a chain at which every second one is let go: steps that are that many are correlated over hundreds, so that nothing is lost, and memory
/// stays where it is (80 walkers with 6 numbers each: 30 MB).
const LONGEST: usize = 5_000;

/// Where a walker was, and the common gain there.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Kept {
    pub place: Vec<f64>,
    pub gain: Gain,
}

/// Walkers on their way.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ensemble {
    /// Where they are.
    pub walkers: Vec<Draw>,
    /// Where each was, after every so many steps.
    pub chains: Vec<Vec<Kept>>,
    /// Steps that were made.
    pub steps: usize,
    /// Steps from one place of a chain to the next.
    every: usize,
}

impl Ensemble {
    /// Walkers at their beginnings; an even number of them.
    pub(super) fn new(walkers: Vec<Draw>) -> Self {
        Self { chains: vec![Vec::new(); walkers.len()], walkers, steps: 0, every: 1 }
    }

    /// All walkers make so many steps.
    pub(super) fn walk(&mut self, target: &mut Target, rng: &mut ChaCha8Rng, steps: usize) -> Result<(), Stopped> {
        for _ in 0..steps {
            for half in 0..2 {
                self.move_half(target, rng, half)?;
            }
            self.steps += 1;
            self.record();
        }
        Ok(())
    }

    /// Adds to the chains where the walkers are, if it is time to.
    fn record(&mut self) {
        if !self.steps.is_multiple_of(self.every) {
            return;
        }
        for (chain, walker) in self.chains.iter_mut().zip(&self.walkers) {
            chain.push(Kept { place: walker.place.clone(), gain: walker.gain });
        }
        if self.chains[0].len() < LONGEST {
            return;
        }
        self.every *= 2;
        for chain in &mut self.chains {
            // Those stay whose step is a multiple of what now lies between two.
            *chain = std::mem::take(chain).into_iter().skip(1).step_by(2).collect();
        }
    }

    fn move_half(&mut self, target: &mut Target, rng: &mut ChaCha8Rng, half: usize) -> Result<(), Stopped> {
        let count = self.walkers.len() / 2;
        let (moving, other) = (half * count, (1 - half) * count);
        let others: Vec<Vec<f64>> = self.walkers[other..other + count].iter().map(|w| w.place.clone()).collect();
        let proposals: Vec<(Vec<f64>, f64)> =
            (moving..moving + count).map(|k| propose(rng, &self.walkers[k].place, &others)).collect();
        let (places, factors): (Vec<_>, Vec<_>) = proposals.into_iter().unzip();
        let draws = target.draws(places)?;
        for ((walker, draw), factor) in self.walkers[moving..moving + count].iter_mut().zip(draws).zip(factors) {
            let gain = factor + draw.prior + draw.likelihood - walker.prior - walker.likelihood;
            if even(rng).ln() < gain {
                *walker = draw;
            }
        }
        Ok(())
    }
}

/// A new place, and the logarithm of the factor by which its acceptance is multiplied.
fn propose(rng: &mut ChaCha8Rng, from: &[f64], others: &[Vec<f64>]) -> (Vec<f64>, f64) {
    let axes = from.len();
    let first = place(rng, others.len());
    if even(rng) < 0.3 {
        let stretch = (even(rng) + 1.0).powi(2) / 2.0;
        let next = from.iter().zip(&others[first]).map(|(x, other)| other + stretch * (x - other)).collect();
        return (next, (axes as f64 - 1.0) * stretch.ln());
    }
    let second = (first + 1 + place(rng, others.len() - 1)) % others.len();
    let whole = even(rng) < 0.1;
    let share = if whole { 1.0 } else { 2.38 / (2.0 * axes as f64).sqrt() };
    let along = |axis: usize| share * (others[first][axis] - others[second][axis]);
    ((0..axes).map(|axis| from[axis] + along(axis) + 1e-5 * normal(rng)).collect(), 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_chains_keep_every_so_manieth_step() {
        let gain = Gain { mean: 1.0, variance: 0.0 };
        let walker = || Draw { place: vec![0.0], prior: 0.0, likelihood: 0.0, gain };
        let mut ensemble = Ensemble::new(vec![walker(), walker()]);
        for step in 1..=3 * LONGEST {
            ensemble.walkers.iter_mut().for_each(|walker| walker.place[0] = step as f64);
            ensemble.steps = step;
            ensemble.record();
        }
        assert_eq!(ensemble.every, 4);
        for chain in &ensemble.chains {
            assert!(chain.iter().enumerate().all(|(k, kept)| kept.place[0] == (4 * (k + 1)) as f64));
            assert_eq!(chain.len(), 3 * LONGEST / 4);
        }
    }
}
