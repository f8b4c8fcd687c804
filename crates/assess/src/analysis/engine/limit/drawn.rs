//! Blocks of a file or a drawing by limit analysis.

use super::loads;
use crate::analysis::engine::{rigid, scene};
use crate::analysis::{AnalysisError, parallel};
use mechanics::limit;
use mechanics::watch::Watch;
use outcome::collapse::{By, Collapse, FlowRule, LimitReport};
use outcome::note;
use outcome::warning;
use structure::blocks::Scene;
use structure::discretise::Discretised;

/// The load factor at which the blocks become a mechanism.
pub(super) fn mechanism(scene: &Scene, d: &Discretised, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let crushing = scene::crushes(scene);
    let settings = rigid::settings_of(&scene.plan, crushing);
    let mut solve = |settings: &limit::Settings| {
        parallel::alone("limit analysis", false, watch, |token| {
            limit::collapse_load_while(&d.model, &d.loading, settings, token)
        })
    };
    let outcome = solve(&settings)?;
    let unlimited = match crushing {
        true => solve(&rigid::settings_of(&scene.plan, false))?.factor,
        false => outcome.factor,
    };
    let mut picture = scene::built(scene, "limit analysis");
    rigid::draw(d, &outcome, &mut picture);
    let mut c = scene::blank(scene, d, By::Limit(LimitReport::default()), rigid::status(outcome.status), picture);
    loads(d, &outcome, unlimited, &mut c);
    c.assumptions.push(note::Blocks::Rigid.into());
    c.warnings.extend(outcome.jammed.then(|| warning::Joints::Jammed.into()));
    if c.limit().is_some_and(|report| report.friction == FlowRule::Associated) && !c.picture.sliding.is_empty() {
        c.warnings.push(warning::Joints::Sliding { joints: c.picture.sliding.len() }.into());
    }
    Ok(c)
}
