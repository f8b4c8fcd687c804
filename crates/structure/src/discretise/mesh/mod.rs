//! From a bridge to a mesh of quadrilaterals: voussoirs, piers and abutments, the fill on them and behind them.
//!
//! A ring is a strip of voussoirs, each a solid of its own; facing nodes of two neighbours make a joint. Fill stands in columns
//! over the extrados up to the surface. Where an extrados is steep, and below the levels of haunch fill and backing, it lies in
//! level rows between two extrados, or between an extrados and the line over an abutment's back. Every region has four sides
//! and is meshed by transfinite interpolation; fill has its own nodes where it touches masonry.
//!
//! Piers, abutments and the fill behind these stand on a fixed base at the level of their foundation; the side boundaries
//! hold the fill horizontally.

mod arch;
mod build;
mod layout;
mod options;
mod patch;
mod picture;
mod quality;
mod saddle;
mod sets;
mod stations;
mod supports;

pub use arch::End;
pub use build::mesh_with;
pub use options::MeshOptions;
pub use quality::{Quality, corners, quality, scaled_jacobian};
pub use sets::{NodeSets, Role, SpanSets, Substance, Voussoir};

use bridge::Bridge;
use bridge::ring::Misfit;
use mechanics::fem::Mesh;
use mechanics::ids::{Table, ZoneId};
use thiserror::Error;

/// A bridge as a mesh, with the way back to the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Meshed {
    /// Nodes, elements, joints and contacts.
    pub mesh: Mesh,
    /// What each zone is.
    pub roles: Table<ZoneId, Role>,
    /// Nodes that supports, loads, sensors and figures look for.
    pub sets: NodeSets,
    /// How it was made.
    pub options: MeshOptions,
    /// How good it is.
    pub quality: Quality,
    /// Level of the surface [m].
    pub surface: f64,
    /// Weight of ballast on the surface [Pa]: it is no part of the mesh.
    pub ballast_pressure: f64,
}

/// Why a bridge has no mesh.
#[derive(Debug, Clone, PartialEq, Error)]
#[expect(missing_docs, reason = "the messages say what each is")]
pub enum MeshError {
    /// The intrados of a span cannot be drawn.
    #[error("the intrados of span {span} has no curve: {misfit}")]
    Intrados {
        /// Span, from 1.
        span: usize,
        /// Why.
        misfit: Misfit,
    },
    /// The surface of the mesh is level.
    #[error(
        "the road is not level, and the mesh knows none but a level one: leave out [road] and give the lowest layer its least thickness"
    )]
    RoadNotLevel,
    #[error(
        "a [[void]] takes the place of cover that is weight, and the mesh knows solid fill: leave it out and give the layers mean densities"
    )]
    Voids,
    #[error(
        "[internal_walls] are weight without stiffness, and the mesh knows solid fill: describe them as [haunch_fill] with mean density and \
         modulus"
    )]
    InternalWalls,
    /// There is nothing between the extrados and the surface.
    #[error(
        "there is no fill between the highest extrados and the surface: describe a layer of [[cover]] other than ballast, \
         for example \"fill\" of 0.3 m"
    )]
    NoFill,
    #[error(
        "the rings on both sides of pier {support} leave {gap:.3} m between their backs on its top: the mesh needs {least:.3} m; \
         give a pier {wider:.3} m wider"
    )]
    RingsMeet {
        support: usize,
        /// Room between them [m].
        gap: f64,
        /// Least room [m].
        least: f64,
        /// What is missing [m].
        wider: f64,
    },
    #[error("a mesh of this size would have about {nodes} nodes, more than {most}: give a larger `size` in [mesh]")]
    TooFine {
        /// Nodes expected.
        nodes: usize,
        /// Most nodes.
        most: usize,
    },
    #[error(
        "an element of the {zone} at x = {x:.2} m, y = {y:.2} m would be folded or flat (scaled Jacobian {value:.4}): {help}"
    )]
    Folded {
        zone: String,
        /// Place [m].
        x: f64,
        /// Place [m].
        y: f64,
        /// Scaled Jacobian.
        value: f64,
        /// What to change.
        help: &'static str,
    },
}

/// Elements with a smaller scaled Jacobian are refused: their corners are within 1.1 degrees of flat.
pub const LEAST_JACOBIAN: f64 = 0.02;

/// Most nodes of a mesh; ten times those of the finest mesh that answers in minutes.
pub const MOST_NODES: usize = 2_000_000;

/// Meshes a bridge as its file says.
///
/// # Errors
/// What the mesh does not know, no fill or no room on a pier, a folded element, or too many nodes.
pub fn mesh(bridge: &Bridge) -> Result<Meshed, MeshError> {
    mesh_with(bridge, MeshOptions::of(bridge))
}

#[cfg(test)]
mod tests;
