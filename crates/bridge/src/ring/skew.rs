//! A span that is known square to its springings: what it is along the road.
//!
//! A barrel is a cylinder. Its section along the road is the one square to the springings, stretched horizontally by 1 / cos(skew) at
//! the same height: half a circle becomes half an ellipse, a segment of a circle a piece of an ellipse.

use super::{Intrados, Misfit, Profile, Shape, Size, WITH_SPAN};
use crate::findings::Findings;
use crate::tree::{At, Table};

/// Points of the stretched curve, from springing to springing: between them it is off by less than a thousandth of a millimetre in ten
/// metres (test).
const POINTS: usize = 240;

/// The span as its profile needs it [m], where the file gives one, and by how much the profile is stretched along the road, where the file
/// gives the square span. None where something is wrong, which has been reported.
pub(super) fn span(
    table: &Table<'_>,
    shape: Option<Shape>,
    findings: &mut Findings,
) -> Option<(Option<f64>, Option<f64>)> {
    let span: Option<Option<f64>> = table.read("span", findings);
    let square: Option<Option<At<f64>>> = table.read("square_span", findings);
    let skew: Option<Option<f64>> = table.read("skew", findings);
    let needed = shape.is_some_and(|shape| WITH_SPAN.contains(&shape.word()));
    match (table.has("span"), table.has("square_span")) {
        (false, false) if needed => table.need("span", findings),
        (true, true) => table.exclude("square_span", "`span`, which runs along the road", findings),
        (false, true) if !table.has("skew") => table.need("skew", findings),
        (false, true) => Some((Some(square??.value), Some(1.0 / skew??.cos()))),
        _ => Some((span?, None)),
    }
}

/// The profile along the road, its span and rise.
pub(super) fn along_the_road(
    table: &Table<'_>,
    profile: &Profile,
    size: Size,
    stretch: f64,
    findings: &mut Findings,
) -> Option<(Profile, Size)> {
    let stretched = match profile {
        _ if stretch == 1.0 => profile.clone(),
        Profile::Elliptical => Profile::Elliptical,
        Profile::Semicircular if size.right == 0.0 => Profile::Elliptical,
        Profile::Parabolic => Profile::Parabolic,
        Profile::Semicircular | Profile::Segmental | Profile::ThreeCentred { .. } => {
            match points(profile, size, stretch) {
                Ok(points) => Profile::Measured { points },
                Err(misfit) => {
                    let key = if misfit.key == "span" { "square_span" } else { misfit.key };
                    return findings.refuse(misfit.code, table.place(key), misfit.message, misfit.label, misfit.help);
                }
            }
        }
        Profile::Pointed | Profile::Measured { .. } => {
            return findings.refuse(
                "B228",
                table.place("square_span"),
                format!("the square section of a {} span is not turned into the one along the road", profile.word()),
                "the shape along the road is wanted",
                "give `span` along the road, and the shape that its face shows",
            );
        }
    };
    Some((stretched, Size { span: size.span * stretch, ..size }))
}

/// Points of the stretched curve, mirrored to the last bit.
fn points(profile: &Profile, size: Size, stretch: f64) -> Result<Vec<[f64; 2]>, Misfit> {
    let square = Intrados::between(profile, size.span, size.rise, size.right)?;
    let point = |k: usize| {
        let [x, y] = square.at(k as f64 / POINTS as f64).point;
        let level = match k {
            0 => 0.0,
            POINTS => size.right,
            _ => y,
        };
        [stretch * x, level]
    };
    Ok((0..=POINTS).map(point).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The stretched circle has an equation: what is drawn lies on it everywhere, and is the square section where there is no skew.
    #[test]
    fn a_stretched_segment_lies_on_its_ellipse() {
        let (span, rise) = (10.0f64, 2.5f64);
        let radius = (25.0 + rise * rise) / (2.0 * rise);
        for degrees in [0.0f64, 5.0, 20.0, 45.0, 60.0] {
            let stretch = 1.0 / degrees.to_radians().cos();
            let points = points(&Profile::Segmental, Size { span, rise, right: 0.0 }, stretch).unwrap();
            let along = Intrados::between(&Profile::Measured { points }, span * stretch, rise, 0.0).unwrap();
            for k in 0..=1777 {
                let station = along.at(k as f64 / 1777.0);
                let [x, y] = station.point;
                let across = x / stretch - 0.5 * span;
                let off = across.hypot(y - rise + radius) - radius;
                assert!(off.abs() < 1e-6, "{degrees} degrees, {k}: {off:e}");
                let normal = [across / stretch, y - rise + radius];
                let size = normal[0].hypot(normal[1]);
                let turned =
                    (normal[0] / size - station.normal[0]).abs().max((normal[1] / size - station.normal[1]).abs());
                assert!(turned < 2e-3, "{degrees} degrees, {k}: {turned:e}");
            }
        }
    }
}
