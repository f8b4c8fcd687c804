//! Which quadrilaterals are looked at in each position: those that flow, their neighbours, and those that would flow soon.

use super::parts::Kind;
use super::{Condensed, CondensedError};
use crate::fem::law::{Four, Law};
use crate::fem::model::Model;
use crate::fem::{assemble, element};
use crate::ids::{Id, QuadId};

/// A quadrilateral is watched if it would flow at this multiple of what the loads do to it.
const FORESIGHT: f64 = 2.0;

/// Quadrilaterals at each node whose law is not linear.
pub(super) fn around(model: &Model) -> Vec<Vec<QuadId>> {
    let mut around = vec![Vec::new(); model.mesh.nodes.len()];
    for (id, quad) in model.mesh.quads.pairs().filter(|(id, _)| !model.section(*id).solid.material.linear()) {
        quad.nodes.iter().for_each(|node| around[node.index()].push(id));
    }
    around
}

impl Condensed<'_> {
    /// Yielding spreads to what is next to it.
    pub(super) fn watch_around(&mut self, changed: &[usize]) -> Result<(), CondensedError> {
        for &index in changed {
            let Kind::Quad(id) = self.parts[index].kind else { continue };
            for node in self.model.mesh.quads[id].nodes {
                for k in 0..self.around[node.index()].len() {
                    self.watch_quad(self.around[node.index()][k])?;
                }
            }
        }
        Ok(())
    }

    /// Finds quadrilaterals that would flow soon and watches them from now on; `true` where one of them flows already, unwatched:
    /// the positions since the last look have to be gone through again.
    pub fn look_ahead(&mut self) -> Result<bool, CondensedError> {
        let now = self.displacements();
        let mut missed = false;
        let ids: Vec<QuadId> = self.model.mesh.quads.pairs().map(|(id, _)| id).collect();
        for id in ids {
            let solid = &self.model.section(id).solid;
            if self.part_of[id.index()].is_some() || solid.material.linear() {
                continue;
            }
            let (then, at) = (self.strains(id, &self.start.displacements), self.strains(id, &now));
            let flows = |share: f64| {
                let points = self.start.points[4 * id.index()..4 * id.index() + 4].iter();
                points.zip(then.iter().zip(&at)).any(|(point, (then, at))| {
                    let strain: Four = std::array::from_fn(|i| then[i] + share * (at[i] - then[i]));
                    solid.respond(&strain, &point.memory).yields
                })
            };
            if flows(FORESIGHT) {
                missed |= flows(1.0);
                self.watch_quad(id)?;
            }
        }
        Ok(missed)
    }

    /// Strains at the points of a quadrilateral, incompatible modes left out.
    fn strains(&self, id: QuadId, displacements: &[f64]) -> [Four; 4] {
        let u = assemble::moved(displacements, &self.model.mesh.quads[id].nodes);
        element::sample(&self.model.corners(id)).map(|at| {
            let mut strain = [0.0; 4];
            for a in 0..4 {
                strain[0] += at.dx[a] * u[2 * a];
                strain[1] += at.dy[a] * u[2 * a + 1];
                strain[3] += at.dy[a] * u[2 * a] + at.dx[a] * u[2 * a + 1];
            }
            strain
        })
    }
}
