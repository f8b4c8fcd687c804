//! Which weight has its adverse factor and which its favourable one: dead load may load an arch or hold it together.
//!
//! The greatest load factor is the optimum of a program with convex limits in which weights stand on the right side, so it
//! is a concave function of them: over all weights between their favourable and adverse values it is least where every
//! group has one or the other. Trying those combinations therefore leaves nothing out.

use bridge::{Bridge, LayerKind};
use outcome::vehicles::Weights;
use rules::Rule;

/// Whether a layer counts as surfacing: laid on top, renewed and thickened over the years.
fn is_surfacing(layer: LayerKind) -> bool {
    matches!(layer, LayerKind::Surfacing | LayerKind::Ballast)
}

/// Every combination of adverse and favourable factors on the weights that a bridge has; the one that is adverse throughout
/// comes first.
pub(super) fn combinations(bridge: &Bridge, rule: &Rule) -> Vec<Weights> {
    let (f, favourable) = (&rule.factors, rule.factors.weight_favourable.value);
    let of = |adverse: f64| match adverse == favourable {
        true => vec![adverse],
        false => vec![adverse, favourable],
    };
    let weighs = |wanted: bool| bridge.cover.layers.iter().any(|l| l.weighs && is_surfacing(l.name) == wanted);
    let optional = |there: bool, adverse: f64| match there {
        true => of(adverse).into_iter().map(Some).collect(),
        false => vec![None],
    };
    let fills = optional(bridge.cover.backing.is_some() || weighs(false), f.fill_weight.value);
    let surfacings = optional(weighs(true), f.surfacing_weight.value);
    let mut list = Vec::new();
    for masonry in of(f.masonry_weight.value) {
        for &fill in &fills {
            list.extend(surfacings.iter().map(|&surfacing| Weights { masonry, fill, surfacing }));
        }
    }
    list
}

/// Puts the factors on the weights of a bridge.
pub(super) fn put(weights: &Weights, on: &mut Bridge) {
    on.masonry.density *= weights.masonry;
    if let Some(wall) = &mut on.spandrel_wall {
        wall.density *= weights.masonry;
    }
    for layer in &mut on.cover.layers {
        let factor = if is_surfacing(layer.name) { weights.surfacing } else { weights.fill };
        layer.density *= factor.unwrap_or(1.0);
    }
    if let (Some(water), Some(lowest)) = (&mut on.cover.water, on.cover.layers.first()) {
        let factor = if is_surfacing(lowest.name) { weights.surfacing } else { weights.fill };
        water.saturated_density *= factor.unwrap_or(1.0);
    }
    if let Some(backing) = &mut on.cover.backing {
        backing.density *= weights.fill.unwrap_or(1.0);
    }
    if let Some(walls) = &mut on.cover.internal_walls {
        walls.density *= weights.masonry;
    }
    // Soil of no density of its own is that of the lowest layer, which has its factor.
    for body in on.abutments.iter_mut().filter_map(|abutment| abutment.body.as_mut()) {
        body.earth_density = body.earth_density.map(|density| density * weights.fill.unwrap_or(1.0));
    }
}
