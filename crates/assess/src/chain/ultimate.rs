//! The file's own loads at collapse, moved over the bridge; and a support that moves.

use super::shortened::{as_shortened, shortened};
use crate::analysis::state::{self, Change};
use crate::analysis::{self, AnalysisError, Places, by_weight_alone};
use bridge::{Analysis, Bridge, LoadKind, Method, Strip};
use mechanics::watch::Watch;
use outcome::collapse::{Collapse, Status};
use outcome::facts::{MovementFacts, ShortenedFacts, UltimateFacts};
use outcome::note::{self, Note};
use outcome::sweep::{Sweep, SweepPoint};
use outcome::warning::{self, Warning};

/// What the stage found: facts with the collapse at the governing position, and the sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Ultimate {
    /// For checks and reports.
    pub facts: UltimateFacts,
    /// For drawing.
    pub sweep: Sweep,
}

/// Positions over the shortest span, as in sweeps of vehicles: however long the bridge is, the worst position of a span is
/// met and then sought between them.
const POSITIONS_IN_A_SPAN: f64 = 60.0;

/// The same where each position takes seconds: fill that yields as a continuum.
const BOUNDS_IN_A_SPAN: f64 = 12.0;

/// The bridge for limit analysis, and on deformable joints where its plan asks for them: between its walls, fill as weight, loads
/// through the cover.
fn of_blocks(bridge: &Bridge) -> Bridge {
    let changes = [
        Change::Analysis(Analysis::Load),
        Change::Method(method(bridge)),
        Change::Strip(Strip::Fill),
        Change::OpenSteps,
        Change::LoadsThroughCover,
        Change::ParticlesAsWeight,
    ];
    state::with(bridge, &changes)
}

/// Deformable joints are followed beside rigid blocks where the plan says so.
fn method(bridge: &Bridge) -> Method {
    if bridge.plan.method.follows_moving_loads() { bridge.plan.method } else { Method::Limit }
}

/// The factor on the run of axles that governs, at one position [m] of the first load, with the parts of uniform loads that govern: what is
/// needed to see it change.
pub(super) fn at_position(
    bridge: &Bridge,
    position: f64,
    parts: &[ShortenedFacts],
    watch: &mut dyn Watch,
) -> Result<UltimateFacts, AnalysisError> {
    let own = by_weight_alone(bridge);
    let own = as_shortened(&of_blocks(own.as_ref().unwrap_or(bridge)), parts);
    let sweep = analysis::sweep(&own, Places::At(position), true, watch)?;
    let found = sweep.points.first();
    Ok(UltimateFacts {
        status: found.map_or(Status::NotConverged, |point| point.status),
        load_factor: found.and_then(|point| point.load_factor),
        positions_not_converged: sweep.positions_not_converged(),
        position_m: Some(position),
        ..UltimateFacts::default()
    })
}

/// Moves the loads of the file over the bridge by limit analysis, and draws the collapse where they are worst. With soil that yields it is
/// also made with fill as weight alone, and the lower one counts. None where the onlooker wished to stop.
///
/// # Errors
/// No load, one that stands on a loading block, or a bridge that cannot be analysed.
pub fn ultimate(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Option<Ultimate>, AnalysisError> {
    let Some(found) = moved(bridge, watch)? else { return Ok(None) };
    let bare = by_weight_alone(bridge).filter(|_| bridge.continuum.is_some());
    let Some(bare) = bare else { return Ok(Some(found)) };
    let Some(lower) = moved(&bare, watch)? else { return Ok(None) };
    let [with, without] = [&found, &lower].map(|one| one.facts.load_factor);
    // A bridge that does not stand by weight alone has no factor: that is the lower end.
    let mut counts = if with.is_some_and(|with| without.is_some_and(|without| with < without)) { found } else { lower };
    counts.facts.warnings.push(warning::Yielding::StrengthInSweep { bare: without, with }.into());
    Ok(Some(counts))
}

fn moved(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Option<Ultimate>, AnalysisError> {
    let whole = of_blocks(bridge);
    let parts = shortened(&whole, watch)?;
    let own = as_shortened(&whole, &parts);
    let shortest = own.spans.iter().map(|s| s.span).fold(f64::INFINITY, f64::min);
    let positions = if own.continuum.is_some() { BOUNDS_IN_A_SPAN } else { POSITIONS_IN_A_SPAN };
    let sweep = analysis::sweep(&own, Places::Every(shortest / positions), true, watch)?;
    if !sweep.whole {
        return Ok(None);
    }
    let worst = sweep.worst().cloned();
    // The loads where they stand, by the method that gives less.
    let file = analysis::collapse_by(method(&own), &own, watch)?;
    let (at_file, at_status) = (factor(&file), file.status);
    let mut facts = UltimateFacts {
        load: bridge.loads.iter().map(|load| load.name.as_str()).collect::<Vec<_>>().join(", "),
        method: if bridge.plan.method.follows_moving_loads() {
            "the smaller load of limit analysis (rigid blocks as built) and of the equilibrium path (deformable joints)"
        } else if own.continuum.is_some() {
            "limit analysis, lower bound of rigid blocks as built beside soil that yields as a continuum"
        } else {
            "limit analysis, rigid blocks as built, fill by its weight and dispersal alone"
        }
        .to_owned(),
        positions: sweep.points.len(),
        positions_not_converged: sweep.positions_not_converged() + usize::from(file.status == Status::NotConverged),
        reference_load_kn_per_m: file.reference_load / 1e3,
        ..UltimateFacts::default()
    };
    // The file's own place may lie between two positions of the sweep.
    let moved = worst.filter(|worst| worst.bound() < at_file.or(Some(f64::INFINITY)));
    let collapse = match &moved {
        Some(worst) => analysis::collapse_by(method(&own), &with_axles(&own, worst.offset, worst.axles), watch)?,
        None => file,
    };
    if [at_status, collapse.status].contains(&Status::Cancelled) {
        return Ok(None);
    }
    // The governing case by itself may carry less than the sweep found, or find no answer.
    let alone = collapse.status == Status::Collapsed;
    let least = [moved.as_ref().and_then(SweepPoint::bound), factor(&collapse)].into_iter().flatten().reduce(f64::min);
    let answered = facts.positions_not_converged == 0 && (alone || moved.is_none());
    facts.status = if answered { collapse.status } else { Status::NotConverged };
    (facts.load_factor, facts.load_factor_at_most) = if answered { (least, None) } else { (None, least) };
    let stands = || own.loads.first().map(|load| load.position);
    facts.position_m = moved.as_ref().map(|worst| worst.position).or_else(stands);
    facts.permissible = collapse.along().map_or_else(Vec::new, |along| along.permissible.clone());
    facts.assumptions = collapse.assumptions.iter().chain(&sweep.assumptions).cloned().collect();
    let shorter = |part: &ShortenedFacts| -> Note {
        note::Moving::Shorter { load: part.name.clone(), of: part.of_m, length: part.length_m }.into()
    };
    facts.assumptions.extend(parts.iter().map(shorter));
    facts.shortened = parts;
    // What the sweep says of help that is not counted, the case by itself says again.
    let again = |warning: &&Warning| {
        let of_help = [warning::PRESSURE_RANGE, warning::HELP_NOT_COUNTED].contains(&warning.code());
        !of_help || sweep.warnings.iter().all(|told| told.code() != warning.code())
    };
    facts.warnings = sweep.warnings.iter().chain(collapse.warnings.iter().filter(again)).cloned().collect();
    facts.not_counted = if moved.is_some() { &sweep.not_counted } else { &collapse.not_counted }.clone();
    facts.collapse = Some(Box::new(collapse));
    Ok(Some(Ultimate { facts, sweep }))
}

/// The load factor of a collapse. What is carried where no load was found bounds nothing from above, and is none.
fn factor(found: &Collapse) -> Option<f64> {
    let answered = found.status == Status::Collapsed;
    found.carried().filter(|_| answered).map(|load| load / found.reference_load)
}

/// The loads moved by an offset [m], with only a run of their axles.
fn with_axles(bridge: &Bridge, offset: f64, axles: [usize; 2]) -> Bridge {
    let mut own = bridge.clone();
    let mut first = 0;
    own.loads.retain_mut(|load| {
        load.position += offset;
        let LoadKind::Axles { axles: list, .. } = &mut load.kind else {
            first += 1;
            return (axles[0]..=axles[1]).contains(&(first - 1));
        };
        let begin = first;
        first += list.len();
        let mut k = begin;
        list.retain(|_| {
            k += 1;
            (axles[0]..=axles[1]).contains(&(k - 1))
        });
        !list.is_empty()
    });
    own
}

/// The movement of the file's support that makes a mechanism.
///
/// # Errors
/// A plan without a movement, or an analysis that cannot be set up.
pub fn movement(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let yields = bridge.continuum.is_some();
    let changes = [Change::Analysis(Analysis::SupportMovement), Change::FillAsWeight];
    let own = state::with(bridge, if yields { &changes } else { &changes[..1] });
    let mut found = analysis::collapse(&own, None, watch)?;
    if yields {
        found.assumptions.push(note::Soil::AsWeightOfMovements.into());
    }
    Ok(found)
}

/// Its facts.
pub fn movement_facts(bridge: &Bridge, found: Collapse) -> MovementFacts {
    let support = bridge.plan.support_movement.map_or(0, |movement| movement.support);
    let name = match support {
        0 => "left abutment".to_owned(),
        k if k == bridge.spans.len() => "right abutment".to_owned(),
        k => format!("pier {k}"),
    };
    MovementFacts {
        status: found.status,
        last_stable_mm: found.support().and_then(|report| report.last_stable).map(|m| 1e3 * m),
        support: name,
        collapse: Some(Box::new(found)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_carried_without_an_answer_is_no_load_factor() {
        let mut found =
            analysis::collapse_by_limit(&crate::samples::bridgemill(), &mut mechanics::watch::Unwatched).unwrap();
        assert!(factor(&found).is_some());
        found.status = Status::NotConverged;
        assert!(found.carried().is_some() && factor(&found).is_none());
    }
}
