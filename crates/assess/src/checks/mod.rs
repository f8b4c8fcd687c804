//! Checks: one file each, one line each in [`CHECKS`]. A check reads an [`Assessment`], compares a number with its limit,
//! or says why it cannot.

mod adequacy;
mod crown_deflection;
mod fatigue;
mod joint_shear;
pub mod mexe;
mod mexe_check;
pub mod model_factor;
mod movement;
mod permissible;
mod strength;
mod stress;
mod thrust;
mod vehicles;
mod verdict;

pub use verdict::{Verdict, governing, verdict};

use crate::assessment::{Assessment, Stage};
use crate::wire::{JointFacts, ServiceLoadFacts};

/// What a check is: `extrados explain CODE` prints it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Card {
    /// Code, `C…`.
    pub code: &'static str,
    /// In a few words.
    pub title: &'static str,
    /// The clause that it follows, in short.
    pub clause: &'static str,
    /// What is computed and compared, and what to do where it is not met.
    pub text: &'static str,
    /// Where it is from.
    pub source: &'static str,
}

/// A number and its limit.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// The load that it is for.
    pub load_model: String,
    /// The number.
    pub value: f64,
    /// Its limit.
    pub limit: f64,
    /// Unit of both; empty for bare numbers.
    pub unit: &'static str,
    /// How much of the limit is used; above one it is not met.
    pub utilisation: f64,
    /// What was computed, where and how.
    pub basis: String,
    /// Place of the first axle that it belongs to [m], where there is one.
    pub position: Option<f64>,
    /// Self-weight, live load with design augment, their sum, live load with total augment, their sum: the columns of the
    /// railway paper's Table 7, where the check has them.
    pub columns: Option<[f64; 5]>,
    /// Whether this is a check of strength: at ultimate, under factors with a source.
    pub strength: bool,
}

impl Finding {
    /// Whether the limit is met.
    pub fn met(&self) -> bool {
        self.utilisation <= 1.0
    }
}

/// Why a check could not be made.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NotMade {
    /// In words.
    pub why: String,
    /// Whether an analysis that it rests on was asked for and failed: then nothing is settled.
    pub failed: bool,
}

impl NotMade {
    fn because(why: impl Into<String>) -> NotMade {
        NotMade { why: why.into(), failed: false }
    }
}

/// A check.
pub trait Check: Sync {
    /// What it is.
    fn card(&self) -> Card;
    /// Makes it: a finding for every load, place and reading, at least one.
    fn run(&self, assessment: &Assessment) -> Result<Vec<Finding>, NotMade>;
}

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
    &mexe_check::MexeAxle,
    &movement::SupportMovement,
];

/// A check and what came of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked {
    /// What it is.
    pub card: Card,
    /// What came of it.
    pub outcome: Result<Vec<Finding>, NotMade>,
}

/// Makes every check.
pub fn run(assessment: &Assessment) -> Vec<Checked> {
    CHECKS.iter().map(|check| Checked { card: check.card(), outcome: check.run(assessment) }).collect()
}

/// The card of a code.
pub fn cards() -> impl Iterator<Item = Card> {
    CHECKS.iter().map(|check| check.card())
}

/// The facts of a stage, or why there are none.
fn of<T>(stage: &Stage<T>) -> Result<&T, NotMade> {
    let not_made = || NotMade { why: stage.why_not().unwrap_or_default().to_owned(), failed: stage.failed() };
    stage.made().ok_or_else(not_made)
}

/// A limit of the file, or the form of what to write and where its value is found: never a value.
fn limit(given: Option<f64>, form: &str, found: &str) -> Result<f64, NotMade> {
    given.ok_or_else(|| NotMade::because(format!("the file gives no limit: write {form} in [assess], {found}")))
}

/// A finding for every load and every reading of the augment at the joints of the rings.
fn of_joints(
    a: &Assessment,
    augment: impl Fn(&JointFacts) -> f64,
    finding: impl Fn(&JointFacts) -> Finding,
) -> Result<Vec<Finding>, NotMade> {
    let facts = of(&a.service)?;
    let told = |load: &ServiceLoadFacts, joint: &JointFacts| Finding {
        load_model: format!("{}, {} CDA {:.3}", load.name, joint.reading, augment(joint)),
        ..finding(joint)
    };
    let list: Vec<Finding> =
        facts.loads.iter().flat_map(|load| load.joints.iter().map(move |joint| told(load, joint))).collect();
    if list.is_empty() { Err(NotMade::because("no joint was watched while the train crossed")) } else { Ok(list) }
}

/// Use of a limit: the value over it. A limit of zero is met by nothing above zero.
fn used(value: f64, limit: f64) -> f64 {
    match (value, limit) {
        (value, _) if value <= 0.0 => 0.0,
        (value, limit) if limit > 0.0 => value / limit,
        _ => f64::MAX,
    }
}

#[cfg(test)]
mod tests;
