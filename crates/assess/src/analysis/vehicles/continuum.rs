//! Vehicles on fill that yields as a continuum: the case that governs each of them where fill is weight is answered again between two bounds,
//! and the smaller factor counts. Other positions are not: they take seconds each.

use super::super::by_bounds;
use super::super::pieces::{self, Stage};
use super::{AnalysisError, factored};
use crate::vehicles::Chosen;
use bridge::{Bridge, SweepPlan};
use mechanics::watch::Watch;
use outcome::collapse::Status;
use outcome::vehicles::Swept;
use rules::Rule;
use structure::discretise::continuum;

/// Upper over lower bound to which a case is answered: the lower one counts.
const RATIO: f64 = 1.2;

/// Whether the vehicles of a bridge are asked on a continuum.
pub(super) fn is_wanted(bridge: &Bridge) -> bool {
    continuum::wanted(bridge).is_some()
}

/// Puts the lower bound of the governing case of each vehicle in front where it is the smaller one. Tells whether all of it was done.
pub(super) fn beside(
    bridge: &Bridge,
    (rule, plan): (&Rule, &SweepPlan),
    vehicles: &[Chosen],
    swept: &mut [Swept],
    watch: &mut dyn Watch,
) -> Result<bool, AnalysisError> {
    let jobs: Vec<usize> = (0..swept.len()).filter(|&k| swept[k].case.is_some()).collect();
    let stage = Stage { name: "vehicles on fill that yields", steps: jobs.len() as u64, shares: [0.0, 1.0] };
    let (found, done) = pieces::each(&jobs, &stage, watch, |&k, pace| {
        let Some(case) = &swept[k].case else { return Ok::<_, AnalysisError>(None) };
        let own = factored::bridge(bridge, rule, &case.weights);
        let one = factored::with_case(&own, plan, rule, &vehicles[k], case);
        let found = by_bounds::bracket(&one, RATIO, pace)?;
        pace.step();
        // What is carried without a load on the fill bounds nothing.
        Ok((found.status != Status::Locks).then_some(found))
    });
    for (&k, answer) in jobs.iter().zip(found) {
        let Some(answer) = answer.transpose()?.flatten() else { continue };
        swept[k]
            .counts(answer.lower.filter(|_| answer.status == Status::Collapsed).map(|f| f * rule.capacity_factor()));
    }
    Ok(done)
}
