//! Blocks of a file or a drawing: pictures and results with nothing found yet.

use crate::analysis::template;
use mechanics::dem::Body;
use mechanics::ids::Id;
use outcome::collapse::{By, Collapse, Status};
use outcome::picture::{Disc, LoadArrow, Picture, Shape};
use structure::blocks::Scene;
use structure::discretise::Discretised;

/// Whether a material has a strength at which joints crush.
pub(crate) fn crushes(scene: &Scene) -> bool {
    scene.materials.iter().any(|material| material.masonry.compressive_strength.is_some())
}

/// The name of a block; particles are counted from 1.
pub(crate) fn named(scene: &Scene, body: Body) -> String {
    match body {
        Body::Block(block) => scene.bodies[block.index()].name.clone(),
        Body::Particle(particle) => format!("particle {}", particle.index() + 1),
    }
}

/// A result with nothing found yet.
pub(crate) fn blank(scene: &Scene, d: &Discretised, by: By, status: Status, picture: Picture) -> Collapse {
    let name = scene.name.clone();
    Collapse { bridge: name, width: scene.width, status, ..template::of_blocks(&scene.plan, d, by, picture) }
}

/// The blocks as they are drawn, under a title.
pub(crate) fn built(scene: &Scene, title: &str) -> Picture {
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
