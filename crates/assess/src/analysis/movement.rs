//! Collapse by the movement of a support.

use super::geometry::point;
use super::template;
use super::{AnalysisError, by_dem, by_limit, notes, parallel, picture};
use bridge::{Bridge, Method};
use mechanics::dem;
use mechanics::ids::{BlockId, Table};
use mechanics::limit;
use mechanics::plane::{Pose, Vec2};
use mechanics::watch::Watch;
use outcome::collapse::{By, Sought};
use outcome::collapse::{Collapse, LimitReport, Status, SupportReport};
use outcome::note;
use outcome::picture::{Motion, Snapshot};
use outcome::warning::{Loads, Warning};
use structure::discretise::{Discretised, discretise};

/// Limit analysis narrows the movement to this share of the increment.
const FINE: f64 = 1e-3;

/// Moves the support of the plan in increments until the blocks collapse, under the permanent loads alone.
pub fn support_movement(
    bridge: &Bridge,
    resume: Option<&[u64]>,
    watch: &mut dyn Watch,
) -> Result<Collapse, AnalysisError> {
    let mut d = discretise(bridge)?;
    d.loading.variable.clear();
    let Some(movement) = bridge.plan.support_movement else {
        let why = "which support moves, and where, is the question";
        return Err(AnalysisError::Missing { what: "support_movement", why });
    };
    // A thousandth of the shortest span a step, up to a tenth of it: no bridge moves farther unnoticed.
    let shortest = bridge.spans.iter().map(|s| s.span).fold(f64::INFINITY, f64::min);
    let largest = movement.limit.unwrap_or(0.1 * shortest);
    let step = movement.increment.unwrap_or(1e-3 * shortest);
    let mut c = match bridge.plan.method {
        Method::Dem => by_dem(bridge, &d, step, largest, resume, watch)?,
        Method::Limit => by_limit(bridge, &d, step, largest, watch)?,
        Method::Path => return Err(AnalysisError::NotByPath("support movements")),
        Method::Fe => return Err(AnalysisError::NotByFiniteElements("support movements")),
    };
    c.assumptions.push(note::Blocks::WeightsAlone.into());
    let increment = movement.increment.is_none().then_some(Loads::Increment { increment: step });
    let limit = movement.limit.is_none().then_some(Loads::LargestMovement { limit: largest });
    c.warnings.extend(increment.into_iter().chain(limit).map(Warning::from));
    Ok(c)
}

fn by_dem(
    bridge: &Bridge,
    d: &Discretised,
    step: f64,
    largest: f64,
    resume: Option<&[u64]>,
    watch: &mut dyn Watch,
) -> Result<Collapse, AnalysisError> {
    by_dem::require_stiffness(bridge)?;
    let program = dem::Program { increment: step, limit: largest, resolution: None, watched: d.watched };
    let outcome = dem::collapse(&d.model, &d.loading, &program, &by_dem::settings(bridge), resume, watch)?;
    let mut c = by_dem::report(bridge, d, &outcome, "support movement", &|factor| factor);
    // A step that neither came to rest nor collapsed is no collapse.
    let collapse = outcome.collapse_factor.filter(|_| outcome.status != dem::Status::Stalled);
    c.sought = Sought::SupportMovement(SupportReport { last_stable: outcome.last_stable_factor, collapse, step });
    notes::dem(bridge, d, &mut c);
    Ok(c)
}

fn by_limit(
    bridge: &Bridge,
    d: &Discretised,
    step: f64,
    largest: f64,
    watch: &mut dyn Watch,
) -> Result<Collapse, AnalysisError> {
    let settings = by_limit::settings(bridge);
    let increments = limit::Increments { largest, step, resolution: FINE * step };
    let outcome = parallel::alone("support movement", true, watch, |token| {
        limit::support_movement(&d.model, &d.loading, 0.0, increments, &settings, token)
    })?;
    let mut picture = picture::built(bridge, d, "support movement");
    let built = d.model.poses();
    let (hinges, resultants) = as_built(&outcome, &built);
    picture.hinges = by_limit::hinges(d, &outcome.interfaces, &hinges);
    picture.thrust_lines = by_limit::thrust_lines(d, &outcome.interfaces, &resultants);
    let n = built.len();
    picture.snapshots = vec![Snapshot {
        load: outcome.stands,
        motions: outcome
            .poses
            .iter()
            .zip(built.iter())
            .map(|(now, then)| Motion {
                translation: point(now.position - then.position),
                rotation: now.rotation.sin.atan2(now.rotation.cos),
            })
            .collect(),
        velocities: vec![[0.0; 2]; n],
        contacts: Vec::new(),
        // Resultants alone are known: no stress is told rather than none.
        stresses: Vec::new(),
        ..Snapshot::default()
    }];
    picture.last_stable = Some(0);
    picture.mechanism = super::geometry::scaled(picture.snapshots[0].motions.clone());
    let report = LimitReport { iterations: outcome.path.len() as u32, ..LimitReport::default() };
    let mut c = template::of_bridge(bridge, d, By::Limit(report), picture);
    c.tolerance = FINE * step;
    c.contacts = outcome.interfaces.iter().map(|i| i.points.len()).sum();
    c.status = match outcome.status {
        limit::MovementStatus::Collapsed => Status::Collapsed,
        limit::MovementStatus::StandsThroughout => Status::StableToLastLoad,
        limit::MovementStatus::NoEquilibrium => Status::UnstableUnderSelfWeight,
        limit::MovementStatus::Cancelled => Status::Cancelled,
    };
    let stands = (outcome.status != limit::MovementStatus::NoEquilibrium).then_some(outcome.stands);
    c.sought = Sought::SupportMovement(SupportReport { last_stable: stands, collapse: outcome.falls, step });
    notes::limit(bridge, d, &mut c);
    c.assumptions.push(note::Blocks::FirstFall.into());
    Ok(c)
}

/// Hinges and resultants, found where the blocks have moved to, at their places in the bridge as built: results and
/// drawings name the places of a bridge there.
fn as_built(
    outcome: &limit::MovementOutcome,
    built: &Table<BlockId, Pose>,
) -> (Vec<limit::Hinge>, Vec<Option<limit::Resultant>>) {
    let back = |joint: usize, at: Vec2| {
        let first = outcome.interfaces[joint].first;
        let now = outcome.poses[first];
        built[first].place(now.rotation.turn_back(at - now.position))
    };
    let hinges = outcome.hinges.iter().map(|h| limit::Hinge { at: back(h.joint, h.at), ..*h }).collect();
    let resultants = outcome.resultants.iter().enumerate();
    let resultants = resultants.map(|(k, r)| r.map(|r| limit::Resultant { at: back(k, r.at), ..r })).collect();
    (hinges, resultants)
}
