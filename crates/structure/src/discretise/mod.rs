//! From a bridge to blocks: rings, piers and abutments, what they weigh and carry, and where each block came from.

mod backing;
pub mod continuum;
pub mod cover;
mod curve;
mod defects;
pub mod dispersal;
mod displaced;
pub mod extrados;
pub mod fill;
pub mod laws;
pub mod mesh;
pub mod pressure;
pub mod ring_mesh;
mod rings;
pub mod springings;
mod supports;
mod voids;
pub mod wall;

use bridge::defect::{Defect, DefectKind, Face};
use bridge::ring::Misfit;
use bridge::{Bridge, Span, SpandrelWall, Strip as Width};
use cover::Surface;
use curve::Curve;
use dispersal::{Spread, Strip};
use extrados::{Extrados, Stretch};
use fill::FillRegion;
pub use springings::bridge_length;

use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, Movement};
use mechanics::dem::Body;
use mechanics::ids::{BlockId, GroupId, Id, Table};
use mechanics::plane::{Polygon, PolygonError, Vec2, vec2};
use supports::Skewback;
use thiserror::Error;
use wall::{Seat, WallError};

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
    /// The ground under an abutment that can move.
    AbutmentGround {
        /// Support: 0 or the last.
        support: usize,
    },
    /// A course of an abutment that can move.
    AbutmentCourse {
        /// Support: 0 or the last.
        support: usize,
        /// Course, from the ground up.
        course: usize,
    },
    /// A block of a model that is no bridge, counted from 0.
    Block {
        /// Its place among the blocks.
        number: usize,
    },
    /// A brick of a spandrel wall, or a piece of one that was cut.
    Brick {
        /// Course, from the top; none for the stones of steep haunches.
        course: Option<usize>,
        /// Counted through all courses, from the left.
        brick: usize,
    },
    /// A stone of the backing, or a column of it on the back of a voussoir.
    Backing {
        /// Counted from the left.
        column: usize,
    },
    /// A slab of a layer that lies on particles.
    Slab {
        /// Layer, from the extrados up.
        layer: usize,
        /// Counted from the left.
        slab: usize,
    },
    /// The fixed wall at an end of the spandrel wall.
    EndWall {
        /// Whether it is the right one.
        right: bool,
    },
    /// A block that brings a load onto the surface.
    LoadingBlock {
        /// The load, in the order of the file.
        load: usize,
    },
}

impl Origin {
    /// The word for drawings.
    pub fn role(self) -> &'static str {
        match self {
            Origin::Voussoir { .. } => "voussoir",
            Origin::Abutment { .. } | Origin::Foundation { .. } | Origin::AbutmentGround { .. } => "abutment",
            Origin::Pier { .. } | Origin::AbutmentCourse { .. } => "pier",
            Origin::Brick { .. } | Origin::EndWall { .. } => "wall",
            Origin::Block { .. } | Origin::LoadingBlock { .. } | Origin::Slab { .. } => "block",
            Origin::Backing { .. } => "backing",
        }
    }
    /// Whether it is part of the arches and what they stand on, and not of what stands on them.
    pub fn is_arch(self) -> bool {
        matches!(
            self,
            Origin::Voussoir { .. }
                | Origin::Abutment { .. }
                | Origin::Foundation { .. }
                | Origin::Pier { .. }
                | Origin::AbutmentGround { .. }
                | Origin::AbutmentCourse { .. }
        )
    }
    /// A name for tables and messages, counted from 1.
    pub fn name(self) -> String {
        let side = |support: usize| if support == 0 { "left" } else { "right" };
        match self {
            Origin::Voussoir { span, ring, voussoir } => {
                format!("span {} ring {} voussoir {}", span + 1, ring + 1, voussoir + 1)
            }
            Origin::Abutment { support: 0 } => "left abutment".into(),
            Origin::Abutment { .. } => "right abutment".into(),
            Origin::Foundation { support } => format!("foundation of pier {support}"),
            Origin::Pier { support, course } => format!("pier {support} course {}", course + 1),
            Origin::AbutmentGround { support } => format!("ground under the {} abutment", side(support)),
            Origin::AbutmentCourse { support, course } => format!("{} abutment course {}", side(support), course + 1),
            Origin::Block { number } => format!("block {}", number + 1),
            Origin::Brick { course: Some(course), brick } => format!("wall course {} brick {}", course + 1, brick + 1),
            Origin::Brick { course: None, brick } => format!("wall haunch stone {}", brick + 1),
            Origin::EndWall { right: false } => "left end wall".into(),
            Origin::EndWall { right: true } => "right end wall".into(),
            Origin::Backing { column } => format!("backing column {}", column + 1),
            Origin::Slab { layer, slab } => format!("layer {} slab {}", layer + 1, slab + 1),
            Origin::LoadingBlock { load } => format!("block of load {}", load + 1),
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

/// Why a bridge cannot be cut into blocks.
#[derive(Debug, Clone, PartialEq, Error)]
#[expect(missing_docs, reason = "the messages say what each is")]
pub enum DiscretiseError {
    #[error("voussoir {voussoir} of ring {ring} in span {span} has no usable outline: {source}")]
    Voussoir { span: usize, ring: usize, voussoir: usize, source: PolygonError },
    #[error("support {support} (0 is the left abutment) has no usable outline: {source}")]
    Support {
        /// Support, from the left, 0 the left abutment.
        support: usize,
        source: PolygonError,
    },
    #[error("the rings on both sides of pier {support} cross by {overlap:.3} m: its width of {width} m is too small")]
    RingsCross {
        support: usize,
        /// By how much [m].
        overlap: f64,
        /// Width of the pier [m].
        width: f64,
    },
    /// The intrados of a span cannot be drawn.
    #[error("the intrados of span {span} has no curve: {misfit}")]
    Intrados {
        /// Span, from 1.
        span: usize,
        /// Why.
        misfit: Misfit,
    },
    /// The spandrel wall cannot be cut into bricks.
    #[error(transparent)]
    Wall(#[from] WallError),
    #[error("backing cannot be laid as blocks on these haunches: {0}; write as = \"weight\" in [backing]")]
    Backing(WallError),
    #[error("the bridge has no spandrel wall: describe it with [spandrel_wall], or analyse strip = \"fill\"")]
    NoWall,
    #[error(
        "load {load} stands on cover that is weight alone and cannot carry its block: write through = \"cover\", or analyse \
         strip = \"wall\""
    )]
    BlockOnCover { load: usize },
    #[error(
        "layer {layer} of the cover is weight alone, and weight cannot act on particles: write as = \"particles\" or as = \
         \"nothing\" for it"
    )]
    WeightOnParticles { layer: usize },
    #[error("[backing] is weight alone and cannot carry particles: leave it out, or model no layer as particles")]
    BackingUnderParticles,
    #[error("load {load} would act on particles: write through = \"block\" and the block's weight")]
    LoadOnParticles { load: usize },
    #[error(
        "layer {layer} of the cover cannot lie on the one below it: from the extrados up come particles, then blocks, then \
         what is weight alone or nothing"
    )]
    LayerOrder { layer: usize },
    #[error("there is no region between the extrados and the road that particles could fill")]
    NoRegion,
    #[error(
        "the continuum is {depth:.3} m thick over the crown and loads would stand on the ring: give its layers a greater thickness"
    )]
    ContinuumWithoutDepth {
        /// Thickness over the crown [m].
        depth: f64,
    },
    #[error(
        "a load at {x:.3} m is {length:.3} m long: a point load on a continuum is carried by nothing; give contact_length, or the \
         length of the load"
    )]
    PointLoadOnContinuum {
        /// Its middle [m].
        x: f64,
        /// Its length along the bridge [m].
        length: f64,
    },
    #[error(
        "the support has moved before the loads came, and only single rings without walls, particles or a continuum are brought into their \
         new shape: leave out `before` of [support_movement], and describe the shape that was surveyed with profile = \"measured\""
    )]
    MovedShape,
    #[error(
        "the bridge falls before its support has moved by {before:.4} m: it stands up to {stands:.4} m; check `before` of \
         [support_movement], the thickness of the ring and what lies above it"
    )]
    FellBefore {
        /// Movement of the file [m].
        before: f64,
        /// Largest movement at which it stands [m].
        stands: f64,
    },
    #[error("a load acts along the bridge, and {what} knows vertical loads only: leave out `horizontal` and `braking`")]
    Horizontal {
        /// What knows vertical loads only.
        what: &'static str,
    },
    #[error(
        "the road is not level, and {what} knows none but a level one: leave out [road] and give the lowest layer its least thickness, or \
         write as = \"weight\""
    )]
    RoadNotLevel {
        /// What asks for a level road.
        what: &'static str,
    },
    #[error(
        "the road is not level, and a spandrel wall has courses up to one level: give its `top` in [spandrel_wall]"
    )]
    WallUnderRoad,
    #[error(
        "the springings are not level, and {what} reaches up to one level: write as = \"weight\" in [backing], whose level then follows the \
         springings"
    )]
    SpringingsNotLevel {
        /// What asks for level springings.
        what: &'static str,
    },
    #[error(
        "{part} takes the place of cover that is weight, and {what} is a body: model the cover as weight, or leave {part} out and give the \
         layers mean densities"
    )]
    Hollow {
        /// What is hollow.
        part: &'static str,
        /// How the cover is modelled.
        what: &'static str,
    },
    #[error(
        "an abutment of blocks can move, and {what} bears on ground that cannot: write as = \"fixed\" in [abutment], or model the cover as \
         weight"
    )]
    MovableAbutment {
        /// How the cover is modelled.
        what: &'static str,
    },
    #[error(
        "void {void} reaches into the ring: at x = {x:.3} m the extrados lies {above:.3} m above its roof; give a higher `roof`, or end it \
         before that place"
    )]
    VoidInRing {
        /// Void, from 1, from the left.
        void: usize,
        /// Where [m].
        x: f64,
        /// By how much [m].
        above: f64,
    },
    #[error(
        "the roof of void {void} lies above the lowest layer of the cover, whose top is at {top:.3} m there: give a lower `roof`"
    )]
    VoidAboveFill {
        /// Void, from 1, from the left.
        void: usize,
        /// Level of the layer's top [m].
        top: f64,
    },
    #[error(
        "the roof of void {void} is carried to x = {x:.3} m, where nothing of the bridge stands: give places between the ends of the \
         abutments in `carried_to`"
    )]
    VoidBesideBridge {
        /// Void, from 1, from the left.
        void: usize,
        /// Where [m].
        x: f64,
    },
    #[error("support {support} does not exist: the last is {last}")]
    NoSuchSupport {
        /// Support named.
        support: usize,
        /// The right abutment.
        last: usize,
    },
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

/// Voussoirs of a ring that are in the same state.
struct RingGroup {
    group: GroupId,
    span: usize,
    ring: usize,
    state: defects::State,
}

struct Build<'a> {
    bridge: &'a Bridge,
    blocks: Table<BlockId, Block>,
    groups: Table<GroupId, String>,
    /// Groups of voussoirs.
    rings: Vec<RingGroup>,
    origins: Table<BlockId, Origin>,
    faces: Table<BlockId, Option<Faces>>,
    extrados: Extrados,
    seats: Vec<Seat>,
    /// Groups of bricks, end walls and loading blocks: all their contacts follow the law of the wall's joints.
    walls: Vec<GroupId>,
    /// Groups whose joints have a share of the strength: they fill a share of the width.
    shares: Vec<(GroupId, f64)>,
    /// Groups of ground under abutments that can move, with the friction on it.
    grounds: Vec<(GroupId, f64)>,
    /// Backs of abutments that can move: where soil presses.
    pressed: Vec<supports::Back>,
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
            seats: Vec::new(),
            walls: Vec::new(),
            shares: Vec::new(),
            grounds: Vec::new(),
            pressed: Vec::new(),
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
        if let Some(body) = &described.body {
            return self.movable_abutment(support, described, body, skewback, side);
        }
        let (outline, top) = supports::abutment(support, described, skewback, side)?;
        let group = self.groups.push(Origin::Abutment { support }.name());
        let block = self.block(outline, group, Held::FIXED, Origin::Abutment { support }, None);
        self.stretch(block, top, true);
        self.seats.push(Seat { left: top[0], right: top[1], span: None });
        self.extrados.line.extend(top);
        Ok(())
    }

    fn span(&mut self, span: usize, rings: Vec<Vec<rings::Cut>>) {
        let uppermost = rings.len() - 1;
        for (ring, cuts) in rings.into_iter().enumerate() {
            let mut groups: Vec<RingGroup> = Vec::new();
            for (voussoir, cut) in cuts.into_iter().enumerate() {
                let state = defects::State::of(&self.bridge.spans[span], ring, voussoir);
                if state.is_missing {
                    continue;
                }
                let known = groups.iter().find(|known| known.state == state).map(|known| known.group);
                let group = known.unwrap_or_else(|| {
                    let name = format!("span {} ring {}{}", span + 1, ring + 1, state.name());
                    let group = self.groups.push(name);
                    groups.push(RingGroup { group, span, ring, state });
                    group
                });
                let faces = Faces { bed: cut.bed, back: cut.back };
                let origin = Origin::Voussoir { span, ring, voussoir };
                let block = self.block(cut.outline, group, Held::FREE, origin, Some(faces));
                if ring == uppermost {
                    self.stretch(block, cut.back, false);
                    self.seats.push(Seat { left: cut.back[0], right: cut.back[1], span: Some(span) });
                }
            }
            self.rings.extend(groups);
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
        let mut group = self.groups.push(format!("pier {support}"));
        self.block(cut.foundation, group, Held::FIXED, Origin::Foundation { support }, None);
        let courses = cut.courses.len();
        for (course, supports::Course { outline, across }) in cut.courses.into_iter().enumerate() {
            let ratios = across.map(|ends| ends.map(|width| width / self.bridge.width));
            if ratios.is_some() {
                group = self.groups.push(format!("pier {support} course {}", course + 1));
            }
            let block = self.block(outline, group, Held::FREE, Origin::Pier { support, course }, None);
            if let Some([low, high]) = ratios {
                self.blocks[block].density *= 0.5 * (low + high);
                if low.min(high) < 1.0 {
                    self.shares.push((group, low.min(high)));
                }
            }
            if course + 1 == courses {
                self.stretch(block, cut.top, false);
            }
        }
        if cut.top[1].x > cut.top[0].x {
            self.seats.push(Seat { left: cut.top[0], right: cut.top[1], span: None });
        }
        Ok(())
    }

    /// An abutment of blocks on the ground.
    fn movable_abutment(
        &mut self,
        support: usize,
        described: &bridge::Abutment,
        body: &bridge::AbutmentBody,
        skewback: Skewback,
        side: f64,
    ) -> Result<(), DiscretiseError> {
        let cut = supports::movable(support, described, body, skewback, side)?;
        let ground = self.groups.push(Origin::AbutmentGround { support }.name());
        self.grounds.push((ground, body.ground_friction_angle.tan()));
        self.block(cut.ground, ground, Held::FIXED, Origin::AbutmentGround { support }, None);
        let group = self.groups.push(format!("{} abutment", if support == 0 { "left" } else { "right" }));
        let courses = cut.courses.len();
        for (course, (outline, back)) in cut.courses.into_iter().enumerate() {
            let block = self.block(outline, group, Held::FREE, Origin::AbutmentCourse { support, course }, None);
            self.pressed.push(supports::Back {
                block,
                ends: back,
                inwards: -side,
                top: cut.top[usize::from(side > 0.0)],
            });
            if course + 1 == courses {
                self.stretch(block, cut.top, false);
            }
        }
        self.seats.push(Seat { left: cut.top[0], right: cut.top[1], span: None });
        self.extrados.line.extend(cut.top);
        Ok(())
    }

    /// Bricks on the extrados and the fixed walls at their ends; gives the upper faces.
    fn wall(&mut self, wall: &SpandrelWall, surface: f64) -> Result<(Extrados, f64), WallError> {
        let layout = wall::layout(self.bridge, wall, &self.seats, self.extrados.crown(), surface)?;
        let pieces = wall::cut(&self.seats, &layout, wall.rounding)?;
        let group = self.groups.push("spandrel wall".into());
        self.walls.push(group);
        let mut road = Extrados::default();
        for (brick, piece) in pieces.into_iter().enumerate() {
            let (low, high) = piece.outline.bounds();
            let origin = Origin::Brick { course: piece.course, brick };
            let block = self.brick(wall, piece.outline, group, Held::FREE, origin);
            if piece.course == Some(0) {
                let [left, right] = [vec2(low.x, high.y), vec2(high.x, high.y)];
                road.stretches.push(Stretch { block, left, right, ground: false });
            }
        }
        road.line = vec![vec2(layout.ends[0], layout.top), vec2(layout.ends[1], layout.top)];
        if wall.end_walls {
            let group = self.groups.push("end walls".into());
            self.walls.push(group);
            for (right, seat) in [(false, self.seats.first().copied()), (true, self.seats.last().copied())] {
                let Some(seat) = seat else { continue };
                let (foot, x) = if right { (seat.right.y, layout.ends[1]) } else { (seat.left.y, layout.ends[0]) };
                let corner = vec2(if right { x } else { x - wall.brick_length }, foot);
                let outline = Polygon::rectangle(corner, wall.brick_length, layout.top - foot)
                    .map_err(|source| WallError::Outline { x, y: foot, source })?;
                self.brick(wall, outline, group, Held::FIXED, Origin::EndWall { right });
            }
        }
        Ok((road, layout.top))
    }

    fn brick(&mut self, wall: &SpandrelWall, outline: Polygon, group: GroupId, held: Held, origin: Origin) -> BlockId {
        let id = self.block(outline, group, held, origin, None);
        self.blocks[id].density = wall.density;
        self.blocks[id].rounding = wall.rounding;
        id
    }

    /// The block of a load that stands on the wall or on particles; gives the force that the load puts on it.
    fn loading_block(
        &mut self,
        stands: &Stands,
        road: &Extrados,
        load: usize,
        weight: f64,
        strip: Strip,
    ) -> Result<Spread, WallError> {
        let [from, to] = [road.line[0], road.line[1]];
        let half = 0.5 * strip.length;
        if strip.middle - half < from.x || strip.middle + half > to.x {
            return Err(WallError::BesideWall { x: strip.middle, from: from.x, to: to.x });
        }
        let outline = Polygon::rectangle(vec2(strip.middle - half, to.y), strip.length, stands.height)
            .map_err(|source| WallError::Outline { x: strip.middle, y: to.y, source })?;
        let group = self.groups.push(Origin::LoadingBlock { load }.name());
        if !stands.on_particles {
            self.walls.push(group);
        }
        let density = weight / (self.bridge.gravity * outline.area());
        let held = Held { x: true, y: false, rotation: true };
        let block = self.block(outline, group, held, Origin::LoadingBlock { load }, None);
        (self.blocks[block].density, self.blocks[block].rounding) = (density, stands.rounding);
        let at = vec2(strip.middle, to.y + stands.height);
        let forces = vec![mechanics::blocks::PointForce { block, at, force: vec2(0.0, -strip.force) }];
        let ends = [strip.middle - half, strip.middle + half].map(|x| vec2(x, to.y));
        Ok(Spread { strip, ends, depths: [0.0; 2], pressures: [0.0; 2], forces, to_ground: 0.0, shift: 0.0 })
    }

    fn finish(mut self) -> Result<Discretised, DiscretiseError> {
        let bridge = self.bridge;
        if bridge.plan.strip == Width::Fill {
            self.extrados.voids = bridge.cover.voids.clone();
        }
        if bridge.plan.strip == Width::Fill && fill::wanted(bridge).is_none() {
            self.solid_backing()?;
        }
        let mut surface = cover::surface(bridge, &self.extrados);
        let mut road = None;
        if bridge.plan.strip != Width::Fill {
            let wall = bridge.spandrel_wall.as_ref().ok_or(DiscretiseError::NoWall)?;
            if bridge.cover.road.is_some() && wall.top.is_none() {
                return Err(DiscretiseError::WallUnderRoad);
            }
            let (upper, top) = self.wall(wall, surface.highest())?;
            (road, surface) = (Some(upper), Surface::level(top));
        }
        let mut region = None;
        if fill::wanted(bridge).is_some() {
            if bridge.cover.road.is_some() {
                return Err(DiscretiseError::RoadNotLevel { what: "fill as particles" });
            }
            solid(bridge, "fill as particles")?;
            if bridge.abutments.iter().any(|abutment| abutment.body.is_some()) {
                return Err(DiscretiseError::MovableAbutment { what: "fill as particles" });
            }
            let (filled, upper) = self.fill(surface.highest())?;
            (region, road) = (Some(filled), Some(upper));
        }
        if road.is_none() {
            voids::check(bridge, &self.extrados)?;
        }
        let (spreads, counted_weight) = self.spreads(road.as_ref(), region.as_ref(), &surface)?;
        let mut laws = self.laws();
        if let (Some(region), Some(particles)) = (&region, &bridge.particles) {
            self.particle_laws(region, particles, &mut laws);
        }
        let model = BlockModel {
            laws,
            blocks: self.blocks,
            particles: Table::default(),
            groups: self.groups,
            gravity: vec2(0.0, -bridge.gravity),
        };
        let extrados = self.extrados;
        let earth = supports::earth(bridge, &extrados, &self.pressed);
        // From zero on, for an empty sum is minus zero.
        let reference_load = spreads.iter().fold(0.0, |sum, s| sum + s.strip.force);
        let loading = Loading {
            // A wall or particles stand in place of the cover.
            permanent: match (&road, &region) {
                (None, _) => [cover::weight(bridge, &extrados), pressure::water(bridge, &extrados)].concat(),
                (Some(road), Some(region)) if region.slabs => cover::on_slabs(bridge, road),
                _ => Vec::new(),
            }
            .into_iter()
            .chain(earth)
            .collect(),
            variable: spreads.iter().flat_map(|s| s.forces.iter().copied()).collect(),
            movements: movements(bridge, &model, &self.origins)?,
            restraints: Vec::new(),
        };
        let watched = watched(bridge, &extrados, &spreads, &model);
        Ok(Discretised {
            model,
            loading,
            origins: self.origins,
            faces: self.faces,
            extrados,
            road,
            fill: region,
            surface,
            counted_weight,
            reference_load,
            spreads,
            watched,
        })
    }

    /// How every load reaches the blocks, and what its blocks weigh.
    fn spreads(
        &mut self,
        road: Option<&Extrados>,
        region: Option<&FillRegion>,
        surface: &Surface,
    ) -> Result<(Vec<Spread>, f64), DiscretiseError> {
        let (mut spreads, mut weight) = (Vec::new(), 0.0);
        for (index, load) in self.bridge.loads.iter().enumerate() {
            let block = &load.block;
            for strip in dispersal::strips(load, 0.0) {
                let stands = Stands::of(self.bridge, region);
                spreads.push(match (block, road, stands) {
                    (Some(block), Some(road), Some(stands)) => {
                        weight += block.weight;
                        self.loading_block(&stands, road, index, block.weight, strip)?
                    }
                    (Some(_), ..) => return Err(DiscretiseError::BlockOnCover { load: index + 1 }),
                    (None, Some(road), _) if region.is_some_and(|r| r.slabs) => {
                        dispersal::spread(strip, self.bridge.dispersal, surface, road)
                    }
                    _ if region.is_some() => return Err(DiscretiseError::LoadOnParticles { load: index + 1 }),
                    _ => spread(self.bridge, road, &self.extrados, surface, strip),
                });
            }
        }
        Ok((spreads, weight))
    }

    fn laws(&self) -> LawTable {
        let joint: ContactLaw = laws::law(self.bridge, &self.bridge.joint);
        let between_rings = laws::law(self.bridge, &self.bridge.ring_joint);
        let mut laws = LawTable::uniform(self.groups.len(), joint);
        for a in &self.rings {
            for b in self.rings.iter().filter(|b| b.span == a.span && b.ring > a.ring) {
                laws.set(a.group, b.group, a.state.separated(&self.bridge.spans[a.span], between_rings));
            }
        }
        for weak in &self.rings {
            for other in self.groups.ids() {
                let law = *laws.between(weak.group, other);
                laws.set(weak.group, other, weak.state.weakened(&self.bridge.spans[weak.span], law));
            }
        }
        // A joint between two parts that fill a share of the width is as wide as the narrower one.
        let share =
            |group: GroupId| self.shares.iter().find(|(known, _)| *known == group).map_or(1.0, |(_, share)| *share);
        for &(group, own) in &self.shares {
            for other in self.groups.ids() {
                let theirs = share(other);
                if own < theirs || (own == theirs && group <= other) {
                    let law = *laws.between(group, other);
                    laws.set(group, other, laws::shared(law, own));
                }
            }
        }
        for &(ground, friction) in &self.grounds {
            for other in self.groups.ids() {
                laws.set(ground, other, ContactLaw { friction, cohesion: 0.0, tension: 0.0, ..joint });
            }
        }
        if let Some(wall) = &self.bridge.spandrel_wall {
            let law = laws::wall(self.bridge, wall);
            for &a in &self.walls {
                for b in self.groups.ids() {
                    laws.set(a, b, law);
                }
            }
        }
        laws
    }
}

/// What a loading block stands on, and how it is made.
struct Stands {
    height: f64,
    rounding: f64,
    on_particles: bool,
}

/// Height of a loading block that stands on particles [m]: to be seen in drawings.
const BLOCK_HEIGHT: f64 = 0.4;

impl Stands {
    fn of(bridge: &Bridge, region: Option<&FillRegion>) -> Option<Stands> {
        if region.is_some() {
            return Some(Stands { height: BLOCK_HEIGHT, rounding: bridge.masonry.rounding, on_particles: true });
        }
        let wall = bridge.spandrel_wall.as_ref()?;
        Some(Stands { height: wall.brick_height, rounding: wall.rounding, on_particles: false })
    }
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
