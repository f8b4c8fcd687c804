//! From a bridge to blocks: rings, piers and abutments, what they weigh and carry, and where each block came from.

mod backing;
mod build;
pub mod continuum;
pub mod cover;
mod curve;
mod defects;
pub mod dispersal;
mod displaced;
mod error;
pub mod extrados;
pub mod fill;
pub mod laws;
pub mod mesh;
mod origin;
pub mod pressure;
pub mod ring_mesh;
mod rings;
pub mod springings;
mod supports;
mod voids;
pub mod wall;

use bridge::defect::{Defect, DefectKind, Face};
use bridge::{Bridge, Span};
use build::Build;
use cover::Surface;
use curve::Curve;
use dispersal::{Spread, Strip};
pub use error::DiscretiseError;
use extrados::{Extrados, Stretch};
use fill::FillRegion;
use mechanics::blocks::{BlockModel, Loading, Movement};
use mechanics::dem::Body;
use mechanics::ids::{BlockId, Id, Table};
use mechanics::plane::{Vec2, vec2};
pub use origin::{Faces, Origin};
pub use springings::bridge_length;
use supports::Skewback;

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
}

/// Cuts a bridge into blocks and brings cover and loads onto them: the strip that its plan names, that of the walls where
/// it names both.
pub fn discretise(bridge: &Bridge) -> Result<Discretised, DiscretiseError> {
    let mut build = Build::new(bridge);
    let mut skewbacks = Vec::new();
    let places = springings::springings(bridge);
    let (mut spans, mut lines) = (Vec::new(), Vec::new());
    let mut built = f64::NEG_INFINITY;
    for (i, span) in bridge.spans.iter().enumerate() {
        let curve =
            Curve::new(span, places[i][0]).map_err(|misfit| DiscretiseError::Intrados { span: i + 1, misfit })?;
        skewbacks.push([0.0, 1.0].map(|share| {
            let (intrados, normal) = curve.at(share);
            Skewback { intrados, extrados: intrados + normal * rings::faces(span, span.rings.len() - 1, share)[1] }
        }));
        lines.push(rings::extrados(span, &curve));
        let sound = Span { defects: Vec::new(), ..span.clone() };
        built = built.max(highest(&rings::extrados(&sound, &curve)));
        spans.push(rings::cut(i, span, &curve)?);
    }
    let last = bridge.spans.len();
    build.abutment(0, skewbacks[0][0], -1.0)?;
    for (i, (rings, line)) in spans.into_iter().zip(lines).enumerate() {
        build.span(i, rings);
        build.extrados.line.extend(line);
        if let Some(pier) = bridge.piers.get(i) {
            build.pier(i + 1, pier, skewbacks[i][1], skewbacks[i + 1][0])?;
        }
    }
    build.abutment(last, skewbacks[last - 1][1], 1.0)?;
    build.extrados.lost = (built - highest(&build.extrados.line)).max(0.0);
    displaced::displaced(bridge, build.finish()?)
}

/// Highest level of a line [m].
fn highest(line: &[Vec2]) -> f64 {
    line.iter().map(|p| p.y).fold(f64::NEG_INFINITY, f64::max)
}

/// How a strip on the surface reaches the blocks: through the cover, or as forces on the bricks of a wall.
fn spread(bridge: &Bridge, road: Option<&Extrados>, extrados: &Extrados, surface: &Surface, strip: Strip) -> Spread {
    match (road, &bridge.spandrel_wall) {
        (Some(road), Some(wall)) => wall::loads::on_bricks(strip, wall.loaded_bricks, road, surface),
        _ => dispersal::spread(strip, bridge.dispersal, surface, extrados),
    }
}

impl Discretised {
    /// The load at a load factor [N/m], with the weight of loading blocks.
    pub fn load(&self, factor: f64) -> f64 {
        self.counted_weight + factor * self.reference_load
    }
    /// How a strip on the surface reaches the blocks; for loads that move.
    pub fn spread(&self, bridge: &Bridge, strip: Strip) -> Spread {
        spread(bridge, self.road.as_ref(), &self.extrados, &self.surface, strip)
    }
}

/// The support movement of the plan, on the block that is the support. It turns about the springing's middle for an
/// abutment and about the middle of the foundation's upper face for a pier.
fn movements(
    bridge: &Bridge,
    model: &BlockModel,
    origins: &Table<BlockId, Origin>,
) -> Result<Vec<Movement>, DiscretiseError> {
    let Some(m) = bridge.plan.support_movement else { return Ok(Vec::new()) };
    let last = bridge.spans.len();
    let is_it = |o: &Origin| match *o {
        Origin::Abutment { support } | Origin::Foundation { support } | Origin::AbutmentGround { support } => {
            support == m.support
        }
        _ => false,
    };
    let Some(block) = origins.iter().position(is_it).map(BlockId::new) else {
        return Err(DiscretiseError::NoSuchSupport { support: m.support, last });
    };
    let centre = model.blocks[block].outline.centroid();
    let pivot = match origins[block] {
        Origin::Abutment { support: 0 } => vec2(0.0, 0.0),
        Origin::Abutment { .. } => vec2(bridge_length(bridge), last_springing(bridge).y),
        _ => vec2(centre.x, model.blocks[block].outline.bounds().1.y),
    };
    // The centroid of a block that turns about another point also moves.
    let translation = vec2(m.horizontal, m.vertical) + (centre - pivot).left() * m.rotation;
    Ok(vec![Movement { block, translation, rotation: m.rotation }])
}

/// The line along which a defect of a span lies, from left to right [m]: the face that lost something, the joint that parted, the middle of
/// what is weak. Empty where the span has no curve.
pub fn defect_line(bridge: &Bridge, span: usize, defect: &Defect) -> Vec<Vec2> {
    let described = &bridge.spans[span];
    let Ok(curve) = Curve::new(described, springings::springings(bridge)[span][0]) else { return Vec::new() };
    const STEPS: usize = 48;
    let last = described.rings.len() - 1;
    let point = |step: usize| {
        let share = defect.shares[0] + (defect.shares[1] - defect.shares[0]) * step as f64 / STEPS as f64;
        let (at, normal) = curve.at(share);
        let [lowest, highest] = [rings::faces(described, 0, share)[0], rings::faces(described, last, share)[1]];
        let offset = match defect.kind {
            DefectKind::LostMortar { face: Face::Extrados, .. } | DefectKind::ThinRing { face: Face::Extrados, .. } => {
                highest
            }
            DefectKind::OpenJoint { face, depth } => {
                let (open, closed) = if face == Face::Extrados { (highest, lowest) } else { (lowest, highest) };
                let part = (depth / (highest - lowest)).min(1.0) * step as f64 / STEPS as f64;
                open + (closed - open) * part
            }
            DefectKind::LostMortar { .. }
            | DefectKind::ThinRing { .. }
            | DefectKind::MissingStones
            | DefectKind::DroppedStones { .. } => lowest,
            DefectKind::RingSeparation { ring, .. } => rings::faces(described, ring, share)[1],
            DefectKind::WeakMasonry { ring: Some(ring), .. } => {
                rings::faces(described, ring, share).iter().sum::<f64>() * 0.5
            }
            DefectKind::WeakMasonry { ring: None, .. } => 0.5 * (lowest + highest),
        };
        at + normal * offset
    };
    (0..=STEPS).map(point).collect()
}

/// The right springing of the last span [m].
fn last_springing(bridge: &Bridge) -> Vec2 {
    springings::springings(bridge).last().map_or(Vec2::ZERO, |ends| ends[1])
}

/// Refuses what is hollow under cover that is a body.
fn solid(bridge: &Bridge, what: &'static str) -> Result<(), DiscretiseError> {
    let hollow = if !bridge.cover.voids.is_empty() {
        Some("[[void]]")
    } else {
        bridge.cover.internal_walls.map(|_| "[internal_walls]")
    };
    hollow.map_or(Ok(()), |part| Err(DiscretiseError::Hollow { part, what }))
}

/// The back under the middle of the loads, or the crown of the first span where nothing is loaded.
fn watched(bridge: &Bridge, extrados: &Extrados, spreads: &[Spread], model: &BlockModel) -> (BlockId, Vec2) {
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

#[cfg(test)]
mod road_tests;
#[cfg(test)]
mod spandrel_tests;
#[cfg(test)]
mod springing_tests;
#[cfg(test)]
mod support_tests;
#[cfg(test)]
mod tests;
