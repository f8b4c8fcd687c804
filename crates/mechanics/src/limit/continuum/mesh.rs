//! Triangles that both bounds share: corners, edges, what each edge of the boundary touches; and their refinement.

use super::model::{Continuum, Side};
use crate::plane::Vec2;

/// A conforming mesh of straight triangles.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// Corners [m].
    pub points: Vec<Vec2>,
    /// Corners of each triangle, counter-clockwise.
    pub triangles: Vec<[usize; 3]>,
    /// The region of each triangle.
    pub regions: Vec<usize>,
    /// Every edge once.
    pub edges: Vec<Edge>,
    /// The edges of each triangle: the first is opposite to its first corner.
    pub edges_of: Vec<[usize; 3]>,
}

/// An edge of the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    /// Its ends; the triangle that counts as its own lies on the left of the way from the first to the second.
    pub ends: [usize; 2],
    /// The triangle on its left.
    pub triangle: usize,
    /// The triangle on its right; none on the boundary.
    pub other: Option<usize>,
    /// The side of the body that it lies on; none inside, and where the boundary is free.
    pub side: Option<usize>,
}

impl Mesh {
    /// Finds edges and what they touch.
    pub(super) fn new(points: Vec<Vec2>, triangles: Vec<[usize; 3]>, regions: Vec<usize>, sides: &[Side]) -> Mesh {
        let mut halves: Vec<([usize; 2], usize, usize)> = Vec::with_capacity(3 * triangles.len());
        for (t, corners) in triangles.iter().enumerate() {
            for k in 0..3 {
                let (a, b) = (corners[(k + 1) % 3], corners[(k + 2) % 3]);
                halves.push(([a.min(b), a.max(b)], t, k));
            }
        }
        halves.sort_unstable();
        let mut mesh = Mesh { edges_of: vec![[0; 3]; triangles.len()], points, triangles, regions, edges: Vec::new() };
        for pair in halves.chunk_by(|a, b| a.0 == b.0) {
            let (_, triangle, k) = pair[0];
            let corners = mesh.triangles[triangle];
            let ends = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
            for &(_, t, k) in pair {
                mesh.edges_of[t][k] = mesh.edges.len();
            }
            mesh.edges.push(Edge { ends, triangle, other: pair.get(1).map(|p| p.1), side: None });
        }
        for e in 0..mesh.edges.len() {
            if mesh.edges[e].other.is_none() {
                mesh.edges[e].side = mesh.side(e, sides);
            }
        }
        mesh
    }

    /// The side that an edge of the boundary lies on.
    fn side(&self, edge: usize, sides: &[Side]) -> Option<usize> {
        let [a, b] = self.ends(edge);
        let (middle, length) = ((a + b) * 0.5, (b - a).norm());
        let distance = |side: &Side| {
            let [from, to] = side.ends;
            let run = to - from;
            let t = ((middle - from).dot(run) / run.dot(run)).clamp(0.0, 1.0);
            (middle - from - run * t).norm()
        };
        let nearest = (0..sides.len()).min_by(|&i, &j| distance(&sides[i]).total_cmp(&distance(&sides[j])))?;
        (distance(&sides[nearest]) < 1e-3 * length).then_some(nearest)
    }

    /// The ends of an edge [m].
    pub fn ends(&self, edge: usize) -> [Vec2; 2] {
        self.edges[edge].ends.map(|p| self.points[p])
    }
    /// The corners of a triangle [m].
    pub fn corners(&self, triangle: usize) -> [Vec2; 3] {
        self.triangles[triangle].map(|p| self.points[p])
    }
    /// Its area [m^2].
    pub fn area(&self, triangle: usize) -> f64 {
        let [a, b, c] = self.corners(triangle);
        0.5 * (b - a).cross(c - a)
    }
    /// Number of velocity nodes: corners, then the middle of every edge.
    pub fn nodes(&self) -> usize {
        self.points.len() + self.edges.len()
    }
    /// The six velocity nodes of a triangle: its corners, then the middles of the edges opposite to them.
    pub fn nodes_of(&self, triangle: usize) -> [usize; 6] {
        let ([a, b, c], [d, e, f]) = (self.triangles[triangle], self.edges_of[triangle]);
        let n = self.points.len();
        [a, b, c, n + d, n + e, n + f]
    }
    /// The place of a velocity node [m].
    pub fn node(&self, node: usize) -> Vec2 {
        match node.checked_sub(self.points.len()) {
            None => self.points[node],
            Some(edge) => {
                let [a, b] = self.ends(edge);
                (a + b) * 0.5
            }
        }
    }

    /// The mesh with the marked triangles divided at their longest edges, and as many others as that takes to fit together
    /// (Rivara 1984), and of each of its triangles the one that it is a piece of. Angles stay above half of the smallest one of the first mesh;
    /// every field of the coarse mesh is one of the fine mesh.
    pub(super) fn refined(&self, marked: &[bool], model: &Continuum) -> (Mesh, Vec<usize>) {
        let mut divided = vec![false; self.edges.len()];
        let longest: Vec<usize> = (0..self.triangles.len()).map(|t| self.longest(t)).collect();
        let mut open: Vec<usize> = (0..self.triangles.len()).filter(|&t| marked[t]).collect();
        while let Some(t) = open.pop() {
            let edge = self.edges_of[t][longest[t]];
            if divided[edge] {
                continue;
            }
            divided[edge] = true;
            open.extend([Some(self.edges[edge].triangle), self.edges[edge].other].into_iter().flatten());
        }
        let mut points = self.points.clone();
        let middle: Vec<Option<usize>> = (0..self.edges.len())
            .map(|e| {
                divided[e].then(|| {
                    let [a, b] = self.ends(e);
                    points.push((a + b) * 0.5);
                    points.len() - 1
                })
            })
            .collect();
        let (mut triangles, mut parents) = (Vec::new(), Vec::new());
        for (t, corners) in self.triangles.iter().enumerate() {
            let k = longest[t];
            let [top, left, right] = [corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]];
            let edges = self.edges_of[t];
            let before = triangles.len();
            match middle[edges[k]] {
                None => triangles.push([top, left, right]),
                Some(m) => {
                    // The edge opposite to `right` joins `top` and `left`.
                    match middle[edges[(k + 2) % 3]] {
                        None => triangles.push([top, left, m]),
                        Some(n) => triangles.extend([[top, n, m], [n, left, m]]),
                    }
                    match middle[edges[(k + 1) % 3]] {
                        None => triangles.push([top, m, right]),
                        Some(n) => triangles.extend([[top, m, n], [n, m, right]]),
                    }
                }
            }
            parents.extend(std::iter::repeat_n(t, triangles.len() - before));
        }
        let regions = parents.iter().map(|&t| self.regions[t]).collect();
        (Mesh::new(points, triangles, regions, &model.sides), parents)
    }

    /// The mesh with a corner wherever a side of another boundary ends, and what that boundary touches; and of each of its triangles the one that
    /// it is a piece of.
    pub(super) fn divided_at(&self, model: &Continuum) -> (Mesh, Vec<usize>) {
        let mut mesh = Mesh::new(self.points.clone(), self.triangles.clone(), self.regions.clone(), &model.sides);
        let mut parents: Vec<usize> = (0..self.triangles.len()).collect();
        for end in model.sides.iter().flat_map(|side| side.ends) {
            let Some(edge) = mesh.edge_at(end) else { continue };
            let t = mesh.edges[edge].triangle;
            let corner = mesh.triangles[t][(0..3).find(|&k| mesh.edges_of[t][k] == edge).unwrap_or(0)];
            let [a, b] = mesh.edges[edge].ends;
            let new = mesh.points.len();
            mesh.points.push(end);
            mesh.triangles[t] = [corner, a, new];
            mesh.triangles.push([corner, new, b]);
            mesh.regions.push(mesh.regions[t]);
            parents.push(parents[t]);
            mesh = Mesh::new(mesh.points, mesh.triangles, mesh.regions, &model.sides);
        }
        (mesh, parents)
    }

    /// The edge of the boundary that holds a point between its ends.
    fn edge_at(&self, point: Vec2) -> Option<usize> {
        (0..self.edges.len()).filter(|&e| self.edges[e].other.is_none()).find(|&e| {
            let [a, b] = self.ends(e);
            let (run, arm) = (b - a, point - a);
            let (length, along) = (run.norm(), arm.dot(run) / run.norm());
            let near = 1e-9 * length;
            near < along && along < length - near && (run.cross(arm) / length).abs() < near
        })
    }

    /// The longest edge of a triangle; of equal ones the one with the larger number, which both neighbours agree on.
    fn longest(&self, triangle: usize) -> usize {
        let size = |k: usize| {
            let edge = self.edges_of[triangle][k];
            let [a, b] = self.ends(edge);
            ((b - a).dot(b - a), edge)
        };
        let longer = |i: &usize, j: &usize| {
            let (a, b) = (size(*i), size(*j));
            a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))
        };
        (0..3).max_by(longer).unwrap_or(0)
    }
}
