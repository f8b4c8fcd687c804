//! A parabolic intrados, its vertex in the crown. The left half only.

use super::invert::invert;
use super::{Curve, Form, Misfit, Station};
use crate::fields::Field;

pub(super) use super::as_written as size;
pub(super) const NEEDS: [bool; 2] = [true, true];
pub(super) const KEYS: &[Field] = &[];

pub(super) fn curve(span: f64, rise: f64) -> Result<Form, Misfit> {
    Form::half(Parabola { half: 0.5 * span, rise })
}

/// y = rise (1 - u²) with u = 1 at the springing and 0 in the crown.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Parabola {
    half: f64,
    rise: f64,
}

impl Parabola {
    /// Slope at the springing.
    fn slope(&self) -> f64 {
        2.0 * self.rise / self.half
    }

    /// Length from the crown to u: half/2 (u √(1 + p²u²) + asinh(pu) / p).
    fn length_to_crown(&self, u: f64) -> f64 {
        let p = self.slope();
        let pu = p * u;
        0.5 * self.half * (u * pu.hypot(1.0) + pu.asinh() / p)
    }
}

impl Curve for Parabola {
    fn length(&self) -> f64 {
        self.length_to_crown(1.0)
    }

    fn at(&self, distance: f64) -> Station {
        let target = self.length() - distance;
        let p = self.slope();
        let u = invert(|u| self.length_to_crown(u), |u| self.half * (p * u).hypot(1.0), target, 1.0);
        let steep = (p * u).hypot(1.0);
        Station {
            point: [self.half * (1.0 - u), self.rise * (1.0 - u) * (1.0 + u)],
            normal: [-p * u / steep, 1.0 / steep],
        }
    }
}
