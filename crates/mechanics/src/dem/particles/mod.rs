//! Particles: circular bodies beside the blocks (Cundall and Strack 1979; Rouxinol, Providência and Lemos).
//!
//! They stand in memory along a space-filling curve, in chunks of some thousand. A contact belongs to the chunk of its
//! earlier particle, so chunks can be worked on side by side, and every sum is made in the same order for any number of
//! threads. Without particles there are no chunks, and nothing here costs anything.

mod account;
mod cells;
mod chunk;
mod disc;
mod integrate;
mod laws;
mod lean;
mod neighbours;
mod order;
mod quad;

pub(super) use cells::Cells;
pub(super) use chunk::{Chunk, Force, MOST_PARTICLES};
pub use disc::Disc;
pub(super) use integrate::with_forces;
pub(super) use lean::Lean;
pub(super) use neighbours::{Blocks, bounds, chunks, number_all};

use super::settings::Damping;
use crate::blocks::{LawTable, Particle};
use crate::ids::{GroupId, ParticleId, Table};
use crate::plane::Vec2;
pub(super) use chunk::Contact;
use integrate::{Motion, Tally, integrate};
use laws::{ContactStiffness, PairLaws, stiffness};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Greatest distance at which a pair counts as near, as a share of the mean radius, and least: the more often searches
/// come, the more each of them should be good for.
const SKIN: (f64, f64) = (0.02, 0.3);

/// Steps between searches below which the skin grows, and at which a search comes whatever has moved and the skin shrinks.
const SEARCHES: (u64, u64) = (100, 1_000);

/// What is fixed about the particles once a run is set up.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(super) struct ParticleModel {
    /// The particle that stands in each row of memory, and the row of each particle.
    pub ids: Vec<u32>,
    pub rows: Vec<u32>,
    /// Centre [m] and radius [m] of each row as built.
    pub built: Vec<[f64; 3]>,
    /// Group of each row, as numbered by the laws.
    kinds: Vec<u8>,
    laws: PairLaws,
    /// Mass density of each row [kg/m^3].
    densities: Vec<f64>,
    /// Weight of each row as built [N/m].
    pub weights: Vec<[f64; 2]>,
    gravity: Vec2,
}

/// Particles, their contacts and how they are searched: part of the state.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(super) struct Particles {
    /// The particles, by row.
    pub discs: Vec<Disc>,
    /// The stretches of rows and their contacts.
    pub chunks: Vec<Chunk>,
    /// Forces one step earlier, for adaptive damping; empty otherwise.
    pub previous: Vec<Force>,
    /// Distance within which pairs were searched [m], how far anything may have moved since [m], and the step.
    pub skin: f64,
    pub travel: f64,
    pub searched: u64,
}

impl ParticleModel {
    /// Sets particles up that have been checked: at most [`MOST_PARTICLES`] in at most [`MOST_GROUPS`] groups.
    pub(super) fn new(particles: &Table<ParticleId, Particle>, laws: &LawTable, gravity: Vec2) -> ParticleModel {
        let mut groups: Vec<GroupId> = particles.iter().map(|p| p.group).collect();
        groups.sort_unstable();
        groups.dedup();
        let laws = PairLaws::new(groups, laws);
        let centres: Vec<Vec2> = particles.iter().map(|p| p.centre).collect();
        let ids = if centres.is_empty() { Vec::new() } else { order::along_curve(&centres) };
        let mut rows = vec![0; ids.len()];
        ids.iter().enumerate().for_each(|(row, &id)| rows[id as usize] = row as u32);
        let rowed = || ids.iter().map(|&id| &particles[ParticleId(id)]);
        ParticleModel {
            weights: rowed().map(|p| [gravity.x * p.mass(), gravity.y * p.mass()]).collect(),
            built: rowed().map(|p| [p.centre.x, p.centre.y, p.radius]).collect(),
            kinds: rowed().map(|p| laws.kind(p.group).unwrap_or_default()).collect(),
            densities: rowed().map(|p| p.density).collect(),
            laws,
            rows,
            ids,
            gravity,
        }
    }
    /// Number of particles.
    pub(super) fn len(&self) -> usize {
        self.ids.len()
    }
    /// Group of a row.
    pub(super) fn group(&self, row: u32) -> GroupId {
        self.laws.groups[self.kinds[row as usize] as usize]
    }
    /// Mass of a row as built [kg/m].
    pub(super) fn mass(&self, row: usize) -> f64 {
        let r = self.built[row][2];
        self.densities[row] * std::f64::consts::PI * r * r
    }
    /// Weight of all particles [N/m], positive.
    pub(super) fn weight(&self) -> f64 {
        (0..self.len()).map(|row| self.mass(row)).sum::<f64>() * (self.gravity.x.abs() + self.gravity.y.abs())
    }
    /// A contact of the rows `i` and `j`, `i < j`, whose row of the other's force is not known yet.
    pub(super) fn contact(&self, discs: &[Disc], laws: &LawTable, (i, j): (u32, u32), one: u16, shear: f64) -> Contact {
        let sum = discs[i as usize].radius + discs[j as usize].radius;
        let law = self.laws.index(self.kinds[i as usize], self.kinds[j as usize]);
        let ContactStiffness { normal: normal_stiffness, shear: shear_stiffness, .. } =
            stiffness(laws.between(self.group(i), self.group(j)), sum, sum);
        Contact { tagged: j | u32::from(law) << 24, one, two: 0, shear, normal_stiffness, shear_stiffness }
    }
    /// Square of the largest angular frequency [1/s^2] of a row's particle and another like it that touch: both give way
    /// to the normal spring, and to the shear spring with three times their masses' reciprocal, for their rims turn.
    pub(super) fn of_its_like(&self, laws: &LawTable, row: u32, disc: &Disc) -> f64 {
        let k = stiffness(laws.between(self.group(row), self.group(row)), 2.0 * disc.radius, 2.0 * disc.radius);
        2.0 * disc.inverse_mass * k.normal.max(3.0 * k.shear)
    }
    /// The particles at rest where they are built, without contacts.
    pub(super) fn begin(&self) -> Particles {
        let disc = |row: usize| {
            let [x, y, radius] = self.built[row];
            Disc { x, y, radius, inverse_mass: 1.0 / self.mass(row), ..Disc::default() }
        };
        let discs: Vec<Disc> = (0..self.len()).map(disc).collect();
        let mean = discs.iter().map(|d| d.radius).sum::<f64>() / discs.len().max(1) as f64;
        Particles {
            skin: SKIN.0 * mean,
            travel: f64::INFINITY,
            chunks: neighbours::chunks(discs.len()),
            discs,
            ..Particles::default()
        }
    }
}

/// Most groups of particles: the number of a pair's law has eight bits.
pub(super) const MOST_GROUPS: usize = 15;

/// Works on every chunk, side by side where there are several.
fn each_chunk(chunks: &mut [Chunk], work: &(dyn Fn(&mut Chunk) + Sync)) {
    match chunks {
        [one] => work(one),
        many => many.par_iter_mut().for_each(work),
    }
}

/// What work on every chunk and its part of some rows gives, side by side where there are several.
fn by_chunks<T: Send, R: Send>(
    chunks: &[Chunk],
    rows: &mut [T],
    work: impl Fn(&Chunk, &mut [T]) -> R + Sync,
) -> Vec<R> {
    match chunks {
        [] => Vec::new(),
        [only] => vec![work(only, rows)],
        many => many.par_iter().zip(rows.par_chunks_mut(chunk::CHUNK)).map(|(one, rows)| work(one, rows)).collect(),
    }
}

impl Particles {
    /// Searches anew if anything may have moved far enough. Returns whether it did.
    pub(super) fn search(&mut self, model: &ParticleModel, blocks: Blocks<'_>, cells: &mut Cells, step: u64) -> bool {
        let idle = self.travel <= 0.5 * self.skin && step < self.searched + SEARCHES.1;
        if self.discs.is_empty() || idle {
            return false;
        }
        if self.travel.is_finite() {
            let mean = self.discs.iter().map(|d| d.radius).sum::<f64>() / self.discs.len() as f64;
            let since = step - self.searched;
            let factor = if since < SEARCHES.0 {
                1.5
            } else if since >= SEARCHES.1 {
                1.0 / 1.5
            } else {
                1.0
            };
            self.skin = (self.skin * factor).clamp(SKIN.0 * mean, SKIN.1 * mean);
        }
        neighbours::find(model, &self.discs, &mut self.chunks, blocks, cells, self.skin);
        self.travel = 0.0;
        self.searched = step;
        true
    }

    /// Forces of all contacts after a step of `dt` [s]; those on blocks are added to `on_blocks`, in the order of the
    /// chunks. Returns the energy lost [J/m].
    pub(super) fn resist(
        &mut self,
        model: &ParticleModel,
        blocks: Blocks<'_>,
        velocities: &[[f64; 3]],
        dt: f64,
        on_blocks: &mut [[f64; 3]],
    ) -> f64 {
        let discs = &self.discs[..];
        let pairs = &model.laws.pairs[..];
        each_chunk(&mut self.chunks, &|chunk| {
            chunk.resist(discs, &model.weights, pairs, dt);
            chunk.lean(discs, blocks, velocities, dt);
        });
        let mut lost = 0.0;
        for chunk in &mut self.chunks {
            for (&block, more) in chunk.blocks.iter().zip(&chunk.on_blocks) {
                let on = &mut on_blocks[block as usize];
                *on = [on[0] + more[0], on[1] + more[1], on[2] + more[2]];
            }
            lost += std::mem::take(&mut chunk.dissipated);
        }
        lost
    }

    /// Moves all particles on: velocities by the first time [s], places by the second. Returns the largest distance moved [m], not finite if a number broke, and the energy
    /// taken out by damping [J/m].
    pub(super) fn integrate(&mut self, damping: Damping, viscosity: f64, (between, dt): (f64, f64)) -> (f64, f64) {
        let (local, share) = match damping {
            Damping::Local(share) => (true, share),
            _ => (false, 0.0),
        };
        let motion = Motion { between, dt, local: share, viscosity };
        let chunks = &self.chunks[..];
        let one = |chunk: &Chunk, discs: &mut [Disc]| match local {
            true => integrate::<true>(discs, chunk, chunks, &motion),
            false => integrate::<false>(discs, chunk, chunks, &motion),
        };
        let tallies: Vec<Tally> = by_chunks(chunks, &mut self.discs, one);
        let (mut fastest, mut check, mut damped) = (0.0_f64, 0.0, 0.0);
        for tally in &tallies {
            fastest = fastest.max(tally.fastest);
            check += tally.check;
            damped += tally.damped;
        }
        let moved = if f64::is_finite(check) { fastest.sqrt() * dt } else { f64::NAN };
        (moved, damped)
    }

    /// Sums for the Rayleigh quotient of the present motion: change of force times velocity [W/m] and twice the kinetic
    /// energy [J/m]. Remembers the forces.
    pub(super) fn rayleigh(&mut self) -> (f64, f64) {
        self.previous.resize(self.discs.len(), [0.0; 3]);
        let (chunks, discs) = (&self.chunks[..], &self.discs[..]);
        let one = |chunk: &Chunk, previous: &mut [Force]| {
            let (mut stiff, mut kinetic) = (0.0, 0.0);
            with_forces(chunk, chunks, |k, force| {
                let (disc, before) = (&discs[chunk.first as usize + k], &mut previous[k]);
                stiff -= disc.vx * (force[0] - before[0])
                    + disc.vy * (force[1] - before[1])
                    + disc.rim * (force[2] - before[2]);
                kinetic += 2.0 * disc.kinetic_energy();
                *before = [force[0], force[1], force[2]];
            });
            (stiff, kinetic)
        };
        let sums: Vec<(f64, f64)> = by_chunks(chunks, &mut self.previous, one);
        sums.iter().fold((0.0, 0.0), |(s, k), (stiff, kinetic)| (s + stiff, k + kinetic))
    }

    /// Sets the inertia of every particle to its mass and gives what was there [m/kg].
    pub(super) fn true_inertia(&mut self, model: &ParticleModel) -> Vec<f64> {
        let true_mass =
            |(row, disc): (usize, &mut Disc)| std::mem::replace(&mut disc.inverse_mass, 1.0 / model.mass(row));
        self.discs.iter_mut().enumerate().map(true_mass).collect()
    }

    /// Gives particles on which springs of more than the middle one's frequency pull as much more inertia as brings them
    /// down to it. `squares` are bounds on the squared frequencies [1/s^2] with the true masses. Returns the kinetic energy
    /// gained by it [J/m].
    pub(super) fn scale_inertia(&mut self, before: &[f64], squares: &[f64]) -> f64 {
        if squares.is_empty() {
            return 0.0;
        }
        let mut sorted = squares.to_vec();
        let middle = *sorted.select_nth_unstable_by(squares.len() / 2, f64::total_cmp).1;
        let mut gained = 0.0;
        for (row, (disc, square)) in self.discs.iter_mut().zip(squares).enumerate() {
            let old = Disc { inverse_mass: before[row], ..*disc }.kinetic_energy();
            let scale = if middle > 0.0 { (square / middle).max(1.0) } else { 1.0 };
            disc.inverse_mass /= scale;
            gained += disc.kinetic_energy() - old;
        }
        gained
    }
}
