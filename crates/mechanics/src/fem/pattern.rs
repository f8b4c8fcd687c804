//! Where the entries of the tangent stand: the lower triangle by columns, and for each element the places of its own.

use super::dofs::{Dofs, HELD, dof};
use super::model::Model;
use crate::ids::NodeId;

/// The pattern of a model's tangent, fixed for good.
#[derive(Debug, Clone)]
pub struct Pattern {
    /// Start of each column in `rows`, and the end of the last.
    pub(super) columns: Vec<u32>,
    /// Rows of the lower triangle, ascending in each column, the diagonal first.
    pub(super) rows: Vec<u32>,
    /// Entries that join a free component (by equation) to a held one (by component); they stand behind those of the triangle.
    pub(super) coupling: Vec<(u32, u32)>,
    /// Places of the entries (0,0), (1,0), (1,1), (2,0) ... of each element: quadrilaterals first, then springs.
    slots: Vec<u32>,
    starts: Vec<usize>,
}

impl Pattern {
    /// Finds the pattern of a model.
    pub fn new(model: &Model) -> Pattern {
        let quads = model.mesh.quads.iter().map(|quad| quad.nodes.to_vec());
        let springs = model.springs.iter().map(|spring| spring.nodes().collect());
        let elements: Vec<Vec<NodeId>> = quads.chain(springs).collect();
        let neighbours = neighbours(model.mesh.nodes.len(), &elements);
        let (columns, rows) = triangle(&model.dofs, &neighbours);
        let mut pattern = Pattern { columns, rows, coupling: Vec::new(), slots: Vec::new(), starts: vec![0] };
        for nodes in &elements {
            pattern.place(&model.dofs, nodes);
        }
        // Entries that nobody reads stand in the last place.
        let last = (pattern.places() - 1) as u32;
        pattern.slots.iter_mut().filter(|slot| **slot == HELD).for_each(|slot| *slot = last);
        pattern
    }

    /// Entries of the lower triangle.
    pub(super) fn entries(&self) -> usize {
        self.rows.len()
    }

    /// Entries with those that join held components, and one where entries between held components are thrown.
    pub(super) fn places(&self) -> usize {
        self.rows.len() + self.coupling.len() + 1
    }

    /// Places of an element's entries.
    #[inline]
    pub(super) fn slots(&self, element: usize) -> &[u32] {
        &self.slots[self.starts[element]..self.starts[element + 1]]
    }

    /// Entries of a column: rows and where the first of them stands.
    #[inline]
    pub(super) fn column(&self, column: usize) -> std::ops::Range<usize> {
        self.columns[column] as usize..self.columns[column + 1] as usize
    }

    fn place(&mut self, dofs: &Dofs, nodes: &[NodeId]) {
        let components: Vec<usize> = nodes.iter().flat_map(|node| [dof(*node, 0), dof(*node, 1)]).collect();
        for (i, one) in components.iter().enumerate() {
            for two in &components[..=i] {
                let (a, b) = (dofs.equation[*one], dofs.equation[*two]);
                let place = match (a == HELD, b == HELD) {
                    (false, false) => self.find(a.min(b) as usize, a.max(b)),
                    // Marked here; moved behind the others once all are known.
                    (false, true) => self.couple(a, *two as u32),
                    (true, false) => self.couple(b, *one as u32),
                    (true, true) => HELD,
                };
                self.slots.push(place);
            }
        }
        self.starts.push(self.slots.len());
    }

    fn find(&self, column: usize, row: u32) -> u32 {
        let range = self.column(column);
        let within = self.rows[range.clone()].partition_point(|r| *r < row);
        (range.start + within) as u32
    }

    fn couple(&mut self, free: u32, held: u32) -> u32 {
        self.coupling.push((free, held));
        (self.rows.len() + self.coupling.len() - 1) as u32
    }

    /// `out += S x + A x`: the symmetric part in the lower triangle of `values`, and what is skew in that of `skew`, if anything is.
    pub(super) fn multiply(&self, values: &[f64], skew: &[f64], x: &[f64], out: &mut [f64]) {
        self.multiply_triangle::<false>(values, x, out);
        if !skew.is_empty() {
            self.multiply_triangle::<true>(skew, x, out);
        }
    }

    fn multiply_triangle<const SKEW: bool>(&self, values: &[f64], x: &[f64], out: &mut [f64]) {
        for column in 0..x.len() {
            let range = self.column(column);
            let (xc, mut sum) = (x[column], 0.0);
            if !SKEW {
                out[column] += values[range.start] * xc;
            }
            for k in range.start + 1..range.end {
                let row = self.rows[k] as usize;
                out[row] += values[k] * xc;
                let mirrored = values[k] * x[row];
                sum += if SKEW { -mirrored } else { mirrored };
            }
            out[column] += sum;
        }
    }
}

/// Nodes that share an element with each node, itself among them, ascending.
fn neighbours(count: usize, elements: &[Vec<NodeId>]) -> Vec<Vec<u32>> {
    let mut all: Vec<Vec<u32>> = vec![Vec::new(); count];
    for nodes in elements {
        for one in nodes {
            all[one.0 as usize].extend(nodes.iter().map(|node| node.0));
        }
    }
    for (node, of_node) in all.iter_mut().enumerate() {
        of_node.push(node as u32);
        of_node.sort_unstable();
        of_node.dedup();
    }
    all
}

/// Columns and rows of the lower triangle.
fn triangle(dofs: &Dofs, neighbours: &[Vec<u32>]) -> (Vec<u32>, Vec<u32>) {
    let mut columns = vec![0];
    let mut rows = Vec::new();
    for (equation, component) in dofs.free.iter().enumerate() {
        for node in &neighbours[*component as usize / 2] {
            for axis in 0..2 {
                let row = dofs.equation[2 * *node as usize + axis];
                if row != HELD && row as usize >= equation {
                    rows.push(row);
                }
            }
        }
        columns.push(rows.len() as u32);
    }
    (columns, rows)
}
