//! Two circular arcs that meet at a point in the crown.

use super::arcs::Arcs;
use super::{Form, Misfit};
use crate::card::Field;

pub(super) use super::as_written as size;
pub(super) const NEEDS: [bool; 2] = [true, true];
pub(super) const KEYS: &[Field] = &[];

pub(super) fn curve(span: f64, rise: f64) -> Result<Form, Misfit> {
    let half = 0.5 * span;
    if rise <= half {
        return Err(Misfit::new(
            "B203",
            "rise",
            "a pointed arch rises by more than half its span",
            format!("half the span is {half} m"),
            "check span and rise, or use profile = \"segmental\"",
        ));
    }
    Form::half(Arcs::pointed(span, rise))
}

pub(super) fn sloping(_: f64, _: f64, _: f64) -> Result<Form, Misfit> {
    Err(Misfit::new(
        "B229",
        "right_springing",
        "a pointed arch between springings at unequal levels is not drawn by its rise",
        "its two sides would meet at a place that nobody measured",
        "give its curve by points, with profile = \"measured\"",
    ))
}
