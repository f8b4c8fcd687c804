//! A mesh as figures and files show it.

use super::Meshed;
use mechanics::ids::Id;
use outcome::mesh::{MeshPicture, Zone};

impl Meshed {
    /// The mesh as figures and files show it.
    pub fn picture(&self) -> MeshPicture {
        let mesh = &self.mesh;
        let zones = mesh.zones.pairs().map(|(zone, name)| Zone {
            name: name.clone(),
            made_of: self.roles[zone].made_of(),
            quads: mesh.quads.iter().filter(|quad| quad.zone == zone).count(),
        });
        let index = |nodes: &[mechanics::ids::NodeId]| nodes.iter().map(|n| n.index()).collect::<Vec<usize>>();
        MeshPicture {
            nodes: mesh.nodes.iter().map(|p| [p.x, p.y]).collect(),
            quads: mesh.quads.iter().map(|quad| quad.nodes.map(|n| n.index())).collect(),
            zone_of: mesh.quads.iter().map(|quad| quad.zone.index()).collect(),
            scaled_jacobian: mesh.quads.ids().map(|quad| super::scaled_jacobian(super::corners(mesh, quad))).collect(),
            zones: zones.collect(),
            interfaces: mesh
                .interfaces
                .iter()
                .map(|i| (index(&i.one), mesh.kinds.get(i.kind).cloned().unwrap_or_default()))
                .collect(),
            surface: self.sets.surface.iter().map(|n| [mesh.nodes[*n].x, mesh.nodes[*n].y]).collect(),
            springings: self.sets.spans.iter().map(|span| span.springings_at.map(|p| [p.x, p.y])).collect(),
            base: index(&self.sets.base),
            remark: self.quality.words(),
        }
    }
}
