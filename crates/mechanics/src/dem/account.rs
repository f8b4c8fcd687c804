//! What a state amounts to: out-of-balance force, energies, stresses, a frame to be drawn.

use super::model::Model;
use super::outcome::{Body, ContactState, Energy, Frame, ParticleContact};
use super::particles::Disc;
use super::state::State;
use crate::ids::{BlockId, Id};
use crate::plane::{Vec2, vec2};

/// Sum over the free blocks of the out-of-balance force [N/m], moments counted at the radius of gyration, over the
/// sum of the acting forces.
pub(super) fn unbalanced_ratio(model: &Model, state: &State) -> f64 {
    let mut sum = 0.0;
    for i in model.free() {
        let inverse = &model.inverse_mass[i];
        let acting = model.acting(i, state.factor);
        let f = &state.contact_forces[i];
        let turn = &state.poses[i].rotation;
        let force = [
            f[0] + acting.force.x,
            f[1] + acting.force.y,
            (f[2] + turn.cos * acting.cross - turn.sin * acting.dot) / model.gyration[i],
        ];
        for c in 0..3 {
            if inverse[c] > 0.0 {
                sum += force[c].abs();
            }
        }
    }
    (sum + state.particles.unbalanced()) / model.acting_scale(state.factor)
}

/// Kinetic energy of all that is free [J/m].
pub(super) fn kinetic_energy(model: &Model, state: &State) -> f64 {
    let mut sum = state.particles.discs.iter().map(Disc::kinetic_energy).sum::<f64>();
    for i in 0..model.len() {
        for c in 0..3 {
            if model.inverse_mass[i][c] > 0.0 {
                sum += 0.5 * model.mass[i][c] * state.velocities[i][c].powi(2);
            }
        }
    }
    sum
}

/// The energy account since the blocks were built [J/m], at the half step at which velocities are known: positions
/// and contact energies are taken half a step back and forth to it, so that the account closes in motion too.
pub fn energy(model: &Model, state: &State) -> Energy {
    let half = 0.5 * state.time_step;
    let (mut gravity, mut loads, mut elastic) = (0.0, state.load_work, 0.0);
    for i in model.free() {
        let (v, f) = (&state.velocities[i], &state.contact_forces[i]);
        let mut pose = state.poses[i];
        pose.position -= vec2(v[0], v[1]) * half;
        pose.rotation = pose.rotation.advanced(-v[2] * half);
        let weight = model.weight[i].work(model.built[i], &pose);
        gravity += weight;
        loads += model.permanent[i].work(model.built[i], &pose) - weight;
        loads += state.factor * model.variable[i].work(model.built[i], &pose);
        elastic -= half * (0..3).map(|c| f[c] * v[c] * model.bodies[i].free[c]).sum::<f64>();
    }
    let of_particles = state.particles.energy(&model.particles, half);
    gravity += of_particles[0];
    elastic += of_particles[1];
    Energy {
        initial: state.initial_energy,
        gravity,
        loads,
        supports: state.support_work,
        kinetic: kinetic_energy(model, state),
        elastic: elastic + state.touches.iter().map(|t| t.elastic_energy()).sum::<f64>(),
        dissipated: state.dissipated,
        damped: state.damped,
    }
}

/// Changes the load factor; the work that the loads have done so far is booked at the old one.
pub(super) fn set_factor(model: &Model, state: &mut State, factor: f64) {
    for i in model.free() {
        state.load_work += (state.factor - factor) * model.variable[i].work(model.built[i], &state.poses[i]);
    }
    state.factor = factor;
}

/// Closed contacts, sorted by blocks; normals point from the lower to the higher id.
pub fn contacts(state: &State) -> Vec<ContactState> {
    let mut found = Vec::new();
    for t in &state.touches {
        let points = t.points(&state.poses[t.one as usize], &state.poses[t.two as usize]);
        let (first, second) = t.ids();
        let flip = first != t.one;
        for k in 0..t.count as usize {
            let m = &t.memory[k];
            if m.closed {
                // An open hinge presses along the true normal of the two surfaces, not that of the reference edge.
                let push = points.push(k);
                let force = push * m.compression + points.direction * m.shear;
                let normal = push.unit();
                found.push(ContactState {
                    first: BlockId(first),
                    second: BlockId(second),
                    point: points.at(k, state.poses[t.one as usize].position),
                    normal: if flip { -normal } else { normal },
                    compression: force.dot(normal),
                    shear: force.dot(normal.left()),
                    length: m.length,
                    sliding: m.sliding,
                });
            }
        }
    }
    found
}

/// Average stress of each block (xx, yy, xy) [Pa], tension positive, from the forces on its boundary: `1/A sum x (x) f`, by the
/// divergence theorem (Potyondy and Cundall 2004). The mean of the two shear components is reported.
pub fn stresses(model: &Model, state: &State, contacts: &[ContactState], leaning: &[ParticleContact]) -> Vec<[f64; 3]> {
    let mut sums = vec![[0.0; 3]; model.len()];
    let mut add = |i: usize, at: Vec2, f: Vec2| {
        let x = at - state.poses[i].position;
        sums[i][0] += x.x * f.x;
        sums[i][1] += x.y * f.y;
        sums[i][2] += 0.5 * (x.x * f.y + x.y * f.x);
    };
    for c in contacts {
        let f = c.normal * c.compression + c.normal.left() * c.shear;
        add(c.second.index(), c.point, f);
        add(c.first.index(), c.point, -f);
    }
    for c in leaning {
        if let Body::Block(block) = c.partner {
            add(block.index(), c.point, -c.force());
        }
    }
    for i in 0..model.len() {
        // Point forces act on the boundary too, and their arms turn with the block; weight acts on the centroid and
        // adds nothing.
        let turn = &state.poses[i].rotation;
        let built: [f64; 4] =
            std::array::from_fn(|c| model.permanent_virial[i][c] + state.factor * model.variable_virial[i][c]);
        let x = turn.turn(vec2(built[0], built[2]));
        let y = turn.turn(vec2(built[1], built[3]));
        sums[i][0] += x.x;
        sums[i][1] += y.y;
        sums[i][2] += 0.5 * (y.x + x.y);
        for s in &mut sums[i] {
            *s /= model.area[i];
        }
    }
    sums
}

/// The state as a frame.
pub fn frame(model: &Model, state: &State) -> Frame {
    let contacts = contacts(state);
    let particle_contacts = state.particles.contacts(model, &state.poses);
    Frame {
        factor: state.factor,
        iterations: state.steps,
        poses: state.poses.iter().copied().collect(),
        velocities: state.velocities.iter().map(|v| (vec2(v[0], v[1]), v[2])).collect(),
        stresses: stresses(model, state, &contacts, &particle_contacts).into_iter().collect(),
        contacts,
        particles: state.particles.states(&model.particles, &particle_contacts),
        particle_contacts,
    }
}
