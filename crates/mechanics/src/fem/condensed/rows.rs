//! Rows: sums of displacement components that parts and sensors look at, and what each load and each force on another row does to them.

use crate::fem::dofs::HELD;
use crate::fem::model::Model;

/// A sum of displacement components.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Functional(
    /// Component (`2 node` for x, `2 node + 1` for y) and its weight.
    pub Vec<(usize, f64)>,
);

/// A functional on the free components, with its answers.
#[derive(Debug, Clone)]
pub(super) struct Row {
    /// Equations and weights.
    terms: Vec<(u32, f64)>,
    /// Value when the run began, held components included.
    pub start: f64,
    /// Change by a unit of each load.
    pub loads: Vec<f64>,
    /// Change by a unit force on each column's row.
    pub columns: Vec<f64>,
    /// Which column belongs to it, if any.
    pub column: Option<usize>,
}

impl Row {
    /// A row with its answers to all solutions so far.
    pub fn new(model: &Model, functional: &Functional, displacements: &[f64], solved: &Solved) -> Row {
        let dofs = model.dofs();
        let terms: Vec<(u32, f64)> =
            functional.0.iter().map(|&(c, w)| (dofs.equation(c), w)).filter(|(e, _)| *e != HELD).collect();
        let start = functional.0.iter().map(|&(c, w)| w * displacements[c]).sum();
        let mut row = Row { terms, start, loads: Vec::new(), columns: Vec::new(), column: None };
        row.loads = solved.loads.iter().map(|x| row.of(x)).collect();
        row.columns = solved.columns.iter().map(|x| row.of(x)).collect();
        row
    }

    /// Its value in a solution.
    pub fn of(&self, solution: &[f64]) -> f64 {
        self.terms.iter().map(|&(e, w)| w * solution[e as usize]).sum()
    }

    /// The right-hand side of a unit force on it.
    pub fn unit(&self, equations: usize) -> Vec<f64> {
        let mut force = vec![0.0; equations];
        for &(e, w) in &self.terms {
            force[e as usize] += w;
        }
        force
    }

    /// Value under loads, and under forces on the columns' rows.
    #[inline]
    pub fn value(&self, amplitudes: &[f64], forces: &[f64]) -> f64 {
        self.start + dot(&self.loads, amplitudes) + dot(&self.columns, forces)
    }
}

/// Solutions of the linear system, on all equations.
#[derive(Debug, Clone, Default)]
pub(super) struct Solved {
    pub loads: Vec<Vec<f64>>,
    pub columns: Vec<Vec<f64>>,
}

/// Four running sums, in a fixed order: as fast as memory gives the numbers.
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
