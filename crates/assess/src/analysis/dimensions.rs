//! Dimensions of a drawing: every span and rise, piers, and thicknesses and heights where they differ from those before.

use bridge::ring::Intrados;
use bridge::{Bridge, Span};
use outcome::picture::{DimensionLine, Measure, Point};
use structure::discretise::cover::Surface;

/// What an engineer measures first, on the bridge as built; `surface` is the road.
pub fn dimensions(bridge: &Bridge, surface: &Surface) -> Vec<DimensionLine> {
    let mut found = Vec::new();
    let mut add = |measure, from, to| found.push(DimensionLine { measure, from, to });
    let (mut left, mut thickness_before, mut height_before) = (0.0, None, None);
    for (index, span) in bridge.spans.iter().enumerate() {
        let over = left + crown(span);
        add(Measure::Span, [left, 0.0], [left + span.span, 0.0]);
        add(Measure::Rise, [left, 0.0], [over, span.rise]);
        let thickness: f64 = span.rings.iter().map(|ring| ring.crown_thickness).sum();
        if thickness_before != Some(thickness)
            && let Some([from, to]) = across(span, thickness)
        {
            add(Measure::Thickness, [left + from[0], from[1]], [left + to[0], to[1]]);
            thickness_before = Some(thickness);
        }
        let back = span.rise + thickness;
        if index + 1 == bridge.spans.len() && surface.at(over) > back + 1e-9 && !bridge.cover.layers.is_empty() {
            add(Measure::Depth, [over, back], [over, surface.at(over)]);
        }
        left += span.span;
        if let Some(pier) = bridge.piers.get(index) {
            let middle = left + 0.5 * pier.width;
            add(Measure::Width, [left, 0.0], [left + pier.width, 0.0]);
            if height_before != Some(pier.height) {
                add(Measure::Height, [middle, -pier.height], [middle, 0.0]);
                height_before = Some(pier.height);
            }
            left += pier.width;
        }
    }
    found
}

/// Distance of the crown from the left springing [m].
fn crown(span: &Span) -> f64 {
    Intrados::new(&span.profile, span.span, span.rise).map_or(0.5 * span.span, |curve| curve.crown())
}

/// Both ends of the joint halfway along the intrados, all rings together.
fn across(span: &Span, thickness: f64) -> Option<[Point; 2]> {
    let middle = Intrados::new(&span.profile, span.span, span.rise).ok()?.at(0.5);
    Some([middle.offset(0.0), middle.offset(thickness)])
}
