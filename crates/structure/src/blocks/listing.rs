//! A block model as lists for somebody who checks it with other means: blocks, joints, loads, as tables and for other programs.

use super::{Force, Scene};
use mechanics::blocks::{ModelError, interfaces};
use mechanics::ids::{BlockId, GroupId, Id};
use mechanics::plane::Vec2;

/// Blocks share a joint where their gap is at most this [m]: round-off of the outlines.
const TOUCHING: f64 = 1e-6;

/// A block model as lists.
#[derive(Debug, Clone, PartialEq)]
pub struct Listing<'a> {
    /// Its blocks.
    pub blocks: Vec<ListedBlock<'a>>,
    /// Its joints.
    pub joints: Vec<ListedJoint>,
    /// What acts on the blocks beside their own weight, in the order of the file.
    pub loads: &'a [Force],
}

/// A block.
#[derive(Debug, Clone, PartialEq)]
pub struct ListedBlock<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its layer or part.
    pub layer: &'a str,
    /// Its material.
    pub material: &'a str,
    /// Whether it is a support.
    pub held: bool,
    /// Corners, counter-clockwise [m].
    pub corners: &'a [[f64; 2]],
    /// Area [m^2].
    pub area: f64,
    /// Centre of mass [m].
    pub centroid: [f64; 2],
    /// Density [kg/m^3].
    pub density: f64,
    /// Weight per metre of width, downwards [N/m].
    pub weight: f64,
}

/// A joint of two blocks.
#[derive(Debug, Clone, PartialEq)]
pub struct ListedJoint {
    /// Places of the two blocks in the list.
    pub blocks: [usize; 2],
    /// Its ends [m], one where the blocks touch in a point: inset from the edges by the rounding of corners.
    pub ends: Vec<[f64; 2]>,
    /// Unit normal from the first to the second block.
    pub normal: [f64; 2],
    /// Coefficient of friction.
    pub friction: f64,
    /// Cohesion [Pa].
    pub cohesion: f64,
    /// Tensile strength [Pa].
    pub tension: f64,
    /// How far the centres of its free blocks lie from it along the normal, together [m]: what gives where blocks are elastic.
    pub depth: f64,
}

impl ListedJoint {
    /// Length [m]; zero of one that is a point.
    pub fn length(&self) -> f64 {
        let (a, b) = (self.ends[0], self.ends[self.ends.len() - 1]);
        (b[0] - a[0]).hypot(b[1] - a[1])
    }

    /// Its middle [m].
    pub fn middle(&self) -> [f64; 2] {
        let (a, b) = (self.ends[0], self.ends[self.ends.len() - 1]);
        [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
    }
}

/// Lists a model.
///
/// # Errors
/// A block whose rounding leaves nothing of an edge.
pub fn listing(scene: &Scene) -> Result<Listing<'_>, ModelError> {
    let model = scene.discretised().model;
    let centroids = model.centroids();
    let point = |v: Vec2| [v.x, v.y];
    let blocks =
        scene.bodies.iter().zip(model.blocks.iter()).zip(centroids.iter()).map(|((body, block), &centroid)| {
            let material = &scene.materials[body.material];
            ListedBlock {
                name: &body.name,
                layer: &body.layer,
                material: &material.name,
                held: body.held,
                corners: &body.outline,
                area: block.outline.area(),
                centroid: point(centroid),
                density: block.density,
                weight: block.mass() * scene.gravity,
            }
        });
    let joints = interfaces(&model, TOUCHING)?.into_iter().filter(|joint| !joint.points.is_empty()).map(|joint| {
        let sides: [BlockId; 2] = [joint.first, joint.second];
        let group = |side: usize| GroupId::new(scene.bodies[sides[side].index()].material);
        let law = scene.laws.between(group(0), group(1));
        let away = |id: &BlockId| (joint.points[0] - centroids[*id]).dot(joint.normal).abs();
        let free = sides.iter().filter(|id| !scene.bodies[id.index()].held);
        ListedJoint {
            blocks: sides.map(Id::index),
            ends: joint.points.iter().map(|&at| point(at)).collect(),
            normal: point(joint.normal),
            friction: law.friction,
            cohesion: law.cohesion,
            tension: law.tension,
            depth: free.map(away).sum(),
        }
    });
    Ok(Listing { blocks: blocks.collect(), joints: joints.collect(), loads: &scene.forces })
}

impl Listing<'_> {
    /// Weight of the free blocks and of what lies on them, downwards, per metre of width [N/m].
    pub fn dead_load(&self) -> f64 {
        let blocks = self.blocks.iter().filter(|block| !block.held).map(|block| block.weight);
        let permanent = self.loads.iter().filter(|load| load.permanent && !self.blocks[load.body].held);
        blocks.chain(permanent.map(|load| -load.force[1])).sum()
    }

    /// Four tables, each with the ending of its name: blocks, their corners, joints, loads. Lengths in metres, forces in kN per metre of width.
    pub fn tables(&self) -> [(&'static str, Vec<u8>); 4] {
        let number = |value: f64| format!("{value}");
        let held = |held: bool| if held { "yes" } else { "no" }.to_owned();
        let name = |k: usize| self.blocks[k].name.to_owned();
        let blocks = self.blocks.iter().map(|b| {
            let numbers = [b.area, b.centroid[0], b.centroid[1], b.density, 1e-3 * b.weight].map(number);
            let words = [b.name, b.layer, b.material].map(str::to_owned).into_iter().chain([held(b.held)]);
            words.chain(numbers).collect()
        });
        let corners = self.blocks.iter().flat_map(|b| {
            let corner =
                |(k, p): (usize, &[f64; 2])| vec![b.name.to_owned(), format!("{}", k + 1), number(p[0]), number(p[1])];
            b.corners.iter().enumerate().map(corner).collect::<Vec<_>>()
        });
        let joints = self.joints.iter().map(|j| {
            let (a, b) = (j.ends[0], j.ends[j.ends.len() - 1]);
            let place = [a[0], a[1], b[0], b[1], j.length(), j.normal[0], j.normal[1]];
            let law = [j.friction.atan().to_degrees(), 1e-3 * j.cohesion, 1e-3 * j.tension];
            let names = j.blocks.map(name).into_iter();
            names.chain(place.map(number)).chain(law.map(number)).collect()
        });
        let loads = self.loads.iter().map(|load| {
            let kind = if load.permanent { "permanent" } else { "variable" };
            let numbers =
                [load.at[0], load.at[1], 1e-3 * load.force[0], -1e-3 * load.force[1]].map(|value| number(value + 0.0));
            [load.name.clone(), kind.to_owned(), name(load.body)].into_iter().chain(numbers).collect()
        });
        [
            (
                "blocks",
                table(
                    "block,layer,material,support,area_m2,centroid_x_m,centroid_y_m,density_kg_per_m3,weight_kn_per_m",
                    blocks,
                ),
            ),
            ("corners", table("block,corner,x_m,y_m", corners)),
            (
                "joints",
                table(
                    "first,second,x1_m,y1_m,x2_m,y2_m,length_m,normal_x,normal_y,friction_angle_deg,cohesion_kpa,tensile_strength_kpa",
                    joints,
                ),
            ),
            ("loads", table("load,kind,block,x_m,y_m,right_kn_per_m,down_kn_per_m", loads)),
        ]
    }
}

/// A table with its heading.
fn table(heading: &str, rows: impl Iterator<Item = Vec<String>>) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Writing into memory does not fail.
    let mut put = |row: Vec<String>| writer.write_record(row).unwrap_or_default();
    put(heading.split(',').map(str::to_owned).collect());
    rows.for_each(put);
    writer.into_inner().unwrap_or_default()
}
