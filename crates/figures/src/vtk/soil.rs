//! Soil that yields as a continuum: triangles as built, with the stresses that are carried and the motion that is not.

use super::write::{Array, Grid};
use crate::soil;
use crate::stress::most_compressive;
use outcome::picture::Picture;

/// VTK's number of a triangle.
const TRIANGLE: u8 = 5;

const REMARK: &str = "Soil as built, one metre wide; SI units, y up. region: counted from 0 from below. stress: mean tensor of the triangle at the lower bound [Pa], tension positive. motion: in the mechanism of the upper bound, in the scale of mechanism.vtu; Warp By Vector shows it. dissipation: power per area in that mechanism, relative to the largest. gap: share of the gap between the bounds.";

/// The soil as an unstructured grid. None without soil.
pub fn soil(picture: &Picture) -> Option<String> {
    let soil = soil::of(picture)?;
    let count = soil.triangles.len();
    let points: Vec<f64> = soil.points.iter().flat_map(|p| [p[0], p[1], 0.0]).collect();
    let connectivity: Vec<i64> = soil.triangles.iter().flatten().map(|k| *k as i64).collect();
    let offsets: Vec<i64> = (1..=count).map(|k| 3 * k as i64).collect();
    let region: Vec<i64> = soil.regions.iter().map(|r| *r as i64).collect();
    let means: Vec<[f64; 3]> = soil.stresses.iter().map(soil::stress::mean).collect();
    let tensor: Vec<f64> = means.iter().flat_map(|&[xx, yy, xy]| [xx, xy, 0.0, xy, yy, 0.0, 0.0, 0.0, 0.0]).collect();
    let compression: Vec<f64> = means.iter().map(|&s| most_compressive(s)).collect();
    let motion: Vec<f64> = soil.motions.iter().flat_map(|u| [u[0], u[1], 0.0]).collect();
    // A list that does not fit is left out: it would stop the file from loading.
    let mut cells = Vec::new();
    if region.len() == count {
        cells.push(Array::whole("region", &region));
    }
    for (name, values) in [("dissipation", &soil.dissipation), ("gap", &soil.gaps)] {
        if values.len() == count {
            cells.push(Array::real(name, 1, values));
        }
    }
    if means.len() == count {
        cells.push(Array::real("stress", 9, &tensor));
        cells.push(Array::real("principal compression", 1, &compression));
    }
    let moves = [Array::real("motion", 3, &motion)];
    let file = Grid {
        short: false,
        remark: REMARK,
        field: &[],
        points: &points,
        connectivity: &connectivity,
        offsets: &offsets,
        kinds: &vec![TRIANGLE; count],
        at_points: if soil.motions.len() == soil.points.len() { &moves } else { &[] },
        at_cells: &cells,
    }
    .file();
    Some(file)
}
