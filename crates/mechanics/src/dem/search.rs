//! Which pairs may touch, and with which features. Pairs come and go; what their contact points remember stays.

use super::model::Model;
use super::particles::bounds;
use super::state::State;
use super::touch::{Memory, Touch};
use crate::contact::{Bond, ContactLength};
use crate::ids::BlockId;
use crate::plane::{Core, Pose, Vec2, meet, overlapping};

/// Distance by which boxes are grown in the search, as a share of the mean block size. A search is due when a block
/// may have moved half of it.
const SKIN: f64 = 0.05;

/// Features are looked at again when a block may have moved this share of the smallest block's reach.
const FEATURE_TRAVEL: f64 = 1e-3;

/// A contact point keeps its memory when features change if it stays within this share of the smallest reach.
const SAME_POINT: f64 = 0.02;

/// A contact length that is not given follows the joint when sliding has made the joint longer or shorter by this
/// factor.
const OTHER_JOINT: f64 = 1.2;

/// Brings the list of touches up to date where the blocks may have moved far enough to need it. Returns whether
/// pairs were added or joints have grown, so that the time step must be looked at again.
pub(super) fn search(model: &Model, state: &mut State, contact_length: ContactLength) -> bool {
    if state.travel > 0.5 * SKIN * model.block_size {
        let added = find_pairs(model, state, contact_length);
        state.travel = 0.0;
        state.feature_travel = 0.0;
        added
    } else if state.feature_travel > FEATURE_TRAVEL * model.least_reach {
        let mut grown = false;
        for touch in &mut state.touches {
            let (lost, longer) = look_again(model, &state.poses, touch, contact_length);
            state.dissipated += lost;
            grown |= longer;
        }
        state.feature_travel = 0.0;
        grown
    } else {
        false
    }
}

/// Finds all pairs anew and merges them with the old list, so that memories survive.
pub(super) fn find_pairs(model: &Model, state: &mut State, contact_length: ContactLength) -> bool {
    let pairs = close_pairs(model, &state.poses, SKIN * model.block_size);
    let old = std::mem::take(&mut state.touches);
    let mut old = old.into_iter().peekable();
    let mut added = false;
    for (a, b) in pairs {
        while let Some(mut gone) = old.next_if(|t| t.ids() < (a, b)) {
            state.dissipated += gone.forget();
        }
        let touch = if let Some(mut touch) = old.next_if(|t| t.ids() == (a, b)) {
            let (lost, longer) = look_again(model, &state.poses, &mut touch, contact_length);
            state.dissipated += lost;
            added |= longer;
            touch
        } else {
            added = true;
            make(model, &state.poses, (a, b), contact_length)
        };
        state.touches.push(touch);
    }
    for mut gone in old {
        state.dissipated += gone.forget();
    }
    added
}

/// Pairs of which at least one can move and whose boxes, grown by `skin` [m] in all, overlap; sorted.
pub(super) fn close_pairs(model: &Model, poses: &[Pose], skin: f64) -> Vec<(u32, u32)> {
    let one = |(core, pose): (&Core, &Pose)| bounds(core, pose, core.radius + 0.5 * skin);
    let boxes: Vec<(Vec2, Vec2)> = model.cores.iter().zip(poses).map(one).collect();
    let held = |i: usize| model.inverse_mass[i] == [0.0; 3];
    let pairs = overlapping(&boxes, 0.0).into_iter().filter(|&(i, j)| !(held(i) && held(j)));
    pairs.map(|(i, j)| (i as u32, j as u32)).collect()
}

/// A touch of a pair that was not close before.
pub(super) fn make(model: &Model, poses: &[Pose], (a, b): (u32, u32), contact_length: ContactLength) -> Touch {
    let mut touch = build(model, poses, (a, b), None);
    let length = initial_length(model, poses, &touch, contact_length);
    touch.memory = [Memory { length, ..Memory::default() }; 2];
    touch.half_joint = length;
    touch
}

fn build(model: &Model, poses: &[Pose], (a, b): (u32, u32), previous: Option<&Touch>) -> Touch {
    let (ia, ib) = (a as usize, b as usize);
    let cores = (&model.cores[BlockId(a)], &model.cores[BlockId(b)]);
    let meeting = meet(cores.0, &poses[ia], cores.1, &poses[ib], previous.map(|t| t.meeting));
    let normal = meeting.manifold(cores.0, &poses[ia], cores.1, &poses[ib]).normal;
    let distance = (poses[ib].position - poses[ia].position).dot(normal).abs();
    let law = model.laws.between(model.groups[ia], model.groups[ib]);
    let mut touch = Touch::new((a, b), meeting, cores, law, distance);
    if let Some(old) = previous {
        // Stiffness belongs to the contact from the moment it is made.
        touch.normal_stiffness = old.normal_stiffness;
        touch.shear_stiffness = old.shear_stiffness;
        touch.half_joint = old.half_joint;
    }
    touch
}

/// Length that each point of a new touch stands for [m].
fn initial_length(model: &Model, poses: &[Pose], touch: &Touch, contact_length: ContactLength) -> f64 {
    let (one, two) = (touch.one as usize, touch.two as usize);
    let law = model.laws.between(model.groups[one], model.groups[two]);
    match (contact_length, law.fixed_length) {
        (ContactLength::Fixed, Some(length)) => length,
        _ => half_joint(poses, touch),
    }
}

/// Half the distance between the two points now, at least the least length [m].
fn half_joint(poses: &[Pose], touch: &Touch) -> f64 {
    let points = touch.points(&poses[touch.one as usize], &poses[touch.two as usize]);
    (0.5 * points.stretch()).max(touch.least_length)
}

/// Looks at the features and the lengths of a pair again. Returns the energy lost and whether its joint has grown.
fn look_again(model: &Model, poses: &[Pose], touch: &mut Touch, contact_length: ContactLength) -> (f64, bool) {
    let ids = touch.ids();
    let lost = renew(model, poses, touch, ids, contact_length);
    let law = model.laws.between(model.groups[ids.0 as usize], model.groups[ids.1 as usize]);
    let fixed = contact_length == ContactLength::Fixed;
    if fixed && law.fixed_length.is_some() {
        return (lost, false);
    }
    let (before, now) = (touch.half_joint, half_joint(poses, touch));
    if now <= before * OTHER_JOINT && before <= now * OTHER_JOINT {
        return (lost, false);
    }
    touch.half_joint = now;
    let mut released = 0.0;
    if fixed {
        released = touch.elastic_energy();
        for memory in &mut touch.memory {
            memory.compression *= now / memory.length;
            memory.length = now;
        }
        released -= touch.elastic_energy();
    }
    (lost + released, now > before)
}

/// Looks at the features of a pair again; memories go to the nearest point of the new features. Returns the elastic
/// shear energy of memories that found no new point.
fn renew(model: &Model, poses: &[Pose], touch: &mut Touch, ids: (u32, u32), contact_length: ContactLength) -> f64 {
    let (a, b) = (ids.0 as usize, ids.1 as usize);
    let cores = (&model.cores[BlockId(ids.0)], &model.cores[BlockId(ids.1)]);
    if meet(cores.0, &poses[a], cores.1, &poses[b], Some(touch.meeting)) == touch.meeting {
        return 0.0;
    }
    let mut next = build(model, poses, ids, Some(touch));
    let length = initial_length(model, poses, &next, contact_length);
    let before = touch.points(&poses[touch.one as usize], &poses[touch.two as usize]);
    let after = next.points(&poses[next.one as usize], &poses[next.two as usize]);
    let centres = (poses[touch.one as usize].position, poses[next.one as usize].position);
    let reach = SAME_POINT * model.least_reach;
    let distance = |old: usize, new: usize| (before.at(old, centres.0) - after.at(new, centres.1)).norm();
    let mut taken = [false; 2];
    // Cracks go with their ends; a bond whose ends are not found again is lost.
    let mut cracks = [None; 2];
    for k in 0..next.count as usize {
        let nearest =
            (0..touch.count as usize).filter(|&j| !taken[j]).min_by(|&i, &j| distance(i, k).total_cmp(&distance(j, k)));
        next.memory[k] = match nearest {
            Some(j) if distance(j, k) <= reach => {
                taken[j] = true;
                cracks[k] = Some(touch.bond.lost[j]);
                touch.memory[j]
            }
            _ => Memory { length, ..Memory::default() },
        };
    }
    if let [Some(first), Some(second)] = cracks {
        next.bond = Bond { lost: [first, second] };
    }
    let lost = (0..2).filter(|&j| !taken[j]).map(|j| touch.open(j)).sum();
    *touch = next;
    lost
}
