//! Fill and solid backing as a continuum that yields, in plane strain, for limit analysis.
//!
//! The continuum fills the space between the extrados and the top of the layers that are a continuum. Below it lie the backs
//! of the rings, the tops of piers and abutments, and beyond the abutments level ground; its ends are vertical. Levels of layers,
//! of backing and of water cut it into regions. [`earth`] makes this geometry once; [`Earth::loaded`] gives it strength and
//! loads as often as they change. Loads act on its upper face and nothing disperses: the soil carries them.

mod chain;
mod confinement;
mod layout;
mod loaded;

use super::dispersal::{Strip, strips};
use super::{DiscretiseError, Discretised, Origin};
use bridge::{Bridge, ContinuumPlan, Layer};
use chain::floor;
use confinement::panels;
use layout::{Layout, distinct};
use mechanics::blocks::{BlockModel, Loading};
use mechanics::ids::BlockId;
use mechanics::limit::continuum::{Continuum, Panel, Soil, Water};
use mechanics::plane::{Vec2, vec2};

/// Corners nearer to a level, and ends of loads nearer to a corner of the surface, are taken to lie on it [m].
const SNAP: f64 = 1e-3;

/// Levels nearer than this are one [m]: a corner may lie within [`SNAP`] of either.
const GAP: f64 = 2.0 * SNAP;

/// Points nearer than this are one [m].
const NEAR: f64 = 1e-9;

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
    /// Spandrel walls from left to right, where they bound the stress out of the plane.
    pub panels: Vec<Panel>,
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
    bridge.loads.iter().flat_map(|load| strips(load, 0.0)).collect()
}

/// The continuum of a bridge that was cut into blocks; none where it has none.
///
/// # Errors
/// A road, loads, voids or abutments that a continuum does not know, or no depth of it over the crown.
pub fn earth(bridge: &Bridge, discretised: &Discretised) -> Result<Option<Earth>, DiscretiseError> {
    let Some(plan) = wanted(bridge) else { return Ok(None) };
    super::voids::solid(bridge, "fill as a continuum", true)?;
    let backed = bridge.cover.backing.is_some_and(|backing| backing.body == bridge::BackingBody::Continuum);
    if backed && !super::springings::are_level(bridge) {
        return Err(DiscretiseError::SpringingsNotLevel { what: "backing as a continuum" });
    }
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
                if let Some(against) = tag {
                    edges.push(Edge { ends, against, material });
                }
            }
            pieces.push(Piece { outline: piece.points, material, surface: level == top });
        }
        low = level;
    }
    let above = bridge.cover.layers.iter().skip(soils.len()).filter(|layer| layer.weighs);
    let surcharge = above.fold(0.0, |sum, layer| sum + layer.density * bridge.gravity * layer.thickness);
    let panels = panels(bridge, discretised, plan, ends);
    Ok(Some(Earth { materials: layout.materials, pieces, edges, top, ends, water, surcharge, panels, plan: *plan }))
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

#[cfg(test)]
mod tests;
