//! Closed contacts as points.

use super::write::{Array, Cells, Grid};
use outcome::picture::{ContactForce, Picture};

const REMARK: &str = "Closed contacts where the blocks are in this state; forces per metre of width, SI units. normal: from the first to the second block. force: on the second block.";

/// Contacts at one snapshot; none where that snapshot does not exist.
pub fn contacts(picture: &Picture, snapshot: usize) -> Option<String> {
    let state = picture.snapshots.get(snapshot)?;
    let list = &state.contacts;
    let real = |name, value: fn(&ContactForce) -> f64| Array::real(name, 1, list.iter().map(value));
    let whole = |name, value: fn(&ContactForce) -> i64| Array::whole(name, list.iter().map(value));
    let grid = Grid {
        remark: REMARK,
        field: &[("load", state.load)],
        points: list.iter().map(|c| c.point).collect(),
        cells: Cells::points(list.len()),
        at_points: vec![
            real("compression", |c| c.compression),
            real("shear", |c| c.shear),
            real("stress", |c| c.stress),
            whole("sliding", |c| i64::from(c.sliding)),
            Array::vectors("normal", list.iter().map(|c| c.normal)),
            whole("first block", |c| c.blocks[0] as i64),
            whole("second block", |c| c.blocks[1] as i64),
        ],
        ..Grid::default()
    };
    Some(grid.file())
}
