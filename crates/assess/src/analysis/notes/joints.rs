//! What is to be said of joints: cohesion and tension in limit analysis, joints between rings that were not described, and a ring
//! that has none.

use bridge::{Bridge, Joint};
use outcome::warning;

/// A ring in one piece that is thicker than this [m] is thicker than a brick is long.
const BRICK: f64 = 0.25;

/// Cohesion and tension of joints in limit analysis [Pa], with the strength of the masonry, where there is any.
pub(crate) fn bond(bridge: &Bridge) -> Option<(f64, f64, Option<f64>)> {
    let joints = [Some(&bridge.joint), (most_rings(bridge) > 1).then_some(&bridge.ring_joint)];
    let of = |value: fn(&Joint) -> f64| joints.iter().flatten().map(|joint| value(joint)).fold(0.0, f64::max);
    let (cohesion, tension) = (of(|joint| joint.cohesion), of(|joint| joint.tensile_strength));
    (cohesion > 0.0 || tension > 0.0).then_some((cohesion, tension, bridge.masonry.compressive_strength))
}

/// Most rings of a span.
fn most_rings(bridge: &Bridge) -> usize {
    bridge.spans.iter().map(|span| span.rings.len()).max().unwrap_or(0)
}

/// Joints between rings that were not described, and a thick ring that has none.
pub(crate) fn between_rings(bridge: &Bridge) -> Vec<warning::Joints> {
    let mut told = Vec::new();
    let bonded = bridge.ring_joint.cohesion > 0.0 || bridge.ring_joint.tensile_strength > 0.0;
    if most_rings(bridge) > 1 && bonded && bridge.ring_joint == bridge.joint {
        told.push(warning::Joints::RingJointCopied { cohesion: bridge.joint.cohesion });
    }
    let single = bridge.spans.iter().filter(|span| span.rings.len() == 1);
    let thickest = single.map(|span| span.rings[0].crown_thickness).fold(0.0, f64::max);
    if thickest > BRICK {
        told.push(warning::Joints::OnePiece { thickness: thickest });
    }
    told
}

#[cfg(test)]
mod tests {
    use super::*;

    fn codes(bridge: &Bridge) -> Vec<&'static str> {
        let cohesive = bond(bridge).map(|_| warning::COHESION_PRESSED);
        between_rings(bridge).iter().map(warning::Joints::code).chain(cohesive).collect()
    }

    #[test]
    fn cohesion_that_nobody_described_between_rings_is_told() {
        let mut b = crate::samples::bridgemill();
        assert_eq!(codes(&b), ["A194"]);
        let half = bridge::Ring { crown_thickness: 0.2, ..b.spans[0].rings[0].clone() };
        b.spans[0].rings = vec![half.clone(), half];
        assert!(codes(&b).is_empty());
        b.joint.cohesion = 100e3;
        b.ring_joint = b.joint;
        assert_eq!(codes(&b), ["A193", "A192"]);
        b.ring_joint.cohesion = 0.0;
        assert_eq!(codes(&b), ["A192"]);
    }
}
