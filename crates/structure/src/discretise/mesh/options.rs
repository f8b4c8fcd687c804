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
    /// What the distance to the boundary is multiplied by.
    pub farther: f64,
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
            farther: 1.0,
            most_nodes: MOST_NODES,
            joints: match bridge.service.mortar.springs {
                Springs::Equal => Quadrature::EqualSprings,
                Springs::Nodal => Quadrature::Nodal,
                Springs::Interface => Quadrature::Gauss,
            },
        }
    }

    /// The same with the side boundary twice as far away: answers that hang on the boundary change.
    pub fn with_doubled_boundary(mut self) -> MeshOptions {
        self.farther *= 2.0;
        self
    }

    /// The same with elements of half the size: answers that hang on the mesh change. Nodes across the ring stay.
    pub fn with_halved_size(mut self) -> MeshOptions {
        self.size *= 0.5;
        self
    }
}
