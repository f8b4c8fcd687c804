//! A bridge as blocks.

use super::cover::Surface;
use super::dispersal::{self, Spread, Strip};
use super::extrados::{Extrados, Stretch};
use super::fill::FillRegion;
use super::origin::{Faces, Origin};
use super::wall;
use bridge::Bridge;
use mechanics::blocks::{BlockModel, Loading};
use mechanics::dem::Body;
use mechanics::ids::{BlockId, Id, Table};
use mechanics::plane::Vec2;

/// A bridge as blocks, with the way back to the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Discretised {
    /// The blocks and their laws.
    pub model: BlockModel,
    /// What acts on them: the cover's weight, and the loads of the file as they stand there.
    pub loading: Loading,
    /// Where each block came from.
    pub origins: Table<BlockId, Origin>,
    /// Faces of the voussoirs.
    pub faces: Table<BlockId, Option<Faces>>,
    /// The line on which cover and loads lie.
    pub extrados: Extrados,
    /// Upper faces of a spandrel wall, from left to right, where the blocks include one.
    pub road: Option<Extrados>,
    /// The region that particles are to fill, where layers are modelled so.
    pub fill: Option<FillRegion>,
    /// The surface on which loads stand: the road, or the top of the wall.
    pub surface: Surface,
    /// Weight of loading blocks [N/m]: counted in every load, though it does not grow.
    pub counted_weight: f64,
    /// Sum of all loads of the file [N/m]: a load factor of one.
    pub reference_load: f64,
    /// How each load reaches the extrados, axle by axle.
    pub spreads: Vec<Spread>,
    /// The block and the point on it whose displacement is followed: the back under the middle of the loads.
    pub watched: (BlockId, Vec2),
}

impl Discretised {
    /// A name for a block or a particle.
    pub fn body_name(&self, body: Body) -> String {
        match body {
            Body::Block(block) => self.origins[block].name(),
            Body::Particle(particle) => format!("particle {}", particle.0 + 1),
        }
    }

    /// The load at a load factor [N/m], with the weight of loading blocks.
    pub fn load(&self, factor: f64) -> f64 {
        self.counted_weight + factor * self.reference_load
    }

    /// How a strip on the surface reaches the blocks; for loads that move.
    pub fn spread(&self, bridge: &Bridge, strip: Strip) -> Spread {
        spread(bridge, self.road.as_ref(), &self.extrados, &self.surface, strip)
    }
}

/// How a strip on the surface reaches the blocks: through the cover, or as forces on the bricks of a wall.
pub(super) fn spread(
    bridge: &Bridge,
    road: Option<&Extrados>,
    extrados: &Extrados,
    surface: &Surface,
    strip: Strip,
) -> Spread {
    match (road, &bridge.spandrel_wall) {
        (Some(road), Some(wall)) => wall::loads::on_bricks(strip, wall.loaded_bricks, road, surface),
        _ => dispersal::spread(strip, bridge.dispersal, surface, extrados),
    }
}

/// The back under the middle of the loads, or the crown of the first span where nothing is loaded.
pub(super) fn watched(bridge: &Bridge, extrados: &Extrados, spreads: &[Spread], model: &BlockModel) -> (BlockId, Vec2) {
    let force: f64 = spreads.iter().map(|s| s.strip.force).sum();
    let x = if force > 0.0 {
        spreads.iter().map(|s| s.strip.force * s.strip.middle).sum::<f64>() / force
    } else {
        0.5 * bridge.spans[0].span
    };
    let free = extrados.stretches.iter().filter(|s| !s.ground);
    let distance = |s: &&Stretch| (0.5 * (s.left.x + s.right.x) - x).abs();
    match free.min_by(|a, b| distance(a).total_cmp(&distance(b))) {
        Some(s) => (s.block, (s.left + s.right) * 0.5),
        None => (BlockId::new(0), model.blocks[BlockId::new(0)].outline.centroid()),
    }
}
