//! A tangent that differs on a few rows from one that is factorised: in a step of Newton's method few parts begin or cease to flow, to slide or to
//! open, and the others keep their slopes.
//!
//! With `M` the tangent that is factorised, `D` the slopes that have changed, which are empty but for a few rows, and `Z` the solutions
//! of `M` for a one on each of these rows (Woodbury's identity)
//!
//! ```text
//! (M - D G)^-1 b = y + Z (1 - D G Z)^-1 D G y,   y = M^-1 b
//! ```

use super::dense::Dense;
use super::rows::{add_multiples, dots};
use super::tangent::{Slope, Tangent};

/// No place.
const NOWHERE: u32 = u32::MAX;

/// Changes of a tangent, and what was found of it for them.
#[derive(Default)]
pub(super) struct Nearby {
    /// Rows with a solution for a one on them, and these.
    rows: Vec<usize>,
    columns: Vec<Vec<f64>>,
    column_of: Vec<u32>,
    /// Rows at which what these solutions move is read, and what that is: for each of them, by solutions.
    reads: Vec<usize>,
    read_of: Vec<u32>,
    moved: Vec<Vec<f64>>,
    /// The slopes that have changed, by their row's place among those in use and by reads; the solutions in use.
    slopes: Vec<Slope>,
    used: Vec<usize>,
    /// The reads in use, and the place of each among them.
    read_now: Vec<usize>,
    place_now: Vec<u32>,
    small: Dense<f64>,
}

impl Nearby {
    /// The tangent that is factorised is another one now, and nothing has changed of it.
    pub fn clear(&mut self) {
        let (small, columns) = (std::mem::take(&mut self.small), std::mem::take(&mut self.columns));
        *self = Nearby { small, columns, ..Nearby::default() };
        self.columns.clear();
    }

    pub fn is_empty(&self) -> bool {
        self.used.is_empty()
    }

    /// These slopes come on top of those of the tangent; not if they are of more than so many rows.
    pub fn find(&mut self, changes: &[Slope], most: usize, tangent: &mut Tangent<f32>, answers: &[Vec<f64>]) -> bool {
        let mut rows: Vec<usize> = changes.iter().map(|(p, _, _)| *p).collect();
        rows.sort_unstable();
        rows.dedup();
        if rows.len() > most {
            return false;
        }
        self.extend(changes, tangent, answers);
        let mut place_of = vec![NOWHERE; self.columns.len()];
        self.used.clear();
        self.slopes.clear();
        self.read_now.clear();
        self.place_now.clear();
        self.place_now.resize(self.reads.len(), NOWHERE);
        for &(p, q, s) in changes {
            let column = self.column_of[p] as usize;
            if place_of[column] == NOWHERE {
                place_of[column] = self.used.len() as u32;
                self.used.push(column);
            }
            let read = self.read_of[q] as usize;
            if self.place_now[read] == NOWHERE {
                self.place_now[read] = self.read_now.len() as u32;
                self.read_now.push(read);
            }
            self.slopes.push((place_of[column] as usize, read, s));
        }
        let size = self.used.len();
        let entries = self.small.unit(size);
        for &(i, read, s) in &self.slopes {
            let (row, moved) = (&mut entries[i * size..(i + 1) * size], &self.moved[read]);
            row.iter_mut().zip(&self.used).for_each(|(entry, &column)| *entry -= s * moved[column]);
        }
        self.small.factorise();
        true
    }

    /// Solutions and reads that were not needed before.
    fn extend(&mut self, changes: &[Slope], tangent: &mut Tangent<f32>, answers: &[Vec<f64>]) {
        self.column_of.resize(answers.len(), NOWHERE);
        self.read_of.resize(answers.len(), NOWHERE);
        let (columns, reads) = (self.columns.len(), self.reads.len());
        for &(p, q, _) in changes {
            if self.column_of[p] == NOWHERE {
                self.column_of[p] = self.rows.len() as u32;
                self.rows.push(p);
            }
            if self.read_of[q] == NOWHERE {
                self.read_of[q] = self.reads.len() as u32;
                self.reads.push(q);
            }
        }
        self.columns.extend(tangent.columns(&self.rows[columns..], answers));
        self.moved.resize_with(self.reads.len(), Vec::new);
        for (read, (moved, &row)) in self.moved.iter_mut().zip(&self.reads).enumerate() {
            let from = if read < reads { columns } else { 0 };
            dots(&answers[row], self.columns[from..].iter().map(Vec::as_slice), moved);
        }
    }

    /// From the step of the tangent that is factorised to that of the one at hand.
    pub fn correct(&mut self, step: &mut [f64], answers: &[Vec<f64>]) {
        if self.is_empty() {
            return;
        }
        let mut moves = Vec::with_capacity(self.read_now.len());
        dots(step, self.read_now.iter().map(|&read| answers[self.reads[read]].as_slice()), &mut moves);
        let mut right = vec![0.0; self.used.len()];
        self.slopes.iter().for_each(|&(i, read, s)| right[i] += s * moves[self.place_now[read] as usize]);
        self.small.solve(&mut right);
        add_multiples(step, self.used.iter().map(|&column| self.columns[column].as_slice()).zip(right));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fem::condensed::rows::dot;

    const ROWS: usize = 40;

    /// What forces on rows of a soft ground do to each other.
    fn answers() -> Vec<Vec<f64>> {
        let answer = |i: usize, j: usize| 1.0 / (1.0 + i.abs_diff(j) as f64) + f64::from(u8::from(i == j));
        (0..ROWS).map(|i| (0..ROWS).map(|j| answer(i, j)).collect()).collect()
    }

    /// Step for a right-hand side, and what it leaves of it with these slopes.
    fn left(tangent: &mut Tangent<f32>, nearby: &mut Nearby, slopes: &[Slope], answers: &[Vec<f64>]) -> f64 {
        let right: Vec<f64> = (0..ROWS).map(|i| ((7 * i) % 5) as f64 - 2.0).collect();
        let moved = |step: &[f64]| answers.iter().map(|row| dot(row, step)).collect::<Vec<f64>>();
        let mut given = right.clone();
        tangent.steep.iter().for_each(|&p| given[p] = 0.0);
        let mut step = tangent.solve(&right, &moved(&given));
        nearby.correct(&mut step, answers);
        let values = moved(&step);
        let mut left: Vec<f64> = step.iter().zip(&right).map(|(step, right)| step - right).collect();
        slopes.iter().for_each(|&(p, q, s)| left[p] -= s * values[q]);
        left.iter().fold(0.0, |most, left| most.max(left.abs()))
    }

    #[test]
    fn a_tangent_put_right_is_that_of_the_changed_slopes() {
        let answers = answers();
        let slopes: Vec<Slope> =
            (0..24).flat_map(|i| [(i, i, 0.3 - 0.02 * i as f64), (i, (i + 3) % 24, 0.1)]).collect();
        let (mut tangent, mut nearby) = (Tangent::default(), Nearby::default());
        tangent.find(&slopes, &answers);
        // A row that was steep and is no longer, one that was not, others that are otherwise, and twice the same entry. The second time some of them are
        // known, the third time only these are left.
        let first = [(2, 2, -0.26), (2, 5, -0.1), (30, 31, 0.4), (30, 30, -0.2), (7, 7, 0.5), (7, 7, 0.1)];
        let second = [(30, 31, 0.4), (30, 30, -0.2), (7, 9, 0.5), (11, 35, -0.3), (39, 2, 0.2)];
        for changes in [&first[..], &second, &second[..1]] {
            let all: Vec<Slope> = slopes.iter().chain(changes).copied().collect();
            nearby.used.clear();
            let without = left(&mut tangent, &mut nearby, &all, &answers);
            assert!(nearby.find(changes, ROWS, &mut tangent, &answers));
            let with = left(&mut tangent, &mut nearby, &all, &answers);
            assert!(without > 1e-2 && with < 1e-5, "{without} without, {with} with the change");
        }
        assert!(!nearby.find(&second, 3, &mut tangent, &answers), "four rows have changed");
    }
}
