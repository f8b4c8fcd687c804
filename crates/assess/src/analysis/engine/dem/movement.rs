//! Collapse by the movement of a support, by discrete elements.

use super::{report, settings};
use crate::analysis::engine::joints::require_stiffness;
use crate::analysis::engine::rings::MovedSupport;
use crate::analysis::{AnalysisError, notes};
use mechanics::dem;
use mechanics::watch::Watch;
use outcome::collapse::{Collapse, Sought, SupportReport};

/// Moves a support in steps until the blocks do not come to rest.
pub(super) fn until_it_falls(
    moves: &MovedSupport<'_>,
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
) -> Result<Collapse, AnalysisError> {
    let MovedSupport { bridge, blocks: d, step, largest } = *moves;
    require_stiffness(bridge)?;
    let program = dem::Program { increment: step, limit: largest, resolution: None, watched: d.watched };
    let outcome = dem::collapse(&d.model, &d.loading, &program, &settings(bridge), resume, watch)?;
    let mut c = report(bridge, d, &outcome, "support movement", &|factor| factor);
    // A step that neither came to rest nor collapsed is no collapse.
    let collapse = outcome.collapse_factor.filter(|_| outcome.status != dem::Status::Stalled);
    c.sought = Sought::SupportMovement(SupportReport { last_stable: outcome.last_stable_factor, collapse, step });
    notes::dem(bridge, d, &mut c);
    Ok(c)
}
