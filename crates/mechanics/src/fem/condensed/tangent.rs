//! The tangent on the forces of some rows, `1 - S G`, with `S` the slopes of the parts' excess.

use super::rows::widest;
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::lu::partial_pivoting::{factor, solve};
use faer::perm::PermRef;
use faer::{Conj, MatMut, MatRef, Par};
use std::ops::Range;

/// One entry of `S`: row, column, derivative, by places among the rows at hand.
pub(super) type Slope = (usize, usize, f64);

/// Factorised on the rows whose row of `S` is not empty, a few hundred; the step of the others is what is given.
#[derive(Default)]
pub(super) struct Tangent {
    /// Those rows in ascending order, and the place of each among them.
    pub steep: Vec<usize>,
    among: Vec<usize>,
    /// Factors of the transpose, in place of the tangent itself: its rows lie in columns, and so do those of `G`.
    factors: Vec<f64>,
    forward: Vec<usize>,
    backward: Vec<usize>,
    looked: Vec<f64>,
    memory: Option<MemBuffer>,
}

impl Tangent {
    /// Builds and factorises it for `answers`, `G` by rows.
    pub fn find(&mut self, slopes: &[Slope], answers: &[Vec<f64>]) {
        self.steep.clear();
        self.steep.extend(slopes.iter().map(|(p, _, _)| *p));
        self.steep.sort_unstable();
        self.steep.dedup();
        let size = self.steep.len();
        self.among.clear();
        self.among.resize(answers.len(), 0);
        self.steep.iter().enumerate().for_each(|(i, &p)| self.among[p] = i);
        // By the column of `S`, so that each row of `G` is looked at once.
        let mut by_column: Vec<Slope> = slopes.to_vec();
        by_column.sort_unstable_by_key(|(p, q, _)| (*q, *p));
        self.factors.clear();
        self.factors.resize(size * size, 0.0);
        (0..size).for_each(|i| self.factors[i * size + i] = 1.0);
        let mut runs: Vec<Range<usize>> = Vec::new();
        for &p in &self.steep {
            match runs.last_mut().filter(|run| run.end == p) {
                Some(run) => run.end += 1,
                None => runs.push(p..p + 1),
            }
        }
        let Tangent { among, factors, looked, .. } = self;
        widest(Less { slopes: &by_column, answers, runs: &runs, size, among, factors, looked });
        self.forward.resize(size, 0);
        self.backward.resize(size, 0);
        let need = StackReq::any_of(&[
            factor::lu_in_place_scratch::<usize, f64>(size, size, Par::Seq, Default::default()),
            solve::solve_transpose_in_place_scratch::<usize, f64>(size, 1, Par::Seq),
        ]);
        if self.memory.as_ref().is_none_or(|memory| memory.len() < need.unaligned_bytes_required()) {
            self.memory = Some(MemBuffer::new(need));
        }
        if let Some(memory) = &mut self.memory {
            let stack = MemStack::new(memory);
            let (forward, backward) = (&mut self.forward[..], &mut self.backward[..]);
            let factors = MatMut::from_column_major_slice_mut(&mut self.factors, size, size);
            factor::lu_in_place(factors, forward, backward, Par::Seq, stack, Default::default());
        }
    }

    /// Solves `(1 - S G) step = right`, where `given` is what the given part of the step, that of the rows with an empty row of `S`, does to all
    /// rows, with whatever else moves them.
    pub fn solve(&mut self, slopes: &[Slope], right: &[f64], given: &[f64]) -> Vec<f64> {
        let mut rest: Vec<f64> = self.steep.iter().map(|&p| right[p]).collect();
        for &(p, q, s) in slopes {
            rest[self.among[p]] += s * given[q];
        }
        self.solve_steep(&mut rest);
        let mut step = right.to_vec();
        self.steep.iter().zip(rest).for_each(|(&p, x)| step[p] = x);
        step
    }

    /// Solves for the steep rows alone, in place.
    pub fn solve_steep(&mut self, x: &mut [f64]) {
        let Some(memory) = &mut self.memory else { return };
        let size = x.len();
        let factors = MatRef::from_column_major_slice(&self.factors, size, size);
        let right = MatMut::from_column_major_slice_mut(x, size, 1);
        let stack = MemStack::new(memory);
        let order = PermRef::new_checked(&self.forward, &self.backward, size);
        solve::solve_transpose_in_place_with_conj(factors, factors, order, Conj::No, right, Par::Seq, stack);
    }
}

/// Takes `S G` off the tangent; slopes in the order of their columns.
struct Less<'t> {
    slopes: &'t [Slope],
    answers: &'t [Vec<f64>],
    /// Steep rows, by stretches of neighbouring ones, and how many these are.
    runs: &'t [Range<usize>],
    size: usize,
    among: &'t [usize],
    factors: &'t mut [f64],
    /// Answers of a row at the steep ones.
    looked: &'t mut Vec<f64>,
}

impl pulp::NullaryFnOnce for Less<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let size = self.size;
        let mut at = usize::MAX;
        for &(p, q, s) in self.slopes {
            if q != at {
                let row = &self.answers[q];
                self.looked.clear();
                self.runs.iter().for_each(|run| self.looked.extend_from_slice(&row[run.clone()]));
                at = q;
            }
            let start = self.among[p] * size;
            let row = &mut self.factors[start..start + size];
            row.iter_mut().zip(self.looked.iter()).for_each(|(entry, answer)| *entry -= s * *answer);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_step_solves_the_system() {
        let answers: Vec<Vec<f64>> =
            (0..5).map(|i| (0..5).map(|j| 1.0 / (1.0 + i as f64 + j as f64)).collect()).collect();
        let slopes = [(1, 0, 0.3), (1, 1, -0.7), (3, 2, 0.4), (3, 1, 0.9), (4, 3, -0.2)];
        let right = [1.0, -2.0, 0.5, 3.0, 0.25];
        let mut tangent = Tangent::default();
        tangent.find(&slopes, &answers);
        assert_eq!(tangent.steep, [1, 3, 4]);
        let moved = |step: &[f64]| -> Vec<f64> {
            answers.iter().map(|row| row.iter().zip(step).map(|(a, s)| a * s).sum()).collect()
        };
        let mut given = right.to_vec();
        tangent.steep.iter().for_each(|&p| given[p] = 0.0);
        let step = tangent.solve(&slopes, &right, &moved(&given));
        let values = moved(&step);
        let mut left: Vec<f64> = step.iter().zip(right).map(|(step, right)| step - right).collect();
        slopes.iter().for_each(|&(p, q, s)| left[p] -= s * values[q]);
        assert!(left.iter().all(|left| left.abs() < 1e-14), "{left:?}");
    }
}
