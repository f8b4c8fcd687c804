//! Which displacement components are free, and the number each has in the system of equations.

use crate::ids::{Id, NodeId};

/// Number of a component that is held.
pub(super) const HELD: u32 = u32::MAX;

/// Components are `2 node` (x) and `2 node + 1` (y); the free ones are numbered in that order.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Dofs {
    /// Equation of each component, [`HELD`] if it has none.
    pub equation: Vec<u32>,
    /// Free components in order of their equations.
    pub free: Vec<u32>,
}

impl Dofs {
    /// Numbers those that are not `held`.
    pub(super) fn new(held: &[bool]) -> Dofs {
        let mut equation = vec![HELD; held.len()];
        let mut free = Vec::new();
        for (dof, _) in held.iter().enumerate().filter(|(_, held)| !**held) {
            equation[dof] = free.len() as u32;
            free.push(dof as u32);
        }
        Dofs { equation, free }
    }

    /// Values of the free components among those of all, by equation.
    pub(super) fn of_free(&self, all: &[f64]) -> Vec<f64> {
        self.free.iter().map(|component| all[*component as usize]).collect()
    }

    /// Whether a component is held.
    pub(super) fn held(&self, dof: usize) -> bool {
        self.equation[dof] == HELD
    }
}

/// Component `axis` (0 or 1) of a node.
#[inline]
pub(super) fn dof(node: NodeId, axis: usize) -> usize {
    2 * node.index() + axis
}
