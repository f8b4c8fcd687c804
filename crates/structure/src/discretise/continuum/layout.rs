//! Which material lies where: layers, and backing between the outer ends of the abutments' tops.

use super::{GAP, Material, SNAP};
use bridge::{Backing, BackingBody, Bridge, Layer};
use mechanics::limit::continuum::Soil;
use mechanics::plane::{Vec2, vec2};

/// Levels in ascending order between the lowest point and the top, which is the last; none nearer to another than [`GAP`].
pub(super) fn distinct(mut levels: Vec<f64>, [lowest, top]: [f64; 2]) -> Vec<f64> {
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
pub(super) struct Layout {
    pub materials: Vec<Material>,
    /// Level of the upper face of each layer [m] and its material, from the extrados up.
    layers: Vec<(f64, usize)>,
    /// Level of the backing's upper face [m] and its material.
    pub backing: Option<(f64, usize)>,
    /// Where backing ends on the left and on the right [m].
    backs: [f64; 2],
    /// Level of the water in the pores of the lowest layer [m], and the layer's material with its pores full.
    pub full: Option<(f64, usize)>,
}

impl Layout {
    pub(super) fn of(bridge: &Bridge, crown: f64, soils: &[&Layer], backs: [f64; 2], top: f64) -> Layout {
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
        let full = bridge.cover.water.zip(soils.first()).map(|(pores, lowest)| {
            let wet = Soil { weight: weight(pores.saturated_density), ..soil(lowest) };
            materials.push(Material { soil: wet, bonded: false });
            (pores.level, materials.len() - 1)
        });
        Layout { materials, layers, backing, backs, full }
    }

    /// Levels at which one material ends and another begins.
    pub(super) fn levels(&self) -> Vec<f64> {
        let below_top = &self.layers[..self.layers.len().saturating_sub(1)];
        below_top.iter().chain(&self.backing).map(|(level, _)| *level).collect()
    }

    /// Where regions below a level are cut from top to bottom.
    pub(super) fn cuts(&self, level: f64) -> Vec<f64> {
        if self.backing.is_some_and(|(height, _)| level <= height) { self.backs.to_vec() } else { Vec::new() }
    }

    pub(super) fn material(&self, at: Vec2) -> usize {
        let [left, right] = self.backs;
        match self.backing {
            Some((height, backing)) if at.y < height && left < at.x && at.x < right => backing,
            _ => {
                let above = self.layers.iter().find(|(level, _)| *level > at.y).or(self.layers.last());
                match (above.map_or(0, |layer| layer.1), self.full) {
                    (0, Some((level, full))) if at.y < level => full,
                    (material, _) => material,
                }
            }
        }
    }
}
