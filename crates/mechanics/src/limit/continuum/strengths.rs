//! Strength at every corner of a mesh: what programs and checks read.

use super::mesh::Mesh;
use super::model::{Contact, Soil, davis};
use super::setting::Setting;
use super::sideways::Sideways;

/// Strength of soil at the corners of each triangle, of contacts at the ends of each edge that touches a body, and of soil beside a panel.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Strengths {
    pub soils: Vec<[Soil; 3]>,
    pub contacts: Vec<Option<[Contact; 2]>>,
    pub sideways: Vec<Option<Sideways>>,
}

impl Strengths {
    /// As given.
    pub(super) fn of(setting: &Setting<'_>, mesh: &Mesh) -> Strengths {
        let soils: Vec<Soil> = (0..mesh.triangles.len()).map(|t| setting.soil_of(mesh, t)).collect();
        Strengths {
            sideways: soils.iter().enumerate().map(|(t, soil)| Sideways::of(setting, mesh, t, soil)).collect(),
            soils: soils.into_iter().map(|soil| [soil; 3]).collect(),
            contacts: (0..mesh.edges.len()).map(|e| setting.body(mesh, e).map(|(_, contact)| [contact; 2])).collect(),
        }
    }

    /// Reduced after Davis for a dilatancy angle [rad].
    pub(super) fn reduced(&self, dilatancy: f64) -> Strengths {
        let of = |soil: &Soil| soil.reduced(1.0, dilatancy);
        let contact = |c: &Contact| {
            let factor = davis(c.friction.atan(), dilatancy.min(c.friction.atan()));
            Contact { friction: factor * c.friction, cohesion: factor * c.cohesion, ..*c }
        };
        let soils: Vec<[Soil; 3]> = self.soils.iter().map(|soils| soils.each_ref().map(of)).collect();
        Strengths {
            sideways: self.sideways.iter().zip(&soils).map(|(s, soils)| s.map(|s| s.with(&soils[0]))).collect(),
            soils,
            contacts: self.contacts.iter().map(|both| both.map(|both| both.each_ref().map(contact))).collect(),
        }
    }
}
