//! Newton's law for the particles of one chunk.

use super::chunk::{Chunk, Row, larger};
use super::disc::Disc;
use super::quad::{ByFours, Quad, by_fours};
use pulp::cast;

/// What acts on all particles alike in one step.
#[derive(Debug, Clone, Copy)]
pub(in crate::dem) struct Motion {
    /// Time between the old velocities and the new [s], and time step [s]; one where the step has not just changed.
    pub between: f64,
    pub dt: f64,
    /// Share of local damping.
    pub local: f64,
    /// Viscous damping [1/s].
    pub viscosity: f64,
}

/// What a chunk's step tells.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::dem) struct Tally {
    /// Square of the largest speed [m^2/s^2].
    pub fastest: f64,
    /// Sum of all squares: not finite if a number broke.
    pub check: f64,
    /// Energy taken out by damping [J/m].
    pub damped: f64,
}

/// Calls `each` with every particle of a chunk and the whole force on it, its weight included (the fourth number is nothing).
#[inline(always)]
pub(in crate::dem) fn with_forces(chunk: &Chunk, chunks: &[Chunk], mut each: impl FnMut(usize, [f64; 4])) {
    let mut incoming = chunk.incoming.iter().peekable();
    for (k, &Row(mut force)) in chunk.forces[..chunk.count as usize].iter().enumerate() {
        while let Some(from) = incoming.next_if(|from| from.local as usize == k) {
            let Row(more) = chunks[from.chunk as usize].forces[from.row as usize];
            force = std::array::from_fn(|i| force[i] + more[i]);
        }
        each(k, force);
    }
}

/// Moves the particles of a chunk on; local damping as for blocks.
pub(in crate::dem) fn integrate<const LOCAL: bool>(
    discs: &mut [Disc],
    chunk: &Chunk,
    chunks: &[Chunk],
    motion: &Motion,
) -> Tally {
    by_fours(Integration::<LOCAL> { discs, chunk, chunks, motion })
}

struct Integration<'a, const LOCAL: bool> {
    discs: &'a mut [Disc],
    chunk: &'a Chunk,
    chunks: &'a [Chunk],
    motion: &'a Motion,
}

impl<const LOCAL: bool> ByFours for Integration<'_, LOCAL> {
    type Output = Tally;

    /// The four numbers of a particle are its velocities along x, along y and of its rim, and its radius, which nothing pushes.
    #[inline(always)]
    fn work<Q: Quad>(self, quad: Q) -> Tally {
        let Motion { between, dt, local, viscosity } = *self.motion;
        let half = 0.5 * viscosity * between;
        let (share, slow) = (quad.splat_f64s(1.0 / (1.0 + half)), quad.splat_f64s(2.0 * half / (1.0 + half)));
        let (local, viscous, middle) =
            (quad.splat_f64s(local), quad.splat_f64s(viscosity * between), quad.splat_f64s(0.5));
        // A disc's moment of inertia is half of m r^2, so its rim is accelerated by twice force over mass.
        let turns = cast([1.0, 1.0, 2.0, 0.0]);
        let inertia = cast([1.0, 1.0, 0.5, 0.0]);
        let nothing = quad.splat_f64s(0.0);
        let plus = |a, b| quad.add_f64s(a, b);
        let minus = |a, b| quad.sub_f64s(a, b);
        let times = |a, b| quad.mul_f64s(a, b);
        let mut tally = Tally::default();
        let mut damped = nothing;
        let discs = self.discs;
        with_forces(self.chunk, self.chunks, |k, force| {
            let disc = &mut discs[k];
            let push = times(cast(force), times(turns, quad.splat_f64s(disc.inverse_mass * between)));
            let old = cast([disc.vx, disc.vy, disc.rim, disc.radius]);
            let (new, drain) = if LOCAL {
                let most = times(local, quad.larger(push, minus(nothing, push)));
                let mean_free = plus(old, times(middle, push));
                let against = quad.smaller(quad.larger(mean_free, minus(nothing, most)), most);
                let new = minus(plus(old, push), against);
                (new, times(against, times(middle, plus(old, new))))
            } else {
                let new = minus(plus(old, times(push, share)), times(slow, old));
                let mean = times(middle, plus(old, new));
                (new, times(viscous, times(mean, mean)))
            };
            damped = plus(damped, quad.div_f64s(times(inertia, drain), quad.splat_f64s(disc.inverse_mass)));
            let [vx, vy, rim, _]: [f64; 4] = cast(new);
            (disc.vx, disc.vy, disc.rim) = (vx, vy, rim);
            disc.x += vx * dt;
            disc.y += vy * dt;
            disc.rolled += rim * dt;
            let square = vx * vx + vy * vy;
            tally.fastest = larger(square, tally.fastest);
            tally.check += square + rim * rim;
        });
        tally.damped = cast::<_, [f64; 4]>(damped)[..3].iter().sum();
        tally
    }
}
