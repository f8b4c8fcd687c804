//! A mesh as figures and files show it.

use super::Meshed;
use crate::outcome::Point;
use mechanics::ids::Id;

/// A mesh as figures and files show it.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshPicture {
    /// Nodes [m].
    pub points: Vec<Point>,
    /// Corners of the elements, counter-clockwise.
    pub quads: Vec<[usize; 4]>,
    /// Zone of each element.
    pub zone_of: Vec<usize>,
    /// Scaled Jacobian of each element.
    pub scaled_jacobian: Vec<f64>,
    /// The zones.
    pub zones: Vec<ZonePicture>,
    /// Joints and contacts: the nodes of side `one`, and the name of their kind.
    pub interfaces: Vec<(Vec<usize>, String)>,
    /// The surface, from left to right.
    pub surface: Vec<usize>,
    /// Nodes on the fixed base.
    pub base: Vec<usize>,
    /// What the mesh counts, in a line.
    pub remark: String,
}

/// A zone of a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct ZonePicture {
    /// Its name.
    pub name: String,
    /// What it is made of, the same for all spans and piers: "voussoirs", "pier", "abutment", "fill", "haunch fill", "backing",
    /// "abutment fill".
    pub made_of: &'static str,
    /// How many elements it has.
    pub quads: usize,
}

impl Meshed {
    /// The mesh as figures and files show it.
    pub fn picture(&self) -> MeshPicture {
        let mesh = &self.mesh;
        let zones = mesh.zones.pairs().map(|(zone, name)| ZonePicture {
            name: name.clone(),
            made_of: self.roles[zone].made_of(),
            quads: mesh.quads.iter().filter(|quad| quad.zone == zone).count(),
        });
        let index = |nodes: &[mechanics::ids::NodeId]| nodes.iter().map(|n| n.index()).collect::<Vec<usize>>();
        MeshPicture {
            points: mesh.nodes.iter().map(|p| [p.x, p.y]).collect(),
            quads: mesh.quads.iter().map(|quad| quad.nodes.map(|n| n.index())).collect(),
            zone_of: mesh.quads.iter().map(|quad| quad.zone.index()).collect(),
            scaled_jacobian: mesh.quads.ids().map(|quad| super::scaled_jacobian(super::corners(mesh, quad))).collect(),
            zones: zones.collect(),
            interfaces: mesh
                .interfaces
                .iter()
                .map(|i| (index(&i.one), mesh.kinds.get(i.kind).cloned().unwrap_or_default()))
                .collect(),
            surface: index(&self.sets.surface),
            base: index(&self.sets.base),
            remark: self.quality.words(),
        }
    }
}
