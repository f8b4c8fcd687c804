//! Finite elements in the plane: solids of quadrilaterals, joints and contacts between them.
//!
//! A [`Model`] is what is fixed: mesh, materials, supports. A [`State`] is what has happened to it: displacements, and what points
//! remember. A [`Workspace`] holds the pattern, the factorisation and scratch; it can be thrown away. [`advance`] takes a state to new
//! loads in steps of Newton's method, [`transient`] through time; how that ended is an [`Outcome`] with a named status.
//! Vectors of components hold x and y of each node in turn; those of free components leave out what supports hold.
//! Equations are numbered in `docs/theory/finite-elements.md`.

mod assemble;
pub mod condensed;
mod dofs;
mod element;
mod factor;
mod gmres;
mod interface;
pub mod joint;
pub mod law;
mod many;
mod mesh;
mod model;
mod newmark;
mod newton;
mod outcome;
mod pattern;
mod settings;
mod state;
mod unsymmetric;
mod workspace;

pub use element::{Element, Section};
pub use factor::FactorError;
pub use interface::Spring;
pub use mesh::{Interface, Mesh, Quad, Quadrature};
pub use model::{Model, ModelError, Support};
pub use newmark::{Damping, Motion, at_rest, transient};
pub use newton::{Target, advance};
pub use outcome::{Outcome, Status, Step};
pub use pattern::Pattern;
pub use settings::{Kinematics, Settings};
pub use state::{Bond, Point, State};
pub use workspace::{Workspace, reactions};
