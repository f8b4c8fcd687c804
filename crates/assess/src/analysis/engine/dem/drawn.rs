//! Blocks of a file or a drawing by discrete elements.

use super::filled::planned;
use super::{draw, ended, loads, numbers, settings_of};
use crate::analysis::engine::steps::{bound, program};
use crate::analysis::engine::{rigid, scene};
use crate::analysis::{AnalysisError, notes};
use mechanics::dem;
use mechanics::ids::GroupId;
use mechanics::limit;
use mechanics::watch::Watch;
use outcome::collapse::{By, Collapse};
use outcome::warning::Warning;
use structure::blocks::Scene;
use structure::discretise::{Discretised, laws};

/// Raises the loads in steps until the blocks collapse.
pub(super) fn until_they_fall(
    scene: &Scene,
    d: &Discretised,
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
) -> Result<Collapse, AnalysisError> {
    require_stiffness(scene)?;
    let filled = !d.model.particles.is_empty();
    let rigid = match filled {
        true => None,
        false => Some(limit::collapse_load(&d.model, &d.loading, &rigid::settings_of(&scene.plan, false))?),
    };
    let bound = rigid.as_ref().and_then(|rigid| bound(rigid, d));
    let mut chosen = Vec::new();
    let plan = if filled { planned(&scene.plan)? } else { scene.plan.clone() };
    let (program, step) = program(&plan, d, bound, &mut chosen)?;
    let settings = dem::Settings { scaled_inertia: filled, ..settings_of(&scene.plan) };
    let outcome = dem::collapse(&d.model, &d.loading, &program, &settings, resume, watch)?;
    let mut picture = scene::built(scene, "discrete elements");
    draw(d, &outcome, &|factor| d.load(factor), &mut picture);
    let (status, broken) = ended(outcome.status);
    let broken = broken.map(|(body, step)| (scene::named(scene, body), step));
    let report = numbers(&scene.plan, &outcome, broken);
    let mut c = scene::blank(scene, d, By::Dem(Some(report)), status, picture);
    c.max_compressive_stress = Some(outcome.max_compressive_stress);
    let at_rest = outcome.last_stable_frame.and_then(|k| outcome.frames.get(k));
    c.contacts = at_rest.map_or(0, |frame| frame.contacts.len() + frame.particle_contacts.len());
    loads(&outcome, d, &mut c);
    c.load_step = Some(step);
    c.limit_load = rigid.as_ref().and_then(|rigid| rigid.factor).map(|f| d.load(f));
    c.tolerance = scene.plan.tolerance;
    c.warnings.extend(chosen.into_iter().map(Warning::from));
    notes::discrete_elements(&scene.plan, &mut c);
    if let Some(rigid) = rigid {
        notes::apart(rigid.status, &mut c);
        if scene::crushes(scene) {
            let crushed = limit::collapse_load(&d.model, &d.loading, &rigid::settings_of(&scene.plan, true))?;
            c.crushing_limit_load = crushed.factor.map(|f| d.load(f));
            notes::crushed(&mut c);
        }
    }
    Ok(c)
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
