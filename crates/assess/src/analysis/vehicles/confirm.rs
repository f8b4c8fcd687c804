//! The governing case by discrete elements.

use super::super::collapse_by_dem;
use super::super::report::Status;
use bridge::{Bridge, Method};
use mechanics::watch::Watch;
use rules::Rule;

/// The governing case by discrete elements.
#[derive(Debug, Clone, PartialEq)]
pub struct Confirmation {
    /// How it ended; none where it could not be made.
    pub status: Option<Status>,
    /// Adequacy factor of the last load step that was carried.
    pub adequacy: Option<f64>,
    /// The same by limit analysis.
    pub limit: Option<f64>,
    /// Load step, as an adequacy factor.
    pub step: f64,
    /// Why it could not be made.
    pub reason: Option<String>,
}

/// Load steps up to the limit load: the last stable step lies within a fortieth of the collapse load.
const STEPS: f64 = 40.0;

/// Raises the loads of a case in steps until it collapses.
pub fn confirm(case: &Bridge, rule: &Rule, limit: Option<f64>, watch: &mut dyn Watch) -> Confirmation {
    let mut found = Confirmation { status: None, adequacy: None, limit, step: 0.0, reason: None };
    let capacity = rule.capacity_factor();
    let Some(factor) = limit.map(|adequacy| adequacy / capacity) else { return found };
    let mut b = case.clone();
    b.plan.method = Method::Dem;
    let reference: f64 = crate::discretise::discretise(&b).map_or(0.0, |d| d.reference_load);
    b.plan.load_step = Some(reference * factor / STEPS);
    b.plan.load_limit = Some(1.5 * reference * factor);
    found.step = factor * capacity / STEPS;
    match collapse_by_dem(&b, None, watch) {
        Ok(c) => {
            found.status = Some(c.status);
            found.adequacy = c.last_stable_load.map(|load| load / reference * capacity);
        }
        Err(error) => found.reason = Some(error.to_string()),
    }
    found
}
