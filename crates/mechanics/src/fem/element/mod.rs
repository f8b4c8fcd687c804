//! Four-node quadrilaterals: what a zone is made of, and what one element answers to the displacements of its corners.

mod integrate;
mod shape;
mod turn;

pub(super) use integrate::{Answer, Kept, held, is_linear, respond};
pub(super) use shape::{Sample, centre, mass, sample};
pub(super) use turn::{Angle, turned};

use super::law::Solid;

/// Formulation of a quadrilateral, with 2 x 2 points of integration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Element {
    /// Bilinear displacements.
    Q4,
    /// With Taylor's four incompatible modes: bends without locking, and passes the patch test.
    #[default]
    QM6,
}

/// What the elements of a zone are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// Law, in plane strain or plane stress.
    pub solid: Solid,
    /// Formulation.
    pub element: Element,
    /// Mass density [kg/m^3].
    pub density: f64,
}
