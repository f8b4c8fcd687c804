//! What a check is, and how each asks for facts, limits and their use.

use crate::evidence::Evidence;
use outcome::assessment::Stage;
use outcome::checked::{Comparison, NotMade};
use outcome::facts::{JointFacts, ServiceLoadFacts};

/// The cheapest analysis that shows how the utilisation of a check changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Probe {
    /// The train at a few positions about the one that governs; sensors alone.
    Sensors,
    /// The same with joints.
    Joints,
    /// Limit analysis with the loads where they govern.
    Collapse,
    /// Limit analysis of the governing vehicle alone.
    Vehicle,
    /// The check itself.
    Itself,
    /// A whole analysis for every value, which nobody waits for.
    Whole,
}

/// A check: `extrados explain CODE` prints its words.
#[derive(Debug, Clone, Copy)]
pub struct Check {
    /// Code, `C…`.
    pub code: &'static str,
    /// Where a bridge file says for what the value is computed, and where its limit is.
    pub keys: [&'static str; 2],
    /// In a few words.
    pub title: &'static str,
    /// The clause that it follows, in short.
    pub clause: &'static str,
    /// What is computed and compared, and what to do where it is not met.
    pub text: &'static str,
    /// Where it is from.
    pub source: &'static str,
    /// How its sensitivities are found.
    pub probe: Probe,
    /// Makes it: a finding for every load, place and reading, at least one; or why it cannot be made, for there are no facts, limits or
    /// properties, or an analysis failed.
    pub run: fn(&Evidence) -> Result<Vec<Comparison>, NotMade>,
}

/// The facts of a stage, or why there are none.
pub(super) fn of<T>(stage: &Stage<T>) -> Result<&T, NotMade> {
    let not_made = || NotMade {
        why: stage.why_not().unwrap_or_default().to_owned(),
        failed: stage.failed(),
        left_out: stage.left_out().map(str::to_owned),
    };
    stage.made().ok_or_else(not_made)
}

/// A limit of the file, or the form of what to write and where its value is found: never a value.
pub(super) fn limit(given: Option<f64>, form: &str, found: &str) -> Result<f64, NotMade> {
    given.ok_or_else(|| NotMade::because(format!("the file gives no limit: write {form} in [assess], {found}")))
}

/// A finding for every load and every reading of the augment at the joints of the rings.
pub(super) fn of_joints(
    a: &Evidence,
    augment: impl Fn(&JointFacts) -> f64,
    finding: impl Fn(&JointFacts) -> Comparison,
) -> Result<Vec<Comparison>, NotMade> {
    let facts = of(&a.facts.service)?;
    let told = |load: &ServiceLoadFacts, joint: &JointFacts| Comparison {
        load_model: format!("{}, {} CDA {:.3}", load.name, joint.reading, augment(joint)),
        ..finding(joint)
    };
    let list: Vec<Comparison> =
        facts.loads.iter().flat_map(|load| load.joints.iter().map(move |joint| told(load, joint))).collect();
    unless_empty(list, "no joint was watched while the train crossed")
}

/// What was compared, or why nothing was.
pub(super) fn unless_empty(list: Vec<Comparison>, why: impl Into<String>) -> Result<Vec<Comparison>, NotMade> {
    if list.is_empty() { Err(NotMade::because(why)) } else { Ok(list) }
}

/// Use of a limit: the value over it. A limit of zero is met by nothing above zero.
pub(super) fn used(value: f64, limit: f64) -> f64 {
    match (value, limit) {
        (value, _) if value <= 0.0 => 0.0,
        (value, limit) if limit > 0.0 => value / limit,
        _ => f64::MAX,
    }
}
