//! A run as plain 64-bit words, to the last bit, so that a stopped run goes on as if nothing had happened.
//!
//! Geometry that follows from the model (edges, laws) is not stored; decoding builds it again and refuses words that
//! do not fit the model.

use super::model::Model;
use super::outcome::{Body, ContactState, Frame, ParticleContact, ParticleState, PathPoint};
use super::particles::{self, Disc, Lean, Particles};
use super::relax::Stage;
use super::run::Run;
use super::state::State;
use super::touch::{Memory, Touch};
use crate::digest::checksum;
use crate::ids::{BlockId, ParticleId};
use crate::plane::{Meeting, Pose};
use crate::words::{Words, fields};

/// First word of every encoding; changes with the layout.
const LAYOUT: u64 = 0x4558_5452_4144_0006;

fields! {
    Memory { shear, crushed, length, compression, bonded, closed, sliding }
    PathPoint { factor, displacement, iterations, unbalanced_ratio, at_rest }
    ContactState { first, second, point, normal, compression, shear, length, sliding }
    Frame { factor, iterations, poses, velocities, contacts, stresses, particles, particle_contacts }
    ParticleState { centre, radius, angle, velocity, spin, stress }
    ParticleContact { particle, partner, point, normal, compression, shear, length, sliding }
    Stage { window, start, first_step, window_least, best, idle_windows, window_displacement, ratio, next_picture }
}

impl Words for ParticleId {
    fn put(&self, to: &mut Vec<u64>) {
        self.0.put(to);
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        u32::take(from).map(ParticleId)
    }
}

impl Words for Body {
    fn put(&self, to: &mut Vec<u64>) {
        match *self {
            Body::Particle(id) => (0_u64, id.0).put(to),
            Body::Block(id) => (1_u64, id.0).put(to),
        }
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        match Words::take(from)? {
            (0_u64, id) => Some(Body::Particle(ParticleId(id))),
            (1, id) => Some(Body::Block(BlockId(id))),
            _ => None,
        }
    }
}

impl Words for Meeting {
    fn put(&self, to: &mut Vec<u64>) {
        let (kind, a, b) = match *self {
            Meeting::Corner { first, second } => (0_u64, first, second),
            Meeting::Face { flipped, reference, incident } => (1 + u64::from(flipped), reference, incident),
        };
        (kind, (a, b)).put(to);
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        let (kind, (a, b)): (u64, (u32, u32)) = Words::take(from)?;
        match kind {
            0 => Some(Meeting::Corner { first: a, second: b }),
            1 | 2 => Some(Meeting::Face { flipped: kind == 2, reference: a, incident: b }),
            _ => None,
        }
    }
}

/// A touch without what follows from the model.
type StoredTouch = (((u32, u32), Meeting), ([Memory; 2], [f64; 6]));

fn store_touch(t: &Touch) -> StoredTouch {
    (
        (t.ids(), t.meeting),
        (
            t.memory,
            [
                t.normal_stiffness,
                t.shear_stiffness,
                t.half_joint,
                t.stored.unwrap_or(f64::NAN),
                t.bond.lost[0],
                t.bond.lost[1],
            ],
        ),
    )
}

fn rebuild_touch(model: &Model, ((ids, meeting), (memory, stiffness)): StoredTouch) -> Option<Touch> {
    let (a, b) = (ids.0 as usize, ids.1 as usize);
    if a >= b || b >= model.len() {
        return None;
    }
    let cores = (&model.cores[BlockId(ids.0)], &model.cores[BlockId(ids.1)]);
    let (of_a, of_b) = match meeting {
        Meeting::Corner { first, second } => (first, second),
        Meeting::Face { flipped: false, reference, incident } => (reference, incident),
        Meeting::Face { flipped: true, reference, incident } => (incident, reference),
    };
    if of_a as usize >= cores.0.len() || of_b as usize >= cores.1.len() {
        return None;
    }
    let law = model.laws.between(model.groups[a], model.groups[b]);
    let mut touch = Touch::new(ids, meeting, cores, law, 0.0);
    touch.memory = memory;
    let stored;
    [touch.normal_stiffness, touch.shear_stiffness, touch.half_joint, stored, touch.bond.lost[0], touch.bond.lost[1]] =
        stiffness;
    touch.stored = (!stored.is_nan()).then_some(stored);
    Some(touch)
}

/// A lean without what follows from the model: particle and block, edge, and shear, stiffnesses and length.
type StoredLean = (((u32, u32), u32), [f64; 5]);

fn put_particles(p: &Particles, to: &mut Vec<u64>) {
    (p.discs.len() as u64).put(to);
    for d in &p.discs {
        [d.x, d.y, d.vx, d.vy, d.rim, d.radius, d.inverse_mass, d.rolled].put(to);
    }
    p.previous.put(to);
    ([p.skin, p.travel], p.searched).put(to);
    for chunk in &p.chunks {
        (chunk.contacts.len() as u64).put(to);
        for c in &chunk.contacts {
            (u64::from(c.one) << 32 | c.other() as u64, c.shear).put(to);
        }
        let lean = |l: &Lean| -> StoredLean {
            (((l.local, l.block), l.edge), [l.shear, l.normal_stiffness, l.shear_stiffness, l.length, l.compression])
        };
        chunk.leans.iter().map(lean).collect::<Vec<StoredLean>>().put(to);
    }
}

fn take_particles(model: &Model, from: &mut &[u64]) -> Option<Particles> {
    if u64::take(from)? != model.particles.len() as u64 {
        return None;
    }
    let disc = |from: &mut &[u64]| {
        let [x, y, vx, vy, rim, radius, inverse_mass, rolled] = Words::take(from)?;
        Some(Disc { x, y, vx, vy, rim, radius, inverse_mass, rolled })
    };
    let discs: Vec<Disc> = (0..model.particles.len()).map(|_| disc(from)).collect::<Option<_>>()?;
    let previous: Vec<[f64; 3]> = Words::take(from)?;
    if !(previous.is_empty() || previous.len() == discs.len()) {
        return None;
    }
    let ([skin, travel], searched) = Words::take(from)?;
    let mut chunks = particles::chunks(discs.len());
    for chunk in &mut chunks {
        let stored: Vec<(u64, f64)> = Words::take(from)?;
        for (pair, shear) in stored {
            let (one, other) = ((pair >> 32) as u32, (pair & 0xFFFF_FFFF) as u32);
            let i = chunk.first + one;
            if one >= chunk.count || other <= i || other as usize >= discs.len() {
                return None;
            }
            chunk.contacts.push(model.particles.contact(&discs, &model.laws, (i, other), one as u16, shear));
        }
        let stored: Vec<StoredLean> = Words::take(from)?;
        for (((local, block), edge), [shear, normal_stiffness, shear_stiffness, length, compression]) in stored {
            let known = local < chunk.count && (block as usize) < model.len();
            if !(known && (edge as usize) < model.cores[BlockId(block)].len()) {
                return None;
            }
            let law = model.laws.between(model.particles.group(chunk.first + local), model.groups[block as usize]);
            chunk.leans.push(Lean {
                block,
                row: 0,
                local,
                edge,
                shear,
                normal_stiffness,
                shear_stiffness,
                cohesion: law.cohesion * length,
                friction: law.friction,
                length,
                compression,
            });
        }
    }
    particles::number_all(&mut chunks);
    Some(Particles { discs, chunks, previous, skin, travel, searched })
}

fn put_state(s: &State, to: &mut Vec<u64>) {
    s.poses.put(to);
    s.velocities.put(to);
    s.contact_forces.put(to);
    s.previous_forces.put(to);
    put_particles(&s.particles, to);
    s.touches.iter().map(store_touch).collect::<Vec<_>>().put(to);
    s.steps.put(to);
    [s.factor, s.support_factor, s.time_step, s.travel, s.feature_travel, s.viscosity].put(to);
    [s.load_work, s.support_work, s.dissipated, s.damped, s.initial_energy].put(to);
}

fn take_state(model: &Model, from: &mut &[u64]) -> Option<State> {
    let poses: Vec<Pose> = Words::take(from)?;
    let velocities: Vec<[f64; 3]> = Words::take(from)?;
    let contact_forces: Vec<[f64; 3]> = Words::take(from)?;
    let previous_forces: Vec<[f64; 3]> = Words::take(from)?;
    let fits = [poses.len(), velocities.len(), contact_forces.len(), previous_forces.len()];
    if fits != [model.len(); 4] {
        return None;
    }
    let particles = take_particles(model, from)?;
    let stored: Vec<StoredTouch> = Words::take(from)?;
    let touches = stored.into_iter().map(|t| rebuild_touch(model, t)).collect::<Option<_>>()?;
    let steps = Words::take(from)?;
    let [factor, support_factor, time_step, travel, feature_travel, viscosity] = Words::take(from)?;
    let [load_work, support_work, dissipated, damped, initial_energy] = Words::take(from)?;
    Some(State {
        poses,
        velocities,
        contact_forces,
        previous_forces,
        touches,
        particles,
        factor,
        support_factor,
        steps,
        time_step,
        travel,
        feature_travel,
        viscosity,
        initial_energy,
        load_work,
        support_work,
        dissipated,
        damped,
    })
}

impl State {
    /// The state as words, from which [`State::from_words`] makes it again to the bit.
    #[must_use]
    pub fn words(&self) -> Vec<u64> {
        let mut to = vec![LAYOUT];
        put_state(self, &mut to);
        to
    }

    /// A state of this model; `None` where the words are of another model or layout.
    #[must_use]
    pub fn from_words(model: &Model, words: &[u64]) -> Option<State> {
        let (layout, mut from) = words.split_first()?;
        (*layout == LAYOUT).then(|| take_state(model, &mut from)).flatten().filter(|_| from.is_empty())
    }
}

/// The run as words; `belongs` is the [`fingerprint`](super::fingerprint::fingerprint) of what it belongs to. The last
/// word is a checksum, so that damage is seen.
pub(super) fn encode(run: &Run, belongs: u64) -> Vec<u64> {
    let mut to = vec![LAYOUT, belongs];
    put_state(&run.state, &mut to);
    run.stable.is_some().put(&mut to);
    if let Some(stable) = &run.stable {
        put_state(stable, &mut to);
    }
    run.stage.put(&mut to);
    (run.low, run.high).put(&mut to);
    run.increments.put(&mut to);
    run.path.put(&mut to);
    run.frames.put(&mut to);
    run.last_stable_frame.put(&mut to);
    (run.given_up, run.stalled).put(&mut to);
    [run.max_stress, run.critical_time_step, run.single_mass_time_step].put(&mut to);
    to.push(checksum(&to));
    to
}

/// The run that `words` hold, if they are whole and were written for what `belongs` stands for.
pub(super) fn decode(model: &Model, words: &[u64], belongs: u64) -> Option<Run> {
    let (&sum, mut words) = words.split_last()?;
    if sum != checksum(words) {
        return None;
    }
    let from = &mut words;
    if u64::take(from)? != LAYOUT || u64::take(from)? != belongs {
        return None;
    }
    let state = take_state(model, from)?;
    let stable = if bool::take(from)? { Some(take_state(model, from)?) } else { None };
    let stage: Stage = Words::take(from)?;
    if stage.start.len() != model.len() {
        return None;
    }
    let (low, high) = Words::take(from)?;
    let increments = Words::take(from)?;
    let path = Words::take(from)?;
    let frames = Words::take(from)?;
    let last_stable_frame = Words::take(from)?;
    let (given_up, stalled) = Words::take(from)?;
    let [max_stress, critical_time_step, single_mass_time_step] = Words::take(from)?;
    from.is_empty().then_some(Run {
        state,
        stage,
        stable,
        low,
        high,
        increments,
        path,
        frames,
        last_stable_frame,
        max_stress,
        given_up,
        stalled,
        critical_time_step,
        single_mass_time_step,
    })
}
