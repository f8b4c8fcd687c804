//! Contact laws from the joints of the bridge file.

use bridge::{Bridge, Joint, JointStiffness, SpandrelWall};
use mechanics::blocks::{ContactLaw, Stiffness};

/// The same of a body that fills a share of the width: strength of its own belongs to that share, friction does not depend on it.
pub fn shared(law: ContactLaw, share: f64) -> ContactLaw {
    ContactLaw { cohesion: share * law.cohesion, tension: share * law.tension, crushing: share * law.crushing, ..law }
}

/// Share of the ring thickness below which the length of a contact point is not updated, where the file gives none
/// (after Coulomb, as in Rouxinol, Providência and Lemos, Table 2).
pub const LEAST_LENGTH_SHARE: f64 = 0.1;

/// The law of a joint of the rings. A stiffness that the file leaves out is infinite: limit analysis needs none, and the discrete
/// element method refuses to run with it.
pub fn law(bridge: &Bridge, joint: &Joint) -> ContactLaw {
    let thinnest = bridge
        .spans
        .iter()
        .flat_map(|s| &s.rings)
        .map(|r| r.crown_thickness.min(r.springing_thickness))
        .fold(f64::INFINITY, f64::min);
    of_length(bridge, joint, thinnest)
}

/// The law of the joints of a spandrel wall.
pub fn wall(bridge: &Bridge, wall: &SpandrelWall) -> ContactLaw {
    of_length(bridge, &wall.joint, wall.brick_height)
}

/// The law of joints that are at least so long [m].
fn of_length(bridge: &Bridge, joint: &Joint, length: f64) -> ContactLaw {
    let masonry = &bridge.masonry;
    let crushing = masonry.compressive_strength.unwrap_or(f64::INFINITY);
    contact(joint, moduli(masonry.elastic_modulus, masonry.poisson_ratio), crushing, LEAST_LENGTH_SHARE * length)
}

/// Elastic and shear modulus of a material.
pub(crate) fn moduli(elastic: Option<f64>, poisson_ratio: Option<f64>) -> [Option<f64>; 2] {
    let shear = || Some(elastic? / (2.0 * (1.0 + poisson_ratio?)));
    [elastic, shear()]
}

/// The law of a joint between bodies of these moduli and this strength; the least length is for joints that give none.
pub(crate) fn contact(joint: &Joint, moduli: [Option<f64>; 2], crushing: f64, least_length: f64) -> ContactLaw {
    ContactLaw {
        normal: stiffness(joint.normal_stiffness, moduli[0]),
        shear: stiffness(joint.shear_stiffness, moduli[1]),
        friction: joint.friction_angle.tan(),
        cohesion: joint.cohesion,
        tension: joint.tensile_strength,
        crushing,
        fixed_length: joint.fixed_length,
        least_length: joint.least_length.unwrap_or(least_length),
    }
}

fn stiffness(given: Option<JointStiffness>, body: Option<f64>) -> Stiffness {
    match (given, body) {
        (Some(JointStiffness::Contact(k)), _) => Stiffness::Given(k),
        (Some(JointStiffness::Series(joint)), Some(body)) => Stiffness::Series { joint, body },
        _ => Stiffness::Given(f64::INFINITY),
    }
}

/// Whether the discrete element method can use the law.
pub fn has_stiffness(law: &ContactLaw) -> bool {
    let finite = |s: Stiffness| match s {
        Stiffness::Given(k) => k.is_finite() && k > 0.0,
        Stiffness::Series { joint, body } => joint > 0.0 && body.is_finite() && body > 0.0,
    };
    finite(law.normal) && finite(law.shear)
}
