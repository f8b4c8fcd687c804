//! What the command line says in place of a file's plan.

use super::words::{tolerance, word};
use crate::quantities;
use bridge::{Analysis, ContactLength, ContactPoints, Friction, JointContact, Method};
use clap::Args;
use extrados::Refusal;

/// Which analysis, and how exactly, in place of the file's plan.
#[derive(Debug, Clone, Args)]
pub(crate) struct Choice {
    /// Method, in place of the file's
    #[arg(long, value_parser = word::<Method>())]
    pub method: Option<Method>,
    /// What is made to collapse, in place of the file's
    #[arg(long, value_parser = word::<Analysis>())]
    pub analysis: Option<Analysis>,
    /// Refine the collapse load below the load step to this, such as "1 kN/m"
    #[arg(long, value_name = "LOAD", allow_hyphen_values = true)]
    pub resolution: Option<String>,
    /// What to set in place of the file's plan.
    #[command(flatten)]
    pub overrides: Overrides,
}

/// Numerical settings in place of the file's.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Numerical settings, in place of the file's")]
pub(crate) struct Overrides {
    /// local, viscous or adaptive, the first two with a share: "local:0.8"
    #[arg(long, value_name = "KIND[:SHARE]", value_parser = extrados::damping)]
    pub damping: Option<bridge::Damping>,
    /// Where joints carry what presses them: in points at their ends, or over their compressed part
    #[arg(long, value_parser = word::<JointContact>())]
    pub contact: Option<JointContact>,
    /// Whether the length of a contact point is kept or updated
    #[arg(long, value_parser = word::<ContactLength>())]
    pub contact_length: Option<ContactLength>,
    /// Friction rule of limit analysis
    #[arg(long, value_parser = word::<Friction>())]
    pub friction: Option<Friction>,
    /// Where limit analysis puts the contact points of a joint
    #[arg(long, value_parser = word::<ContactPoints>())]
    pub contact_points: Option<ContactPoints>,
    /// Out-of-balance force at rest over the acting forces, such as 1e-5
    #[arg(long, value_name = "RATIO", value_parser = tolerance)]
    pub tolerance: Option<f64>,
    /// Most iterations in one load step
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub step_limit: Option<u64>,
}

impl Choice {
    /// What was said in place of a file's plan, for a bridge of this width [m].
    pub(crate) fn of(&self, width: f64) -> Result<extrados::Choice, Refusal> {
        let resolution = self.resolution.as_ref().map(|text| quantities::line_load("--resolution", text, width));
        let own = &self.overrides;
        Ok(extrados::Choice {
            analysis: self.analysis,
            method: self.method,
            resolution: resolution.transpose()?,
            damping: own.damping,
            contact: own.contact,
            contact_length: own.contact_length,
            friction: own.friction,
            contact_points: own.contact_points,
            tolerance: own.tolerance,
            step_limit: own.step_limit,
        })
    }
}
