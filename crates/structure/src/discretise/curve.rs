//! The intrados of a span where it stands in the bridge.

use bridge::Span;
use bridge::ring::{Intrados, Misfit};
use mechanics::plane::{Vec2, vec2};

/// A span's intrados from its left springing, which lies at `origin`.
pub(super) struct Curve {
    intrados: Intrados,
    origin: Vec2,
}

impl Curve {
    /// The intrados of `span`.
    pub(super) fn new(span: &Span, origin: Vec2) -> Result<Curve, Misfit> {
        Ok(Curve { intrados: span.intrados()?, origin })
    }
    /// Point and outward unit normal at a share of the arc length, 0 at the left springing and 1 at the right.
    pub(super) fn at(&self, share: f64) -> (Vec2, Vec2) {
        let station = self.intrados.at(share);
        (self.origin + vec2(station.point[0], station.point[1]), vec2(station.normal[0], station.normal[1]))
    }
    /// Point at a share of the arc length, so far out along the normal [m].
    pub(super) fn off(&self, share: f64, distance: f64) -> Vec2 {
        let (point, normal) = self.at(share);
        point + normal * distance
    }
}
