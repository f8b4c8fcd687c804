//! A block model file and its drawing become bodies, laws and forces: the same [`Discretised`] that a bridge becomes.

mod bodies;
mod laws;
mod listing;
mod loads;
mod opensees;
mod overlaps;
mod write;

pub use bodies::{Body, Particle};
pub use listing::{ListedBlock, ListedJoint, Listing, listing};
pub use opensees::opensees;
pub use write::{of_bridge, skeleton, toml};

use crate::discretise::cover::Surface;
use crate::discretise::extrados::Extrados;
use crate::discretise::{Discretised, Origin};
use bridge::blocks::{BlockFile, Material};
use bridge::{Diagnostic, Plan, Severity, TextRange};
use mechanics::blocks::{Block, BlockModel, Held, LawTable, Loading, PointForce};
use mechanics::ids::{BlockId, GroupId, Id, Table};
use mechanics::plane::{Polygon, vec2};

/// A block model, ready for analyses, drawings and conversions.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Name for titles.
    pub name: String,
    /// Width over which forces for the whole of it are spread [m].
    pub width: f64,
    /// Acceleration of gravity [m/s^2].
    pub gravity: f64,
    /// Blocks: those listed, then those drawn.
    pub bodies: Vec<Body>,
    /// Particles, likewise.
    pub particles: Vec<Particle>,
    /// Materials, whose places are the groups of the model.
    pub materials: Vec<Material>,
    /// Laws of all pairs of materials.
    pub laws: LawTable,
    /// Forces on the blocks, in the order of the file.
    pub forces: Vec<Force>,
    /// What to analyse, and how exactly.
    pub plan: Plan,
}

/// A force on a block.
#[derive(Debug, Clone, PartialEq)]
pub struct Force {
    /// Name of its load.
    pub name: String,
    /// Place of the block among the bodies.
    pub body: usize,
    /// Where it acts [m].
    pub at: [f64; 2],
    /// Force per metre of width [N/m].
    pub force: [f64; 2],
    /// Whether it is there from the start, and does not grow.
    pub permanent: bool,
}

/// What putting a block model together gives.
#[derive(Debug, Clone)]
pub struct Assembled {
    /// The model, unless something is wrong.
    pub scene: Option<Scene>,
    /// What is wrong with the file, in the light of its drawing.
    pub diagnostics: Vec<Diagnostic>,
    /// What was found in the drawing.
    pub findings: Vec<drawing::Finding>,
}

/// How the drawing of a block model file is to be read.
pub fn options(file: &BlockFile) -> drawing::Options {
    let Some(part) = &file.drawing else { return drawing::Options::default() };
    let ignored = part.layers.iter().filter(|layer| layer.role == bridge::blocks::Role::Ignore);
    drawing::Options {
        unit: part.unit,
        chord_tolerance: part.chord_tolerance,
        gap_tolerance: part.gap_tolerance,
        concave: if part.cut_concave { drawing::Concave::Cut } else { drawing::Concave::Refuse },
        ignored: ignored.map(|layer| layer.name.clone()).collect(),
    }
}

/// Puts the model together from its file and the bytes of its drawing, where it has one.
pub fn assemble(file: &BlockFile, dxf: Option<&[u8]>) -> Assembled {
    let read = dxf.map(|bytes| drawing::read(bytes, &options(file)));
    let mut said = Said::default();
    let refused = read.as_ref().is_some_and(|read| !read.is_usable());
    let (bodies, particles) = bodies::bodies(file, read.as_ref().map(|read| &read.drawing), refused, &mut said);
    let findings = read.map_or_else(Vec::new, |read| read.findings);
    let laws = laws::laws(file, &bodies, &particles, &mut said);
    // A load would miss the very block that could not be read.
    let forces = if refused || !said.list.is_empty() { Vec::new() } else { loads::forces(file, &bodies, &mut said) };
    let usable = !refused && said.list.is_empty();
    let scene = usable.then(|| Scene {
        name: file.name.clone(),
        width: file.width,
        gravity: file.gravity,
        bodies,
        particles,
        materials: file.materials.clone(),
        laws,
        forces,
        plan: file.plan.clone(),
    });
    Assembled { scene, diagnostics: said.list, findings }
}

/// Collects what is wrong with the file: errors alone.
#[derive(Debug, Default)]
struct Said {
    list: Vec<Diagnostic>,
}

impl Said {
    fn error(&mut self, code: &'static str, range: TextRange, message: String, label: &str, help: String) {
        let (severity, label, help) = (Severity::Error, label.into(), Some(help));
        self.list.push(Diagnostic { code, severity, message, range, label, note: None, help });
    }
}

impl Scene {
    /// The same model as blocks, laws and forces; bodies were checked when they were put together.
    pub fn discretised(&self) -> Discretised {
        let blocks: Table<BlockId, Block> = self.bodies.iter().map(|body| self.block(body)).collect();
        let force = |f: &Force| PointForce {
            block: BlockId::new(f.body),
            at: vec2(f.at[0], f.at[1]),
            force: vec2(f.force[0], f.force[1]),
        };
        let of = |permanent: bool| self.forces.iter().filter(move |f| f.permanent == permanent);
        let size = |f: &Force| f.force[0].hypot(f.force[1]);
        // From zero on, for an empty sum is minus zero.
        let reference_load = of(false).fold(0.0, |sum, f| sum + size(f));
        let largest = of(false).max_by(|a, b| size(a).total_cmp(&size(b)));
        let free = || self.bodies.iter().position(|body| !body.held).unwrap_or(0);
        let watched = match largest {
            Some(f) => (BlockId::new(f.body), vec2(f.at[0], f.at[1])),
            None => (BlockId::new(free()), blocks[BlockId::new(free())].outline.centroid()),
        };
        Discretised {
            loading: Loading {
                permanent: of(true).map(force).collect(),
                variable: of(false).map(force).collect(),
                ..Loading::default()
            },
            origins: (0..blocks.len()).map(|number| Origin::Block { number }).collect(),
            faces: (0..blocks.len()).map(|_| None).collect(),
            model: BlockModel {
                blocks,
                particles: self.particles.iter().map(|particle| self.grain(particle)).collect(),
                groups: self.materials.iter().map(|material| material.name.clone()).collect(),
                laws: self.laws.clone(),
                gravity: vec2(0.0, -self.gravity),
            },
            extrados: Extrados::default(),
            road: None,
            fill: None,
            surface: Surface::level(0.0),
            counted_weight: 0.0,
            reference_load,
            spreads: Vec::new(),
            watched,
        }
    }

    fn grain(&self, particle: &Particle) -> mechanics::blocks::Particle {
        mechanics::blocks::Particle {
            centre: vec2(particle.centre[0], particle.centre[1]),
            radius: particle.radius,
            density: self.materials[particle.material].masonry.density,
            group: GroupId::new(particle.material),
        }
    }

    fn block(&self, body: &Body) -> Block {
        let masonry = &self.materials[body.material].masonry;
        let corners = body.outline.iter().map(|&[x, y]| vec2(x, y)).collect();
        Block {
            outline: Polygon::new(corners).expect("bodies were checked when they were put together"),
            rounding: masonry.rounding,
            density: masonry.density,
            group: GroupId::new(body.material),
            held: if body.held { Held::FIXED } else { Held::FREE },
        }
    }
}
