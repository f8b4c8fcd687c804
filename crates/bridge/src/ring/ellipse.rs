//! An elliptical intrados. The left half only.

use std::sync::Arc;

use super::invert::invert;
use super::quadrature::quadrature;
use super::{Curve, Form, Misfit, Station};
use crate::card::Field;

pub(super) use super::as_written as size;
pub(super) const NEEDS: [bool; 2] = [true, true];
pub(super) const KEYS: &[Field] = &[];

pub(super) fn curve(span: f64, rise: f64) -> Result<Form, Misfit> {
    Form::half(Ellipse { half: 0.5 * span, rise })
}

/// Half an ellipse, sheared: upright at both springings, as a rampant arch is.
pub(super) fn sloping(span: f64, rise: f64, right: f64) -> Result<Form, Misfit> {
    let curve = Sloping::new(0.5 * span, rise, right);
    let crown = curve.point((2.0 * rise).atan2(-right))[0];
    Ok(Form::Whole { curve: Arc::new(curve), crown })
}

/// x = half (1 - cos t), y = right (1 - cos t) / 2 + rise sin t, with t = 0 at the left springing and π at the right one.
#[derive(Debug, Clone, PartialEq)]
struct Sloping {
    half: f64,
    rise: f64,
    right: f64,
    /// Lengths from the left springing to the ends of the panels.
    lengths: Vec<f64>,
}

/// Panels of the quadrature from springing to springing: to the last digits for a rise of a tenth of the span.
const PANELS: usize = 32;

impl Sloping {
    fn new(half: f64, rise: f64, right: f64) -> Sloping {
        let mut curve = Sloping { half, rise, right, lengths: vec![0.0] };
        for panel in 0..PANELS {
            let [from, to] = [panel, panel + 1].map(Sloping::end);
            let length = curve.lengths[panel] + quadrature(to - from, 1, |t| curve.speed(from + t));
            curve.lengths.push(length);
        }
        curve
    }

    /// Where a panel begins.
    fn end(panel: usize) -> f64 {
        std::f64::consts::PI * panel as f64 / PANELS as f64
    }

    fn point(&self, t: f64) -> [f64; 2] {
        let (sine, cosine) = t.sin_cos();
        [self.half * (1.0 - cosine), 0.5 * self.right * (1.0 - cosine) + self.rise * sine]
    }

    fn derivative(&self, t: f64) -> [f64; 2] {
        let (sine, cosine) = t.sin_cos();
        [self.half * sine, 0.5 * self.right * sine + self.rise * cosine]
    }

    fn speed(&self, t: f64) -> f64 {
        let [x, y] = self.derivative(t);
        x.hypot(y)
    }

    /// Length from the left springing.
    fn length_to(&self, t: f64) -> f64 {
        let panel = ((t / std::f64::consts::PI * PANELS as f64) as usize).min(PANELS - 1);
        let from = Sloping::end(panel);
        self.lengths[panel] + quadrature(t - from, 1, |t| self.speed(from + t))
    }
}

impl Curve for Sloping {
    fn length(&self) -> f64 {
        self.lengths[PANELS]
    }

    fn at(&self, distance: f64) -> Station {
        let end = std::f64::consts::PI;
        let t = invert(|t| self.length_to(t), |t| self.speed(t), distance, end);
        // Upright at the springings to the last bit.
        match t {
            _ if t == 0.0 => return Station { point: [0.0, 0.0], normal: [-1.0, 0.0] },
            _ if t == end => return Station { point: [2.0 * self.half, self.right], normal: [1.0, 0.0] },
            _ => {}
        }
        let [x, y] = self.derivative(t);
        let size = x.hypot(y);
        Station { point: self.point(t), normal: [-y / size, x / size] }
    }
}

/// x = half (1 - sin t), y = rise cos t, with t = 0 in the crown and π/2 at the springing.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Ellipse {
    half: f64,
    rise: f64,
}

impl Ellipse {
    /// Length from the crown to t: half · E(t | m), m = 1 - (rise / half)², by Carlson's symmetric integrals, also
    /// where the rise is more than half the span and m is negative.
    fn length_to_crown(&self, t: f64) -> f64 {
        let m = (1.0 - self.rise / self.half) * (1.0 + self.rise / self.half);
        let (sine, cosine) = t.sin_cos();
        // 1 - m sin² t without cancellation.
        let (x, y) = (cosine * cosine, cosine * cosine + (sine * self.rise / self.half).powi(2));
        self.half * (sine * carlson_rf(x, y, 1.0) - m / 3.0 * sine.powi(3) * carlson_rd(x, y, 1.0))
    }
}

impl Curve for Ellipse {
    fn length(&self) -> f64 {
        self.length_to_crown(std::f64::consts::FRAC_PI_2)
    }

    fn at(&self, distance: f64) -> Station {
        let quarter = std::f64::consts::FRAC_PI_2;
        if distance == 0.0 {
            return Station { point: [0.0, 0.0], normal: [-1.0, 0.0] };
        }
        let speed = |t: f64| (self.half * t.cos()).hypot(self.rise * t.sin());
        let t = invert(|t| self.length_to_crown(t), speed, self.length() - distance, quarter);
        let (sine, cosine) = t.sin_cos();
        let size = speed(t);
        Station {
            point: [self.half * (1.0 - sine), self.rise * cosine],
            normal: [-self.rise * sine / size, self.half * cosine / size],
        }
    }
}

/// R_F(x, y, z) by duplication; B. C. Carlson, Numerical Algorithms 10 (1995), algorithm 1.
fn carlson_rf(mut x: f64, mut y: f64, mut z: f64) -> f64 {
    let start = (x + y + z) / 3.0;
    // The remainder of the series below is of sixth order: (4^-n Q)^6 under the machine's rounding.
    let mut reach =
        (start - x).abs().max((start - y).abs()).max((start - z).abs()) / (3.0 * f64::EPSILON).powf(1.0 / 6.0);
    let (x0, y0) = (start - x, start - y);
    let (mut mean, mut fourth) = (start, 1.0);
    while reach > mean.abs() {
        let lambda = (x * y).sqrt() + (y * z).sqrt() + (z * x).sqrt();
        (x, y, z) = (0.25 * (x + lambda), 0.25 * (y + lambda), 0.25 * (z + lambda));
        mean = 0.25 * (mean + lambda);
        fourth *= 0.25;
        reach *= 0.25;
    }
    let (p, q) = (x0 * fourth / mean, y0 * fourth / mean);
    let r = -p - q;
    let (e2, e3) = (p * q - r * r, p * q * r);
    (1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0) / mean.sqrt()
}

/// R_D(x, y, z) by duplication; B. C. Carlson, Numerical Algorithms 10 (1995), algorithm 4.
fn carlson_rd(mut x: f64, mut y: f64, mut z: f64) -> f64 {
    let start = (x + y + 3.0 * z) / 5.0;
    let mut reach =
        (start - x).abs().max((start - y).abs()).max((start - z).abs()) / (0.25 * f64::EPSILON).powf(1.0 / 6.0);
    let (x0, y0) = (start - x, start - y);
    let (mut mean, mut fourth, mut sum) = (start, 1.0, 0.0);
    while reach > mean.abs() {
        let lambda = (x * y).sqrt() + (y * z).sqrt() + (z * x).sqrt();
        sum += fourth / (z.sqrt() * (z + lambda));
        (x, y, z) = (0.25 * (x + lambda), 0.25 * (y + lambda), 0.25 * (z + lambda));
        mean = 0.25 * (mean + lambda);
        fourth *= 0.25;
        reach *= 0.25;
    }
    let (p, q) = (x0 * fourth / mean, y0 * fourth / mean);
    let r = -(p + q) / 3.0;
    let (e2, e3) = (p * q - 6.0 * r * r, (3.0 * p * q - 8.0 * r * r) * r);
    let (e4, e5) = (3.0 * (p * q - r * r) * r * r, p * q * r * r * r);
    let series = 1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0 - 3.0 * e4 / 22.0 - 9.0 * e2 * e3 / 52.0
        + 3.0 * e5 / 26.0;
    fourth * series / (mean * mean.sqrt()) + 3.0 * sum
}
