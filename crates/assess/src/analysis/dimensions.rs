//! Dimensions of a drawing: spans, piers, and rise and thickness of the first span.

use crate::outcome::{Dimension, Measure, Point};
use bridge::ring::{Intrados, Profile};
use bridge::{Bridge, Span};

/// What an engineer measures first, on the bridge as built.
pub fn dimensions(bridge: &Bridge) -> Vec<Dimension> {
    let mut found = Vec::new();
    let mut add = |measure, from, to| found.push(Dimension { measure, from, to });
    let mut left = 0.0;
    for (index, span) in bridge.spans.iter().enumerate() {
        add(Measure::Span, [left, 0.0], [left + span.span, 0.0]);
        if index == 0 {
            add(Measure::Rise, [left, 0.0], [left + crown(span), span.rise]);
            if let Some([from, to]) = across(span) {
                add(Measure::Thickness, [left + from[0], from[1]], [left + to[0], to[1]]);
            }
        }
        left += span.span;
        if let Some(pier) = bridge.piers.get(index) {
            if index == 0 {
                let middle = left + 0.5 * pier.width;
                add(Measure::Height, [middle, -pier.height], [middle, 0.0]);
            }
            left += pier.width;
        }
    }
    found
}

/// Distance of the crown from the left springing [m].
fn crown(span: &Span) -> f64 {
    match &span.profile {
        Profile::Measured(points) => {
            points.iter().copied().max_by(|a, b| a[1].total_cmp(&b[1])).map_or(0.5 * span.span, |point| point[0])
        }
        _ => 0.5 * span.span,
    }
}

/// Both ends of the joint halfway along the intrados, all rings together.
fn across(span: &Span) -> Option<[Point; 2]> {
    let middle = Intrados::new(&span.profile, span.span, span.rise).ok()?.at(0.5);
    let thickness: f64 = span.rings.iter().map(|ring| ring.crown_thickness).sum();
    Some([middle.offset(0.0), middle.offset(thickness)])
}
