//! Collapse load by limit analysis.

use super::places::{edge_at, lines, point, scaled};
use super::report::{Collapse, LimitReport, Status};
use super::{AnalysisError, notes, picture};
use crate::discretise::{Discretised, discretise};
use crate::outcome::{ContactForce, Hinge, Motion, Picture, Snapshot, ThrustPoint};
use bridge::{Analysis, Bridge, ContactPoints, Friction, Method};
use mechanics::blocks::{ContactLaw, Interface};
use mechanics::ids::Id;
use mechanics::limit;

/// How the plan wants limit analysis done.
pub fn settings(bridge: &Bridge) -> limit::Settings {
    limit::Settings {
        friction: match bridge.plan.friction {
            Friction::Associated => limit::Friction::Associated,
            Friction::NonAssociated => limit::Friction::NonAssociated,
            Friction::Automatic => limit::Friction::Automatic,
        },
        contact_points: match bridge.plan.contact_points {
            ContactPoints::Rounded => limit::ContactPoints::Rounded,
            ContactPoints::FullRing => limit::ContactPoints::FullRing,
        },
        crushing: bridge.masonry.compressive_strength.is_some(),
        ..limit::Settings::default()
    }
}

/// The load factor at which the blocks as built become a mechanism.
pub fn collapse_by_limit(bridge: &Bridge) -> Result<Collapse, AnalysisError> {
    let mut d = discretise(bridge)?;
    d.loading.movements.clear();
    if d.loading.variable.is_empty() {
        return Err(AnalysisError::NoLoad);
    }
    let settings = settings(bridge);
    let outcome = limit::collapse_load(&d.model, &d.loading, &settings)?;
    // Beside a non-associated load the associated one is shown, never the other way round.
    let associated = (outcome.friction == limit::Friction::NonAssociated)
        .then(|| {
            limit::collapse_load(
                &d.model,
                &d.loading,
                &limit::Settings { friction: limit::Friction::Associated, ..settings },
            )
        })
        .transpose()?
        .and_then(|o| o.factor);
    Ok(report(bridge, &d, &settings, &outcome, associated))
}

/// The word for a flow rule.
fn word(friction: limit::Friction) -> &'static str {
    match friction {
        limit::Friction::NonAssociated => "non-associated",
        _ => "associated",
    }
}

/// How a limit analysis ended, for an engineer.
pub fn status(outcome: &limit::Outcome) -> Status {
    match outcome.status {
        limit::Status::Solved => Status::Collapsed,
        limit::Status::Locks => Status::Locks,
        limit::Status::NoEquilibrium => Status::UnstableUnderSelfWeight,
        limit::Status::NotConverged => Status::NotConverged,
    }
}

fn report(
    bridge: &Bridge,
    d: &Discretised,
    settings: &limit::Settings,
    outcome: &limit::Outcome,
    associated: Option<f64>,
) -> Collapse {
    let load = |factor: Option<f64>| factor.map(|f| f * d.reference_load);
    let mut picture = picture::built(bridge, d, "limit analysis");
    draw(d, outcome, &mut picture);
    let hinges = picture.hinges.clone();
    let sliding_joints = picture.sliding.clone();
    let mut collapse = Collapse {
        bridge: bridge.name.clone(),
        width: bridge.width,
        method: Method::Limit,
        analysis: Analysis::Load,
        status: status(outcome),
        collapse_load: load(outcome.factor),
        last_stable_load: load(outcome.lower_bound),
        load_step: None,
        reference_load: d.reference_load,
        limit_load: load(outcome.factor),
        hinges,
        sliding_joints,
        max_compressive_stress: largest_stress(d, settings, outcome),
        blocks: d.model.blocks.len(),
        particles: 0,
        contacts: outcome.interfaces.iter().map(|i| i.points.len()).sum(),
        tolerance: 1e-6,
        seed: bridge.plan.seed,
        dem: None,
        limit: Some(LimitReport {
            friction: word(outcome.friction),
            lower_bound: load(outcome.lower_bound),
            upper_bound: load(outcome.upper_bound),
            associated_load: load(associated),
            equilibrium_residual: outcome.equilibrium_residual,
            yield_violation: outcome.yield_violation,
            iterations: outcome.iterations,
        }),
        thickness: None,
        support: None,
        block_names: d.origins.iter().map(|o| o.name()).collect(),
        warnings: Vec::new(),
        assumptions: Vec::new(),
        picture,
    };
    notes::limit(bridge, d, &mut collapse);
    collapse
}

/// A joint counts as a hinge from this share of the largest rotation: where the thrust line runs along an edge for some
/// joints, the solver leaves traces of rotation in those beside the hinge.
const HINGE: f64 = 1e-3;

/// Mechanism, hinges, thrust lines and forces of a limit analysis.
pub fn draw(d: &Discretised, outcome: &limit::Outcome, picture: &mut Picture) {
    if let Some(m) = &outcome.mechanism {
        let motions = m.velocities.iter().map(|&(v, rotation)| Motion { translation: point(v), rotation }).collect();
        picture.mechanism = scaled(motions);
        let largest = m.hinges.iter().map(|h| h.rotation.abs()).fold(0.0, f64::max);
        picture.hinges = m
            .hinges
            .iter()
            .filter(|h| h.rotation.abs() >= HINGE * largest)
            .map(|h| {
                let joint = &outcome.interfaces[h.joint];
                let edge = edge_at(d, joint.first, joint.second, h.at);
                Hinge { point: point(h.at), edge, rotation: h.rotation }
            })
            .collect();
        picture.sliding = m.sliding.iter().map(|&j| point(middle(&outcome.interfaces[j]))).collect();
    }
    let resultants = outcome.interfaces.iter().zip(&outcome.resultants);
    picture.thrust_lines = lines(
        d,
        resultants.filter_map(|(i, r)| {
            let r = (*r)?;
            Some((i.first, i.second, ThrustPoint { point: point(r.at), thrust: r.force.norm() }))
        }),
    );
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
        load: factor * d.reference_load,
        motions: vec![Motion::default(); n],
        velocities: vec![[0.0; 2]; n],
        stresses: picture::stresses(d, &contacts, &loads),
        contacts,
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

/// With a finite strength a joint's thrust fills a block of stress at that strength where it is fully used. The
/// largest stress of a uniform block centred on the resultant: `N / (2 e)` with `e` its distance to the nearer end.
fn largest_stress(d: &Discretised, settings: &limit::Settings, outcome: &limit::Outcome) -> Option<f64> {
    if !settings.crushing {
        return None;
    }
    let stress = |(joint, forces): (&Interface, &limit::JointForces)| {
        let [a, b] = forces.points[..] else { return None };
        let total = a.compression + b.compression;
        let law: &ContactLaw =
            d.model.laws.between(d.model.blocks[joint.first].group, d.model.blocks[joint.second].group);
        let length = (b.at - a.at).norm();
        let nearer = a.compression.min(b.compression) / total * length;
        (total > 0.0).then(|| (total / (2.0 * nearer)).min(law.crushing))
    };
    outcome.interfaces.iter().zip(&outcome.forces).filter_map(stress).reduce(f64::max)
}
