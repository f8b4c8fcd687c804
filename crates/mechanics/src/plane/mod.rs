//! Plane geometry: vectors, poses, convex polygons with rounded corners, and where two of them meet.

mod manifold;
mod polygon;
mod pose;
mod vector;

pub use manifold::{Manifold, Meeting, meet};
pub use polygon::{Core, Polygon, PolygonError};
pub(crate) use polygon::{area, bounds, edges, holds, overlapping};
pub use pose::{Pose, Rotation};
pub use vector::{Vec2, vec2};
