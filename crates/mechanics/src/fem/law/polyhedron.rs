//! The way back to a polyhedron in principal stresses: its faces, edges and corners.
//!
//! A trial stress returns by the flow of the faces it ends on, each forward (Koiter 1953). For associated flow that is the
//! closest point in the energy of elastic strain, and there is exactly one. Where flow is not associated, corners draw in what no
//! face or edge takes, as in Clausen, Damkilde, Andersen (2006).

use super::elastic::Elastic;
use super::principal::Principal;
use super::response::{Four, Memory, Response};
use super::three::{Matrix, Three, dot, hooke, inverse, times, transposed_times};

/// A plane bound in principal stresses: `normal · stress ≤ bound`, flow along `flow`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Face {
    pub(super) normal: Three,
    pub(super) flow: Three,
    pub(super) bound: f64,
}

impl Face {
    pub(super) fn excess(&self, stress: &Three) -> f64 {
        dot(&self.normal, stress) - self.bound
    }
}

/// The three bounds σ ≤ `strength` of a cut-off in tension (Rankine).
pub(super) fn tension(strength: f64) -> [Face; 3] {
    std::array::from_fn(|i| {
        let normal: Three = std::array::from_fn(|j| f64::from(u8::from(i == j)));
        Face { normal, flow: normal, bound: strength }
    })
}

/// The answer of a law whose strength is a polyhedron.
pub(super) fn respond(elastic: &Elastic, strain: &Four, old: &Memory, faces: &[Face]) -> Response {
    let trial = elastic.trial(strain, old);
    let principal = Principal::of(&trial);
    let Some(returned) = back(elastic, &principal.stress, faces) else { return elastic.holds(trial, old) };
    let (stress, tangent) = principal.back(elastic, &returned.stress, &returned.tangent);
    elastic.softened(strain, old, stress, tangent)
}

/// Where the way back ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Returned {
    pub(super) stress: Three,
    /// How principal stresses follow principal strains [Pa].
    pub(super) tangent: Matrix,
}

/// The returned stress; none where the trial is admissible.
pub(super) fn back(elastic: &Elastic, trial: &Three, faces: &[Face]) -> Option<Returned> {
    let size = faces.iter().fold(0.0, |size: f64, face| {
        let reach: f64 = (0..3).map(|i| (face.normal[i] * trial[i]).abs()).sum();
        size.max(reach).max(face.bound.abs())
    });
    let rounding = 1e-12 * size;
    if !(worst(faces, trial) > 0.1 * rounding) {
        return None;
    }
    let hooke = hooke(elastic);
    // Should rounding leave none within it, the one that comes nearest is the answer: there is always one.
    let mut nearest: Option<(f64, Returned)> = None;
    let mut judge = |stress: Three, tangent: &dyn Fn() -> Matrix, flaw: f64| {
        let flaw = flaw.max(worst(faces, &stress));
        if nearest.is_none_or(|(least, _)| flaw < least) {
            nearest = Some((flaw, Returned { stress, tangent: tangent() }));
        }
        flaw <= rounding
    };
    for (i, face) in faces.iter().enumerate() {
        if face.excess(trial) <= 0.0 {
            continue;
        }
        let push = times(&hooke, &face.flow);
        let resistance = dot(&face.normal, &push);
        let amount = face.excess(trial) / resistance;
        let stress = std::array::from_fn(|c| trial[c] - amount * push[c]);
        if judge(stress, &|| on_face(&hooke, &faces[i]), 0.0) {
            return nearest.map(|(_, returned)| returned);
        }
    }
    for i in 0..faces.len() {
        for j in 0..i {
            let Some((amounts, stress)) = to_edge(&hooke, trial, &faces[j], &faces[i]) else { continue };
            let backward = amounts.iter().fold(0.0, |flaw: f64, amount| flaw.max(-amount * elastic.shear()));
            let (normals, flows) = ([faces[j].normal, faces[i].normal], [faces[j].flow, faces[i].flow]);
            if judge(stress, &|| less_two(&hooke, &normals, &flows, PARALLEL), backward) {
                return nearest.map(|(_, returned)| returned);
            }
        }
    }
    if let Some(stress) = nearest_corner(elastic, trial, faces, rounding) {
        return Some(Returned { stress, tangent: [[0.0; 3]; 3] });
    }
    nearest.map(|(_, returned)| returned)
}

/// How far a stress lies beyond the faces, or its principal values out of order: the faces stand for their mirror images too.
fn worst(faces: &[Face], stress: &Three) -> f64 {
    let order = (stress[1] - stress[0]).max(stress[2] - stress[1]);
    faces.iter().fold(order, |worst, face| worst.max(face.excess(stress)))
}

fn on_face(hooke: &Matrix, face: &Face) -> Matrix {
    let push = times(hooke, &face.flow);
    let feel = transposed_times(hooke, &face.normal);
    let resistance = dot(&face.normal, &push);
    std::array::from_fn(|a| std::array::from_fn(|b| hooke[a][b] - push[a] * feel[b] / resistance))
}

/// How a flow along two directions answers two excesses: what it pushes, and its inverse resistance; none where they are parallel to
/// within a share `least`.
fn two(stiff: &Matrix, normals: &[Three; 2], flows: &[Three; 2], least: f64) -> Option<([Three; 2], [[f64; 2]; 2])> {
    let push = flows.map(|flow| times(stiff, &flow));
    let [[a, b], [c, d]] = normals.map(|normal| push.map(|push| dot(&normal, &push)));
    let determinant = a * d - b * c;
    if !(determinant.abs() > least * (a * d).abs()) {
        return None;
    }
    Some((push, [[d / determinant, -b / determinant], [-c / determinant, a / determinant]]))
}

/// The stiffness that a flow along two directions leaves: none where they are parallel to within a share `least`.
pub(super) fn less_two(stiff: &Matrix, normals: &[Three; 2], flows: &[Three; 2], least: f64) -> Matrix {
    let Some((push, inverse)) = two(stiff, normals, flows, least) else { return [[0.0; 3]; 3] };
    let feel = normals.map(|normal| transposed_times(stiff, &normal));
    let taken = |a: usize, b: usize| -> f64 {
        (0..2).map(|i| (0..2).map(|j| push[i][a] * inverse[i][j] * feel[j][b]).sum::<f64>()).sum()
    };
    std::array::from_fn(|a| std::array::from_fn(|b| stiff[a][b] - taken(a, b)))
}

/// Share of their stiffness to within which two faces count as parallel.
const PARALLEL: f64 = 1e-12;

fn to_edge(hooke: &Matrix, trial: &Three, one: &Face, two: &Face) -> Option<([f64; 2], Three)> {
    let (push, inverse) = self::two(hooke, &[one.normal, two.normal], &[one.flow, two.flow], PARALLEL)?;
    let excess = [one.excess(trial), two.excess(trial)];
    let amounts = inverse.map(|row| row[0] * excess[0] + row[1] * excess[1]);
    let stress = std::array::from_fn(|c| trial[c] - amounts[0] * push[0][c] - amounts[1] * push[1][c]);
    Some((amounts, stress))
}

/// The admissible corner nearest to the trial in the energy of elastic strain.
fn nearest_corner(elastic: &Elastic, trial: &Three, faces: &[Face], rounding: f64) -> Option<Three> {
    let mut best: Option<(f64, Three)> = None;
    for i in 0..faces.len() {
        for j in 0..i {
            for k in 0..j {
                let three = [&faces[k], &faces[j], &faces[i]];
                let Some(inverse) = inverse(&three.map(|face| face.normal)) else { continue };
                let corner = times(&inverse, &three.map(|face| face.bound));
                if worst(faces, &corner) > rounding {
                    continue;
                }
                let way: Three = std::array::from_fn(|c| trial[c] - corner[c]);
                let sum: f64 = way.iter().sum();
                let energy = (1.0 + elastic.ratio) * dot(&way, &way) - elastic.ratio * sum * sum;
                if best.is_none_or(|(least, _)| energy < least) {
                    best = Some((energy, corner));
                }
            }
        }
    }
    best.map(|(_, corner)| corner)
}
