//! A segment of a circle.

use super::arcs::Arcs;
use super::{Form, Misfit};
use crate::card::Field;

pub(super) use super::as_written as size;
pub(super) const NEEDS: [bool; 2] = [true, true];
pub(super) const KEYS: &[Field] = &[];

pub(super) fn curve(span: f64, rise: f64) -> Result<Form, Misfit> {
    let half = 0.5 * span;
    if rise > half {
        return Err(Misfit::new(
            "B201",
            "rise",
            "the rise of a segment is more than half its span",
            format!("half the span is {half} m"),
            "check span and rise, or use profile = \"pointed\" or \"elliptical\"",
        ));
    }
    Form::half(Arcs::segment(span, rise))
}

pub(super) fn sloping(span: f64, rise: f64, right: f64) -> Result<Form, Misfit> {
    let arcs = Arcs::through(span, rise, right);
    if arcs.leans_back() {
        return Err(Misfit::new(
            "B201",
            "rise",
            "the circle through both springings and the middle would turn back below a springing",
            "higher than half a circle on that side",
            "check span, rise and right_springing, or use profile = \"elliptical\"",
        ));
    }
    Ok(arcs.whole())
}
