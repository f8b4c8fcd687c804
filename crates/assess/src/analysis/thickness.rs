//! The least ring thickness that stands.

use super::AnalysisError;
use super::engine::{self, rings::RingThickness};
use bridge::Bridge;
use mechanics::watch::Watch;
use outcome::collapse::Collapse;
use outcome::note;

/// Narrows the thickness at which the bridge just stands under its weight and the loads of its file, with the intrados
/// held.
///
/// # Errors
/// Rings that cannot be drawn, a method that does not know it, or an analysis that cannot be set up.
pub fn thickness(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let rings = RingThickness { bridge };
    // What is wrong with the bridge as given is said before any search.
    rings.at(1.0)?;
    let mut c = engine::by(bridge.plan.method).thickness(&rings, watch)?;
    c.assumptions.push(note::Blocks::Thinned.into());
    Ok(c)
}
