//! From a bridge to blocks: rings, piers and abutments, what they weigh and carry, and where each block came from.

mod backing;
mod build;
pub mod continuum;
pub mod cover;
mod curve;
mod defects;
mod discretised;
pub mod dispersal;
mod displaced;
mod error;
pub mod extrados;
pub mod fill;
pub mod laws;
pub mod mesh;
mod movement;
mod origin;
mod outline;
pub mod pressure;
pub mod ring_mesh;
mod rings;
pub mod springings;
mod supports;
mod voids;
pub mod wall;

use bridge::defect::{Defect, DefectKind, Face};
use bridge::{Bridge, Span};
use build::Build;
use curve::Curve;
pub use discretised::Discretised;
pub use error::DiscretiseError;
use mechanics::plane::Vec2;
pub use origin::{Faces, Origin};
pub use springings::bridge_length;
use supports::Skewback;

/// Cuts a bridge into blocks and brings cover and loads onto them: the strip that its plan names, that of the walls where
/// it names both.
///
/// # Errors
/// A part or a load that cannot be made of blocks; the message says what the file must change.
pub fn discretise(bridge: &Bridge) -> Result<Discretised, DiscretiseError> {
    let mut build = Build::new(bridge);
    let mut skewbacks = Vec::new();
    let places = springings::springings(bridge);
    let (mut spans, mut lines) = (Vec::new(), Vec::new());
    let mut built = f64::NEG_INFINITY;
    for (i, span) in bridge.spans.iter().enumerate() {
        let curve =
            Curve::new(span, places[i][0]).map_err(|misfit| DiscretiseError::Intrados { span: i + 1, misfit })?;
        let line = rings::extrados(span, &curve);
        let ends = [(0.0, line[0]), (1.0, line[line.len() - 1])];
        skewbacks.push(ends.map(|(share, extrados)| Skewback { intrados: curve.at(share).0, extrados }));
        lines.push(line);
        let sound = Span { defects: Vec::new(), ..span.clone() };
        built = built.max(highest(&rings::extrados(&sound, &curve)));
        spans.push(rings::cut(i, span, &curve)?);
    }
    let last = bridge.spans.len();
    build.abutment(0, skewbacks[0][0], -1.0)?;
    for (i, (rings, line)) in spans.into_iter().zip(lines).enumerate() {
        build.span(i, rings);
        build.extrados.line.extend(line);
        if let Some(pier) = bridge.piers.get(i) {
            build.pier(i + 1, pier, skewbacks[i][1], skewbacks[i + 1][0])?;
        }
    }
    build.abutment(last, skewbacks[last - 1][1], 1.0)?;
    build.extrados.lost = (built - highest(&build.extrados.line)).max(0.0);
    displaced::displaced(bridge, build.finish()?)
}

/// Highest level of a line [m].
fn highest(line: &[Vec2]) -> f64 {
    line.iter().map(|p| p.y).fold(f64::NEG_INFINITY, f64::max)
}

/// The line along which a defect of a span lies, from left to right [m]: the face that lost something, the joint that parted, the middle of
/// what is weak. Empty where the span has no curve.
pub fn defect_line(bridge: &Bridge, span: usize, defect: &Defect) -> Vec<Vec2> {
    let described = &bridge.spans[span];
    let Ok(curve) = Curve::new(described, springings::springings(bridge)[span][0]) else { return Vec::new() };
    const STEPS: usize = 48;
    let last = described.rings.len() - 1;
    let point = |step: usize| {
        let share = defect.shares[0] + (defect.shares[1] - defect.shares[0]) * step as f64 / STEPS as f64;
        let [lowest, highest] = [rings::faces(described, 0, share)[0], rings::faces(described, last, share)[1]];
        let offset = match defect.kind {
            DefectKind::LostMortar { face: Face::Extrados, .. } | DefectKind::ThinRing { face: Face::Extrados, .. } => {
                highest
            }
            DefectKind::OpenJoint { face, depth } => {
                let (open, closed) = if face == Face::Extrados { (highest, lowest) } else { (lowest, highest) };
                let part = (depth / (highest - lowest)).min(1.0) * step as f64 / STEPS as f64;
                open + (closed - open) * part
            }
            DefectKind::LostMortar { .. }
            | DefectKind::ThinRing { .. }
            | DefectKind::MissingStones
            | DefectKind::DroppedStones { .. } => lowest,
            DefectKind::RingSeparation { ring, .. } => rings::faces(described, ring, share)[1],
            DefectKind::WeakMasonry { ring: Some(ring), .. } => {
                rings::faces(described, ring, share).iter().sum::<f64>() * 0.5
            }
            DefectKind::WeakMasonry { ring: None, .. } => 0.5 * (lowest + highest),
        };
        curve.off(share, offset)
    };
    (0..=STEPS).map(point).collect()
}

#[cfg(test)]
mod road_tests;
#[cfg(test)]
mod spandrel_tests;
#[cfg(test)]
mod springing_tests;
#[cfg(test)]
mod support_tests;
#[cfg(test)]
mod tests;
