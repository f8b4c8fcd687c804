//! Contact laws of all pairs of materials.

use super::{Body, Particle, Said};
use crate::discretise::laws::{LEAST_LENGTH_SHARE, contact, moduli};
use bridge::blocks::{BlockFile, Material, MaterialJoint};
use bridge::{Joint, TextRange};
use mechanics::blocks::{ContactLaw, LawTable, Stiffness};
use mechanics::ids::{GroupId, Id};

/// The law of every pair; pairs of materials in use that no joint describes are said.
pub(super) fn laws(file: &BlockFile, bodies: &[Body], particles: &[Particle], said: &mut Said) -> LawTable {
    let count = file.materials.len();
    let side = bodies.iter().map(|body| area(&body.outline)).fold(f64::INFINITY, f64::min).sqrt();
    let side = if bodies.is_empty() { particles.iter().map(|p| 2.0 * p.radius).fold(side, f64::min) } else { side };
    let least = if side.is_finite() { LEAST_LENGTH_SHARE * side } else { LEAST_LENGTH_SHARE };
    let mut table = LawTable::uniform(count, frictionless(least));
    let mut of_blocks = vec![false; count];
    bodies.iter().for_each(|body| of_blocks[body.material] = true);
    let mut of_particles = vec![false; count];
    particles.iter().for_each(|particle| of_particles[particle.material] = true);
    let used = |material: usize| of_blocks[material] || of_particles[material];
    let touched = |a: usize, b: usize| (of_particles[a] && used(b)) || (of_particles[b] && used(a));
    let mut bare = Vec::new();
    for a in 0..count {
        for b in a..count {
            let own = file.joints.iter().find(|joint| joint.between == Some([a, b]));
            let found = own.or_else(|| file.joints.iter().find(|joint| joint.between.is_none()));
            match found {
                Some(found) => {
                    let mut law = law(&found.joint, [&file.materials[a], &file.materials[b]], least);
                    if touched(a, b) {
                        loose(file, [a, b], found, &law, of_blocks[a] && of_blocks[b], said);
                        (law.tension, law.crushing) = (0.0, f64::INFINITY);
                    }
                    table.set(GroupId::new(a), GroupId::new(b), law);
                }
                None if used(a) && used(b) => {
                    bare.push(format!("{} and {}", file.materials[a].name, file.materials[b].name));
                }
                None => {}
            }
        }
    }
    if !bare.is_empty() {
        let message = format!("no [[joint]] describes the contact of {}", bare.join("; of "));
        let help = "add a [[joint]] with `first` and `second`, or one without them for all other pairs".to_owned();
        said.error("D405", TextRange::new(0, 0), message, "a pair of materials without a joint", help);
    }
    table
}

/// Contacts of particles neither stick nor crush. What a joint gives them of either is said, unless it is a strength that
/// no two blocks could need: then it is that of a material alone, and goes unused.
fn loose(file: &BlockFile, [a, b]: [usize; 2], joint: &MaterialJoint, law: &ContactLaw, blocks: bool, said: &mut Said) {
    let pair = format!("{} and {}", file.materials[a].name, file.materials[b].name);
    if law.tension > 0.0 {
        let message = format!("contacts of particles have no tensile strength, and those of {pair} have some");
        let help = "write tensile_strength = \"0 kPa\" in a [[joint]] of this pair".to_owned();
        said.error("D408", joint.range, message, "particles do not stick", help);
    }
    if law.crushing.is_finite() && blocks {
        let message = format!("contacts of particles do not crush, and those of {pair} are contacts of blocks too");
        let help =
            "give the particles a material of their own, or write compressive_strength = \"unlimited\"".to_owned();
        said.error("D408", joint.range, message, "particles and blocks share this joint", help);
    }
}

fn area(points: &[[f64; 2]]) -> f64 {
    let n = points.len();
    let cross = |i: usize| points[i][0] * points[(i + 1) % n][1] - points[i][1] * points[(i + 1) % n][0];
    0.5 * (0..n).map(cross).sum::<f64>().abs()
}

/// Stands where a pair never meets.
fn frictionless(least_length: f64) -> ContactLaw {
    ContactLaw {
        normal: Stiffness::Given(f64::INFINITY),
        shear: Stiffness::Given(f64::INFINITY),
        friction: 0.0,
        cohesion: 0.0,
        tension: 0.0,
        crushing: f64::INFINITY,
        fixed_length: None,
        least_length,
    }
}

fn law(joint: &Joint, [a, b]: [&Material; 2], least: f64) -> ContactLaw {
    // Half of the way between the two centres lies in each material.
    let together = |p: Option<f64>, q: Option<f64>| Some(2.0 / (1.0 / p? + 1.0 / q?));
    let [p, q] = [a, b].map(|m| moduli(m.masonry.elastic_modulus, m.masonry.poisson_ratio));
    let strength = |m: &Material| m.masonry.compressive_strength.unwrap_or(f64::INFINITY);
    // The weaker of the two crushes.
    let crushing = strength(a).min(strength(b));
    contact(joint, [together(p[0], q[0]), together(p[1], q[1])], crushing, least)
}
