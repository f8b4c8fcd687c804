//! Limit analysis of rigid blocks.

mod drawn;
mod movement;
mod thickness;

use crate::analysis::engine::rings::{MovedSupport, RingThickness};
use crate::analysis::engine::{Engine, rigid};
use crate::analysis::state::{self, Change};
use crate::analysis::{AnalysisError, notes, parallel, template};
use bridge::{Bridge, Method};
use mechanics::limit;
use mechanics::watch::{CancelToken, Watch};
use outcome::collapse::{By, Collapse, LimitReport};
use structure::blocks::Scene;
use structure::discretise::{Discretised, pressure};

/// The load factor at which rigid blocks become a mechanism.
pub(super) struct Limit;

impl Engine for Limit {
    fn method(&self) -> Method {
        Method::Limit
    }

    fn load(&self, bridge: &Bridge, _: Option<&[u8]>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
        let d = rigid::loaded(rigid::prepared(bridge)?)?;
        parallel::alone("limit analysis", true, watch, |token| whole(bridge, &d, token))
    }

    fn thickness(&self, rings: &RingThickness<'_>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
        thickness::least(rings, watch)
    }

    fn support_movement(
        &self,
        moves: &MovedSupport<'_>,
        _: Option<&[u8]>,
        watch: &mut dyn Watch,
    ) -> Result<Collapse, AnalysisError> {
        movement::followed(moves, watch)
    }

    fn drawn(
        &self,
        scene: &Scene,
        d: &Discretised,
        _: Option<&[u8]>,
        watch: &mut dyn Watch,
    ) -> Result<Collapse, AnalysisError> {
        drawn::mechanism(scene, d, watch)
    }
}

/// The load factor and those that stand beside it.
fn whole(bridge: &Bridge, d: &Discretised, token: &CancelToken) -> Result<Collapse, AnalysisError> {
    let settings = rigid::settings(bridge);
    let walls = d.road.is_some() && settings.friction == limit::Friction::Associated;
    let pressed = !d.loading.restraints.is_empty();
    // The loads that are found, one after the other.
    let count = 1 + usize::from(settings.crushing) + usize::from(pressed) + usize::from(walls);
    let mut parts = (0..count).map(|k| token.part(k, count));
    let mut solve = |d: &Discretised, settings: &limit::Settings| {
        rigid::solve(d, settings, &parts.next().unwrap_or_else(|| token.clone()))
    };
    let outcome = solve(d, &settings)?;
    let unlimited = match settings.crushing {
        true => solve(d, &limit::Settings { crushing: false, ..settings })?.factor,
        false => outcome.factor,
    };
    let mut c = report(bridge, d, &outcome, unlimited);
    if pressed {
        let mut whole = d.clone();
        whole.loading.restraints = pressure::restraints(&state::with(bridge, &[Change::FullPressure]), &d.extrados);
        let full = solve(&whole, &settings)?.factor.map(|f| d.load(f));
        if let By::Limit(report) = &mut c.by {
            report.full_fill_pressure_load = full;
        }
        notes::pressed(bridge, &mut c);
    }
    // Walls of blocks lock where sliding dilates: their associated load never stands alone.
    if walls {
        let settings = limit::Settings { friction: limit::Friction::NonAssociated, ..settings };
        let corrected = solve(d, &settings)?.factor.map(|f| d.load(f));
        notes::corrected(&mut c, corrected);
    }
    Ok(if !token.is_cancelled() { c } else { rigid::cancelled(bridge, d, By::Limit(LimitReport::default())) })
}

fn report(bridge: &Bridge, d: &Discretised, outcome: &limit::Outcome, unlimited: Option<f64>) -> Collapse {
    let mut c = template::of_bridge(bridge, d, By::Limit(LimitReport::default()), "limit analysis");
    rigid::draw(d, outcome, &mut c.picture);
    c.status = rigid::status(outcome.status);
    loads(d, outcome, unlimited, &mut c);
    notes::limit(bridge, d, &mut c);
    c
}

/// Loads, bounds and residuals, with the load of joints that never crush.
pub(super) fn loads(d: &Discretised, outcome: &limit::Outcome, unlimited: Option<f64>, c: &mut Collapse) {
    let load = |factor: Option<f64>| factor.map(|f| d.load(f));
    c.collapse_load = load(outcome.factor);
    c.last_stable_load = load(outcome.lower_bound);
    c.limit_load = load(outcome.factor);
    c.contacts = outcome.interfaces.iter().map(|i| i.points.len()).sum();
    // Both bounds must agree to this.
    c.tolerance = 1e-6;
    c.by = By::Limit(LimitReport {
        friction: rigid::flow_rule(outcome.friction),
        lower_bound: load(outcome.lower_bound),
        upper_bound: load(outcome.upper_bound),
        associated_load: load(outcome.associated_factor),
        spread: outcome.spread.map(|s| s.map(|f| d.load(f))),
        unlimited_strength_load: load(unlimited),
        equilibrium_residual: Some(outcome.equilibrium_residual),
        yield_violation: Some(outcome.yield_violation),
        iterations: outcome.iterations,
        jammed: outcome.jammed,
        comes_and_goes: outcome.comes_and_goes,
        ..LimitReport::default()
    });
}
