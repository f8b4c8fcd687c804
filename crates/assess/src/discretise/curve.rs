//! The intrados as the discretisation needs it: points and normals by share of the arc length.

use bridge::Span;
use bridge::ring::Profile;
use mechanics::plane::{Vec2, vec2};

/// A span's intrados from its left springing, which lies at `origin`.
pub struct Curve {
    radius: f64,
    half_angle: f64,
    centre: Vec2,
    origin: Vec2,
}

impl Curve {
    /// The intrados of `span`.
    pub fn new(span: &Span, origin: Vec2) -> Result<Curve, String> {
        let (l, r) = match span.profile {
            Profile::Semicircular => (span.span, 0.5 * span.span),
            _ => (span.span, span.rise),
        };
        let radius = (0.25 * l * l + r * r) / (2.0 * r);
        let half_angle = (l / (2.0 * radius)).min(1.0).asin();
        let half_angle = if r > radius { std::f64::consts::PI - half_angle } else { half_angle };
        Ok(Curve { radius, half_angle, centre: vec2(0.5 * l, r - radius), origin })
    }
    /// Point and outward unit normal at a share of the arc length, 0 at the left springing and 1 at the right.
    pub fn at(&self, share: f64) -> (Vec2, Vec2) {
        let a = self.half_angle * (2.0 * share - 1.0);
        let n = vec2(a.sin(), a.cos());
        (self.origin + self.centre + n * self.radius, n)
    }
}
