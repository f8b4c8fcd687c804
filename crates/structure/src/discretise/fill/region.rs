//! Which layers of the cover are bodies, and the region that particles fill: what is in it, how it is filled.

use crate::extent::extent;
use bridge::{Analysis, Bridge, Layer, Packing, Particles, Sizes, Strip};
use mechanics::blocks::{Block, BlockModel, Held};
use mechanics::dem::{Recipe, Target};
use mechanics::ids::{GroupId, Table};
use mechanics::plane::{Polygon, Vec2, vec2};

/// Thickness of end walls and of the lid [m].
pub(super) const WALL: f64 = 0.5;

/// Solid fraction at which discs of moderately different sizes jam without friction.
const JAMMED: f64 = 0.842;

/// A region to be filled with particles.
#[derive(Debug, Clone, PartialEq)]
pub struct FillRegion {
    /// Its outline [m]: along the backs of the rings, up at the end walls, and back along the road.
    pub outline: Vec<Vec2>,
    /// Area [m^2].
    pub area: f64,
    /// Layers from the extrados up, backing first.
    pub layers: Vec<FillLayer>,
    /// Whether slabs close it above.
    pub slabs: bool,
}

/// A layer of particles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FillLayer {
    /// Group of its particles.
    pub group: GroupId,
    /// Level of its upper face [m].
    pub top: f64,
    /// Mass density of a particle [kg/m^3]: that of the layer as a whole, for the voids are part of the soil's density.
    pub density: f64,
    /// Friction angle [rad] and cohesion [Pa] between its particles, where they differ from those of all.
    pub friction_angle: Option<f64>,
    /// See above.
    pub cohesion: Option<f64>,
}

/// Whether layers are to be bodies: in the strip between the walls, where a load is raised by the discrete element method. Everywhere else they
/// are weight.
pub fn wanted(bridge: &Bridge) -> Option<&Particles> {
    let plan = &bridge.plan;
    let bodies = plan.strip == Strip::Fill && plan.method.has_particles() && plan.analysis == Analysis::Load;
    bridge.particles.as_ref().filter(|_| bodies)
}

/// Whether a layer is there as bodies, particles or slabs: it then weighs as these and not as cover.
pub fn is_bodies(bridge: &Bridge, layer: &Layer) -> bool {
    (layer.particles || layer.slabs.is_some()) && wanted(bridge).is_some()
}

impl FillRegion {
    /// The layer at a level [m].
    pub fn layer_at(&self, level: f64) -> FillLayer {
        let above = self.layers.iter().find(|layer| level <= layer.top).or(self.layers.last());
        above.copied().unwrap_or(FillLayer {
            group: GroupId(0),
            top: level,
            density: 0.0,
            friction_angle: None,
            cohesion: None,
        })
    }

    /// Whether a point lies inside: a ray to the right crosses the outline an odd number of times.
    pub fn holds(&self, point: Vec2) -> bool {
        let next = self.outline.iter().cycle().skip(1);
        let crosses = |(a, b): &(&Vec2, &Vec2)| {
            (a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)
        };
        self.outline.iter().zip(next).filter(crosses).count() % 2 == 1
    }

    /// How to fill the region, as the file wants it.
    pub fn recipe(&self, bridge: &Bridge, particles: &Particles) -> Recipe {
        let lowest = self.layer_at(f64::NEG_INFINITY);
        let [left, right] = extent(self.outline.iter().map(|p| p.x));
        let target = match particles.density {
            // Half the mean depth of soil.
            Packing::OwnWeight => Target::Stress(0.5 * lowest.density * bridge.gravity * self.area / (right - left)),
            Packing::Stress(stress) => Target::Stress(stress),
            Packing::SolidFraction(fraction) => Target::SolidFraction(fraction),
        };
        let (count, size_ratio) = match particles.sizes {
            Sizes::Count { count, ratio } => (count, ratio),
            Sizes::Diameters { smallest, largest } => {
                // Radii spread evenly: the mean square.
                let (a, b) = (0.5 * smallest, 0.5 * largest);
                let square = (a * a + a * b + b * b) / 3.0;
                let fraction = if let Target::SolidFraction(fraction) = target { fraction } else { JAMMED };
                ((fraction * self.area / (std::f64::consts::PI * square)).round().max(3.0) as usize, b / a)
            }
        };
        Recipe { count, size_ratio, target, seed: bridge.plan.seed, density: lowest.density, group: lowest.group }
    }

    /// The blocks that hold the particles while they grow: all of `model`, and a lid on the road.
    pub fn mould(&self, model: &BlockModel) -> BlockModel {
        let mut mould = model.clone();
        let [low, high] = extent(self.outline.iter().map(|p| p.x));
        let top = self.outline.last().map_or(0.0, |p| p.y);
        // Slabs are a lid while they are held.
        if !self.slabs
            && let Ok(outline) = Polygon::rectangle(vec2(low, top), high - low, WALL)
        {
            let group = model.blocks.iter().last().map_or(GroupId(0), |b| b.group);
            mould.blocks.push(Block { outline, rounding: 0.0, density: 1.0, group, held: Held::FIXED });
        }
        mould.particles = Table::default();
        mould
    }
}
