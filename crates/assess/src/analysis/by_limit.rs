//! Collapse load by limit analysis.

use super::by_bounds::collapse_by_bounds;
use super::geometry::{between_rings, edge_at, lines, point, scaled};
use super::template;
use super::{AnalysisError, notes, parallel, picture, policy};
use bridge::{Bridge, ContactPoints, Friction, Method, Plan};
use mechanics::blocks::Interface;
use mechanics::ids::{BlockId, Id};
use mechanics::limit;
use mechanics::watch::{CancelToken, Watch};
use outcome::collapse::{By, FlowRule};
use outcome::collapse::{Collapse, LimitReport, Status};
use outcome::collapse::{FiniteReport, PathReport};
use outcome::picture::{ContactForce, Hinge, Motion, Picture, Snapshot, ThrustPoint};
use structure::discretise::{Discretised, continuum, discretise, pressure};

/// How the plan wants limit analysis done: with the compressive strength of the file, where it gives one.
pub fn settings(bridge: &Bridge) -> limit::Settings {
    settings_of(&bridge.plan, bridge.masonry.compressive_strength.is_some())
}

/// The same for any plan, with or without joints that crush.
pub(super) fn settings_of(plan: &Plan, crushing: bool) -> limit::Settings {
    limit::Settings {
        friction: match plan.friction {
            Friction::Associated => limit::Friction::Associated,
            Friction::NonAssociated => limit::Friction::NonAssociated,
            Friction::Automatic => limit::Friction::Automatic,
        },
        contact_points: match plan.contact_points {
            ContactPoints::Rounded => limit::ContactPoints::Rounded,
            ContactPoints::FullRing => limit::ContactPoints::FullRing,
        },
        crushing,
        ..limit::Settings::default()
    }
}

/// The plan's settings, but where only one load can stand: walls of blocks lock where sliding dilates, so that theirs
/// is never the associated one.
pub fn single(bridge: &Bridge, d: &Discretised) -> limit::Settings {
    match settings(bridge) {
        s if d.road.is_some() && s.friction == limit::Friction::Associated => {
            limit::Settings { friction: limit::Friction::Automatic, ..s }
        }
        s => s,
    }
}

/// The blocks as limit analysis sees them: with fill that presses against movement.
pub(super) fn prepared(bridge: &Bridge) -> Result<Discretised, AnalysisError> {
    let mut d = discretise(bridge)?;
    d.loading.movements.clear();
    // Walls and particles stand in place of the fill.
    if d.road.is_none() && d.fill.is_none() {
        d.loading.restraints = pressure::restraints(bridge, &d.extrados);
    }
    Ok(d)
}

/// The bridge with all of the fill's passive pressure mobilised.
fn fully_pressed(bridge: &Bridge) -> Bridge {
    let mut own = bridge.clone();
    if let Some(fill) = &mut own.fill_pressure {
        (fill.mobilisation, fill.cohesion_mobilisation) = (1.0, 1.0);
    }
    own
}

/// The load factor at which the blocks become a mechanism; what may help and may come and go is not counted.
pub fn collapse_by_limit(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    policy::collapse(bridge, None, watch, &|state, _, watch| as_described(state, watch))
}

/// The load factor at which the blocks become a mechanism, with all that the file says of them.
pub(super) fn as_described(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    if continuum::wanted(bridge).is_some() {
        return collapse_by_bounds(bridge, watch);
    }
    let d = prepared(bridge)?;
    if d.loading.variable.is_empty() {
        return Err(AnalysisError::NoLoad);
    }
    parallel::alone("limit analysis", true, watch, |token| whole(bridge, &d, token))
}

/// Result of an analysis that was cancelled before any load was found.
pub(super) fn cancelled(bridge: &Bridge, d: &Discretised) -> Collapse {
    let by = match bridge.plan.method {
        Method::Limit => By::Limit(LimitReport::default()),
        Method::Dem => By::Dem(None),
        Method::Path => By::Path(PathReport::default()),
        Method::Fe => By::Fe(FiniteReport::default()),
    };
    Collapse { status: Status::Cancelled, ..template::of_bridge(bridge, d, by, picture::built(bridge, d, "as built")) }
}

/// The load factor and those that stand beside it.
fn whole(bridge: &Bridge, d: &Discretised, token: &CancelToken) -> Result<Collapse, AnalysisError> {
    let settings = settings(bridge);
    let walls = d.road.is_some() && settings.friction == limit::Friction::Associated;
    let pressed = !d.loading.restraints.is_empty();
    // The loads that are found, one after the other.
    let count = 1 + usize::from(settings.crushing) + usize::from(pressed) + usize::from(walls);
    let mut parts = (0..count).map(|k| token.part(k, count));
    let mut solve = |d: &Discretised, settings: &limit::Settings| {
        solve(d, settings, &parts.next().unwrap_or_else(|| token.clone()))
    };
    let outcome = solve(d, &settings)?;
    let unlimited = match settings.crushing {
        true => solve(d, &limit::Settings { crushing: false, ..settings })?.factor,
        false => outcome.factor,
    };
    let mut c = report(bridge, d, &outcome, unlimited);
    if pressed {
        let mut whole = d.clone();
        whole.loading.restraints = pressure::restraints(&fully_pressed(bridge), &d.extrados);
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
    Ok(if !token.is_cancelled() { c } else { cancelled(bridge, d) })
}

/// The same as [`solve`], watched.
pub fn watched(
    d: &Discretised,
    settings: &limit::Settings,
    watch: &mut dyn Watch,
) -> Result<limit::Outcome, AnalysisError> {
    parallel::alone("limit load", false, watch, |token| solve(d, settings, token))
}

/// The limit load of the model.
pub fn solve(
    d: &Discretised,
    settings: &limit::Settings,
    token: &CancelToken,
) -> Result<limit::Outcome, AnalysisError> {
    Ok(limit::collapse_load_while(&d.model, &d.loading, settings, token)?)
}

/// The flow rule that numbers belong to.
pub(super) fn flow_rule(friction: limit::Friction) -> FlowRule {
    match friction {
        limit::Friction::NonAssociated => FlowRule::NonAssociated,
        _ => FlowRule::Associated,
    }
}

/// How a limit analysis ended, for an engineer.
pub fn status(status: limit::Status) -> Status {
    match status {
        limit::Status::Solved => Status::Collapsed,
        limit::Status::Locks => Status::Locks,
        limit::Status::NoEquilibrium => Status::UnstableUnderSelfWeight,
        limit::Status::NotConverged => Status::NotConverged,
        limit::Status::Cancelled => Status::Cancelled,
    }
}

fn report(bridge: &Bridge, d: &Discretised, outcome: &limit::Outcome, unlimited: Option<f64>) -> Collapse {
    let mut picture = picture::built(bridge, d, "limit analysis");
    draw(d, outcome, &mut picture);
    let mut c = template::of_bridge(bridge, d, By::Limit(LimitReport::default()), picture);
    c.status = status(outcome.status);
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
        friction: flow_rule(outcome.friction),
        lower_bound: load(outcome.lower_bound),
        upper_bound: load(outcome.upper_bound),
        associated_load: load(outcome.associated_factor),
        non_associated_load: None,
        without_fill_pressure_load: None,
        full_fill_pressure_load: None,
        spread: outcome.spread.map(|s| s.map(|f| d.load(f))),
        unlimited_strength_load: load(unlimited),
        equilibrium_residual: Some(outcome.equilibrium_residual),
        yield_violation: Some(outcome.yield_violation),
        iterations: outcome.iterations,
        jammed: outcome.jammed,
        continuum: None,
    });
}

/// A joint counts as a hinge from this share of the largest rotation: where the thrust line runs along an edge for some
/// joints, the solver leaves traces of rotation in those beside the hinge.
const HINGE: f64 = 1e-3;

/// Motions, hinges and sliding joints of a mechanism.
pub fn draw_mechanism(d: &Discretised, joints: &[Interface], m: &limit::Mechanism, picture: &mut Picture) {
    let motions = m.velocities.iter().map(|&(v, rotation)| Motion { translation: point(v), rotation }).collect();
    picture.mechanism = scaled(motions);
    picture.hinges = hinges(d, joints, &m.hinges);
    picture.sliding = m.sliding.iter().map(|&j| point(middle(&joints[j]))).collect();
}

/// Hinges that count, at their edges.
pub fn hinges(d: &Discretised, joints: &[Interface], found: &[limit::Hinge]) -> Vec<Hinge> {
    let largest = found.iter().map(|h| h.rotation.abs()).fold(0.0, f64::max);
    let counts = found.iter().filter(|h| {
        let joint = &joints[h.joint];
        h.rotation.abs() >= HINGE * largest && !between_rings(d, joint.first, joint.second)
    });
    counts
        .map(|h| {
            let joint = &joints[h.joint];
            let edge = edge_at(d, joint.first, joint.second, h.at);
            let between = [joint.first, joint.second].map(BlockId::index);
            Hinge { point: point(h.at), edge, between, rotation: h.rotation }
        })
        .collect()
}

/// Lines of thrust through the resultants of the joints.
pub fn thrust_lines(
    d: &Discretised,
    joints: &[Interface],
    resultants: &[Option<limit::Resultant>],
) -> Vec<Vec<ThrustPoint>> {
    let points = joints.iter().zip(resultants).filter_map(|(i, r)| {
        let r = (*r)?;
        Some((i.first, i.second, ThrustPoint { point: point(r.at), thrust: r.force.norm() }))
    });
    lines(d, points)
}

/// Mechanism, hinges, thrust lines and forces of a limit analysis.
pub fn draw(d: &Discretised, outcome: &limit::Outcome, picture: &mut Picture) {
    if let Some(m) = &outcome.mechanism {
        draw_mechanism(d, &outcome.interfaces, m, picture);
    }
    picture.thrust_lines = thrust_lines(d, &outcome.interfaces, &outcome.resultants);
    let Some(factor) = outcome.factor else { return };
    let sliding = outcome.mechanism.as_ref().map_or(&[][..], |m| &m.sliding[..]);
    let mut contacts = Vec::new();
    for (k, (joint, forces)) in outcome.interfaces.iter().zip(&outcome.forces).enumerate() {
        let length = joint_length(joint) / joint.points.len() as f64;
        for p in forces.points.iter().filter(|p| p.compression > 0.0) {
            contacts.push(ContactForce {
                blocks: [joint.first.index(), joint.second.index()],
                point: point(p.at),
                normal: point(joint.normal),
                compression: p.compression,
                shear: p.shear,
                stress: if length > 0.0 { p.compression / length } else { 0.0 },
                sliding: sliding.contains(&k),
            });
        }
    }
    let permanent = d.loading.permanent.iter().map(|f| (*f, 1.0));
    let loads: Vec<_> = permanent.chain(d.loading.variable.iter().map(|f| (*f, factor))).collect();
    let n = d.model.blocks.len();
    picture.last_stable = Some(0);
    picture.snapshots = vec![Snapshot {
        load: d.load(factor),
        motions: vec![Motion::default(); n],
        velocities: vec![[0.0; 2]; n],
        stresses: picture::stresses(d, &contacts, &loads),
        contacts,
        ..Snapshot::default()
    }];
}

fn joint_length(joint: &Interface) -> f64 {
    match joint.face[..] {
        [a, b] => (b - a).norm(),
        _ => 0.0,
    }
}

fn middle(joint: &Interface) -> mechanics::plane::Vec2 {
    joint.points.iter().fold(mechanics::plane::Vec2::ZERO, |s, &p| s + p) * (1.0 / joint.points.len() as f64)
}
