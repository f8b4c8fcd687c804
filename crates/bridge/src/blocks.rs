//! What a block model file means, in SI units: blocks and particles listed one by one or drawn in a DXF file, their
//! materials and joints, the loads on them, and what to analyse. Plain data, nothing computed.

use crate::choice::choice;
use crate::diagnostic::TextRange;
use crate::model::{Joint, Masonry, Plan};

/// A block model as its file describes it.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockFile {
    /// Name for titles.
    pub name: String,
    /// Width over which forces given for the whole of it are spread [m].
    pub width: f64,
    /// Acceleration of gravity [m/s^2].
    pub gravity: f64,
    /// The drawing, where there is one.
    pub drawing: Option<DrawingPart>,
    /// Materials, in the order of the file.
    pub materials: Vec<Material>,
    /// Joints by pairs of materials, in the order of the file.
    pub joints: Vec<MaterialJoint>,
    /// Blocks listed in the file.
    pub blocks: Vec<ListedBlock>,
    /// Particles listed in the file.
    pub particles: Vec<ListedParticles>,
    /// Loads, in the order of the file.
    pub loads: Vec<BodyLoad>,
    /// What to analyse, and how exactly.
    pub plan: Plan,
}

/// The drawing of a block model.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawingPart {
    /// Path of the DXF file, relative to the block model file.
    pub file: String,
    /// Where the path stands in the file.
    pub range: TextRange,
    /// Metres in one unit of the drawing, where the file says so.
    pub unit: Option<f64>,
    /// How far a chord may lie from its curve [m].
    pub chord_tolerance: f64,
    /// How far apart ends may lie that are meant to meet [m].
    pub gap_tolerance: f64,
    /// Whether concave outlines are cut into convex pieces.
    pub cut_concave: bool,
    /// What is on its layers.
    pub layers: Vec<MappedLayer>,
}

choice! {
    /// What stands for a body.
    pub enum Role {
        /// closed outlines are free blocks
        Block = "block",
        /// closed outlines are blocks that do not move
        Support = "support",
        /// circles are particles
        Particles = "particles",
        /// the layer is not read
        Ignore = "ignore",
    }
}

/// A layer of the drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct MappedLayer {
    /// Its name.
    pub name: String,
    /// Where the name stands in the file.
    pub range: TextRange,
    /// What is on it.
    pub role: Role,
    /// Index of its material; none for layers that are ignored.
    pub material: Option<usize>,
}

/// A material of bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// Its name.
    pub name: String,
    /// Density, moduli, strength and rounding.
    pub masonry: Masonry,
}

/// A joint between two materials.
#[derive(Debug, Clone, PartialEq)]
pub struct MaterialJoint {
    /// Where it stands in the file.
    pub range: TextRange,
    /// Indices of the two materials; none for all pairs that no other joint names.
    pub between: Option<[usize; 2]>,
    /// Stiffness and strength.
    pub joint: Joint,
}

/// A block listed in the file.
#[derive(Debug, Clone, PartialEq)]
pub struct ListedBlock {
    /// Its name, where it has one.
    pub name: Option<String>,
    /// The layer that it is drawn on.
    pub layer: String,
    /// Where it stands in the file.
    pub range: TextRange,
    /// Index of its material.
    pub material: usize,
    /// Whether it is a support.
    pub held: bool,
    /// Corners [m].
    pub outline: Vec<[f64; 2]>,
}

/// Particles of one layer, listed in the file.
#[derive(Debug, Clone, PartialEq)]
pub struct ListedParticles {
    /// The layer that they are drawn on.
    pub layer: String,
    /// Where they stand in the file.
    pub range: TextRange,
    /// Index of their material.
    pub material: usize,
    /// Centre and radius of each [m].
    pub circles: Vec<[f64; 3]>,
}

/// Which bodies a load acts on.
#[derive(Debug, Clone, PartialEq)]
pub enum Target {
    /// The block at a point, which the force acts on [m].
    Point([f64; 2]),
    /// The centroid of a block, by its name.
    Block(String),
    /// Every free block of a layer, in proportion to its mass.
    Layer(String),
}

/// A load on bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyLoad {
    /// Its name.
    pub name: String,
    /// Where it stands in the file.
    pub range: TextRange,
    /// What it acts on.
    pub target: Target,
    /// Force per metre of width [N/m], x to the right, y up.
    pub force: [f64; 2],
    /// Whether it is there from the start, and does not grow.
    pub permanent: bool,
}
