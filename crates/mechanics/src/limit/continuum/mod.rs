//! Limit analysis of rigid blocks beside a continuum that yields: soil in plane strain, with bounds from both sides.
//!
//! A stress field in equilibrium within strength gives a load that is carried, a motion that obeys the flow rule a load that is not. Both
//! are convex programs over the same triangles, with second-order cones for Mohr-Coulomb's surface, and the blocks of
//! [`crate::limit`] in the same equations: what soil exerts on a block is what the block exerts on soil. Where the two
//! bounds differ, the mesh is refined.
//!
//! Read in the order of the method: `model` says what is given, `triangulate` and `mesh` cut it up, `yielding` holds the strength, `lower` and
//! `upper` set up one program each and check what it returns, `conic` solves, `bounds` refines, `flow` estimates what
//! less dilation takes off, `report` says what it means for the blocks.

mod bounds;
mod conic;
mod elsewhere;
mod flow;
mod like;
mod lower;
mod mesh;
mod model;
mod report;
mod setting;
mod sideways;
mod strengths;
mod triangulate;
mod upper;
mod yielding;

pub use bounds::{Bounds, BoundsStatus, FIRST, Round, Wanted, Which, bound_on, closer_bounds, collapse_bounds};
pub use elsewhere::bound_elsewhere;
pub use flow::{Flow, flow_on};
pub use like::{Like, lower_like, upper_like};
pub use lower::Stresses;
pub use mesh::{Edge, Mesh};
pub use model::{Bears, Contact, Continuum, Panel, Region, Side, Soil, Water, davis};
pub use report::Pressure;
pub use setting::Setting;
pub use triangulate::MeshError;
pub use upper::Motion;
