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
        Dual { value, slope: self.slope.map(|s| rate * s) }
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

/// Sine and cosine.
pub(super) trait Angle: Number {
    fn sine_cosine(self) -> (Self, Self);
}

impl Angle for f64 {
    fn sine_cosine(self) -> (f64, f64) {
        self.sin_cos()
    }
}

impl Angle for Dual {
    fn sine_cosine(self) -> (Dual, Dual) {
        let (sine, cosine) = self.value.sin_cos();
        (self.chain(sine, cosine), self.chain(cosine, -sine))
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
