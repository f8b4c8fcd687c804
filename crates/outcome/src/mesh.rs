//! A finite element mesh, as figures and files show it.

use crate::picture::Point;
use crate::words::words;
use serde::{Deserialize, Serialize};

/// A mesh as built.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct MeshPicture {
    /// Nodes [m].
    pub nodes: Vec<Point>,
    /// Corners of every quadrilateral, counter-clockwise.
    pub quads: Vec<[usize; 4]>,
    /// Zone of every quadrilateral.
    pub zone_of: Vec<usize>,
    /// Scaled Jacobian of every quadrilateral.
    pub scaled_jacobian: Vec<f64>,
    /// The zones.
    pub zones: Vec<Zone>,
    /// Joints and contacts: the nodes of one side, and the name of their kind.
    pub interfaces: Vec<(Vec<usize>, String)>,
    /// Top of the fill, from left to right [m].
    pub surface: Vec<Point>,
    /// Left and right springing of each span, at the intrados [m].
    pub springings: Vec<[Point; 2]>,
    /// Nodes on the fixed base.
    pub base: Vec<usize>,
    /// What the mesh counts, in a line.
    pub remark: String,
}

/// A zone of a mesh.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Zone {
    /// Its name.
    pub name: String,
    /// What it is made of, the same for all spans and piers.
    pub made_of: MadeOf,
    /// How many elements it has.
    pub quads: usize,
}

words! {
    /// What zones are made of.
    pub enum MadeOf {
        /// The ring.
        Voussoirs = "voussoirs",
        /// A pier.
        Pier = "pier",
        /// An abutment.
        Abutment = "abutment",
        /// Fill above the ring.
        Fill = "fill",
        /// Fill over the haunches.
        HaunchFill = "haunch fill",
        /// Solid backing.
        Backing = "backing",
        /// Fill behind an abutment.
        AbutmentFill = "abutment fill",
    }
}
