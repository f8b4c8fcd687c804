//! Limit analysis of rigid blocks as every engine and every question asks for it: settings, the load, what is drawn of it.

use crate::analysis::geometry::{between_rings, edge_at, lines, point, scaled};
use crate::analysis::state::{self, Change};
use crate::analysis::{AnalysisError, parallel, picture, template};
use bridge::{Bridge, ContactPoints, Friction, Plan};
use mechanics::blocks::Interface;
use mechanics::ids::{BlockId, Id};
use mechanics::limit;
use mechanics::plane::Vec2;
use mechanics::watch::{CancelToken, Watch};
use outcome::collapse::{By, Collapse, FlowRule, Status};
use outcome::picture::{ContactForce, Hinge, Motion, Picture, Snapshot, ThrustPoint};
use structure::discretise::{Discretised, discretise, pressure};

/// How the plan wants limit analysis done: with the compressive strength of the file, where it gives one.
pub fn settings(bridge: &Bridge) -> limit::Settings {
    settings_of(&bridge.plan, bridge.masonry.compressive_strength.is_some())
}

/// The same for any plan, with or without joints that crush.
pub fn settings_of(plan: &Plan, crushing: bool) -> limit::Settings {
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

/// The blocks as limit analysis sees them, whatever method the plan names: particles as weight, and fill that presses against movement.
///
/// # Errors
/// A bridge that cannot be cut into blocks.
pub fn prepared(bridge: &Bridge) -> Result<Discretised, AnalysisError> {
    let own = state::with(bridge, &[Change::ParticlesAsWeight]);
    let mut d = discretise(&own)?;
    d.loading.movements.clear();
    // Walls stand in place of the fill.
    if d.road.is_none() {
        d.loading.restraints = pressure::restraints(&own, &d.extrados);
    }
    Ok(d)
}

/// The blocks, where a load reaches them.
///
/// # Errors
/// No load.
pub fn loaded(d: Discretised) -> Result<Discretised, AnalysisError> {
    if d.loading.variable.is_empty() { Err(AnalysisError::NoLoad) } else { Ok(d) }
}

/// Result of an analysis that was cancelled before any load was found.
pub fn cancelled(bridge: &Bridge, d: &Discretised, by: By) -> Collapse {
    Collapse { status: Status::Cancelled, ..template::of_bridge(bridge, d, by, "as built") }
}

/// The same as [`solve`], watched.
///
/// # Errors
/// Blocks that cannot be analysed.
pub fn watched(
    d: &Discretised,
    settings: &limit::Settings,
    watch: &mut dyn Watch,
) -> Result<limit::Outcome, AnalysisError> {
    parallel::alone("limit load", false, watch, |token| solve(d, settings, token))
}

/// What rigid blocks carry whose joints do not crush.
///
/// # Errors
/// Blocks that cannot be analysed.
pub fn uncrushed(bridge: &Bridge, d: &Discretised, watch: &mut dyn Watch) -> Result<limit::Outcome, AnalysisError> {
    // Joints that do not crush are the ones to compare with: a contact point spreads its force over a length, where
    // limit analysis lets a joint crush under its edge.
    let uncrushed = limit::Settings { crushing: false, ..single(bridge, d) };
    watched(d, &uncrushed, watch)
}

/// The limit load of the model.
///
/// # Errors
/// Blocks that cannot be analysed.
pub fn solve(
    d: &Discretised,
    settings: &limit::Settings,
    token: &CancelToken,
) -> Result<limit::Outcome, AnalysisError> {
    Ok(limit::collapse_load_while(&d.model, &d.loading, settings, token)?)
}

/// The flow rule that numbers belong to.
pub fn flow_rule(friction: limit::Friction) -> FlowRule {
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

/// Lines of thrust through the resultants, of which there is one for each of `joints`, in their order.
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
    let n = d.model.blocks.len();
    picture.last_stable = Some(0);
    picture.snapshots = vec![Snapshot {
        load: d.load(factor),
        motions: vec![Motion::default(); n],
        velocities: vec![[0.0; 2]; n],
        stresses: picture::stresses(d, &contacts, factor),
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

fn middle(joint: &Interface) -> Vec2 {
    joint.points.iter().fold(Vec2::ZERO, |s, &p| s + p) * (1.0 / joint.points.len() as f64)
}
