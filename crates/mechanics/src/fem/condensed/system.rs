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
    /// Entries of the last `S`.
    slopes: Vec<(u32, u32, f64)>,
    /// Factorised for the first so many of them.
    factor: Option<(PartialPivLu<f64>, usize)>,
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

    /// More rows take part. The factorisation goes on to serve the rows it knows.
    pub fn extend(&mut self, rows: &[usize]) {
        for &row in rows {
            if self.place.len() <= row {
                self.place.resize(row + 1, None);
            }
            self.place[row] = Some(self.rows.len() as u32);
            self.rows.push(row);
        }
    }

    /// Change of the forces that the last tangent makes of a change of the rows' values without them.
    pub fn predict(&self, values: &[f64]) -> Vec<f64> {
        let mut step = vec![0.0; self.rows.len()];
        for &(p, q, s) in &self.slopes {
            step[p as usize] += s * values[q as usize];
        }
        self.precondition(&mut step);
        step
    }

    fn precondition(&self, x: &mut [f64]) {
        if let Some((lu, known)) = &self.factor {
            lu.solve_in_place(faer::MatMut::from_column_major_slice_mut(&mut x[..*known], *known, 1));
        }
    }

    /// Solves `(1 - S G) step = right`. `slopes` gives rows and slope of each part, `column` the answers of a row to the columns.
    pub fn solve<'p>(
        &mut self,
        slopes: impl Iterator<Item = (&'p [Option<usize>; ROWS], &'p [[f64; ROWS]; ROWS])>,
        column: impl Fn(usize) -> &'p Vec<f64>,
        right: &[f64],
    ) -> Vec<f64> {
        let n = self.rows.len();
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
        let answers: Vec<&Vec<f64>> = self.rows.iter().map(|&row| column(row)).collect();
        let matrix = |x: &[f64], out: &mut [f64]| {
            let values: Vec<f64> = answers.iter().map(|answer| dot(answer, x)).collect();
            out.iter_mut().zip(x).for_each(|(out, x)| *out += x);
            for &(p, q, s) in &self.slopes {
                out[p as usize] -= s * values[q as usize];
            }
        };
        if self.factor.is_some() {
            let found = gmres::solve_within(matrix, |x| self.precondition(x), right, ACCURACY, STALE);
            if found.residual <= 10.0 * ACCURACY {
                return found.x;
            }
        }
        let mut dense = Mat::<f64>::identity(n, n);
        for &(p, q, s) in &self.slopes {
            for (j, answer) in answers[q as usize].iter().enumerate() {
                dense[(p as usize, j)] -= s * answer;
            }
        }
        self.factor = Some((dense.partial_piv_lu(), n));
        let mut step = right.to_vec();
        self.precondition(&mut step);
        step
    }
}
