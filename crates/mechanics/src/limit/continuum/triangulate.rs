//! The first mesh: a constrained Delaunay triangulation of the regions, refined to a least angle and a largest area.

use super::mesh::Mesh;
use super::model::Continuum;
use crate::plane::{Vec2, area, edges, holds, vec2};
use spade::{AngleLimit, ConstrainedDelaunayTriangulation, Point2, RefinementParameters, Triangulation};
use thiserror::Error;

/// Why regions have no mesh.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum MeshError {
    /// A region's outline is no polygon.
    #[error("region {region} of the continuum has no area, or its outline crosses itself near ({x:.3}, {y:.3}) m")]
    Outline {
        /// The region, from 1.
        region: usize,
        /// Where [m].
        x: f64,
        /// Where [m].
        y: f64,
    },
    /// Two lines cross where no corner is.
    #[error("two boundaries of the continuum cross near ({x:.3}, {y:.3}) m where no corner is")]
    Cross {
        /// Where [m].
        x: f64,
        /// Where [m].
        y: f64,
    },
    /// No triangle lies in any region.
    #[error("the regions of the continuum hold no triangle")]
    Empty,
}

/// Least angle of the first mesh [degrees]: what refinement reaches everywhere but in sharper corners of the regions.
const LEAST_ANGLE: f64 = 28.0;

/// Points nearer than this share of the body's size are one.
const SAME: f64 = 1e-9;

/// A mesh of about `elements` triangles.
pub(super) fn triangulate(model: &Continuum, elements: usize) -> Result<Mesh, MeshError> {
    let (points, segments) = lines(model)?;
    let mut net = ConstrainedDelaunayTriangulation::<Point2<f64>>::new();
    let place = |p: Vec2| MeshError::Cross { x: p.x, y: p.y };
    let mut handles = Vec::with_capacity(points.len());
    for &p in &points {
        handles.push(net.insert(Point2::new(p.x, p.y)).map_err(|_| place(p))?);
    }
    for &[a, b] in &segments {
        if !net.can_add_constraint(handles[a], handles[b]) {
            return Err(place((points[a] + points[b]) * 0.5));
        }
        net.add_constraint(handles[a], handles[b]);
    }
    let area: f64 = model.regions.iter().map(|r| area(&r.outline)).sum();
    // What lies beside the regions is refined too, and left out below: told to skip it, spade skips every second region.
    let parameters = RefinementParameters::<f64>::new()
        .with_angle_limit(AngleLimit::from_deg(LEAST_ANGLE))
        .with_max_allowed_area(2.0 * area / elements as f64)
        .with_max_additional_vertices(8 * elements + 16 * points.len());
    net.refine(parameters);
    let vertices: Vec<Vec2> = net.vertices().map(|v| vec2(v.position().x, v.position().y)).collect();
    let (mut triangles, mut regions) = (Vec::new(), Vec::new());
    for face in net.inner_faces() {
        let corners = face.vertices().map(|v| v.fix().index());
        let centre = corners.iter().fold(Vec2::ZERO, |sum, &i| sum + vertices[i]) * (1.0 / 3.0);
        if let Some(region) = model.regions.iter().position(|r| holds(&r.outline, centre)) {
            triangles.push(corners);
            regions.push(region);
        }
    }
    if triangles.is_empty() {
        return Err(MeshError::Empty);
    }
    let (points, triangles) = used(vertices, triangles);
    Ok(Mesh::new(points, triangles, regions, &model.sides))
}

/// Corners and segments of all outlines and sides; a segment is divided where a corner lies on it.
fn lines(model: &Continuum) -> Result<(Vec<Vec2>, Vec<[usize; 2]>), MeshError> {
    for (k, region) in model.regions.iter().enumerate() {
        let at = region.outline.first().copied().unwrap_or(Vec2::ZERO);
        if !(area(&region.outline) > 0.0) {
            return Err(MeshError::Outline { region: k + 1, x: at.x, y: at.y });
        }
    }
    let corners = model.regions.iter().flat_map(|r| r.outline.iter().copied());
    let all: Vec<Vec2> = corners.chain(model.sides.iter().flat_map(|s| s.ends)).collect();
    let (low, high) = crate::plane::bounds(&all);
    let near = SAME * (high - low).norm();
    let mut points: Vec<Vec2> = Vec::new();
    let mut number = |p: Vec2| match points.iter().position(|q| (*q - p).norm() <= near) {
        Some(k) => k,
        None => {
            points.push(p);
            points.len() - 1
        }
    };
    let mut raw: Vec<[usize; 2]> = Vec::new();
    for region in &model.regions {
        raw.extend(edges(&region.outline).map(|(a, b)| [number(a), number(b)]));
    }
    raw.extend(model.sides.iter().map(|s| s.ends.map(&mut number)));
    let mut segments: Vec<[usize; 2]> = Vec::new();
    for [a, b] in raw.into_iter().filter(|[a, b]| a != b) {
        let run = points[b] - points[a];
        let length = run.norm();
        let mut on: Vec<(f64, usize)> = (0..points.len())
            .filter_map(|k| {
                let arm = points[k] - points[a];
                let t = arm.dot(run) / (length * length);
                (t > 0.0 && t < 1.0 && arm.cross(run).abs() <= near * length && k != a && k != b).then_some((t, k))
            })
            .collect();
        on.sort_by(|x, y| x.0.total_cmp(&y.0));
        let stops: Vec<usize> = [a].into_iter().chain(on.into_iter().map(|(_, k)| k)).chain([b]).collect();
        segments.extend(stops.windows(2).map(|w| [w[0].min(w[1]), w[0].max(w[1])]));
    }
    segments.sort_unstable();
    segments.dedup();
    Ok((points, segments))
}

/// The points that triangles use, and triangles that name those.
fn used(points: Vec<Vec2>, mut triangles: Vec<[usize; 3]>) -> (Vec<Vec2>, Vec<[usize; 3]>) {
    let mut number = vec![None; points.len()];
    let mut kept = Vec::new();
    for corner in triangles.iter_mut().flatten() {
        *corner = *number[*corner].get_or_insert_with(|| {
            kept.push(points[*corner]);
            kept.len() - 1
        });
    }
    (kept, triangles)
}
