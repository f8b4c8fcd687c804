//! Checks: one file each, one line each in [`CHECKS`]. A check reads an [`Evidence`], compares a number with its limit,
//! or says why it cannot.

mod adequacy;
mod bearing;
mod by_file;
mod by_rule;
mod cases;
mod check;
mod crown_deflection;
mod fatigue;
mod foot;
mod given;
mod joint_shear;
pub mod mexe;
mod mexe_check;
mod movement;
mod onset;
mod permissible;
mod stress;
mod thrust;
mod vehicles;
mod verdict;

pub use check::{Check, CheckCard, Probe};
pub use outcome::checked::{Verdict, governing};
pub use verdict::verdict;

use crate::evidence::Evidence;
use outcome::checked::Checked;

/// Every check, in the order of reports.
pub const CHECKS: &[&dyn Check] = &[
    &crown_deflection::CrownDeflection,
    &stress::Crown,
    &stress::Abutment,
    &stress::Pier,
    &joint_shear::JointShear,
    &thrust::ThrustZone,
    &adequacy::Adequacy,
    &permissible::PermissibleShare,
    &fatigue::StressRange,
    &vehicles::Vehicles,
    &onset::Onset,
    &cases::NamedCases,
    &mexe_check::MexeAxle,
    &movement::SupportMovement,
    &bearing::Bearing,
    &foot::FootEccentricity,
];

/// Makes every check.
pub fn run(assessment: &Evidence) -> Vec<Checked> {
    let made = |check: &&dyn Check| {
        let [code, title, clause] = [check.card().code, check.card().title, check.card().clause].map(str::to_owned);
        let keys = check.card().keys.map(str::to_owned);
        Checked { code, title, clause, keys, outcome: check.run(assessment) }
    };
    CHECKS.iter().map(made).collect()
}

/// The card of a code.
pub fn cards() -> impl Iterator<Item = CheckCard> {
    CHECKS.iter().map(|check| check.card())
}

#[cfg(test)]
mod tests;
