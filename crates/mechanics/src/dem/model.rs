//! What is fixed once a run is set up.

use super::particles::{Blocks, MOST_GROUPS, MOST_PARTICLES, ParticleModel};
use super::search::close_pairs;
use crate::acting::Resultant;
use crate::blocks::{BlockModel, ContactLaw, LawTable, Loading, ModelError, PointForce, Stiffness};
use crate::ids::{BlockId, GroupId, Id, Table};
use crate::plane::{Core, Pose, Vec2, meet};
use serde::Serialize;

/// What a step needs of one body, side by side in memory.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct Body {
    pub inverse_mass: [f64; 3],
    pub mass: [f64; 3],
    /// 1 for a free motion, 0 for a prevented one.
    pub free: [f64; 3],
    /// Distance of its farthest point from the centre of mass [m].
    pub reach: f64,
}

/// Rigid bodies and what acts on them.
#[derive(Debug, Clone, Serialize)]
pub struct Model {
    pub(super) cores: Table<BlockId, Core>,
    pub(super) groups: Vec<GroupId>,
    pub(super) laws: LawTable,
    pub(super) particles: ParticleModel,
    /// Centre of mass of each block as built [m].
    pub(super) built: Vec<Vec2>,
    /// The same numbers as below, as the steps read them.
    pub(super) bodies: Vec<Body>,
    /// Mass [kg/m], twice, and moment of inertia [kg m].
    pub(super) mass: Vec<[f64; 3]>,
    /// Reciprocals of `mass`; zero for a prevented motion.
    pub(super) inverse_mass: Vec<[f64; 3]>,
    /// Radius of gyration [m].
    pub(super) gyration: Vec<f64>,
    pub(super) area: Vec<f64>,
    /// Weight and permanent forces.
    pub(super) permanent: Vec<Resultant>,
    /// Weight alone.
    pub(super) weight: Vec<Resultant>,
    /// Variable forces at load factor 1.
    pub(super) variable: Vec<Resultant>,
    /// Sums of `a (x) F` over the permanent and the variable forces as built [N]: xx, xy, yx, yy.
    pub(super) permanent_virial: Vec<[f64; 4]>,
    pub(super) variable_virial: Vec<[f64; 4]>,
    /// Imposed motion at load factor 1: translation [m], rotation [rad].
    pub(super) movement: Vec<[f64; 3]>,
    /// Mean side of the free blocks, the square root of their area [m].
    pub(super) block_size: f64,
    /// Smallest reach of a block [m].
    pub(super) least_reach: f64,
}

impl Model {
    /// Sets a model up. Refuses blocks without mass, blocks that overlap, rounding that leaves nothing of an edge, laws
    /// that are none, movements of blocks that are free to move, and blocks and groups that are named but not there.
    ///
    /// # Errors
    /// Those, particles that are none, too many or too different in size, and a model in which nothing is free.
    pub fn new(model: &BlockModel, loading: &Loading) -> Result<Model, ModelError> {
        check_names(model, loading)?;
        let cores = model.cores()?;
        let n = model.blocks.len();
        check_particles(model)?;
        let mut m = Model {
            particles: ParticleModel::new(&model.particles, &model.laws, model.gravity),
            groups: model.blocks.iter().map(|b| b.group).collect(),
            laws: model.laws.clone(),
            built: model.centroids().iter().copied().collect(),
            bodies: Vec::with_capacity(n),
            mass: Vec::with_capacity(n),
            inverse_mass: Vec::with_capacity(n),
            gyration: Vec::with_capacity(n),
            area: Vec::with_capacity(n),
            permanent: vec![Resultant::default(); n],
            weight: vec![Resultant::default(); n],
            variable: vec![Resultant::default(); n],
            permanent_virial: vec![[0.0; 4]; n],
            variable_virial: vec![[0.0; 4]; n],
            movement: vec![[0.0; 3]; n],
            block_size: 0.0,
            least_reach: cores
                .iter()
                .map(|c| c.reach)
                .chain(model.particles.iter().map(|p| p.radius))
                .fold(f64::INFINITY, f64::min),
            cores,
        };
        for (id, block) in model.blocks.pairs() {
            if !(block.density > 0.0 && block.density.is_finite()) {
                return Err(ModelError::NotPositive { of: "block", id: id.0, what: "density", value: block.density });
            }
            let area = block.outline.area();
            let mass = block.density * area;
            let inertia = block.density * block.outline.polar_moment();
            let free = |held: bool, m: f64| if held { 0.0 } else { 1.0 / m };
            m.area.push(area);
            m.mass.push([mass, mass, inertia]);
            m.gyration.push((inertia / mass).sqrt());
            m.inverse_mass.push([
                free(block.held.x, mass),
                free(block.held.y, mass),
                free(block.held.rotation, inertia),
            ]);
            let inverse_mass = m.inverse_mass[id.index()];
            m.bodies.push(Body {
                inverse_mass,
                mass: [mass, mass, inertia],
                free: inverse_mass.map(|i| f64::from(i > 0.0)),
                reach: m.cores[id].reach,
            });
            m.weight[id.index()].add(Vec2::ZERO, model.gravity * mass);
        }
        let free: Vec<usize> = m.free().collect();
        if free.is_empty() && model.particles.is_empty() {
            return Err(ModelError::NothingFree);
        }
        m.block_size = if free.is_empty() {
            let sizes = model.particles.iter().map(|p| std::f64::consts::PI.sqrt() * p.radius);
            sizes.sum::<f64>() / model.particles.len() as f64
        } else {
            free.iter().map(|&i| m.area[i].sqrt()).sum::<f64>() / free.len() as f64
        };
        m.permanent.clone_from(&m.weight);
        let add = |into: &mut [Resultant], virial: &mut [[f64; 4]], forces: &[PointForce]| {
            for f in forces {
                let i = f.block.index();
                let arm = f.at - m.built[i];
                into[i].add(arm, f.force);
                for (sum, x) in virial[i].iter_mut().zip([
                    arm.x * f.force.x,
                    arm.x * f.force.y,
                    arm.y * f.force.x,
                    arm.y * f.force.y,
                ]) {
                    *sum += x;
                }
            }
        };
        add(&mut m.permanent, &mut m.permanent_virial, &loading.permanent);
        add(&mut m.variable, &mut m.variable_virial, &loading.variable);
        for motion in &loading.movements {
            let i = motion.block.index();
            let by = [motion.translation.x, motion.translation.y, motion.rotation];
            for c in 0..3 {
                if by[c] != 0.0 && m.inverse_mass[i][c] > 0.0 {
                    return Err(ModelError::MovedWhileFree(motion.block.0));
                }
                m.movement[i][c] += by[c];
            }
        }
        m.check_laws()?;
        m.check_overlaps()?;
        Ok(m)
    }

    fn check_laws(&self) -> Result<(), ModelError> {
        let last = self.groups.iter().copied().max();
        let groups = || (0..=last.map_or(0, |g| g.index())).map(GroupId::new);
        groups().flat_map(|a| groups().map(move |b| (a, b))).try_for_each(|(a, b)| check_law(self.laws.between(a, b)))
    }

    /// Blocks may touch where they are built, not overlap: a contact would start with a force out of nothing.
    fn check_overlaps(&self) -> Result<(), ModelError> {
        let poses = self.poses();
        for (a, b) in close_pairs(self, &poses, 0.0) {
            let (core_a, core_b) = (&self.cores[BlockId(a)], &self.cores[BlockId(b)]);
            let (pose_a, pose_b) = (&poses[a as usize], &poses[b as usize]);
            let m = meet(core_a, pose_a, core_b, pose_b, None).manifold(core_a, pose_a, core_b, pose_b);
            let deepest = m.gaps[..m.count].iter().copied().fold(f64::INFINITY, f64::min);
            if deepest < -OVERLAP * core_a.reach.min(core_b.reach) {
                return Err(ModelError::Overlap(a, b, -deepest));
            }
        }
        Ok(())
    }

    /// Refuses a block that the model does not have.
    pub(super) fn check_block(&self, block: BlockId) -> Result<(), ModelError> {
        // Particles alone have no block to watch.
        if self.is_empty() {
            return Ok(());
        }
        known("block", block.0, self.len())
    }
    /// Number of blocks.
    pub fn len(&self) -> usize {
        self.mass.len()
    }
    /// Whether there is no block; there may be particles.
    pub fn is_empty(&self) -> bool {
        self.mass.is_empty()
    }
    /// Blocks that are not wholly held.
    pub(super) fn free(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.len()).filter(|&i| self.inverse_mass[i] != [0.0; 3])
    }
    /// What acts on block `i` at a load factor.
    pub(super) fn acting(&self, i: usize, factor: f64) -> Resultant {
        self.permanent[i].plus(&self.variable[i], factor)
    }
    /// Sum of the sizes of all forces that act on free blocks [N/m]: the scale of out-of-balance forces.
    pub(super) fn acting_scale(&self, factor: f64) -> f64 {
        self.free()
            .map(|i| {
                let f = |r: &Resultant| r.force.x.abs() + r.force.y.abs();
                f(&self.permanent[i]) + factor.abs() * f(&self.variable[i])
            })
            .sum::<f64>()
            .max(f64::MIN_POSITIVE)
            + self.particles.weight()
    }
    /// Whether anything is moved by the load factor.
    pub(super) fn moves_supports(&self) -> bool {
        self.movement.iter().any(|m| *m != [0.0; 3])
    }
    /// The farthest that a point of a support is moved at load factor 1 [m].
    pub(super) fn farthest_movement(&self) -> f64 {
        let far = |(m, b): (&[f64; 3], &Body)| m[0].hypot(m[1]) + m[2].abs() * b.reach;
        self.movement.iter().zip(&self.bodies).map(far).fold(0.0, f64::max)
    }
    /// Speed of a fall from half the mean block size [m/s].
    pub(super) fn fall_speed(&self) -> f64 {
        let gravity = self.weight.iter().zip(&self.mass).map(|(w, m)| w.force.norm() / m[0]).fold(0.0, f64::max);
        (gravity * self.block_size).sqrt()
    }
    /// The blocks as particles see them.
    pub(super) fn blocks<'a>(&'a self, poses: &'a [Pose]) -> Blocks<'a> {
        Blocks { cores: self.cores.as_slice(), poses, groups: &self.groups, laws: &self.laws }
    }
    /// Poses as built.
    pub(super) fn poses(&self) -> Vec<Pose> {
        self.built.iter().map(|&c| Pose::at(c)).collect()
    }
    pub(super) fn point_on(&self, block: BlockId, built: Vec2, poses: &[Pose]) -> Vec2 {
        let Some(pose) = poses.get(block.index()) else { return built };
        pose.place(built - self.built[block.index()])
    }
}

/// Overlap that coordinates written with six digits may leave between blocks meant to touch, as a share of the
/// smaller block's reach.
const OVERLAP: f64 = 1e-5;

fn known(what: &'static str, id: u32, count: usize) -> Result<(), ModelError> {
    if (id as usize) < count { Ok(()) } else { Err(ModelError::Unknown { what, id }) }
}

/// Every block and group that is named must be there.
fn check_names(model: &BlockModel, loading: &Loading) -> Result<(), ModelError> {
    model.particles.iter().try_for_each(|p| known("group", p.group.index() as u32, model.laws.groups()))?;
    let forces = loading.permanent.iter().chain(&loading.variable).map(|f| f.block);
    for block in forces.chain(loading.movements.iter().map(|m| m.block)) {
        known("block", block.0, model.blocks.len())?;
    }
    model.blocks.iter().try_for_each(|b| known("group", b.group.index() as u32, model.laws.groups()))
}

/// Widest range of radii: a particle must not have more neighbours than a chunk can name.
const WIDEST_RANGE: f64 = 1e3;

fn check_particles(model: &BlockModel) -> Result<(), ModelError> {
    for (id, p) in model.particles.pairs() {
        for (what, value) in [("radius", p.radius), ("density", p.density)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(ModelError::NotPositive { of: "particle", id: id.0, what, value });
            }
        }
        if !p.centre.is_finite() {
            return Err(ModelError::NotPositive { of: "particle", id: id.0, what: "centre", value: f64::NAN });
        }
    }
    let radii = || model.particles.iter().map(|p| p.radius);
    let range = radii().fold(0.0, f64::max) / radii().fold(f64::INFINITY, f64::min);
    let count = model.particles.len() as f64;
    let mut groups: Vec<GroupId> = model.particles.iter().map(|p| p.group).collect();
    groups.sort_unstable();
    groups.dedup();
    let most = [
        ("the ratio of the largest to the smallest radius", range, WIDEST_RANGE),
        ("their number", count, MOST_PARTICLES as f64),
        ("the number of their groups", groups.len() as f64, MOST_GROUPS as f64),
    ];
    for (what, value, most) in most {
        if value > most {
            return Err(ModelError::TooMany { what, value, most });
        }
    }
    let all = model.blocks.iter().map(|b| b.group).chain(groups.iter().copied());
    for other in all {
        for &group in &groups {
            let law = model.laws.between(group, other);
            if law.tension > 0.0 {
                return Err(ModelError::ParticleLaw("tensile strength"));
            }
            if law.crushing.is_finite() {
                return Err(ModelError::ParticleLaw("compressive strength"));
            }
        }
    }
    Ok(())
}

fn check_law(law: &ContactLaw) -> Result<(), ModelError> {
    let refuse = |what, value: f64, fine: bool| if fine { Ok(()) } else { Err(ModelError::Law { what, value }) };
    let positive = |what, value: f64| refuse(what, value, value > 0.0);
    for (what, stiffness) in [("normal stiffness", law.normal), ("shear stiffness", law.shear)] {
        match stiffness {
            Stiffness::Given(k) => positive(what, if k.is_finite() { k } else { f64::NAN })?,
            Stiffness::Series { joint, body } => {
                positive(what, joint)?;
                // Between rigid bodies only the joint yields, so it has to.
                positive(what, if body.is_finite() || joint.is_finite() { body } else { f64::NAN })?;
            }
        }
    }
    for (what, value) in [("friction", law.friction), ("cohesion", law.cohesion), ("tensile strength", law.tension)] {
        refuse(what, value, value >= 0.0)?;
    }
    positive("crushing strength", law.crushing)?;
    positive("fixed length", law.fixed_length.unwrap_or(1.0))?;
    // A contact point that stands for no length would let blocks through one another.
    positive("least length", law.least_length)
}
