//! Fill and solid backing as a continuum that yields, in plane strain, for limit analysis.
//!
//! The continuum fills the space between the extrados and the top of the layers that are a continuum. Below it lie the backs
//! of the rings, the tops of piers and abutments, and beyond the abutments level ground; its ends are vertical. Levels of layers,
//! of backing and of water cut it into regions. [`earth`] makes this geometry once; [`Earth::loaded`] gives it strength and
//! loads as often as they change. Loads act on its upper face and nothing disperses: the soil carries them.
//!
//! Regions are made from below upwards. A chain of sides runs from the upper left corner down the left end, along the extrados
//! to the right and up the right end. Each level in turn cuts off what lies between the chain and the level, and takes the
//! place of that part of the chain. Corners within a millimetre of a level count as lying on it, so that no region is thinner.

use super::dispersal::{Strip, strips};
use super::extrados::{Face, Stretch};
use super::{DiscretiseError, Discretised, Origin};
use bridge::{Backing, BackingBody, Bridge, ContinuumPlan, FillEnds, Layer};
use mechanics::blocks::{Block, BlockModel, Held, Loading, PointForce};
use mechanics::ids::{BlockId, GroupId};
use mechanics::limit::continuum::{Bears, Contact, Continuum, Region, Side, Soil, Water};
use mechanics::plane::{Polygon, Vec2, vec2};

/// Height of the plate under a load [m], for drawings.
const PLATE: f64 = 0.1;

/// Mass density of plates [kg/m^3]: nothing beside any load.
const WEIGHTLESS: f64 = 1e-6;

/// Corners nearer to a level, and ends of loads nearer to a corner of the surface, are taken to lie on it [m].
const SNAP: f64 = 1e-3;

/// Levels nearer than this are one [m]: a corner may lie within [`SNAP`] of either.
const GAP: f64 = 2.0 * SNAP;

/// Points nearer than this are one [m].
const NEAR: f64 = 1e-9;

/// Shortest length of a load on the surface [m].
const LEAST_STRIP: f64 = 0.01;

/// Mass density of water [kg/m^3].
const WATER: f64 = 1000.0;

/// Friction angle between soil and masonry over that of the soil, where the file gives none.
const INTERFACE_SHARE: f64 = 2.0 / 3.0;

/// The continuum of a bridge: its geometry, and the strength that the file gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Earth {
    /// What it is made of.
    pub materials: Vec<Material>,
    /// Its regions, from below upwards.
    pub pieces: Vec<Piece>,
    /// Its boundary but for the upper face: the soil lies to the left of each side.
    pub edges: Vec<Edge>,
    /// Level of the upper face [m].
    pub top: f64,
    /// Where it ends on the left and on the right [m].
    pub ends: [f64; 2],
    /// Water in the pores, if there is any; never above the upper face.
    pub water: Option<Water>,
    /// Weight of the layers above it [Pa].
    pub surcharge: f64,
    /// How it is modelled.
    pub plan: ContinuumPlan,
}

/// A material of the continuum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Its weight and its whole strength.
    pub soil: Soil,
    /// Whether it is backing: bonded to the masonry, with its own strength.
    pub bonded: bool,
}

/// A region of one material.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// Corners of a simple polygon, counter-clockwise [m]: from the left end of its upper side down and along to the right end. The
    /// upper side closes it.
    pub outline: Vec<Vec2>,
    /// Its place among the materials.
    pub material: usize,
    /// Whether its upper side is part of the upper face.
    pub surface: bool,
}

/// A straight stretch of the boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    /// Its ends [m].
    pub ends: [Vec2; 2],
    /// What stands there.
    pub against: Against,
    /// The material beside it.
    pub material: usize,
}

/// What the continuum bears against.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Against {
    /// A block.
    Block(BlockId),
    /// Level ground behind an abutment, which does not move.
    Ground,
    /// What stands at a far end.
    End,
}

/// How much of the strength acts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strength {
    /// Share of cohesion and of the tangent of the friction angle that is mobilised.
    pub share: f64,
    /// Dilatancy angle [rad].
    pub dilatancy: f64,
}

impl Strength {
    /// As the file says.
    pub fn of(plan: &ContinuumPlan) -> Strength {
        Strength { share: plan.mobilised_share, dilatancy: plan.dilatancy_angle }
    }
}

/// The continuum with its strength and its loads.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedEarth {
    /// Soil, and what it touches.
    pub continuum: Continuum,
    /// The blocks of the bridge, and after them a plate under each load.
    pub model: BlockModel,
    /// What acts on them: the soil has the cover's weight, plates have the loads.
    pub loading: Loading,
    /// Share of the loads that stands beyond the ends of the fill and is left out.
    pub left_out: f64,
}

/// How the continuum is modelled, where the strip that is analysed has one. The method is for the caller: limit analysis alone
/// knows a continuum.
pub fn wanted(bridge: &Bridge) -> Option<&ContinuumPlan> {
    bridge.continuum.as_ref().filter(|_| bridge.plan.strip == bridge::Strip::Fill)
}

/// The loads of the file as strips on the surface.
pub fn loads(bridge: &Bridge) -> Vec<Strip> {
    bridge.loads.iter().flat_map(|load| strips(&load.kind, load.position)).collect()
}

/// The continuum of a bridge that was cut into blocks; none where it has none.
pub fn earth(bridge: &Bridge, discretised: &Discretised) -> Result<Option<Earth>, DiscretiseError> {
    let Some(plan) = wanted(bridge) else { return Ok(None) };
    let soils: Vec<&Layer> = bridge.cover.layers.iter().take_while(|layer| layer.continuum).collect();
    let crown = discretised.extrados.crown();
    let depth: f64 = soils.iter().map(|layer| layer.thickness).sum();
    let (top, none) = (crown + depth, DiscretiseError::ContinuumWithoutDepth { depth });
    let (Some(springings), true) = (springings(bridge, discretised), depth > GAP) else { return Err(none) };
    let reach = |side: usize| {
        let usual = f64::max(bridge.abutments[side].top_width, 2.0 * (top - springings[side].y));
        plan.extent.unwrap_or(usual)
    };
    // Where backing ends: at the outer ends of the abutments' tops.
    let stretches = &discretised.extrados.stretches;
    let (Some(first), Some(last)) = (stretches.first(), stretches.last()) else { return Err(none) };
    let backs = [first.left.x, last.right.x];
    let near = |x: f64, back: f64| if (x - back).abs() < SNAP { back } else { x };
    let ends = [near(springings[0].x - reach(0), backs[0]), near(springings[1].x + reach(1), backs[1])];
    let mut chain = floor(discretised, ends, springings.map(|p| p.y), top).ok_or(none)?;
    let lowest = chain.points.iter().map(|p| p.y).fold(f64::INFINITY, f64::min);

    let mut layout = Layout::of(bridge, crown, &soils, backs, top);
    let mut levels = layout.levels();
    let water = plan.water_level.map(|level| level.min(top)).filter(|level| *level > lowest + SNAP);
    levels.extend(water);
    let levels = distinct(levels, [lowest, top]);
    // The level at which regions are cut, so that the pressure of the water is linear in each.
    let cut = |level: f64| levels.iter().copied().find(|cut| (cut - level).abs() < GAP).unwrap_or(level);
    let water = water.map(|level| Water { level: cut(level), unit_weight: WATER * bridge.gravity });
    layout.backing = layout.backing.map(|(level, material)| (cut(level), material));

    let (mut pieces, mut edges) = (Vec::new(), Vec::new());
    let mut low = lowest;
    for &level in &levels {
        let middle = 0.5 * (low + level);
        for piece in chain.raise(level, &layout.cuts(level)) {
            let material = layout.material(vec2(piece.middle(), middle));
            for (ends, tag) in piece.sides() {
                if let Tag::Against(against) = tag {
                    edges.push(Edge { ends, against, material });
                }
            }
            pieces.push(Piece { outline: piece.points, material, surface: level == top });
        }
        low = level;
    }
    let above = bridge.cover.layers.iter().skip(soils.len()).filter(|layer| layer.weighs);
    let surcharge = above.fold(0.0, |sum, layer| sum + layer.density * bridge.gravity * layer.thickness);
    Ok(Some(Earth { materials: layout.materials, pieces, edges, top, ends, water, surcharge, plan: *plan }))
}

/// Extrados at the outer springings, on the left and on the right [m].
fn springings(bridge: &Bridge, discretised: &Discretised) -> Option<[Vec2; 2]> {
    let back = |span: usize, last: bool| {
        let ring = bridge.spans[span].rings.len() - 1;
        let voussoir = if last { bridge.spans[span].rings[ring].voussoirs - 1 } else { 0 };
        let is_it = |origin: &Origin| *origin == Origin::Voussoir { span, ring, voussoir };
        let (block, _) = discretised.origins.pairs().find(|(_, origin)| is_it(origin))?;
        discretised.faces[block].map(|faces| faces.back)
    };
    Some([back(0, false)?[0], back(bridge.spans.len() - 1, true)?[1]])
}

/// Levels in ascending order between the lowest point and the top, which is the last; none nearer to another than [`GAP`].
fn distinct(mut levels: Vec<f64>, [lowest, top]: [f64; 2]) -> Vec<f64> {
    levels.retain(|level| *level > lowest + SNAP);
    levels.sort_by(|a, b| b.total_cmp(a));
    let mut kept = vec![top];
    for level in levels {
        if kept[kept.len() - 1] - level >= GAP {
            kept.push(level);
        }
    }
    kept.reverse();
    kept
}

/// Which material lies where.
struct Layout {
    materials: Vec<Material>,
    /// Level of the upper face of each layer [m] and its material, from the extrados up.
    layers: Vec<(f64, usize)>,
    /// Level of the backing's upper face [m] and its material.
    backing: Option<(f64, usize)>,
    /// Where backing ends on the left and on the right [m].
    backs: [f64; 2],
}

impl Layout {
    fn of(bridge: &Bridge, crown: f64, soils: &[&Layer], backs: [f64; 2], top: f64) -> Layout {
        let weight = |density: f64| vec2(0.0, -density * bridge.gravity);
        let soil = |layer: &Layer| Soil {
            cohesion: layer.cohesion.unwrap_or(0.0),
            friction_angle: layer.friction_angle.unwrap_or(0.0),
            tension: layer.tensile_strength.unwrap_or(0.0),
            crushing: f64::INFINITY,
            weight: weight(layer.density),
            variable_weight: Vec2::ZERO,
        };
        let (mut materials, mut layers): (Vec<Material>, Vec<(f64, usize)>) = (Vec::new(), Vec::new());
        let mut level = crown;
        for layer in soils {
            level += layer.thickness;
            let material = Material { soil: soil(layer), bonded: false };
            // Neighbours of one material are one layer.
            match (materials.last(), layers.last_mut()) {
                (Some(below), Some(last)) if *below == material => last.0 = level,
                _ => {
                    layers.push((level, materials.len()));
                    materials.push(material);
                }
            }
        }
        let solid = |backing: Backing| Soil {
            cohesion: backing.cohesion.unwrap_or(0.0),
            friction_angle: backing.friction_angle.unwrap_or(0.0),
            tension: backing.tensile_strength.unwrap_or(0.0),
            crushing: backing.compressive_strength.unwrap_or(f64::INFINITY),
            weight: weight(backing.density),
            variable_weight: Vec2::ZERO,
        };
        let backing = bridge.cover.backing.filter(|backing| backing.body == BackingBody::Continuum).map(|backing| {
            materials.push(Material { soil: solid(backing), bonded: true });
            (backing.height.min(top), materials.len() - 1)
        });
        Layout { materials, layers, backing, backs }
    }

    /// Levels at which one material ends and another begins.
    fn levels(&self) -> Vec<f64> {
        let below_top = &self.layers[..self.layers.len().saturating_sub(1)];
        below_top.iter().chain(&self.backing).map(|(level, _)| *level).collect()
    }

    /// Where regions below a level are cut from top to bottom.
    fn cuts(&self, level: f64) -> Vec<f64> {
        if self.backing.is_some_and(|(height, _)| level <= height) { self.backs.to_vec() } else { Vec::new() }
    }

    fn material(&self, at: Vec2) -> usize {
        let [left, right] = self.backs;
        match self.backing {
            Some((height, backing)) if at.y < height && left < at.x && at.x < right => backing,
            _ => {
                let above = self.layers.iter().find(|(level, _)| *level > at.y).or(self.layers.last());
                above.map_or(0, |layer| layer.1)
            }
        }
    }
}

/// What a side of the chain is.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Tag {
    Against(Against),
    /// Between two regions.
    Inside,
}

/// Sides one after the other, never to the left, with the continuum above them.
#[derive(Debug, Clone, PartialEq)]
struct Chain {
    points: Vec<Vec2>,
    /// One fewer than points.
    tags: Vec<Tag>,
}

impl Chain {
    fn from(start: Vec2) -> Chain {
        Chain { points: vec![start], tags: Vec::new() }
    }

    fn last(&self) -> Vec2 {
        self.points[self.points.len() - 1]
    }

    /// Goes on to a point; one that is the last already adds nothing.
    fn to(&mut self, point: Vec2, tag: Tag) {
        if (point - self.last()).norm() > NEAR {
            self.points.push(point);
            self.tags.push(tag);
        }
    }

    fn sides(&self) -> impl Iterator<Item = ([Vec2; 2], Tag)> {
        self.points.windows(2).map(|pair| [pair[0], pair[1]]).zip(self.tags.iter().copied())
    }

    /// Middle between its ends [m].
    fn middle(&self) -> f64 {
        0.5 * (self.points[0].x + self.last().x)
    }

    /// Takes back what lies to the right of `x`.
    fn back_to(&mut self, x: f64) {
        while self.points.len() > 1 && self.last().x > x + NEAR {
            let (Some(beyond), Some(tag)) = (self.points.pop(), self.tags.pop()) else { return };
            let before = self.last();
            if before.x < x {
                self.to(before + (beyond - before) * ((x - before.x) / (beyond.x - before.x)), tag);
            }
        }
    }

    /// Adds a corner wherever a side crosses a level.
    fn cross(&mut self, level: f64) {
        let mut crossed = Chain::from(self.points[0]);
        for ([a, b], tag) in self.sides() {
            let (from, to) = (a.y - level, b.y - level);
            if from.min(to) < -SNAP && from.max(to) > SNAP {
                crossed.to(vec2(a.x + (b.x - a.x) * (from / (from - to)), level), tag);
            }
            crossed.to(b, tag);
        }
        *self = crossed;
    }

    /// Cuts off what lies below a level, in regions that end at the places `cuts`, too; the upper side that closes each is left out.
    fn raise(&mut self, level: f64, cuts: &[f64]) -> Vec<Chain> {
        self.cross(level);
        let below = |p: &Vec2| p.y < level - SNAP;
        let mut raised = Chain::from(self.points[0]);
        let mut pieces = Vec::new();
        let mut k = 0;
        while k + 1 < self.points.len() {
            if !below(&self.points[k + 1]) {
                raised.to(self.points[k + 1], self.tags[k]);
                k += 1;
                continue;
            }
            // Both ends of the chain are at the top.
            let rest = self.points[k + 1..].iter().position(|p| !below(p));
            let end = rest.map_or(self.points.len() - 1, |rest| k + 1 + rest);
            let run = Chain { points: self.points[k..=end].to_vec(), tags: self.tags[k..end].to_vec() };
            if run.last().x - run.points[0].x < SNAP {
                // A slot too narrow for a region.
                raised.to(run.last(), self.tags[k]);
            } else {
                for piece in run.parts(level, cuts) {
                    raised.to(piece.last(), Tag::Inside);
                    pieces.push(piece);
                }
            }
            k = end;
        }
        *self = raised;
        pieces
    }

    /// The parts between the places of vertical cuts up to a level.
    fn parts(&self, level: f64, cuts: &[f64]) -> Vec<Chain> {
        let (from, to) = (self.points[0].x + SNAP, self.last().x - SNAP);
        let mut parts = Vec::new();
        let mut rest = self.clone();
        for &x in cuts.iter().filter(|x| from < **x && **x < to) {
            let Some(foot) = rest.points.iter().position(|p| (p.x - x).abs() < NEAR) else { continue };
            let head = vec2(x, level);
            let mut part = Chain { points: rest.points[..=foot].to_vec(), tags: rest.tags[..foot].to_vec() };
            part.to(head, Tag::Inside);
            parts.push(part);
            let mut next = Chain::from(head);
            next.to(rest.points[foot], Tag::Inside);
            rest.points[foot + 1..].iter().zip(&rest.tags[foot..]).for_each(|(p, tag)| next.to(*p, *tag));
            rest = next;
        }
        parts.push(rest);
        parts
    }
}

/// The chain from the upper left corner along the extrados to the upper right one; none where the extrados reaches the top.
fn floor(discretised: &Discretised, ends: [f64; 2], ground: [f64; 2], top: f64) -> Option<Chain> {
    let extrados = &discretised.extrados;
    let inside = |s: &&Stretch| s.right.x > ends[0] + SNAP && s.left.x < ends[1] - SNAP;
    let clipped = |s: &Stretch| {
        let (left, right) = (s.left.x.max(ends[0]), s.right.x.min(ends[1]));
        let at = |x: f64, end: Vec2| if x == end.x { end } else { s.at(x) };
        Stretch { left: at(left, s.left), right: at(right, s.right), ..*s }
    };
    let stretches: Vec<Stretch> = extrados.stretches.iter().filter(inside).map(clipped).collect();
    let (first, last) = (stretches.first()?, stretches.last()?);
    if stretches.iter().any(|s| s.left.y.max(s.right.y) > top - SNAP) {
        return None;
    }
    let mut chain = Chain::from(vec2(ends[0], top));
    let end = Tag::Against(Against::End);
    let level = if first.left.x - ends[0] > SNAP { ground[0] } else { first.left.y };
    chain.to(vec2(ends[0], level), end);
    if first.left.x - ends[0] > SNAP {
        chain.to(vec2(first.left.x, level), Tag::Against(Against::Ground));
    }
    let mut before = first.block;
    for stretch in &stretches {
        let mut left = stretch.left;
        if left.x < chain.last().x - NEAR {
            // A back that overhangs is no part of the extrados: what is above shadows what is below.
            if left.y > chain.last().y {
                chain.back_to(left.x);
            } else if stretch.right.x > chain.last().x + NEAR {
                left = stretch.at(chain.last().x);
            } else {
                continue;
            }
        }
        join(&mut chain, left, [before, stretch.block], &extrados.faces);
        chain.to(stretch.right, Tag::Against(Against::Block(stretch.block)));
        before = stretch.block;
    }
    if ends[1] - last.right.x > SNAP {
        join(&mut chain, vec2(last.right.x, ground[1]), [before; 2], &extrados.faces);
        chain.to(vec2(ends[1], ground[1]), Tag::Against(Against::Ground));
    }
    chain.to(vec2(ends[1], top), end);
    Some(chain)
}

/// Goes on to the next stretch, which need not begin where the last ended: a step belongs to the higher of the two blocks, or to
/// those whose faces stand there.
fn join(chain: &mut Chain, to: Vec2, [before, after]: [BlockId; 2], faces: &[Face]) {
    let from = chain.last();
    let tag = |block: BlockId| Tag::Against(Against::Block(block));
    let upper = if to.y > from.y { after } else { before };
    let mut levels = vec![from.y, to.y];
    let here = |face: &&Face| (face.x - from.x).abs() < SNAP;
    if (to.x - from.x).abs() < NEAR {
        let between = |y: &f64| *y > from.y.min(to.y) + NEAR && *y < from.y.max(to.y) - NEAR;
        levels.extend(faces.iter().filter(here).flat_map(|face| face.levels).filter(between));
    }
    levels.sort_by(f64::total_cmp);
    if to.y < from.y {
        levels.reverse();
    }
    for pair in levels.windows(2) {
        let middle = 0.5 * (pair[0] + pair[1]);
        let stands = |face: &&Face| here(face) && face.levels[0] < middle && middle < face.levels[1];
        let block = faces.iter().find(stands).map_or(upper, |face| face.block);
        chain.to(if pair[1] == to.y { to } else { vec2(from.x, pair[1]) }, tag(block));
    }
}

impl Earth {
    /// The continuum with a strength, and with loads on its upper face. Each stands on a rigid plate as long as its strip, free to sink, slide
    /// and turn: the soil decides where it presses, and the resultant stays where the load is. A pressure that must be uniform would fail
    /// at the edges of its strip before the soil below it does. Loads whose strips meet share a plate. Pressure of fill on backs
    /// ([`super::pressure::restraints`]) must not be added.
    pub fn loaded(
        &self,
        discretised: &Discretised,
        strength: Strength,
        strips: &[Strip],
    ) -> Result<LoadedEarth, DiscretiseError> {
        let plates = self.plates(strips)?;
        let mut model = discretised.model.clone();
        let mut loading = Loading { movements: discretised.loading.movements.clone(), ..Loading::default() };
        let group = model.blocks.iter().next().map_or(GroupId(0), |b| b.group);
        let mut blocks = Vec::with_capacity(plates.on.len());
        for plate in &plates.on {
            let [a, b] = plate.ends;
            let outline = Polygon::rectangle(vec2(a, self.top), b - a, PLATE)
                .map_err(|_| DiscretiseError::PointLoadOnContinuum { x: plate.at, length: b - a })?;
            let block =
                model.blocks.push(Block { outline, rounding: 0.0, density: WEIGHTLESS, group, held: Held::FREE });
            let down = |force: f64, x: f64| PointForce { block, at: vec2(x, self.top), force: vec2(0.0, -force) };
            loading.variable.push(down(plate.force, plate.at));
            if self.surcharge > 0.0 {
                loading.permanent.push(down(self.surcharge * (b - a), 0.5 * (a + b)));
            }
            blocks.push(block);
        }
        let mut regions = Vec::new();
        let mut sides: Vec<Side> = self.edges.iter().filter_map(|edge| self.side(edge, strength)).collect();
        for piece in &self.pieces {
            let mut outline = piece.outline.clone();
            if piece.surface
                && let (Some(&left), Some(&right)) = (outline.first(), outline.last())
            {
                let inner = plates.marks.iter().filter(|x| left.x + NEAR < **x && **x < right.x - NEAR);
                let at = |x: f64| left + (right - left) * ((x - left.x) / (right.x - left.x));
                outline.extend(inner.rev().map(|x| vec2(*x, at(*x).y)));
                let along: Vec<Vec2> = outline[piece.outline.len() - 1..].iter().copied().chain([left]).collect();
                let contact = self.contact(piece.material, strength);
                for pair in along.windows(2) {
                    let middle = 0.5 * (pair[0].x + pair[1].x);
                    let plate = plates.on.iter().position(|p| p.ends[0] < middle && middle < p.ends[1]);
                    let bears = match plate {
                        Some(plate) => Bears::Body { block: Some(blocks[plate]), contact },
                        None => Bears::Load { permanent: vec2(0.0, -self.surcharge), variable: Vec2::ZERO },
                    };
                    sides.push(Side { ends: [pair[0], pair[1]], bears });
                }
            }
            regions.push(Region { outline, soil: self.soil(piece.material, strength) });
        }
        let left_out = if plates.total > 0.0 { plates.left_out / plates.total } else { 0.0 };
        Ok(LoadedEarth { continuum: Continuum { regions, sides, water: self.water }, model, loading, left_out })
    }

    fn soil(&self, material: usize, strength: Strength) -> Soil {
        self.materials[material].soil.reduced(strength.share, strength.dilatancy)
    }

    /// A side of the boundary; none where it is free.
    fn side(&self, edge: &Edge, strength: Strength) -> Option<Side> {
        let contact = self.contact(edge.material, strength);
        let (block, contact) = match (edge.against, self.plan.ends) {
            (Against::Block(block), _) => (Some(block), contact),
            (Against::Ground, _) | (Against::End, FillEnds::Hold) => (None, contact),
            (Against::End, FillEnds::Slide) => (None, Contact { friction: 0.0, cohesion: 0.0, tension: 0.0 }),
            (Against::End, FillEnds::Free) => return None,
        };
        Some(Side { ends: edge.ends, bears: Bears::Body { block, contact } })
    }

    /// How a material resists where it touches masonry or ground. The interface is reduced as the soil is; it is never stronger.
    fn contact(&self, material: usize, strength: Strength) -> Contact {
        let Material { soil, bonded } = self.materials[material];
        let reduced = self.soil(material, strength);
        if bonded {
            return Contact { friction: reduced.friction_angle.tan(), cohesion: reduced.cohesion, tension: 0.0 };
        }
        let whole = self.plan.interface_friction_angle.unwrap_or(INTERFACE_SHARE * soil.friction_angle);
        // What is left of one pascal of cohesion is the factor on all strength.
        let factor = Soil { cohesion: 1.0, ..soil }.reduced(strength.share, strength.dilatancy).cohesion;
        Contact {
            friction: factor * whole.min(soil.friction_angle).tan(),
            cohesion: factor * self.plan.interface_cohesion.min(soil.cohesion),
            tension: 0.0,
        }
    }

    /// The plates of strips on the upper face.
    fn plates(&self, strips: &[Strip]) -> Result<Plates, DiscretiseError> {
        let corners = self.pieces.iter().filter(|piece| piece.surface).flat_map(|piece| {
            let ends = [piece.outline.first(), piece.outline.last()];
            ends.into_iter().flatten().map(|p| p.x)
        });
        let mut marks: Vec<f64> = corners.collect();
        let mut found = Plates { marks: Vec::new(), on: Vec::new(), total: 0.0, left_out: 0.0 };
        for strip in strips {
            if !(strip.length >= LEAST_STRIP) {
                return Err(DiscretiseError::PointLoadOnContinuum { x: strip.middle, length: strip.length });
            }
            found.total += strip.force;
            let half = 0.5 * strip.length;
            let [from, to] = [strip.middle - half, strip.middle + half].map(|x| x.clamp(self.ends[0], self.ends[1]));
            let [a, b] = [from, to].map(|x| {
                let nearest = marks.iter().copied().min_by(|p, q| (p - x).abs().total_cmp(&(q - x).abs()));
                nearest.filter(|mark| (mark - x).abs() < SNAP).unwrap_or_else(|| {
                    marks.push(x);
                    x
                })
            });
            let inside = if b > a { strip.force * (to - from) / strip.length } else { 0.0 };
            found.left_out += strip.force - inside;
            if b > a {
                found.on.push(Plate { ends: [a, b], force: inside, at: 0.5 * (from + to) });
            }
        }
        marks.sort_by(f64::total_cmp);
        marks.dedup();
        found.on.sort_by(|p, q| p.ends[0].total_cmp(&q.ends[0]));
        let mut merged: Vec<Plate> = Vec::with_capacity(found.on.len());
        for plate in found.on {
            match merged.last_mut() {
                Some(last) if plate.ends[0] <= last.ends[1] => last.join(plate),
                _ => merged.push(plate),
            }
        }
        Ok(Plates { marks, on: merged, ..found })
    }
}

/// Plates on the upper face.
struct Plates {
    /// Corners of the upper face and ends of loads, from left to right [m].
    marks: Vec<f64>,
    /// From left to right.
    on: Vec<Plate>,
    /// Sum of all forces [N/m].
    total: f64,
    /// What stands beyond the ends [N/m].
    left_out: f64,
}

/// A rigid plate under loads.
#[derive(Debug, Clone, Copy)]
struct Plate {
    /// Its ends [m].
    ends: [f64; 2],
    /// The resultant of its loads [N/m].
    force: f64,
    /// Where it acts [m].
    at: f64,
}

impl Plate {
    fn join(&mut self, other: Plate) {
        let force = self.force + other.force;
        if force != 0.0 {
            self.at = (self.force * self.at + other.force * other.at) / force;
        }
        self.force = force;
        self.ends[1] = self.ends[1].max(other.ends[1]);
    }
}

#[cfg(test)]
mod tests;
