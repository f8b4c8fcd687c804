//! The least thickness of rings by discrete elements.

use super::{report, settings};
use crate::analysis::engine::joints::require_stiffness;
use crate::analysis::engine::rings::RingThickness;
use crate::analysis::parallel::Retold;
use crate::analysis::{AnalysisError, notes};
use mechanics::dem;
use mechanics::watch::{Progress, Watch, Wish};
use outcome::collapse::{Collapse, Sought, Status};
use structure::discretise::Discretised;

/// The thickness is bracketed to this share: half of what is worth a decision on site.
const BRACKET: f64 = 5e-3;

/// Brackets the thickness at which the rings just stand.
pub(super) fn found(rings: &RingThickness<'_>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let bridge = rings.bridge;
    require_stiffness(bridge)?;
    let settings = settings(bridge);
    let run = |factor: f64, watch: &mut dyn Watch| -> Result<(Discretised, dem::Outcome), AnalysisError> {
        let d = rings.at(factor)?;
        let program = dem::Program { increment: 1.0, limit: 0.0, resolution: None, watched: d.watched };
        let told = |progress: &Progress| {
            let stage = format!("thickness {factor:.4} of the given one: {}", progress.stage);
            Progress { stage, fraction: None, steps: progress.steps }
        };
        let trial = &mut Retold { watch, kept: None, told };
        let outcome = dem::collapse(&d.model, &d.loading, &program, &settings, None, trial)?;
        Ok((d, outcome))
    };
    let [least, most] = rings.range();
    let (mut fell, mut stood) = (None, None);
    let mut last_fall = None;
    let mut ended = Status::Completed;
    // Geometric steps out from the given thickness, then halving.
    let (mut factor, mut steps) = (1.0, 0);
    loop {
        steps += 1;
        let stage = format!("thickness {factor:.4} of the given one");
        if watch.look(&Progress { stage, fraction: None, steps }) == Wish::Stop {
            ended = Status::Cancelled;
            break;
        }
        let (d, outcome) = run(factor, watch)?;
        match outcome.status {
            dem::Status::StableToLastLoad => stood = Some((factor, d, outcome)),
            dem::Status::UnstableUnderSelfWeight | dem::Status::Collapsed => {
                fell = Some(factor);
                last_fall = Some((d, outcome));
            }
            _ => {
                ended = super::ended(outcome.status).0;
                break;
            }
        }
        factor = match (fell, &stood) {
            (Some(fell), Some((stood, ..))) if stood / fell <= 1.0 + BRACKET => break,
            (Some(fell), Some((stood, ..))) => (fell * stood).sqrt(),
            (None, Some((stood, ..))) if *stood <= least => {
                ended = Status::StableToLastLoad;
                break;
            }
            (None, Some((stood, ..))) => (0.7 * stood).max(least),
            (Some(fell), None) if fell >= most => {
                ended = Status::UnstableUnderSelfWeight;
                break;
            }
            (Some(fell), None) => (fell / 0.7).min(most),
            (None, None) => break,
        };
    }
    let (d, outcome) = match (&stood, last_fall) {
        (Some((_, d, o)), None) => (d.clone(), o.clone()),
        (_, Some(fall)) => fall,
        (None, None) => run(1.0, watch)?,
    };
    let mut c = report(bridge, &d, &outcome, "least thickness", &|factor| factor);
    c.status = ended;
    c.sought = Sought::Thickness(fell.zip(stood.as_ref()).map(|(fell, (stood, ..))| rings.report([fell, *stood])));
    if let Some((_, d, outcome)) = &stood {
        let standing = report(bridge, d, outcome, "least thickness", &|factor| factor);
        c.picture.thrust_lines = standing.picture.thrust_lines;
        c.max_compressive_stress = standing.max_compressive_stress;
        c.contacts = standing.contacts;
    }
    notes::dem(bridge, &d, &mut c);
    Ok(c)
}
