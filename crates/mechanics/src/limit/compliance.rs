//! `K = sum B_j C_j B_j^T`: the stiffness of the blocks when each joint resists by a small matrix `C_j`. With `C_j = 1`
//! it gives an elastic state; with projections it takes out of velocities what a mechanism must not do.

use super::equilibrium::Equilibrium;
use clarabel::algebra::CscMatrix;
use clarabel::qdldl::QDLDLFactorisation;

/// A symmetric matrix for the forces of one joint: compressions, then the shear.
pub(super) type Resistance = [[f64; 3]; 3];

/// Resistance of one to everything.
const ALIKE: Resistance = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Out-of-balance forces, relative to all permanent loads, that a state may leave: round-off of a refined solution.
const BALANCED: f64 = 1e-11;
/// Passes in which a load is balanced, and what the last one need not take out: round-off of loads whose sizes sum to one.
const PASSES: usize = 3;
const ENOUGH: f64 = 1e-15;

/// Added to the diagonal of `K`, whose entries are of the order of one: far below the smallest stiffness of a chain of
/// a thousand blocks, far above round-off.
const SHIFT: f64 = 1e-12;

/// `K`, factorised, together with what it was made from.
pub(super) struct Stiffness<'a> {
    pub(super) equilibrium: &'a Equilibrium,
    resistances: Vec<Resistance>,
    factor: QDLDLFactorisation,
}

impl<'a> Stiffness<'a> {
    /// Factorises, with a resistance for each joint; `None` where that fails.
    pub(super) fn new(equilibrium: &'a Equilibrium, resistances: Vec<Resistance>) -> Option<Self> {
        let (mut rows, mut columns, mut values) = (Vec::new(), Vec::new(), Vec::new());
        let mut push = |i: usize, j: usize, v: f64| {
            rows.push(i);
            columns.push(j);
            values.push(v);
        };
        for (joint, resistance) in equilibrium.joints.iter().zip(&resistances) {
            let parts = equilibrium.parts(joint.columns());
            for (i, a) in &parts {
                let scaled = apply(resistance, *a);
                for (j, b) in parts.iter().filter(|(j, _)| j >= i) {
                    push(*i, *j, scaled.iter().zip(b).map(|(x, y)| x * y).sum());
                }
            }
        }
        for i in 0..equilibrium.rows {
            push(i, i, SHIFT);
        }
        let n = equilibrium.rows;
        let matrix = CscMatrix::new_from_triplets(n, n, rows, columns, values);
        let factor = QDLDLFactorisation::new(&matrix, None).ok()?;
        Some(Stiffness { equilibrium, resistances, factor })
    }

    /// That of joints that are all alike.
    pub(super) fn alike(equilibrium: &'a Equilibrium) -> Option<Self> {
        Stiffness::new(equilibrium, vec![ALIKE; equilibrium.joints.len()])
    }

    /// Solves `(K + SHIFT) x = b`.
    pub(super) fn solve(&mut self, b: &[f64]) -> Vec<f64> {
        let mut x = b.to_vec();
        self.factor.solve(&mut x);
        x
    }

    /// Joint forces `C_j B_j^T u` of velocities `u`.
    pub(super) fn forces(&self, velocities: &[f64]) -> Vec<f64> {
        let mut forces = self.equilibrium.deformations(velocities);
        for (joint, resistance) in self.equilibrium.joints.iter().zip(&self.resistances) {
            let own = &mut forces[joint.columns()];
            let mut one = [0.0; 3];
            one[..own.len()].copy_from_slice(own);
            own.copy_from_slice(&apply(resistance, one)[..own.len()]);
        }
        // What answers movement is no joint and has no stiffness.
        forces[self.equilibrium.joint_columns()..].fill(0.0);
        forces
    }

    /// Forces `f` of elastic joints with `B f = -load`; none where round-off spoils them.
    pub(super) fn balance(&mut self, load: &[f64]) -> Option<Vec<f64>> {
        let mut forces = vec![0.0; self.equilibrium.columns.len()];
        let mut left: Vec<f64> = load.iter().map(|p| -p).collect();
        let mut worst = f64::INFINITY;
        // Each pass takes out what the one before left of the load.
        for _ in 0..PASSES {
            let velocities = self.solve(&left);
            for (f, d) in forces.iter_mut().zip(self.forces(&velocities)) {
                *f += d;
            }
            left = self.equilibrium.balance(load.to_vec(), &forces).into_iter().map(|p| -p).collect();
            worst = left.iter().fold(0.0f64, |m, r| m.max(r.abs()));
            if worst <= ENOUGH {
                break;
            }
        }
        (worst <= BALANCED).then_some(forces)
    }

    /// Velocities whose deformations are `wanted`, as nearly as may be.
    pub(super) fn motion(&mut self, wanted: &[f64]) -> Vec<f64> {
        let mut velocities = vec![0.0; self.equilibrium.rows];
        for _ in 0..2 {
            let have = self.equilibrium.deformations(&velocities);
            let mut missing: Vec<f64> = wanted.iter().zip(&have).map(|(w, h)| w - h).collect();
            missing[self.equilibrium.joint_columns()..].fill(0.0);
            let out = self.equilibrium.balance(vec![0.0; self.equilibrium.rows], &missing);
            for (u, d) in velocities.iter_mut().zip(self.solve(&out)) {
                *u += d;
            }
        }
        velocities
    }
}

fn apply(m: &Resistance, v: [f64; 3]) -> [f64; 3] {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}
