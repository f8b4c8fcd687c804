//! How good the elements of a mesh are.

use mechanics::fem::Mesh;
use mechanics::ids::QuadId;
use mechanics::plane::Vec2;

/// What a mesh counts and how well its elements are shaped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quality {
    /// Nodes.
    pub nodes: usize,
    /// Elements.
    pub quads: usize,
    /// Pairs of facing nodes in joints and contacts.
    pub pairs: usize,
    /// Displacements that are free: two a node, less those that supports hold.
    pub degrees_of_freedom: usize,
    /// Least scaled Jacobian: the sine of a corner's angle, 1 for rectangles, 0 where an element is flat.
    pub scaled_jacobian: f64,
    /// Where it is [m].
    pub worst: Vec2,
    /// Mean of the elements' scaled Jacobians.
    pub mean_scaled_jacobian: f64,
    /// Largest ratio of the mean lengths of opposite sides.
    pub aspect_ratio: f64,
    /// Shortest and longest side [m].
    pub sides: [f64; 2],
}

impl Quality {
    /// It in a line.
    pub fn words(&self) -> String {
        format!(
            "{} elements, {} nodes, {} free displacements, {} pairs of facing nodes; least scaled Jacobian {:.2}, mean {:.2}; \
             largest aspect ratio {:.0}",
            self.quads,
            self.nodes,
            self.degrees_of_freedom,
            self.pairs,
            self.scaled_jacobian,
            self.mean_scaled_jacobian,
            self.aspect_ratio
        )
    }
}

/// The scaled Jacobian of a quadrilateral: the least sine of its four corners, negative where one is not convex.
pub fn scaled_jacobian(corners: [Vec2; 4]) -> f64 {
    (0..4)
        .map(|k| {
            let (at, next, before) = (corners[k], corners[(k + 1) % 4], corners[(k + 3) % 4]);
            (next - at).unit().cross((before - at).unit())
        })
        .fold(f64::INFINITY, f64::min)
}

/// The corners of an element.
pub fn corners(mesh: &Mesh, quad: QuadId) -> [Vec2; 4] {
    mesh.quads[quad].nodes.map(|node| mesh.nodes[node])
}

/// The quality of a mesh of which `held` displacements are held.
pub fn quality(mesh: &Mesh, held: usize) -> Quality {
    let mut found = Quality {
        nodes: mesh.nodes.len(),
        quads: mesh.quads.len(),
        pairs: mesh.interfaces.iter().map(|i| i.one.len()).sum(),
        degrees_of_freedom: (2 * mesh.nodes.len()).saturating_sub(held),
        scaled_jacobian: f64::INFINITY,
        worst: Vec2::ZERO,
        mean_scaled_jacobian: 0.0,
        aspect_ratio: 1.0,
        sides: [f64::INFINITY, 0.0],
    };
    let mut sum = 0.0;
    for quad in mesh.quads.ids() {
        let c = corners(mesh, quad);
        let jacobian = scaled_jacobian(c);
        sum += jacobian;
        // What is no number is worse than anything.
        if jacobian.is_nan() || jacobian < found.scaled_jacobian {
            found.scaled_jacobian = if jacobian.is_nan() { f64::NEG_INFINITY } else { jacobian };
            found.worst = (c[0] + c[1] + c[2] + c[3]) * 0.25;
        }
        let side = |k: usize| (c[(k + 1) % 4] - c[k]).norm();
        let (a, b) = (side(0) + side(2), side(1) + side(3));
        found.aspect_ratio = found.aspect_ratio.max(a.max(b) / a.min(b));
        for k in 0..4 {
            found.sides = [found.sides[0].min(side(k)), found.sides[1].max(side(k))];
        }
    }
    found.mean_scaled_jacobian = sum / mesh.quads.len().max(1) as f64;
    found
}
