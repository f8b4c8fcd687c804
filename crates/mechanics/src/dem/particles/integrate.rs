//! Newton's law for the particles of one chunk.

use super::chunk::{Chunk, Force, larger, smaller};
use super::disc::Disc;

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

/// Calls `each` with every particle of a chunk and the whole force on it, its weight included.
#[inline(always)]
pub(in crate::dem) fn with_forces(chunk: &Chunk, chunks: &[Chunk], mut each: impl FnMut(usize, Force)) {
    let mut incoming = chunk.incoming.iter().peekable();
    for (k, force) in chunk.forces[..chunk.count as usize].iter().enumerate() {
        let mut force = force.force();
        while let Some(from) = incoming.next_if(|from| from.local as usize == k) {
            let more = chunks[from.chunk as usize].forces[from.row as usize].force();
            force = [force[0] + more[0], force[1] + more[1], force[2] + more[2]];
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
    let Motion { between, dt, local, viscosity } = *motion;
    let half = 0.5 * viscosity * between;
    let (share, slow) = (1.0 / (1.0 + half), 2.0 * half / (1.0 + half));
    let mut tally = Tally::default();
    with_forces(chunk, chunks, |k, force| {
        let disc = &mut discs[k];
        // A disc's moment of inertia is half of m r^2, so its rim is accelerated by twice force over mass.
        let scale = disc.inverse_mass * between;
        let push = [force[0] * scale, force[1] * scale, 2.0 * force[2] * scale];
        let old = [disc.vx, disc.vy, disc.rim];
        let mut new = [0.0; 3];
        let mut drain = [0.0; 3];
        for c in 0..3 {
            let mean_free = old[c] + 0.5 * push[c];
            if LOCAL {
                let most = local * push[c].abs();
                let against = smaller(larger(mean_free, -most), most);
                new[c] = old[c] + push[c] - against;
                drain[c] = against * 0.5 * (old[c] + new[c]);
            } else {
                new[c] = old[c] + push[c] * share - slow * old[c];
                let mean = 0.5 * (old[c] + new[c]);
                drain[c] = viscosity * between * mean * mean;
            }
        }
        tally.damped += (drain[0] + drain[1] + 0.5 * drain[2]) / disc.inverse_mass;
        [disc.vx, disc.vy, disc.rim] = new;
        disc.x += new[0] * dt;
        disc.y += new[1] * dt;
        disc.rolled += new[2] * dt;
        let square = new[0] * new[0] + new[1] * new[1];
        tally.fastest = larger(square, tally.fastest);
        tally.check += square + new[2] * new[2];
    });
    tally
}
