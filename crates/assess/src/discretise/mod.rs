//! From a bridge to blocks: rings, piers and abutments, what they weigh and carry, and where each block came from.

pub mod cover;
mod curve;
pub mod dispersal;
pub mod extrados;
pub mod laws;
mod rings;
mod supports;

use bridge::Bridge;
use bridge::ring::Misfit;
use curve::Curve;
use dispersal::Spread;
use extrados::{Extrados, Stretch};
use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, Movement};
use mechanics::ids::{BlockId, GroupId, Id, Table};
use mechanics::plane::{Polygon, PolygonError, Vec2, vec2};
use supports::Skewback;
use thiserror::Error;

/// Where a block came from. Spans, rings and supports count from 0, supports from the left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// A voussoir, counted from the left springing.
    Voussoir {
        /// Span.
        span: usize,
        /// Ring, from the intrados up.
        ring: usize,
        /// Voussoir.
        voussoir: usize,
    },
    /// The fixed block behind a springing.
    Abutment {
        /// Support: 0 or the last.
        support: usize,
    },
    /// The fixed block below a pier.
    Foundation {
        /// Support.
        support: usize,
    },
    /// A course of a pier.
    Pier {
        /// Support.
        support: usize,
        /// Course, from the foundation up.
        course: usize,
    },
    /// A block of a model that is no bridge, counted from 0.
    Block {
        /// Its place among the blocks.
        number: usize,
    },
}

impl Origin {
    /// The word for drawings.
    pub fn role(self) -> &'static str {
        match self {
            Origin::Voussoir { .. } => "voussoir",
            Origin::Abutment { .. } | Origin::Foundation { .. } => "abutment",
            Origin::Pier { .. } => "pier",
            Origin::Block { .. } => "block",
        }
    }
    /// A name for tables and messages, counted from 1.
    pub fn name(self) -> String {
        match self {
            Origin::Voussoir { span, ring, voussoir } => {
                format!("span {} ring {} voussoir {}", span + 1, ring + 1, voussoir + 1)
            }
            Origin::Abutment { support: 0 } => "left abutment".into(),
            Origin::Abutment { .. } => "right abutment".into(),
            Origin::Foundation { support } => format!("foundation of pier {support}"),
            Origin::Pier { support, course } => format!("pier {support} course {}", course + 1),
            Origin::Block { number } => format!("block {}", number + 1),
        }
    }
}

/// The lower and upper face of a voussoir, each from left to right [m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Faces {
    /// Towards the intrados.
    pub bed: [Vec2; 2],
    /// Towards the extrados.
    pub back: [Vec2; 2],
}

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
    /// Level of the road surface [m].
    pub surface: f64,
    /// Sum of all loads of the file [N/m]: a load factor of one.
    pub reference_load: f64,
    /// How each load reaches the extrados, axle by axle.
    pub spreads: Vec<Spread>,
    /// The block and the point on it whose displacement is followed: the back under the middle of the loads.
    pub watched: (BlockId, Vec2),
}

/// Why a bridge cannot be cut into blocks.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum DiscretiseError {
    /// A voussoir has no usable outline.
    #[error("voussoir {voussoir} of ring {ring} in span {span} has no usable outline: {source}")]
    Voussoir {
        /// Span, from 1.
        span: usize,
        /// Ring, from 1.
        ring: usize,
        /// Voussoir, from 1.
        voussoir: usize,
        /// What is wrong.
        source: PolygonError,
    },
    /// An abutment or pier has no usable outline.
    #[error("support {support} (0 is the left abutment) has no usable outline: {source}")]
    Support {
        /// Support, from the left, 0 the left abutment.
        support: usize,
        /// What is wrong.
        source: PolygonError,
    },
    /// The rings of neighbouring spans cross above their pier.
    #[error("the rings on both sides of pier {support} cross by {overlap:.3} m: its width of {width} m is too small")]
    RingsCross {
        /// Support.
        support: usize,
        /// By how much [m].
        overlap: f64,
        /// Width of the pier [m].
        width: f64,
    },
    /// The intrados of a span cannot be drawn.
    #[error("the intrados of span {span} has no curve: {misfit:?}")]
    Intrados {
        /// Span, from 1.
        span: usize,
        /// Why.
        misfit: Misfit,
    },
    /// The file moves a support that does not exist.
    #[error("support {support} does not exist: the last is {last}")]
    NoSuchSupport {
        /// Support named.
        support: usize,
        /// The right abutment.
        last: usize,
    },
}

/// Cuts a bridge into blocks and brings cover and loads onto them.
pub fn discretise(bridge: &Bridge) -> Result<Discretised, DiscretiseError> {
    let mut build = Build::new(bridge);
    let mut x = 0.0;
    let mut skewbacks = Vec::new();
    let (mut spans, mut lines) = (Vec::new(), Vec::new());
    for (i, span) in bridge.spans.iter().enumerate() {
        let curve =
            Curve::new(span, vec2(x, 0.0)).map_err(|misfit| DiscretiseError::Intrados { span: i + 1, misfit })?;
        let total: f64 = span.rings.iter().map(|r| r.springing_thickness).sum();
        skewbacks.push([0.0, 1.0].map(|share| {
            let (intrados, normal) = curve.at(share);
            Skewback { intrados, extrados: intrados + normal * total }
        }));
        lines.push(rings::extrados(span, &curve));
        spans.push(rings::cut(i, span, &curve)?);
        x += span.span + bridge.piers.get(i).map_or(0.0, |p| p.width);
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
    build.finish()
}

struct Build<'a> {
    bridge: &'a Bridge,
    blocks: Table<BlockId, Block>,
    groups: Table<GroupId, String>,
    /// Groups whose mutual contacts are joints between rings: span and ring.
    rings: Vec<(GroupId, usize, usize)>,
    origins: Table<BlockId, Origin>,
    faces: Table<BlockId, Option<Faces>>,
    extrados: Extrados,
}

impl<'a> Build<'a> {
    fn new(bridge: &'a Bridge) -> Build<'a> {
        Build {
            bridge,
            blocks: Table::default(),
            groups: Table::default(),
            rings: Vec::new(),
            origins: Table::default(),
            faces: Table::default(),
            extrados: Extrados::default(),
        }
    }

    fn block(&mut self, outline: Polygon, group: GroupId, held: Held, origin: Origin, faces: Option<Faces>) -> BlockId {
        self.origins.push(origin);
        self.faces.push(faces);
        let Bridge { masonry, .. } = self.bridge;
        self.blocks.push(Block { outline, rounding: masonry.rounding, density: masonry.density, group, held })
    }

    fn stretch(&mut self, block: BlockId, [left, right]: [Vec2; 2], ground: bool) {
        if right.x > left.x {
            self.extrados.stretches.push(Stretch { block, left, right, ground });
        }
    }

    fn abutment(&mut self, support: usize, skewback: Skewback, side: f64) -> Result<(), DiscretiseError> {
        let described = &self.bridge.abutments[usize::from(side > 0.0)];
        let (outline, top) = supports::abutment(support, described, skewback, side)?;
        let group = self.groups.push(Origin::Abutment { support }.name());
        let block = self.block(outline, group, Held::FIXED, Origin::Abutment { support }, None);
        self.stretch(block, top, true);
        self.extrados.line.extend(top);
        Ok(())
    }

    fn span(&mut self, span: usize, rings: Vec<Vec<rings::Cut>>) {
        let uppermost = rings.len() - 1;
        for (ring, cuts) in rings.into_iter().enumerate() {
            let group = self.groups.push(format!("span {} ring {}", span + 1, ring + 1));
            self.rings.push((group, span, ring));
            for (voussoir, cut) in cuts.into_iter().enumerate() {
                let faces = Faces { bed: cut.bed, back: cut.back };
                let origin = Origin::Voussoir { span, ring, voussoir };
                let block = self.block(cut.outline, group, Held::FREE, origin, Some(faces));
                if ring == uppermost {
                    self.stretch(block, cut.back, false);
                }
            }
        }
    }

    fn pier(
        &mut self,
        support: usize,
        pier: &bridge::Pier,
        left: Skewback,
        right: Skewback,
    ) -> Result<(), DiscretiseError> {
        let cut = supports::pier(support, pier, left, right)?;
        let group = self.groups.push(format!("pier {support}"));
        self.block(cut.foundation, group, Held::FIXED, Origin::Foundation { support }, None);
        let courses = cut.courses.len();
        for (course, outline) in cut.courses.into_iter().enumerate() {
            let block = self.block(outline, group, Held::FREE, Origin::Pier { support, course }, None);
            if course + 1 == courses {
                self.stretch(block, cut.top, false);
            }
        }
        Ok(())
    }

    fn finish(self) -> Result<Discretised, DiscretiseError> {
        let bridge = self.bridge;
        let model = BlockModel {
            laws: self.laws(),
            blocks: self.blocks,
            groups: self.groups,
            gravity: vec2(0.0, -bridge.gravity),
        };
        let extrados = self.extrados;
        let surface = cover::surface(bridge, &extrados);
        let spreads: Vec<Spread> = bridge
            .loads
            .iter()
            .flat_map(|load| dispersal::strips(&load.kind, load.position))
            .map(|strip| dispersal::spread(strip, bridge.dispersal, surface, &extrados))
            .collect();
        // From zero on, for an empty sum is minus zero.
        let reference_load = spreads.iter().fold(0.0, |sum, s| sum + s.strip.force);
        let loading = Loading {
            permanent: cover::weight(bridge, &extrados),
            variable: spreads.iter().flat_map(|s| s.forces.iter().copied()).collect(),
            movements: movements(bridge, &model, &self.origins)?,
        };
        let watched = watched(bridge, &extrados, &spreads, &model);
        Ok(Discretised {
            model,
            loading,
            origins: self.origins,
            faces: self.faces,
            extrados,
            surface,
            reference_load,
            spreads,
            watched,
        })
    }

    fn laws(&self) -> LawTable {
        let joint: ContactLaw = laws::law(self.bridge, &self.bridge.joint);
        let between_rings = laws::law(self.bridge, &self.bridge.ring_joint);
        let mut laws = LawTable::uniform(self.groups.len(), joint);
        for &(a, span_a, ring_a) in &self.rings {
            for &(b, span_b, ring_b) in &self.rings {
                if span_a == span_b && ring_a != ring_b {
                    laws.set(a, b, between_rings);
                }
            }
        }
        laws
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
        Origin::Abutment { support } | Origin::Foundation { support } => support == m.support,
        _ => false,
    };
    let Some(block) = origins.iter().position(is_it).map(BlockId::new) else {
        return Err(DiscretiseError::NoSuchSupport { support: m.support, last });
    };
    let centre = model.blocks[block].outline.centroid();
    let pivot = match origins[block] {
        Origin::Abutment { support: 0 } => vec2(0.0, 0.0),
        Origin::Abutment { .. } => vec2(bridge_length(bridge), 0.0),
        _ => vec2(centre.x, model.blocks[block].outline.bounds().1.y),
    };
    // The centroid of a block that turns about another point also moves.
    let translation = vec2(m.horizontal, m.vertical) + (centre - pivot).left() * m.rotation;
    Ok(vec![Movement { block, translation, rotation: m.rotation }])
}

/// Distance between the outer springings, at the intrados [m].
pub fn bridge_length(bridge: &Bridge) -> f64 {
    bridge.spans.iter().map(|s| s.span).sum::<f64>() + bridge.piers.iter().map(|p| p.width).sum::<f64>()
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
mod tests;
