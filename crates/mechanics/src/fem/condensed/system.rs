//! The tangent on the forces of the active rows: `1 - S G`, with `S` the slopes of the parts' excess.

use super::parts::ROWS;
use super::rows::dot;
use crate::fem::gmres;
use faer::Mat;
use faer::linalg::solvers::{PartialPivLu, Solve};

/// Vectors of GMRES beyond which the tangent is factorised anew.
const STALE: usize = 12;

/// Residual to which a step is solved.
const ACCURACY: f64 = 1e-6;

/// The active rows, and the last tangent.
#[derive(Default)]
pub(super) struct System {
    /// Active rows in the order of their columns.
    rows: Vec<usize>,
    /// Place of a row among them.
    place: Vec<Option<u32>>,
    /// `G`: for each active row what a unit force on it does to all of them.
    answers: Vec<Vec<f64>>,
    /// Entries of the last `S`.
    slopes: Vec<(u32, u32, f64)>,
    /// Factorised on these places, the only ones whose row of `S` was not empty then.
    factor: Option<(PartialPivLu<f64>, Vec<u32>)>,
}

impl std::fmt::Debug for System {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        to.debug_struct("System").field("rows", &self.rows.len()).finish_non_exhaustive()
    }
}

impl System {
    pub fn rows(&self) -> &[usize] {
        &self.rows
    }

    /// More rows take part; `answer` tells what a unit force on a column's row does to a row.
    pub fn extend(&mut self, rows: &[usize], answer: impl Fn(usize, usize) -> f64) {
        let before = self.rows.len();
        for &row in rows {
            if self.place.len() <= row {
                self.place.resize(row + 1, None);
            }
            self.place[row] = Some(self.rows.len() as u32);
            self.rows.push(row);
        }
        for (column, answers) in self.answers.iter_mut().enumerate() {
            answers.extend(rows.iter().map(|&row| answer(column, row)));
        }
        for column in before..self.rows.len() {
            self.answers.push(self.rows.iter().map(|&row| answer(column, row)).collect());
        }
    }

    /// Changes of the active rows' values by forces on them.
    pub fn moves(&self, forces: &[f64]) -> Vec<f64> {
        let mut moves = vec![0.0; self.rows.len()];
        for (answers, force) in self.answers.iter().zip(forces).filter(|(_, force)| **force != 0.0) {
            moves.iter_mut().zip(answers).for_each(|(moves, answer)| *moves += force * answer);
        }
        moves
    }

    /// Change of the forces that the last tangent makes of a change of the rows' values without them.
    pub fn predict(&self, values: &[f64]) -> Vec<f64> {
        let mut step = vec![0.0; self.rows.len()];
        for &(p, q, s) in &self.slopes {
            step[p as usize] += s * values[q as usize];
        }
        if let Some((lu, places)) = &self.factor {
            let mut x: Vec<f64> = places.iter().map(|&p| step[p as usize]).collect();
            solve_with(lu, &mut x);
            places.iter().zip(x).for_each(|(&p, x)| step[p as usize] = x);
        }
        step
    }

    /// Solves `(1 - S G) step = right`. `slopes` gives rows and slope of each part. Where a row of `S` is empty the step is what is
    /// given; the others make a system of their own.
    pub fn solve<'p>(
        &mut self,
        slopes: impl Iterator<Item = (&'p [Option<usize>; ROWS], &'p [[f64; ROWS]; ROWS])>,
        right: &[f64],
    ) -> Vec<f64> {
        self.slopes.clear();
        for (rows, slope) in slopes {
            let places = rows.map(|row| row.and_then(|row| self.place[row]));
            for (i, p) in places.iter().enumerate() {
                for (j, q) in places.iter().enumerate() {
                    if let (Some(p), Some(q), true) = (p, q, slope[i][j] != 0.0) {
                        self.slopes.push((*p, *q, slope[i][j]));
                    }
                }
            }
        }
        let mut places: Vec<u32> = self.slopes.iter().map(|(p, _, _)| *p).collect();
        places.extend(self.factor.iter().flat_map(|(_, places)| places));
        places.sort_unstable();
        places.dedup();
        let within = Within::new(self, &places);
        // What the given part does to the rest.
        let mut step = right.to_vec();
        places.iter().for_each(|&p| step[p as usize] = 0.0);
        let given = self.moves(&step);
        let mut small: Vec<f64> = places.iter().map(|&p| right[p as usize]).collect();
        for &(p, q, s) in &self.slopes {
            small[within.of(p)] += s * given[q as usize];
        }
        let found = self.small(&within, &places, &small);
        places.iter().zip(found).for_each(|(&p, x)| step[p as usize] = x);
        step
    }

    fn small(&mut self, within: &Within, places: &[u32], right: &[f64]) -> Vec<f64> {
        if let Some((lu, known)) = &self.factor {
            let known: Vec<usize> = known.iter().map(|&p| within.of(p)).collect();
            let inverse = |x: &mut [f64]| {
                let mut y: Vec<f64> = known.iter().map(|&i| x[i]).collect();
                solve_with(lu, &mut y);
                known.iter().zip(y).for_each(|(&i, y)| x[i] = y);
            };
            let found = gmres::solve_within(|x, out| within.multiply(x, out), inverse, right, ACCURACY, STALE);
            if found.residual <= 10.0 * ACCURACY {
                return found.x;
            }
        }
        let mut mine: Vec<u32> = self.slopes.iter().map(|(p, _, _)| *p).collect();
        mine.sort_unstable();
        mine.dedup();
        let at: Vec<usize> = mine.iter().map(|&p| within.of(p)).collect();
        let dense = within.dense();
        let mut x = right.to_vec();
        let mut y: Vec<f64> = at.iter().map(|&i| x[i]).collect();
        // Rows of the others are those of the identity: what they hold is known.
        let known = |j: usize| places.get(j).is_some_and(|p| mine.binary_search(p).is_err());
        for (row, y) in at.iter().zip(&mut y) {
            *y -= (0..x.len()).filter(|&j| known(j)).map(|j| dense[(*row, j)] * x[j]).sum::<f64>();
        }
        let lu = Mat::<f64>::from_fn(at.len(), at.len(), |i, j| dense[(at[i], at[j])]).partial_piv_lu();
        solve_with(&lu, &mut y);
        at.iter().zip(y).for_each(|(&i, y)| x[i] = y);
        self.factor = Some((lu, mine));
        x
    }
}

fn solve_with(lu: &PartialPivLu<f64>, x: &mut [f64]) {
    let rows = x.len();
    lu.solve_in_place(faer::MatMut::from_column_major_slice_mut(x, rows, 1));
}

/// The tangent on some places.
struct Within {
    /// Place among them.
    local: std::collections::BTreeMap<u32, usize>,
    /// Entries of `S`: place, row of `answers`, value.
    slopes: Vec<(usize, usize, f64)>,
    /// `G` from the places to the rows that `S` looks at.
    answers: Vec<Vec<f64>>,
}

impl Within {
    fn new(system: &System, places: &[u32]) -> Within {
        let local: std::collections::BTreeMap<u32, usize> = places.iter().enumerate().map(|(i, &p)| (p, i)).collect();
        let mut looked: Vec<u32> = system.slopes.iter().map(|(_, q, _)| *q).collect();
        looked.sort_unstable();
        looked.dedup();
        let answers =
            looked.iter().map(|&q| places.iter().map(|&p| system.answers[q as usize][p as usize]).collect()).collect();
        let row = |q: &u32| looked.binary_search(q).unwrap_or(0);
        let slopes = system.slopes.iter().map(|(p, q, s)| (local[p], row(q), *s)).collect();
        Within { local, slopes, answers }
    }

    fn of(&self, place: u32) -> usize {
        self.local[&place]
    }

    fn multiply(&self, x: &[f64], out: &mut [f64]) {
        let values: Vec<f64> = self.answers.iter().map(|answers| dot(answers, x)).collect();
        out.iter_mut().zip(x).for_each(|(out, x)| *out += x);
        for &(p, q, s) in &self.slopes {
            out[p] -= s * values[q];
        }
    }

    fn dense(&self) -> Mat<f64> {
        let n = self.local.len();
        let mut dense = Mat::<f64>::identity(n, n);
        for &(p, q, s) in &self.slopes {
            for (j, answer) in self.answers[q].iter().enumerate() {
                dense[(p, j)] -= s * answer;
            }
        }
        dense
    }
}
