//! Joint forces as a state of equilibrium and what may be added to it without any load.
//!
//! All forces in equilibrium with the permanent loads and `factor` times a load are
//! `f = f0 + factor f_p + N x`: `f0` carries the permanent loads within strength, `f_p` balances the load, and the columns
//! of `N` are states of self-stress, three for every ring that is clamped at both ends. So limit analysis of a load is a
//! linear program in `x` and the factor alone, a handful of unknowns, whose rows change with the load in one column only.
//! `f0`, `N` and the factorisation behind `f_p` are made once for all loads.

use super::compliance::Stiffness;
use super::equilibrium::{Entry, Equilibrium};

/// Beyond this many states of self-stress dense rows cost more than a sparse interior-point method.
const MOST_STATES: usize = 160;

/// A row that forces must keep: `entries . f + constant >= 0`.
#[derive(Debug, Clone)]
pub(super) struct Row {
    /// Column and coefficient; a joint has no more than three forces, and what is left is zeros.
    entries: [Entry; 3],
    /// Constant, scaled force.
    pub constant: f64,
    /// Whether a joint slides where the row is reached.
    pub slides: bool,
}

impl Row {
    fn new(own: &[Entry], constant: f64, slides: bool) -> Row {
        let mut entries = [(0, 0.0); 3];
        entries[..own.len()].copy_from_slice(own);
        Row { entries, constant, slides }
    }

    /// Whether another one is a tangent to the same parabola.
    pub(super) fn is_beside(&self, other: &Row) -> bool {
        self.entries[0].0 == other.entries[0].0
    }

    /// Columns and their coefficients.
    pub(super) fn entries(&self) -> impl Iterator<Item = Entry> + '_ {
        self.entries.iter().copied().filter(|entry| entry.1 != 0.0)
    }

    /// `entries . f`.
    pub(super) fn of(&self, forces: &[f64]) -> f64 {
        self.entries.iter().map(|&(c, v)| v * forces[c]).sum()
    }
}

/// States of self-stress, as many as there are columns more than equations: orthonormal ones of the joints, then each force
/// that answers movement with the joint forces that balance it. None where they are too many, or where round-off would
/// spoil them.
pub(super) fn self_stress(elastic: &mut Stiffness) -> Option<Vec<Vec<f64>>> {
    let (all, columns) = (elastic.equilibrium.columns.len(), elastic.equilibrium.joint_columns());
    let states = columns.checked_sub(elastic.equilibrium.rows)?;
    // Forces that answer movement stand at their bounds but for a few: they do not make a program large.
    if all == elastic.equilibrium.rows || states > MOST_STATES {
        return None;
    }
    // Rows of the projector on self-stress, taken largest first (a pivoted Cholesky factorisation of it).
    let mut project = |v: &[f64]| -> Option<Vec<f64>> {
        let load = elastic.equilibrium.balance(vec![0.0; elastic.equilibrium.rows], v);
        let balance = elastic.balance(&load)?;
        Some(v.iter().zip(balance).map(|(a, b)| a + b).collect())
    };
    let unit = |c: usize| (0..all).map(|k| if k == c { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
    let mut left = Vec::with_capacity(columns);
    for c in 0..columns {
        left.push(project(&unit(c))?[c]);
    }
    let mut basis: Vec<Vec<f64>> = Vec::with_capacity(states);
    for _ in 0..states {
        let mut largest = 0;
        for c in 1..columns {
            if left[c] > left[largest] {
                largest = c;
            }
        }
        let mut state = unit(largest);
        // Twice is enough: what the first pass leaves of the others is round-off.
        for _ in 0..2 {
            state = project(&state)?;
            for other in &basis {
                let along: f64 = state.iter().zip(other).map(|(a, b)| a * b).sum();
                for (a, b) in state.iter_mut().zip(other) {
                    *a -= along * b;
                }
            }
            let size = state.iter().map(|a| a * a).sum::<f64>().sqrt();
            if !(size > 1e-6) {
                return None;
            }
            state.iter_mut().for_each(|a| *a /= size);
        }
        for (l, a) in left.iter_mut().zip(&state) {
            *l -= a * a;
        }
        basis.push(state);
    }
    for c in columns..all {
        basis.push(project(&unit(c))?);
    }
    Some(basis)
}

/// What the strength of all joints asks of their forces, linear: without the parabolas of joints that crush.
pub(super) fn rows(equilibrium: &Equilibrium) -> Vec<Row> {
    let unit = equilibrium.force;
    let mut rows = Vec::new();
    for joint in &equilibrium.joints {
        let (c, n, strength) = (joint.column, joint.points.len(), &joint.strength);
        // Tension also bounds joints that crush: their parabola lies within.
        for k in 0..n {
            rows.push(Row::new(&[(c + k, 1.0)], strength.tension / unit, false));
        }
        if strength.friction.is_finite() {
            for sign in [1.0, -1.0] {
                let forces = [(c + n, sign), (c, strength.friction), (c + 1, strength.friction)];
                rows.push(Row::new(&forces[..=n], strength.cohesion / unit, true));
            }
        }
    }
    for restraint in &equilibrium.restraints {
        rows.push(Row::new(&[(restraint.column, 1.0)], 0.0, false));
        rows.push(Row::new(&[(restraint.column, -1.0)], restraint.most, false));
    }
    rows
}

/// Tangents, at these forces, to the parabolas of joints that crush, where the forces lie outside by more than `allowed`.
pub(super) fn tangents(equilibrium: &Equilibrium, forces: &[f64], allowed: f64) -> Vec<Row> {
    let unit = equilibrium.force;
    let mut rows = Vec::new();
    for joint in &equilibrium.joints {
        let (c, strength) = (joint.column, &joint.strength);
        let curvature = strength.curvature(joint.points.len()) * unit;
        if curvature == 0.0 {
            continue;
        }
        let tension = strength.tension / unit;
        let total = forces[c] + forces[c + 1] + 2.0 * tension;
        for k in 0..2 {
            if forces[c + k] + tension - curvature * total * total < -allowed {
                // n' >= curvature (2 total0 total' - total0^2), with n' and total' shifted by the tension.
                let slope = 2.0 * curvature * total;
                let constant = tension - 2.0 * slope * tension + curvature * total * total;
                rows.push(Row::new(&[(c + k, 1.0 - slope), (c + 1 - k, -slope)], constant, false));
            }
        }
    }
    rows
}
