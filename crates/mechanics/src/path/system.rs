//! Equilibrium of all blocks and its exact tangent.

use super::dual::{Dual, Half, between, half_of, whole};
use super::inertia::{has_no_negative_eigenvalue, may_have_no_negative_eigenvalue};
use super::joint::{Bedding, Memory, Relative, Response};
use super::model::Model;
use super::settings::Settings;
use crate::acting::Resultant;
use crate::banded::Banded;
use crate::contact::Bond;
use crate::numbering::HELD;
use crate::plane::{Vec2, vec2};
use serde::{Deserialize, Serialize};

/// A state of the blocks: what a checkpoint must contain.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct State {
    /// Translations [m] and rotation [rad] of each block since it was built.
    pub motions: Vec<[f64; 3]>,
    /// Load factor.
    pub factor: f64,
    pub(super) memory: Vec<Memory>,
    /// See [`Bedding`].
    pub(super) pressed: f64,
}

impl State {
    /// As built, without load.
    pub(super) fn as_built(model: &Model) -> State {
        State {
            motions: vec![[0.0; 3]; model.built.len()],
            factor: 0.0,
            memory: vec![Memory::default(); model.joints.len()],
            pressed: 0.0,
        }
    }
}

/// Sum of the sizes of all forces that act on free blocks [N/m].
pub(super) fn scale(model: &Model, factor: f64) -> f64 {
    let size = |r: &Resultant| r.force.x.abs() + r.force.y.abs();
    let free = (0..model.built.len()).filter(|&i| model.equation[i] != [HELD; 3]);
    let of = |i: usize| size(&model.permanent[i]) + factor.abs() * size(&model.variable[i]);
    let pressed: f64 = model.restraints.iter().map(|r| r.most).sum();
    (free.map(of).sum::<f64>() + pressed).max(f64::MIN_POSITIVE)
}

/// Scratch: forces and tangent of one trial state.
#[derive(Debug, Clone)]
pub(super) struct Workspace {
    /// `-dF/du`.
    pub tangent: Banded,
    /// Out-of-balance forces `F` [N/m]; moments are divided by the size of the blocks.
    pub unbalanced: Vec<f64>,
    /// `dF/dfactor`.
    pub growing: Vec<f64>,
    /// Whether an end of a joint slides.
    pub slides: bool,
    /// Whether some of a bond breaks.
    pub cracks: bool,
    /// Half of the turn of each block.
    turns: Vec<Half>,
    /// Room for the elimination that tells whether a tangent is stable.
    eliminated: Vec<f64>,
}

impl Workspace {
    pub(super) fn new(model: &Model) -> Workspace {
        Workspace {
            tangent: Banded::new(model.last.clone()),
            unbalanced: vec![0.0; model.equations],
            growing: vec![0.0; model.equations],
            slides: false,
            cracks: false,
            turns: Vec::new(),
            eliminated: Vec::new(),
        }
    }
    /// Whether every small motion from the state whose tangent stands here, not factorised, takes work.
    pub(super) fn is_stable(&mut self) -> bool {
        has_no_negative_eigenvalue(&self.tangent, &mut self.eliminated)
    }
    /// Whether that may be, where it is asked often and the answer is asked again in the end.
    pub(super) fn may_be_stable(&mut self) -> bool {
        may_have_no_negative_eigenvalue(&self.tangent, &mut self.eliminated)
    }
    /// Largest out-of-balance force [N/m].
    pub(super) fn largest(&self) -> f64 {
        self.unbalanced.iter().fold(0.0, |most, f| if f.is_finite() { f.abs().max(most) } else { f64::INFINITY })
    }
}

/// Response of joint `k` in a state, with shear that follows from the last balanced one.
pub(super) fn respond(model: &Model, settings: &Settings, memory: &Memory, k: usize, state: &State) -> Response<f64> {
    let joint = &model.joints[k];
    let turns = [joint.first, joint.second].map(|block| half_of(state.motions[block][2]));
    joint.respond(bedding(settings, state), memory, relative(model, k, state, turns))
}

fn bedding(settings: &Settings, state: &State) -> Bedding {
    Bedding { contact_length: settings.contact_length, pressed: state.pressed }
}

/// Pose of a joint's second block as its first one sees it. The half turns of both are given.
fn relative(model: &Model, k: usize, state: &State, turns: [Half; 2]) -> Relative {
    let joint = &model.joints[k];
    let moved = joint.moved(state.motions[joint.first], state.motions[joint.second], turns[0]);
    (moved, between(turns[0], turns[1]))
}

/// Out-of-balance forces of a trial state, and the tangent; the state's memory is that of the last balanced one.
pub(super) fn assemble(model: &Model, settings: &Settings, state: &State, work: &mut Workspace) {
    work.tangent.clear();
    work.unbalanced.fill(0.0);
    work.growing.fill(0.0);
    (work.slides, work.cracks) = (false, false);
    work.turns.clear();
    work.turns.extend(state.motions.iter().map(|motion| half_of(motion[2])));
    for block in 0..model.built.len() {
        act(model, block, state, work);
    }
    for k in 0..model.joints.len() {
        join(model, settings, k, state, work);
    }
    // Fill that one or two blocks move against.
    for restraint in &model.restraints {
        let held = restraint.on(state);
        spread(model, held.blocks, (held.forces.as_flattened(), &held.slope), work);
    }
}

/// Loads of one block.
fn act(model: &Model, block: usize, state: &State, work: &mut Workspace) {
    let equations = model.equation[block];
    if equations == [HELD; 3] {
        return;
    }
    let [sine, cosine] = whole(work.turns[block]);
    let moment = |r: &Resultant| (cosine * r.cross - sine * r.dot) / model.size;
    let grows = &model.variable[block];
    let now = model.permanent[block].plus(grows, state.factor);
    let forces = [now.force.x, now.force.y, moment(&now)];
    let growing = [grows.force.x, grows.force.y, moment(grows)];
    for c in 0..3 {
        if equations[c] != HELD {
            work.unbalanced[equations[c] as usize] += forces[c];
            work.growing[equations[c] as usize] += growing[c];
        }
    }
    if equations[2] != HELD {
        // The unknown is the rotation times the size, and the moment is divided by it.
        let slope = (-sine * now.cross - cosine * now.dot) / (model.size * model.size);
        work.tangent.add(equations[2] as usize, equations[2] as usize, -slope);
    }
}

/// What the load factor adds to the forces of a state for each unit that it grows by [N/m], without what imposed motions do; moments are divided by the size
/// of the blocks. The tangent in the workspace is spoilt.
pub(super) fn load_of(model: &Model, state: &State, work: &mut Workspace) -> Vec<f64> {
    work.growing.fill(0.0);
    work.turns.clear();
    work.turns.extend(state.motions.iter().map(|motion| half_of(motion[2])));
    (0..model.built.len()).for_each(|block| act(model, block, state, work));
    work.growing.clone()
}

/// Adds the forces on two blocks, and their derivatives by the motions of both, to the equations.
fn spread(
    model: &Model,
    blocks: [Option<usize>; 2],
    (forces, tangent): (&[f64], &[[f64; 6]; 6]),
    work: &mut Workspace,
) {
    let inverse = 1.0 / model.size;
    let scale = [1.0, 1.0, inverse];
    if let [Some(first), Some(second)] = blocks.map(|block| block.and_then(|block| model.free(block))) {
        for (part, to) in [first, second].into_iter().enumerate() {
            for c in 0..3 {
                let (row, of) = (to + c, 3 * part + c);
                work.unbalanced[row] += forces[of] * scale[c];
                let [a, b, turn, d, e, other] = tangent[of].map(|value| -value * scale[c]);
                work.tangent.add_all(row, first, [a, b, turn * inverse]);
                work.tangent.add_all(row, second, [d, e, other * inverse]);
            }
        }
        return;
    }
    let equation = |i: usize| blocks[i / 3].map_or(HELD, |block| model.equation[block][i % 3]);
    let imposed = |i: usize| blocks[i / 3].map_or(0.0, |block| model.movement[block][i % 3]);
    for row in 0..6 {
        let to = equation(row);
        if to == HELD {
            continue;
        }
        let to = to as usize;
        work.unbalanced[to] += forces[row] * scale[row % 3];
        for motion in 0..6 {
            let value = tangent[row][motion] * scale[row % 3];
            match equation(motion) {
                HELD => work.growing[to] += value * imposed(motion),
                column => work.tangent.add(to, column as usize, -value * scale[motion % 3]),
            }
        }
    }
}

/// Forces of one joint on its two blocks, with their derivatives.
fn join(model: &Model, settings: &Settings, k: usize, state: &State, work: &mut Workspace) {
    let joint = &model.joints[k];
    let turns = [work.turns[joint.first], work.turns[joint.second]];
    let pose = relative(model, k, state, turns);
    let response = joint.respond::<Dual>(bedding(settings, state), &state.memory[k], pose);
    work.slides |= response.sliding[0] || response.sliding[1];
    work.cracks |= response.cracking;
    let [along, across, turn] = response.force;
    let (f, mut slope) = ([along.value, across.value, turn.value], [along.slope, across.slope, turn.slope]);
    let [artificial_normal, artificial_shear, artificial_turn] = joint.artificial();
    slope[0][0] -= artificial_shear;
    slope[1][1] -= artificial_normal;
    slope[2][2] -= artificial_turn;
    let apart = joint.between() + pose.0;
    // Where the joint lies after the turn of its first block.
    let [sine, cosine] = whole(turns[0]);
    let turned = |v: Vec2| vec2(cosine * v.x - sine * v.y, cosine * v.y + sine * v.x);
    let (t, n) = (turned(joint.tangent()), turned(joint.normal));
    // Change of the pose with four of the six motions: rotation of the first block, translations and rotation of the second. The first block's
    // translations do the opposite of the second's.
    let change = [[-apart.y, apart.x, -1.0], [t.x, n.x, 0.0], [t.y, n.y, 0.0], [0.0, 0.0, 1.0]];
    let on_second = t * f[0] + n * f[1];
    let moment_on_first = -f[2] - (apart.y * f[0] - apart.x * f[1]);
    let forces = [-on_second.x, -on_second.y, moment_on_first, on_second.x, on_second.y, f[2]];
    let mut tangent = [[0.0; 6]; 6];
    for (change, motion) in change.iter().zip(2..6) {
        let row = |r: usize| slope[r][0] * change[0] + slope[r][1] * change[1] + slope[r][2] * change[2];
        let by = [row(0), row(1), row(2)];
        let mut force = t * by[0] + n * by[1];
        if motion == 2 {
            force += on_second.left();
        }
        let on_first = change[1] * f[0] - change[0] * f[1] + apart.y * by[0] - apart.x * by[1];
        let column = [-force.x, -force.y, -by[2] - on_first, force.x, force.y, by[2]];
        for row in 0..6 {
            tangent[row][motion] = column[row];
        }
    }
    for row in &mut tangent {
        (row[0], row[1]) = (-row[3], -row[4]);
    }
    spread(model, [Some(joint.first), Some(joint.second)], (&forces, &tangent), work);
}

/// Moves a state by a change of its unknowns, none where it is empty, and of the factor.
pub(super) fn advance(model: &Model, state: &mut State, change: &[f64], factor: f64) {
    state.factor += factor;
    for (block, motion) in state.motions.iter_mut().enumerate() {
        let imposed = model.movement[block];
        for c in 0..3 {
            match model.equation[block][c] {
                HELD => motion[c] = state.factor * imposed[c],
                _ if change.is_empty() => {}
                equation if c == 2 => motion[c] += change[equation as usize] / model.size,
                equation => motion[c] += change[equation as usize],
            }
        }
    }
}

/// Share of its shear that a joint keeps.
const HOLDS: f64 = 1.0 - 1e-9;

/// Share of a joint's length by which a crack is remembered as shorter than it is.
const HAIR: f64 = 1e-9;

/// Lets the joints remember the state: it is balanced. What slides is left a hair below its strength, so that the tangent there
/// is that of joints that hold: whether they slide on is for the next state to show. A crack is left a hair shorter, so that the tangent there is
/// that of a crack that grows: one that takes load away does so at once.
pub(super) fn commit(model: &Model, settings: &Settings, state: &mut State) {
    for k in 0..model.joints.len() {
        let response = respond(model, settings, &state.memory[k], k, state);
        let stiffness = response.ends.length.map(|length| length * model.joints[k].resistance.shear);
        let sheared = [0, 1].map(|e| if stiffness[e] > 0.0 { HOLDS * response.shear[e] / stiffness[e] } else { 0.0 });
        let before = state.memory[k].bond;
        let broken = model.joints[k].cracks(bedding(settings, state), response.meeting.overlap, &before);
        let lost = |left: Bond, e: usize| {
            if left.lost[e] > before.lost[e] { (left.lost[e] - HAIR).max(before.lost[e]) } else { left.lost[e] }
        };
        let hair = |left: Bond| Bond { lost: [0, 1].map(|e| lost(left, e)) };
        state.memory[k] = Memory { sheared, glide: response.meeting.glide, bond: broken.map_or(before, hair) };
    }
}
