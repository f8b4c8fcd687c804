//! Finite elements in the plane: solids of quadrilaterals, joints and contacts between them.

pub mod joint;
pub mod law;
mod mesh;

pub use mesh::{Interface, Mesh, Quad, Quadrature};
