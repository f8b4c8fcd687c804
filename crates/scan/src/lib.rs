//! Point clouds of laser scanners, cut by an upright plane.
//!
//! A scanned bridge comes as millions of points. What a plane model takes of it is one section: the points near an upright plane along the
//! bridge, seen at right angles. Clouds are read in pieces and never held as a whole.

mod cut;
mod read;

pub use cut::{CELL, Cut, Slice, cut};
pub use read::{CloudError, Format, points};
