//! Results as an engineer reads them: in metres, newtons and pascals, on the bridge as drawn. Figures, tables and the
//! wire format are made from these values alone.

use crate::wire::published;
use crate::words::words;
use serde::{Deserialize, Serialize};

/// A point or vector [m] unless said otherwise.
pub type Point = [f64; 2];

/// A block as it was built.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Shape {
    /// Outline, counter-clockwise [m].
    pub outline: Vec<Point>,
    /// What it is: "voussoir", "abutment", "pier", "backing", "wall", "block".
    pub role: String,
    /// Whether it is a support.
    pub held: bool,
}

/// A particle as it was packed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Disc {
    /// Centre [m].
    pub centre: Point,
    /// Radius [m].
    pub radius: f64,
    /// The layer it belongs to, counted from 0 from the extrados up.
    pub layer: usize,
}

/// A particle at one load.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct DiscState {
    /// Centre [m].
    pub centre: Point,
    /// Angle turned since it was packed [rad].
    pub angle: f64,
    /// Velocity of its centre [m/s].
    pub velocity: Point,
    /// Average stress [Pa], tension positive: xx, yy, xy.
    pub stress: [f64; 3],
}

/// What a particle touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Partner {
    /// Index into the shapes.
    Shape(usize),
    /// Index into the particles.
    Particle(usize),
}

/// A force on a particle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ParticleForce {
    /// Index into the particles.
    pub particle: usize,
    /// What exerts it.
    pub partner: Partner,
    /// Where [m].
    pub point: Point,
    /// Unit normal from the partner to the particle.
    pub normal: Point,
    /// Compression [N/m], positive.
    pub compression: f64,
    /// Shear [N/m], positive when the force on the particle acts along the normal turned left.
    pub shear: f64,
    /// Compressive stress [Pa].
    pub stress: f64,
    /// Whether it slides.
    pub sliding: bool,
}

/// How a block has moved: translation of its centroid [m] and rotation [rad].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Motion {
    /// Translation [m].
    pub translation: Point,
    /// Rotation about the centroid [rad].
    pub rotation: f64,
}

words! {
    /// Where a hinge opens.
    pub enum HingeAt {
        /// The joint turns about its intrados edge.
        Intrados = "intrados",
        /// The joint turns about its extrados edge.
        Extrados = "extrados",
        /// Neither: a pier course, a wall.
        Other = "other",
    }
}

published! {
    /// A hinge of the mechanism, between two blocks with names.
    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    pub struct Hinge |hinge, sides: Option<[&str; 2]>| {
        = x: f64 [m] = hinge.point[0],
        = y: f64 [m] = hinge.point[1],
        /// Where, on the bridge as built [m].
        pub point: Point [kept],
        /// At which edge.
        pub edge: HingeAt,
        /// The two sides of its joint.
        = between: Vec<String> = sides.map_or_else(Vec::new, Vec::from),
        /// The same as indices into the shapes.
        pub between: [usize; 2] [kept],
        /// Relative rotation of the two sides [rad, or per unit of the mechanism].
        pub rotation: f64,
    }
}

/// A force between two blocks.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ContactForce {
    /// Indices into the shapes.
    pub blocks: [usize; 2],
    /// Where [m].
    pub point: Point,
    /// Unit normal from the first to the second block.
    pub normal: Point,
    /// Compression [N/m], positive.
    pub compression: f64,
    /// Shear [N/m].
    pub shear: f64,
    /// Compressive stress [Pa].
    pub stress: f64,
    /// Whether it slides.
    pub sliding: bool,
}

/// The bridge at one load.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Snapshot {
    /// Load [N/m].
    pub load: f64,
    /// Motion of each shape.
    pub motions: Vec<Motion>,
    /// Velocity of each block's centroid [m/s].
    pub velocities: Vec<Point>,
    /// Closed contacts.
    pub contacts: Vec<ContactForce>,
    /// Average stress of each block [Pa], tension positive: xx, yy, xy; empty where it is not known.
    pub stresses: Vec<[f64; 3]>,
    /// The particles.
    pub particles: Vec<DiscState>,
    /// Forces on the particles that touch something.
    pub particle_forces: Vec<ParticleForce>,
}

published! {
    /// A point of the line of thrust.
    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    pub struct ThrustPoint |at| {
        = x: f64 [m] = at.point[0],
        = y: f64 [m] = at.point[1],
        /// Where the resultant crosses a joint [m].
        pub point: Point [kept],
        /// Size of the resultant [N/m].
        pub thrust: f64 [kN/m],
    }

    /// One load step; of supports that move, or of loads.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Step |step, moves: bool| {
        /// The load.
        = load?: Option<f64> [kN/m] = (!moves).then_some(step.load),
        /// The support movement.
        = movement?: Option<f64> [m] = moves.then_some(step.load),
        /// Load [N/m] (support movement: [m]).
        pub load: f64 [kept],
        /// Displacement of the watched point, in all and along both axes.
        = displacement: f64 [mm] = step.displacement[0].hypot(step.displacement[1]),
        = displacement_x: f64 [mm] = step.displacement[0],
        = displacement_y: f64 [mm] = step.displacement[1],
        /// Displacement of the watched point [m].
        pub displacement: Point [kept],
        /// Iterations.
        pub iterations: u64,
        /// Out-of-balance force over acting forces.
        pub unbalanced_ratio: f64,
        /// Whether it came to rest.
        pub at_rest: bool,
    }
}

/// A load as drawn: a trapezoid of pressure on the extrados, or an arrow.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LoadArrow {
    /// Where it acts on the blocks [m].
    pub at: Point,
    /// Force [N/m] at the reference load, x right, y up.
    pub force: Point,
}

/// A layer of the cover, or backing, as drawn behind the ring.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Band {
    /// What it is: "fill", "surfacing", "backing".
    pub name: String,
    /// Its size in words: thickness above the crown, or the level of its upper face.
    pub size: String,
    /// Outlines, one for each connected part, counter-clockwise [m].
    pub outlines: Vec<Vec<Point>>,
}

/// A defect of a ring as drawn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DefectMark {
    /// What it is and where, in words.
    pub words: String,
    /// Along the face or the joint that has it, from left to right [m].
    pub line: Vec<Point>,
}

/// What a dimension measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Measure {
    /// Horizontal distance between two springings at the intrados.
    Span,
    /// Height of the crown's intrados above the springings: from a springing to the crown.
    Rise,
    /// Thickness of the ring, all rings together: from intrados to extrados along a joint.
    Thickness,
    /// Height of a pier or a wall: from its foot to its head.
    Height,
    /// Width of a pier: from its left face to its right one.
    Width,
    /// Depth of the cover: from the crown's extrados to the road surface.
    Depth,
}

/// A dimension to be drawn on the bridge as built.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct DimensionLine {
    /// What it measures.
    pub measure: Measure,
    /// From [m].
    pub from: Point,
    /// To [m].
    pub to: Point,
}

/// Everything that figures and files of a collapse analysis are made from.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Picture {
    /// Title: bridge and analysis.
    pub title: String,
    /// Blocks as built.
    pub shapes: Vec<Shape>,
    /// Particles as packed.
    pub particles: Vec<Disc>,
    /// What the layers of particles are, from the extrados up, as the file names them.
    pub layers: Vec<String>,
    /// Outline of the region that particles fill, counter-clockwise [m]; empty where there is none.
    pub fill: Vec<Point>,
    /// Layers of the cover that are weight alone, and backing, from the extrados up.
    pub bands: Vec<Band>,
    /// Defects of the rings, in the order of the file.
    pub defects: Vec<DefectMark>,
    /// What the loads of the drawing are, where they are one case of many: vehicle, factor, place, direction.
    pub case: Option<String>,
    /// Outline of the road surface, where there is a cover [m].
    pub surface: Vec<Point>,
    /// Upper edge of the spandrel walls, where the file describes some [m].
    pub wall_top: Vec<Point>,
    /// What stands at the edges of the road and on it.
    pub edges: crate::ground::Edges,
    /// Where loads touch the surface: middle and length [m].
    pub surface_loads: Vec<(Point, f64)>,
    /// Forces on the blocks from the variable loads.
    pub loads: Vec<LoadArrow>,
    /// Mechanism: motion of each shape, scaled so that the largest translation is 1 m.
    pub mechanism: Option<Vec<Motion>>,
    /// Hinges of the mechanism.
    pub hinges: Vec<Hinge>,
    /// Points of joints that slide [m].
    pub sliding: Vec<Point>,
    /// Line of thrust, one polyline per span.
    pub thrust_lines: Vec<Vec<ThrustPoint>>,
    /// Load path.
    pub path: Vec<Step>,
    /// The bridge at rest under each load, and on its way down.
    pub snapshots: Vec<Snapshot>,
    /// Index of the last stable snapshot.
    pub last_stable: Option<usize>,
    /// Soil that yields as a continuum, where fill is one.
    pub soil: Option<crate::soil::SoilPicture>,
    /// Dimensions of the drawing; none for models without an arch.
    pub dimensions: Vec<DimensionLine>,
    /// Load at collapse [N/m], where one was found (support movement: [m]).
    pub collapse_load: Option<f64>,
    /// Whether the run stalled: its last step neither came to rest nor collapsed.
    pub stalls: bool,
    /// Whether the loads of path and snapshots are support movements [m] instead of forces [N/m].
    pub moves_supports: bool,
    /// What joints of other stiffness would carry.
    pub over_stiffness: Option<OverStiffness>,
}

/// Largest load in balance over the stiffness of the joints.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct OverStiffness {
    /// Stiffness as a multiple of that of the result, and load [N/m]; the softer first.
    pub points: Vec<[f64; 2]>,
    /// Load of rigid blocks [N/m], which the stiffest joints approach from below.
    pub rigid: f64,
}
