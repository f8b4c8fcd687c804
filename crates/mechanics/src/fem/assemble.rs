//! Internal forces and tangent of the whole, straight into the places of the pattern.

use super::dofs::HELD;
use super::element::{self, Angle, Kept, Sample, sample, turned};
use super::model::Model;
use super::settings::Kinematics;
use super::state::{Point, State};
use super::workspace::Workspace;
use crate::ids::{Id, QuadId};
use crate::plane::Vec2;

/// Computes internal forces, tangent and memories at the displacements that are tried, from the memories of `state`
/// (equations 1 and 2); `None` where the law or the frame of an element has no answer: the step was too long.
pub(super) fn assemble(model: &Model, work: &mut Workspace, state: &State) -> Option<()> {
    work.values.fill(0.0);
    work.skew.fill(0.0);
    work.skewed = false;
    work.loose = 0.0;
    work.internal.fill(0.0);
    work.fresh = false;
    for id in model.mesh.quads.ids() {
        let components = model.components(id);
        let answer = quadrilateral(model, work, id, &components, state)?;
        work.loose = work.loose.hypot(answer.loose);
        let symmetric = model.section(id).solid.material.symmetric();
        add(model, work, id.index(), &components, (&answer.force, &answer.tangent), symmetric);
    }
    springs(model, work, state)
}

/// One quadrilateral, in its own turned frame where displacements are large.
fn quadrilateral(
    model: &Model,
    work: &mut Workspace,
    id: QuadId,
    components: &[usize; 8],
    state: &State,
) -> Option<element::Answer> {
    let (corners, section, index, trial) = (model.corners(id), model.section(id), id.index(), &mut work.trial);
    let u = components.map(|component| trial.displacements[component]);
    let old: &[Point] = &state.points[4 * index..4 * index + 4];
    let kept = Kept {
        points: &mut trial.points[4 * index..4 * index + 4],
        modes: &mut trial.modes[index],
        from: state.modes[index],
        misses: &mut work.misses[index],
    };
    let incompatible = model.incompatible(id);
    let samples = sample(&corners);
    match model.kinematics {
        Kinematics::Small => element::respond(&section.solid, incompatible, &samples, &u, old, kept),
        Kinematics::Large => {
            let frame = Frame::of(&corners, &u)?;
            let mut answer = element::respond(&section.solid, incompatible, &samples, &frame.local, old, kept)?;
            turned(&frame.angle, frame.direction, &frame.positions, (&mut answer.force, &mut answer.tangent), 8);
            Some(answer)
        }
    }
}

/// The frame of an element: it turns by the rotation of the deformation gradient at the centre (equation 9).
pub(super) struct Frame {
    pub angle: Angle<8>,
    /// Cosine and sine of its turn.
    pub direction: [f64; 2],
    /// Where the corners are in it, from the first of them.
    pub positions: [f64; 8],
    /// Their displacements in it.
    pub local: [f64; 8],
}

impl Frame {
    pub(super) fn of(corners: &[Vec2; 4], u: &[f64; 8]) -> Option<Frame> {
        let Sample { dx, dy, .. } = element::centre(corners);
        let mut angle = Angle { along: [2.0, 0.0], slopes: [[0.0; 8]; 2] };
        for a in 0..4 {
            let (x, y) = (u[2 * a], u[2 * a + 1]);
            angle.along[0] += x * dx[a] + y * dy[a];
            angle.along[1] += y * dx[a] - x * dy[a];
            angle.slopes[0][2 * a..2 * a + 2].copy_from_slice(&[dx[a], dy[a]]);
            angle.slopes[1][2 * a..2 * a + 2].copy_from_slice(&[-dy[a], dx[a]]);
        }
        let [cos, sin] = angle.direction()?;
        let (mut positions, mut local) = ([0.0; 8], [0.0; 8]);
        for a in 1..4 {
            let start = corners[a] - corners[0];
            let (x, y) = (start.x + u[2 * a] - u[0], start.y + u[2 * a + 1] - u[1]);
            (positions[2 * a], positions[2 * a + 1]) = (cos * x + sin * y, cos * y - sin * x);
            (local[2 * a], local[2 * a + 1]) = (positions[2 * a] - start.x, positions[2 * a + 1] - start.y);
        }
        Some(Frame { angle, direction: [cos, sin], positions, local })
    }
}

fn springs(model: &Model, work: &mut Workspace, state: &State) -> Option<()> {
    let first = model.mesh.quads.len();
    let large = model.kinematics == Kinematics::Large;
    for (index, spring) in model.springs.iter().enumerate() {
        let law = &model.joints[spring.kind];
        let pull = spring.respond(law, &model.mesh, &work.trial.displacements, large, &state.bonds[index])?;
        let mut components = [0; 12];
        for (n, node) in spring.nodes().enumerate() {
            (components[2 * n], components[2 * n + 1]) = (2 * node.index(), 2 * node.index() + 1);
        }
        let count = 2 * spring.nodes().len();
        work.trial.bonds[index] = pull.bond;
        add(model, work, first + index, &components[..count], (&pull.force, &pull.tangent), law.symmetric());
    }
    Some(())
}

/// Adds an element's forces and tangent to those of the whole.
#[inline]
fn add<const M: usize>(
    model: &Model,
    work: &mut Workspace,
    element: usize,
    components: &[usize],
    (force, tangent): (&[f64; M], &[[f64; M]; M]),
    symmetric: bool,
) {
    let slots = work.pattern.slots(element);
    let mut slot = slots.iter();
    for (i, component) in components.iter().enumerate() {
        work.internal[*component] += force[i];
        for (j, slot) in (0..=i).zip(&mut slot) {
            work.values[*slot as usize] += 0.5 * (tangent[i][j] + tangent[j][i]);
        }
    }
    if symmetric {
        return;
    }
    let mut slot = slots.iter();
    for (i, one) in components.iter().enumerate() {
        for (j, slot) in (0..=i).zip(&mut slot) {
            let skew = 0.5 * (tangent[i][j] - tangent[j][i]);
            if skew != 0.0 {
                let (a, b) = (model.dofs.equation[*one], model.dofs.equation[components[j]]);
                if a != HELD && b != HELD {
                    work.skew[*slot as usize] += if a > b { skew } else { -skew };
                    work.skewed = true;
                }
            }
        }
    }
}
