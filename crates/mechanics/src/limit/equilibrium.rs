//! Equilibrium of the free blocks, in scaled form.

use super::joints::{Joint, Strength, joints};
use super::settings::Settings;
use crate::blocks::{Block, BlockModel, Interface, Loading, ModelError, PointForce, Restraint};
use crate::ids::{BlockId, Table};
use crate::plane::{Vec2, vec2};
use crate::watch::CancelToken;
use std::ops::Range;

/// One entry of a column: equation and coefficient.
pub(super) type Entry = (usize, f64);

/// `B f + factor p + w = 0`: three equations for each free block, moments about its centroid divided by `length`,
/// forces divided by `force`, the factor multiplied by `factor_scale`. Every number is then of the order of one.
#[derive(Debug, Clone, Default)]
pub(super) struct Equilibrium {
    /// Number of equations.
    pub rows: usize,
    /// The joints and their strength.
    pub joints: Vec<Joint>,
    /// Equation of each motion (x, y, rotation) of each block; `None` where it is prevented.
    pub row: Table<BlockId, [Option<usize>; 3]>,
    /// Where moments are taken about [m].
    pub centroids: Table<BlockId, Vec2>,
    /// Columns of `B`: those of a joint are its compressions, then its shear.
    pub columns: Vec<Vec<Entry>>,
    /// Forces that answer movement, in columns after those of all joints. What is there anyway is a permanent load.
    pub restraints: Vec<Restrained>,
    /// Scaled permanent loads.
    pub permanent: Vec<f64>,
    /// Scaled variable loads.
    pub variable: Vec<f64>,
    /// Unit of force [N/m].
    pub force: f64,
    /// Unit of length for moments [m].
    pub length: f64,
    /// The scaled factor is the factor divided by this.
    pub factor_scale: f64,
    /// Asked by the methods that solve them whether to go on.
    pub token: CancelToken,
}

/// A force that answers movement: between zero and `most`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Restrained {
    /// Its column.
    pub column: usize,
    /// Largest force, scaled.
    pub most: f64,
}

impl Equilibrium {
    /// Sets up the equations of blocks of which some are free, and finds their joints.
    pub(super) fn of_free(
        model: &BlockModel,
        loading: &Loading,
        settings: &Settings,
    ) -> Result<(Vec<Interface>, Equilibrium), ModelError> {
        if model.blocks.iter().all(|b| b.held.is_fixed()) {
            return Err(ModelError::NothingFree);
        }
        Equilibrium::new(model, loading, settings)
    }

    /// Sets up the equations of the blocks as built, and finds their joints.
    pub(super) fn new(
        model: &BlockModel,
        loading: &Loading,
        settings: &Settings,
    ) -> Result<(Vec<Interface>, Equilibrium), ModelError> {
        let (interfaces, joints) = joints(model, settings)?;
        Ok((interfaces, Equilibrium::placed(model, model.centroids(), loading, joints)))
    }

    /// Sets up the equations of blocks whose centroids, forces and joints have moved to where they are given.
    pub(super) fn placed(
        model: &BlockModel,
        centroids: Table<BlockId, Vec2>,
        loading: &Loading,
        joints: Vec<Joint>,
    ) -> Equilibrium {
        let mut rows = 0;
        let mut number = |held: bool| {
            (!held).then(|| {
                rows += 1;
                rows - 1
            })
        };
        let row = model.blocks.iter().map(|b| [b.held.x, b.held.y, b.held.rotation].map(&mut number)).collect();
        let mut this = Equilibrium {
            rows,
            row,
            centroids,
            columns: Vec::with_capacity(3 * joints.len()),
            length: unit_of_length(model, &joints),
            ..Equilibrium::default()
        };
        for joint in &joints {
            let units = joint.points.iter().map(|&at| (at, joint.normal)).chain([(joint.points[0], joint.tangent())]);
            for (at, force) in units {
                let on_both = [(joint.second, force), (joint.first, -force)];
                let on_both = on_both.map(|(block, force)| PointForce { block, at, force });
                this.columns.push(on_both.into_iter().flat_map(|f| this.act(f)).collect());
            }
        }
        for r in loading.restraints.iter().filter(|r| r.most > r.least) {
            this.restraints.push(Restrained { column: this.columns.len(), most: r.most - r.least });
            this.columns.push(answering(r, 1.0).flat_map(|f| this.act(f)).collect());
        }
        let weight = |(block, b): (BlockId, &Block)| {
            let force = model.gravity * b.mass();
            PointForce { block, at: this.centroids[block], force }
        };
        let permanent = model.blocks.pairs().map(weight).chain(loading.permanent.iter().copied());
        let permanent = this.of_loads(permanent.chain(loading.restraints.iter().flat_map(|r| answering(r, r.least))));
        let variable = this.of_loads(loading.variable.iter().copied());
        this.scale(permanent, variable, least_strength(&joints));
        this.joints = joints;
        let force = this.force;
        this.restraints.iter_mut().for_each(|r| r.most = (r.most / force).max(0.0));
        this
    }

    /// The same with other strengths of all joints.
    pub(super) fn with_strengths(&self, of: impl Fn(&Strength) -> Strength) -> Equilibrium {
        let mut this = self.clone();
        this.joints.iter_mut().for_each(|joint| joint.strength = of(&joint.strength));
        this
    }

    /// The equations that some columns take part in, and the part of each of these columns, three at most.
    pub(super) fn parts(&self, columns: Range<usize>) -> Vec<(usize, [f64; 3])> {
        let mut parts: Vec<(usize, [f64; 3])> = Vec::with_capacity(6);
        for (k, column) in self.columns[columns].iter().enumerate() {
            for &(row, value) in column {
                let at = parts.iter().position(|part| part.0 == row).unwrap_or_else(|| {
                    parts.push((row, [0.0; 3]));
                    parts.len() - 1
                });
                parts[at].1[k] += value;
            }
        }
        parts
    }

    /// Whether any joint can crush.
    pub(super) fn crushes(&self) -> bool {
        self.joints.iter().any(|joint| joint.strength.crushing.is_finite())
    }

    /// Number of columns of joints.
    pub(super) fn joint_columns(&self) -> usize {
        self.columns.len() - self.restraints.len()
    }

    /// What a force on a block adds to the equations of that block.
    pub(super) fn act(&self, f: PointForce) -> impl Iterator<Item = Entry> {
        let moment = (f.at - self.centroids[f.block]).cross(f.force) / self.length;
        let values = self.row[f.block].into_iter().zip([f.force.x, f.force.y, moment]);
        values.filter_map(|(row, value)| Some((row?, value)))
    }

    /// What loads add to the equations, in newtons per metre.
    pub(super) fn of_loads(&self, forces: impl Iterator<Item = PointForce>) -> Vec<f64> {
        let mut sums = vec![0.0; self.rows];
        forces.flat_map(|f| self.act(f)).for_each(|(i, v)| sums[i] += v);
        sums
    }

    fn scale(&mut self, permanent: Vec<f64>, variable: Vec<f64>, strength: Option<f64>) {
        let size = |v: &[f64]| v.iter().map(|x| x.abs()).sum::<f64>();
        let (w, p) = (size(&permanent), size(&variable));
        // Without permanent loads the strength says how large the forces become; without either nothing does.
        self.force = match strength {
            _ if w > 0.0 => w,
            Some(strength) => strength,
            None if p > 0.0 => p,
            None => 1.0,
        };
        self.factor_scale = if p > 0.0 { self.force / p } else { 1.0 };
        self.permanent = permanent.iter().map(|x| x / self.force).collect();
        self.variable = variable.iter().map(|x| x * self.factor_scale / self.force).collect();
    }

    /// `factor p + w`.
    pub(super) fn loads(&self, factor: f64) -> Vec<f64> {
        self.permanent.iter().zip(&self.variable).map(|(w, p)| w + factor * p).collect()
    }

    /// `B f` added to loads, for scaled forces.
    pub(super) fn balance(&self, mut loads: Vec<f64>, forces: &[f64]) -> Vec<f64> {
        for (column, f) in self.columns.iter().zip(forces) {
            for &(i, v) in column {
                loads[i] += v * f;
            }
        }
        loads
    }

    /// `B f + factor p + w` for scaled forces.
    pub(super) fn residual(&self, forces: &[f64], factor: f64) -> Vec<f64> {
        self.balance(self.loads(factor), forces)
    }

    /// `B^T u`: how the velocities `u` open and shear every joint.
    pub(super) fn deformations(&self, velocities: &[f64]) -> Vec<f64> {
        self.columns.iter().map(|c| c.iter().map(|&(i, v)| v * velocities[i]).sum()).collect()
    }

    /// Translation [m] and rotation [rad] of each block for scaled velocities.
    pub(super) fn motions(&self, velocities: &[f64]) -> Table<BlockId, (Vec2, f64)> {
        self.row
            .iter()
            .map(|rows| {
                let v = rows.map(|r| r.map_or(0.0, |i| velocities[i]));
                (vec2(v[0], v[1]), v[2] / self.length)
            })
            .collect()
    }
}

/// A force of this size against a movement, and the opposite one on what bears it.
fn answering(r: &Restraint, size: f64) -> impl Iterator<Item = PointForce> + use<> {
    let force = r.direction * size;
    let against = r.against.map(|(block, at)| PointForce { block, at, force: -force });
    [Some(PointForce { block: r.block, at: r.at, force }), against].into_iter().flatten()
}

/// Half the mean joint length [m], or the mean block size where no joint has a length.
fn unit_of_length(model: &BlockModel, joints: &[Joint]) -> f64 {
    let faces: Vec<f64> = joints.iter().map(|j| j.length).filter(|&l| l > 0.0).collect();
    if faces.is_empty() {
        let area = model.blocks.iter().map(|b| b.outline.area()).sum::<f64>() / model.blocks.len().max(1) as f64;
        0.5 * area.sqrt()
    } else {
        0.5 * faces.iter().sum::<f64>() / faces.len() as f64
    }
}

/// The least strength of any joint that is a force by itself [N/m].
fn least_strength(joints: &[Joint]) -> Option<f64> {
    let forces = joints.iter().flat_map(|j| [j.strength.tension, j.strength.cohesion, j.strength.crushing]);
    forces.filter(|f| f.is_finite() && *f > 0.0).min_by(f64::total_cmp)
}
