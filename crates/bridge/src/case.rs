//! Named cases of a bridge file: which loads act together, with which factors, on which weights and values.

use crate::model::{Bridge, LayerKind, LoadKind};
use crate::vary::Request;

/// A case.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Its name.
    pub name: String,
    /// The loads of the file that act, by their place among them, with their factors.
    pub loads: Vec<(usize, f64)>,
    /// Factor on the weight of rings, piers and walls.
    pub masonry_weight: f64,
    /// Factor on the weight of fill and backing.
    pub fill_weight: f64,
    /// Factor on the weight of surfacing and ballast.
    pub surfacing_weight: f64,
    /// Quantities of the file that are otherwise in this case; one value each.
    pub changes: Vec<Request>,
}

impl Case {
    /// The bridge with the loads and weights of this case. Changes are for the file's text, before it is read.
    pub fn put(&self, bridge: &Bridge) -> Bridge {
        let mut b = bridge.clone();
        b.loads =
            self.loads.iter().filter_map(|(load, factor)| Some(times(bridge.loads.get(*load)?, *factor))).collect();
        b.masonry.density *= self.masonry_weight;
        if let Some(wall) = &mut b.spandrel_wall {
            wall.density *= self.masonry_weight;
        }
        for layer in &mut b.cover.layers {
            layer.density *= if is_surfacing(layer.name) { self.surfacing_weight } else { self.fill_weight };
        }
        if let (Some(water), Some(lowest)) = (&mut b.cover.water, b.cover.layers.first()) {
            water.saturated_density *= if is_surfacing(lowest.name) { self.surfacing_weight } else { self.fill_weight };
        }
        if let Some(backing) = &mut b.cover.backing {
            backing.density *= self.fill_weight;
        }
        b
    }
}

/// Whether a layer counts as surfacing: laid on top, renewed and thickened over the years.
pub fn is_surfacing(layer: LayerKind) -> bool {
    matches!(layer, LayerKind::Surfacing | LayerKind::Ballast)
}

fn times(load: &crate::model::Load, factor: f64) -> crate::model::Load {
    let mut load = load.clone();
    match &mut load.kind {
        LoadKind::KnifeEdge { force, .. } => *force *= factor,
        LoadKind::Patch { pressure, .. } => *pressure *= factor,
        LoadKind::Axles { axles, .. } => axles.iter_mut().for_each(|(force, _)| *force *= factor),
    }
    load
}
