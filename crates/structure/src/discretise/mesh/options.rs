//! How fine a mesh is and how far it reaches.

use super::MOST_NODES;
use bridge::{Bridge, Springs};
use mechanics::fem::Quadrature;

/// How a mesh is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshOptions {
    /// Length of an element near the rings and the surface [m].
    pub size: f64,
    /// Nodes across the depth of each ring.
    pub ring_nodes: usize,
    /// Distance from the back of an abutment to the side boundary [m]; none: twice the height from the lowest foundation to
    /// the surface.
    pub side_distance: Option<f64>,
    /// How mortar joints are integrated.
    pub joints: Quadrature,
    /// A mesh that is expected to have more nodes is refused before it is made.
    pub most_nodes: usize,
}

impl MeshOptions {
    /// What the file of a bridge says, or its defaults.
    pub fn of(bridge: &Bridge) -> MeshOptions {
        let rings = bridge.spans.iter().flat_map(|span| &span.rings);
        let thinnest = rings.map(|r| r.crown_thickness.min(r.springing_thickness)).fold(f64::INFINITY, f64::min);
        let plan = &bridge.service.mesh;
        MeshOptions {
            size: plan.size.unwrap_or(if thinnest.is_finite() { 0.5 * thinnest } else { 0.25 }),
            ring_nodes: plan.ring_nodes.max(2),
            side_distance: plan.side_distance,
            most_nodes: MOST_NODES,
            joints: match bridge.service.mortar.springs {
                Springs::Equal => Quadrature::EqualSprings,
                Springs::Nodal => Quadrature::Nodal,
                Springs::Interface => Quadrature::Gauss,
            },
        }
    }
}
