//! Stresses at nodes and at any place, from those at the points of integration.

use mechanics::fem::law::Four;
use mechanics::fem::{Model, State};
use mechanics::ids::{Id, NodeId, QuadId, ZoneId};
use mechanics::plane::{Vec2, vec2};
use std::collections::BTreeMap;

/// Corners of the parent square.
const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Where two-point Gauss quadrature looks.
const GAUSS: f64 = 0.577_350_269_189_625_8;

/// Shape functions at a place of the parent square.
fn weights([xi, eta]: [f64; 2]) -> [f64; 4] {
    CORNERS.map(|[a, b]| 0.25 * (1.0 + a * xi) * (1.0 + b * eta))
}

/// Stress of an element at a place of its parent square, bilinear through its points of integration.
fn stress_in(state: &State, quad: QuadId, place: [f64; 2]) -> Four {
    let shares = weights(place.map(|x| x / GAUSS));
    let points = &state.points[4 * quad.index()..4 * quad.index() + 4];
    let mut stress = [0.0; 4];
    for (share, point) in shares.iter().zip(points) {
        for (sum, value) in stress.iter_mut().zip(point.stress) {
            *sum += share * value;
        }
    }
    stress
}

/// Stress [Pa] at the nodes of each zone, extrapolated to the corners of the elements: those of one zone are averaged, those of
/// different zones are not.
pub(crate) fn recover(model: &Model, state: &State) -> BTreeMap<(ZoneId, NodeId), Four> {
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
    sums.into_iter().map(mean).collect()
}

/// Stress [Pa] at a place of a quadrilateral before anything moved; `None` where the place lies outside it.
pub(crate) fn stress_at(model: &Model, state: &State, quad: QuadId, place: Vec2) -> Option<Four> {
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
