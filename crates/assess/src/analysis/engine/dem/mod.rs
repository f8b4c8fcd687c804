//! Discrete elements: blocks, and particles where the fill is made of them, in motion.

mod drawn;
pub mod filled;
mod movement;
mod thickness;

use crate::analysis::engine::joints::{contact_length, require_stiffness};
use crate::analysis::engine::rings::{MovedSupport, RingThickness};
use crate::analysis::engine::steps::{bound, program};
use crate::analysis::engine::{Engine, rigid};
use crate::analysis::geometry::{moving_as_built, point, scaled, thrust_lines};
use crate::analysis::{AnalysisError, notes, template};
use bridge::{Bridge, Damping, JointContact, Method, Plan};
use mechanics::dem::{self, Body};
use mechanics::ids::Id;
use mechanics::limit;
use mechanics::plane::vec2;
use mechanics::watch::{Unwatched, Watch};
use outcome::collapse::By;
use outcome::collapse::{Collapse, DemReport, Status};
use outcome::picture::{ContactForce, DiscState, Motion, ParticleForce, Partner, Picture, Snapshot, Step};
use outcome::warning::Warning;
use structure::blocks::Scene;
use structure::discretise::{Discretised, Origin, discretise, fill};

/// Discrete elements.
pub struct Dem;

impl Engine for Dem {
    fn method(&self) -> Method {
        Method::Dem
    }

    fn joints(&self, bridge: &Bridge) -> Result<(), AnalysisError> {
        require_stiffness(bridge)
    }

    fn ready(&self, bridge: &Bridge) -> Result<(), AnalysisError> {
        self.joints(bridge)?;
        match fill::wanted(bridge) {
            Some(particles) => filled::ready(bridge, particles),
            None => rigid::loaded(discretise(bridge)?).map(|_| ()),
        }
    }

    fn load(&self, bridge: &Bridge, resume: Option<&[u8]>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
        match fill::wanted(bridge) {
            Some(particles) => filled::collapse_filled(bridge, particles, resume, watch),
            None => until_it_falls(bridge, resume, watch),
        }
    }

    fn thickness(&self, rings: &RingThickness<'_>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
        thickness::least(rings, watch)
    }

    fn support_movement(
        &self,
        moves: &MovedSupport<'_>,
        resume: Option<&[u8]>,
        watch: &mut dyn Watch,
    ) -> Result<Collapse, AnalysisError> {
        movement::until_it_falls(moves, resume, watch)
    }

    fn drawn(
        &self,
        scene: &Scene,
        d: &Discretised,
        resume: Option<&[u8]>,
        watch: &mut dyn Watch,
    ) -> Result<Collapse, AnalysisError> {
        drawn::until_they_fall(scene, d, resume, watch)
    }
}

/// How the plan wants the method done.
pub fn settings(bridge: &Bridge) -> dem::Settings {
    dem::Settings { scaled_inertia: bridge.particles.is_some(), ..settings_of(&bridge.plan) }
}

/// The same for any plan, for a model without particles.
pub(super) fn settings_of(plan: &Plan) -> dem::Settings {
    dem::Settings {
        damping: match plan.damping {
            Damping::Local(share) => dem::Damping::Local(share),
            Damping::Viscous(share) => dem::Damping::Viscous(share),
            Damping::Adaptive => dem::Damping::Adaptive,
        },
        contact_length: contact_length(plan, JointContact::Points),
        tolerance: plan.tolerance,
        step_limit: plan.step_limit,
        time_step_factor: plan.time_step_factor,
        scaled_inertia: false,
    }
}

/// The blocks of a bridge and a run of them in the hands of the caller: what [`Dem`] computes, some steps at a time.
/// `Discretised::load` turns its factor into a load, and the blocks of its frames are those of `Discretised::model`. The bridge has nothing that may
/// come and go.
///
/// # Errors
/// Joints without stiffness, no load, or an analysis that cannot be set up.
pub fn stepping(bridge: &Bridge) -> Result<(Discretised, dem::Stepping), AnalysisError> {
    let (d, rigid) = increased(bridge, &mut Unwatched)?;
    let (program, _) = program(&bridge.plan, &d, bound(&rigid, &d), &mut Vec::new())?;
    let run = dem::Stepping::new(&d.model, &d.loading, &program, &settings(bridge))?;
    Ok((d, run))
}

/// The blocks with the loads that are increased, and limit analysis of the same blocks.
pub(super) fn increased(
    bridge: &Bridge,
    watch: &mut dyn Watch,
) -> Result<(Discretised, limit::Outcome), AnalysisError> {
    require_stiffness(bridge)?;
    let mut d = rigid::loaded(discretise(bridge)?)?;
    d.loading.movements.clear();
    let rigid = rigid::uncrushed(bridge, &d, watch)?;
    Ok((d, rigid))
}

/// Raises the loads of the file in steps until the blocks collapse.
fn until_it_falls(bridge: &Bridge, resume: Option<&[u8]>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let (d, rigid) = increased(bridge, watch)?;
    if rigid.status == limit::Status::Cancelled {
        return Ok(rigid::cancelled(bridge, &d, By::Dem(None)));
    }
    let limit_load = rigid.factor;
    let mut chosen = Vec::new();
    let (program, load_step) = program(&bridge.plan, &d, bound(&rigid, &d), &mut chosen)?;
    let outcome = dem::collapse(&d.model, &d.loading, &program, &settings(bridge), resume, watch)?;
    let load = |factor: f64| d.load(factor);
    let mut c = report(bridge, &d, &outcome, "discrete elements", &load);
    loads(&outcome, &d, &mut c);
    c.load_step = Some(load_step);
    c.limit_load = limit_load.map(load);
    c.warnings.extend(chosen.into_iter().map(Warning::from));
    notes::dem(bridge, &d, &mut c);
    notes::apart(rigid.status, &mut c);
    if rigid::settings(bridge).crushing {
        let crushed = rigid::watched(&d, &rigid::single(bridge, &d), watch)?.factor;
        c.crushing_limit_load = crushed.map(load);
        notes::crushed(&mut c);
    }
    Ok(c)
}

/// The last load at rest, and the first that collapsed: a step that did neither is no collapse load.
pub fn loads(outcome: &dem::Outcome, d: &Discretised, c: &mut Collapse) {
    c.last_stable_load = outcome.last_stable_factor.map(|factor| d.load(factor));
    let next = outcome.collapse_factor.map(|factor| d.load(factor));
    match outcome.status {
        dem::Status::Stalled => c.stalled_load = next,
        _ => c.collapse_load = next,
    }
}

/// How a run ended, for an engineer, and where it broke off.
pub fn ended(status: dem::Status) -> (Status, Option<(Body, u64)>) {
    match status {
        dem::Status::Collapsed => (Status::Collapsed, None),
        dem::Status::StableToLastLoad => (Status::StableToLastLoad, None),
        dem::Status::Stalled => (Status::Stalled, None),
        dem::Status::UnstableUnderSelfWeight => (Status::UnstableUnderSelfWeight, None),
        dem::Status::StepLimit => (Status::StepLimit, None),
        dem::Status::Cancelled => (Status::Cancelled, None),
        dem::Status::Broken { body, step } => (Status::NotConverged, Some((body, step))),
    }
}

fn damping(d: Damping) -> String {
    match d {
        Damping::Local(share) => format!("local, {share}"),
        Damping::Viscous(share) => format!("viscous, {share} of critical"),
        Damping::Adaptive => "adaptive viscous".into(),
    }
}

/// Everything that does not depend on what was increased. `load` turns the load factor into a load (or a movement).
pub fn report(
    bridge: &Bridge,
    d: &Discretised,
    outcome: &dem::Outcome,
    title: &str,
    load: &dyn Fn(f64) -> f64,
) -> Collapse {
    let (status, broken) = ended(outcome.status);
    let at_rest = outcome.last_stable_frame.and_then(|k| outcome.frames.get(k));
    let report = numbers(&bridge.plan, outcome, broken.map(|(body, step)| (d.body_name(body), step)));
    let mut c = template::of_bridge(bridge, d, By::Dem(Some(report)), title);
    draw(d, outcome, load, &mut c.picture);
    c.status = status;
    c.max_compressive_stress = Some(outcome.max_compressive_stress);
    c.contacts = at_rest.map_or(0, |f| f.contacts.len());
    c
}

/// Iterations, time steps and settings of a run, and where it broke off.
pub(super) fn numbers(plan: &Plan, outcome: &dem::Outcome, broken_at: Option<(String, u64)>) -> DemReport {
    let e = &outcome.energy;
    let work = [e.gravity, e.loads, e.supports].iter().map(|w| w.abs()).sum::<f64>();
    DemReport {
        iterations_total: outcome.iterations_total,
        time_step: outcome.time_step,
        critical_time_step: outcome.critical_time_step,
        single_mass_time_step: outcome.single_mass_time_step,
        damping: damping(plan.damping),
        contact_length: plan.contact_length,
        energy_drift: if work > 0.0 { e.drift().abs() / work } else { 0.0 },
        broken_at,
    }
}

/// Motion of each block between two frames.
fn motions(from: Option<&dem::Frame>, to: &dem::Frame, d: &Discretised) -> Vec<Motion> {
    d.model
        .blocks
        .pairs()
        .map(|(id, block)| {
            let now = to.poses[id];
            let (start, turned) = match from.map(|f| f.poses[id]) {
                Some(p) => (p.position, p.rotation.turn_back(vec2(now.rotation.cos, now.rotation.sin))),
                None => (block.outline.centroid(), vec2(now.rotation.cos, now.rotation.sin)),
            };
            Motion { translation: point(now.position - start), rotation: turned.y.atan2(turned.x) }
        })
        .collect()
}

/// A collapse is drawn and its hinges are read once some block of masonry has moved this far from rest [m]: far beyond the elastic
/// sag of a step, well before the joints of an arch jump out of place. A loading block that sinks into fill says nothing of the arch.
const CLEARLY_MOVING: f64 = 0.02;

pub(super) fn draw(d: &Discretised, outcome: &dem::Outcome, load: &dyn Fn(f64) -> f64, picture: &mut Picture) {
    picture.stalls = outcome.status == dem::Status::Stalled;
    picture.path = outcome
        .path
        .iter()
        .map(|p| Step {
            load: load(p.factor),
            displacement: point(p.displacement),
            iterations: p.iterations,
            unbalanced_ratio: p.unbalanced_ratio,
            at_rest: p.at_rest,
        })
        .collect();
    picture.last_stable = outcome.last_stable_frame;
    picture.snapshots = outcome.frames.iter().map(|f| snapshot(d, f, load)).collect();
    let at_rest = outcome.last_stable_frame.and_then(|k| outcome.frames.get(k));
    if let Some(state) = outcome.last_stable_frame.and_then(|k| picture.snapshots.get(k)) {
        picture.thrust_lines = thrust_lines(d, &state.contacts);
    }
    let falling = outcome.last_stable_frame.map_or(0, |k| k + 1);
    let moved = |all: &[Motion]| {
        let masonry = all
            .iter()
            .zip(d.origins.iter())
            .filter(|(_, origin)| !matches!(origin, Origin::LoadingBlock { .. } | Origin::Slab { .. }));
        masonry.map(|(m, _)| m.translation[0].hypot(m.translation[1])).fold(0.0, f64::max)
    };
    let falls: Vec<Vec<Motion>> = outcome.frames.iter().skip(falling).map(|f| motions(at_rest, f, d)).collect();
    let clear = falls.iter().find(|all| moved(all) >= CLEARLY_MOVING).or(falls.last());
    let collapsed =
        matches!(outcome.status, dem::Status::Collapsed | dem::Status::UnstableUnderSelfWeight | dem::Status::Stalled);
    if let (true, Some(clear)) = (collapsed, clear) {
        picture.mechanism = scaled(clear.clone());
    }
    moving_as_built(d, picture);
}

fn snapshot(d: &Discretised, frame: &dem::Frame, load: &dyn Fn(f64) -> f64) -> Snapshot {
    Snapshot {
        load: load(frame.factor),
        motions: motions(None, frame, d),
        velocities: frame.velocities.iter().map(|&(v, _)| point(v)).collect(),
        contacts: frame
            .contacts
            .iter()
            .map(|c| ContactForce {
                blocks: [c.first.index(), c.second.index()],
                point: point(c.point),
                normal: point(c.normal),
                compression: c.compression,
                shear: c.shear,
                stress: c.compression / c.length,
                sliding: c.sliding,
            })
            .collect(),
        stresses: frame.stresses.iter().copied().collect(),
        particles: frame.particles.iter().map(disc_state).collect(),
        particle_forces: frame.particle_contacts.iter().map(particle_force).collect(),
    }
}

fn disc_state(p: &dem::ParticleState) -> DiscState {
    DiscState { centre: point(p.centre), angle: p.angle, velocity: point(p.velocity), stress: p.stress }
}

fn particle_force(c: &dem::ParticleContact) -> ParticleForce {
    ParticleForce {
        particle: c.particle.index(),
        partner: match c.partner {
            Body::Block(block) => Partner::Shape(block.index()),
            Body::Particle(other) => Partner::Particle(other.index()),
        },
        point: point(c.point),
        normal: point(c.normal),
        compression: c.compression,
        shear: c.shear,
        stress: c.compression / c.length,
        sliding: c.sliding,
    }
}
