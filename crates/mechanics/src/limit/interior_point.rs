//! Clarabel's interior-point method as every program here uses it: one thread, no presolve, watched.

use crate::watch::CancelToken;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolution, DefaultSolver, IPSolver, SupportedConeT};

/// How exactly a program is to be solved, and how long it may take.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Accuracy {
    /// Relative gap and residuals.
    pub tolerance: f64,
    /// The same of a program that comes to rest a little early.
    pub nearly: f64,
    /// Most iterations.
    pub iterations: u32,
    /// How often each solution of linear equations is refined, at most.
    pub refinements: u32,
}

/// Minimises `x P x / 2 + q x` where `b - A x` lies in the cones; none where a number is not finite or the solver will not begin.
pub(super) fn minimise(
    (p, q): (&CscMatrix<f64>, &[f64]),
    (a, b): (&CscMatrix<f64>, &[f64]),
    cones: &[SupportedConeT<f64>],
    accuracy: Accuracy,
    token: &CancelToken,
) -> Option<DefaultSolution<f64>> {
    let Accuracy { tolerance, nearly, iterations, refinements } = accuracy;
    if a.nzval.iter().chain(b).chain(q).any(|v| !v.is_finite()) {
        return None;
    }
    let settings = DefaultSettings {
        verbose: false,
        max_iter: iterations,
        tol_gap_abs: tolerance,
        tol_gap_rel: tolerance,
        tol_feas: tolerance,
        reduced_tol_gap_abs: nearly,
        reduced_tol_gap_rel: nearly,
        reduced_tol_feas: nearly,
        iterative_refinement_enable: refinements > 0,
        iterative_refinement_max_iter: refinements,
        max_threads: 1,
        presolve_enable: false,
        direct_solve_method: "qdldl".to_string(),
        ..DefaultSettings::default()
    };
    let mut solver = DefaultSolver::new(p, q, a, b, cones, settings).ok()?;
    let token = token.clone();
    solver.set_termination_callback(move |_| !token.iterate());
    solver.solve();
    let found = solver.solution;
    found.x.iter().chain(&found.z).all(|v| v.is_finite()).then_some(found)
}

/// The matrix of columns of entries, each with its row.
pub(super) fn compressed(rows: usize, columns: &[Vec<(usize, f64)>]) -> CscMatrix<f64> {
    let entries: usize = columns.iter().map(Vec::len).sum();
    let mut starts = Vec::with_capacity(columns.len() + 1);
    let (mut indices, mut values) = (Vec::with_capacity(entries), Vec::with_capacity(entries));
    starts.push(0);
    let mut sorted = Vec::new();
    for column in columns {
        sorted.clone_from(column);
        sorted.sort_unstable_by_key(|e| e.0);
        indices.extend(sorted.iter().map(|e| e.0));
        values.extend(sorted.iter().map(|e| e.1));
        starts.push(indices.len());
    }
    CscMatrix::new(rows, columns.len(), starts, indices, values)
}
