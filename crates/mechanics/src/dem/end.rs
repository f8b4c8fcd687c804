//! One end of the common stretch of two faces: a corner of the reference block beside a corner of the incident block.
//!
//! Which of the two corners carries decides the direction of the force. Where the joint opens away from this end (a
//! hinge), the cores are convex to one another: corner on edge, corner on corner and edge on corner follow one another
//! smoothly, and the distance is exact. Where the joint closes away from this end, both corners press at once; the
//! point then changes hands over a short stretch. In every case the force is the gradient of the distance, so that
//! contacts give back the energy they take.

use crate::plane::{Vec2, vec2};

/// Half the stretch over which a point changes hands in a closing joint, as a share of the reference edge: a few
/// hundredths of a millimetre in a voussoir, far below any slip that matters, yet so long that the change of direction
/// adds next to nothing to the shear stiffness.
const BLEND: f64 = 1e-4;

/// A contact point at one end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct End {
    /// How far inside the reference edge it lies [m].
    pub inset: f64,
    /// Distance of the two cores [m].
    pub distance: f64,
    /// Direction of the force on the incident block: inwards along the reference edge, and along its normal.
    pub push: Vec2,
    /// Height above the reference core's edge at which the tangential part of the force acts [m].
    pub height: f64,
}

/// The contact point of an end whose incident corner lies `s` inside the reference edge and `g` above it [m], with
/// the gap growing by `slope` per metre inwards. `length` is that of the reference edge.
#[inline(always)]
pub(super) fn end(s: f64, g: f64, slope: f64, length: f64) -> End {
    let straight = vec2(0.0, 1.0);
    let blend = BLEND * length;
    if slope >= 0.0 {
        if s >= 0.0 {
            // Incident corner on the reference edge.
            return End { inset: s, distance: g, push: straight, height: g };
        }
        if -s >= g * slope || g <= 0.0 {
            // Reference corner on the incident edge.
            let cos = 1.0 / (1.0 + slope * slope).sqrt();
            return End { inset: 0.0, distance: (g - s * slope) * cos, push: vec2(-slope * cos, cos), height: 0.0 };
        }
        // Corner on corner.
        let distance = (s * s + g * g).sqrt();
        return End { inset: 0.0, distance, push: vec2(s / distance, g / distance), height: 0.0 };
    }
    if s >= blend {
        return End { inset: s, distance: g, push: straight, height: g };
    }
    // `max(s, 0)` with a parabola in place of its kink, and its slope.
    let t = (s + blend).max(0.0);
    let (soft, rate) = (t * t / (4.0 * blend), t / (2.0 * blend));
    let distance = g + (soft - s) * slope;
    End { inset: s.max(0.0), distance, push: vec2(slope * (rate - 1.0), 1.0), height: distance }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sliding the incident block inwards by `h` moves `s` by `h` and changes the distance by `push.x * h`; lifting it
    /// changes the distance by `push.y * h`. Central differences over 1 nm see that to 1e-6.
    #[test]
    fn the_push_is_the_gradient_of_the_distance() {
        let h = 1e-9;
        for slope in [-2e-2, -3e-4, 0.0, 4e-4, 3e-2] {
            for s in [-1e-3, -4e-4, -3e-5, -1e-6, 0.0, 2e-6, 4e-5, 2e-3] {
                let g = 0.019;
                let at = end(s, g, slope, 0.691);
                let along = (end(s + h, g, slope, 0.691).distance - end(s - h, g, slope, 0.691).distance) / (2.0 * h);
                let across = (end(s, g + h, slope, 0.691).distance - end(s, g - h, slope, 0.691).distance) / (2.0 * h);
                // The kink of slope zero at s = 0 has no gradient; every other point does.
                assert!((along - at.push.x).abs() < 1e-6 + slope.abs() * 1e-4, "{slope} {s}: {along} {:?}", at);
                assert!((across - at.push.y).abs() < 1e-6, "{slope} {s}: {across} {:?}", at);
            }
        }
    }
}
