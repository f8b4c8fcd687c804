//! What a bridge's joints are to engines whose joints deform.

use crate::analysis::AnalysisError;
use bridge::{Bridge, ContactLength, JointContact, Plan, Strip};
use mechanics::blocks::{ContactLaw, Stiffness};
use mechanics::contact;
use structure::discretise::laws;

/// Where joints press, by the plan, or by a method's own choice where that does not say.
pub(crate) fn contact_length(plan: &Plan, own: JointContact) -> contact::ContactLength {
    match (plan.contact.unwrap_or(own), plan.contact_length) {
        (JointContact::Distributed, _) => contact::ContactLength::Distributed,
        (JointContact::Points, ContactLength::Fixed) => contact::ContactLength::Fixed,
        (JointContact::Points, ContactLength::Updated) => contact::ContactLength::Updated,
    }
}

/// A law with its stiffness multiplied.
pub(crate) fn stiffer(law: &ContactLaw, multiple: f64) -> ContactLaw {
    let times = |stiffness: Stiffness| match stiffness {
        Stiffness::Given(k) => Stiffness::Given(multiple * k),
        Stiffness::Series { joint, body } => Stiffness::Series { joint: multiple * joint, body: multiple * body },
    };
    ContactLaw { normal: times(law.normal), shear: times(law.shear), ..*law }
}

/// Refuses joints without stiffness.
pub(crate) fn require_stiffness(bridge: &Bridge) -> Result<(), AnalysisError> {
    if !laws::has_stiffness(&laws::law(bridge, &bridge.joint)) {
        return Err(AnalysisError::NoStiffness { joint: "joints" });
    }
    if bridge.spans.iter().any(|s| s.rings.len() > 1) && !laws::has_stiffness(&laws::law(bridge, &bridge.ring_joint)) {
        return Err(AnalysisError::NoStiffness { joint: "joints between rings" });
    }
    if bridge.plan.strip != Strip::Fill
        && let Some(wall) = &bridge.spandrel_wall
        && !laws::has_stiffness(&laws::wall(bridge, wall))
    {
        return Err(AnalysisError::NoStiffness { joint: "joints of the spandrel wall" });
    }
    Ok(())
}
