//! What the questions of thickness and of moved supports hand to an engine.

use crate::analysis::AnalysisError;
use crate::analysis::state::{self, Change};
use bridge::Bridge;
use outcome::collapse::ThicknessReport;
use structure::discretise::{Discretised, discretise};

/// Thickness is searched up to this multiple of the given one, as far as the rings fit beside one another.
const THICKEST: f64 = 8.0;
/// Thickness is searched down to this share of the given one, and to four times the rounding of the corners.
const THINNEST: f64 = 0.02;

/// Rings whose thickness is sought, with the intrados held and the loads of the file at rest on them.
pub struct RingThickness<'a> {
    /// With rings as thick as given.
    pub bridge: &'a Bridge,
}

impl RingThickness<'_> {
    /// The bridge with all rings `factor` times as thick.
    ///
    /// # Errors
    /// Rings that cannot be drawn.
    pub fn at(&self, factor: f64) -> Result<Discretised, AnalysisError> {
        let mut d = discretise(&state::with(self.bridge, &[Change::Thickened(factor)]))?;
        let loads = std::mem::take(&mut d.loading.variable);
        d.loading.permanent.extend(loads);
        d.loading.movements.clear();
        Ok(d)
    }

    /// Shares of the given thickness between which the rings can be drawn.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        let rings = self.bridge.spans.iter().flat_map(|s| &s.rings);
        let thinnest = rings.map(|r| r.crown_thickness.min(r.springing_thickness)).fold(f64::INFINITY, f64::min);
        let mut most = 1.0;
        while most < THICKEST && self.at(1.25 * most).is_ok() {
            most *= 1.25;
        }
        [THINNEST.max(4.0 * self.bridge.masonry.rounding / thinnest).min(1.0), most]
    }

    /// What is told of shares of the given thickness at which they fell and stood.
    #[must_use]
    pub fn report(&self, [fell, stood]: [f64; 2]) -> ThicknessReport {
        let span = &self.bridge.spans[0];
        let total: f64 = span.rings.iter().map(|r| r.crown_thickness).sum::<f64>() * stood;
        // Where the intrados of the first span is a circle.
        let radius = span.intrados().ok().and_then(|intrados| intrados.circle());
        ThicknessReport {
            factor: [fell, stood],
            crown_thickness: total,
            over_mean_radius: radius.map(|r| total / (r + 0.5 * total)),
        }
    }
}

/// A support that moves, under the permanent loads alone.
pub struct MovedSupport<'a> {
    /// The bridge.
    pub bridge: &'a Bridge,
    /// Its blocks, without variable loads.
    pub blocks: &'a Discretised,
    /// How far it moves in a step [m].
    pub step: f64,
    /// How far it moves at most [m].
    pub largest: f64,
}
