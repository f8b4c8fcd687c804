//! Layers of the cover that are particles: the region they fill, the walls that hold it, the laws of their contacts.

use super::laws;
use super::{Build, DiscretiseError, Origin};
use bridge::{Bridge, Joint, Layer, Packing, Particles, Sizes};
use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable};
use mechanics::dem::{Recipe, Target};
use mechanics::ids::{GroupId, Table};
use mechanics::plane::{Polygon, Vec2, vec2};

/// A region to be filled with particles.
#[derive(Debug, Clone, PartialEq)]
pub struct FillRegion {
    /// Its outline [m]: along the backs of the rings, up at the end walls, and back along the road.
    pub outline: Vec<Vec2>,
    /// Area [m^2].
    pub area: f64,
    /// Layers from the extrados up.
    pub layers: Vec<FillLayer>,
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
}

/// Thickness of end walls and of the lid [m].
const WALL: f64 = 0.5;

/// Height by which end walls stand above the road [m], so that nothing flows over them.
const PARAPET: f64 = 1.0;

/// Whether layers are to be bodies: in the strip between the walls, by the discrete element method.
pub fn wanted(bridge: &Bridge) -> Option<&Particles> {
    let strip = bridge.plan.strip == bridge::Strip::Fill && bridge.plan.method == bridge::Method::Dem;
    bridge.particles.as_ref().filter(|_| strip)
}

impl Build<'_> {
    /// The region between the extrados, the ends and the road, and the fixed walls at its ends.
    pub(super) fn fill(&mut self, surface: f64) -> Result<FillRegion, DiscretiseError> {
        let cover = &self.bridge.cover;
        if let Some(layer) = cover.layers.iter().position(|l| !l.particles && l.weighs) {
            return Err(DiscretiseError::WeightOnParticles { layer: layer + 1 });
        }
        if cover.backing.is_some() {
            return Err(DiscretiseError::BackingUnderParticles);
        }
        let mut outline: Vec<Vec2> = Vec::new();
        for stretch in &self.extrados.stretches {
            for point in [stretch.left, stretch.right] {
                if outline.last().is_none_or(|last| (*last - point).norm() > 1e-9) {
                    outline.push(point);
                }
            }
        }
        let (Some(&first), Some(&last)) = (outline.first(), outline.last()) else {
            return Err(DiscretiseError::NoRegion);
        };
        let mut level = self.extrados.crown();
        let mut layers = Vec::new();
        for (index, layer) in cover.layers.iter().enumerate() {
            level += layer.thickness;
            if layer.particles {
                let group = self.groups.push(format!("layer {}", index + 1));
                layers.push(FillLayer { group, top: level, density: layer.density });
            }
        }
        // What lies above the uppermost particles is depth for loads only.
        let top = layers.last().map_or(surface, |layer| layer.top);
        outline.extend([vec2(last.x, top), vec2(first.x, top)]);
        let group = self.groups.push("end walls".into());
        for (right, foot) in [(false, first), (true, last)] {
            let corner = vec2(if right { foot.x } else { foot.x - WALL }, foot.y);
            let wall =
                Polygon::rectangle(corner, WALL, top + PARAPET - foot.y).map_err(|_| DiscretiseError::NoRegion)?;
            self.block(wall, group, Held::FIXED, Origin::EndWall { right }, None);
        }
        let area = area(&outline);
        if !(area > 0.0) {
            return Err(DiscretiseError::NoRegion);
        }
        Ok(FillRegion { outline, area, layers })
    }

    /// Laws of contacts among particles, and of particles with blocks.
    pub(super) fn particle_laws(&self, region: &FillRegion, particles: &Particles, laws: &mut LawTable) {
        let of_layer = |group: GroupId| {
            let index = region.layers.iter().position(|layer| layer.group == group)?;
            self.bridge.cover.layers.iter().filter(|layer| layer.particles).nth(index)
        };
        for a in self.groups.ids() {
            let Some(layer) = of_layer(a) else { continue };
            for b in self.groups.ids() {
                laws.set(
                    a,
                    b,
                    match of_layer(b) {
                        Some(other) => between(particles, layer, other),
                        None => law(particles, &particles.block_joint),
                    },
                );
            }
        }
    }
}

/// The law between particles of two layers: friction and cohesion are those of the weaker one.
fn between(particles: &Particles, a: &Layer, b: &Layer) -> ContactLaw {
    let whole = law(particles, &particles.joint);
    let friction = |l: &Layer| l.friction_angle.map_or(whole.friction, f64::tan);
    let cohesion = |l: &Layer| l.cohesion.unwrap_or(whole.cohesion);
    ContactLaw { friction: friction(a).min(friction(b)), cohesion: cohesion(a).min(cohesion(b)), ..whole }
}

/// A contact of particles; the series rule takes the modulus of the particles.
pub fn law(particles: &Particles, joint: &Joint) -> ContactLaw {
    let shear_modulus = || Some(particles.elastic_modulus? / (2.0 * (1.0 + particles.poisson_ratio?)));
    ContactLaw {
        normal: laws::stiffness(joint.normal_stiffness, particles.elastic_modulus),
        shear: laws::stiffness(joint.shear_stiffness, shear_modulus()),
        friction: joint.friction_angle.tan(),
        cohesion: joint.cohesion,
        tension: 0.0,
        crushing: f64::INFINITY,
        fixed_length: joint.fixed_length,
        // Particles stand for a fixed length.
        least_length: joint.least_length.unwrap_or(1.0),
    }
}

impl FillRegion {
    /// The layer at a level [m].
    pub fn layer_at(&self, level: f64) -> FillLayer {
        let above = self.layers.iter().find(|layer| level <= layer.top).or(self.layers.last());
        above.copied().unwrap_or(FillLayer { group: GroupId(0), top: level, density: 0.0 })
    }

    /// How to fill the region, as the file wants it.
    pub fn recipe(&self, bridge: &Bridge, particles: &Particles) -> Recipe {
        let lowest = self.layer_at(f64::NEG_INFINITY);
        let length = self.outline.iter().map(|p| p.x).fold(f64::NEG_INFINITY, f64::max)
            - self.outline.iter().map(|p| p.x).fold(f64::INFINITY, f64::min);
        let target = match particles.density {
            // Half the mean depth of soil.
            Packing::OwnWeight => Target::Stress(0.5 * lowest.density * bridge.gravity * self.area / length),
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
        let (low, high) = self
            .outline
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(p.x), high.max(p.x)));
        let top = self.outline.last().map_or(0.0, |p| p.y);
        if let Ok(outline) = Polygon::rectangle(vec2(low, top), high - low, WALL) {
            let group = model.blocks.iter().last().map_or(GroupId(0), |b| b.group);
            mould.blocks.push(Block { outline, rounding: 0.0, density: 1.0, group, held: Held::FIXED });
        }
        mould.particles = Table::default();
        mould
    }
}

/// Solid fraction at which discs of moderately different sizes jam without friction.
const JAMMED: f64 = 0.842;

/// Area of a simple polygon [m^2].
fn area(outline: &[Vec2]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    0.5 * outline.iter().zip(next).map(|(a, b)| a.cross(*b)).sum::<f64>()
}
