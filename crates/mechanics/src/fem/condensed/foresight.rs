//! Which quadrilaterals are looked at in each position: those that flow, their neighbours, those that would flow if all were linear,
//! and those that would flow soon.

use super::parts::Kind;
use super::{Condensed, CondensedError};
use crate::fem::dofs::{HELD, dof};
use crate::fem::law::{Four, Law};
use crate::fem::model::Model;
use crate::fem::{assemble, element};
use crate::ids::{Id, QuadId};

/// A quadrilateral is watched if it would flow at this multiple of what the loads do to it.
pub(super) const FORESIGHT: f64 = 2.0;

/// Positions between two of a scan, and positions of a scan that are worked on together.
const SCAN: (usize, usize) = (4, 32);

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

    /// Watches quadrilaterals that would flow somewhere on the way if all parts stayed linear.
    ///
    /// Of each that is not watched yet the scan keeps the displacements of its corners where its centre is sheared most, where it is
    /// stretched most, and where the sum of both is largest; its law is asked about these alone.
    pub(super) fn scan(&mut self, count: usize, amplitudes: &dyn Fn(usize) -> Vec<f64>) -> Result<(), CondensedError> {
        let model = self.model;
        let open = model.mesh.quads.pairs().filter(|(id, _)| !model.section(*id).solid.material.linear());
        let mut quads: Vec<Scanned> =
            open.filter(|(id, _)| self.part_of[id.index()].is_none()).map(|(id, _)| Scanned::new(model, id)).collect();
        let places: Vec<usize> = (0..count).step_by(SCAN.0).collect();
        for places in places.chunks(SCAN.1) {
            let shares: Vec<Vec<f64>> = places.iter().map(|&k| amplitudes(k)).collect();
            let moved = self.rows.displacements(&shares);
            for moved in moved.col_iter() {
                let moved: Vec<f64> = moved.iter().copied().collect();
                quads.iter_mut().for_each(|quad| quad.see(&moved));
            }
        }
        for quad in quads {
            let u = assemble::moved(&self.start.displacements, &model.mesh.quads[quad.id].nodes);
            let then = self.strains(quad.id, &u);
            let flows = quad.most.iter().any(|(_, more)| {
                let at = self.strains(quad.id, &std::array::from_fn(|i| u[i] + more[i]));
                self.flows(quad.id, &then, &at, self.foresight)
            });
            if flows {
                self.watch_quad(quad.id)?;
            }
        }
        Ok(())
    }

    /// Whether a point of a quadrilateral would flow at a multiple of a change of strain.
    fn flows(&self, id: QuadId, then: &[Four; 4], at: &[Four; 4], multiple: f64) -> bool {
        let solid = &self.model.section(id).solid;
        let points = self.start.points[4 * id.index()..4 * id.index() + 4].iter();
        points.zip(then.iter().zip(at)).any(|(point, (then, at))| {
            let strain: Four = std::array::from_fn(|i| then[i] + multiple * (at[i] - then[i]));
            solid.respond(&strain, &point.memory).yields
        })
    }

    /// Finds quadrilaterals that would flow soon and watches them from now on; `true` where one of them flows already, unwatched:
    /// the positions since the last look have to be gone through again.
    pub fn look_ahead(&mut self) -> Result<bool, CondensedError> {
        let now = self.displacements();
        let mut missed = false;
        let ids: Vec<QuadId> = self.model.mesh.quads.pairs().map(|(id, _)| id).collect();
        for id in ids {
            if self.part_of[id.index()].is_some() || self.model.section(id).solid.material.linear() {
                continue;
            }
            let nodes = &self.model.mesh.quads[id].nodes;
            let then = self.strains(id, &assemble::moved(&self.start.displacements, nodes));
            let at = self.strains(id, &assemble::moved(&now, nodes));
            if self.flows(id, &then, &at, self.foresight.max(1.0)) {
                missed |= self.flows(id, &then, &at, 1.0);
                self.watch_quad(id)?;
            }
        }
        Ok(missed)
    }

    /// Strains at the points of a quadrilateral whose corners are displaced by `u`, incompatible modes left out.
    fn strains(&self, id: QuadId, u: &[f64; 8]) -> [Four; 4] {
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

/// A quadrilateral that a scan looks at.
struct Scanned {
    id: QuadId,
    /// Equations of its components.
    equations: [u32; 8],
    /// Derivatives of the bilinear functions at its centre [1/m].
    slopes: [[f64; 4]; 2],
    /// Largest measures so far, and the displacements of its corners there.
    most: [(f64, [f64; 8]); 3],
}

impl Scanned {
    fn new(model: &Model, id: QuadId) -> Scanned {
        let nodes = model.mesh.quads[id].nodes;
        let equations = std::array::from_fn(|i| model.dofs().equation(dof(nodes[i / 2], i % 2)));
        let samples = element::sample(&model.corners(id));
        let mean = |of: &dyn Fn(usize) -> f64| 0.25 * (0..4).map(of).sum::<f64>();
        let dx = std::array::from_fn(|a| mean(&|k| samples[k].dx[a]));
        let dy = std::array::from_fn(|a| mean(&|k| samples[k].dy[a]));
        Scanned { id, equations, slopes: [dx, dy], most: [(0.0, [0.0; 8]); 3] }
    }

    fn see(&mut self, moved: &[f64]) {
        let u: [f64; 8] = self.equations.map(|e| if e == HELD { 0.0 } else { moved[e as usize] });
        let (mut xx, mut yy, mut xy) = (0.0, 0.0, 0.0);
        for a in 0..4 {
            xx += self.slopes[0][a] * u[2 * a];
            yy += self.slopes[1][a] * u[2 * a + 1];
            xy += self.slopes[1][a] * u[2 * a] + self.slopes[0][a] * u[2 * a + 1];
        }
        let sheared = ((xx - yy) * (xx - yy) + xy * xy).sqrt();
        for (most, measure) in self.most.iter_mut().zip([sheared, xx + yy, sheared + xx + yy]) {
            if measure > most.0 {
                *most = (measure, u);
            }
        }
    }
}
