//! Two small circles at the haunches and a large one at the crown.

use super::arcs::Arcs;
use super::{Form, Misfit, Shape};
use crate::card::Field;
use crate::cards::*;

pub(super) const NEEDS: [bool; 2] = [true, true];
pub(super) const KEYS: &[Field] = &[length("haunch_radius", "radius of the two circles at the haunches", "2.0 m")
    .positive()
    .only("profile", &[Shape::ThreeCentred.word()])];

pub(super) fn size(span: Option<f64>, rise: Option<f64>, _: &mut f64) -> Option<(f64, f64)> {
    super::as_written(span, rise)
}

pub(super) fn curve(span: f64, rise: f64, haunch_radius: &f64) -> Result<Form, Misfit> {
    let half = 0.5 * span;
    if rise > half {
        return Err(Misfit::new(
            "B201",
            "rise",
            "the rise of a three-centred arch is more than half its span",
            format!("half the span is {half} m"),
            "check span and rise, or use profile = \"elliptical\"",
        ));
    }
    if !(*haunch_radius > 0.0 && *haunch_radius < rise) {
        return Err(Misfit::new(
            "B202",
            "haunch_radius",
            "the haunch circles leave no room for the crown circle",
            format!("must be less than the rise, {rise} m"),
            "give a haunch radius below the rise; around half the rise is common",
        ));
    }
    Form::half(Arcs::three_centred(span, rise, *haunch_radius))
}

pub(super) fn sloping(span: f64, rise: f64, right: f64, haunch_radius: &f64) -> Result<Form, Misfit> {
    let arcs = Arcs::three_centred_sloping(span, rise, right, *haunch_radius);
    Ok(arcs
        .ok_or_else(|| {
            Misfit::new(
                "B202",
                "haunch_radius",
                "no crown circle touches both haunch circles and passes through the rise in the middle",
                "too large for this rise and these springings",
                "give a smaller haunch radius, or more rise",
            )
        })?
        .whole())
}
