//! The least ring thickness that stands.

use super::template;
use super::{AnalysisError, by_dem, by_limit, notes, parallel, picture};
use bridge::{Bridge, Method};
use mechanics::dem;
use mechanics::limit;
use mechanics::watch::{CancelToken, Progress, Watch, Wish};
use outcome::collapse::{By, Sought};
use outcome::collapse::{Collapse, LimitReport, Status, ThicknessReport};
use outcome::note;
use std::cell::RefCell;
use structure::discretise::{Discretised, discretise};

/// Limit analysis narrows the thickness to this share of the given one.
const EXACT: f64 = 1e-7;
/// Discrete elements bracket it to this share: half of what is worth a decision on site.
const BRACKET: f64 = 5e-3;
/// Thickness is searched up to this multiple of the given one, as far as the rings fit beside one another.
const THICKEST: f64 = 8.0;
/// Thickness is searched down to this share of the given one, and to four times the rounding of the corners.
const THINNEST: f64 = 0.02;

/// The same bridge with all rings `factor` times as thick, on the same intrados, its loads at rest on it.
pub(super) fn thickened(bridge: &Bridge, factor: f64) -> Result<Discretised, AnalysisError> {
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

/// Shares of the given thickness between which the rings can be drawn.
fn range(bridge: &Bridge) -> [f64; 2] {
    let rings = bridge.spans.iter().flat_map(|s| &s.rings);
    let thinnest = rings.map(|r| r.crown_thickness.min(r.springing_thickness)).fold(f64::INFINITY, f64::min);
    let mut most = 1.0;
    while most < THICKEST && thickened(bridge, 1.25 * most).is_ok() {
        most *= 1.25;
    }
    [THINNEST.max(4.0 * bridge.masonry.rounding / thinnest).min(1.0), most]
}

/// Narrows the thickness at which the bridge just stands under its weight and the loads of its file, with the intrados
/// held. Hinges belong to the thickest ring that falls, the line of thrust to the thinnest that stands.
pub fn thickness(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    // What is wrong with the bridge as given is said before any search.
    thickened(bridge, 1.0)?;
    let mut c = match bridge.plan.method {
        Method::Limit => by_limit(bridge, watch)?,
        Method::Dem => by_dem(bridge, watch)?,
        Method::Path => return Err(AnalysisError::NotByPath("the least thickness")),
        Method::Fe => return Err(AnalysisError::NotByFiniteElements("the least thickness")),
    };
    c.assumptions.push(note::Blocks::Thinned.into());
    Ok(c)
}

fn report(bridge: &Bridge, [fell, stood]: [f64; 2]) -> ThicknessReport {
    let total: f64 = bridge.spans[0].rings.iter().map(|r| r.crown_thickness).sum::<f64>() * stood;
    ThicknessReport {
        factor: [fell, stood],
        crown_thickness: total,
        over_mean_radius: intrados_radius(bridge).map(|r| total / (r + 0.5 * total)),
    }
}

/// Radius of the first span's intrados, where it is a circle [m].
fn intrados_radius(bridge: &Bridge) -> Option<f64> {
    let span = &bridge.spans[0];
    span.intrados().ok()?.circle()
}

fn by_limit(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let settings = by_limit::settings(bridge);
    let given = thickened(bridge, 1.0)?;
    let search = |token: &CancelToken| {
        let failed = RefCell::new(None);
        let make = |factor: f64| match thickened(bridge, factor) {
            Ok(d) => (d.model, d.loading),
            Err(error) => {
                failed.replace(Some(error));
                (given.model.clone(), given.loading.clone())
            }
        };
        let found = limit::minimum_thickness(range(bridge), EXACT, 1.0, &settings, token, make)?;
        failed.into_inner().map_or(Ok(found), Err)
    };
    let found = parallel::alone("least thickness", true, watch, search)?;
    let shown = thickened(bridge, found.stands.or(found.falls).unwrap_or(1.0))?;
    let (joints, line) = limit::least_thrust(&shown.model, &shown.loading, 0.0, &settings)?;
    let mut picture = picture::built(bridge, &shown, "least thickness");
    if let Some(mechanism) = &found.mechanism {
        by_limit::draw_mechanism(&shown, &joints, mechanism, &mut picture);
    }
    if let Some(line) = &line {
        picture.thrust_lines = by_limit::thrust_lines(&shown, &joints, line);
    }
    let by = By::Limit(LimitReport { iterations: found.trials, ..LimitReport::default() });
    let mut c = template::of_bridge(bridge, &shown, by, picture);
    c.tolerance = EXACT;
    c.contacts = joints.iter().map(|i| i.points.len()).sum();
    c.status = match found.status {
        limit::ThicknessStatus::Found => Status::Completed,
        limit::ThicknessStatus::StandsAtThinnest => Status::StableToLastLoad,
        limit::ThicknessStatus::FallsAtThickest => Status::UnstableUnderSelfWeight,
        limit::ThicknessStatus::NotConverged => Status::NotConverged,
        limit::ThicknessStatus::Cancelled => Status::Cancelled,
    };
    c.sought = Sought::Thickness(found.falls.zip(found.stands).map(|(fell, stood)| report(bridge, [fell, stood])));
    notes::limit(bridge, &shown, &mut c);
    Ok(c)
}

/// An onlooker who is told which thickness is tried.
struct Trial<'a> {
    watch: &'a mut dyn Watch,
    factor: f64,
}

impl Watch for Trial<'_> {
    fn look(&mut self, progress: &Progress) -> Wish {
        let stage = format!("thickness {:.4} of the given one: {}", self.factor, progress.stage);
        self.watch.look(&Progress { stage, fraction: None, steps: progress.steps })
    }
}

fn by_dem(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    by_dem::require_stiffness(bridge)?;
    let settings = by_dem::settings(bridge);
    let run = |factor: f64, watch: &mut dyn Watch| -> Result<(Discretised, dem::Outcome), AnalysisError> {
        let d = thickened(bridge, factor)?;
        let program = dem::Program { increment: 1.0, limit: 0.0, resolution: None, watched: d.watched };
        let outcome = dem::collapse(&d.model, &d.loading, &program, &settings, None, &mut Trial { watch, factor })?;
        Ok((d, outcome))
    };
    let [least, most] = range(bridge);
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
                (ended, _) = by_dem::status(&outcome);
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
    let mut c = by_dem::report(bridge, &d, &outcome, "least thickness", &|factor| factor);
    c.status = ended;
    c.sought = Sought::Thickness(fell.zip(stood.as_ref()).map(|(fell, (stood, ..))| report(bridge, [fell, *stood])));
    if let Some((_, d, outcome)) = &stood {
        let standing = by_dem::report(bridge, d, outcome, "least thickness", &|factor| factor);
        c.picture.thrust_lines = standing.picture.thrust_lines;
        c.max_compressive_stress = standing.max_compressive_stress;
        c.contacts = standing.contacts;
    }
    notes::dem(bridge, &d, &mut c);
    Ok(c)
}
