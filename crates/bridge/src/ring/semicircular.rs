//! Half a circle.

use super::arcs::Arcs;
use super::{Form, Misfit};
use crate::fields::Field;

pub(super) const NEEDS: [bool; 2] = [true, false];
pub(super) const KEYS: &[Field] = &[];

pub(super) fn size(span: Option<f64>, _: Option<f64>) -> Option<(f64, f64)> {
    span.map(|span| (span, 0.5 * span))
}

pub(super) fn curve(span: f64, rise: f64) -> Result<Form, Misfit> {
    let half = 0.5 * span;
    // Half a span that is written in another unit differs by rounding.
    if (rise - half).abs() > 1e-9 * half {
        return Err(Misfit::new(
            "B201",
            "span",
            "the rise of a semicircle is not half its span",
            format!("half the span is {half} m"),
            "remove the rise, or use profile = \"segmental\"",
        ));
    }
    Form::half(Arcs { circle: Some(half), ..Arcs::segment(span, half) })
}
