//! Layers of the cover that are particles: the region they fill, the walls that hold it, the laws of their contacts.

mod region;

pub use region::{FillLayer, FillRegion, is_bodies, wanted};

use super::build::Build;
use super::extrados::{Extrados, Stretch};
use super::laws;
use super::springings::are_level;
use super::{DiscretiseError, Origin};
use bridge::{BackingBody, Joint, Layer, Particles};
use mechanics::blocks::{ContactLaw, Held, LawTable};
use mechanics::ids::GroupId;
use mechanics::plane::{Polygon, Vec2, vec2};
use region::WALL;

/// Width of the gap between two slabs [m]: a road carries no thrust from end to end.
const SLAB_GAP: f64 = 5e-3;

/// Height by which end walls stand above the road [m], so that nothing flows over them.
const PARAPET: f64 = 1.0;

impl Build<'_> {
    /// The region between the extrados, the ends and the road, the fixed walls at its ends, backing and slabs that are
    /// blocks. Gives the upper faces on which loads stand, too.
    pub(super) fn fill(&mut self, surface: f64) -> Result<(FillRegion, Extrados), DiscretiseError> {
        let [particles, bodies] = self.levels()?;
        let mut outline = self.floor()?;
        let (Some(&first), Some(&last)) = (outline.first(), outline.last()) else {
            return Err(DiscretiseError::NoRegion);
        };
        let layers = self.layers();
        outline.extend([vec2(last.x, particles), vec2(first.x, particles)]);
        let group = self.groups.push("end walls".into());
        // End walls stand on the abutments and hold backing as they hold particles.
        let below = |s: Option<&Stretch>| s.map_or(f64::INFINITY, |s| s.left.y.min(s.right.y));
        let feet = [below(self.extrados.stretches.first()), below(self.extrados.stretches.last())];
        for (right, foot) in [(false, first), (true, last)] {
            let corner = vec2(if right { foot.x } else { foot.x - WALL }, foot.y.min(feet[usize::from(right)]));
            let wall = Polygon::rectangle(corner, WALL, surface + PARAPET - corner.y)
                .map_err(|_| DiscretiseError::NoRegion)?;
            self.block(wall, group, Held::FIXED, Origin::EndWall { right });
        }
        let area = area(&outline);
        if !(area > 0.0) {
            return Err(DiscretiseError::NoRegion);
        }
        let line = vec![vec2(first.x, bodies), vec2(last.x, bodies)];
        let stretches = self.slabs(particles, [first.x, last.x]);
        let slabs = !stretches.is_empty();
        Ok((FillRegion { outline, area, layers, slabs }, Extrados { stretches, line, ..Extrados::default() }))
    }

    /// Backing as blocks under cover that is weight, up to its level or the crown. Cover and loads then lie on its upper faces.
    pub(super) fn solid_backing(&mut self) -> Result<(), DiscretiseError> {
        let backing = self.bridge.cover.backing.filter(|b| b.body == BackingBody::Blocks);
        let Some(backing) = backing else { return Ok(()) };
        let level = backing.height.min(self.extrados.crown());
        (self.extrados.stretches, self.extrados.faces) = self.backed(&backing, level)?;
        self.extrados.line.iter_mut().for_each(|p| p.y = p.y.max(level));
        Ok(())
    }

    /// Levels of the upper faces of the particles and of the slabs on them [m]; particles below slabs below what is weight alone.
    fn levels(&self) -> Result<[f64; 2], DiscretiseError> {
        let cover = &self.bridge.cover;
        if cover.backing.is_some_and(|b| matches!(b.body, BackingBody::Weight | BackingBody::Continuum)) {
            return Err(DiscretiseError::BackingUnderParticles);
        }
        if cover.backing.is_some() && !are_level(self.bridge) {
            return Err(DiscretiseError::SpringingsNotLevel { what: "backing as particles" });
        }
        let rank = |l: &Layer| match (l.particles, l.slabs) {
            (true, _) => 0,
            (false, Some(_)) => 1,
            (false, None) => 2,
        };
        if let Some(k) = cover.layers.windows(2).position(|pair| rank(&pair[0]) > rank(&pair[1])) {
            return Err(DiscretiseError::LayerOrder { layer: k + 2 });
        }
        let slabs = cover.layers.iter().any(|l| l.slabs.is_some());
        if let Some(layer) = cover.layers.iter().position(|l| rank(l) == 2 && l.weighs && !slabs) {
            return Err(DiscretiseError::WeightOnParticles { layer: layer + 1 });
        }
        let depth = |most: u32| cover.layers.iter().filter(|l| rank(l) <= most).map(|l| l.thickness).sum::<f64>();
        let crown = self.extrados.crown();
        Ok([crown + depth(0), crown + depth(1)])
    }

    /// The lower boundary of the region: the backs of the rings, or of the backing that stands on them as blocks.
    fn floor(&mut self) -> Result<Vec<Vec2>, DiscretiseError> {
        let stretches = match self.bridge.cover.backing.filter(|b| b.body == BackingBody::Blocks) {
            Some(backing) => self.backed(&backing, backing.height)?.0,
            None => self.extrados.stretches.clone(),
        };
        let mut floor: Vec<Vec2> = stretches.iter().flat_map(|s| [s.left, s.right]).collect();
        floor.dedup_by(|point, last| (*last - *point).norm() <= 1e-9);
        Ok(floor)
    }

    /// Groups of particles, from the extrados up.
    fn layers(&mut self) -> Vec<FillLayer> {
        let cover = &self.bridge.cover;
        let mut level = self.extrados.crown();
        let mut layers = Vec::new();
        if let Some(backing) = cover.backing.filter(|b| b.body == BackingBody::Particles) {
            let group = self.groups.push("backing".into());
            let (friction_angle, cohesion) = (backing.friction_angle, backing.cohesion);
            layers.push(FillLayer { group, top: backing.height, density: backing.density, friction_angle, cohesion });
        }
        for (index, layer) in cover.layers.iter().enumerate() {
            level += layer.thickness;
            if layer.particles {
                let group = self.groups.push(format!("layer {}", index + 1));
                let (friction_angle, cohesion) = (layer.friction_angle, layer.cohesion);
                layers.push(FillLayer { group, top: level, density: layer.density, friction_angle, cohesion });
            }
        }
        layers
    }

    /// Slabs that lie on the particles, from their level up, course by course; the upper faces of the uppermost.
    fn slabs(&mut self, mut level: f64, [from, to]: [f64; 2]) -> Vec<Stretch> {
        let mut upper = Vec::new();
        for (index, layer) in self.bridge.cover.layers.iter().enumerate() {
            let Some(length) = layer.slabs else { continue };
            let group = self.groups.push(format!("layer {}", index + 1));
            let count = ((to - from) / length).round().max(1.0);
            let pitch = (to - from) / count;
            upper.clear();
            for slab in 0..count as usize {
                let left = from + pitch * slab as f64 + 0.5 * SLAB_GAP;
                let corner = vec2(left, level);
                let Ok(outline) = Polygon::rectangle(corner, pitch - SLAB_GAP, layer.thickness) else { continue };
                let block = self.block(outline, group, Held::FREE, Origin::Slab { layer: index, slab });
                self.blocks[block].density = layer.density;
                let y = level + layer.thickness;
                let (left, right) = (vec2(left, y), vec2(left + pitch - SLAB_GAP, y));
                upper.push(Stretch { block, left, right, ground: false });
            }
            level += layer.thickness;
        }
        upper
    }

    /// Laws of contacts among particles, and of particles with blocks.
    pub(super) fn particle_laws(&self, region: &FillRegion, particles: &Particles, laws: &mut LawTable) {
        let of_layer = |group: GroupId| region.layers.iter().find(|layer| layer.group == group);
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
fn between(particles: &Particles, a: &FillLayer, b: &FillLayer) -> ContactLaw {
    let whole = law(particles, &particles.joint);
    let friction = |l: &FillLayer| l.friction_angle.map_or(whole.friction, f64::tan);
    let cohesion = |l: &FillLayer| l.cohesion.unwrap_or(whole.cohesion);
    ContactLaw { friction: friction(a).min(friction(b)), cohesion: cohesion(a).min(cohesion(b)), ..whole }
}

/// A contact of particles; the series rule takes the modulus of the particles.
pub fn law(particles: &Particles, joint: &Joint) -> ContactLaw {
    // Particles stand for a fixed length.
    let moduli = laws::moduli(particles.elastic_modulus, particles.poisson_ratio);
    ContactLaw { tension: 0.0, ..laws::contact(joint, moduli, f64::INFINITY, 1.0) }
}

/// Area of a simple polygon [m^2].
fn area(outline: &[Vec2]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    0.5 * outline.iter().zip(next).map(|(a, b)| a.cross(*b)).sum::<f64>()
}
