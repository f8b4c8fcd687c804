//! Numbers that carry their derivatives with respect to a relative pose: tangents are exact and written once.

use crate::contact::Number;
use std::ops::{Add, Div, Mul, Sub};

/// A value and its derivatives with respect to the two translations and the rotation of a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Dual {
    pub value: f64,
    pub slope: [f64; 3],
}

impl Dual {
    /// The variable of a number.
    pub fn variable(value: f64, number: usize) -> Dual {
        let mut slope = [0.0; 3];
        slope[number] = 1.0;
        Dual { value, slope }
    }

    /// Another value, whose derivative with respect to this one is `rate`.
    #[inline(always)]
    fn chain(self, value: f64, rate: f64) -> Dual {
        let [a, b, c] = self.slope;
        Dual { value, slope: [rate * a, rate * b, rate * c] }
    }

    #[inline(always)]
    fn with(self, other: Dual, value: f64, (left, right): (f64, f64)) -> Dual {
        let (a, b) = (self.slope, other.slope);
        let slope = [left * a[0] + right * b[0], left * a[1] + right * b[1], left * a[2] + right * b[2]];
        Dual { value, slope }
    }
}

impl Number for Dual {
    #[inline(always)]
    fn of(value: f64) -> Dual {
        Dual { value, slope: [0.0; 3] }
    }
    #[inline(always)]
    fn value(self) -> f64 {
        self.value
    }
}

/// An angle whose half has a known sine and cosine.
pub(super) trait Angle: Number {
    /// These as numbers of its own kind.
    fn of_half(self, known: Half) -> (Self, Self);
}

/// Sine and cosine of half of an angle.
pub(super) type Half = [f64; 2];

/// Half of the turn of a block.
pub(super) fn half_of(turn: f64) -> Half {
    let (sine, cosine) = (0.5 * turn).sin_cos();
    [sine, cosine]
}

/// Half of the difference of two turns.
pub(super) fn between([sine, cosine]: Half, [other_sine, other_cosine]: Half) -> Half {
    [other_sine * cosine - other_cosine * sine, other_cosine * cosine + other_sine * sine]
}

/// Sine and cosine of the whole angle.
pub(super) fn whole([sine, cosine]: Half) -> [f64; 2] {
    [2.0 * sine * cosine, cosine * cosine - sine * sine]
}

impl Angle for f64 {
    #[inline(always)]
    fn of_half(self, [sine, cosine]: Half) -> (f64, f64) {
        (sine, cosine)
    }
}

impl Angle for Dual {
    #[inline(always)]
    fn of_half(self, [sine, cosine]: Half) -> (Dual, Dual) {
        (self.chain(sine, 0.5 * cosine), self.chain(cosine, -0.5 * sine))
    }
}

impl Add for Dual {
    type Output = Dual;
    #[inline(always)]
    fn add(self, other: Dual) -> Dual {
        self.with(other, self.value + other.value, (1.0, 1.0))
    }
}

impl Sub for Dual {
    type Output = Dual;
    #[inline(always)]
    fn sub(self, other: Dual) -> Dual {
        self.with(other, self.value - other.value, (1.0, -1.0))
    }
}

impl Mul for Dual {
    type Output = Dual;
    #[inline(always)]
    fn mul(self, other: Dual) -> Dual {
        self.with(other, self.value * other.value, (other.value, self.value))
    }
}

impl Div for Dual {
    type Output = Dual;
    #[inline(always)]
    fn div(self, other: Dual) -> Dual {
        let inverse = 1.0 / other.value;
        let value = self.value * inverse;
        self.with(other, value, (inverse, -value * inverse))
    }
}
