//! Soil that yields as a continuum: triangles as built, with the stresses that are carried and the motion that is not.

use super::write::{Array, Cells, Grid};
use crate::soil;
use crate::stress::most_compressive;
use outcome::picture::Picture;

const REMARK: &str = "Soil as built, one metre wide; SI units, y up. region: counted from 0 from below. stress: mean tensor of the triangle at the lower bound [Pa], tension positive. motion: in the mechanism of the upper bound, in the scale of mechanism.vtu; Warp By Vector shows it. dissipation: power per area in that mechanism, relative to the largest. gap: share of the gap between the bounds.";

/// The soil as an unstructured grid. None without soil.
pub fn soil(picture: &Picture) -> Option<String> {
    let soil = soil::of(picture)?;
    let count = soil.triangles.len();
    let means: Vec<[f64; 3]> = soil.stresses.iter().map(soil::stress::mean).collect();
    // A list that does not fit is left out: it would stop the file from loading.
    let mut cells = Vec::new();
    if soil.regions.len() == count {
        cells.push(Array::whole("region", soil.regions.iter().map(|r| *r as i64)));
    }
    for (name, values) in [("dissipation", &soil.dissipation), ("gap", &soil.gaps)] {
        if values.len() == count {
            cells.push(Array::real(name, 1, values.iter().copied()));
        }
    }
    if means.len() == count {
        cells.extend(stresses(&means));
    }
    let moves = soil.motions.len() == soil.points.len();
    let grid = Grid {
        remark: REMARK,
        points: soil.points.clone(),
        cells: Cells::of(Cells::TRIANGLE, soil.triangles.iter().copied()),
        at_points: moves.then(|| Array::vectors("motion", soil.motions.iter().copied())).into_iter().collect(),
        at_cells: cells,
        ..Grid::default()
    };
    Some(grid.file())
}

/// Stresses in the plane as tensors, and the most compressive principal ones.
pub(super) fn stresses(stresses: &[[f64; 3]]) -> [Array<'static>; 2] {
    let tensor = stresses.iter().flat_map(|&[xx, yy, xy]| [xx, xy, 0.0, xy, yy, 0.0, 0.0, 0.0, 0.0]);
    let compression = stresses.iter().map(|&s| most_compressive(s));
    [Array::real("stress", 9, tensor), Array::real("principal compression", 1, compression)]
}
