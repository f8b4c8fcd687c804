//! Particles as points and the forces between them as lines. There are many of both, so that their numbers have seven
//! digits; tables have all of them.

use super::write::{Array, Cells, Grid};
use crate::stress::most_compressive;
use outcome::picture::{DiscState, ParticleForce, Partner, Picture, Snapshot};

const PARTICLES: &str = "Particles where they are in this state, one metre wide; y up. Glyph with Sphere or 2D Circle, scaled by radius_m (scale factor 2 for a glyph of radius 0.5), shows them. displacement_m: since they were packed. velocity in m/s, angle in rad. stress_*_kpa: average of the particle, tension positive; compression_kpa: most compressive principal stress, compression positive. layer: counted from 0 from the extrados up.";

const FORCES: &str = "Forces between particles, and between particles and blocks, per metre of width, in this state. Each line joins the centres, or a centre and the place of contact; Tube with radius by compression_kn_per_m shows force chains. shear_kn_per_m: positive when the force on the particle acts along the normal (from the partner to the particle) turned left. partner_block and partner_particle: -1 where it is not one.";

/// The particles of a snapshot, where there are any.
fn of(picture: &Picture, snapshot: usize) -> Option<&Snapshot> {
    let state = picture.snapshots.get(snapshot)?;
    (!state.particles.is_empty() && state.particles.len() == picture.particles.len()).then_some(state)
}

/// Particles at one snapshot as points. None without particles.
pub fn particles(picture: &Picture, snapshot: usize) -> Option<String> {
    let state = of(picture, snapshot)?;
    let now = || state.particles.iter();
    let real = |name, value: fn(&DiscState) -> f64| Array::real(name, 1, now().map(value));
    let moved = picture.particles.iter().zip(now()).map(|(d, now)| [0, 1].map(|k| now.centre[k] - d.centre[k]));
    let grid = Grid {
        short: true,
        remark: PARTICLES,
        field: &[("load", state.load)],
        points: now().map(|p| p.centre).collect(),
        cells: Cells::points(state.particles.len()),
        at_points: vec![
            Array::whole("particle", 0..state.particles.len() as i64),
            Array::real("radius_m", 1, picture.particles.iter().map(|d| d.radius)),
            Array::whole("layer", picture.particles.iter().map(|d| d.layer as i64)),
            Array::vectors("displacement_m", moved),
            Array::vectors("velocity", now().map(|p| p.velocity)),
            real("angle", |p| p.angle),
            real("stress_xx_kpa", |p| p.stress[0] / 1e3),
            real("stress_yy_kpa", |p| p.stress[1] / 1e3),
            real("stress_xy_kpa", |p| p.stress[2] / 1e3),
            real("stress_mean_kpa", |p| 0.5 * (p.stress[0] + p.stress[1]) / 1e3),
            real("compression_kpa", |p| most_compressive(p.stress) / 1e3),
        ],
        ..Grid::default()
    };
    Some(grid.file())
}

/// Forces on particles at one snapshot as lines. None without particles.
pub fn particle_forces(picture: &Picture, snapshot: usize) -> Option<String> {
    let state = of(picture, snapshot)?;
    let known = |f: &&ParticleForce| {
        let partner = match f.partner {
            Partner::Particle(other) => other < state.particles.len(),
            Partner::Shape(_) => true,
        };
        partner && f.particle < state.particles.len()
    };
    let list: Vec<&ParticleForce> = state.particle_forces.iter().filter(known).collect();
    let end = |f: &ParticleForce| match f.partner {
        Partner::Particle(other) => state.particles[other].centre,
        Partner::Shape(_) => f.point,
    };
    let real = |name, value: fn(&ParticleForce) -> f64| Array::real(name, 1, list.iter().map(|f| value(f)));
    let whole = |name, value: fn(&ParticleForce) -> i64| Array::whole(name, list.iter().map(|f| value(f)));
    let grid = Grid {
        short: true,
        remark: FORCES,
        field: &[("load", state.load)],
        points: list.iter().flat_map(|f| [state.particles[f.particle].centre, end(f)]).collect(),
        cells: Cells::of(Cells::LINE, (0..list.len()).map(|k| [2 * k, 2 * k + 1])),
        at_cells: vec![
            real("compression_kn_per_m", |f| f.compression / 1e3),
            real("shear_kn_per_m", |f| f.shear / 1e3),
            real("stress_kpa", |f| f.stress / 1e3),
            Array::vectors("normal", list.iter().map(|f| f.normal)),
            whole("sliding", |f| i64::from(f.sliding)),
            whole("particle", |f| f.particle as i64),
            whole("partner_particle", |f| if let Partner::Particle(k) = f.partner { k as i64 } else { -1 }),
            whole("partner_block", |f| if let Partner::Shape(k) = f.partner { k as i64 } else { -1 }),
        ],
        ..Grid::default()
    };
    Some(grid.file())
}
