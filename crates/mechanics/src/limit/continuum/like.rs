//! One bound on a mesh that is as fine as other meshes of the same soil were, for loads that stand beside theirs.
//!
//! A mesh that refinement has made knows where stresses need it fine: about its load, and about the hinges of its mechanism. For a load a
//! little farther along the first moves with it and the second stay, so that one mesh serves where several would be refined one after the other.

use super::bounds::{Bounds, BoundsStatus, Round, Wanted, collapse_bounds};
use super::conic::Ending;
use super::lower::lower;
use super::mesh::Mesh;
use super::setting::Setting;
use super::triangulate::{MeshError, triangulate};
use super::upper::upper;
use crate::plane::{Vec2, vec2};
use crate::watch::CancelToken;

/// A mesh of the same soil for loads that stand elsewhere.
#[derive(Debug, Clone, Copy)]
pub struct Like<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// How far to the right of its loads the present ones stand [m].
    pub shift: f64,
}

/// A lower bound alone, on one mesh as fine as others are (status [`BoundsStatus::LowerAlone`]); where no stresses are found on it, both bounds
/// in the usual way.
///
/// # Errors
/// Those of [`collapse_bounds`].
pub fn lower_like(
    setting: &Setting<'_>,
    like: &[Like<'_>],
    wanted: &Wanted,
    token: &CancelToken,
) -> Result<Bounds, MeshError> {
    let mesh = graded(setting, like, wanted, COARSER)?;
    let below = match lower(setting, &mesh, token) {
        Ok(below) => below,
        Err(Ending::Cancelled) => {
            return Ok(Bounds { status: BoundsStatus::Cancelled, ..Bounds::begun(setting, mesh) });
        }
        Err(_) => return collapse_bounds(setting, wanted, token),
    };
    let rounds = vec![Round::of(&mesh, Some(&below), None)];
    Ok(Bounds { status: BoundsStatus::LowerAlone, lower: Some(below), rounds, ..Bounds::begun(setting, mesh) })
}

/// An upper bound alone, on a mesh about a third as fine as others are; none where no motion is found on it.
///
/// # Errors
/// Those of [`collapse_bounds`].
pub fn upper_like(
    setting: &Setting<'_>,
    like: &[Like<'_>],
    wanted: &Wanted,
    token: &CancelToken,
) -> Result<Option<f64>, MeshError> {
    let mesh = graded(setting, like, wanted, ROUGH)?;
    Ok(upper(setting, &mesh, token).ok().map(|motion| motion.factor))
}

/// Area of a triangle over that of others there from which on it is divided: for lower bounds, and for upper bounds.
const COARSER: f64 = 1.4;
const ROUGH: f64 = 4.0;

/// The first mesh, divided where others are finer.
fn graded(setting: &Setting<'_>, like: &[Like<'_>], wanted: &Wanted, coarser: f64) -> Result<Mesh, MeshError> {
    let mut mesh = triangulate(setting.soil, wanted.first.min(wanted.elements))?;
    let sizes: Vec<(Sizes<'_>, f64)> = like.iter().map(|like| (Sizes::of(like.mesh), like.shift)).collect();
    loop {
        let coarse = |t: &usize| {
            let middle = mesh.corners(*t).into_iter().fold(Vec2::ZERO, |sum, c| sum + c) * (1.0 / 3.0);
            mesh.area(*t) > coarser * area_wanted(&sizes, middle)
        };
        let mut marked = vec![false; mesh.triangles.len()];
        (0..mesh.triangles.len()).filter(coarse).for_each(|t| marked[t] = true);
        if !marked.contains(&true) {
            return Ok(mesh);
        }
        let (finer, _) = mesh.refined(&marked, setting.soil);
        if finer.triangles.len() > wanted.elements {
            return Ok(mesh);
        }
        mesh = finer;
    }
}

/// What is fine about one load alone need not be about another: of several meshes the coarsest counts, once where it stands and once moved with
/// the load; of these two the finer one.
fn area_wanted(sizes: &[(Sizes<'_>, f64)], at: Vec2) -> f64 {
    let most = |moved: f64| {
        sizes
            .iter()
            .filter_map(|(sizes, shift)| sizes.at(at - vec2(moved * shift, 0.0)))
            .fold(f64::NEG_INFINITY, f64::max)
    };
    let finite = |area: f64| if area > 0.0 { area } else { f64::INFINITY };
    finite(most(0.0)).min(finite(most(1.0)))
}

/// The triangles of a mesh by place.
struct Sizes<'a> {
    mesh: &'a Mesh,
    low: Vec2,
    cell: f64,
    columns: usize,
    cells: Vec<Vec<usize>>,
}

impl Sizes<'_> {
    fn of(mesh: &Mesh) -> Sizes<'_> {
        let (low, high) = crate::plane::bounds(&mesh.points);
        let span = high - low;
        let cell = (span.x * span.y / mesh.triangles.len().max(1) as f64).sqrt().max(f64::MIN_POSITIVE);
        let columns = (span.x / cell) as usize + 1;
        let rows = (span.y / cell) as usize + 1;
        let mut sizes = Sizes { mesh, low, cell, columns, cells: vec![Vec::new(); columns * rows] };
        for t in 0..mesh.triangles.len() {
            let (from, to) = crate::plane::bounds(mesh.corners(t));
            let ([i, j], [m, n]) = (sizes.place(from), sizes.place(to));
            for row in j..=n {
                for column in i..=m {
                    sizes.cells[row * columns + column].push(t);
                }
            }
        }
        sizes
    }

    fn place(&self, at: Vec2) -> [usize; 2] {
        let arm = (at - self.low) * (1.0 / self.cell);
        [arm.x as usize, arm.y as usize]
    }

    /// The area of the triangle that holds a point; none beside the mesh.
    fn at(&self, point: Vec2) -> Option<f64> {
        if point.x < self.low.x || point.y < self.low.y {
            return None;
        }
        let [column, row] = self.place(point);
        let inside = |t: &usize| {
            let [a, b, c] = self.mesh.corners(*t);
            [(a, b), (b, c), (c, a)].into_iter().all(|(p, q)| (q - p).cross(point - p) >= 0.0)
        };
        let cell = (column < self.columns).then(|| self.cells.get(row * self.columns + column)).flatten()?;
        cell.iter().copied().find(inside).map(|t| self.mesh.area(t))
    }
}
