//! Stiffness of joints for equilibrium paths, where the file gives none.
//!
//! Masonry gives more than its units do: its joints are taken to be as stiff as if the masonry between the middles of two
//! voussoirs had a tenth of the modulus of its units. That is the ratio of Bridgemill's published joints (4.84 GPa/m over
//! 0.31 m, units of 15 GPa), and soft for what is known of masonry: the load errs to the low side.

use super::state::{self, Change};
use bridge::{Bridge, Joint, StiffnessAsked};
use outcome::warning::{self, Warning};

/// Modulus of the masonry as a share of that of its units.
const SHARE: f64 = 0.1;

/// Poisson's ratio where the file gives none.
const POISSON_RATIO: f64 = 0.2;

/// The same where the plan's method is the equilibrium path, with what is to be said of it.
pub(super) fn for_paths(bridge: &Bridge) -> Option<(Bridge, Option<Warning>)> {
    (bridge.plan.method.stiffness() == StiffnessAsked::OrModulus).then(|| (stiffened(bridge), note(bridge)))
}

/// The bridge with a stiffness for all of its joints, where its units have a modulus.
pub fn stiffened(bridge: &Bridge) -> Bridge {
    state::with(bridge, &[Change::DefaultStiffness])
}

/// What is to be said of joints whose stiffness the file does not give.
pub(super) fn note(bridge: &Bridge) -> Option<Warning> {
    let open = |joint: &Joint| joint.normal_stiffness.is_none() || joint.shear_stiffness.is_none();
    let several = bridge.spans.iter().any(|span| span.rings.len() > 1);
    if !(open(&bridge.joint) || several && open(&bridge.ring_joint)) {
        return None;
    }
    let [normal, shear] = taken(bridge)?;
    Some(warning::Joints::StiffnessTaken { normal, shear }.into())
}

/// Normal and shear stiffness [Pa/m]; none where the modulus of the units is not known.
pub(super) fn taken(bridge: &Bridge) -> Option<[f64; 2]> {
    let modulus = SHARE * bridge.masonry.elastic_modulus?;
    let ratio = bridge.masonry.poisson_ratio.unwrap_or(POISSON_RATIO);
    let rings = bridge.spans.iter().flat_map(|span| span.rings.iter().map(move |ring| (span, ring)));
    // Half of the perimeter of the ellipse with this span and rise, a few percent long for flat profiles.
    let length = |span: &bridge::Span| {
        let (a, b) = (0.5 * span.span, span.rise);
        std::f64::consts::FRAC_PI_2 * (3.0 * (a + b) - ((3.0 * a + b) * (a + 3.0 * b)).sqrt())
    };
    let longest = rings.map(|(span, ring)| length(span) / ring.voussoirs as f64).fold(0.0, f64::max);
    (longest > 0.0).then(|| [modulus / longest, modulus / (2.0 * (1.0 + ratio)) / longest])
}

#[cfg(test)]
mod tests {
    use super::*;
    use bridge::JointStiffness;

    #[test]
    fn joints_without_a_stiffness_take_it_from_the_modulus_and_say_so() {
        let mut bridge = crate::samples::bridgemill();
        assert_eq!((stiffened(&bridge), note(&bridge)), (bridge.clone(), None));
        (bridge.joint.normal_stiffness, bridge.joint.shear_stiffness) = (None, None);
        let Some(JointStiffness::Contact(normal)) = stiffened(&bridge).joint.normal_stiffness else { panic!("none") };
        // The published joints of this bridge: 4.84 GPa/m.
        assert!((normal / 4.84e9 - 1.0).abs() < 0.15, "{normal}");
        assert_eq!(note(&bridge).unwrap().code(), warning::STIFFNESS_TAKEN);
        bridge.masonry.elastic_modulus = None;
        assert_eq!((stiffened(&bridge), note(&bridge)), (bridge.clone(), None));
    }
}
