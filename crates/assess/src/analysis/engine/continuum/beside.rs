//! What stands beside the bounds of the load: soil that dilates, the range over shares of the strength, flow with less dilation by
//! iteration, and what spandrel walls hold.

use super::setting;
use crate::analysis::AnalysisError;
use mechanics::limit::Settings;
use mechanics::limit::continuum::{Bounds, Panel, Which, bound_on, flow_on};
use mechanics::watch::CancelToken;
use outcome::soil::{ContinuumReport, WallThatGives};
use structure::discretise::Discretised;
use structure::discretise::continuum::{Earth, Strength};
use structure::discretise::dispersal::Strip;

/// The share of the soil's strength at the lower end of the range that is reported with every load: a stated choice, which no source gives.
pub(super) const LEAST_SHARE: f64 = 0.5;

/// What is found beside the bounds, on their meshes: the same body with other strengths.
pub(super) struct Beside<'a> {
    pub d: &'a Discretised,
    pub earth: &'a Earth,
    pub settings: Settings,
    pub strips: &'a [Strip],
    pub bounds: &'a Bounds,
    pub token: &'a CancelToken,
}

/// A dilatancy angle that no soil exceeds [rad]: it dilates by its friction angle.
const BY_FRICTION: f64 = std::f64::consts::FRAC_PI_2;

impl Beside<'_> {
    /// Puts it into the report.
    pub(super) fn reported(&self, report: ContinuumReport) -> Result<ContinuumReport, AnalysisError> {
        let plan = &self.earth.plan;
        let own = Strength::of(plan);
        let dilating = Strength { dilatancy: BY_FRICTION, ..own };
        let shares = [LEAST_SHARE.min(own.share), 1.0];
        let [least, most] = shares.map(|share| Strength { share, ..own });
        let both = |low: Option<f64>, high: Option<f64>| Some([low?, high?]);
        let is_confined = !self.earth.panels.is_empty();
        Ok(ContinuumReport {
            associated: both(self.bound(Which::Lower, dilating, 0)?, self.bound(Which::Upper, dilating, 1)?),
            range: both(self.bound(Which::Lower, least, 2)?, self.bound(Which::Upper, most, 3)?),
            shares,
            iterated: self.iterated(dilating)?,
            plane_strain: if is_confined { self.in_plane_strain(own)? } else { None },
            wall: self.wall(),
            ..report
        })
    }

    /// A bound with another strength [N/m].
    fn bound(&self, which: Which, strength: Strength, part: usize) -> Result<Option<f64>, AnalysisError> {
        let other = self.earth.loaded(self.d, strength, self.strips)?;
        let (token, mesh) = (self.token.part(8 + part, 16), &self.bounds.mesh);
        let found = bound_on(which, &setting(&other, &self.settings)?, mesh, &token);
        Ok(found.map(|factor| self.d.load(factor)))
    }

    /// The lower bound where nothing bounds the stress out of the plane [N/m].
    fn in_plane_strain(&self, strength: Strength) -> Result<Option<f64>, AnalysisError> {
        let mut other = self.earth.loaded(self.d, strength, self.strips)?;
        other.continuum.panels.clear();
        let setting = setting(&other, &self.settings)?;
        let found = bound_on(Which::Lower, &setting, &self.bounds.mesh, self.token);
        Ok(found.map(|factor| self.d.load(factor)))
    }

    /// What the iteration for flow with less dilation came to, where it settled [N/m].
    fn iterated(&self, whole: Strength) -> Result<Option<f64>, AnalysisError> {
        let dilatancy = self.earth.plan.dilatancy_angle;
        if self.earth.materials.iter().all(|material| material.soil.friction_angle <= dilatancy) {
            return Ok(None);
        }
        let other = self.earth.loaded(self.d, whole, self.strips)?;
        let mesh = self.bounds.coarser.as_ref().unwrap_or(&self.bounds.mesh);
        let found = flow_on(dilatancy, &setting(&other, &self.settings)?, mesh, &self.token.part(3, 4));
        Ok(found.filter(|flow| flow.settled).map(|flow| self.d.load(flow.factor)))
    }

    /// The panel that resists the most power in the mechanism of the upper bound.
    fn wall(&self) -> Option<WallThatGives> {
        let moves = &self.bounds.upper.as_ref()?.panels;
        let power = |(panel, [slide, tilt]): (&Panel, &[f64; 2])| [panel.force * slide, panel.moment * tilt];
        let all = self.earth.panels.iter().zip(moves).map(|both| (both.0, power(both)));
        let (panel, [slides, tilts]) = all.max_by(|a, b| (a.1[0] + a.1[1]).total_cmp(&(b.1[0] + b.1[1])))?;
        let is_tilting = tilts > slides;
        let resists = if is_tilting { panel.moment } else { panel.force };
        (slides + tilts > 0.0).then_some(WallThatGives { ends: panel.ends, tilts: is_tilting, resists })
    }
}
