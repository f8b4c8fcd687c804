//! What is fixed once the path is set up: joints, loads and the order of the equations.

use super::joint::Joint;
use super::restraint::Restrained;
use super::settings::Settings;
use crate::acting::Resultant;
use crate::blocks::{BlockModel, Interface, Loading, ModelError, PointForce, interfaces};
use crate::ids::{BlockId, Id};
use crate::numbering::{HELD, numbered};
use crate::plane::{Vec2, vec2};
use serde::Serialize;

/// Rigid blocks, their joints and what acts on them.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Model {
    /// The joints as built, in the order of their blocks.
    pub interfaces: Vec<Interface>,
    pub(super) joints: Vec<Joint>,
    pub(super) restraints: Vec<Restrained>,
    /// Centre of mass of each block as built [m].
    pub(super) built: Vec<Vec2>,
    /// Weight and permanent forces of each block.
    pub(super) permanent: Vec<Resultant>,
    /// Variable forces at load factor 1.
    pub(super) variable: Vec<Resultant>,
    /// Motion imposed at load factor 1: translations [m] and rotation [rad].
    pub(super) movement: Vec<[f64; 3]>,
    /// Equation of each motion of each block, or [`HELD`].
    pub(super) equation: Vec<[u32; 3]>,
    pub(super) equations: usize,
    /// The last equation that each one acts with.
    pub(super) last: Vec<u32>,
    /// Force that rounding of coordinates alone may leave out of balance [N/m].
    pub(super) rounding: f64,
    /// Length that rotations are multiplied by, so that all unknowns are lengths [m]: mean side of the free blocks.
    pub(super) size: f64,
}

impl Model {
    /// Sets the equations up.
    ///
    /// # Errors
    /// What makes a model unusable: particles, no free block, a movement of a block that is free to move, a block that is
    /// named but not there, a joint without length.
    pub(super) fn new(model: &BlockModel, loading: &Loading, settings: &Settings) -> Result<Model, ModelError> {
        if !model.particles.is_empty() {
            return Err(ModelError::ParticlesInLimitAnalysis(model.particles.len()));
        }
        let named = loading.permanent.iter().chain(&loading.variable).map(|f| f.block);
        for block in named.chain(loading.movements.iter().map(|m| m.block)) {
            if block.index() >= model.blocks.len() {
                return Err(ModelError::Unknown { what: "block", id: block.0 });
            }
        }
        for law in model.laws.clone().iter_mut() {
            for (what, stiffness) in [("normal stiffness", law.normal), ("shear stiffness", law.shear)] {
                let value = stiffness.at(0.0);
                if !(value > 0.0) {
                    return Err(ModelError::Law { what, value });
                }
            }
            if !(law.crushing > 0.0) {
                return Err(ModelError::Law { what: "compressive strength", value: law.crushing });
            }
        }
        let interfaces = interfaces(model, settings.touching)?;
        let joints = Joint::all(model, &interfaces)?;
        let built: Vec<Vec2> = model.blocks.iter().map(|b| b.outline.centroid()).collect();
        let held: Vec<[bool; 3]> = model.blocks.iter().map(|b| [b.held.x, b.held.y, b.held.rotation]).collect();
        let free: Vec<usize> = (0..built.len()).filter(|&i| held[i] != [true; 3]).collect();
        if free.is_empty() {
            return Err(ModelError::NothingFree);
        }
        let restraints = Restrained::all(loading, &built)?;
        let joined = joints.iter().map(|joint| [joint.first, joint.second]);
        let pushed = restraints.iter().filter_map(|r| match r.blocks() {
            [Some(a), Some(b)] => Some([a, b]),
            _ => None,
        });
        let pairs: Vec<[usize; 2]> = joined.chain(pushed).collect();
        let (equation, last) = numbered(&held, &pairs);
        let side = |&i: &usize| model.blocks[BlockId::new(i)].outline.area().sqrt();
        let size = free.iter().map(side).sum::<f64>() / free.len() as f64;
        let rounding = joints.iter().map(Joint::rounding).fold(0.0, f64::max);
        let mut permanent = vec![Resultant::default(); built.len()];
        for (id, block) in model.blocks.pairs() {
            permanent[id.index()].add(Vec2::ZERO, model.gravity * block.mass());
        }
        gather(&loading.permanent, &built, &mut permanent);
        let mut variable = vec![Resultant::default(); built.len()];
        gather(&loading.variable, &built, &mut variable);
        let mut movement = vec![[0.0; 3]; built.len()];
        for motion in &loading.movements {
            let (i, by) = (motion.block.index(), [motion.translation.x, motion.translation.y, motion.rotation]);
            for c in 0..3 {
                if by[c] != 0.0 && !held[i][c] {
                    return Err(ModelError::MovedWhileFree(motion.block.0));
                }
                movement[i][c] += by[c];
            }
        }
        Ok(Model {
            interfaces,
            joints,
            restraints,
            built,
            permanent,
            variable,
            movement,
            equation,
            equations: last.len(),
            last,
            rounding,
            size,
        })
    }

    /// The first of the equations of a block none of whose motions is prevented: they follow one another.
    #[inline(always)]
    pub(super) fn free(&self, block: usize) -> Option<usize> {
        let [first, second, turn] = self.equation[block];
        (first != HELD && second != HELD && turn != HELD).then_some(first as usize)
    }

    /// Puts other forces in the place of those that grow.
    pub(super) fn load(&mut self, forces: &[PointForce]) {
        self.variable.fill(Resultant::default());
        gather(forces, &self.built, &mut self.variable);
    }

    /// Where a point of a block as built [m] is after the block's motion.
    pub(super) fn moved(&self, block: usize, built: Vec2, motion: [f64; 3]) -> Vec2 {
        let (sine, cosine) = motion[2].sin_cos();
        let arm = built - self.built[block];
        self.built[block] + vec2(motion[0] + cosine * arm.x - sine * arm.y, motion[1] + sine * arm.x + cosine * arm.y)
    }
}

fn gather(forces: &[PointForce], built: &[Vec2], into: &mut [Resultant]) {
    for f in forces {
        into[f.block.index()].add(f.at - built[f.block.index()], f.force);
    }
}
