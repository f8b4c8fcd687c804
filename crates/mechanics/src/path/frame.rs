//! A balanced state as it is reported.

use super::dual::{between, half_of};
use super::joint::{Joint, Memory, Response};
use super::model::Model;
use super::outcome::{EndState, Frame, JointState, PathPoint};
use super::settings::{Program, Settings};
use super::system::{State, respond};
use crate::contact::ContactLength;
use crate::ids::Id;
use crate::plane::{Pose, Rotation, Vec2, vec2};

/// The blocks and joints of a balanced state.
pub(super) fn frame(model: &Model, settings: &Settings, state: &State, step: usize) -> Frame {
    let pose = |(i, motion): (usize, &[f64; 3])| Pose {
        position: model.built[i] + vec2(motion[0], motion[1]),
        rotation: Rotation::by(motion[2]),
    };
    let joints = (0..model.joints.len()).map(|k| joint(model, settings, state, k)).collect();
    Frame { factor: state.factor, step, poses: state.motions.iter().enumerate().map(pose).collect(), joints }
}

/// A joint of a state that its memory belongs to.
fn joint(model: &Model, settings: &Settings, state: &State, k: usize) -> JointState {
    let joint = &model.joints[k];
    let response = respond(model, settings, &state.memory[k], k, state);
    let first = state.motions[joint.first];
    let half = Rotation::by(first[2] + 0.5 * (state.motions[joint.second][2] - first[2]));
    let centre = model.built[joint.first] + vec2(first[0], first[1]);
    let turn = Rotation::by(first[2]);
    let half_turn = between(half_of(first[2]), half_of(state.motions[joint.second][2]));
    let end = |e: usize| EndState {
        at: centre + turn.turn(joint.place(response.meeting.at[e], half_turn)),
        compression: response.ends.compression[e],
        shear: response.shear[e],
        length: response.ends.length[e],
        overlap: response.meeting.overlap[e],
        sliding: slides(joint, &response, e),
    };
    JointState {
        normal: half.turn(joint.normal),
        ends: [end(0), end(1)],
        stress: stress(settings, joint, &response),
        opened: opened(settings, (joint, &state.memory[k]), &response.meeting.overlap),
        crushed: crushed(settings, joint, &response.meeting.overlap),
    }
}

/// Whether the shear of an end is as large as its strength.
fn slides(joint: &Joint, response: &Response<f64>, end: usize) -> bool {
    let strength = response.ends.shear_strength(end, &joint.resistance);
    let resists = response.ends.compression[end] > 0.0 || strength > 0.0;
    resists && response.shear[end].abs() >= strength * (1.0 - 1e-6)
}

/// Greatest compressive stress [Pa].
fn stress(settings: &Settings, joint: &Joint, response: &Response<f64>) -> f64 {
    let law = &joint.resistance;
    let at_end = |k: usize| match settings.contact_length {
        ContactLength::Distributed => (law.normal * response.meeting.overlap[k]).clamp(0.0, law.crushing),
        _ if response.ends.length[k] > 0.0 => response.ends.compression[k] / response.ends.length[k],
        _ => 0.0,
    };
    at_end(0).max(at_end(1))
}

/// Share of the face where its sides are apart and no bond holds them.
fn opened(settings: &Settings, (joint, memory): (&Joint, &Memory), overlap: &[f64; 2]) -> f64 {
    let apart = beyond([-overlap[0], -overlap[1]]);
    (apart - joint.pulled(settings.contact_length, *overlap, &memory.bond)).max(0.0)
}

/// Share of the face whose stress is at the strength.
fn crushed(settings: &Settings, joint: &Joint, overlap: &[f64; 2]) -> f64 {
    let most = joint.resistance.crushing / joint.resistance.normal;
    match settings.contact_length {
        ContactLength::Distributed if most.is_finite() => beyond([overlap[0] - most, overlap[1] - most]),
        _ => 0.0,
    }
}

/// Share of a stretch on which a linear function is positive.
fn beyond([a, b]: [f64; 2]) -> f64 {
    match (a > 0.0, b > 0.0) {
        (true, true) => 1.0,
        (false, false) => 0.0,
        (true, false) => a / (a - b),
        (false, true) => b / (b - a),
    }
}

/// The numbers of a balanced state.
pub(super) fn point(
    model: &Model,
    (settings, program): (&Settings, &Program),
    state: &State,
    (iterations, residual): (u32, f64),
) -> PathPoint {
    let mut point = PathPoint {
        factor: state.factor,
        displacement: watched(model, program, state),
        mobilised: mobilised(model, state),
        iterations,
        residual,
        ..PathPoint::default()
    };
    for (k, joint) in model.joints.iter().enumerate() {
        let response = respond(model, settings, &state.memory[k], k, state);
        let open = opened(settings, (joint, &state.memory[k]), &response.meeting.overlap);
        // A joint that is open throughout carries nothing: it is no hinge.
        if open < 1.0 {
            point.opened = point.opened.max(open);
            point.hinges += u32::from(open > 0.5);
        }
        let [a, b] = response.ends.compression;
        if a + b > 0.0 {
            let arm = 0.5 * response.meeting.length / joint.built_length().max(response.meeting.length);
            point.eccentricity = point.eccentricity.max(arm * ((b - a) / (a + b)).abs());
        }
        let beyond = |end: usize| response.shear[end].abs() - response.ends.shear_strength(end, &joint.resistance);
        point.excess = point.excess.max(beyond(0)).max(beyond(1));
        point.sliding += u32::from((0..2).any(|e| slides(joint, &response, e)));
        point.stress = point.stress.max(stress(settings, joint, &response));
        point.crushed = point.crushed.max(crushed(settings, joint, &response.meeting.overlap));
    }
    point
}

/// What restraints add that blocks move against, as a share of all that these could add.
fn mobilised(model: &Model, state: &State) -> f64 {
    let against = model.restraints.iter().filter_map(|r| r.added(state));
    let [there, most] = against.fold([0.0; 2], |[there, most], [one, all]| [there + one, most + all]);
    if most > 0.0 { there / most } else { 0.0 }
}

/// Displacement of the watched point [m].
fn watched(model: &Model, program: &Program, state: &State) -> Vec2 {
    let (block, at) = program.watched;
    model.moved(block.index(), at, state.motions[block.index()]) - at
}
