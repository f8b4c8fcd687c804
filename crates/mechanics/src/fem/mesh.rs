//! Nodes, quadrilaterals in zones, and the interfaces between solids.

use crate::ids::{InterfaceId, NodeId, QuadId, Table, ZoneId};
use crate::plane::Vec2;

/// A mesh: nothing but geometry and which zone each part belongs to.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// Where the nodes are before anything moves [m].
    pub nodes: Table<NodeId, Vec2>,
    /// Four-node elements. Those of one zone stand together.
    pub quads: Table<QuadId, Quad>,
    /// Joints and contacts between solids whose nodes are doubled there.
    pub interfaces: Table<InterfaceId, Interface>,
    /// Names of the zones; each has one material.
    pub zones: Table<ZoneId, String>,
    /// Names of the kinds of interface; each has one law. [`Interface::kind`] points into it.
    pub kinds: Vec<String>,
}

/// A quadrilateral.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Quad {
    /// Its corners, counter-clockwise.
    pub nodes: [NodeId; 4],
    /// What it is made of.
    pub zone: ZoneId,
}

/// A joint or a contact: two faces of as many nodes, which coincide where nothing has moved.
///
/// Walking from the first node to the last, side `one` lies on the right and side `two` on the left: the normal, a quarter turn
/// counter-clockwise from the way walked, points from `one` to `two`.
#[derive(Debug, Clone, PartialEq)]
pub struct Interface {
    /// Nodes of one side, in the order along the face.
    pub one: Vec<NodeId>,
    /// The nodes of the other side that face them.
    pub two: Vec<NodeId>,
    /// Which kind it is of.
    pub kind: usize,
    /// How it is integrated.
    pub quadrature: Quadrature,
}

/// How the stress between two faces is summed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quadrature {
    /// A spring between each pair of nodes, all of the same area: the thickness over the number of springs (the railway paper's
    /// equation 1).
    EqualSprings,
    /// A spring between each pair, with the area that belongs to it (nodal, Newton-Cotes).
    Nodal,
    /// Two Gauss points a segment.
    Gauss,
    /// So many strips of equal width a segment, each with a spring in its middle: a joint that opens has its stress over nearly all of
    /// what is closed, and not at nodes alone.
    Strips(u32),
}
