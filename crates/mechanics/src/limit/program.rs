//! The convex program, solved by Clarabel's interior-point method.

use super::equilibrium::{Entry, Equilibrium};
use super::interior_point::{Accuracy, compressed, minimise};
use clarabel::algebra::CscMatrix;
use clarabel::solver::{NonnegativeConeT, SecondOrderConeT, SolverStatus, SupportedConeT, ZeroConeT};

/// Maximises a number `t`, or the `objective` of the joint forces `f`, subject to `B f + t scaled_loads + constant_loads = 0`,
/// `t <= cap` and the strength of the joints.
pub(super) struct Program<'a> {
    /// Geometry, joints and units.
    pub equilibrium: &'a Equilibrium,
    /// Loads that `t` multiplies, scaled; empty for none.
    pub scaled_loads: &'a [f64],
    /// Loads that it does not, scaled.
    pub constant_loads: &'a [f64],
    /// Largest `t`.
    pub cap: Option<f64>,
    /// Weights of the forces in the objective: column and weight. Empty to make `t` largest.
    pub objective: Vec<Entry>,
    /// What `t` means beside that.
    pub interpretation: Interpretation,
}

/// What `t` stands for besides the multiplier of `scaled_loads`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Interpretation {
    /// Nothing.
    Factor,
    /// A margin, scaled force, that every limit of every joint must keep; negative where a limit is exceeded.
    Margin,
    /// The unit of force: it multiplies every strength, is not negative, and the compression of this joint is one.
    /// That makes a linear program of the ratio of a force to this compression.
    UnitCompression(usize),
}

/// Relative gap and residuals of a program that is nearly solved, as where joints crush: it is not an answer by itself.
const NEARLY: f64 = 1e-6;

/// What a program returned, scaled.
#[derive(Debug, Clone)]
pub(super) struct Solution {
    /// Whether to its tolerance.
    pub solved: bool,
    /// Forces: of each joint the compressions, then the shear.
    pub forces: Vec<f64>,
    /// The number `t`.
    pub factor: f64,
    /// Multipliers of the equilibrium equations.
    pub velocities: Vec<f64>,
    /// Iterations.
    pub iterations: u32,
}

impl<'a> Program<'a> {
    /// The program of the largest factor of the variable loads, beside the permanent ones.
    pub(super) fn of_the_factor(equilibrium: &'a Equilibrium) -> Program<'a> {
        Program {
            equilibrium,
            scaled_loads: &equilibrium.variable,
            constant_loads: &equilibrium.permanent,
            cap: None,
            objective: Vec::new(),
            interpretation: Interpretation::Factor,
        }
    }

    /// Solves to a relative gap and residual of `tolerance`.
    pub(super) fn solve(&self, tolerance: f64) -> Solution {
        let forces = self.equilibrium.columns.len();
        let (a, b, cones) = self.constraints();
        let mut q = vec![0.0; forces + 1];
        if self.objective.is_empty() {
            q[forces] = -1.0;
        }
        for &(i, v) in &self.objective {
            q[i] -= v;
        }
        let p = CscMatrix::zeros((forces + 1, forces + 1));
        let token = &self.equilibrium.token;
        let accuracy = Accuracy { tolerance, nearly: NEARLY, iterations: 100, refinements: 10 };
        let found = (!token.is_cancelled()).then(|| minimise((&p, &q), (&a, &b), &cones, accuracy, token)).flatten();
        let Some(found) = found else {
            let (forces, velocities) = (vec![0.0; forces], vec![0.0; self.equilibrium.rows]);
            return Solution { solved: false, forces, factor: 0.0, velocities, iterations: 0 };
        };
        Solution {
            solved: found.status == SolverStatus::Solved,
            forces: found.x[..forces].to_vec(),
            factor: found.x[forces],
            velocities: found.z[..self.equilibrium.rows].to_vec(),
            iterations: found.iterations,
        }
    }

    /// `b - A x` lies in the cones: equations, then linear limits, then one parabola per contact point.
    fn constraints(&self) -> (CscMatrix<f64>, Vec<f64>, Vec<SupportedConeT<f64>>) {
        let equations = self.equilibrium.rows;
        let mut columns: Vec<Vec<Entry>> = self.equilibrium.columns.clone();
        columns.push(self.scaled_loads.iter().copied().enumerate().filter(|&(_, v)| v != 0.0).collect());
        let mut b: Vec<f64> = self.constant_loads.iter().map(|r| -r).collect();
        let last = columns.len() - 1;
        let unit = self.equilibrium.force;
        let mut equations = equations;
        if let Interpretation::UnitCompression(joint) = self.interpretation {
            let of = &self.equilibrium.joints[joint];
            for column in &mut columns[of.column..of.column + of.points.len()] {
                column.push((equations, 1.0));
            }
            b.push(1.0);
            equations += 1;
        }
        let interpretation = self.interpretation;
        let mut limit = |columns: &mut Vec<Vec<Entry>>, at_least_zero: &[Entry], constant: f64, margin: bool| {
            for &(column, v) in at_least_zero {
                columns[column].push((b.len(), -v));
            }
            match interpretation {
                Interpretation::Margin if margin => columns[last].push((b.len(), 1.0)),
                Interpretation::UnitCompression(_) if constant != 0.0 => columns[last].push((b.len(), -constant)),
                _ => {}
            }
            b.push(if matches!(interpretation, Interpretation::UnitCompression(_)) { 0.0 } else { constant });
        };
        if matches!(interpretation, Interpretation::UnitCompression(_)) {
            limit(&mut columns, &[(last, 1.0)], 0.0, false);
        }
        if let Some(cap) = self.cap {
            limit(&mut columns, &[(last, -1.0)], cap, false);
        }
        for joint in &self.equilibrium.joints {
            let (c, n, strength) = (joint.column, joint.points.len(), &joint.strength);
            let curved = strength.curvature(n) > 0.0;
            for k in (0..n).filter(|_| !curved) {
                limit(&mut columns, &[(c + k, 1.0)], strength.tension / unit, true);
            }
            if strength.friction.is_finite() {
                for sign in [1.0, -1.0] {
                    let mut entries = vec![(c + n, sign)];
                    entries.extend((0..n).map(|k| (c + k, strength.friction)));
                    limit(&mut columns, &entries, strength.cohesion / unit, true);
                }
            }
        }
        for r in &self.equilibrium.restraints {
            limit(&mut columns, &[(r.column, 1.0)], 0.0, false);
            limit(&mut columns, &[(r.column, -1.0)], r.most, false);
        }
        let mut cones = vec![ZeroConeT(equations), NonnegativeConeT(0)];
        for joint in &self.equilibrium.joints {
            let (c, strength) = (joint.column, &joint.strength);
            let curvature = strength.curvature(joint.points.len()) * unit;
            if curvature == 0.0 {
                continue;
            }
            let tension = strength.tension / unit;
            // (n' + q)^2 >= (n' - q)^2 + 4 q curvature total'^2, with q = curvature: balanced where total' is about 1.
            for k in 0..2 {
                limit(&mut columns, &[(c + k, 1.0)], tension + curvature, true);
                limit(&mut columns, &[(c + k, 1.0)], tension - curvature, true);
                let slope = 2.0 * curvature;
                limit(&mut columns, &[(c, slope), (c + 1, slope)], 2.0 * slope * tension, false);
                cones.push(SecondOrderConeT(3));
            }
        }
        let curved = 3 * (cones.len() - 2);
        cones[1] = NonnegativeConeT(b.len() - equations - curved);
        (compressed(b.len(), &columns), b, cones)
    }
}
