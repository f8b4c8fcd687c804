//! CSV tables of particles.

use super::rows::row;
use super::tables::counted;
use crate::collapse::Collapse;
use crate::picture::{Partner, Picture, Snapshot};

/// The state that tables of particles show: the last stable one, or the last of all.
fn shown(picture: &Picture) -> Option<&Snapshot> {
    let at = picture.last_stable.or(picture.snapshots.len().checked_sub(1));
    at.and_then(|k| picture.snapshots.get(k)).filter(|s| s.particles.len() == picture.particles.len())
}

/// Particles at the last stable load: where they are, how far they came since they were packed and since the first
/// state at rest, and their average stress, tension positive.
pub fn particles(c: &Collapse) -> String {
    let (name, unit) = counted(c);
    let mut csv = format!(
        "{name},particle,x_m,y_m,radius_m,layer,since_packed_x_mm,since_packed_y_mm,displacement_x_mm,displacement_y_mm,angle_rad,stress_xx_kpa,stress_yy_kpa,stress_xy_kpa\n"
    );
    let Some(s) = shown(&c.picture) else { return csv };
    let rest = c.picture.snapshots.first().filter(|r| r.particles.len() == s.particles.len()).unwrap_or(s);
    for (k, ((disc, now), then)) in c.picture.particles.iter().zip(&s.particles).zip(&rest.particles).enumerate() {
        let since = |from: [f64; 2]| [0, 1].map(|i| 1e3 * (now.centre[i] - from[i]));
        let layer = c.picture.layers.get(disc.layer).map_or("", |layer| layer);
        let moved = [since(disc.centre), since(then.centre)];
        let stress = now.stress.map(|v| v / 1e3);
        row!(&mut csv, s.load / unit, k, now.centre, disc.radius, layer, moved, now.angle, stress);
    }
    csv
}

/// Contacts of particles at the last stable load, with one another and with blocks.
pub fn particle_contacts(c: &Collapse) -> String {
    let (name, unit) = counted(c);
    let mut csv = format!(
        "{name},particle,partner_kind,partner,x_m,y_m,normal_x,normal_y,compression_kn_per_m,shear_kn_per_m,stress_kpa,sliding\n"
    );
    let Some(s) = shown(&c.picture) else { return csv };
    for f in &s.particle_forces {
        let (kind, partner) = match f.partner {
            Partner::Shape(block) => ("block", block),
            Partner::Particle(other) => ("particle", other),
        };
        let force = [f.compression, f.shear, f.stress].map(|v| v / 1e3);
        row!(&mut csv, s.load / unit, f.particle, kind, partner, f.point, f.normal, force, f.sliding);
    }
    csv
}
