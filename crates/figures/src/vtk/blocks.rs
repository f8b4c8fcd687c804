//! Blocks as polygons, as built, with their displacement beside: ParaView's "Warp By Vector" moves them.

use super::soil::stresses;
use super::write::{Array, Cells, Grid};
use crate::geometry::{Turn, centroid, displacement};
use outcome::picture::{Motion, Picture, Shape, Snapshot};

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
    let (mut points, mut moves, mut cells) = (Vec::new(), Vec::new(), Vec::new());
    for (shape, &motion) in shapes.iter().zip(motions) {
        let centre = centroid(&shape.outline);
        moves.extend(shape.outline.iter().map(|&corner| displacement(corner, centre, motion, turn)));
        cells.push(points.len()..points.len() + shape.outline.len());
        points.extend(&shape.outline);
    }
    let count = shapes.len();
    let mut at_cells = vec![
        Array::whole("block", 0..count as i64),
        Array::whole("role", shapes.iter().map(|s| role_number(&s.role))),
        Array::whole("held", shapes.iter().map(|s| i64::from(s.held))),
        Array::real("rotation", 1, motions.iter().map(|m| m.rotation)),
    ];
    if let Some(state) = state.filter(|s| s.velocities.len() == count && count > 0) {
        at_cells.push(Array::vectors("velocity", state.velocities.iter().copied()));
    }
    if let Some(state) = state.filter(|s| s.stresses.len() == count && count > 0) {
        at_cells.extend(stresses(&state.stresses));
    }
    let field: Vec<(&str, f64)> = state.map(|s| ("load", s.load)).into_iter().collect();
    let grid = Grid {
        remark: REMARK,
        field: &field,
        points,
        cells: Cells::of(Cells::POLYGON, cells),
        at_points: vec![Array::vectors("displacement", moves)],
        at_cells,
        ..Grid::default()
    };
    grid.file()
}
