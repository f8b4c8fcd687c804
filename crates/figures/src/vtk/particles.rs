//! Particles as points and the forces between them as lines. There are many of both, so that their numbers have seven
//! digits; tables have all of them.

use super::write::{Array, Grid};
use crate::stress::most_compressive;
use outcome::picture::{DiscState, ParticleForce, Partner, Picture, Snapshot};

/// VTK's numbers of a single point and of a line.
const VERTEX: u8 = 1;
const LINE: u8 = 3;

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
    let count = state.particles.len();
    let real = |value: fn(&DiscState) -> f64| -> Vec<f64> { state.particles.iter().map(value).collect() };
    let points: Vec<f64> = state.particles.iter().flat_map(|p| [p.centre[0], p.centre[1], 0.0]).collect();
    let radius: Vec<f64> = picture.particles.iter().map(|d| d.radius).collect();
    let layer: Vec<i64> = picture.particles.iter().map(|d| d.layer as i64).collect();
    let moved = picture.particles.iter().zip(&state.particles);
    let moved: Vec<f64> =
        moved.flat_map(|(d, now)| [now.centre[0] - d.centre[0], now.centre[1] - d.centre[1], 0.0]).collect();
    let velocity: Vec<f64> = state.particles.iter().flat_map(|p| [p.velocity[0], p.velocity[1], 0.0]).collect();
    let angle = real(|p| p.angle);
    let (xx, yy, xy) = (real(|p| p.stress[0] / 1e3), real(|p| p.stress[1] / 1e3), real(|p| p.stress[2] / 1e3));
    let mean = real(|p| 0.5 * (p.stress[0] + p.stress[1]) / 1e3);
    let compression = real(|p| most_compressive(p.stress) / 1e3);
    let numbers: Vec<i64> = (0..count as i64).collect();
    let ends: Vec<i64> = (1..=count as i64).collect();
    let arrays = [
        Array::whole("particle", &numbers),
        Array::real("radius_m", 1, &radius),
        Array::whole("layer", &layer),
        Array::real("displacement_m", 3, &moved),
        Array::real("velocity", 3, &velocity),
        Array::real("angle", 1, &angle),
        Array::real("stress_xx_kpa", 1, &xx),
        Array::real("stress_yy_kpa", 1, &yy),
        Array::real("stress_xy_kpa", 1, &xy),
        Array::real("stress_mean_kpa", 1, &mean),
        Array::real("compression_kpa", 1, &compression),
    ];
    let grid = Grid {
        short: true,
        remark: PARTICLES,
        field: &[("load", state.load)],
        points: &points,
        connectivity: &numbers,
        offsets: &ends,
        kinds: &vec![VERTEX; count],
        at_points: &arrays,
        at_cells: &[],
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
    let both = list.iter().flat_map(|f| [state.particles[f.particle].centre, end(f)]);
    let points: Vec<f64> = both.flat_map(|[x, y]| [x, y, 0.0]).collect();
    let real = |value: fn(&ParticleForce) -> f64| -> Vec<f64> { list.iter().map(|f| value(f)).collect() };
    let whole = |value: fn(&ParticleForce) -> i64| -> Vec<i64> { list.iter().map(|f| value(f)).collect() };
    let (compression, shear) = (real(|f| f.compression / 1e3), real(|f| f.shear / 1e3));
    let stress = real(|f| f.stress / 1e3);
    let normal: Vec<f64> = list.iter().flat_map(|f| [f.normal[0], f.normal[1], 0.0]).collect();
    let sliding = whole(|f| i64::from(f.sliding));
    let particle = whole(|f| f.particle as i64);
    let block = whole(|f| if let Partner::Shape(k) = f.partner { k as i64 } else { -1 });
    let other = whole(|f| if let Partner::Particle(k) = f.partner { k as i64 } else { -1 });
    let numbers: Vec<i64> = (0..2 * list.len() as i64).collect();
    let ends: Vec<i64> = (1..=list.len() as i64).map(|k| 2 * k).collect();
    let arrays = [
        Array::real("compression_kn_per_m", 1, &compression),
        Array::real("shear_kn_per_m", 1, &shear),
        Array::real("stress_kpa", 1, &stress),
        Array::real("normal", 3, &normal),
        Array::whole("sliding", &sliding),
        Array::whole("particle", &particle),
        Array::whole("partner_particle", &other),
        Array::whole("partner_block", &block),
    ];
    let grid = Grid {
        short: true,
        remark: FORCES,
        field: &[("load", state.load)],
        points: &points,
        connectivity: &numbers,
        offsets: &ends,
        kinds: &vec![LINE; list.len()],
        at_points: &[],
        at_cells: &arrays,
    };
    Some(grid.file())
}
