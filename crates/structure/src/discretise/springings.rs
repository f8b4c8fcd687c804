//! Where the spans stand: their springings, and what is measured from these.

use bridge::Bridge;
use mechanics::plane::{Vec2, vec2};

/// Left and right springing of every span at the intrados [m], from the left springing of the first span.
pub fn springings(bridge: &Bridge) -> Vec<[Vec2; 2]> {
    let (mut x, mut y) = (0.0, 0.0);
    let mut list = Vec::with_capacity(bridge.spans.len());
    for (i, span) in bridge.spans.iter().enumerate() {
        list.push([vec2(x, y), vec2(x + span.span, y + span.right_springing)]);
        x += span.span + bridge.piers.get(i).map_or(0.0, |pier| pier.width);
        y += span.right_springing + bridge.piers.get(i).map_or(0.0, |pier| pier.step);
    }
    list
}

/// From springing to springing of every span [m].
pub fn ranges(bridge: &Bridge) -> Vec<[f64; 2]> {
    springings(bridge).into_iter().map(|ends| ends.map(|springing| springing.x)).collect()
}

/// Differences that a survey cannot tell [m].
const LEVEL: f64 = 1e-3;

/// Whether all springings lie on one level.
pub fn are_level(bridge: &Bridge) -> bool {
    springings(bridge).iter().flatten().all(|springing| springing.y.abs() <= LEVEL)
}

/// Distance between the outer springings, at the intrados [m].
pub fn bridge_length(bridge: &Bridge) -> f64 {
    bridge.spans.iter().map(|s| s.span).sum::<f64>() + bridge.piers.iter().map(|p| p.width).sum::<f64>()
}
