//! Equilibrium of the free blocks, in scaled form.

use super::joints::Joint;
use crate::blocks::{BlockModel, Loading, PointForce};
use crate::ids::{BlockId, Table};
use crate::plane::{Vec2, vec2};
use crate::watch::CancelToken;

/// One entry of a column: equation and coefficient.
pub(super) type Entry = (usize, f64);

/// `B f + factor p + w = 0`: three equations for each free block, moments about its centroid divided by `length`,
/// forces divided by `force`, the factor multiplied by `factor_scale`. Every number is then of the order of one.
#[derive(Debug, Clone)]
pub(super) struct Equilibrium {
    /// Number of equations.
    pub rows: usize,
    /// Equation of each motion (x, y, rotation) of each block; `None` where it is prevented.
    pub row: Table<BlockId, [Option<usize>; 3]>,
    /// Columns of `B`: those of a joint are its compressions, then its shear.
    pub columns: Vec<Vec<Entry>>,
    /// First column of each joint.
    pub first_column: Vec<usize>,
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
    /// Sets up the equations of the blocks as built.
    pub(super) fn new(model: &BlockModel, loading: &Loading, joints: &[Joint]) -> Equilibrium {
        let centroids = model.blocks.iter().map(|b| b.outline.centroid()).collect();
        Equilibrium::placed(model, &centroids, loading, joints)
    }

    /// Sets up the equations of blocks whose centroids, forces and joints have moved to where they are given.
    pub(super) fn placed(
        model: &BlockModel,
        centroids: &Table<BlockId, Vec2>,
        loading: &Loading,
        joints: &[Joint],
    ) -> Equilibrium {
        let mut rows = 0;
        let row: Table<BlockId, [Option<usize>; 3]> = model
            .blocks
            .iter()
            .map(|b| {
                [b.held.x, b.held.y, b.held.rotation].map(|held| {
                    (!held).then(|| {
                        rows += 1;
                        rows - 1
                    })
                })
            })
            .collect();
        let length = unit_of_length(model, joints);
        let mut this = Equilibrium {
            rows,
            token: CancelToken::default(),
            row,
            columns: Vec::with_capacity(3 * joints.len()),
            first_column: Vec::with_capacity(joints.len()),
            restraints: Vec::new(),
            permanent: vec![0.0; rows],
            variable: vec![0.0; rows],
            force: 1.0,
            length,
            factor_scale: 1.0,
        };
        for joint in joints {
            this.first_column.push(this.columns.len());
            let unit_forces =
                joint.points.iter().map(|&at| (at, joint.normal)).chain([(joint.points[0], joint.tangent())]);
            for (at, force) in unit_forces {
                let mut column = Vec::with_capacity(6);
                this.act(joint.second, at - centroids[joint.second], force, |i, v| column.push((i, v)));
                this.act(joint.first, at - centroids[joint.first], -force, |i, v| column.push((i, v)));
                this.columns.push(column);
            }
        }
        for r in loading.restraints.iter().filter(|r| r.most > r.least) {
            let mut column = Vec::with_capacity(6);
            this.act(r.block, r.at - centroids[r.block], r.direction, |i, v| column.push((i, v)));
            if let Some((block, at)) = r.against {
                this.act(block, at - centroids[block], -r.direction, |i, v| column.push((i, v)));
            }
            this.restraints.push(Restrained { column: this.columns.len(), most: r.most - r.least });
            this.columns.push(column);
        }
        let mut permanent = vec![0.0; rows];
        for (id, block) in model.blocks.pairs() {
            this.act(id, Vec2::ZERO, model.gravity * block.mass(), |i, v| permanent[i] += v);
        }
        let add = |forces: &[PointForce], to: &mut Vec<f64>| {
            for f in forces {
                this.act(f.block, f.at - centroids[f.block], f.force, |i, v| to[i] += v);
            }
        };
        add(&loading.permanent, &mut permanent);
        for r in &loading.restraints {
            this.act(r.block, r.at - centroids[r.block], r.direction * r.least, |i, v| permanent[i] += v);
            if let Some((block, at)) = r.against {
                this.act(block, at - centroids[block], -r.direction * r.least, |i, v| permanent[i] += v);
            }
        }
        let mut variable = vec![0.0; rows];
        add(&loading.variable, &mut variable);
        this.scale(permanent, variable, least_strength(joints));
        let force = this.force;
        this.restraints.iter_mut().for_each(|r| r.most = (r.most / force).max(0.0));
        this
    }

    /// The same with nothing that answers movement.
    pub(super) fn unrestrained(&self) -> Equilibrium {
        let mut this = self.clone();
        this.restraints.iter_mut().for_each(|r| r.most = 0.0);
        this
    }

    /// Number of columns of joints.
    pub(super) fn joint_columns(&self) -> usize {
        self.columns.len() - self.restraints.len()
    }

    /// Adds a force on a block to the equations of that block.
    fn act(&self, block: BlockId, arm: Vec2, force: Vec2, mut add: impl FnMut(usize, f64)) {
        let values = [force.x, force.y, arm.cross(force) / self.length];
        for (row, value) in self.row[block].iter().zip(values) {
            if let Some(i) = row {
                add(*i, value);
            }
        }
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

    /// What a load adds to the equations, in newtons per metre.
    pub(super) fn of_load(&self, model: &BlockModel, load: &[PointForce]) -> Vec<f64> {
        let mut p = vec![0.0; self.rows];
        for f in load {
            let centroid = model.blocks[f.block].outline.centroid();
            self.act(f.block, f.at - centroid, f.force, |i, v| p[i] += v);
        }
        p
    }

    /// `B f + factor p + w` for scaled forces.
    pub(super) fn residual(&self, forces: &[f64], factor: f64) -> Vec<f64> {
        let mut r: Vec<f64> = self.permanent.iter().zip(&self.variable).map(|(w, p)| w + factor * p).collect();
        for (column, f) in self.columns.iter().zip(forces) {
            for &(i, v) in column {
                r[i] += v * f;
            }
        }
        r
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
