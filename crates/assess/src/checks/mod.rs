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

pub use check::{Check, Probe};
pub use outcome::checked::{Verdict, governing};
pub use verdict::verdict;

use crate::evidence::Evidence;
use outcome::checked::Checked;

/// Every check, in the order of reports.
pub const CHECKS: &[Check] = &[
    crown_deflection::CHECK,
    stress::CROWN,
    stress::ABUTMENT,
    stress::PIER,
    joint_shear::CHECK,
    thrust::CHECK,
    adequacy::CHECK,
    permissible::CHECK,
    fatigue::CHECK,
    vehicles::CHECK,
    onset::CHECK,
    cases::CHECK,
    mexe_check::CHECK,
    movement::CHECK,
    bearing::CHECK,
    foot::CHECK,
];

/// Makes every check.
pub fn run(assessment: &Evidence) -> Vec<Checked> {
    let made = |check: &Check| {
        let [code, title, clause] = [check.code, check.title, check.clause].map(str::to_owned);
        Checked { code, title, clause, keys: check.keys.map(str::to_owned), outcome: (check.run)(assessment) }
    };
    CHECKS.iter().map(made).collect()
}

#[cfg(test)]
mod tests;
