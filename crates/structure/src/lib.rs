//! From what an engineer wrote or drew to models of it: rings, piers, walls and fill become blocks, forces and meshes. Nothing is
//! analysed here.

pub mod blocks;
pub mod discretise;
mod extent;
pub mod packing_file;
pub mod section;

#[cfg(test)]
mod samples;
