//! Colours and axes of figures of an update.

use crate::chart::Axis;
use outcome::calibrate::{Parameter, Scale};

/// Of records.
pub(super) const MEASURED: &str = "#222222";
/// Of the start model.
pub(super) const START: &str = "#d07a00";
/// Of the updated model.
pub(super) const UPDATED: &str = "#0b5394";

/// The axis of a parameter from one value to another, divided as its range is.
pub(super) fn axis<'a>(parameter: &Parameter, name: &'a str, [low, high]: [f64; 2], count: usize) -> Axis<'a> {
    match parameter.scale {
        Scale::Linear => Axis::exact(name, low, high, count),
        Scale::Logarithmic => Axis::logarithmic(name, low, high),
    }
}
