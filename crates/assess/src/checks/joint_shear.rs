//! Shear stress in joints in service.

use super::check::{Check, Probe, limit, of_joints, used};
use crate::evidence::Evidence;
use outcome::checked::{Comparison, NotMade, Unit};

/// The check.
pub(super) const CHECK: Check = Check {
    code: "C105",
    keys: ["service_load", "assess.joint_shear_limit"],
    title: "joint shear",
    clause: "shear stress in joints of the ring",
    text: "The largest shear stress at any point of any joint of the ring, at the moments at which a sensor or \
           a point of the checks has its peak; the effect of the train is increased by the coefficient of \
           dynamic augment. It is compared with joint_shear_limit of [assess]. Values at points are compared, \
           not the mean over the joint, which is lower. If the check is not met, see whether the joint is in \
           compression there: then friction, not adhesion, holds it.",
    source: "the railway paper, section 3.4, which takes a shear strength for the joints of its own bridge",
    probe: Probe::Joints,
    run,
};

fn run(a: &Evidence) -> Result<Vec<Comparison>, NotMade> {
    let limit = limit(
        a.asked.limits.joint_shear,
        "joint_shear_limit = \"… MPa\"",
        "from tests of its joints or the rule that you assess by",
    )? / 1e6;
    of_joints(
        a,
        |joint| joint.shear_augment,
        |joint| Comparison {
            value: joint.shear_mpa,
            limit,
            unit: Unit::Megapascal,
            utilisation: used(joint.shear_mpa, limit),
            basis: joint.shear_at.clone(),
            position: Some(joint.shear_position_m),
            ..Comparison::default()
        },
    )
}
