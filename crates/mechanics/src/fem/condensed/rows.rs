//! Rows: sums of displacement components that parts and sensors look at, and what each load and each force on another row does to them.

use crate::fem::dofs::HELD;
use crate::fem::model::Model;

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
    /// Values of all rows under the amplitudes and forces to which they were brought last.
    values: Vec<f64>,
    stand: [Vec<f64>; 2],
}

/// Loads, and columns.
const LOADS: usize = 0;
const COLUMNS: usize = 1;

impl Rows {
    /// No rows yet; solutions for the loads.
    pub fn new(loads: Vec<Vec<f64>>) -> Rows {
        let count = loads.len();
        Rows {
            solved: [loads, Vec::new()],
            answers: [vec![Vec::new(); count], Vec::new()],
            stand: [vec![0.0; count], Vec::new()],
            ..Rows::default()
        }
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
        let mut value = start;
        for kind in [LOADS, COLUMNS] {
            for k in 0..self.solved[kind].len() {
                let answer = row.of(&self.solved[kind][k]);
                self.answers[kind][k].push(answer);
                value += answer * self.stand[kind][k];
            }
        }
        self.values.push(value);
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
            self.stand[COLUMNS].push(0.0);
        }
    }

    /// What a unit force on a column's row does to a row.
    #[inline]
    pub fn answer(&self, column: usize, row: usize) -> f64 {
        self.answers[COLUMNS][column][row]
    }

    /// Value of a row under loads alone.
    pub fn linear(&self, row: usize, amplitudes: &[f64]) -> f64 {
        self.list[row].start + self.moved(row, amplitudes)
    }

    /// Change of a row by loads.
    pub fn moved(&self, row: usize, amplitudes: &[f64]) -> f64 {
        self.answers[LOADS].iter().zip(amplitudes).filter(|(_, a)| **a != 0.0).map(|(answer, a)| answer[row] * a).sum()
    }

    /// Brings the values of all rows to these amplitudes and forces: only what has changed is added.
    pub fn bring(&mut self, amplitudes: &[f64], forces: &[f64]) {
        for (kind, now) in [(LOADS, amplitudes), (COLUMNS, forces)] {
            for ((answer, stand), now) in self.answers[kind].iter().zip(&mut self.stand[kind]).zip(now) {
                let more = now - *stand;
                if more != 0.0 {
                    self.values.iter_mut().zip(answer).for_each(|(value, answer)| *value += more * answer);
                    *stand = *now;
                }
            }
        }
    }

    /// Brings all values back to those of the start, without what rounding has left.
    pub fn restart(&mut self) {
        self.values.iter_mut().zip(&self.list).for_each(|(value, row)| *value = row.start);
        self.stand.iter_mut().for_each(|stand| stand.fill(0.0));
    }

    /// Value of a row as it was brought last.
    #[inline]
    pub fn value(&self, row: usize) -> f64 {
        self.values[row]
    }
}

impl std::ops::Index<usize> for Rows {
    type Output = Row;
    fn index(&self, row: usize) -> &Row {
        &self.list[row]
    }
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
