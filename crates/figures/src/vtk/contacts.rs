//! Closed contacts as points.

use super::write::{Array, Grid};
use outcome::picture::{ContactForce, Picture};

/// VTK's number of a single point.
const VERTEX: u8 = 1;

const REMARK: &str = "Closed contacts where the blocks are in this state; forces per metre of width, SI units. normal: from the first to the second block. force: on the second block.";

/// Contacts at one snapshot; none where that snapshot does not exist.
pub fn contacts(picture: &Picture, snapshot: usize) -> Option<String> {
    let state = picture.snapshots.get(snapshot)?;
    let list = &state.contacts;
    let real = |value: fn(&ContactForce) -> f64| -> Vec<f64> { list.iter().map(value).collect() };
    let whole = |value: fn(&ContactForce) -> i64| -> Vec<i64> { list.iter().map(value).collect() };
    let points: Vec<f64> = list.iter().flat_map(|c| [c.point[0], c.point[1], 0.0]).collect();
    let normals: Vec<f64> = list.iter().flat_map(|c| [c.normal[0], c.normal[1], 0.0]).collect();
    let (compression, shear, stress) = (real(|c| c.compression), real(|c| c.shear), real(|c| c.stress));
    let sliding = whole(|c| i64::from(c.sliding));
    let (first, second) = (whole(|c| c.blocks[0] as i64), whole(|c| c.blocks[1] as i64));
    let numbers: Vec<i64> = (0..list.len() as i64).collect();
    let ends: Vec<i64> = (1..=list.len() as i64).collect();
    let arrays = [
        Array::real("compression", 1, &compression),
        Array::real("shear", 1, &shear),
        Array::real("stress", 1, &stress),
        Array::whole("sliding", &sliding),
        Array::real("normal", 3, &normals),
        Array::whole("first block", &first),
        Array::whole("second block", &second),
    ];
    let grid = Grid {
        short: false,
        remark: REMARK,
        field: &[("load", state.load)],
        points: &points,
        connectivity: &numbers,
        offsets: &ends,
        kinds: &vec![VERTEX; list.len()],
        at_points: &arrays,
        at_cells: &[],
    };
    Some(grid.file())
}
