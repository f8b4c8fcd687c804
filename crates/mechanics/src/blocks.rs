//! Rigid blocks, the laws of their contacts, and what acts on them: the one model that the discrete element method
//! and limit analysis share.

use crate::ids::{BlockId, GroupId, Id, ParticleId, Table};
use crate::plane::{Core, Meeting, Polygon, PolygonError, Pose, Vec2, meet, overlapping};
use serde::Serialize;
use thiserror::Error;

/// Which motions of a block are prevented.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Held {
    /// No horizontal motion.
    pub x: bool,
    /// No vertical motion.
    pub y: bool,
    /// No rotation.
    pub rotation: bool,
}

impl Held {
    /// Free to move.
    pub const FREE: Held = Held { x: false, y: false, rotation: false };
    /// A support.
    pub const FIXED: Held = Held { x: true, y: true, rotation: true };

    /// Whether no motion is left.
    pub fn is_fixed(self) -> bool {
        self == Held::FIXED
    }
}

/// One rigid block.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// Outline where the block was built [m].
    pub outline: Polygon,
    /// Radius of the rounded corners [m]; contact points lie this far (at a right angle) inside the edges.
    pub rounding: f64,
    /// Mass density [kg/m^3].
    pub density: f64,
    /// The group that decides the laws of its contacts.
    pub group: GroupId,
    /// Prevented motions.
    pub held: Held,
}

impl Block {
    /// Mass per metre of width [kg/m].
    pub fn mass(&self) -> f64 {
        self.density * self.outline.area()
    }
}

/// One circular particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Particle {
    /// Centre where the particle was built [m].
    pub centre: Vec2,
    /// Radius [m].
    pub radius: f64,
    /// Mass density [kg/m^3].
    pub density: f64,
    /// The group that decides the laws of its contacts.
    pub group: GroupId,
}

impl Particle {
    /// Mass per metre of width [kg/m].
    pub fn mass(&self) -> f64 {
        self.density * std::f64::consts::PI * self.radius * self.radius
    }
}

/// A stiffness per unit area [Pa/m] of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum Stiffness {
    /// As given [Pa/m].
    Given(f64),
    /// Joint and bodies in series: `1/k = 1/joint + l/body`, with `l` the distance between the two centres of mass
    /// along the contact's normal. Rouxinol, Providência and Lemos, equation (1).
    Series {
        /// Stiffness of the joint alone [Pa/m]; infinite for a dry joint.
        joint: f64,
        /// Modulus of the bodies [Pa].
        body: f64,
    },
}

impl Stiffness {
    /// The value [Pa/m] for centres of mass `distance` [m] apart along the normal.
    pub fn at(self, distance: f64) -> f64 {
        match self {
            Stiffness::Given(k) => k,
            Stiffness::Series { joint, body } => 1.0 / (1.0 / joint + distance / body),
        }
    }
}

/// How a contact between two groups resists.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ContactLaw {
    /// Normal stiffness per unit area [Pa/m].
    pub normal: Stiffness,
    /// Shear stiffness per unit area [Pa/m].
    pub shear: Stiffness,
    /// Coefficient of friction, tan(phi).
    pub friction: f64,
    /// Cohesion [Pa]; acts while the contact is closed.
    pub cohesion: f64,
    /// Tensile strength [Pa].
    pub tension: f64,
    /// Compressive strength at which the contact crushes [Pa]; infinite for none.
    pub crushing: f64,
    /// Length that a contact point stands for in the force formulation [m]; half the distance between the two
    /// points of a joint where it is not given.
    pub fixed_length: Option<f64>,
    /// Least length of a contact point in the stress formulation [m].
    pub least_length: f64,
}

/// The laws of all pairs of groups.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LawTable {
    groups: usize,
    laws: Vec<ContactLaw>,
}

impl LawTable {
    /// The same law between all of `groups` groups.
    pub fn uniform(groups: usize, law: ContactLaw) -> LawTable {
        LawTable { groups, laws: vec![law; groups * groups] }
    }
    /// How many groups the table knows.
    pub fn groups(&self) -> usize {
        self.groups
    }
    /// Sets the law between two groups, in both orders.
    pub fn set(&mut self, a: GroupId, b: GroupId, law: ContactLaw) {
        self.laws[a.index() * self.groups + b.index()] = law;
        self.laws[b.index() * self.groups + a.index()] = law;
    }
    /// The law between two groups.
    pub fn between(&self, a: GroupId, b: GroupId) -> &ContactLaw {
        &self.laws[a.index() * self.groups + b.index()]
    }
    /// Every law, to be changed alike (a stiffness multiple, a friction angle).
    pub fn iter_mut(&mut self) -> std::slice::IterMut<'_, ContactLaw> {
        self.laws.iter_mut()
    }
}

/// A force that acts on a point of a block and moves along with it; its direction stays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointForce {
    /// The block.
    pub block: BlockId,
    /// Where the force acts, on the block as built [m].
    pub at: Vec2,
    /// Force per metre of width [N/m].
    pub force: Vec2,
}

/// A motion imposed on a held block, per unit of the load factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Movement {
    /// The block.
    pub block: BlockId,
    /// Translation [m].
    pub translation: Vec2,
    /// Rotation about the block's centroid [rad].
    pub rotation: f64,
}

/// A force that answers movement: between `least` and `most`, and at `most` only where its point moves against it. Limit
/// analysis alone knows it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Restraint {
    /// The block.
    pub block: BlockId,
    /// Where the force acts, on the block as built [m].
    pub at: Vec2,
    /// Direction of the force on the block; a unit vector.
    pub direction: Vec2,
    /// Force that is there whatever moves [N/m].
    pub least: f64,
    /// Force against a movement [N/m].
    pub most: f64,
    /// Movement against it at which half of what lies between the two is there [m]. Where movement itself is not known, as in
    /// limit analysis, all of it is there at once.
    pub half_movement: f64,
    /// Another block and the point on it that bears the opposite force; none where something outside of the model does.
    pub against: Option<(BlockId, Vec2)>,
}

/// What acts on the blocks besides gravity.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Loading {
    /// Forces that are there from the first stage on.
    pub permanent: Vec<PointForce>,
    /// Forces that are multiplied by the load factor.
    pub variable: Vec<PointForce>,
    /// Support movements that are multiplied by the load factor.
    pub movements: Vec<Movement>,
    /// Forces that answer movement.
    pub restraints: Vec<Restraint>,
}

/// Rigid blocks and particles, the laws of their contacts and gravity. Fixed once built.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockModel {
    /// The blocks.
    pub blocks: Table<BlockId, Block>,
    /// The particles; limit analysis knows none.
    pub particles: Table<ParticleId, Particle>,
    /// Names of the groups.
    pub groups: Table<GroupId, String>,
    /// The laws between groups.
    pub laws: LawTable,
    /// Acceleration of gravity [m/s^2], usually (0, -9.81).
    pub gravity: Vec2,
}

/// Why a model cannot be analysed.
#[derive(Debug, Clone, PartialEq, Error)]
#[expect(missing_docs, reason = "the messages say what each is")]
pub enum ModelError {
    #[error("block {block}: {source}")]
    Outline { block: u32, source: PolygonError },
    #[error("{of} {id}: {what} must be positive and finite, it is {value}")]
    NotPositive {
        /// A block or a particle.
        of: &'static str,
        id: u32,
        /// Which number.
        what: &'static str,
        value: f64,
    },
    #[error("particles: {what} is {value}, at most {most} can be modelled")]
    TooMany {
        what: &'static str,
        /// How many.
        value: f64,
        most: f64,
    },
    #[error("limit analysis knows blocks only, and this model has {0} particles: use discrete elements for it")]
    ParticlesInLimitAnalysis(usize),
    #[error("contacts of particles have no {0}")]
    ParticleLaw(&'static str),
    #[error("every block is held: there is nothing to analyse")]
    NothingFree,
    #[error("the kept state does not belong to this model, or is damaged")]
    ForeignState,
    #[error("contact law: {what} cannot be {value}")]
    Law {
        /// Which number.
        what: &'static str,
        value: f64,
    },
    #[error("block {0} is to be moved in a direction in which it is not held")]
    MovedWhileFree(u32),
    #[error("there is no {what} {id} in this model")]
    Unknown {
        /// What is named: a block or a group.
        what: &'static str,
        /// The id it is named by.
        id: u32,
    },
    #[error("blocks {0} and {1} overlap by {2:.6} m where they are built")]
    Overlap(u32, u32, f64),
}

impl BlockModel {
    /// The rounded outline of each block, relative to its centre of mass.
    ///
    /// # Errors
    /// A block whose rounding leaves nothing of an edge.
    pub fn cores(&self) -> Result<Table<BlockId, Core>, ModelError> {
        self.rounded(|block| block.rounding)
    }
    fn rounded(&self, by: impl Fn(&Block) -> f64) -> Result<Table<BlockId, Core>, ModelError> {
        let core = |(id, block): (BlockId, &Block)| {
            Core::new(&block.outline, by(block)).map_err(|source| ModelError::Outline { block: id.0, source })
        };
        self.blocks.pairs().map(core).collect()
    }
    /// Where each block's centre of mass is built [m].
    pub fn centroids(&self) -> Table<BlockId, Vec2> {
        self.blocks.iter().map(|b| b.outline.centroid()).collect()
    }
    /// The same of blocks that have not turned.
    pub fn poses(&self) -> Table<BlockId, Pose> {
        self.centroids().iter().map(|&at| Pose::at(at)).collect()
    }
    /// Motions of the blocks, velocity and spin, with the fastest point moved by 1 m; none where nothing moves.
    pub(crate) fn to_one_metre(&self, motions: &Table<BlockId, (Vec2, f64)>) -> Option<Table<BlockId, (Vec2, f64)>> {
        let speed = |(block, &(v, w)): (&Block, &(Vec2, f64))| {
            let centre = block.outline.centroid();
            block.outline.vertices().iter().map(|&p| (v + (p - centre).left() * w).norm()).fold(0.0, f64::max)
        };
        let fastest = self.blocks.iter().zip(motions.iter()).map(speed).fold(0.0, f64::max);
        (fastest > 0.0).then(|| motions.iter().map(|&(v, w)| (v * (1.0 / fastest), w / fastest)).collect())
    }

    /// Weight of the free blocks [N/m], positive.
    pub fn free_weight(&self) -> f64 {
        self.blocks.iter().filter(|b| !b.held.y).map(|b| b.mass() * self.gravity.norm()).sum()
    }
}

/// A joint of the model as built: two blocks that touch along a face, or at one point of a face.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Interface {
    /// The block on one side.
    pub first: BlockId,
    /// The block on the other side.
    pub second: BlockId,
    /// Unit normal from the first to the second block.
    pub normal: Vec2,
    /// The contact points [m], ordered along `normal.left()`; inset from the edges by the rounding.
    pub points: Vec<Vec2>,
    /// Ends of the common face without rounding [m], in the same order; equal to `points` for sharp corners.
    pub face: Vec<Vec2>,
}

/// Every pair of blocks that touch where they are built, in the order of their ids. Blocks count as touching when
/// their gap is at most `tolerance` [m]; pairs of held blocks are left out.
///
/// Two corners that only touch are no joint where a face of one of them ends at that point. What a corner prevents of another is one of two things, to pass under the
/// bed or to pass through the side, and it may always give way along the other: no single normal says so, and the
/// diagonal one would hold both. Leaving the pair out never adds strength. A common face no longer than `tolerance` is
/// such a pair as well, for where a face ends is known no better than whether it touches. Blocks that meet nowhere but in their corners
/// are pinned there: the point stays their joint.
///
/// # Errors
/// A block whose rounding leaves nothing of an edge.
pub fn interfaces(model: &BlockModel, tolerance: f64) -> Result<Vec<Interface>, ModelError> {
    let rounded = model.cores()?;
    let sharp = model.rounded(|_| 0.0)?;
    let poses = model.poses();
    let (mut found, mut pins) = (Vec::new(), Vec::new());
    let boxes: Vec<_> = model.blocks.iter().map(|b| b.outline.bounds()).collect();
    for (a, b) in overlapping(&boxes, tolerance) {
        let (a, b) = (BlockId::new(a), BlockId::new(b));
        if model.blocks[a].held.is_fixed() && model.blocks[b].held.is_fixed() {
            continue;
        }
        let points = |cores: &Table<BlockId, Core>| {
            let (ca, cb) = (&cores[a], &cores[b]);
            let meeting = meet(ca, &poses[a], cb, &poses[b], None);
            let m = meeting.manifold(ca, &poses[a], cb, &poses[b]);
            let face = matches!(meeting, Meeting::Face { .. }) && (m.points[1] - m.points[0]).norm() > tolerance;
            let touching = (0..m.count).filter(|&k| m.gaps[k] <= tolerance);
            (m.normal, face, touching.map(|k| m.points[k]).collect::<Vec<Vec2>>())
        };
        let (normal, is_face, contact) = points(&rounded);
        let (_, sharp_is_face, face) = points(&sharp);
        match (is_face && sharp_is_face, &contact[..]) {
            (_, []) => {}
            (true, _) if face.len() == contact.len() => {
                found.push(Interface { first: a, second: b, normal, points: contact, face });
            }
            (false, &[at, ..]) if !is_face => {
                pins.push(Interface { first: a, second: b, normal, points: vec![at], face: vec![at] });
            }
            _ => {}
        }
    }
    let ends_here = |pin: &Interface, joint: &Interface| {
        let blocks = [pin.first, pin.second];
        let shared = blocks.contains(&joint.first) || blocks.contains(&joint.second);
        shared && joint.face.iter().any(|end| (*end - pin.points[0]).norm() <= 4.0 * tolerance)
    };
    pins.retain(|pin| !found.iter().any(|joint| ends_here(pin, joint)));
    found.extend(pins);
    found.sort_by_key(|joint| (joint.first, joint.second));
    Ok(found)
}
