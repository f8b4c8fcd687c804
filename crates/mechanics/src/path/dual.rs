//! Numbers that carry their derivatives with respect to a relative pose: tangents are exact and written once.

use crate::contact::Number;
use crate::plane::{Vec2, vec2};
use std::ops::{Add, Div, Mul, Sub};

/// A value and its derivatives with respect to the two translations and the rotation of a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Dual {
    pub value: f64,
    pub slope: [f64; 3],
}

impl Dual {
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
    #[inline(always)]
    fn times(self, factor: f64) -> Dual {
        self.chain(factor * self.value, factor)
    }
    #[inline(always)]
    fn plus(self, constant: f64) -> Dual {
        Dual { value: self.value + constant, ..self }
    }
}

/// Sine and cosine of half of an angle.
pub(super) type Half = [f64; 2];

/// Half of the turn of a block. Small turns by their series, which is exact to the last digits and has the same bits on every machine.
pub(super) fn half_of(turn: f64) -> Half {
    const SMALL: f64 = 0.1;
    let half = 0.5 * turn;
    if half.abs() > SMALL {
        let (sine, cosine) = half.sin_cos();
        return [sine, cosine];
    }
    let square = half * half;
    let term = |rest: f64, over: f64| 1.0 - square * rest / over;
    let sine = half * term(term(term(term(1.0, 72.0), 42.0), 20.0), 6.0);
    let cosine = term(term(term(term(term(1.0, 90.0), 56.0), 30.0), 12.0), 2.0);
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

/// A number that depends on the pose of the second block of a joint as its first one sees it: how far it has moved along the
/// joint and across it, and its turn. Vectors stand in the frame of the first block or in the one that halves the angle between the two, along
/// the joint and across it.
pub(super) trait Posed: Number {
    /// A vector of the first block, seen from the frame between.
    fn of_first(vector: Vec2, turn: Half) -> [Self; 2];
    /// A vector of the second block, as that was built, seen from the frame between.
    fn of_second(vector: Vec2, turn: Half) -> [Self; 2];
    /// What moves with the second block's centre, given in the frame of the first one, seen from the frame between.
    fn of_centre(vector: Vec2, turn: Half) -> [Self; 2];
    /// A vector of the frame between, seen from the first block.
    fn seen_by_first(vector: [Self; 2], turn: Half) -> [Self; 2];
}

impl Posed for f64 {
    #[inline(always)]
    fn of_first(v: Vec2, [sine, cosine]: Half) -> [f64; 2] {
        [cosine * v.x - sine * v.y, cosine * v.y + sine * v.x]
    }
    #[inline(always)]
    fn of_second(v: Vec2, [sine, cosine]: Half) -> [f64; 2] {
        [cosine * v.x + sine * v.y, cosine * v.y - sine * v.x]
    }
    #[inline(always)]
    fn of_centre(v: Vec2, turn: Half) -> [f64; 2] {
        f64::of_first(v, turn)
    }
    #[inline(always)]
    fn seen_by_first([along, across]: [f64; 2], turn: Half) -> [f64; 2] {
        f64::of_second(vec2(along, across), turn)
    }
}

impl Posed for Dual {
    #[inline(always)]
    fn of_first(v: Vec2, turn: Half) -> [Dual; 2] {
        let [x, y] = f64::of_first(v, turn);
        [Dual { value: x, slope: [0.0, 0.0, -0.5 * y] }, Dual { value: y, slope: [0.0, 0.0, 0.5 * x] }]
    }
    #[inline(always)]
    fn of_second(v: Vec2, turn: Half) -> [Dual; 2] {
        let [x, y] = f64::of_second(v, turn);
        [Dual { value: x, slope: [0.0, 0.0, 0.5 * y] }, Dual { value: y, slope: [0.0, 0.0, -0.5 * x] }]
    }
    #[inline(always)]
    fn of_centre(v: Vec2, [sine, cosine]: Half) -> [Dual; 2] {
        let [x, y] = f64::of_centre(v, [sine, cosine]);
        [Dual { value: x, slope: [cosine, -sine, -0.5 * y] }, Dual { value: y, slope: [sine, cosine, 0.5 * x] }]
    }
    #[inline(always)]
    fn seen_by_first([along, across]: [Dual; 2], [sine, cosine]: Half) -> [Dual; 2] {
        let (mut x, mut y) = (along.times(cosine) + across.times(sine), across.times(cosine) - along.times(sine));
        x.slope[2] += 0.5 * y.value;
        y.slope[2] -= 0.5 * x.value;
        [x, y]
    }
}

/// An operator: the value of two numbers, and its derivatives with respect to them.
macro_rules! operators {
    ($($operator:ident $name:ident |$a:ident, $b:ident| $value:expr, $slopes:expr;)+) => {$(
        impl $operator for Dual {
            type Output = Dual;

            #[inline(always)]
            fn $name(self, other: Dual) -> Dual {
                let ($a, $b) = (self.value, other.value);
                self.with(other, $value, $slopes)
            }
        }
    )+};
}

operators! {
    Add add |a, b| a + b, (1.0, 1.0);
    Sub sub |a, b| a - b, (1.0, -1.0);
    Mul mul |a, b| a * b, (b, a);
    Div div |a, b| a * (1.0 / b), (1.0 / b, -(a * (1.0 / b)) * (1.0 / b));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_of_small_turns_goes_on_as_the_functions_do() {
        for k in -4000..=4000 {
            let turn = 6e-5 * f64::from(k);
            let [sine, cosine] = half_of(turn);
            assert!((sine - (0.5 * turn).sin()).abs() <= 1.5e-16 * turn.abs(), "{turn}: {sine}");
            assert!((cosine - (0.5 * turn).cos()).abs() <= 2.3e-16, "{turn}: {cosine}");
        }
    }

    /// Derivatives by differences, at turns small and large.
    #[test]
    fn vectors_change_with_the_pose_as_they_say() {
        let (arm, size) = (vec2(0.7, -1.3), 1e-6);
        for turn in [-2.0, -0.3, 0.0, 1e-3, 0.9] {
            let half = half_of(turn);
            let differ = |later: [f64; 2], sooner: [f64; 2], told: [Dual; 2], motion: usize| {
                for c in 0..2 {
                    let slope = (later[c] - sooner[c]) / (2.0 * size);
                    assert!((told[c].slope[motion] - slope).abs() < 1e-8, "{turn} {motion}: {told:?}, not {slope}");
                }
            };
            let [before, after] = [turn - size, turn + size].map(half_of);
            differ(f64::of_first(arm, after), f64::of_first(arm, before), Dual::of_first(arm, half), 2);
            differ(f64::of_second(arm, after), f64::of_second(arm, before), Dual::of_second(arm, half), 2);
            let centre = Dual::of_centre(arm, half);
            differ(f64::of_centre(arm, after), f64::of_centre(arm, before), centre, 2);
            for (motion, by) in [vec2(size, 0.0), vec2(0.0, size)].into_iter().enumerate() {
                differ(f64::of_centre(arm + by, half), f64::of_centre(arm - by, half), centre, motion);
            }
            let back = Dual::seen_by_first([arm.x, arm.y].map(Dual::of), half);
            differ(f64::seen_by_first([arm.x, arm.y], after), f64::seen_by_first([arm.x, arm.y], before), back, 2);
            // There and back.
            let [x, y] = f64::seen_by_first(f64::of_first(arm, half), half);
            assert!((x - arm.x).abs() + (y - arm.y).abs() < 1e-15);
        }
    }
}
