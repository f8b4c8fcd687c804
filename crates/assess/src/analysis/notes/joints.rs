//! What is to be said of joints: cohesion and tension in limit analysis, joints between rings that were not described, and a ring
//! that has none.

use crate::analysis::by_fe::Sliding;
use bridge::{Bridge, Joint};
use outcome::warning::{self, Warning};

/// A ring in one piece that is thicker than this [m] is thicker than a brick is long.
const BRICK: f64 = 0.25;

/// Blocks that stand only as far as they are jammed.
pub fn jammed() -> Warning {
    let message = "without dilation blocks stand by friction on compressions that self-stress alone brings about: what they carry depends \
                   on how hard they were jammed, and no load is known. Where they were not, they slip";
    Warning::new(warning::JAMMED, message)
}

/// Joints that are held against sliding by the method alone.
pub fn would_slide(found: Sliding) -> Warning {
    let Sliding { from, at, joints, most, place } = found;
    let now = match joints {
        0 => format!("at {:.2} kN/m none does any more", at / 1e3),
        _ => format!("at {:.2} kN/m {joints} do, by up to {most:.2} times, at x = {place:.2} m", at / 1e3),
    };
    let message = format!(
        "joints do not slide in this method, and from {:.2} kN/m on some carry more shear than friction and cohesion hold: {now}",
        from / 1e3
    );
    Warning::new(warning::HELD_AGAINST_SLIDING, message)
}

/// Cohesion and tension of joints in limit analysis.
pub fn cohesive(bridge: &Bridge) -> Option<Warning> {
    let joints = [Some(&bridge.joint), (most_rings(bridge) > 1).then_some(&bridge.ring_joint)];
    let of = |value: fn(&Joint) -> f64| joints.iter().flatten().map(|joint| value(joint)).fold(0.0, f64::max);
    let (cohesion, tension) = (of(|joint| joint.cohesion), of(|joint| joint.tensile_strength));
    let mut told = Vec::new();
    if cohesion > 0.0 {
        told.push(match bridge.masonry.compressive_strength {
            Some(strength) => format!(
                "cohesion of {:.1} kPa acts where joints are compressed, as a friction coefficient that is {:.4} \
                 larger",
                cohesion / 1e3,
                cohesion / strength
            ),
            None => format!("cohesion of {:.1} kPa is left out, because joints turn about an edge", cohesion / 1e3),
        });
    }
    if tension > 0.0 {
        told.push(format!("a tensile strength of {:.1} kPa acts as if it never broke", tension / 1e3));
    }
    (!told.is_empty()).then(|| Warning::new(warning::COHESION_PRESSED, told.join("; ")))
}

/// Most rings of a span.
fn most_rings(bridge: &Bridge) -> usize {
    bridge.spans.iter().map(|span| span.rings.len()).max().unwrap_or(0)
}

/// Joints between rings that were not described, and a thick ring that has none.
pub fn between_rings(bridge: &Bridge) -> Vec<Warning> {
    let mut told = Vec::new();
    let bonded = bridge.ring_joint.cohesion > 0.0 || bridge.ring_joint.tensile_strength > 0.0;
    if most_rings(bridge) > 1 && bonded && bridge.ring_joint == bridge.joint {
        let message = format!(
            "joints between rings have the cohesion of [joint], {:.1} kPa: describe them in [ring_joint]",
            bridge.joint.cohesion / 1e3
        );
        told.push(Warning::new(warning::RING_JOINT_COPIED, message));
    }
    let single = bridge.spans.iter().filter(|span| span.rings.len() == 1);
    let thickest = single.map(|span| span.rings[0].crown_thickness).fold(0.0, f64::max);
    if thickest > BRICK {
        let message = format!(
            "a ring of {thickest:.3} m is modelled in one piece: separation of brick rings is not \
                               checked"
        );
        told.push(Warning::new(warning::ONE_PIECE, message));
    }
    told
}

#[cfg(test)]
mod tests {
    use super::*;

    fn codes(bridge: &Bridge) -> Vec<&'static str> {
        between_rings(bridge).into_iter().chain(cohesive(bridge)).map(|warning| warning.code).collect()
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
