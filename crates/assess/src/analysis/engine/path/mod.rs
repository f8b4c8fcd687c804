//! Collapse along the equilibrium path: deformable joints, up to the largest load and past it.

mod stiffness_study;

use crate::analysis::engine::joints::{contact_length, require_stiffness};
use crate::analysis::engine::{Engine, rigid};
use crate::analysis::geometry::{lines, moving, point, scaled};
use crate::analysis::{AnalysisError, default_stiffness, notes, picture, service, template};
use bridge::{Bridge, JointContact, Method};
use mechanics::blocks::Interface;
use mechanics::contact::ContactLength;
use mechanics::ids::Id;
use mechanics::limit;
use mechanics::path::{self, Cause, Frame, PathPoint};
use mechanics::watch::Watch;
use outcome::collapse::{By, Collapse, Ended, PathPressure, PathReport, Permissible, Status};
use outcome::note;
use outcome::picture::{ContactForce, Motion, Picture, Snapshot, Step, ThrustPoint};
use outcome::warning::{self, Warning};
use structure::discretise::Discretised;

/// First increment of the load, as a share of that of rigid blocks.
const FIRST_STEP: f64 = 0.05;

/// The load beyond which no more is sought, in loads of rigid blocks: theirs is never passed but by a hair. Rigid blocks have no
/// cohesion, or part of it: joints that have some may carry any multiple of that load.
const BEYOND: f64 = 1.5;

/// Pictures of the path: as many as its result shows.
const MOST_PICTURES: usize = 24;

/// Static path following.
pub(crate) struct Path;

impl Engine for Path {
    fn method(&self) -> Method {
        Method::Path
    }

    fn joints(&self, bridge: &Bridge) -> Result<(), AnalysisError> {
        require_stiffness(&default_stiffness::stiffened(bridge))
    }

    fn load(&self, bridge: &Bridge, resume: Option<&[u8]>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
        until_its_largest_load(bridge, resume, watch)
    }
}

/// Follows the balanced states of the bridge from its own weight to its largest load.
fn until_its_largest_load(
    bridge: &Bridge,
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
) -> Result<Collapse, AnalysisError> {
    let taken = default_stiffness::note(bridge);
    let bridge = &default_stiffness::stiffened(bridge);
    require_stiffness(bridge)?;
    let d = rigid::loaded(rigid::prepared(bridge)?)?;
    let rigid = rigid::uncrushed(bridge, &d, watch)?;
    if rigid.status == limit::Status::Cancelled {
        return Ok(rigid::cancelled(bridge, &d, By::Path(PathReport::default())));
    }
    let bound = rigid.factor.or(rigid.associated_factor);
    let given = |load: Option<f64>| load.map(|load| load / d.reference_load);
    let program = path::Program {
        increment: given(bridge.plan.load_step).or(bound.map(|b| FIRST_STEP * b)).unwrap_or(1.0),
        limit: given(bridge.plan.load_limit.map(|most| most - d.counted_weight))
            .or(bound.filter(|_| !cohesive(&d)).map(|b| BEYOND * b))
            .unwrap_or(f64::INFINITY),
        watched: d.watched,
    };
    let contact = bridge.plan.contact.unwrap_or(JointContact::Distributed);
    let settings = path::Settings {
        onsets: service::sought(strength(&d)),
        ..path::Settings::new(contact_length(&bridge.plan, contact))
    };
    let outcome = path::collapse(&d.model, &d.loading, (&settings, &program), resume, watch)?;
    let mut c = report(bridge, &d, (&settings, contact), &outcome);
    c.load_step = Some(d.load(program.increment));
    c.limit_load = rigid.factor.map(|factor| d.load(factor));
    if !d.loading.restraints.is_empty() {
        pressed(&outcome, &mut c);
    }
    if let (Some(own), Some(rigid)) = (outcome.collapse_factor, rigid.factor) {
        let own = (own, outcome.iterations);
        c.picture.over_stiffness = stiffness_study::over_stiffness(&d, (&settings, &program), own, rigid)?;
    }
    let distributed = settings.contact_length == ContactLength::Distributed;
    notes::path(bridge, &d, distributed, &mut c);
    notes::apart(rigid.status, &mut c);
    c.warnings.extend(taken);
    c.warnings.extend(broken_off(&c));
    // Both are answers: a stiffer joint may let the blocks stand.
    if c.status == Status::UnstableUnderSelfWeight && rigid.factor.is_some() {
        c.assumptions.push(note::Blocks::FallOnDeformableJoints.into());
    }
    if rigid::settings(bridge).crushing {
        let crushed = rigid::watched(&d, &rigid::single(bridge, &d), watch)?.factor;
        c.crushing_limit_load = crushed.map(|factor| d.load(factor));
    }
    Ok(c)
}

/// What movement has mobilised of the fill's pressure at the largest load.
fn pressed(outcome: &path::Outcome, c: &mut Collapse) {
    let By::Path(report) = &mut c.by else { return };
    let at_peak = outcome.peak.and_then(|k| outcome.path.get(outcome.frames[k].step));
    report.fill_pressure =
        Some(PathPressure { without: None, mobilised: at_peak.map_or(0.0, |point| point.mobilised) });
}

/// What is to be said of a path that broke off, or never began.
fn broken_off(c: &Collapse) -> Option<Warning> {
    let carried = c.last_stable_load;
    (c.status == Status::NotConverged).then(|| warning::Loads::PathBrokenOff { carried }.into())
}

/// Whether joints have cohesion.
fn cohesive(d: &Discretised) -> bool {
    d.model.laws.clone().iter_mut().any(|law| law.cohesion > 0.0)
}

fn report(
    bridge: &Bridge,
    d: &Discretised,
    (settings, contact): (&path::Settings, JointContact),
    outcome: &path::Outcome,
) -> Collapse {
    let load = |factor: Option<f64>| factor.map(|f| d.load(f));
    let (status, ended) = ended(outcome);
    let permissible = service::met(&outcome.onsets);
    let weight = d.model.free_weight().max(f64::MIN_POSITIVE);
    let report = PathReport {
        ended,
        contact: Some(contact),
        permissible: permissible.map(|(criterion, factor)| Permissible { criterion, load: d.load(factor) }).collect(),
        snaps: outcome.snaps,
        equilibrium_residual: outcome.path.iter().map(|p| p.residual).fold(0.0, f64::max),
        yield_violation: outcome.path.iter().map(|p| p.excess).fold(0.0, f64::max) / weight,
        iterations_total: outcome.iterations,
        fill_pressure: None,
    };
    let at_peak = outcome.peak.and_then(|k| outcome.frames.get(k));
    let mut c = template::of_bridge(bridge, d, By::Path(report), "equilibrium path");
    draw(d, outcome, &mut c.picture);
    c.status = status;
    c.collapse_load = load(outcome.collapse_factor);
    c.last_stable_load = load(outcome.last_stable_factor);
    c.max_compressive_stress = at_peak.map(|frame| outcome.path[frame.step].stress);
    c.contacts =
        at_peak.map_or(0, |frame| frame.joints.iter().flat_map(|j| &j.ends).filter(|e| e.compression > 0.0).count());
    c.tolerance = settings.tolerance;
    c
}

/// How a path ended, for an engineer and by what.
fn ended(outcome: &path::Outcome) -> (Status, Ended) {
    match (outcome.status, outcome.cause) {
        (path::Status::LimitPoint, Some(Cause::Sliding)) => (Status::Collapsed, Ended::Sliding),
        (path::Status::LimitPoint, Some(Cause::Crushing)) => (Status::Collapsed, Ended::Crushing),
        (path::Status::LimitPoint, _) => (Status::Collapsed, Ended::LimitPoint),
        (path::Status::Bifurcation, _) => (Status::Collapsed, Ended::Bifurcation),
        (path::Status::StableToLastLoad, _) => (Status::StableToLastLoad, Ended::LoadLimit),
        (path::Status::UnstableUnderSelfWeight, _) => (Status::UnstableUnderSelfWeight, Ended::SelfWeight),
        (path::Status::NotConverged, _) => (Status::NotConverged, Ended::NotConverged),
        (path::Status::Cancelled, _) => (Status::Cancelled, Ended::Cancelled),
    }
}

/// Least crushing strength of the joints [Pa].
pub(crate) fn strength(d: &Discretised) -> f64 {
    d.model.laws.clone().iter_mut().map(|law| law.crushing).fold(f64::INFINITY, f64::min)
}

fn draw(d: &Discretised, outcome: &path::Outcome, picture: &mut Picture) {
    let step = |p: &PathPoint| Step {
        load: d.load(p.factor),
        displacement: point(p.displacement),
        iterations: u64::from(p.iterations),
        unbalanced_ratio: p.residual,
        at_rest: true,
    };
    picture.path = outcome.path.iter().map(step).collect();
    let shown = shown(outcome);
    picture.last_stable = outcome.peak.and_then(|peak| shown.iter().position(|&k| k == peak));
    picture.snapshots = shown.iter().map(|&k| snapshot(d, &outcome.interfaces, &outcome.frames[k])).collect();
    if let Some(frame) = outcome.peak.map(|k| &outcome.frames[k]) {
        picture.thrust_lines = thrust_lines(d, &outcome.interfaces, frame);
    }
    let motions = outcome.mechanism.iter().map(|&(v, rotation)| Motion { translation: point(v), rotation });
    picture.mechanism = scaled(motions.collect());
    moving(d, &outcome.interfaces, picture);
}

/// Frames that are drawn: the first, the peak, the last and some between.
fn shown(outcome: &path::Outcome) -> Vec<usize> {
    let count = outcome.frames.len();
    let every = count.div_ceil(MOST_PICTURES).max(1);
    (0..count).filter(|&k| k % every == 0 || k + 1 == count || Some(k) == outcome.peak).collect()
}

fn snapshot(d: &Discretised, joints: &[Interface], frame: &Frame) -> Snapshot {
    let mut contacts = Vec::new();
    for (joint, state) in joints.iter().zip(&frame.joints) {
        for end in state.ends.iter().filter(|end| end.compression != 0.0) {
            contacts.push(ContactForce {
                blocks: [joint.first.index(), joint.second.index()],
                point: point(end.at),
                normal: point(state.normal),
                compression: end.compression,
                shear: end.shear,
                stress: state.stress.min(end.compression / end.length.max(f64::MIN_POSITIVE)),
                sliding: end.sliding,
            });
        }
    }
    let motion = |(id, pose): (_, &mechanics::plane::Pose)| {
        let block: &mechanics::blocks::Block = &d.model.blocks[id];
        let turned = pose.rotation;
        Motion { translation: point(pose.position - block.outline.centroid()), rotation: turned.sin.atan2(turned.cos) }
    };
    Snapshot {
        load: d.load(frame.factor),
        motions: frame.poses.pairs().map(motion).collect(),
        velocities: vec![[0.0; 2]; d.model.blocks.len()],
        stresses: picture::stresses(d, &contacts, frame.factor),
        contacts,
        ..Snapshot::default()
    }
}

fn thrust_lines(d: &Discretised, joints: &[Interface], frame: &Frame) -> Vec<Vec<ThrustPoint>> {
    let points = joints.iter().zip(&frame.joints).filter_map(|(joint, state)| {
        let at = state.resultant()?;
        Some((joint.first, joint.second, ThrustPoint { point: point(at), thrust: state.force().norm() }))
    });
    lines(d, points)
}

#[cfg(test)]
mod tests {
    use super::*;
    use mechanics::watch::Unwatched;

    #[test]
    fn a_path_that_breaks_off_says_what_is_carried_and_what_is_not_known() {
        let mut b = crate::samples::bridgemill();
        b.plan.method = bridge::Method::Path;
        let mut c = until_its_largest_load(&b, None, &mut Unwatched).unwrap();
        assert_eq!(broken_off(&c), None);
        c.status = Status::NotConverged;
        let load = format!("{:.2} kN/m", c.last_stable_load.unwrap() / 1e3);
        assert!(broken_off(&c).unwrap().message().contains(&load));
        c.last_stable_load = None;
        assert!(broken_off(&c).unwrap().message().contains("nothing is known"));
    }
}
