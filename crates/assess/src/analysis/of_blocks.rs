//! Collapse of a block model that a file lists or a drawing holds.

use super::engine::{self, rigid, scene};
use super::{AnalysisError, policy};
use mechanics::watch::Watch;
use outcome::collapse::{By, Collapse};
use outcome::note;
use outcome::picture::{ContactForce, Picture, Point, Shape, Snapshot, ThrustPoint};
use outcome::warning;
use std::collections::BTreeMap;
use structure::blocks::Scene;

/// The blocks as they are drawn. Nothing is computed.
pub fn blocks_as_built(scene: &Scene) -> Picture {
    scene::built(scene, "as built")
}

/// Raises the loads of the model until its blocks collapse; bonds of joints that may be lost are not counted. `resume` is a state that
/// [`Watch::keep`] was offered by a run of the same model.
///
/// # Errors
/// No load, no step of it, a method that does not know drawn blocks, or blocks that cannot be analysed.
pub fn collapse_of_blocks(
    scene: &Scene,
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
) -> Result<Collapse, AnalysisError> {
    let states = policy::states_of_blocks(scene);
    let turns = policy::Turns::new(states.len(), resume)?;
    let mut all = Vec::new();
    for turn in states.iter().enumerate() {
        all.push(as_described(&turn.1.bridge, turns.kept(turn.0), &mut turns.watch(turn, watch))?);
        if all.last().is_some_and(Collapse::is_cancelled) {
            break;
        }
    }
    Ok(policy::least_of(&states, &all))
}

/// The same with all that the file says of the blocks.
fn as_described(scene: &Scene, resume: Option<&[u8]>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let d = rigid::loaded(scene.discretised())?;
    let mut found = engine::by(scene.plan.method).drawn(scene, &d, resume, watch)?;
    found.block_names = scene.bodies.iter().map(|body| body.name.clone()).collect();
    found.picture.collapse_load = found.collapse_load;
    let shown = found.picture.last_stable.and_then(|k| found.picture.snapshots.get(k));
    found.picture.thrust_lines = shown.map_or_else(Vec::new, |state| chains(&found.picture.shapes, state));
    notes(scene, &mut found);
    Ok(found)
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
