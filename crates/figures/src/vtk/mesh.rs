//! A finite element mesh: quadrilaterals with their zones.

use super::write::{Array, Cells, Grid};
use outcome::mesh::MeshPicture;

/// The mesh as an unstructured grid: zone and scaled Jacobian of each element.
pub fn mesh(picture: &MeshPicture) -> String {
    let names: Vec<String> = picture.zones.iter().enumerate().map(|(k, z)| format!("{k} {}", z.name)).collect();
    let remark = format!("Finite element mesh; SI units, y up. zone: {}. {}.", names.join(", "), picture.remark);
    let grid = Grid {
        remark: &remark,
        points: picture.nodes.clone(),
        cells: Cells::of(Cells::QUAD, picture.quads.iter().copied()),
        at_cells: vec![
            Array::whole("zone", picture.zone_of.iter().map(|zone| *zone as i64)),
            Array::real("scaled Jacobian", 1, picture.scaled_jacobian.iter().copied()),
        ],
        ..Grid::default()
    };
    grid.file()
}
