//! A stretch of particles and the contacts that it owns. Chunks are the same for any number of threads, and so are the
//! sums: each chunk adds up its own forces, and what others exert on its particles is added in the order of the chunks.

use super::disc::Disc;
use super::laws::PairLaw;
use super::lean::Lean;
use super::neighbours::Blocks;

/// Particles of one chunk: enough work to be worth handing over, few enough to stay in a core's own cache
/// (4,096 particles and their contacts take about 0.7 MB).
pub(in crate::dem) const CHUNK: usize = 4096;

/// A pair of particles close enough to touch before the next search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::dem) struct Contact {
    /// The other particle, and the number of the law in the upper eight bits.
    tagged: u32,
    /// Row of the owner's force, and of the other's.
    pub one: u16,
    pub two: u16,
    /// Shear force [N/m], positive when it acts on the other particle along the normal turned left.
    pub shear: f64,
    /// Stiffness [Pa].
    pub normal_stiffness: f64,
    pub shear_stiffness: f64,
}

/// Most particles of a model: ids share a word with the number of the law.
pub(in crate::dem) const MOST_PARTICLES: usize = 1 << 24;

impl Contact {
    pub fn new(other: u32, law: u8, rows: (u16, u16), shear: f64, stiffness: (f64, f64)) -> Contact {
        Contact {
            tagged: other | u32::from(law) << 24,
            one: rows.0,
            two: rows.1,
            shear,
            normal_stiffness: stiffness.0,
            shear_stiffness: stiffness.1,
        }
    }
    #[inline(always)]
    pub fn other(&self) -> usize {
        (self.tagged & 0x00FF_FFFF) as usize
    }
    #[inline(always)]
    pub fn law(&self) -> usize {
        (self.tagged >> 24) as usize
    }
}

/// A force that another chunk exerts on a particle of this one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::dem) struct Incoming {
    pub chunk: u32,
    pub row: u16,
    pub local: u16,
}

/// Forces [N/m] on a particle: along x, along y, and along its rim.
pub(in crate::dem) type Force = [f64; 3];

/// A stretch of particles.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::dem) struct Chunk {
    /// First particle, and how many.
    pub first: u32,
    pub count: u32,
    /// Contacts of these particles with later ones, sorted by both.
    pub contacts: Vec<Contact>,
    /// Contacts of these particles with blocks, sorted by particle and block.
    pub leans: Vec<Lean>,
    /// Particles of later chunks that contacts of this one act on, ascending: rows `count..` of `forces`.
    pub guests: Vec<u32>,
    /// Forces that this chunk's contacts exert.
    pub forces: Vec<Force>,
    /// Forces of other chunks on these particles, by chunk.
    pub incoming: Vec<Incoming>,
    /// Blocks that these particles may touch, ascending, and the force [N/m] and moment [N] on each.
    pub blocks: Vec<u32>,
    pub on_blocks: Vec<Force>,
    /// Energy lost in friction and opened contacts since it was last collected [J/m].
    pub dissipated: f64,
}

impl Chunk {
    /// Forces of all pairs of particles of this chunk after a step of `dt` [s].
    /// What acts on each particle begins with its weight.
    pub fn resist(&mut self, discs: &[Disc], weights: &[[f64; 2]], laws: &[PairLaw], dt: f64) {
        let range = self.first as usize..(self.first + self.count) as usize;
        let (own, guests) = self.forces.split_at_mut(self.count as usize);
        own.iter_mut().zip(&weights[range]).for_each(|(force, w)| *force = [w[0], w[1], 0.0]);
        guests.fill([0.0; 3]);
        let own = &discs[self.first as usize..(self.first + self.count) as usize];
        let (groups, rest) = self.contacts.as_chunks_mut::<LANES>();
        let mut dissipated = 0.0;
        for group in groups {
            dissipated += resist(group, own, discs, laws, dt, &mut self.forces);
        }
        for one in rest {
            dissipated += resist(std::array::from_mut(one), own, discs, laws, dt, &mut self.forces);
        }
        self.dissipated += dissipated;
    }
}

/// Contacts worked on side by side, so that square roots and divisions, which are most of the time, come in vectors.
const LANES: usize = 4;

/// The larger of two numbers; one instruction, where `f64::max` takes five to be right about NaN.
#[inline(always)]
pub(in crate::dem) fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The smaller of two numbers.
#[inline(always)]
pub(in crate::dem) fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// Forces of `N` contacts; returns the energy lost [J/m].
///
/// A contact point lies on the line of centres where it divides the distance as the radii: both arms shrink by the same
/// share with the overlap, so that the moments of a pair balance exactly. An open pair goes through the same arithmetic
/// with a cap of nothing: no branch to guess wrong.
#[inline(always)]
fn resist<const N: usize>(
    contacts: &mut [Contact; N],
    own: &[Disc],
    discs: &[Disc],
    laws: &[PairLaw],
    dt: f64,
    forces: &mut [Force],
) -> f64 {
    let zero = [0.0_f64; N];
    let (mut dx, mut dy, mut sum, mut ux, mut uy, mut rims) = (zero, zero, zero, zero, zero, zero);
    let (mut bond, mut friction) = (zero, zero);
    for k in 0..N {
        let (a, b) = (&own[contacts[k].one as usize], &discs[contacts[k].other()]);
        let law = &laws[contacts[k].law()];
        (dx[k], dy[k], sum[k]) = (b.x - a.x, b.y - a.y, a.radius + b.radius);
        (ux[k], uy[k], rims[k]) = (b.vx - a.vx, b.vy - a.vy, a.rim + b.rim);
        (bond[k], friction[k]) = (law.cohesion + law.cohesion_share * sum[k], law.friction);
    }
    let (mut fx, mut fy, mut turn, mut lost) = (zero, zero, zero, zero);
    for k in 0..N {
        let distance = (dx[k] * dx[k] + dy[k] * dy[k]).sqrt();
        // One division for both reciprocals; two centres never coincide unless something has broken.
        let reciprocal = 1.0 / (distance * sum[k]);
        let (unit, arm) = (reciprocal * sum[k], distance * distance * reciprocal);
        let (nx, ny) = (dx[k] * unit, dy[k] * unit);
        let overlap = sum[k] - distance;
        let compression = contacts[k].normal_stiffness * larger(overlap, 0.0);
        let glide = nx * uy[k] - ny * ux[k] - arm * rims[k];
        let trial = contacts[k].shear - contacts[k].shear_stiffness * glide * dt;
        let cap = if overlap > 0.0 { bond[k] + friction[k] * compression } else { 0.0 };
        let shear = smaller(larger(trial, -cap), cap);
        // What the spring cannot hold slides, against the mean of the old and the new force.
        lost[k] = (contacts[k].shear + shear) * (trial - shear);
        contacts[k].shear = shear;
        (fx[k], fy[k], turn[k]) = (compression * nx - shear * ny, compression * ny + shear * nx, shear * arm);
    }
    let mut dissipated = 0.0;
    for k in 0..N {
        let on = &mut forces[contacts[k].one as usize];
        *on = [on[0] - fx[k], on[1] - fy[k], on[2] - turn[k]];
        let on = &mut forces[contacts[k].two as usize];
        *on = [on[0] + fx[k], on[1] + fy[k], on[2] - turn[k]];
        if lost[k] != 0.0 {
            dissipated += 0.5 * lost[k] / contacts[k].shear_stiffness;
        }
    }
    dissipated
}

impl Chunk {
    /// Adds the forces of the leans; those on blocks are kept in `on_blocks`.
    pub fn lean(&mut self, discs: &[Disc], blocks: Blocks<'_>, velocities: &[[f64; 3]], dt: f64) {
        self.on_blocks.fill([0.0; 3]);
        for lean in &mut self.leans {
            let disc = &discs[(self.first + lean.local) as usize];
            let block = lean.block as usize;
            let Some(push) = lean.resist(disc, &blocks.cores[block], &blocks.poses[block], &velocities[block], dt)
            else {
                continue;
            };
            let on = &mut self.forces[lean.local as usize];
            *on = [on[0] + push.force.x, on[1] + push.force.y, on[2] + push.rim];
            let on = &mut self.on_blocks[lean.row as usize];
            *on = [on[0] - push.force.x, on[1] - push.force.y, on[2] + push.moment];
            self.dissipated += push.dissipated;
        }
    }
    /// Bytes held.
    pub fn bytes(&self) -> usize {
        use std::mem::size_of;
        size_of::<Contact>() * self.contacts.capacity()
            + size_of::<Lean>() * self.leans.capacity()
            + size_of::<Force>() * (self.forces.capacity() + self.on_blocks.capacity())
            + size_of::<Incoming>() * self.incoming.capacity()
            + 4 * (self.guests.capacity() + self.blocks.capacity())
    }
}
