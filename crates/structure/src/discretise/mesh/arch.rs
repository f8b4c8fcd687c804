//! A span's strip of rings: points of it, and where along it a condition is met.

use crate::discretise::curve::Curve;
use crate::discretise::rings::faces;
use bridge::Span;
use mechanics::plane::Vec2;

/// Steps in which a condition is looked for along half a span; between two steps it is halved further.
const STEPS: usize = 400;

/// The end of a span.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum End {
    /// Its left springing.
    Left,
    /// Its right springing.
    Right,
}

impl End {
    /// The share of the arc length that lies this share of it from the springing.
    pub fn share(self, from_springing: f64) -> f64 {
        match self {
            End::Left => from_springing,
            End::Right => 1.0 - from_springing,
        }
    }
}

/// The rings of a span where they stand in the bridge. Places along them are shares of the intrados' arc length.
pub(super) struct Arch<'a> {
    /// The span as the file has it.
    pub span: &'a Span,
    /// Its intrados.
    pub curve: Curve,
}

impl Arch<'_> {
    /// A point of ring `ring`, at a share of its depth from its intrados.
    pub(super) fn at(&self, share: f64, ring: usize, depth: f64) -> Vec2 {
        let [lower, upper] = faces(self.span, ring, share);
        self.curve.off(share, lower + depth * (upper - lower))
    }

    /// A point of the intrados.
    pub(super) fn intrados(&self, share: f64) -> Vec2 {
        self.at(share, 0, 0.0)
    }

    /// A point of the extrados.
    pub(super) fn extrados(&self, share: f64) -> Vec2 {
        self.at(share, self.span.rings.len() - 1, 1.0)
    }

    /// Length of the extrados between two shares [m].
    pub(super) fn extrados_length(&self, from: f64, to: f64) -> f64 {
        const CHORDS: usize = 8;
        let at = |k: usize| self.extrados(from + (to - from) * k as f64 / CHORDS as f64);
        (0..CHORDS).map(|k| (at(k + 1) - at(k)).norm()).sum()
    }

    /// Unit tangent of the extrados away from a springing, by the intrados' normal.
    pub(super) fn rising(&self, end: End, from_springing: f64) -> Vec2 {
        let (_, normal) = self.curve.at(end.share(from_springing));
        match end {
            End::Left => normal.right(),
            End::Right => normal.left(),
        }
    }

    /// The first share from the springing, up to `most`, at which `met` turns true.
    pub(super) fn first(&self, end: End, most: f64, met: impl Fn(Vec2, Vec2) -> bool) -> Option<f64> {
        let holds = |d: f64| met(self.extrados(end.share(d)), self.rising(end, d));
        let k = (0..=STEPS).find(|&k| holds(most * k as f64 / STEPS as f64))?;
        if k == 0 {
            return Some(0.0);
        }
        let (mut no, mut yes) = (most * (k - 1) as f64 / STEPS as f64, most * k as f64 / STEPS as f64);
        for _ in 0..40 {
            let middle = 0.5 * (no + yes);
            if holds(middle) { yes = middle } else { no = middle }
        }
        Some(yes)
    }
}
