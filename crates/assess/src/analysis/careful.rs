//! What may come and go does not count as help: with a support that has moved, and with water in the fill, the bridge is analysed without
//! either as well, and the smallest load leads.

use super::AnalysisError;
use super::by_limit::as_described;
use bridge::{Analysis, Bridge};
use mechanics::watch::Watch;
use outcome::collapse::{Collapse, Status};

/// The bridge without one of them, and which one.
fn without(bridge: &Bridge) -> Vec<(&'static str, Bridge)> {
    let mut found = Vec::new();
    if bridge.plan.analysis != Analysis::Load {
        return found;
    }
    if bridge.plan.support_movement.is_some_and(|movement| movement.before.is_some()) {
        let mut own = bridge.clone();
        own.plan.support_movement = None;
        found.push(("the movement of the support", own));
    }
    if bridge.cover.water.is_some() {
        let mut own = bridge.clone();
        own.cover.water = None;
        if let Some(plan) = &mut own.continuum {
            plan.water_level = None;
        }
        found.push(("the water in the fill", own));
    }
    found
}

/// The smallest load of the bridge as described and without what may help it.
pub(super) fn least(bridge: &Bridge, found: Collapse, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let mut best = found;
    let described = best.last_stable_load;
    for (what, other) in without(bridge) {
        if best.status == Status::Cancelled {
            return Ok(best);
        }
        let other = as_described(&other, watch)?;
        if other.status == Status::Cancelled {
            return Ok(other);
        }
        let load = |load: Option<f64>| {
            load.map_or_else(|| "no load that was found".to_owned(), |l| format!("{:.2} kN/m", l / 1e3))
        };
        let [with, bare] = [described, other.last_stable_load].map(load);
        // A bridge that carries nothing without what helps it carries nothing.
        let helps = match (described, other.last_stable_load) {
            (Some(with), Some(bare)) => bare < with,
            (Some(_), None) => true,
            (None, _) => false,
        };
        if helps {
            let words = format!(
                "With {what} the bridge carries {with}, without it {bare}: what may change again is not counted as help, and the smaller \
                 load leads, with its figures."
            );
            let smaller = match (best.last_stable_load, other.last_stable_load) {
                (Some(best), Some(other)) => other < best,
                (Some(_), None) => true,
                (None, _) => false,
            };
            let mut told: Vec<String> =
                best.assumptions.iter().filter(|told| told.contains("is not counted as help")).cloned().collect();
            if smaller {
                best = other;
                best.assumptions.append(&mut told);
            }
            best.assumptions.push(words);
        } else {
            best.assumptions.push(format!("Without {what} the bridge would carry {bare} in place of {with}."));
        }
    }
    Ok(best)
}
