//! A stretch of particles and the contacts that it owns. Chunks are the same for any number of threads, and so are the
//! sums: each chunk adds up its own forces, and what others exert on its particles is added in the order of the chunks.

use super::disc::Disc;
use super::laws::PairLaw;
use super::lean::Lean;
use super::neighbours::Blocks;
use super::quad::{ByFours, Quad, by_fours};
use pulp::{cast, f64x4};
use serde::{Deserialize, Serialize};

/// Particles of one chunk: enough work to be worth handing over, few enough to stay in a core's own cache
/// (4,096 particles and their contacts take about 0.7 MB).
pub(in crate::dem) const CHUNK: usize = 4096;

/// A pair of particles close enough to touch before the next search.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(in crate::dem) struct Contact {
    /// The other particle, and the number of the law in the upper eight bits.
    pub tagged: u32,
    /// Row of the owner's force, and of the other's.
    pub one: u16,
    #[serde(skip)]
    pub two: u16,
    /// Shear force [N/m], positive when it acts on the other particle along the normal turned left.
    pub shear: f64,
    /// Stiffness [Pa].
    #[serde(skip)]
    pub normal_stiffness: f64,
    #[serde(skip)]
    pub shear_stiffness: f64,
}

/// Most particles of a model: ids share a word with the number of the law.
pub(in crate::dem) const MOST_PARTICLES: usize = 1 << 24;

impl Contact {
    #[inline(always)]
    pub(crate) fn other(&self) -> usize {
        (self.tagged & 0x00FF_FFFF) as usize
    }
    #[inline(always)]
    pub(crate) fn law(&self) -> usize {
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

/// The same as one vector of the processor, in one cache line; the fourth number is nothing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(align(32))]
pub(in crate::dem) struct Row(pub [f64; 4]);

/// A stretch of particles.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(in crate::dem) struct Chunk {
    /// First particle, and how many.
    pub first: u32,
    pub count: u32,
    /// Contacts of these particles with later ones, sorted by both.
    pub contacts: Vec<Contact>,
    /// Contacts of these particles with blocks, sorted by particle and block.
    pub leans: Vec<Lean>,
    /// Particles of later chunks that contacts of this one act on, ascending: rows `count..` of `forces`.
    #[serde(skip)]
    pub guests: Vec<u32>,
    /// Forces that this chunk's contacts exert.
    #[serde(skip)]
    pub forces: Vec<Row>,
    /// Forces of other chunks on these particles, by chunk.
    #[serde(skip)]
    pub incoming: Vec<Incoming>,
    /// Blocks that these particles may touch, ascending, and the force [N/m] and moment [N] on each.
    #[serde(skip)]
    pub blocks: Vec<u32>,
    #[serde(skip)]
    pub on_blocks: Vec<Force>,
    /// Energy lost in friction and opened contacts since it was last collected [J/m].
    #[serde(skip)]
    pub dissipated: f64,
}

impl Chunk {
    /// Forces of all pairs of particles of this chunk after a step of `dt` [s].
    /// What acts on each particle begins with its weight.
    pub(crate) fn resist(&mut self, discs: &[Disc], weights: &[[f64; 2]], laws: &[PairLaw], dt: f64) {
        let range = self.first as usize..(self.first + self.count) as usize;
        let (own, guests) = self.forces.split_at_mut(self.count as usize);
        own.iter_mut().zip(&weights[range]).for_each(|(force, w)| *force = Row([w[0], w[1], 0.0, 0.0]));
        guests.fill(Row::default());
        let own = &discs[self.first as usize..(self.first + self.count) as usize];
        let (contacts, forces) = (&mut self.contacts[..], &mut self.forces[..]);
        self.dissipated += match laws {
            [only] => by_fours(Pairs { contacts, forces, own, discs, law: |_: &Contact| only, dt }),
            many => by_fours(Pairs { contacts, forces, own, discs, law: |c: &Contact| &many[c.law()], dt }),
        };
    }
}

/// The pairs of a chunk.
struct Pairs<'a, L> {
    contacts: &'a mut [Contact],
    forces: &'a mut [Row],
    own: &'a [Disc],
    discs: &'a [Disc],
    law: L,
    dt: f64,
}

impl<'a, L: Fn(&Contact) -> &'a PairLaw> ByFours for Pairs<'a, L> {
    type Output = f64;

    /// Forces of all pairs, four by four; returns the energy lost [J/m].
    #[inline(always)]
    fn work<Q: Quad>(self, quad: Q) -> f64 {
        let Pairs { contacts, forces, own, discs, law, dt } = self;
        let (groups, rest) = contacts.as_chunks_mut::<4>();
        let mut lost = quad.splat_f64s(0.0);
        for group in groups {
            lost = quad.add_f64s(lost, resist(quad, (group, 4), (own, discs), &law, dt, forces));
        }
        let mut dissipated: f64 = cast::<_, [f64; 4]>(lost).iter().sum();
        if let Some(&last) = rest.last() {
            let mut group = [last; 4];
            group[..rest.len()].copy_from_slice(rest);
            let lost = resist(quad, (&mut group, rest.len()), (own, discs), &law, dt, forces);
            dissipated += cast::<_, [f64; 4]>(lost)[..rest.len()].iter().sum::<f64>();
            rest.copy_from_slice(&group[..rest.len()]);
        }
        dissipated
    }
}

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

/// Forces of four contacts, of which the first `count` count; returns the energies lost [J/m].
///
/// A contact point lies on the line of centres where it divides the distance as the radii: both arms shrink by the same
/// share with the overlap, so that the moments of a pair balance exactly. An open pair goes through the same arithmetic
/// with a cap of nothing: no branch to guess wrong.
#[inline(always)]
fn resist<'a, Q: Quad>(
    quad: Q,
    (contacts, count): (&mut [Contact; 4], usize),
    (own, discs): (&[Disc], &[Disc]),
    law: &impl Fn(&Contact) -> &'a PairLaw,
    dt: f64,
    forces: &mut [Row],
) -> f64x4 {
    let nothing = quad.splat_f64s(0.0);
    let (mut motion, mut size, mut memory, mut laws) = ([nothing; 4], [nothing; 4], [nothing; 4], [nothing; 4]);
    for k in 0..4 {
        let contact = &contacts[k];
        let (a, b) = (&own[contact.one as usize], &discs[contact.other()]);
        motion[k] = quad.sub_f64s(cast([b.x, b.y, b.vx, b.vy]), cast([a.x, a.y, a.vx, a.vy]));
        size[k] = quad.add_f64s(
            cast([a.rim, a.radius, a.inverse_mass, a.rolled]),
            cast([b.rim, b.radius, b.inverse_mass, b.rolled]),
        );
        memory[k] = cast([contact.shear, contact.normal_stiffness, contact.shear_stiffness, 0.0]);
        let law = law(contact);
        laws[k] = cast([law.cohesion, law.cohesion_share, law.friction, 0.0]);
    }
    let [dx, dy, ux, uy] = quad.transpose(motion);
    let [rims, sum, ..] = quad.transpose(size);
    let [old, normal_stiffness, shear_stiffness, _] = quad.transpose(memory);
    let [bond, bond_share, friction, _] = quad.transpose(laws);

    let plus = |a, b| quad.add_f64s(a, b);
    let minus = |a, b| quad.sub_f64s(a, b);
    let times = |a, b| quad.mul_f64s(a, b);
    let distance = quad.sqrt_f64s(plus(times(dx, dx), times(dy, dy)));
    // One division for both reciprocals; two centres never coincide unless something has broken.
    let reciprocal = quad.div_f64s(quad.splat_f64s(1.0), times(distance, sum));
    let (unit, arm) = (times(reciprocal, sum), times(times(distance, distance), reciprocal));
    let (nx, ny) = (times(dx, unit), times(dy, unit));
    let overlap = minus(sum, distance);
    let compression = times(normal_stiffness, quad.larger(overlap, nothing));
    let glide = minus(minus(times(nx, uy), times(ny, ux)), times(arm, rims));
    let trial = minus(old, times(times(shear_stiffness, glide), quad.splat_f64s(dt)));
    let most = plus(plus(bond, times(bond_share, sum)), times(friction, compression));
    let cap = quad.where_positive(overlap, most);
    let shear = quad.smaller(quad.larger(trial, minus(nothing, cap)), cap);
    // What the spring cannot hold slides, against the mean of the old and the new force.
    let slid = times(plus(old, shear), minus(trial, shear));
    let lost = quad
        .div_f64s(times(quad.splat_f64s(0.5), slid), quad.larger(shear_stiffness, quad.splat_f64s(f64::MIN_POSITIVE)));
    let fx = minus(times(compression, nx), times(shear, ny));
    let fy = plus(times(compression, ny), times(shear, nx));
    let turn = times(shear, arm);
    let on_one = quad.transpose([fx, fy, turn, nothing]);
    let on_two = quad.transpose([fx, fy, minus(nothing, turn), nothing]);

    let shear: [f64; 4] = cast(shear);
    for k in 0..count {
        contacts[k].shear = shear[k];
        let on = &mut forces[contacts[k].one as usize].0;
        *on = cast(quad.sub_f64s(cast(*on), on_one[k]));
        let on = &mut forces[contacts[k].two as usize].0;
        *on = cast(quad.add_f64s(cast(*on), on_two[k]));
    }
    lost
}

impl Chunk {
    /// Adds the forces of the leans; those on blocks are kept in `on_blocks`.
    pub(crate) fn lean(&mut self, discs: &[Disc], blocks: Blocks<'_>, velocities: &[[f64; 3]], dt: f64) {
        self.on_blocks.fill([0.0; 3]);
        for lean in &mut self.leans {
            let disc = &discs[(self.first + lean.local) as usize];
            let block = lean.block as usize;
            let Some(push) = lean.resist(disc, &blocks.cores[block], &blocks.poses[block], &velocities[block], dt)
            else {
                continue;
            };
            let on = &mut self.forces[lean.local as usize].0;
            *on = [on[0] + push.force.x, on[1] + push.force.y, on[2] + push.rim, 0.0];
            let on = &mut self.on_blocks[lean.row as usize];
            *on = [on[0] - push.force.x, on[1] - push.force.y, on[2] + push.moment];
            self.dissipated += push.dissipated;
        }
    }
    /// Bytes held.
    pub(crate) fn bytes(&self) -> usize {
        use std::mem::size_of;
        size_of::<Contact>() * self.contacts.capacity()
            + size_of::<Lean>() * self.leans.capacity()
            + size_of::<Row>() * self.forces.capacity()
            + size_of::<Force>() * self.on_blocks.capacity()
            + size_of::<Incoming>() * self.incoming.capacity()
            + 4 * (self.guests.capacity() + self.blocks.capacity())
    }
}
