//! Half a circle.

use super::arcs::Arcs;
use super::{Form, Misfit};
use crate::card::Field;

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

/// Rise of the middle above the line between the springings [m], where the lower one lies on the diameter and the other one higher.
pub(super) fn sloping_rise(span: f64, right: f64) -> f64 {
    let radius = radius(span, right);
    let across = radius - 0.5 * span;
    (radius * radius - across * across).sqrt() - 0.5 * right.abs()
}

/// Radius of the circle that rises upright from the lower springing and passes through the other [m].
fn radius(span: f64, right: f64) -> f64 {
    (span * span + right * right) / (2.0 * span)
}

/// The circle is cut where the higher springing lies.
pub(super) fn sloping(span: f64, _: f64, right: f64) -> Result<Form, Misfit> {
    Ok(Arcs::cut_semicircle(span, right, radius(span, right)).whole())
}
