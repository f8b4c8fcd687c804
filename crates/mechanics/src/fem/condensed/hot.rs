//! The parts that move now and those that moved lately: all that takes part in the iterations of a position, and the tangent on the
//! forces of their rows, `1 - S G` with `S` the slopes of the parts' excess.

use super::parts::{Part, ROWS};
use super::rows::{Rows, add_multiples};
use faer::linalg::solvers::{PartialPivLu, Solve};
use faer::{Mat, MatMut};

/// No place.
const NOWHERE: u32 = u32::MAX;

/// Parts that iterate, and the last tangent.
#[derive(Default)]
pub(super) struct Hot {
    /// In the order in which they came.
    pub parts: Vec<usize>,
    is_hot: Vec<bool>,
    /// Their rows.
    pub rows: Vec<usize>,
    /// Place of an active row among them, [`NOWHERE`] if it has none.
    place: Vec<u32>,
    /// `G` between them.
    answers: Vec<Vec<f64>>,
    /// Entries of the last `S`, by active rows.
    slopes: Vec<(u32, u32, f64)>,
    /// Factorised on these active rows, the only ones whose row of `S` was not empty then.
    factor: Option<(PartialPivLu<f64>, Vec<u32>)>,
}

impl std::fmt::Debug for Hot {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        to.debug_struct("Hot").field("parts", &self.parts.len()).field("rows", &self.rows.len()).finish_non_exhaustive()
    }
}

impl Hot {
    /// Nothing but these parts is hot.
    pub fn set(&mut self, hot: impl Iterator<Item = usize>, parts: &[Part], rows: &Rows) {
        self.parts.clear();
        self.rows.clear();
        self.answers.clear();
        self.is_hot.clear();
        self.place.fill(NOWHERE);
        self.add(hot, parts, rows);
    }

    /// More parts are hot.
    pub fn add(&mut self, more: impl Iterator<Item = usize>, parts: &[Part], rows: &Rows) {
        self.is_hot.resize(parts.len(), false);
        self.place.resize(rows.len(), NOWHERE);
        let before = self.rows.len();
        for index in more {
            if std::mem::replace(&mut self.is_hot[index], true) {
                continue;
            }
            self.parts.push(index);
            for row in parts[index].rows.into_iter().flatten() {
                if self.place[row] == NOWHERE {
                    self.place[row] = self.rows.len() as u32;
                    self.rows.push(row);
                }
            }
        }
        for (place, row) in self.rows.iter().enumerate() {
            let answers = rows.answers(*row);
            if place < before {
                self.answers[place].extend(self.rows[before..].iter().map(|&other| answers[other]));
            } else {
                self.answers.push(self.rows.iter().map(|&other| answers[other]).collect());
            }
        }
    }

    pub fn is_hot(&self, part: usize) -> bool {
        self.is_hot.get(part).copied().unwrap_or(false)
    }

    /// Place of an active row, if it has one.
    #[inline]
    pub fn place(&self, row: usize) -> Option<usize> {
        self.place.get(row).filter(|place| **place != NOWHERE).map(|place| *place as usize)
    }

    /// Changes of the hot rows' values by forces on them.
    pub fn moves(&self, forces: &[f64]) -> Vec<f64> {
        let mut moves = vec![0.0; self.rows.len()];
        add_multiples(&mut moves, self.answers.iter().map(Vec::as_slice).zip(forces.iter().copied()));
        moves
    }

    /// The last tangent is that of another place: nothing is predicted from it.
    pub fn forget(&mut self) {
        self.slopes.clear();
    }

    /// Change of the forces that the last tangent makes of a change of the rows' values without them.
    pub fn predict(&self, values: &[f64]) -> Vec<f64> {
        let mut step = vec![0.0; self.rows.len()];
        if self.slopes.is_empty() {
            return step;
        }
        for &(p, q, s) in &self.slopes {
            if let (Some(p), Some(q)) = (self.place(p as usize), self.place(q as usize)) {
                step[p] += s * values[q];
            }
        }
        if let Some((lu, rows)) = &self.factor {
            let mut x: Vec<f64> = rows.iter().map(|&row| self.place(row as usize).map_or(0.0, |p| step[p])).collect();
            solve_with(lu, &mut x);
            for (&row, x) in rows.iter().zip(x) {
                if let Some(place) = self.place(row as usize) {
                    step[place] = x;
                }
            }
        }
        step
    }

    /// Solves `(1 - S G) step = right` with the slopes that the hot parts answered last. Where a row of `S` is empty the step is what is
    /// given; the others, a few hundred, make a system of their own. It is factorised anew in every iteration: with 344 points that flow, GMRES before an
    /// older factor takes as long.
    pub fn solve(&mut self, parts: &[Part], right: &[f64]) -> Vec<f64> {
        self.slopes.clear();
        for part in self.parts.iter().map(|&part| &parts[part]).filter(|part| !part.still) {
            for i in 0..ROWS {
                for j in 0..ROWS {
                    if let (Some(p), Some(q), true) = (part.rows[i], part.rows[j], part.slope[i][j] != 0.0) {
                        self.slopes.push((p as u32, q as u32, part.slope[i][j]));
                    }
                }
            }
        }
        let slopes: Vec<(usize, usize, f64)> = self
            .slopes
            .iter()
            .map(|&(p, q, s)| (self.place[p as usize] as usize, self.place[q as usize] as usize, s))
            .collect();
        let mut steep: Vec<usize> = slopes.iter().map(|(p, _, _)| *p).collect();
        steep.sort_unstable();
        steep.dedup();
        let mut among = vec![0; self.rows.len()];
        steep.iter().enumerate().for_each(|(i, &p)| among[p] = i);
        // What the given part does to the rest.
        let mut step = right.to_vec();
        steep.iter().for_each(|&p| step[p] = 0.0);
        let given = self.moves(&step);
        let mut rest: Vec<f64> = steep.iter().map(|&p| right[p]).collect();
        // Transposed: the rows of the tangent lie in columns, and so do those of `G`.
        let mut tangent = Mat::<f64>::identity(steep.len(), steep.len());
        let mut looked: Vec<Option<Vec<f64>>> = vec![None; self.rows.len()];
        for &(p, q, s) in &slopes {
            rest[among[p]] += s * given[q];
            let answers = looked[q].get_or_insert_with(|| steep.iter().map(|&p| self.answers[q][p]).collect());
            let row = tangent.col_as_slice_mut(among[p]);
            row.iter_mut().zip(answers).for_each(|(entry, answer)| *entry -= s * *answer);
        }
        let lu = tangent.partial_piv_lu();
        solve_with(&lu, &mut rest);
        steep.iter().zip(&rest).for_each(|(&p, x)| step[p] = *x);
        self.factor = Some((lu, steep.iter().map(|&p| self.rows[p] as u32).collect()));
        step
    }
}

/// Solves with the transpose of what was factorised.
fn solve_with(lu: &PartialPivLu<f64>, x: &mut [f64]) {
    let rows = x.len();
    lu.solve_transpose_in_place(MatMut::from_column_major_slice_mut(x, rows, 1));
}
