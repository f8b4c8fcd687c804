//! Blocks as polygons, as built, with their displacement beside: ParaView's "Warp By Vector" moves them.

use super::write::{Array, Grid};
use crate::geometry::{Turn, centroid, displacement};
use crate::stress::most_compressive;
use outcome::picture::{Motion, Picture, Shape, Snapshot};

/// VTK's number of a polygon.
const POLYGON: u8 = 7;

/// The number of a role in the array `role`: 0 voussoir, 1 abutment, 2 pier, 3 backing, 4 block, 6 wall, 5 anything else.
pub fn role_number(role: &str) -> i64 {
    match role {
        "voussoir" => 0,
        "abutment" => 1,
        "pier" => 2,
        "backing" => 3,
        "block" => 4,
        "wall" => 6,
        _ => 5,
    }
}

const REMARK: &str = "Blocks as built, one metre wide; SI units, y up. Warp By Vector with displacement shows them moved. role: 0 voussoir, 1 abutment, 2 pier, 3 backing, 4 block, 5 other, 6 wall. stress: average tensor of the block, tension positive.";

/// Blocks at one snapshot. None where that snapshot does not exist or does not fit the blocks.
pub fn blocks(picture: &Picture, snapshot: usize) -> Option<String> {
    let state = picture.snapshots.get(snapshot).filter(|s| s.motions.len() == picture.shapes.len())?;
    Some(file(&picture.shapes, &state.motions, Turn::Finite, Some(state)))
}

/// Blocks with the motion of the mechanism, its largest translation 1 m. None without a mechanism.
pub fn mechanism(picture: &Picture) -> Option<String> {
    let motions = picture.mechanism.as_ref().filter(|m| m.len() == picture.shapes.len())?;
    Some(file(&picture.shapes, motions, Turn::Small, None))
}

fn file(shapes: &[Shape], motions: &[Motion], turn: Turn, state: Option<&Snapshot>) -> String {
    let (mut points, mut moves, mut connectivity, mut offsets) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for (shape, &motion) in shapes.iter().zip(motions) {
        let centre = centroid(&shape.outline);
        for &corner in &shape.outline {
            connectivity.push((points.len() / 3) as i64);
            points.extend([corner[0], corner[1], 0.0]);
            let u = displacement(corner, centre, motion, turn);
            moves.extend([u[0], u[1], 0.0]);
        }
        offsets.push(connectivity.len() as i64);
    }
    let count = shapes.len();
    let numbers: Vec<i64> = (0..count as i64).collect();
    let roles: Vec<i64> = shapes.iter().map(|s| role_number(&s.role)).collect();
    let held: Vec<i64> = shapes.iter().map(|s| i64::from(s.held)).collect();
    let rotation: Vec<f64> = motions.iter().map(|m| m.rotation).collect();
    let mut cells = vec![
        Array::whole("block", &numbers),
        Array::whole("role", &roles),
        Array::whole("held", &held),
        Array::real("rotation", 1, &rotation),
    ];
    let fitting = |n: usize| n == count;
    let velocities = state.filter(|s| fitting(s.velocities.len())).map(|s| &s.velocities);
    let velocity: Vec<f64> = velocities.into_iter().flatten().flat_map(|v| [v[0], v[1], 0.0]).collect();
    if !velocity.is_empty() {
        cells.push(Array::real("velocity", 3, &velocity));
    }
    let stresses = || state.filter(|s| fitting(s.stresses.len())).into_iter().flat_map(|s| &s.stresses);
    let tensor: Vec<f64> = stresses().flat_map(|&[xx, yy, xy]| [xx, xy, 0.0, xy, yy, 0.0, 0.0, 0.0, 0.0]).collect();
    let compression: Vec<f64> = stresses().map(|&s| most_compressive(s)).collect();
    if !tensor.is_empty() {
        cells.push(Array::real("stress", 9, &tensor));
        cells.push(Array::real("principal compression", 1, &compression));
    }
    let field: Vec<(&str, f64)> = state.map(|s| ("load", s.load)).into_iter().collect();
    Grid {
        short: false,
        remark: REMARK,
        field: &field,
        points: &points,
        connectivity: &connectivity,
        offsets: &offsets,
        kinds: &vec![POLYGON; count],
        at_points: &[Array::real("displacement", 3, &moves)],
        at_cells: &cells,
    }
    .file()
}
