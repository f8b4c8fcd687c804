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

/// Brackets the thickness at which the rings just stand. Rings whose forces go to and fro without end are not shown to stand, and the bracket
/// is narrowed above them.
pub(super) fn least(rings: &RingThickness<'_>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
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
    // What falls, and what does not stand: it falls, or its forces go to and fro without end.
    let (mut fell, mut unproven, mut stood) = (None, None, None);
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
            dem::Status::UnstableUnderSelfWeight | dem::Status::Collapsed | dem::Status::Stalled => {
                unproven = Some(factor);
                if outcome.status == dem::Status::Stalled {
                    ended = Status::Stalled;
                } else {
                    (ended, fell) = (Status::Completed, unproven);
                }
                last_fall = Some((d, outcome));
            }
            _ => {
                ended = super::ended(outcome.status).0;
                break;
            }
        }
        factor = match (unproven, &stood) {
            (Some(thin), Some((stood, ..))) if stood / thin <= 1.0 + BRACKET => break,
            (Some(thin), Some((stood, ..))) => (thin * stood).sqrt(),
            (None, Some((stood, ..))) if *stood <= least => {
                ended = Status::StableToLastLoad;
                break;
            }
            (None, Some((stood, ..))) => (0.7 * stood).max(least),
            (Some(thin), None) if thin >= most => {
                if ended == Status::Completed {
                    ended = Status::UnstableUnderSelfWeight;
                }
                break;
            }
            (Some(thin), None) => (thin / 0.7).min(most),
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
    c.sought = Sought::Thickness(
        fell.or(unproven).zip(stood.as_ref()).map(|(fell, (stood, ..))| rings.report([fell, *stood])),
    );
    if let Some((_, d, outcome)) = &stood {
        let standing = report(bridge, d, outcome, "least thickness", &|factor| factor);
        c.picture.thrust_lines = standing.picture.thrust_lines;
        c.max_compressive_stress = standing.max_compressive_stress;
        c.contacts = standing.contacts;
    }
    notes::dem(bridge, &d, &mut c);
    Ok(c)
}
