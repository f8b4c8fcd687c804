//! A finite element mesh: quadrilaterals with their zones.

use super::write::{Array, Grid};
use outcome::mesh::MeshPicture;

/// VTK's number of a quadrilateral.
const QUAD: u8 = 9;

/// The mesh as an unstructured grid: zone and scaled Jacobian of each element.
pub fn mesh(picture: &MeshPicture) -> String {
    let points: Vec<f64> = picture.nodes.iter().flat_map(|p| [p[0], p[1], 0.0]).collect();
    let connectivity: Vec<i64> = picture.quads.iter().flatten().map(|n| *n as i64).collect();
    let offsets: Vec<i64> = (1..=picture.quads.len()).map(|k| 4 * k as i64).collect();
    let zone: Vec<i64> = picture.zone_of.iter().map(|z| *z as i64).collect();
    let names: Vec<String> = picture.zones.iter().enumerate().map(|(k, z)| format!("{k} {}", z.name)).collect();
    let remark = format!("Finite element mesh; SI units, y up. zone: {}. {}.", names.join(", "), picture.remark);
    Grid {
        short: false,
        remark: &remark,
        field: &[],
        points: &points,
        connectivity: &connectivity,
        offsets: &offsets,
        kinds: &vec![QUAD; picture.quads.len()],
        at_points: &[],
        at_cells: &[Array::whole("zone", &zone), Array::real("scaled Jacobian", 1, &picture.scaled_jacobian)],
    }
    .file()
}
