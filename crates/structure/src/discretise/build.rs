//! The blocks of a bridge as they are put together.

use super::cover::Surface;
use super::discretised::{Discretised, spread, watched};
use super::dispersal::{Spread, Strip};
use super::extrados::{Extrados, Stretch};
use super::fill::FillRegion;
use super::movement::movements;
use super::wall::{Seat, WallError};
use super::{DiscretiseError, Faces, Origin, cover, defects, dispersal, fill, laws, pressure, supports, voids, wall};
use bridge::{Bridge, SpandrelWall, Strip as Width};
use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading};
use mechanics::ids::{BlockId, GroupId, Table};
use mechanics::plane::{Polygon, Vec2, vec2};

/// Voussoirs of a ring that are in the same state.
pub(super) struct RingGroup {
    pub(super) group: GroupId,
    pub(super) span: usize,
    pub(super) ring: usize,
    pub(super) state: defects::State,
}

pub(super) struct Build<'a> {
    pub(super) bridge: &'a Bridge,
    pub(super) blocks: Table<BlockId, Block>,
    pub(super) groups: Table<GroupId, String>,
    /// Groups of voussoirs.
    pub(super) rings: Vec<RingGroup>,
    pub(super) origins: Table<BlockId, Origin>,
    pub(super) faces: Table<BlockId, Option<Faces>>,
    pub(super) extrados: Extrados,
    pub(super) seats: Vec<Seat>,
    /// Groups of bricks, end walls and loading blocks: all their contacts follow the law of the wall's joints.
    pub(super) walls: Vec<GroupId>,
    /// Groups whose joints have a share of the strength: they fill a share of the width.
    pub(super) shares: Vec<(GroupId, f64)>,
    /// Groups of ground under abutments that can move, with the friction on it.
    pub(super) grounds: Vec<(GroupId, f64)>,
    /// Backs of abutments that can move: where soil presses.
    pub(super) pressed: Vec<supports::Back>,
}

impl<'a> Build<'a> {
    pub(super) fn new(bridge: &'a Bridge) -> Build<'a> {
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

    pub(super) fn block(&mut self, outline: Polygon, group: GroupId, held: Held, origin: Origin) -> BlockId {
        self.origins.push(origin);
        self.faces.push(None);
        let Bridge { masonry, .. } = self.bridge;
        self.blocks.push(Block { outline, rounding: masonry.rounding, density: masonry.density, group, held })
    }

    pub(super) fn stretch(&mut self, block: BlockId, [left, right]: [Vec2; 2], ground: bool) {
        if right.x > left.x {
            self.extrados.stretches.push(Stretch { block, left, right, ground });
        }
    }

    pub(super) fn span(&mut self, span: usize, rings: Vec<Vec<(Polygon, Faces)>>) {
        let uppermost = rings.len() - 1;
        for (ring, cuts) in rings.into_iter().enumerate() {
            let mut groups: Vec<RingGroup> = Vec::new();
            for (voussoir, (outline, faces)) in cuts.into_iter().enumerate() {
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
                let origin = Origin::Voussoir { span, ring, voussoir };
                let block = self.block(outline, group, Held::FREE, origin);
                self.faces[block] = Some(faces);
                if ring == uppermost {
                    self.stretch(block, faces.back, false);
                    self.seats.push(Seat { left: faces.back[0], right: faces.back[1], span: Some(span) });
                }
            }
            self.rings.extend(groups);
        }
    }

    /// Bricks on the extrados and the fixed walls at their ends; gives the upper faces.
    pub(super) fn wall(&mut self, wall: &SpandrelWall, surface: f64) -> Result<(Extrados, f64), WallError> {
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
        let id = self.block(outline, group, held, origin);
        self.blocks[id].density = wall.density;
        self.blocks[id].rounding = wall.rounding;
        id
    }

    /// The block of a load that stands on the wall or on particles; gives the force that the load puts on it.
    pub(super) fn loading_block(
        &mut self,
        on_particles: bool,
        road: &Extrados,
        load: usize,
        weight: f64,
        strip: Strip,
    ) -> Result<Spread, WallError> {
        let (height, rounding) = match &self.bridge.spandrel_wall {
            Some(wall) if !on_particles => (wall.brick_height, wall.rounding),
            _ => (BLOCK_HEIGHT, self.bridge.masonry.rounding),
        };
        let [from, to] = [road.line[0], road.line[1]];
        let half = 0.5 * strip.length;
        if strip.middle - half < from.x || strip.middle + half > to.x {
            return Err(WallError::BesideWall { x: strip.middle, from: from.x, to: to.x });
        }
        let outline = Polygon::rectangle(vec2(strip.middle - half, to.y), strip.length, height)
            .map_err(|source| WallError::Outline { x: strip.middle, y: to.y, source })?;
        let group = self.groups.push(Origin::LoadingBlock { load }.name());
        if !on_particles {
            self.walls.push(group);
        }
        let density = weight / (self.bridge.gravity * outline.area());
        let held = Held { x: true, y: false, rotation: true };
        let block = self.block(outline, group, held, Origin::LoadingBlock { load });
        (self.blocks[block].density, self.blocks[block].rounding) = (density, rounding);
        let at = vec2(strip.middle, to.y + height);
        let forces = vec![mechanics::blocks::PointForce { block, at, force: vec2(0.0, -strip.force) }];
        let ends = [strip.middle - half, strip.middle + half].map(|x| vec2(x, to.y));
        Ok(Spread { strip, ends, depths: [0.0; 2], pressures: [0.0; 2], forces, to_ground: 0.0, shift: 0.0 })
    }

    pub(super) fn finish(mut self) -> Result<Discretised, DiscretiseError> {
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
            voids::solid(bridge, "fill as particles", false)?;
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
    pub(super) fn spreads(
        &mut self,
        road: Option<&Extrados>,
        region: Option<&FillRegion>,
        surface: &Surface,
    ) -> Result<(Vec<Spread>, f64), DiscretiseError> {
        let (mut spreads, mut weight) = (Vec::new(), 0.0);
        for (index, load) in self.bridge.loads.iter().enumerate() {
            let block = &load.block;
            for strip in dispersal::strips(load, 0.0) {
                spreads.push(match (block, road) {
                    (Some(block), Some(road)) => {
                        weight += block.weight;
                        self.loading_block(region.is_some(), road, index, block.weight, strip)?
                    }
                    (Some(_), None) => return Err(DiscretiseError::BlockOnCover { load: index + 1 }),
                    (None, Some(road)) if region.is_some_and(|r| r.slabs) => {
                        dispersal::spread(strip, self.bridge.dispersal, surface, road)
                    }
                    _ if region.is_some() => return Err(DiscretiseError::LoadOnParticles { load: index + 1 }),
                    _ => spread(self.bridge, road, &self.extrados, surface, strip),
                });
            }
        }
        Ok((spreads, weight))
    }

    pub(super) fn laws(&self) -> LawTable {
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

/// Height of a loading block that stands on particles [m]: to be seen in drawings.
const BLOCK_HEIGHT: f64 = 0.4;
