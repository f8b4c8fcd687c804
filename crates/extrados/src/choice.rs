//! What a caller says in place of a file's plan.

use bridge::{Analysis, ContactLength, ContactPoints, Damping, Friction, JointContact, Method, Plan};

/// Entries of `[analysis]` that take the place of the file's; what is none stays as the file has it.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Choice {
    /// What is sought.
    pub analysis: Option<Analysis>,
    /// By which method.
    pub method: Option<Method>,
    /// How sharp a collapse load is wanted by discrete elements, per metre of width [N/m].
    pub resolution: Option<f64>,
    /// Damping of discrete elements.
    pub damping: Option<Damping>,
    /// Where joints carry what presses them.
    pub contact: Option<JointContact>,
    /// Length of contacts in discrete elements.
    pub contact_length: Option<ContactLength>,
    /// Friction rule of limit analysis.
    pub friction: Option<Friction>,
    /// Where contact points lie.
    pub contact_points: Option<ContactPoints>,
    /// Residual at which blocks are at rest.
    pub tolerance: Option<f64>,
    /// Most steps of discrete elements for one load.
    pub step_limit: Option<u64>,
}

/// Damping as callers write it: local, viscous or adaptive, the first two with a share, "local:0.8".
///
/// # Errors
/// What to write in the place of words that are none of these.
pub fn damping(text: &str) -> Result<Damping, &'static str> {
    let (kind, share) = text.split_once(':').map_or((text, None), |(kind, share)| (kind, Some(share)));
    let share = match share.map(str::parse::<f64>) {
        None => None,
        Some(Ok(share)) if share > 0.0 && share <= 1.0 => Some(share),
        Some(_) => return Err("the share lies above 0 and up to 1"),
    };
    match (kind, share) {
        ("local", share) => Ok(Damping::Local(share.unwrap_or(0.8))),
        ("viscous", share) => Ok(Damping::Viscous(share.unwrap_or(0.8))),
        ("adaptive", None) => Ok(Damping::Adaptive),
        ("adaptive", Some(_)) => Err("adaptive damping finds its own intensity: give no share"),
        _ => Err("write local, viscous or adaptive, such as local:0.8"),
    }
}

impl Choice {
    /// Puts what was chosen into a plan.
    pub fn apply(&self, plan: &mut Plan) {
        plan.analysis = self.analysis.unwrap_or(plan.analysis);
        plan.method = self.method.unwrap_or(plan.method);
        plan.resolution = self.resolution.or(plan.resolution);
        plan.damping = self.damping.unwrap_or(plan.damping);
        plan.contact = self.contact.or(plan.contact);
        plan.contact_length = self.contact_length.unwrap_or(plan.contact_length);
        plan.friction = self.friction.unwrap_or(plan.friction);
        plan.contact_points = self.contact_points.unwrap_or(plan.contact_points);
        plan.tolerance = self.tolerance.unwrap_or(plan.tolerance);
        plan.step_limit = self.step_limit.unwrap_or(plan.step_limit);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn damping_takes_a_share() {
        assert_eq!(damping("local:0.7"), Ok(Damping::Local(0.7)));
        assert_eq!(damping("adaptive"), Ok(Damping::Adaptive));
        assert!(damping("local:2").is_err() && damping("soft").is_err() && damping("adaptive:0.5").is_err());
    }
}
