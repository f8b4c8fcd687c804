//! Drawings (DXF) as closed outlines and circles in metres, both ways, and road profiles (LandXML) as lines. A leaf: it knows neither bridges nor mechanics.
//!
//! Reading never fails, whatever the bytes are: it gives what it understood and every finding, each with the layer, the
//! handle and the coordinates of its place. [`read()`] goes through four steps: the sieve keeps the parts of
//! the file that describe geometry, its groups become entities, curves become chords and block references are expanded,
//! and what comes out is chained, repaired and checked until only convex outlines are left.
//!
//! Lengths are in metres, x to the right, y up.

pub mod cards;
mod chain;
mod curve;
mod cut;
mod entities;
mod entity;
mod finding;
pub mod landxml;
mod options;
mod outline;
mod overlap;
mod read;
mod shapes;
mod shown;
mod sieve;
mod through;
mod transform;
mod units;
mod write;

pub use finding::{Finding, Place};
pub use findings::Severity;
pub use options::{Concave, Options};
pub use read::{Read, Trace, read, trace};
pub use shapes::{Circle, Drawing, Outline};
pub use write::{Item, Layer, Sheet, layer_name};

/// A point [m].
pub type Point = [f64; 2];
