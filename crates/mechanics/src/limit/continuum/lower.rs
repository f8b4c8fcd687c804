//! The lower bound: stresses that vary in a straight line over each triangle and may jump from one to the next, in equilibrium
//! everywhere and nowhere beyond strength (Lyamin and Sloan 2002; Makrodimopoulos and Martin 2006).
//!
//! Equilibrium inside a triangle is two equations, for stresses are linear; tractions on an edge agree wherever they agree at its ends;
//! strength is convex, so that corners within it hold the whole triangle. Nothing is approximated but the shape of the field.

use super::conic::{Affine, Conic, Ending, WORTH};
use super::mesh::Mesh;
use super::model::Panel;
use super::setting::{Base, Question, Setting};
use super::sideways::{Sideways, Weights, bear, linear};
use super::strengths::Strengths;
use crate::plane::{Vec2, vec2};
use crate::watch::CancelToken;
use std::ops::Range;

/// A stress field and the factor of the variable loads that it balances.
#[derive(Debug, Clone, PartialEq)]
pub struct Stresses {
    /// Load factor: what the stresses balance, less what their residuals may be worth.
    pub factor: f64,
    /// Stress (xx, yy, xy) at the corners of each triangle [Pa]; compression negative, water included.
    pub stresses: Vec<[[f64; 3]; 3]>,
    /// Pressure out of the plane at the corners of each triangle that a panel holds [Pa], positive; zero elsewhere.
    pub sideways: Vec<[f64; 3]>,
    /// Forces of the joints of the blocks, of each the compressions, then the shear [N/m].
    pub forces: Vec<f64>,
    /// Largest force out of balance, of triangles, edges and blocks, relative to all loads.
    pub equilibrium_residual: f64,
    /// Largest force by which strength is exceeded, relative to all loads.
    pub yield_violation: f64,
    /// Power of the stresses of each triangle on the motion that the program has for multipliers, in its units: where they are worked hardest.
    pub(super) dissipation: Vec<f64>,
    /// Iterations of the solver.
    pub iterations: u32,
}

/// Forces out of balance and beyond strength, relative to all loads, up to which a field is an answer.
const SOUND: f64 = 1e-6;

/// The gradient of the barycentric coordinate of each corner, times the area [m].
pub(super) fn gradients(corners: [Vec2; 3]) -> [Vec2; 3] {
    [0, 1, 2].map(|k| {
        let (a, b) = (corners[(k + 1) % 3], corners[(k + 2) % 3]);
        vec2(0.5 * (a.y - b.y), 0.5 * (b.x - a.x))
    })
}

/// The traction `s n` of a stress (xx, yy, xy), in x and in y.
fn traction(stress: &[Affine; 3], n: Vec2) -> [Affine; 2] {
    let [xx, yy, xy] = stress;
    [Affine::sum(&[(n.x, xx), (n.y, xy)]), Affine::sum(&[(n.x, xy), (n.y, yy)])]
}

/// Finds the best stress field on a mesh.
pub(super) fn lower(setting: &Setting<'_>, mesh: &Mesh, token: &CancelToken) -> Result<Stresses, Ending> {
    within(setting, mesh, &Strengths::of(setting, mesh), Question::Factor, token)
}

/// The stress field on a mesh that carries the largest share of the permanent loads, up to all; its factor is that share.
pub(super) fn share_carried(setting: &Setting<'_>, mesh: &Mesh, token: &CancelToken) -> Result<Stresses, Ending> {
    within(setting, mesh, &Strengths::of(setting, mesh), Question::Share, token)
}

/// The program of a mesh.
pub(super) struct Asked {
    pub program: Conic,
    base: Base,
    /// At the corners of each triangle.
    stresses: Vec<[[Affine; 3]; 3]>,
    /// The variables and the equations that the strength of each triangle takes.
    own: Vec<[Range<usize>; 2]>,
    /// Of triangles beside panels: the panel, the pressures at the corners, what they add to its resultant and moment.
    pressures: Vec<(usize, [usize; 3], Weights)>,
}

/// What is asked within strengths that vary from corner to corner.
pub(super) fn asked(setting: &Setting<'_>, mesh: &Mesh, strengths: &Strengths, question: Question) -> Asked {
    let mut program = Conic::default();
    let base = setting.begin(&mut program, question);
    let [permanent, variable] = &base.loads;
    let unit = setting.force;
    let panels = &setting.soil.panels;
    let mut pressures: Vec<(usize, [usize; 3], Weights)> = Vec::new();
    let mut own = Vec::with_capacity(mesh.triangles.len());
    let stresses: Vec<[[Affine; 3]; 3]> = (0..mesh.triangles.len())
        .map(|t| {
            let before = program.size();
            let (corners, soils, sideways) = (mesh.corners(t), &strengths.soils[t], strengths.sideways[t]);
            let held = sideways.map(|s| (s, [0; 3].map(|_| program.positive())));
            if let Some((s, variables)) = held {
                pressures.push((s.panel, variables, linear(mesh, t, &panels[s.panel])));
            }
            let stress = [0, 1, 2].map(|k| {
                let pore = permanent.times(setting.pore(corners[k]));
                soils[k].stress(&mut program, &pore, unit, held.map(|(s, variables)| (s, variables[k])))
            });
            own.push([0, 1].map(|i| before[i]..program.size()[i]));
            stress
        })
        .collect();
    bear(&mut program, panels, &pressures, unit);
    for (t, stress) in stresses.iter().enumerate() {
        let soil = strengths.soils[t][0];
        // As stresses, not as forces: what small triangles and edges leave out of balance is then as small as anywhere.
        let (area, size) = (mesh.area(t), mesh.area(t).sqrt());
        let gradients = gradients(mesh.corners(t)).map(|g| g * (1.0 / size));
        for (axis, weights) in
            [[soil.weight.x, soil.variable_weight.x], [soil.weight.y, soil.variable_weight.y]].into_iter().enumerate()
        {
            let row = program.equation(0.0);
            for (s, g) in stress.iter().zip(gradients) {
                program.add(row, g.x, &s[if axis == 0 { 0 } else { 2 }]);
                program.add(row, g.y, &s[if axis == 0 { 2 } else { 1 }]);
            }
            program.add(row, area / size * weights[0], permanent);
            program.add(row, area / size * weights[1], variable);
        }
    }
    for e in 0..mesh.edges.len() {
        let at = Ends::of(mesh, e);
        let inside = at.corners(mesh, mesh.edges[e].triangle).map(|k| &stresses[mesh.edges[e].triangle][k]);
        if let Some(other) = mesh.edges[e].other {
            let outside = at.corners(mesh, other).map(|k| &stresses[other][k]);
            for k in 0..2 {
                let (a, b) = (traction(inside[k], at.normal), traction(outside[k], at.normal));
                for axis in 0..2 {
                    let row = program.equation(0.0);
                    program.add(row, 1.0, &a[axis]);
                    program.add(row, -1.0, &b[axis]);
                }
            }
            continue;
        }
        let (Some((block, _)), Some(contacts)) = (setting.body(mesh, e), strengths.contacts[e]) else {
            let [p, v] = setting.tractions(mesh, e);
            for stress in inside {
                let t = traction(stress, at.normal);
                for (axis, loads) in [[p.x, v.x], [p.y, v.y]].into_iter().enumerate() {
                    let row = program.equation(0.0);
                    program.add(row, 1.0, &t[axis]);
                    program.add(row, -loads[0], permanent);
                    program.add(row, -loads[1], variable);
                }
            }
            continue;
        };
        let t = inside.map(|stress| traction(stress, at.normal));
        for k in 0..2 {
            let pressure = Affine::sum(&[(-at.normal.x, &t[k][0]), (-at.normal.y, &t[k][1])]);
            let along = at.normal.left();
            let shear = Affine::sum(&[(along.x, &t[k][0]), (along.y, &t[k][1])]);
            contacts[k].limit(&mut program, &pressure, &shear, &permanent.times(setting.pore(at.points[k])), unit);
        }
        if let Some(block) = block {
            // Force and moment of a traction that is linear along the edge.
            for (k, point) in at.thirds().into_iter().enumerate() {
                let rows = setting.rows_of(block, point);
                for axis in 0..2 {
                    for &(row, v) in &rows[axis] {
                        program.add(row, -0.5 * at.length * v, &t[k][axis]);
                    }
                }
            }
        }
    }
    Asked { program, base, stresses, own, pressures }
}

/// The best stress field within strengths that vary from corner to corner.
pub(super) fn within(
    setting: &Setting<'_>,
    mesh: &Mesh,
    strengths: &Strengths,
    question: Question,
    token: &CancelToken,
) -> Result<Stresses, Ending> {
    let Asked { program, base, stresses, own, pressures } = asked(setting, mesh, strengths, question);
    let unit = setting.force;
    program.answer(token, |found| {
        if !matches!(found.ending, Ending::Solved | Ending::Early) {
            return Err(found.ending);
        }
        let z = &found.variables;
        let scale = if question == Question::Factor { setting.factor_scale } else { 1.0 };
        let values = stresses.iter().map(|s| s.each_ref().map(|s| s.each_ref().map(|a| a.at(z) * unit))).collect();
        let mut beside = pressures.iter().map(|(_, variables, _)| variables.map(|i| z[i] * unit));
        let of = |s: &Option<Sideways>| s.and_then(|_| beside.next()).unwrap_or_default();
        let mut field = Stresses {
            factor: z[base.factor] * scale,
            stresses: values,
            sideways: strengths.sideways.iter().map(of).collect(),
            forces: base.forces.iter().map(|&i| z[i] * unit).collect(),
            equilibrium_residual: 0.0,
            yield_violation: 0.0,
            dissipation: own.iter().map(|[variables, equations]| program.power(variables, equations, &found)).collect(),
            iterations: found.iterations,
        };
        let loads = if question == Question::Factor { [1.0, field.factor] } else { [field.factor, 0.0] };
        (field.equilibrium_residual, field.yield_violation) = check(setting, mesh, strengths, &field, loads);
        field.factor -= WORTH * found.errors[0] * scale;
        // What residuals are worth below zero is zero; a load that must pull the other way is told as it is.
        if field.factor < 0.0 && field.factor >= -SOUND * scale {
            field.factor = 0.0;
        }
        let sound = field.equilibrium_residual <= SOUND && field.yield_violation <= SOUND;
        if sound { Ok(field) } else { Err(Ending::Unknown) }
    })
}

/// The ends of an edge as seen from its own triangle.
pub(super) struct Ends {
    pub points: [Vec2; 2],
    ids: [usize; 2],
    pub length: f64,
    /// Out of its own triangle.
    pub normal: Vec2,
}

impl Ends {
    pub(super) fn of(mesh: &Mesh, edge: usize) -> Ends {
        let points = mesh.ends(edge);
        let run = points[1] - points[0];
        Ends { points, ids: mesh.edges[edge].ends, length: run.norm(), normal: run.right().unit() }
    }
    /// The corners of a triangle at the two ends.
    pub(super) fn corners(&self, mesh: &Mesh, triangle: usize) -> [usize; 2] {
        self.ids.map(|id| mesh.triangles[triangle].iter().position(|&p| p == id).unwrap_or(0))
    }
    /// Where the resultants of tractions act that fall from one at an end to zero at the other.
    pub(super) fn thirds(&self) -> [Vec2; 2] {
        let [a, b] = self.points;
        [(a * 2.0 + b) * (1.0 / 3.0), (a + b * 2.0) * (1.0 / 3.0)]
    }
}

/// `s n` of a stress.
pub(super) fn push([xx, yy, xy]: [f64; 3], n: Vec2) -> Vec2 {
    vec2(xx * n.x + xy * n.y, xy * n.x + yy * n.y)
}

/// By how much pressures out of the plane exceed what panels bear, and stresses what these pressures allow [N/m].
fn beyond_panels(setting: &Setting<'_>, mesh: &Mesh, strengths: &Strengths, field: &Stresses, share: f64) -> f64 {
    let panels = &setting.soil.panels;
    let mut borne = vec![[0.0; 2]; panels.len()];
    let mut beyond = 0.0f64;
    for (t, sideways) in strengths.sideways.iter().enumerate() {
        let Some(sideways) = sideways else { continue };
        let size = mesh.area(t).sqrt();
        let weights = linear(mesh, t, &panels[sideways.panel]);
        for (k, at) in mesh.corners(t).into_iter().enumerate() {
            let pressure = field.sideways[t][k];
            let excess = sideways.excess(field.stresses[t][k], share * setting.pore(at), pressure);
            beyond = beyond.max(size * excess.max(-pressure));
            borne[sideways.panel][0] += weights[k][0] * pressure;
            borne[sideways.panel][1] += weights[k][1] * pressure;
        }
    }
    let over = |(panel, [force, moment]): (&Panel, &[f64; 2])| (force - panel.force).max(moment - panel.moment);
    panels.iter().zip(&borne).map(over).fold(beyond, f64::max)
}

/// Checks a field from its numbers alone: the largest force out of balance and the largest force beyond strength, relative to all loads, of which
/// it carries so many times the permanent and the variable ones.
pub(super) fn check(
    setting: &Setting<'_>,
    mesh: &Mesh,
    strengths: &Strengths,
    field: &Stresses,
    [share, variable]: [f64; 2],
) -> (f64, f64) {
    let (mut residual, mut beyond) = (0.0f64, beyond_panels(setting, mesh, strengths, field, share));
    for (t, stress) in field.stresses.iter().enumerate() {
        let soils = &strengths.soils[t];
        let mut sum = (soils[0].weight * share + soils[0].variable_weight * variable) * mesh.area(t);
        for (s, g) in stress.iter().zip(gradients(mesh.corners(t))) {
            sum += push(*s, g);
        }
        residual = residual.max(sum.norm());
        let size = mesh.area(t).sqrt();
        for ((s, at), soil) in stress.iter().zip(mesh.corners(t)).zip(soils) {
            beyond = beyond.max(size * soil.excess(*s, share * setting.pore(at)));
        }
    }
    let eq = &setting.equilibrium;
    let loads = (0..eq.rows)
        .map(|i| share * eq.permanent[i] * eq.force + eq.variable[i] * eq.force / eq.factor_scale * variable)
        .collect();
    let mut blocks = eq.balance(loads, &field.forces);
    for e in 0..mesh.edges.len() {
        let at = Ends::of(mesh, e);
        let of = |t: usize| at.corners(mesh, t).map(|k| push(field.stresses[t][k], at.normal));
        let inside = of(mesh.edges[e].triangle);
        if let Some(other) = mesh.edges[e].other {
            let outside = of(other);
            (0..2).for_each(|k| residual = residual.max(at.length * (inside[k] - outside[k]).norm()));
            continue;
        }
        match setting.body(mesh, e).zip(strengths.contacts[e]) {
            None => {
                let [p, v] = setting.tractions(mesh, e);
                let wanted = p * share + v * variable;
                inside.iter().for_each(|t| residual = residual.max(at.length * (*t - wanted).norm()));
            }
            Some(((block, _), contacts)) => {
                for k in 0..2 {
                    let (pressure, shear) = (-inside[k].dot(at.normal), inside[k].dot(at.normal.left()));
                    beyond =
                        beyond.max(at.length * contacts[k].excess(pressure, shear, share * setting.pore(at.points[k])));
                    let Some(block) = block else { continue };
                    let [x, y] = setting.rows_of(block, at.thirds()[k]);
                    x.iter().for_each(|&(i, v)| blocks[i] -= 0.5 * at.length * v * inside[k].x);
                    y.iter().for_each(|&(i, v)| blocks[i] -= 0.5 * at.length * v * inside[k].y);
                }
            }
        }
    }
    let residual = blocks.iter().fold(residual, |m, r| m.max(r.abs()));
    let scaled: Vec<f64> = field.forces.iter().map(|f| f / eq.force).collect();
    let joints = crate::limit::bounds::yield_violation(eq, &scaled) * eq.force;
    let all = (setting.loads[0] + variable.abs() * setting.loads[1]).max(f64::MIN_POSITIVE);
    (residual / all, beyond.max(joints) / all)
}
