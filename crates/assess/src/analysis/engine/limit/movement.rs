//! Collapse by the movement of a support, by limit analysis.

use crate::analysis::engine::rigid;
use crate::analysis::engine::rings::MovedSupport;
use crate::analysis::geometry::{point, scaled};
use crate::analysis::{AnalysisError, notes, parallel, template};
use mechanics::ids::{BlockId, Table};
use mechanics::limit;
use mechanics::plane::{Pose, Vec2};
use mechanics::watch::Watch;
use outcome::collapse::{By, Collapse, LimitReport, Sought, Status, SupportReport};
use outcome::note;
use outcome::picture::{Motion, Snapshot};

/// The movement is narrowed to this share of the increment.
const FINE: f64 = 1e-3;

/// Moves a support until no thrust line holds the blocks where they are.
pub(super) fn followed(moves: &MovedSupport<'_>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let MovedSupport { bridge, blocks: d, step, largest } = *moves;
    let settings = rigid::settings(bridge);
    let increments = limit::Increments { largest, step, resolution: FINE * step };
    let outcome = parallel::alone("support movement", true, watch, |token| {
        limit::support_movement(&d.model, &d.loading, 0.0, increments, &settings, token)
    })?;
    let report = LimitReport { iterations: outcome.path.len() as u32, ..LimitReport::default() };
    let mut c = template::of_bridge(bridge, d, By::Limit(report), "support movement");
    let picture = &mut c.picture;
    let built = d.model.poses();
    let (hinges, resultants) = as_built(&outcome, &built);
    picture.hinges = rigid::hinges(d, &outcome.interfaces, &hinges);
    picture.thrust_lines = rigid::thrust_lines(d, &outcome.interfaces, &resultants);
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
    picture.mechanism = scaled(picture.snapshots[0].motions.clone());
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
