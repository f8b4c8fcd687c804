//! A parabolic intrados, its vertex in the crown. The left half only.

use std::sync::Arc;

use super::invert::invert;
use super::{Curve, Form, Misfit, Station};
use crate::card::Field;

pub(super) use super::as_written as size;
pub(super) const NEEDS: [bool; 2] = [true, true];
pub(super) const KEYS: &[Field] = &[];

pub(super) fn curve(span: f64, rise: f64) -> Result<Form, Misfit> {
    Form::half(Parabola { half: 0.5 * span, rise })
}

pub(super) fn sloping(span: f64, rise: f64, right: f64) -> Result<Form, Misfit> {
    let crown = 0.5 * span * (1.0 + right / (4.0 * rise));
    Ok(Form::Whole { curve: Arc::new(Sloping { span, rise, right }), crown: crown.clamp(0.0, span) })
}

/// y = right u + 4 rise u (1 - u) with u = x / span: the same parabola, its vertex beside the middle.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Sloping {
    span: f64,
    rise: f64,
    right: f64,
}

impl Sloping {
    /// Slope at a share of the span.
    fn slope(&self, u: f64) -> f64 {
        (self.right + 4.0 * self.rise * (1.0 - 2.0 * u)) / self.span
    }

    /// Length from the left springing: span² / (8 rise) times the integral of √(1 + p²) over the slope p.
    fn length_to(&self, u: f64) -> f64 {
        let integral = |p: f64| 0.5 * (p * p.hypot(1.0) + p.asinh());
        self.span * self.span / (8.0 * self.rise) * (integral(self.slope(0.0)) - integral(self.slope(u)))
    }
}

impl Curve for Sloping {
    fn length(&self) -> f64 {
        self.length_to(1.0)
    }

    fn at(&self, distance: f64) -> Station {
        let u = invert(|u| self.length_to(u), |u| self.span * self.slope(u).hypot(1.0), distance, 1.0);
        let slope = self.slope(u);
        let steep = slope.hypot(1.0);
        Station {
            point: [self.span * u, self.right * u + 4.0 * self.rise * u * (1.0 - u)],
            normal: [-slope / steep, 1.0 / steep],
        }
    }
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
