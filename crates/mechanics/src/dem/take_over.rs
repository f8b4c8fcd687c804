//! Populations change between stages only: a lid is taken away, a ring let go, a block placed. The new model's state
//! begins where the old one ended, contact forces included.

use super::account::energy;
use super::model::Model;
use super::particles::{Contact, Lean};
use super::search::find_pairs;
use super::settings::Settings;
use super::state::State;
use super::step::{Workspace, begin, critical_time_step};
use super::touch::Touch;
use crate::ids::BlockId;

/// The state of `model` in which everything that `old` has too stands where it stood there, with the velocity and the
/// contact forces that it had. Blocks and particles are the same where their ids are; what is new stands as built. Laws,
/// radii and held motions are those of the new model.
pub fn take_over(model: &Model, settings: &Settings, (old, before): (&Model, &State)) -> State {
    let mut state = begin(model, settings);
    let blocks = model.len().min(old.len());
    state.poses[..blocks].copy_from_slice(&before.poses[..blocks]);
    state.velocities[..blocks].copy_from_slice(&before.velocities[..blocks]);
    for (v, inverse) in state.velocities.iter_mut().zip(&model.inverse_mass) {
        (0..3).filter(|&c| inverse[c] == 0.0).for_each(|c| v[c] = 0.0);
    }
    state.touches = before.touches.iter().filter_map(|t| touch(model, blocks, t)).collect();
    particles(model, &mut state, (old, before), blocks);
    find_pairs(model, &mut state, settings.contact_length);
    let mut work = Workspace::default();
    state.particles.travel = f64::INFINITY;
    state.particles.search(&model.particles, model.blocks(&state.poses), &mut work.cells, 0);
    state.time_step = settings.time_step_factor * critical_time_step(model, &state, settings);
    // Not what the particles would have held where they are built.
    state.initial_energy -= energy(model, &state).drift();
    state
}

/// An old touch under the new laws, if both of its blocks are still there.
fn touch(model: &Model, blocks: usize, old: &Touch) -> Option<Touch> {
    let (a, b) = old.ids();
    if b as usize >= blocks {
        return None;
    }
    let cores = (&model.cores[BlockId(a)], &model.cores[BlockId(b)]);
    let law = model.laws.between(model.groups[a as usize], model.groups[b as usize]);
    let mut touch = Touch::new((a, b), old.meeting, cores, law, 0.0);
    touch.memory = old.memory;
    touch.bond = old.bond;
    touch.normal_stiffness = old.normal_stiffness;
    touch.shear_stiffness = old.shear_stiffness;
    touch.half_joint = old.half_joint;
    Some(touch)
}

/// Particles stand in another order in memory; the shear of their contacts is carried over by id.
fn particles(model: &Model, state: &mut State, (old, before): (&Model, &State), blocks: usize) {
    let count = model.particles.len().min(old.particles.len()) as u32;
    let row = |old_row: usize| {
        Some(old.particles.ids[old_row]).filter(|&id| id < count).map(|id| model.particles.rows[id as usize])
    };
    for (k, disc) in before.particles.discs.iter().enumerate() {
        let Some(row) = row(k) else { continue };
        let now = &mut state.particles.discs[row as usize];
        let turned = disc.angle() * now.radius;
        (now.x, now.y, now.vx, now.vy, now.rim, now.rolled) = (disc.x, disc.y, disc.vx, disc.vy, disc.rim, turned);
    }
    let mut contacts: Vec<(u32, u32, f64)> = Vec::new();
    let mut leans: Vec<(u32, Lean)> = Vec::new();
    for chunk in &before.particles.chunks {
        for c in &chunk.contacts {
            if let (Some(i), Some(j)) = (row(chunk.first as usize + c.one as usize), row(c.other())) {
                // Along the normal turned left the shear is the same seen from either side.
                contacts.push((i.min(j), i.max(j), c.shear));
            }
        }
        for l in &chunk.leans {
            if let (Some(i), true) = (row((chunk.first + l.local) as usize), (l.block as usize) < blocks) {
                leans.push((i, *l));
            }
        }
    }
    contacts.sort_unstable_by_key(|&(i, j, _)| (i, j));
    leans.sort_unstable_by_key(|(i, l)| (*i, l.block));
    let discs = &state.particles.discs;
    for chunk in &mut state.particles.chunks {
        let range = chunk.first..chunk.first + chunk.count;
        let (from, to) =
            (contacts.partition_point(|c| c.0 < range.start), contacts.partition_point(|c| c.0 < range.end));
        let contact = |&(i, j, shear): &(u32, u32, f64)| -> Contact {
            model.particles.contact(discs, &model.laws, (i, j), (i - range.start) as u16, shear)
        };
        chunk.contacts = contacts[from..to].iter().map(contact).collect();
        let (from, to) = (leans.partition_point(|l| l.0 < range.start), leans.partition_point(|l| l.0 < range.end));
        let lean = |(i, old): &(u32, Lean)| {
            let law = model.laws.between(model.particles.group(*i), model.groups[old.block as usize]);
            Lean { local: i - range.start, cohesion: law.cohesion * old.length, friction: law.friction, ..*old }
        };
        chunk.leans = leans[from..to].iter().map(lean).collect();
    }
    super::particles::number_all(&mut state.particles.chunks);
}
