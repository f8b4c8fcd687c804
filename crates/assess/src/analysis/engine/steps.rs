//! Load steps of a run, with what the plan leaves open of them.

use crate::analysis::AnalysisError;
use bridge::Plan;
use mechanics::{dem, limit};
use outcome::warning::Loads;
use structure::discretise::Discretised;

/// The steps of a run and the size of one [N/m]. What the plan leaves open is chosen from the limit load factor
/// `bound`, and said.
pub(super) fn program(
    plan: &Plan,
    d: &Discretised,
    bound: Option<f64>,
    chosen: &mut Vec<Loads>,
) -> Result<(dem::Program, f64), AnalysisError> {
    let missing =
        |what| AnalysisError::Missing { what, why: "the limit load, from which it would be chosen, is not finite" };
    let load_step = match (plan.load_step, bound) {
        (Some(step), _) => step,
        (None, Some(bound)) => {
            let step = round_down(bound * d.reference_load / 20.0);
            chosen.push(Loads::LoadStep { step });
            step
        }
        _ => return Err(missing("load_step")),
    };
    let load_limit = match (plan.load_limit, bound) {
        (Some(limit), _) => limit,
        (None, Some(bound)) => {
            let limit = d.counted_weight + load_step * (1.5 * bound * d.reference_load / load_step).ceil();
            chosen.push(Loads::LoadLimit { limit });
            limit
        }
        _ => return Err(missing("load_limit")),
    };
    let program = dem::Program {
        increment: load_step / d.reference_load,
        limit: (load_limit - d.counted_weight).max(0.0) / d.reference_load,
        resolution: plan.resolution.map(|r| r / d.reference_load),
        watched: d.watched,
    };
    Ok((program, load_step))
}

/// The load factor from which steps are chosen: the limit load's, which the associated one stands in for. Rigid blocks that do not stand have
/// none: there the loads together weigh as much as the blocks, and self-weight comes before them.
pub(super) fn bound(rigid: &limit::Outcome, d: &Discretised) -> Option<f64> {
    let weighs = || d.model.free_weight() / d.reference_load;
    let falls = rigid.status == limit::Status::NoEquilibrium;
    rigid.factor.or(rigid.associated_factor).or(falls.then(weighs).filter(|factor| factor.is_finite() && *factor > 0.0))
}

/// The largest of 1, 2, 5 times a power of ten that is not above `value`.
fn round_down(value: f64) -> f64 {
    let decade = 10f64.powf(value.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|m| m * decade).find(|&v| v <= value).unwrap_or(decade)
}
