//! Nodes by what they are on a bridge.

use bridge::{Backing, Bridge, Masonry, Soil};
use mechanics::ids::{InterfaceId, NodeId};
use mechanics::plane::Vec2;
use outcome::mesh::MadeOf;

use super::arch::End;

/// What a zone is, in the order of the zones. Spans and piers count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Role {
    /// The voussoirs of a span.
    Voussoirs(usize),
    /// A pier.
    Pier(usize),
    /// An abutment.
    Abutment(End),
    /// Fill over the rings.
    Fill,
    /// Fill of the haunches.
    HaunchFill,
    /// Backing of the haunches.
    Backing,
    /// Fill behind an abutment.
    AbutmentFill(End),
}

impl Role {
    /// What it is made of, in a word that spans and piers share.
    pub fn made_of(self) -> MadeOf {
        match self {
            Role::Voussoirs(_) => MadeOf::Voussoirs,
            Role::Pier(_) => MadeOf::Pier,
            Role::Abutment(_) => MadeOf::Abutment,
            Role::Fill => MadeOf::Fill,
            Role::HaunchFill => MadeOf::HaunchFill,
            Role::Backing => MadeOf::Backing,
            Role::AbutmentFill(_) => MadeOf::AbutmentFill,
        }
    }
    /// Its name.
    pub fn name(self) -> String {
        match self {
            Role::Voussoirs(span) => format!("voussoirs span {}", span + 1),
            Role::Pier(pier) => format!("pier {}", pier + 1),
            Role::Abutment(End::Left) => "abutment left".into(),
            Role::Abutment(End::Right) => "abutment right".into(),
            Role::Fill => "fill".into(),
            Role::HaunchFill => "haunch fill".into(),
            Role::Backing => "backing".into(),
            Role::AbutmentFill(End::Left) => "abutment fill left".into(),
            Role::AbutmentFill(End::Right) => "abutment fill right".into(),
        }
    }

    /// What it is made of in a bridge.
    pub fn substance(self, bridge: &Bridge) -> Substance<'_> {
        let service = &bridge.service;
        let fill = Substance::Soil(&service.fill);
        match self {
            Role::Voussoirs(_) | Role::Pier(_) | Role::Abutment(_) => Substance::Masonry(&bridge.masonry),
            Role::Fill => fill,
            Role::HaunchFill => service.haunch_fill.as_ref().map_or(fill, |haunch| Substance::Soil(&haunch.soil)),
            Role::Backing => bridge.cover.backing.as_ref().map_or(fill, Substance::Backing),
            Role::AbutmentFill(_) => Substance::Soil(&service.abutment_fill.soil),
        }
    }
}

/// What a zone is made of, as the file describes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Substance<'a> {
    /// Masonry of rings, piers and abutments.
    Masonry(&'a Masonry),
    /// Solid backing.
    Backing(&'a Backing),
    /// Fill.
    Soil(&'a Soil),
}

/// What an interface is: its place among the kinds of the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Seam {
    /// A joint of a ring, from intrados to extrados: side `one` is to the right of it, side `two` to the left.
    Joint,
    /// Between two rings, from left to right: side `one` is the lower ring.
    Rings,
    /// Between masonry, side `one`, and fill, side `two`.
    Contact,
}

impl Seam {
    /// Names of the kinds of interface, in the same order.
    pub(super) const KINDS: [&str; 3] = ["mortar joint", "ring joint", "fill contact"];
}

/// A voussoir.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Voussoir {
    /// Its nodes, station by station from the left, each from the intrados to the extrados.
    pub nodes: Vec<NodeId>,
    /// How many of them stand at one station.
    pub across: usize,
}

impl Voussoir {
    /// Nodes on its intrados, from left to right.
    pub fn intrados(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.nodes.iter().copied().step_by(self.across.max(1))
    }
    /// Nodes on its extrados, from left to right.
    pub fn extrados(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.nodes.iter().copied().skip(self.across.saturating_sub(1)).step_by(self.across.max(1))
    }
}

/// Nodes and joints of a span.
#[derive(Debug, Clone, PartialEq)]
pub struct SpanSets {
    /// Voussoirs of each ring, from the left.
    pub voussoirs: Vec<Vec<Voussoir>>,
    /// Joints of each ring, from the left springing to the right one.
    pub joints: Vec<Vec<InterfaceId>>,
    /// Its left and right springing at the intrados [m].
    pub springings_at: [Vec2; 2],
}

/// Nodes that supports, loads, sensors and figures look for.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct NodeSets {
    /// On the fixed base.
    pub base: Vec<NodeId>,
    /// On the left side boundary, from the base up; the lowest is on the base too.
    pub left: Vec<NodeId>,
    /// On the right side boundary, in the same way.
    pub right: Vec<NodeId>,
    /// On the surface, from left to right.
    pub surface: Vec<NodeId>,
    /// Of each span.
    pub spans: Vec<SpanSets>,
}

impl NodeSets {
    /// Displacements that the supports hold: both on the base, the horizontal one on the sides.
    pub fn held(&self) -> usize {
        let sides = [&self.left, &self.right];
        let alone = sides.iter().flat_map(|side| side.iter()).filter(|n| !self.base.contains(n)).count();
        2 * self.base.len() + alone
    }
}
