//! Collapse of a block model that a file lists or a drawing holds.

use super::{AnalysisError, by_dem, by_limit, parallel, policy};
use bridge::{Method, Plan};
use mechanics::dem::Body;
use mechanics::ids::{GroupId, Id};
use mechanics::limit;
use mechanics::watch::Watch;
use outcome::collapse::{By, FlowRule, LimitReport};
use outcome::collapse::{Collapse, Status};
use outcome::note;
use outcome::picture::{ContactForce, Disc, LoadArrow, Picture, Point, Shape, Snapshot, ThrustPoint};
use outcome::warning::{self, Warning};
use std::collections::BTreeMap;
use structure::blocks::Scene;
use structure::discretise::{Discretised, laws};

/// The blocks as they are drawn. Nothing is computed.
pub fn blocks_as_built(scene: &Scene) -> Picture {
    built(scene, "as built")
}

/// Raises the loads of the model until its blocks collapse; bonds of joints that may be lost are not counted. `resume` is a state that
/// [`Watch::keep`] was offered by a run of the same model.
pub fn collapse_of_blocks(
    scene: &Scene,
    resume: Option<&[u64]>,
    watch: &mut dyn Watch,
) -> Result<Collapse, AnalysisError> {
    policy::of_blocks(scene, resume, watch, &as_described)
}

/// The same with all that the file says of the blocks.
fn as_described(scene: &Scene, resume: Option<&[u64]>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let d = scene.discretised();
    if d.loading.variable.is_empty() {
        return Err(AnalysisError::NoLoad);
    }
    let mut found = match scene.plan.method {
        Method::Dem => dem(scene, &d, resume, watch),
        Method::Limit => limit(scene, &d, watch),
        Method::Path => Err(AnalysisError::NotByPath("blocks of a drawing")),
        Method::Fe => Err(AnalysisError::NotByFiniteElements("blocks of a drawing")),
    }?;
    found.block_names = scene.bodies.iter().map(|body| body.name.clone()).collect();
    found.picture.collapse_load = found.collapse_load;
    let shown = found.picture.last_stable.and_then(|k| found.picture.snapshots.get(k));
    found.picture.thrust_lines = shown.map_or_else(Vec::new, |state| chains(&found.picture.shapes, state));
    notes(scene, &mut found);
    Ok(found)
}

fn dem(
    scene: &Scene,
    d: &Discretised,
    resume: Option<&[u64]>,
    watch: &mut dyn Watch,
) -> Result<Collapse, AnalysisError> {
    require_stiffness(scene)?;
    let filled = !d.model.particles.is_empty();
    let rigid = match filled {
        true => None,
        false => Some(limit::collapse_load(&d.model, &d.loading, &by_limit::settings_of(&scene.plan, false))?),
    };
    let bound = rigid.as_ref().and_then(|rigid| rigid.factor.or(rigid.associated_factor));
    let mut chosen = Vec::new();
    let (program, step) = by_dem::program(&planned(scene, filled)?, d, bound, &mut chosen)?;
    let settings = mechanics::dem::Settings { scaled_inertia: filled, ..by_dem::settings_of(&scene.plan) };
    let outcome = mechanics::dem::collapse(&d.model, &d.loading, &program, &settings, resume, watch)?;
    let mut picture = built(scene, "discrete elements");
    by_dem::draw(d, &outcome, &|factor| d.load(factor), &mut picture);
    let (status, broken) = by_dem::status(&outcome);
    let broken = broken.map(|(body, step)| (named(scene, body), step));
    let report = by_dem::numbers(&scene.plan, &outcome, broken);
    let mut c = blank(scene, d, By::Dem(Some(report)), status, picture);
    c.max_compressive_stress = Some(outcome.max_compressive_stress);
    let at_rest = outcome.last_stable_frame.and_then(|k| outcome.frames.get(k));
    c.contacts = at_rest.map_or(0, |frame| frame.contacts.len() + frame.particle_contacts.len());
    by_dem::loads(&outcome, &|factor| d.load(factor), &mut c);
    c.load_step = Some(step);
    c.limit_load = rigid.as_ref().and_then(|rigid| rigid.factor).map(|f| d.load(f));
    c.tolerance = scene.plan.tolerance;
    c.warnings.extend(chosen.into_iter().map(Warning::from));
    super::notes::discrete_elements(&scene.plan, &mut c);
    if let Some(rigid) = rigid {
        super::notes::apart(rigid.status, &mut c);
        if crushes(scene) {
            let crushed = limit::collapse_load(&d.model, &d.loading, &by_limit::settings_of(&scene.plan, true))?;
            c.crushing_limit_load = crushed.factor.map(|f| d.load(f));
            super::notes::crushed(&mut c);
        }
    }
    Ok(c)
}

/// Whether a material has a strength at which joints crush.
fn crushes(scene: &Scene) -> bool {
    scene.materials.iter().any(|material| material.masonry.compressive_strength.is_some())
}

/// Load steps tried where the file gives no limit for a model with particles.
const MOST_STEPS: f64 = 100.0;

/// The plan; with particles, limit analysis cannot choose what it leaves open.
fn planned(scene: &Scene, filled: bool) -> Result<Plan, AnalysisError> {
    let plan = scene.plan.clone();
    if !filled {
        return Ok(plan);
    }
    let step = plan.load_step.ok_or(AnalysisError::Missing {
        what: "load_step",
        why: "limit analysis, from which it would be chosen, knows no particles",
    })?;
    Ok(Plan { load_limit: plan.load_limit.or(Some(MOST_STEPS * step)), ..plan })
}

/// The name of a block; particles are counted from 1.
fn named(scene: &Scene, body: Body) -> String {
    match body {
        Body::Block(block) => scene.bodies[block.index()].name.clone(),
        Body::Particle(particle) => format!("particle {}", particle.index() + 1),
    }
}

/// Refuses pairs of materials in use whose joint has no stiffness.
fn require_stiffness(scene: &Scene) -> Result<(), AnalysisError> {
    let used = |k: usize| {
        scene.bodies.iter().any(|body| body.material == k) || scene.particles.iter().any(|p| p.material == k)
    };
    let materials: Vec<usize> = (0..scene.materials.len()).filter(|&k| used(k)).collect();
    let stiff = |a: usize, b: usize| laws::has_stiffness(scene.laws.between(GroupId(a as u32), GroupId(b as u32)));
    match materials.iter().all(|&a| materials.iter().all(|&b| stiff(a, b))) {
        true => Ok(()),
        false => Err(AnalysisError::NoStiffness { joint: "joints between the materials of the blocks" }),
    }
}

fn limit(scene: &Scene, d: &Discretised, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let crushing = crushes(scene);
    let settings = by_limit::settings_of(&scene.plan, crushing);
    let mut solve = |settings: &limit::Settings| {
        parallel::alone("limit analysis", false, watch, |token| {
            limit::collapse_load_while(&d.model, &d.loading, settings, token)
        })
    };
    let outcome = solve(&settings)?;
    let unlimited = match crushing {
        true => solve(&by_limit::settings_of(&scene.plan, false))?.factor,
        false => outcome.factor,
    };
    let mut picture = built(scene, "limit analysis");
    by_limit::draw(d, &outcome, &mut picture);
    let mut c = blank(scene, d, By::Limit(LimitReport::default()), by_limit::status(outcome.status), picture);
    by_limit::loads(d, &outcome, unlimited, &mut c);
    c.assumptions.push(note::Blocks::Rigid.into());
    c.warnings.extend(outcome.jammed.then(|| warning::Joints::Jammed.into()));
    if c.limit().is_some_and(|report| report.friction == FlowRule::Associated) && !c.sliding_joints.is_empty() {
        c.warnings.push(warning::Joints::Sliding { joints: c.sliding_joints.len() }.into());
    }
    Ok(c)
}

/// What a reader of any of these results must know.
fn notes(scene: &Scene, c: &mut Collapse) {
    let unlimited = scene.materials.iter().filter(|material| material.masonry.compressive_strength.is_none());
    let materials: Vec<String> = unlimited.map(|material| material.name.clone()).collect();
    if !materials.is_empty() {
        c.warnings.push(warning::Joints::UnlimitedOf { materials }.into());
    }
    let rounding = scene.materials.iter().map(|material| material.masonry.rounding).fold(0.0, f64::max);
    if rounding > 0.0 {
        c.warnings.push(warning::Joints::InsetBlocks { rounding }.into());
    }
    if let (Some(stable), Some(limit), By::Dem(_)) = (c.last_stable_load, c.limit_load, &c.by)
        && stable > limit
    {
        c.warnings.push(warning::Loads::AboveLimitOfBlocks { stable, limit }.into());
    }
    c.assumptions.push(note::Blocks::LoadsOnBlocks.into());
    c.assumptions.push(note::Barrel::Plane.into());
}

/// A result with nothing found yet.
fn blank(scene: &Scene, d: &Discretised, by: By, status: Status, picture: Picture) -> Collapse {
    let name = scene.name.clone();
    Collapse { bridge: name, width: scene.width, status, ..super::template::of_blocks(&scene.plan, d, by, picture) }
}

fn built(scene: &Scene, title: &str) -> Picture {
    let shape = |body: &structure::blocks::Body| Shape {
        outline: body.outline.clone(),
        role: "block".to_owned(),
        held: body.held,
    };
    let variable = scene.forces.iter().filter(|force| !force.permanent);
    Picture {
        title: format!("{}: {title}", scene.name),
        shapes: scene.bodies.iter().map(shape).collect(),
        particles: discs(scene),
        loads: variable.map(|force| LoadArrow { at: force.at, force: force.force }).collect(),
        ..Picture::default()
    }
}

/// The particles, their layers in the order in which they are met.
fn discs(scene: &Scene) -> Vec<Disc> {
    let mut layers: Vec<&str> = Vec::new();
    let mut discs = Vec::with_capacity(scene.particles.len());
    for particle in &scene.particles {
        let known = layers.iter().position(|layer| *layer == particle.layer);
        let layer = known.unwrap_or(layers.len());
        if known.is_none() {
            layers.push(&particle.layer);
        }
        discs.push(Disc { centre: particle.centre, radius: particle.radius, layer });
    }
    discs
}

/// Lines of thrust through blocks that stand in a row: each has two joints that carry. Where more meet, a line ends.
fn chains(shapes: &[Shape], state: &Snapshot) -> Vec<Vec<ThrustPoint>> {
    let joints = joints(&state.contacts);
    let mut of_block: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (k, (blocks, _)) in joints.iter().enumerate() {
        for &block in blocks {
            of_block.entry(block).or_default().push(k);
        }
    }
    let passes = |block: usize| !shapes[block].held && of_block[&block].len() == 2;
    let mut used = vec![false; joints.len()];
    let mut lines = Vec::new();
    let mut walk = |first: usize, from: usize, used: &mut Vec<bool>| {
        let (mut joint, mut from, mut line) = (first, from, vec![joints[first].1]);
        used[joint] = true;
        loop {
            let [a, b] = joints[joint].0;
            let to = if a == from { b } else { a };
            if !passes(to) {
                break;
            }
            let Some(&next) = of_block[&to].iter().find(|&&k| !used[k]) else { break };
            used[next] = true;
            line.push(joints[next].1);
            (joint, from) = (next, to);
        }
        if line.len() > 1 {
            lines.push(line);
        }
    };
    // From the ends of rows first; what is left goes round in a circle.
    for k in 0..joints.len() {
        let end = joints[k].0.into_iter().find(|&block| !passes(block));
        if let (false, Some(end)) = (used[k], end) {
            walk(k, end, &mut used);
        }
    }
    lines
}

/// The resultant of each pair of blocks: where it crosses their joint, and its size.
fn joints(contacts: &[ContactForce]) -> Vec<([usize; 2], ThrustPoint)> {
    let mut pairs: BTreeMap<[usize; 2], (f64, Point, Point)> = BTreeMap::new();
    for c in contacts.iter().filter(|c| c.compression > 0.0) {
        let (total, moment, force) = pairs.entry(c.blocks).or_default();
        *total += c.compression;
        for k in 0..2 {
            let tangent = [-c.normal[1], c.normal[0]];
            moment[k] += c.compression * c.point[k];
            force[k] += c.compression * c.normal[k] + c.shear * tangent[k];
        }
    }
    let resultant = |(blocks, (total, moment, force)): ([usize; 2], (f64, Point, Point))| {
        (blocks, ThrustPoint { point: moment.map(|m| m / total), thrust: force[0].hypot(force[1]) })
    };
    pairs.into_iter().map(resultant).collect()
}

#[cfg(test)]
#[path = "of_blocks_tests.rs"]
mod tests;
