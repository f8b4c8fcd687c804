//! Bodies: those that the file lists, and those that its drawing holds on mapped layers.

use super::loads::centroid;
use super::{Said, overlaps};
use bridge::TextRange;
use bridge::blocks::{BlockFile, DrawingPart, MappedLayer, Role};
use findings::words::counted;
use mechanics::plane::{Core, Polygon, vec2};
use std::collections::{BTreeMap, BTreeSet};

/// A block.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Its name: given, or the layer and a number from 1.
    pub name: String,
    /// Its layer.
    pub layer: String,
    /// Place of its material.
    pub material: usize,
    /// Whether it is a support.
    pub held: bool,
    /// Corners, counter-clockwise [m].
    pub outline: Vec<[f64; 2]>,
}

/// A circular particle.
#[derive(Debug, Clone, PartialEq)]
pub struct Particle {
    /// Its layer.
    pub layer: String,
    /// Place of its material, which gives its density.
    pub material: usize,
    /// Centre [m].
    pub centre: [f64; 2],
    /// Radius [m].
    pub radius: f64,
}

/// Every body of the model; what is wrong with them is said. What a refused drawing seems to lack may be what could not
/// be read of it, and is not said.
pub(super) fn bodies(
    file: &BlockFile,
    drawing: Option<&drawing::Drawing>,
    refused: bool,
    said: &mut Said,
) -> (Vec<Body>, Vec<Particle>) {
    let mut bodies = Bodies::default();
    let mut places = Vec::new();
    let mut particles = Vec::new();
    for block in &file.blocks {
        let mut outline = block.outline.clone();
        if centroid(&outline).0 < 0.0 {
            outline.reverse();
        }
        let name = bodies.name(block.name.clone(), &block.layer);
        let body = Body { name, layer: block.layer.clone(), material: block.material, held: block.held, outline };
        bodies.add(file, body, block.range, said);
    }
    for listed in &file.particles {
        let place = |&[x, y, _]: &[f64; 3]| format!("at ({:.4}, {:.4}) m, layer {}", x + 0.0, y + 0.0, listed.layer);
        places.extend(listed.circles.iter().map(|circle| (listed.range, place(circle))));
        particles.extend(listed.circles.iter().map(|&[x, y, radius]| Particle {
            layer: listed.layer.clone(),
            material: listed.material,
            centre: [x, y],
            radius,
        }));
    }
    if let (Some(part), Some(drawing)) = (&file.drawing, drawing) {
        map(part, drawing, refused, said);
        drawn(file, part, drawing, &mut bodies, (&mut particles, &mut places), said);
    }
    let bodies = bodies.list;
    let free = bodies.iter().any(|body| !body.held);
    if !bodies.is_empty() && particles.is_empty() && !free && !refused && said.list.is_empty() {
        let range = file.drawing.as_ref().map_or(TextRange::new(0, 0), |part| part.range);
        let help = "give a layer or a block role = \"block\"".to_owned();
        said.error(
            "D405",
            range,
            "every block is a support: there is nothing to analyse".into(),
            "no free block",
            help,
        );
    }
    overlaps::check(&bodies, &particles, &places, said);
    (bodies, particles)
}

/// The blocks so far, and what they are called.
#[derive(Default)]
struct Bodies {
    list: Vec<Body>,
    names: BTreeSet<String>,
    on_layer: BTreeMap<String, usize>,
}

impl Bodies {
    /// The name that is given, or the layer and a number from 1.
    fn name(&mut self, given: Option<String>, layer: &str) -> String {
        let count = self.on_layer.entry(layer.to_owned()).or_insert(0);
        *count += 1;
        given.unwrap_or_else(|| format!("{layer} {count}"))
    }

    /// Adds a body, or says why the engines cannot take it.
    fn add(&mut self, file: &BlockFile, body: Body, range: TextRange, said: &mut Said) {
        let rounding = file.materials[body.material].masonry.rounding;
        let corners = body.outline.iter().map(|&[x, y]| vec2(x, y)).collect();
        if let Err(reason) = Polygon::new(corners).and_then(|outline| Core::new(&outline, rounding)) {
            let help =
                "corners run once around a convex outline; the rounding of the material must leave some of each edge";
            said.error("D405", range, format!("{}: {reason}", body.name), "cannot be a block", help.into());
        }
        if !self.names.insert(body.name.clone()) {
            let help = "give each block a name of its own, or none".to_owned();
            said.error("D405", range, format!("two blocks are called {}", body.name), "named before", help);
        }
        self.list.push(body);
    }
}

fn same(a: &str, b: &str) -> bool {
    a.to_uppercase() == b.to_uppercase()
}

fn entry<'a>(part: &'a DrawingPart, layer: &str) -> Option<&'a MappedLayer> {
    part.layers.iter().find(|mapped| same(&mapped.name, layer))
}

/// Layers of the drawing without an entry, and entries without a layer.
fn map(part: &DrawingPart, drawing: &drawing::Drawing, refused: bool, said: &mut Said) {
    let mut numbers: BTreeMap<&str, [usize; 2]> = BTreeMap::new();
    drawing.outlines.iter().for_each(|outline| numbers.entry(&outline.layer).or_default()[0] += 1);
    drawing.circles.iter().for_each(|circle| numbers.entry(&circle.layer).or_default()[1] += 1);
    for layer in drawing.layers.iter().filter(|layer| entry(part, layer).is_none()) {
        let [outlines, circles] = numbers.get(layer.as_str()).copied().unwrap_or_default();
        let role = if circles > outlines { "particles" } else { "block" };
        let found = match (outlines, circles) {
            (0, 0) => "what is on it cannot be used as it is".to_owned(),
            _ => format!("{}, {}", counted(outlines, "outline"), counted(circles, "circle")),
        };
        let message = format!("layer {layer} of the drawing has no entry: {found}");
        let help = format!(
            "add [[drawing.layer]] with name = \"{layer}\", role = \"{role}\" (or \"support\", \"ignore\") and material = \"…\""
        );
        said.error("D401", part.range, message, "has a layer that nothing is said about", help);
    }
    for mapped in part.layers.iter().filter(|mapped| mapped.role != Role::Ignore && !refused) {
        if !drawing.layers.iter().any(|layer| same(layer, &mapped.name)) {
            let list = drawing.layers.join(", ");
            let help = format!("the layers with outlines or circles are {list}");
            let message = format!("there is nothing on a layer {}", mapped.name);
            said.error("D402", mapped.range, message, "not in the drawing", help);
        }
    }
    for (k, mapped) in part.layers.iter().enumerate() {
        if part.layers[..k].iter().any(|before| same(&before.name, &mapped.name)) {
            let help = "keep one of the two".to_owned();
            said.error("D405", mapped.range, format!("two entries for layer {}", mapped.name), "named before", help);
        }
    }
}

fn drawn(
    file: &BlockFile,
    part: &DrawingPart,
    drawing: &drawing::Drawing,
    bodies: &mut Bodies,
    (particles, places): (&mut Vec<Particle>, &mut Vec<(TextRange, String)>),
    said: &mut Said,
) {
    let wrong = |mapped: &MappedLayer, what: &str, place: &drawing::Place, said: &mut Said| {
        let message = format!("{what} on layer {} ({place})", mapped.name);
        let help = "move it to another layer of the drawing, or change the role of this one".to_owned();
        said.error("D403", mapped.range, message, "does not fit the role of the layer", help);
    };
    for outline in &drawing.outlines {
        let Some(mapped) = entry(part, &outline.layer) else { continue };
        match (mapped.role, mapped.material) {
            (Role::Block | Role::Support, Some(material)) => {
                let (layer, name) = (outline.layer.clone(), bodies.name(None, &outline.layer));
                let held = mapped.role == Role::Support;
                let body = Body { name, layer, material, held, outline: outline.points.clone() };
                bodies.add(file, body, mapped.range, said);
            }
            (Role::Particles, _) => wrong(mapped, "an outline", &outline.place, said),
            _ => {}
        }
    }
    for circle in &drawing.circles {
        let Some(mapped) = entry(part, &circle.layer) else { continue };
        match (mapped.role, mapped.material) {
            (Role::Particles, Some(material)) => {
                let (centre, radius) = (circle.centre, circle.radius);
                places.push((mapped.range, circle.place.at(centre).to_string()));
                particles.push(Particle { layer: circle.layer.clone(), material, centre, radius });
            }
            (Role::Block | Role::Support, _) => wrong(mapped, "a circle", &circle.place, said),
            _ => {}
        }
    }
}
