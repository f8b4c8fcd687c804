//! The least ring thickness that stands.

use super::report::{Collapse, Status, ThicknessReport};
use super::{AnalysisError, by_dem, by_limit, notes, picture};
use crate::discretise::{Discretised, discretise};
use bridge::ring::Profile;
use bridge::{Analysis, Bridge, Method};
use mechanics::dem;
use mechanics::limit;
use mechanics::watch::{Progress, Unwatched, Watch, Wish};

/// Limit analysis narrows the thickness to this share.
const EXACT: f64 = 1e-7;
/// Discrete elements bracket it to this share, unless the plan's resolution is finer than what an engineer surveys.
const BRACKET: f64 = 5e-3;
/// Thickness is searched between these shares of the given one.
const RANGE: [f64; 2] = [0.02, 16.0];

/// The same bridge with all rings `factor` times as thick, on the same intrados, its loads at rest on it.
fn thickened(bridge: &Bridge, factor: f64) -> Result<Discretised, AnalysisError> {
    let mut changed = bridge.clone();
    for ring in changed.spans.iter_mut().flat_map(|s| &mut s.rings) {
        ring.crown_thickness *= factor;
        ring.springing_thickness *= factor;
    }
    let mut d = discretise(&changed)?;
    let loads = std::mem::take(&mut d.loading.variable);
    d.loading.permanent.extend(loads);
    d.loading.movements.clear();
    Ok(d)
}

/// Narrows the thickness at which the bridge just stands under its weight and the loads of its file, with the intrados
/// held. Hinges and thrust line belong to the thinnest ring that stands.
pub fn thickness(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let by_limit = bridge.plan.method == Method::Limit;
    if !by_limit {
        by_dem::require_stiffness(bridge)?;
    }
    let limit_settings = by_limit::settings(bridge);
    let dem_settings = by_dem::settings(bridge);
    let run = |factor: f64| -> Result<(Discretised, dem::Outcome), AnalysisError> {
        let d = thickened(bridge, factor)?;
        let program = dem::Program { increment: 1.0, limit: 0.0, resolution: None, watched: d.watched };
        let outcome = dem::collapse(&d.model, &d.loading, &program, &dem_settings, None, &mut Unwatched)?;
        Ok((d, outcome))
    };
    // Whether a thickness stands; none where the method cannot tell.
    let stands = |factor: f64| -> Result<Option<bool>, AnalysisError> {
        if by_limit {
            let d = thickened(bridge, factor)?;
            Ok(match limit::collapse_load(&d.model, &d.loading, &limit_settings)?.status {
                limit::Status::Solved | limit::Status::Locks => Some(true),
                limit::Status::NoEquilibrium => Some(false),
                limit::Status::NotConverged => None,
            })
        } else {
            Ok(match run(factor)?.1.status {
                dem::Status::StableToLastLoad => Some(true),
                dem::Status::UnstableUnderSelfWeight | dem::Status::Collapsed => Some(false),
                _ => None,
            })
        }
    };
    let narrow = if by_limit { EXACT } else { BRACKET };
    let mut steps = 0;
    let mut ended = Status::Completed;
    let [mut thin, mut thick] = RANGE;
    let mut bracket = [None, None];
    // Geometric steps out from the given thickness, then halving.
    let mut factor = 1.0;
    while bracket[0].is_none() || bracket[1].is_none() || thick / thin > 1.0 + narrow {
        steps += 1;
        let stage = format!("thickness {factor:.6} of the given one");
        if watch.look(&Progress { stage, fraction: None, steps }) == Wish::Stop {
            ended = Status::Cancelled;
            break;
        }
        match stands(factor)? {
            Some(true) => (thick, bracket[1]) = (factor, Some(factor)),
            Some(false) => (thin, bracket[0]) = (factor, Some(factor)),
            None => {
                ended = Status::NotConverged;
                break;
            }
        }
        factor = match bracket {
            [None, Some(stood)] => 0.7 * stood,
            [Some(fell), None] => fell / 0.7,
            _ => (thin * thick).sqrt(),
        };
        if !(RANGE[0]..=RANGE[1]).contains(&factor) {
            ended = if bracket[1].is_none() { Status::UnstableUnderSelfWeight } else { Status::Completed };
            break;
        }
    }
    let shown = bracket[1].unwrap_or(1.0);
    let mut c = if by_limit { limit_view(bridge, shown, bracket[0])? } else { dem_view(bridge, run(shown)?) };
    c.status = ended;
    if let [Some(fell), Some(stood)] = bracket {
        let total: f64 = bridge.spans[0].rings.iter().map(|r| r.crown_thickness).sum::<f64>() * stood;
        c.thickness = Some(ThicknessReport {
            factor: [fell, stood],
            crown_thickness: total,
            over_mean_radius: intrados_radius(bridge).map(|r| total / (r + 0.5 * total)),
        });
    }
    c.assumptions.push("Rings are thinned on the same intrados; the loads of the file rest on them.".into());
    Ok(c)
}

/// Radius of the first span's intrados, where it is a circle [m].
fn intrados_radius(bridge: &Bridge) -> Option<f64> {
    let span = &bridge.spans[0];
    match span.profile {
        Profile::Segmental => Some((0.25 * span.span * span.span + span.rise * span.rise) / (2.0 * span.rise)),
        Profile::Semicircular => Some(0.5 * span.span),
        _ => None,
    }
}

/// The thinnest ring that stands: its thrust line touches the edges at the hinges of the mechanism in which the next
/// thinner one falls.
fn limit_view(bridge: &Bridge, stood: f64, fell: Option<f64>) -> Result<Collapse, AnalysisError> {
    let d = thickened(bridge, stood)?;
    let settings = by_limit::settings(bridge);
    let mut picture = picture::built(bridge, &d, "least thickness");
    let outcome = limit::collapse_load(&d.model, &d.loading, &settings)?;
    by_limit::draw(&d, &outcome, &mut picture);
    if let Some(fell) = fell {
        let thinner = thickened(bridge, fell)?;
        let fallen = limit::collapse_load(&thinner.model, &thinner.loading, &settings)?;
        by_limit::draw(&thinner, &fallen, &mut picture);
    }
    let mut c = blank(bridge, &d, picture);
    c.contacts = outcome.interfaces.iter().map(|i| i.points.len()).sum();
    c.limit = Some(super::report::LimitReport {
        friction: if outcome.friction == limit::Friction::NonAssociated { "non-associated" } else { "associated" },
        lower_bound: None,
        upper_bound: None,
        associated_load: None,
        equilibrium_residual: outcome.equilibrium_residual,
        yield_violation: outcome.yield_violation,
        iterations: outcome.iterations,
    });
    notes::limit(bridge, &d, &mut c);
    c.tolerance = EXACT;
    Ok(c)
}

fn dem_view(bridge: &Bridge, (d, outcome): (Discretised, dem::Outcome)) -> Collapse {
    let mut c = by_dem::report(bridge, &d, &outcome, "least thickness", 1.0);
    c.analysis = Analysis::Thickness;
    notes::dem(bridge, &d, &mut c);
    c
}

fn blank(bridge: &Bridge, d: &Discretised, picture: crate::outcome::Picture) -> Collapse {
    Collapse {
        bridge: bridge.name.clone(),
        width: bridge.width,
        method: bridge.plan.method,
        analysis: Analysis::Thickness,
        status: Status::Completed,
        collapse_load: None,
        last_stable_load: None,
        load_step: None,
        reference_load: d.reference_load,
        limit_load: None,
        hinges: picture.hinges.clone(),
        sliding_joints: picture.sliding.clone(),
        max_compressive_stress: None,
        blocks: d.model.blocks.len(),
        particles: 0,
        contacts: 0,
        tolerance: bridge.plan.tolerance,
        seed: bridge.plan.seed,
        dem: None,
        limit: None,
        thickness: None,
        support: None,
        block_names: d.origins.iter().map(|o| o.name()).collect(),
        warnings: Vec::new(),
        assumptions: Vec::new(),
        picture,
    }
}
