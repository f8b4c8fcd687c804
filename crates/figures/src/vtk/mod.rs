//! Files that ParaView opens: unstructured grids (VTU) and their series (PVD).

mod blocks;
mod contacts;
mod mesh;
mod particles;
mod series;
mod soil;
mod write;

pub use blocks::{blocks, mechanism, role_number};
pub use contacts::contacts;
pub use mesh::mesh;
pub use particles::{particle_forces, particles};
pub use series::moments;
pub(crate) use series::{file, over_time};
pub use soil::soil;
pub(crate) use write::{Array, Cells, Grid};
