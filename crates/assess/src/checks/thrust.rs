//! The line of thrust in service.

use super::check::{Check, Probe, of_joints, used};
use crate::evidence::Evidence;
use outcome::checked::{Comparison, NotMade, Unit};

/// The check.
pub(super) const CHECK: Check = Check {
    code: "C106",
    keys: ["service_load", "assess.thrust_zone"],
    title: "thrust line",
    clause: "thrust within the middle third or the middle half of the ring",
    text: "The distance of the resultant from the middle of a joint over the joint's depth, from the tractions \
           of the finite element model, at the moments at which a sensor or a point of the checks has its \
           peak; the effect of the train is increased by the coefficient of dynamic augment. Within the middle \
           third (0.167) a joint stays closed; within the middle half (0.25) it stays closed over three \
           quarters of its depth. thrust_zone of [assess] says which is required. In many sound arches the \
           thrust leaves the middle third under a heavy axle: this is a check on cracking and on the life of \
           joints, not on strength.",
    source: "Heyman, The Masonry Arch (1982): middle third rule; the middle half is the serviceability rule of UIC practice [recalled]",
    probe: Probe::Joints,
    run,
};

fn run(a: &Evidence) -> Result<Vec<Comparison>, NotMade> {
    let zone = a.asked.limits.thrust_zone.ok_or_else(|| NotMade::because(no_zone(a)))?;
    let limit = 0.5 * zone;
    of_joints(
        a,
        |joint| joint.eccentricity_augment,
        |joint| Comparison {
            value: joint.eccentricity,
            limit,
            unit: Unit::OfTheDepth,
            utilisation: used(joint.eccentricity, limit),
            basis: joint.eccentricity_at.clone(),
            position: Some(joint.eccentricity_position_m),
            ..Comparison::default()
        },
    )
}

/// What to write, and how far the thrust goes where that is known: a reader should not have to ask for a limit to see it.
fn no_zone(a: &Evidence) -> String {
    let write = "the file gives no zone: write thrust_zone = \"middle-third\" or \"middle-half\" in [assess]";
    let loads = a.facts.service.made().map_or(&[][..], |facts| &facts.loads);
    let farthest = loads.iter().flat_map(|load| &load.joints).map(|joint| joint.eccentricity).fold(0.0, f64::max);
    match farthest > 0.0 {
        true => format!(
            "{write}; in service the thrust goes {farthest:.3} of the depth from the middle of a joint (middle third 0.167, middle \
             half 0.25, face 0.5)"
        ),
        false => write.to_owned(),
    }
}
