//! The governing case by discrete elements: a second method, whose joints bear on two points.
//!
//! A joint of discrete elements bears on two points near its edges. Each stands for half the joint and crushes only when it
//! carries half the joint times the strength, so that a hinge there turns about the very edge: crushing would be left out. In
//! masonry of strength f a thrust N needs a strip of N / f to bear on and turns about the middle of that strip, N / 2f inside
//! the edge. So the points are put there: the corners of the blocks are rounded by that much more, with the thrusts of limit
//! analysis at its hinges.

use super::super::engine;
use super::super::state::{self, Change};
use bridge::{Bridge, Method};
use mechanics::watch::Watch;
use outcome::collapse::{Collapse, Status};
use outcome::vehicles::ByDiscreteElements;
use rules::Rule;

/// Load steps up to the limit load: the last stable step lies within a fortieth of the collapse load.
const STEPS: f64 = 40.0;

/// Raises the loads of a case in steps until it collapses. `by_limit` is the same case by limit analysis.
pub(super) fn carried(
    case: &Bridge,
    by_limit: &Collapse,
    rule: &Rule,
    limit: Option<f64>,
    watch: &mut dyn Watch,
) -> ByDiscreteElements {
    let mut found = ByDiscreteElements { status: None, adequacy: None, limit, step: 0.0, inset: None, reason: None };
    let capacity = rule.capacity_factor();
    let Some(factor) = limit.map(|adequacy| adequacy / capacity) else { return found };
    // The same fill as in limit analysis.
    let mut b = state::with(case, &[Change::Method(Method::Dem), Change::ParticlesAsWeight]);
    if let Some(inset) = inset(&b, by_limit) {
        let mut with = b.clone();
        with.masonry.rounding += inset;
        if structure::discretise::discretise(&with).is_ok() {
            (b, found.inset) = (with, Some(inset));
        }
    }
    let reference: f64 = structure::discretise::discretise(&b).map_or(0.0, |d| d.reference_load);
    b.plan.load_step = Some(reference * factor / STEPS);
    b.plan.load_limit = Some(1.5 * reference * factor);
    found.step = factor * capacity / STEPS;
    match engine::by(Method::Dem).load(&b, None, watch) {
        Ok(c) => {
            found.status = Some(c.status);
            found.adequacy = match c.status {
                // What does not stand carries nothing.
                Status::UnstableUnderSelfWeight => Some(0.0),
                _ => c.last_stable_load.map(|load| load / reference * capacity),
            };
        }
        Err(error) => found.reason = Some(error.to_string()),
    }
    found
}

/// How far inside the edges hinges turn [m]: of all hinges together, weighed so that their work against crushing is the same as
/// with each at its own place.
fn inset(bridge: &Bridge, by_limit: &Collapse) -> Option<f64> {
    let strength = bridge.masonry.compressive_strength?;
    let (mut work, mut turned) = (0.0, 0.0);
    for hinge in &by_limit.picture.hinges {
        let away = |t: &outcome::picture::ThrustPoint| (t.point[0] - hinge.point[0]).hypot(t.point[1] - hinge.point[1]);
        let points = by_limit.picture.thrust_lines.iter().flatten();
        let nearest = points.min_by(|a, b| away(a).total_cmp(&away(b)))?;
        work += nearest.thrust.powi(2) * hinge.rotation.abs() / (2.0 * strength);
        turned += nearest.thrust * hinge.rotation.abs();
    }
    let inset = work / turned;
    (inset.is_finite() && inset > 0.0).then_some(inset)
}
