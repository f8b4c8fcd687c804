//! Reactions, and stresses at nodes and at any place.

use super::assemble::assemble;
use super::element::{corner_values, weights};
use super::law::Four;
use super::model::Model;
use super::state::State;
use super::workspace::Workspace;
use crate::ids::{Id, NodeId, QuadId, ZoneId};
use crate::plane::{Vec2, vec2};
use std::collections::BTreeMap;

/// Stress at the nodes of each zone: elements of one zone are averaged, those of different zones are not.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Recovered {
    /// Stress [Pa] by zone and node.
    pub stress: BTreeMap<(ZoneId, NodeId), Four>,
}

/// Forces [N/m] that the supports exert, by component; zero at free components, and not numbers where an element has no answer.
pub fn reactions(model: &Model, work: &mut Workspace, state: &State) -> Vec<f64> {
    work.take(state);
    if assemble(model, work, state).is_err() {
        return vec![f64::NAN; state.forces.len()];
    }
    let dofs = model.dofs();
    let of = |component: usize| match dofs.held(component) {
        true => work.internal[component] - state.forces[component],
        false => 0.0,
    };
    (0..dofs.count()).map(of).collect()
}

/// Stress of an element at a place of its parent square, bilinear through its points of integration.
fn stress_in(state: &State, quad: QuadId, place: [f64; 2]) -> Four {
    let shares = corner_values(place);
    let points = &state.points[4 * quad.index()..4 * quad.index() + 4];
    let mut stress = [0.0; 4];
    for (share, point) in shares.iter().zip(points) {
        for (sum, value) in stress.iter_mut().zip(point.stress) {
            *sum += share * value;
        }
    }
    stress
}

/// Extrapolates stresses to the corners of the elements and averages them at the nodes of each zone.
pub fn recover(model: &Model, state: &State) -> Recovered {
    const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let mut sums: BTreeMap<(ZoneId, NodeId), (Four, f64)> = BTreeMap::new();
    for (id, quad) in model.mesh.quads.pairs() {
        for (node, place) in quad.nodes.iter().zip(CORNERS) {
            let stress = stress_in(state, id, place);
            let (sum, count) = sums.entry((quad.zone, *node)).or_default();
            sum.iter_mut().zip(stress).for_each(|(sum, value)| *sum += value);
            *count += 1.0;
        }
    }
    let mean = |(key, (sum, count)): ((ZoneId, NodeId), (Four, f64))| (key, sum.map(|value| value / count));
    Recovered { stress: sums.into_iter().map(mean).collect() }
}

/// Stress [Pa] at a place of a quadrilateral before anything moved; `None` where the place lies outside it.
pub fn stress_at(model: &Model, state: &State, quad: QuadId, place: Vec2) -> Option<Four> {
    parent(&model.corners(quad), place).map(|inside| stress_in(state, quad, inside))
}

/// Coordinates of a place on the parent square, by Newton's method.
fn parent(corners: &[Vec2; 4], place: Vec2) -> Option<[f64; 2]> {
    const SLACK: f64 = 1e-9;
    let at = |[xi, eta]: [f64; 2]| {
        weights([xi, eta]).iter().zip(corners).fold(Vec2::ZERO, |sum, (weight, corner)| sum + *corner * *weight)
    };
    let mut inside = [0.0, 0.0];
    for _ in 0..30 {
        let [xi, eta] = inside;
        let miss = place - at(inside);
        // The map is linear along each parent axis, so that these differences are its derivatives.
        let along_xi = (at([1.0, eta]) - at([-1.0, eta])) * 0.5;
        let along_eta = (at([xi, 1.0]) - at([xi, -1.0])) * 0.5;
        let area = along_xi.cross(along_eta);
        if !(area.abs() > 0.0) {
            return None;
        }
        let step = vec2(miss.cross(along_eta) / area, along_xi.cross(miss) / area);
        inside = [xi + step.x, eta + step.y];
        if step.norm() < 1e-14 {
            break;
        }
    }
    let within = |x: f64| x.abs() <= 1.0 + SLACK;
    (within(inside[0]) && within(inside[1])).then_some(inside)
}
