//! Joints that are elastic along their whole depth, with the blocks between them: of all states in balance with a load, the one of
//! least energy. Joints of two equal springs at their ends would be three times as stiff in rotation for the same stiffness in
//! compression, which takes a tenth off the thrust of a flat ring.

use super::equilibrium::Equilibrium;
use super::joints::Joint;
use crate::blocks::BlockModel;
use crate::ids::BlockId;

/// Compliance of a block in shear over that in compression, each times its area: 2 (1 + nu) / (5/6) with Poisson's ratio of 0.2.
const SHEAR: f64 = 2.88;
/// A state of self-stress belongs to joints alone where its other forces are smaller than this.
const NOTHING: f64 = 1e-12;

/// What turns any state in balance into the elastic one: states of self-stress, and how much of each.
#[derive(Debug, Clone)]
pub(super) struct Bedded {
    states: Vec<Vec<f64>>,
    /// Rows of `(S^T F S)^-1 S^T F`.
    shares: Vec<Vec<f64>>,
}

impl Bedded {
    /// From states of self-stress; none where their energies cannot be told apart.
    pub(super) fn new(model: &BlockModel, equilibrium: &Equilibrium, states: &[Vec<f64>]) -> Option<Bedded> {
        let own = equilibrium.joint_columns();
        let of_joints = |state: &&Vec<f64>| state[own..].iter().all(|force| force.abs() < NOTHING);
        let states: Vec<Vec<f64>> = states.iter().filter(of_joints).cloned().collect();
        let lengths: Vec<f64> = equilibrium.joints.iter().map(|joint| spacing(model, joint)).collect();
        let weighed: Vec<Vec<f64>> = states.iter().map(|state| compliances(equilibrium, &lengths, state)).collect();
        let energies: Vec<Vec<f64>> = states
            .iter()
            .map(|a| weighed.iter().map(|b| a.iter().zip(b).map(|(x, y)| x * y).sum()).collect())
            .collect();
        let shares = solved(energies, weighed)?;
        Some(Bedded { states, shares })
    }

    /// The elastic state that balances the same load.
    pub(super) fn relaxed(&self, forces: &[f64]) -> Vec<f64> {
        let mut relaxed = forces.to_vec();
        for (state, share) in self.states.iter().zip(&self.shares) {
            let x: f64 = share.iter().zip(forces).map(|(a, b)| a * b).sum();
            relaxed.iter_mut().zip(state).for_each(|(force, s)| *force -= x * s);
        }
        relaxed
    }
}

/// How much of the blocks on both sides a joint stands for [m]: the distance of their centroids along its normal; a held block gives
/// nothing.
fn spacing(model: &BlockModel, joint: &Joint) -> f64 {
    let middle =
        joint.points.iter().fold(crate::plane::Vec2::ZERO, |sum, &at| sum + at) * (1.0 / joint.points.len() as f64);
    let half = |block: BlockId| {
        let block = &model.blocks[block];
        if block.held.is_fixed() { 0.0 } else { (block.outline.centroid() - middle).dot(joint.normal).abs() }
    };
    half(joint.first) + half(joint.second)
}

/// Deformations `F f` of joints under their forces: compression that varies in a straight line along the joint, and shear.
fn compliances(equilibrium: &Equilibrium, lengths: &[f64], forces: &[f64]) -> Vec<f64> {
    let mut found = vec![0.0; forces.len()];
    for (joint, length) in equilibrium.joints.iter().zip(lengths) {
        let (c, f) = (joint.column, length / joint.length.max(f64::MIN_POSITIVE));
        // A single point has no depth: its force follows from balance.
        if joint.points.len() == 2 {
            found[c] = f * (4.0 * forces[c] - 2.0 * forces[c + 1]);
            found[c + 1] = f * (4.0 * forces[c + 1] - 2.0 * forces[c]);
            found[c + 2] = f * SHEAR * forces[c + 2];
        }
    }
    found
}

/// `A^-1 B` by elimination with pivots; none where a pivot vanishes.
fn solved(mut a: Vec<Vec<f64>>, mut b: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
    let n = a.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
        a.swap(k, pivot);
        b.swap(k, pivot);
        let scale = a[k][k];
        if scale.abs() < f64::MIN_POSITIVE {
            return None;
        }
        a[k].iter_mut().for_each(|v| *v /= scale);
        b[k].iter_mut().for_each(|v| *v /= scale);
        let (row, right) = (a[k].clone(), b[k].clone());
        for i in (0..n).filter(|i| *i != k) {
            let share = a[i][k];
            if share != 0.0 {
                a[i].iter_mut().zip(&row).for_each(|(v, r)| *v -= share * r);
                b[i].iter_mut().zip(&right).for_each(|(v, r)| *v -= share * r);
            }
        }
    }
    Some(b)
}
