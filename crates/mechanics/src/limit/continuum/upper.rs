//! The upper bound: velocities that are quadratic over each triangle and continuous from one to the next, and may jump where soil meets
//! a body (Makrodimopoulos and Martin 2007).
//!
//! Strain rates are then linear over a triangle whose edges are straight, and a flow rule that holds at its corners holds throughout, for
//! what it allows is convex. On an edge that touches a body the jump is quadratic; it is held at its three control points (Bernstein's), of
//! which it is a mean everywhere. In both the dissipation that is counted is no less than that of the motion.

use super::conic::{Affine, Conic, Ending, WORTH};
use super::lower::{Ends, gradients};
use super::mesh::Mesh;
use super::model::Panel;
use super::setting::{Question, Setting};
use super::sideways::{Sideways, Weights, bear, by_corners};
use crate::plane::{Vec2, vec2};
use crate::watch::CancelToken;

/// A motion and the factor of the variable loads at which it needs no more work than they do.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Load factor, recomputed from the velocities, and what their violations of the flow rule may be worth.
    pub factor: f64,
    /// Power that the solver's errors may be worth [W/m]: counted in the factor.
    pub(super) doubt: f64,
    /// Velocity of each node of the mesh [m/s], scaled so that the fastest point moves by 1 m/s.
    pub velocities: Vec<Vec2>,
    /// What multiplies the equations of the blocks, scaled alike.
    pub blocks: Vec<f64>,
    /// How each panel beside the plane gives way: velocity [m/s] and rotation [rad/s] per metre of soil across, scaled alike.
    pub panels: Vec<[f64; 2]>,
    /// Power dissipated in each triangle [W/m], and what is dissipated where it touches bodies.
    pub dissipation: Vec<f64>,
    /// Power of the variable loads at a load factor of one [W/m].
    pub power: f64,
    /// Largest velocity that flow rules do not allow, relative to the fastest point.
    pub flow_violation: f64,
    /// Iterations of the solver.
    pub iterations: u32,
}

/// Velocities against the flow rule, relative to the fastest, up to which a motion is an answer.
pub(super) const SOUND: f64 = 1e-5;

/// Gradients of the six shape functions at a corner of a triangle, times its area [m].
fn shapes(gradients: [Vec2; 3], corner: usize) -> [Vec2; 6] {
    let mut of = [Vec2::ZERO; 6];
    for k in 0..3 {
        of[k] = if k == corner { gradients[k] * 3.0 } else { -gradients[k] };
        // The middle of the edge opposite to `k`; it joins the other two.
        let other = (0..3).find(|&j| j != k && j != corner);
        if let (true, Some(other)) = (k != corner, other) {
            of[3 + k] = gradients[other] * 4.0;
        }
    }
    of
}

/// Pore pressures for the corners of a triangle [Pa] with which the sum over the corners, a third of the area each, is the integral of pore pressure
/// times the rate of volume: both are linear.
fn pores(setting: &Setting<'_>, corners: [Vec2; 3]) -> [f64; 3] {
    let at = corners.map(|c| setting.pore(c));
    at.map(|own| 0.25 * (at[0] + at[1] + at[2] + own))
}

/// The same for the control points of an edge, along which the jump is quadratic.
fn pores_along(setting: &Setting<'_>, ends: [Vec2; 2]) -> [f64; 3] {
    let [a, b] = ends.map(|c| setting.pore(c));
    [0.25 * (3.0 * a + b), 0.5 * (a + b), 0.25 * (a + 3.0 * b)]
}

/// The nodes of an edge: its ends, and its middle.
fn nodes(mesh: &Mesh, edge: usize) -> [usize; 3] {
    let [a, b] = mesh.edges[edge].ends;
    [a, mesh.points.len() + edge, b]
}

/// Control points of an edge: where they are, and as sums of its nodes' values.
fn control(mesh: &Mesh, edge: usize) -> [(Vec2, [f64; 3]); 3] {
    let [a, b] = mesh.ends(edge);
    [(a, [1.0, 0.0, 0.0]), ((a + b) * 0.5, [-0.5, 2.0, -0.5]), (b, [0.0, 0.0, 1.0])]
}

/// Where they are, and their velocities.
pub(super) fn moving(mesh: &Mesh, edge: usize, velocities: &[Vec2]) -> [(Vec2, Vec2); 3] {
    let sum =
        |weights| nodes(mesh, edge).into_iter().zip(weights).fold(Vec2::ZERO, |sum, (n, w)| sum + velocities[n] * w);
    control(mesh, edge).map(|(point, weights)| (point, sum(weights)))
}

/// The program of a mesh.
pub(super) struct Asked {
    pub program: Conic,
    /// Where the factor stands.
    factor: usize,
    /// The equations of each node, in x and in y.
    rows: Vec<usize>,
    /// The equations of each panel beside the plane: of its resultant and of its moment.
    panels: Vec<[usize; 2]>,
}

pub(super) fn asked(setting: &Setting<'_>, mesh: &Mesh, question: Question) -> Asked {
    let mut program = Conic::default();
    let base = setting.begin(&mut program, question);
    let [permanent, variable] = &base.loads;
    let unit = setting.force;
    // Two equations for each node, after what slacks have added: their numbers are kept.
    let rows: Vec<usize> = (0..2 * mesh.nodes()).map(|_| program.equation(0.0)).collect();
    let panels = &setting.soil.panels;
    let mut pressures: Vec<(usize, [usize; 3], Weights)> = Vec::new();
    for t in 0..mesh.triangles.len() {
        let soil = setting.soil_of(mesh, t);
        let held = Sideways::of(setting, mesh, t, &soil).map(|s| (s, [0; 3].map(|_| program.positive())));
        if let Some((s, variables)) = held {
            pressures.push((s.panel, variables, by_corners(mesh, t, &panels[s.panel])));
        }
        let (corners, nodes, third) = (mesh.corners(t), mesh.nodes_of(t), mesh.area(t) / 3.0);
        let gradients = gradients(corners);
        let pores = pores(setting, corners);
        for k in 0..3 {
            let beside = held.map(|(s, variables)| (s, variables[k]));
            let [xx, yy, xy] = soil.stress(&mut program, &permanent.times(pores[k]), unit, beside);
            for (node, g) in nodes.into_iter().zip(shapes(gradients, k)) {
                if g == Vec2::ZERO {
                    continue;
                }
                // The gradient holds the area, of which a third belongs to the corner.
                let g = g * (-1.0 / 3.0);
                program.add(rows[2 * node], g.x, &xx);
                program.add(rows[2 * node], g.y, &xy);
                program.add(rows[2 * node + 1], g.y, &yy);
                program.add(rows[2 * node + 1], g.x, &xy);
            }
        }
        for node in nodes.into_iter().skip(3) {
            for (axis, [p, v]) in [[soil.weight.x, soil.variable_weight.x], [soil.weight.y, soil.variable_weight.y]]
                .into_iter()
                .enumerate()
            {
                program.add(rows[2 * node + axis], third * p, permanent);
                program.add(rows[2 * node + axis], third * v, variable);
            }
        }
    }
    let panels = bear(&mut program, panels, &pressures, unit);
    for e in (0..mesh.edges.len()).filter(|&e| mesh.edges[e].other.is_none()) {
        let (at, nodes) = (Ends::of(mesh, e), nodes(mesh, e));
        let Some((block, contact)) = setting.body(mesh, e) else {
            let [p, v] = setting.tractions(mesh, e);
            for (node, weight) in nodes.into_iter().zip([1.0, 4.0, 1.0]) {
                let length = at.length * weight / 6.0;
                for (axis, [p, v]) in [[p.x, v.x], [p.y, v.y]].into_iter().enumerate() {
                    program.add(rows[2 * node + axis], length * p, permanent);
                    program.add(rows[2 * node + axis], length * v, variable);
                }
            }
            continue;
        };
        for ((point, weights), pore) in control(mesh, e).into_iter().zip(pores_along(setting, at.points)) {
            let [pressure, shear] = contact.stress(&mut program, &permanent.times(pore), unit);
            // Traction on the soil.
            let (n, s) = (at.normal, at.normal.left());
            let traction =
                [Affine::sum(&[(-n.x, &pressure), (s.x, &shear)]), Affine::sum(&[(-n.y, &pressure), (s.y, &shear)])];
            let third = at.length / 3.0;
            for axis in 0..2 {
                for (node, weight) in nodes.into_iter().zip(weights) {
                    program.add(rows[2 * node + axis], third * weight, &traction[axis]);
                }
                if let Some(block) = block {
                    for &(row, v) in &setting.rows_of(block, point)[axis] {
                        program.add(row, -third * v, &traction[axis]);
                    }
                }
            }
        }
    }
    Asked { program, factor: base.factor, rows, panels }
}

/// Finds the best motion on a mesh.
pub(super) fn upper(setting: &Setting<'_>, mesh: &Mesh, token: &CancelToken) -> Result<Motion, Ending> {
    let Asked { program, rows, panels, .. } = asked(setting, mesh, Question::Factor);
    program.answer(token, |found| {
        if !matches!(found.ending, Ending::Solved | Ending::Early) {
            return Err(found.ending);
        }
        let blocks: Vec<f64> = found.multipliers[..setting.equilibrium.rows].iter().map(|x| -x).collect();
        let velocity = |k: usize| vec2(-found.multipliers[rows[2 * k]], -found.multipliers[rows[2 * k + 1]]);
        let velocities: Vec<Vec2> = (0..mesh.nodes()).map(velocity).collect();
        let panels = panels.iter().map(|both| both.map(|row| found.multipliers[row].max(0.0))).collect();
        let (mut motion, _) = work(setting, mesh, velocities, blocks, panels);
        let doubt = WORTH * found.errors[1] * setting.factor_scale;
        motion.factor += doubt;
        motion.doubt = doubt * motion.power;
        motion.iterations = found.iterations;
        let sound = motion.flow_violation <= SOUND && motion.factor.is_finite() && motion.power > 0.0;
        if sound { Ok(motion) } else { Err(Ending::Unknown) }
    })
}

/// No more than this share of the permanent loads is carried; one where no motion says less.
pub(super) fn share(setting: &Setting<'_>, mesh: &Mesh, token: &CancelToken) -> Result<f64, Ending> {
    let Asked { program, factor: share, .. } = asked(setting, mesh, Question::Share);
    program.answer(token, |found| match found.ending {
        Ending::Solved => Ok((found.variables[share] + WORTH * (found.errors[0] + found.errors[1])).clamp(0.0, 1.0)),
        other => Err(other),
    })
}

/// Strain rates (xx, yy, shear angle) at the corners of a triangle [1/s].
pub(super) fn strain_rates(mesh: &Mesh, triangle: usize, velocities: &[Vec2]) -> [[f64; 3]; 3] {
    let (gradients, area, nodes) = (gradients(mesh.corners(triangle)), mesh.area(triangle), mesh.nodes_of(triangle));
    [0, 1, 2].map(|k| {
        let mut rates = [0.0; 3];
        for (node, g) in nodes.into_iter().zip(shapes(gradients, k)) {
            let v = velocities[node] * (1.0 / area);
            rates[0] += g.x * v.x;
            rates[1] += g.y * v.y;
            rates[2] += g.y * v.x + g.x * v.y;
        }
        rates
    })
}

/// Control points of the jump on an edge that touches a body: where they are, and the soil's velocity towards the body and along it.
pub(super) fn jumps(
    setting: &Setting<'_>,
    mesh: &Mesh,
    edge: usize,
    velocities: &[Vec2],
    blocks: &[f64],
) -> Vec<(Vec2, f64, f64)> {
    let Some((block, _)) = setting.body(mesh, edge) else { return Vec::new() };
    let at = Ends::of(mesh, edge);
    let of = |(point, soil): (Vec2, Vec2)| {
        let jump = soil - setting.velocity(block, point, blocks);
        (point, jump.dot(at.normal), jump.dot(at.normal.left()))
    };
    moving(mesh, edge, velocities).map(of).to_vec()
}

/// The work equation of a motion, from its velocities alone; and the velocity of its fastest point as it was given.
pub(super) fn work(
    setting: &Setting<'_>,
    mesh: &Mesh,
    velocities: Vec<Vec2>,
    blocks: Vec<f64>,
    panels: Vec<[f64; 2]>,
) -> (Motion, f64) {
    let eq = &setting.equilibrium;
    let mut fastest = velocities.iter().map(|v| v.norm()).fold(f64::MIN_POSITIVE, f64::max);
    fastest = blocks.iter().map(|v| v.abs()).fold(fastest, f64::max);
    let velocities: Vec<Vec2> = velocities.into_iter().map(|v| v * (1.0 / fastest)).collect();
    let blocks: Vec<f64> = blocks.into_iter().map(|v| v / fastest).collect();
    let panels: Vec<[f64; 2]> = panels.into_iter().map(|both| both.map(|v| v / fastest)).collect();
    let (mut dissipation, mut violation) = (vec![0.0; mesh.triangles.len()], 0.0f64);
    let [mut permanent, mut variable] = [0.0; 2];
    for t in 0..mesh.triangles.len() {
        let soil = setting.soil_of(mesh, t);
        let third = mesh.area(t) / 3.0;
        let corners = mesh.corners(t);
        let beside = Sideways::of(setting, mesh, t, &soil);
        let each = strain_rates(mesh, t, &velocities).into_iter().zip(pores(setting, corners)).zip(corners);
        for ((rates, pore), at) in each {
            let (power, wrong) = match &beside {
                None => soil.dissipation(rates, pore),
                Some(sideways) => {
                    let ([slide, tilt], foot) = (panels[sideways.panel], setting.soil.panels[sideways.panel].foot);
                    soil.dissipation_beside(rates, pore, sideways, slide + tilt * (at.y - foot))
                }
            };
            dissipation[t] += third * power;
            violation = violation.max(wrong * mesh.area(t).sqrt());
        }
        for node in mesh.nodes_of(t).into_iter().skip(3) {
            permanent += third * soil.weight.dot(velocities[node]);
            variable += third * soil.variable_weight.dot(velocities[node]);
        }
    }
    for e in (0..mesh.edges.len()).filter(|&e| mesh.edges[e].other.is_none()) {
        let Ends { length, points, .. } = Ends::of(mesh, e);
        if let Some((_, contact)) = setting.body(mesh, e) {
            let each = jumps(setting, mesh, e, &velocities, &blocks).into_iter().zip(pores_along(setting, points));
            for ((_, closing, sliding), pore) in each {
                let (power, wrong) = contact.dissipation(closing, sliding, pore);
                dissipation[mesh.edges[e].triangle] += length / 3.0 * power;
                violation = violation.max(wrong);
            }
            continue;
        }
        let [p, v] = setting.tractions(mesh, e);
        for (node, weight) in nodes(mesh, e).into_iter().zip([1.0, 4.0, 1.0]) {
            permanent += length * weight / 6.0 * p.dot(velocities[node]);
            variable += length * weight / 6.0 * v.dot(velocities[node]);
        }
    }
    // Of the blocks: what their joints dissipate less the work of their permanent loads.
    let joints = crate::limit::bounds::resistance(eq, &blocks);
    violation = violation.max(joints.violation);
    variable += eq.variable.iter().zip(&blocks).map(|(p, u)| p * u).sum::<f64>() * eq.force / eq.factor_scale;
    let resisted = |(panel, [slide, tilt]): (&Panel, &[f64; 2])| panel.force * slide + panel.moment * tilt;
    let held: f64 = setting.soil.panels.iter().zip(&panels).map(resisted).sum();
    let total = dissipation.iter().sum::<f64>() + held + joints.factor * eq.force - permanent;
    let motion = Motion {
        factor: total / variable,
        doubt: 0.0,
        velocities,
        blocks,
        panels,
        dissipation,
        power: variable,
        flow_violation: violation,
        iterations: 0,
    };
    (motion, fastest)
}
