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
    let shear_modulus = || Some(masonry.elastic_modulus? / (2.0 * (1.0 + masonry.poisson_ratio?)));
    ContactLaw {
        normal: stiffness(joint.normal_stiffness, masonry.elastic_modulus),
        shear: stiffness(joint.shear_stiffness, shear_modulus()),
        friction: joint.friction_angle.tan(),
        cohesion: joint.cohesion,
        tension: joint.tensile_strength,
        crushing: masonry.compressive_strength.unwrap_or(f64::INFINITY),
        fixed_length: joint.fixed_length,
        least_length: joint.least_length.unwrap_or(LEAST_LENGTH_SHARE * length),
    }
}

pub(crate) fn stiffness(given: Option<JointStiffness>, body: Option<f64>) -> Stiffness {
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
