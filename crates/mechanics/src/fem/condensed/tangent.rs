//! The tangent on the forces of some rows, `1 - S G`, with `S` the slopes of the parts' excess.

use super::dense::{Dense, Digits};
use super::rows::widest;
use std::ops::Range;

/// One entry of `S`: row, column, derivative, by places among the rows at hand.
pub(super) type Slope = (usize, usize, f64);

/// Factorised on the rows whose row of `S` is not empty, a few hundred; the step of the others is what is given.
#[derive(Default)]
pub(super) struct Tangent<D> {
    /// Those rows in ascending order.
    pub steep: Vec<usize>,
    /// `S`.
    slopes: Vec<Slope>,
    /// Place of a row among the steep ones.
    among: Vec<usize>,
    factors: Dense<D>,
    looked: Looked<D>,
}

impl<D: Digits> Tangent<D> {
    /// Builds and factorises it for `answers`, `G` by rows.
    pub fn find(&mut self, slopes: &[Slope], answers: &[Vec<f64>]) {
        self.steep.clear();
        self.steep.extend(slopes.iter().map(|(p, _, _)| *p));
        self.steep.sort_unstable();
        self.steep.dedup();
        self.among.clear();
        self.among.resize(answers.len(), 0);
        self.steep.iter().enumerate().for_each(|(i, &p)| self.among[p] = i);
        self.slopes.clear();
        self.slopes.extend_from_slice(slopes);
        let Tangent { steep, slopes, among, factors, looked } = self;
        widest(Less { slopes, answers, steep, among, factors: factors.unit(steep.len()), looked });
        self.factors.factorise();
    }

    /// Solves `(1 - S G) step = right`, where `given` is what the given part of the step, that of the rows with an empty row of `S`, does to all
    /// rows, with whatever else moves them.
    pub fn solve(&mut self, right: &[f64], given: &[f64]) -> Vec<f64> {
        let mut rest: Vec<f64> = self.steep.iter().map(|&p| right[p]).collect();
        for &(p, q, s) in &self.slopes {
            rest[self.among[p]] += s * given[q];
        }
        self.factors.solve(&mut rest);
        let mut step = right.to_vec();
        self.steep.iter().zip(rest).for_each(|(&p, x)| step[p] = x);
        step
    }

    /// Steps for a one on each of some rows in turn.
    pub fn columns(&mut self, of: &[usize], answers: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let size = self.steep.len();
        let mut right = vec![0.0; size * of.len()];
        let is_steep = |row: usize| self.steep.binary_search(&row).is_ok();
        for (k, &row) in of.iter().enumerate() {
            let right = &mut right[k * size..(k + 1) * size];
            if is_steep(row) {
                right[self.among[row]] = 1.0;
            } else {
                self.slopes.iter().for_each(|&(p, q, s)| right[self.among[p]] += s * answers[row][q]);
            }
        }
        self.factors.solve(&mut right);
        let column = |(k, &row): (usize, &usize)| {
            let mut step = vec![0.0; answers.len()];
            step[row] = 1.0;
            self.steep.iter().zip(&right[k * size..]).for_each(|(&p, x)| step[p] = *x);
            step
        };
        of.iter().enumerate().map(column).collect()
    }
}

/// Takes `S G` off the tangent.
struct Less<'t, D> {
    slopes: &'t [Slope],
    answers: &'t [Vec<f64>],
    steep: &'t [usize],
    among: &'t [usize],
    factors: &'t mut [D],
    looked: &'t mut Looked<D>,
}

/// Rows of `G` at the steep ones.
#[derive(Default)]
struct Looked<D> {
    rows: Vec<D>,
    /// Place of a row among them.
    place: Vec<u32>,
    /// The steep rows, by stretches of neighbouring ones.
    runs: Vec<Range<usize>>,
}

impl<D: Digits> pulp::NullaryFnOnce for Less<'_, D> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let (size, Looked { rows, place, runs }) = (self.steep.len(), self.looked);
        rows.clear();
        place.clear();
        place.resize(self.answers.len(), u32::MAX);
        runs.clear();
        for &p in self.steep {
            match runs.last_mut().filter(|run| run.end == p) {
                Some(run) => run.end += 1,
                None => runs.push(p..p + 1),
            }
        }
        let mut count = 0;
        for &(_, q, _) in self.slopes {
            if place[q] != u32::MAX {
                continue;
            }
            place[q] = count;
            count += 1;
            for run in runs.iter() {
                rows.extend(self.answers[q][run.clone()].iter().map(|answer| D::of(*answer)));
            }
        }
        // Entries of one row one after the other, four at a time: what they are taken off is read and written once for four.
        for slopes in self.slopes.chunk_by(|one, other| one.0 == other.0) {
            let to = self.among[slopes[0].0] * size;
            let to = &mut self.factors[to..to + size];
            let from = |&(_, q, s): &Slope| (&rows[place[q] as usize * size..][..size], D::of(s));
            for some in slopes.chunks(4) {
                if let [a, b, c, d] = some {
                    let [(a, fa), (b, fb), (c, fc), (d, fd)] = [a, b, c, d].map(from);
                    for ((((entry, a), b), c), d) in to.iter_mut().zip(a).zip(b).zip(c).zip(d) {
                        *entry -= (fa * *a + fb * *b) + (fc * *c + fd * *d);
                    }
                } else {
                    for (from, s) in some.iter().map(from) {
                        to.iter_mut().zip(from).for_each(|(entry, answer)| *entry -= s * *answer);
                    }
                }
            }
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
        // Of one row five entries, more than are taken at a time.
        let full = [0.3, -0.7, 0.05, -0.1, 0.02].into_iter().enumerate().map(|(q, s)| (1, q, s));
        let slopes: Vec<Slope> = full.chain([(3, 2, 0.4), (3, 1, 0.9), (4, 3, -0.2)]).collect();
        let right = [1.0, -2.0, 0.5, 3.0, 0.25];
        let mut tangent = Tangent::<f64>::default();
        tangent.find(&slopes, &answers);
        assert_eq!(tangent.steep, [1, 3, 4]);
        let moved = |step: &[f64]| -> Vec<f64> {
            answers.iter().map(|row| row.iter().zip(step).map(|(a, s)| a * s).sum()).collect()
        };
        let left = |step: &[f64], right: &[f64]| {
            let values = moved(step);
            let mut left: Vec<f64> = step.iter().zip(right).map(|(step, right)| step - right).collect();
            slopes.iter().for_each(|&(p, q, s)| left[p] -= s * values[q]);
            left.iter().fold(0.0_f64, |most, left| most.max(left.abs()))
        };
        let mut given = right.to_vec();
        tangent.steep.iter().for_each(|&p| given[p] = 0.0);
        let step = tangent.solve(&right, &moved(&given));
        assert!(left(&step, &right) < 1e-14);
        // A one on a row that is steep, and on one that is not.
        for (row, step) in [3, 2].into_iter().zip(tangent.columns(&[3, 2], &answers)) {
            let mut right = [0.0; 5];
            right[row] = 1.0;
            assert!(left(&step, &right) < 1e-14, "row {row}");
        }
    }
}
