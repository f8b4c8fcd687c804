//! Outlines of a span's voussoirs.
//!
//! Joints run along the normal of the intrados at equal steps of its arc length; faces are flat (chords). Where rings
//! lie upon one another, the upper ring's beds are its chords, and the backs of the lower ring are cut along them: the
//! lower voussoirs get a corner where a joint of the upper ring falls on their back. That way two rings with different
//! numbers of voussoirs fit without gap or overlap and every voussoir stays convex.

use super::curve::Curve;
use super::{DiscretiseError, Faces};
use bridge::Span;
use bridge::defect::{Face, raked, thinned};
use mechanics::plane::{Polygon, Vec2};

/// Share of a voussoir below which a joint of the upper ring is moved onto the joint it nearly meets: thinner slivers
/// of a back would be rounded away.
const SLIVER: f64 = 0.05;

/// A ring's joints: where along the intrados, and the lower and upper end of each.
struct Joints {
    shares: Vec<f64>,
    lower: Vec<Vec2>,
    upper: Vec<Vec2>,
}

/// Distance of a ring's lower and upper face from the intrados of the span as it was built, along its normal, at a share of the arc length
/// [m]: less what stones have lost.
pub(super) fn faces(span: &Span, ring: usize, share: f64) -> [f64; 2] {
    let below: f64 = span.rings[..ring].iter().map(|r| r.thickness(share)).sum();
    let lost = |face: Face, is_outer: bool| {
        if is_outer { thinned(&span.defects, face, share, span.rings[ring].voussoirs) } else { 0.0 }
    };
    let upper = below + span.rings[ring].thickness(share);
    [below + lost(Face::Intrados, ring == 0), upper - lost(Face::Extrados, ring + 1 == span.rings.len())]
}

/// The voussoirs of every ring of `span`, from the intrados up, each from left to right: outlines, counter-clockwise from the left intrados
/// corner, and faces.
pub(super) fn cut(index: usize, span: &Span, curve: &Curve) -> Result<Vec<Vec<(Polygon, Faces)>>, DiscretiseError> {
    let joints = joints(span, curve);
    let mut rings = Vec::new();
    for (k, ring) in span.rings.iter().enumerate() {
        let own = &joints[k];
        let mut cuts = Vec::with_capacity(ring.voussoirs);
        for i in 0..ring.voussoirs {
            let mut outline = vec![own.lower[i], own.lower[i + 1], own.upper[i + 1]];
            if let Some(above) = joints.get(k + 1) {
                // Corners of the bed above that fall on this back, right to left.
                let inside = |s: f64| s > own.shares[i] + 1e-9 && s < own.shares[i + 1] - 1e-9;
                let corners = above.shares.iter().zip(&above.lower).filter(|(s, _)| inside(**s));
                outline.extend(corners.rev().map(|(_, p)| *p));
            }
            outline.push(own.upper[i]);
            let outline = raked_joints(span, k, own, i, outline);
            let outline = Polygon::new(outline).map_err(|source| DiscretiseError::Voussoir {
                span: index + 1,
                ring: k + 1,
                voussoir: i + 1,
                source,
            })?;
            let [bed, back] = [&own.lower, &own.upper].map(|ends| [ends[i], ends[i + 1]]);
            cuts.push((outline, Faces { bed, back }));
        }
        rings.push(cuts);
    }
    Ok(rings)
}

/// How far the corner of a stone stands free of its neighbour where mortar is lost [m]. Only the depth decides what the joint carries; a real
/// joint is wider, and stones lose no weight with their mortar.
const HALF_JOINT: f64 = 2e-4;

/// Most of a stone's face that a corner of it stands free.
const MOST_OF_A_FACE: f64 = 0.2;

/// Least depth without mortar that is modelled [m].
const LEAST_RAKED: f64 = 1e-4;

/// The outline of a voussoir, first its lower corners, then its back, without the corners that no mortar holds any more.
fn raked_joints(span: &Span, ring: usize, own: &Joints, i: usize, outline: Vec<Vec2>) -> Vec<Vec2> {
    let last = outline.len() - 1;
    let depth = |corner: usize| {
        let share = own.shares[if corner == 0 || corner == last { i } else { i + 1 }];
        let face = match corner {
            0 | 1 if ring == 0 => Face::Intrados,
            2 if ring + 1 == span.rings.len() => Face::Extrados,
            _ if corner == last && ring + 1 == span.rings.len() => Face::Extrados,
            _ => return 0.0,
        };
        raked(&span.defects, face, share, span.rings[ring].voussoirs)
    };
    let mut cut = Vec::with_capacity(outline.len() + 4);
    for (corner, &at) in outline.iter().enumerate() {
        let depth = depth(corner);
        if depth < LEAST_RAKED {
            cut.push(at);
            continue;
        }
        let (before, after) = (outline[(corner + last) % (last + 1)], outline[(corner + 1) % (last + 1)]);
        let towards = |to: Vec2, far: f64| at + (to - at) * (far / (to - at).norm());
        let along = |to: Vec2| towards(to, HALF_JOINT.min(MOST_OF_A_FACE * (to - at).norm()));
        if corner == 0 || corner == 2 {
            // The joint comes before the corner, and the face after it.
            cut.extend([towards(before, depth), along(after)]);
        } else {
            cut.extend([along(before), towards(after, depth)]);
        }
    }
    cut
}

/// Steps in which the curve of the extrados is drawn: chords so short depart from it by less than a thousandth of a
/// millimetre.
const FINE: usize = 1024;

/// The extrados of the uppermost ring as a curve, from left to right.
pub(super) fn extrados(span: &Span, curve: &Curve) -> Vec<Vec2> {
    let point = |i: usize| {
        let share = i as f64 / FINE as f64;
        curve.off(share, faces(span, span.rings.len() - 1, share)[1])
    };
    (0..=FINE).map(point).collect()
}

/// Joints of every ring, with the backs of lower rings cut along the beds above them.
fn joints(span: &Span, curve: &Curve) -> Vec<Joints> {
    let mut rings: Vec<Joints> = Vec::new();
    for (k, ring) in span.rings.iter().enumerate() {
        let n = ring.voussoirs;
        let shares: Vec<f64> = (0..=n)
            .map(|i| {
                let share = i as f64 / n as f64;
                let snapped = rings.last().and_then(|below: &Joints| {
                    // A little less than the round number: no two counts of voussoirs may lie on the limit, where round-off
                    // would treat one end of the bridge otherwise than the other.
                    let reach = SLIVER / n.max(below.shares.len() - 1) as f64 - 1e-9;
                    below.shares.iter().copied().find(|s| (s - share).abs() < reach)
                });
                snapped.unwrap_or(share)
            })
            .collect();
        let [lower, upper] = [0, 1].map(|face| shares.iter().map(|&s| curve.off(s, faces(span, k, s)[face])).collect());
        rings.push(Joints { shares, lower, upper });
    }
    for k in 1..rings.len() {
        let (below, above) = rings.split_at_mut(k);
        let (below, above) = (&mut below[k - 1], &above[0]);
        for (i, &share) in below.shares.iter().enumerate() {
            below.upper[i] = on_bed(curve, share, above);
        }
    }
    rings
}

/// Where the normal of the intrados at `share` meets the beds of `above`.
fn on_bed(curve: &Curve, share: f64, above: &Joints) -> Vec2 {
    let j = above.shares.partition_point(|&s| s < share - 1e-12);
    if (above.shares[j] - share).abs() <= 1e-12 {
        return above.lower[j];
    }
    let (a, b) = (above.lower[j - 1], above.lower[j]);
    let (point, normal) = curve.at(share);
    let chord = b - a;
    a + chord * ((point - a).cross(normal) / chord.cross(normal))
}
