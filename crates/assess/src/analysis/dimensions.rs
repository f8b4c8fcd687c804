//! Dimensions of a drawing: every span and rise, piers, and thicknesses and heights where they differ from those before.

use bridge::{Bridge, Span};
use outcome::picture::{DimensionLine, Measure, Point};
use structure::discretise::cover::Surface;
use structure::discretise::springings::springings;

/// What an engineer measures first, on the bridge as built; `surface` is the road.
pub(super) fn dimensions(bridge: &Bridge, surface: &Surface) -> Vec<DimensionLine> {
    let mut found = Vec::new();
    let mut add = |measure, from, to| found.push(DimensionLine { measure, from, to });
    let (mut thickness_before, mut height_before) = (None, None);
    let places = springings(bridge);
    for (index, (span, [start, end])) in bridge.spans.iter().zip(&places).enumerate() {
        let (left, base) = (start.x, start.y);
        let (over, top) = crown(span);
        let over = left + over;
        add(Measure::Span, [left, base], [left + span.span, base]);
        if span.right_springing == 0.0 || !span.profile.has_rise() {
            add(Measure::Rise, [left, base], [over, base + span.rise]);
        } else {
            // Of the middle, above the line between the springings.
            let chord = base + 0.5 * span.right_springing;
            let middle = left + 0.5 * span.span;
            add(Measure::Rise, [middle, chord], [middle, chord + span.rise]);
        }
        // A millimetre is what a survey resolves.
        if span.right_springing.abs() > 1e-3 {
            add(Measure::Height, [end.x, base], [end.x, end.y]);
        }
        let thickness: f64 = span.rings.iter().map(|ring| ring.crown_thickness).sum();
        if thickness_before != Some(thickness)
            && let Some([from, to]) = across(span, thickness)
        {
            add(Measure::Thickness, [left + from[0], base + from[1]], [left + to[0], base + to[1]]);
            thickness_before = Some(thickness);
        }
        let back = base + top + thickness;
        if index + 1 == bridge.spans.len() && surface.at(over) > back + 1e-9 && !bridge.cover.layers.is_empty() {
            add(Measure::Depth, [over, back], [over, surface.at(over)]);
        }
        if let Some(pier) = bridge.piers.get(index) {
            let middle = end.x + 0.5 * pier.width;
            let springing = end.y + pier.step.min(0.0);
            add(Measure::Width, [end.x, end.y], [end.x + pier.width, end.y]);
            if height_before != Some(pier.height) {
                add(Measure::Height, [middle, springing - pier.height], [middle, springing]);
                height_before = Some(pier.height);
            }
        }
    }
    found
}

/// Distance of the crown from the left springing, and its level above it [m].
fn crown(span: &Span) -> (f64, f64) {
    let is_level = span.right_springing == 0.0;
    span.intrados().map_or((0.5 * span.span, span.rise), |curve| {
        (curve.crown(), if is_level { span.rise } else { curve.highest() })
    })
}

/// Both ends of the joint halfway along the intrados, all rings together.
fn across(span: &Span, thickness: f64) -> Option<[Point; 2]> {
    let middle = span.intrados().ok()?.at(0.5);
    Some([middle.offset(0.0), middle.offset(thickness)])
}
