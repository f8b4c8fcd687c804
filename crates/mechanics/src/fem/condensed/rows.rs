//! Rows: sums of displacement components that parts and sensors look at, and what each load and each force on another row does to them.

use crate::fem::dofs::HELD;
use crate::fem::model::Model;
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par};

/// A sum of displacement components.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Functional(
    /// Component (`2 node` for x, `2 node + 1` for y) and its weight.
    pub Vec<(usize, f64)>,
);

/// A functional on the free components.
#[derive(Debug, Clone)]
pub(super) struct Row {
    /// Equations and weights.
    terms: Vec<(u32, f64)>,
    /// Value when the run began, held components included.
    pub start: f64,
    /// Which column belongs to it, if any.
    pub column: Option<usize>,
}

impl Row {
    /// Its value in a solution.
    fn of(&self, solution: &[f64]) -> f64 {
        self.terms.iter().map(|&(e, w)| w * solution[e as usize]).sum()
    }

    /// The right-hand side of a unit force on it.
    pub fn unit(&self, equations: usize) -> Vec<f64> {
        let mut force = vec![0.0; equations];
        self.push(&mut force, 1.0);
        force
    }

    /// Adds a force on it to a right-hand side.
    pub fn push(&self, right: &mut [f64], force: f64) {
        for &(e, w) in &self.terms {
            right[e as usize] += w * force;
        }
    }
}

/// All rows, and what loads and forces on some of them do to each.
#[derive(Debug, Clone, Default)]
pub(super) struct Rows {
    list: Vec<Row>,
    /// Solutions for the loads and for the columns, on all equations.
    solved: [Vec<Vec<f64>>; 2],
    /// For each load and each column: change of every row.
    answers: [Vec<Vec<f64>>; 2],
    /// Changes of all rows under the forces to which they were brought last, and those forces.
    carried: Vec<f64>,
    stand: Vec<f64>,
}

/// Loads, and columns.
const LOADS: usize = 0;
const COLUMNS: usize = 1;

impl Rows {
    /// No rows yet; solutions for the loads.
    pub fn new(loads: Vec<Vec<f64>>) -> Rows {
        let count = loads.len();
        Rows { solved: [loads, Vec::new()], answers: [vec![Vec::new(); count], Vec::new()], ..Rows::default() }
    }

    pub fn len(&self) -> usize {
        self.list.len()
    }

    pub fn columns(&self) -> usize {
        self.answers[COLUMNS].len()
    }

    /// One more row.
    pub fn push(&mut self, model: &Model, functional: &Functional, displacements: &[f64]) -> usize {
        let dofs = model.dofs();
        let terms: Vec<(u32, f64)> =
            functional.0.iter().map(|&(c, w)| (dofs.equation(c), w)).filter(|(e, _)| *e != HELD).collect();
        let start = functional.0.iter().map(|&(c, w)| w * displacements[c]).sum();
        let row = Row { terms, start, column: None };
        for kind in [LOADS, COLUMNS] {
            for (answers, solution) in self.answers[kind].iter_mut().zip(&self.solved[kind]) {
                answers.push(row.of(solution));
            }
        }
        let carried =
            self.answers[COLUMNS].iter().zip(&self.stand).map(|(answers, force)| answers[self.list.len()] * force);
        self.carried.push(carried.sum());
        self.list.push(row);
        self.list.len() - 1
    }

    /// Columns for these rows.
    pub fn add_columns(&mut self, rows: &[usize], solutions: Vec<Vec<f64>>) {
        for (&row, solution) in rows.iter().zip(solutions) {
            self.list[row].column = Some(self.columns());
            let answers = self.list.iter().map(|row| row.of(&solution)).collect();
            self.answers[COLUMNS].push(answers);
            self.solved[COLUMNS].push(solution);
            self.stand.push(0.0);
        }
    }

    /// What a unit force on a column's row does to a row.
    #[inline]
    pub fn answer(&self, column: usize, row: usize) -> f64 {
        self.answers[COLUMNS][column][row]
    }

    /// Displacements of all equations by loads alone: a column for each set of amplitudes.
    pub fn displacements(&self, amplitudes: &[Vec<f64>]) -> Mat<f64> {
        product(&self.solved[LOADS], amplitudes)
    }

    /// Changes of all rows by loads alone: a column for each set of amplitudes.
    pub fn all_moved(&self, amplitudes: &[Vec<f64>]) -> Mat<f64> {
        product(&self.answers[LOADS], amplitudes)
    }

    /// Change of a row by loads.
    pub fn moved(&self, row: usize, amplitudes: &[f64]) -> f64 {
        self.answers[LOADS].iter().zip(amplitudes).filter(|(_, a)| **a != 0.0).map(|(answer, a)| answer[row] * a).sum()
    }

    /// Brings all rows to these forces: only what has changed is added.
    pub fn bring(&mut self, forces: &[f64]) {
        for ((answer, stand), now) in self.answers[COLUMNS].iter().zip(&mut self.stand).zip(forces) {
            let more = now - *stand;
            if more != 0.0 {
                self.carried.iter_mut().zip(answer).for_each(|(value, answer)| *value += more * answer);
                *stand = *now;
            }
        }
    }

    /// Forces to which all rows were brought last.
    pub fn brought(&self) -> &[f64] {
        &self.stand
    }

    /// Brings all rows to no forces, without what rounding has left.
    pub fn restart(&mut self) {
        self.carried.fill(0.0);
        self.stand.fill(0.0);
    }

    /// Value of a row when the run began, and what the forces to which it was brought last have added.
    #[inline]
    pub fn carried(&self, row: usize) -> f64 {
        self.list[row].start + self.carried[row]
    }
}

impl std::ops::Index<usize> for Rows {
    type Output = Row;
    fn index(&self, row: usize) -> &Row {
        &self.list[row]
    }
}

/// Sums of the columns by amplitudes, many at a time: what is not zero is read once for all of them.
fn product(columns: &[Vec<f64>], amplitudes: &[Vec<f64>]) -> Mat<f64> {
    let used: Vec<usize> = (0..columns.len()).filter(|&l| amplitudes.iter().any(|a| a[l] != 0.0)).collect();
    let rows = columns.first().map_or(0, Vec::len);
    let mut read = Vec::with_capacity(rows * used.len());
    used.iter().for_each(|&l| read.extend_from_slice(&columns[l]));
    let read = MatRef::from_column_major_slice(&read, rows, used.len());
    let shares = Mat::<f64>::from_fn(used.len(), amplitudes.len(), |k, p| amplitudes[p][used[k]]);
    let mut sums = Mat::<f64>::zeros(rows, amplitudes.len());
    matmul(sums.as_mut(), Accum::Replace, read, shares.as_ref(), 1.0, Par::Seq);
    sums
}

/// Eight running sums, in a fixed order: as fast as memory gives the numbers.
#[inline]
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f64 = a8.remainder().iter().zip(b8.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in a8.zip(b8) {
        for k in 0..8 {
            sums[k] += a[k] * b[k];
        }
    }
    sums.iter().sum::<f64>() + rest
}
