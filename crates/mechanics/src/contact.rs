//! How a joint answers the overlap of its two sides: one law for the block engine and for the equilibrium path.
//!
//! The overlap is linear along the common face, so its values at the two ends say all. What presses is given back as one
//! force at each end, statically equivalent to the pressure between them.

use crate::blocks::ContactLaw;
use serde::{Deserialize, Serialize};
use std::ops::{Add, Div, Mul, Sub};

/// How long a stretch of a joint presses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum ContactLength {
    /// Each end for a length that is fixed when the contact is made (force formulation of Rouxinol, Providência and Lemos).
    Fixed,
    /// Each end for half of the compressed part, bounded below (stress formulation).
    Updated,
    /// The whole compressed part: the pressure is normal stiffness times overlap, at most the crushing strength.
    Distributed,
}

/// A number that a law is computed with: `f64`, or one that carries its derivatives.
pub trait Number: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> {
    /// A constant.
    fn of(value: f64) -> Self;
    /// Its value.
    fn value(self) -> f64;
    /// So many times it.
    fn times(self, factor: f64) -> Self;
    /// It and a constant.
    fn plus(self, constant: f64) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn of(value: f64) -> f64 {
        value
    }
    #[inline(always)]
    fn value(self) -> f64 {
        self
    }
    #[inline(always)]
    fn times(self, factor: f64) -> f64 {
        factor * self
    }
    #[inline(always)]
    fn plus(self, constant: f64) -> f64 {
        self + constant
    }
}

/// How far the bond of a joint is lost: a crack runs from each end, as a share of the joint's length. What is lost stays so.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Bond<T = f64> {
    /// Length of the crack from the first and from the second end.
    pub lost: [T; 2],
}

impl Bond {
    /// Nothing is left of it.
    pub const GONE: Bond = Bond { lost: [1.0; 2] };
}

impl<T: Number> Bond<T> {
    /// Whether any of it is left.
    pub fn holds(&self) -> bool {
        self.lost[0].value() + self.lost[1].value() < 1.0
    }
}

/// The law of one joint with its numbers: stiffness is that for the distance between its two blocks.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Resistance {
    /// Normal stiffness per unit area [Pa/m].
    pub normal: f64,
    /// Shear stiffness per unit area [Pa/m].
    pub shear: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Cohesion [Pa] over the compressed part.
    pub cohesion: f64,
    /// Compressive strength [Pa]; infinite for none.
    pub crushing: f64,
    /// Tensile strength of the bond [Pa], in the distributed formulation.
    pub tension: f64,
    /// Length that a point of the force formulation stands for [m], where it is given.
    pub fixed_length: Option<f64>,
    /// Least length of a point of the stress formulation [m].
    pub least_length: f64,
}

impl Resistance {
    /// The law for centres of mass `distance` [m] apart along the normal.
    pub fn new(law: &ContactLaw, distance: f64) -> Resistance {
        Resistance {
            normal: law.normal.at(distance),
            shear: law.shear.at(distance),
            friction: law.friction,
            cohesion: law.cohesion,
            crushing: law.crushing,
            tension: law.tension,
            fixed_length: law.fixed_length,
            least_length: law.least_length,
        }
    }

    /// Compression [N/m] at the two ends of a face of `length` [m] that overlap by `overlap` [m], and the length [m] for
    /// which each end resists shear. An open end has neither. `bond` is what was left of the bond before; points have none.
    pub fn ends<T: Number>(&self, contact_length: ContactLength, overlap: [T; 2], length: T, bond: &Bond) -> Ends<T> {
        match contact_length {
            ContactLength::Fixed => {
                let half = self.fixed_length.map_or(length.times(0.5), T::of);
                self.points(overlap, [half; 2])
            }
            ContactLength::Updated => {
                let half = length.times(0.5);
                self.points(overlap, [0, 1].map(|k| self.updated(overlap[k], overlap[1 - k], half)))
            }
            ContactLength::Distributed => self.distributed(overlap, length, bond),
        }
    }

    /// Work that closed the compressed part of a face in the distributed formulation and opened the bonded one [J/m], which the
    /// way back returns.
    pub fn energy(&self, overlap: [f64; 2], length: f64, bond: &Bond) -> f64 {
        let most = self.crushing / self.normal;
        let beyond = if most.is_finite() { squares(overlap.map(|o| o - most)) } else { 0.0 };
        let pulled = match self.pulled(overlap, bond) {
            Some(from) => points_within(from).iter().map(|at| at.share * at.of(overlap) * at.of(overlap)).sum(),
            None => 0.0,
        };
        0.5 * self.normal * length * (squares(overlap) - beyond + pulled)
    }

    /// What is left of a bond: it breaks for good where the tension would be beyond its strength.
    pub fn left<T: Number>(&self, overlap: [T; 2], bond: &Bond) -> Bond<T> {
        if !(self.tension > 0.0 && bond.holds()) {
            return Bond { lost: [T::of(1.0); 2] };
        }
        let [a, b] = each(overlap, |o| o.plus(self.tension / self.normal));
        let before = each(bond.lost, T::of);
        let longer = |crack: T, before: T| if crack.value() > before.value() { crack } else { before };
        match (a.value() >= 0.0, b.value() >= 0.0) {
            (true, true) => Bond { lost: before },
            (false, false) => Bond { lost: [T::of(1.0); 2] },
            (false, true) => Bond { lost: [longer(a / (a - b), before[0]), before[1]] },
            (true, false) => Bond { lost: [before[0], longer(b / (b - a), before[1])] },
        }
    }

    /// Share of a face that its bond pulls together.
    pub fn pulled_share(&self, overlap: [f64; 2], bond: &Bond) -> f64 {
        self.pulled(overlap, bond).map_or(0.0, |from| 1.0 - (from[0] + from[1]))
    }

    /// The part of a face that its bond pulls together: its distances from the two ends, as shares of the face's length.
    fn pulled<T: Number>(&self, overlap: [T; 2], bond: &Bond) -> Option<[T; 2]> {
        if !(self.tension > 0.0 && bond.holds()) {
            return None;
        }
        let Bond { lost } = self.left(overlap, bond);
        let [a, b] = overlap;
        let later = |one: T, two: T| if two.value() > one.value() { two } else { one };
        let from = match (a.value() >= 0.0, b.value() >= 0.0) {
            (true, true) => return None,
            (false, false) => lost,
            (true, false) => [later(lost[0], a / (a - b)), lost[1]],
            (false, true) => [lost[0], later(lost[1], b / (b - a))],
        };
        (from[0].value() + from[1].value() < 1.0).then_some(from)
    }

    /// Each end by itself.
    fn points<T: Number>(&self, overlap: [T; 2], length: [T; 2]) -> Ends<T> {
        let mut ends = Ends { compression: [T::of(0.0); 2], length: [T::of(0.0); 2] };
        for k in 0..2 {
            if overlap[k].value() >= 0.0 {
                let stress = overlap[k].times(self.normal);
                let stress = if stress.value() > self.crushing { T::of(self.crushing) } else { stress };
                ends.compression[k] = stress * length[k];
                ends.length[k] = length[k];
            }
        }
        ends
    }

    /// Half the compressed part, or half the face where the other end is closed too; at least the least length.
    fn updated<T: Number>(&self, here: T, there: T, half: T) -> T {
        let compressed = here.value() > 0.0 && there.value() < 0.0;
        let length = if compressed { half * here / (here - there) } else { half };
        if length.value() < self.least_length { T::of(self.least_length) } else { length }
    }

    /// The pressure `normal * overlap`, nowhere more than the crushing strength, and nowhere less than nothing but where the bond
    /// holds: it pulls there, up to its strength.
    pub fn distributed<T: Number>(&self, overlap: [T; 2], length: T, bond: &Bond) -> Ends<T> {
        let (mut pressed, mut share) = compressed(overlap);
        let most = self.crushing / self.normal;
        if overlap.iter().any(|o| o.value() > most) {
            let (beyond, _) = compressed(each(overlap, |o| o.plus(-most)));
            pressed = [pressed[0] - beyond[0], pressed[1] - beyond[1]];
        }
        if let Some(from) = self.pulled(overlap, bond) {
            let [one, two] = points_within(from);
            for k in 0..2 {
                // Both together first, so that a joint seen from its other side answers to the same bits.
                let weights = [one.share * one.weights[k], two.share * two.weights[k]];
                pressed[k] = pressed[k] + (weights[0] * one.of(overlap) + weights[1] * two.of(overlap));
                share[k] = share[k] + (weights[0] + weights[1]);
            }
        }
        let scale = length.times(self.normal);
        Ends { compression: each(pressed, |p| scale * p), length: each(share, |s| length * s) }
    }
}

/// A place on a face for sums over a part of it.
#[derive(Clone, Copy)]
struct Point<T> {
    /// Share of the face's length that it stands for.
    share: T,
    /// Shares of the two ends in what is linear along the face.
    weights: [T; 2],
}

/// Gauss's two points in what lies so far from the two ends: exact for polynomials of the third degree, and the same from either end.
fn points_within<T: Number>([a, b]: [T; 2]) -> [Point<T>; 2] {
    const NEAR: f64 = 0.211_324_865_405_187_13;
    let length = T::of(1.0) - (a + b);
    let share = length.times(0.5);
    let (near, far) = (length.times(NEAR), length.times(1.0 - NEAR));
    [Point { share, weights: [b + far, a + near] }, Point { share, weights: [b + near, a + far] }]
}

impl<T: Number> Point<T> {
    /// The value there of what is linear along the face.
    fn of(&self, ends: [T; 2]) -> T {
        self.weights[0] * ends[0] + self.weights[1] * ends[1]
    }
}

/// The same of both ends. Arrays of numbers with derivatives are not mapped in place: that took a tenth of the time of a path.
#[inline(always)]
pub(crate) fn each<T, U>([first, second]: [T; 2], of: impl Fn(T) -> U) -> [U; 2] {
    [of(first), of(second)]
}

/// What the two ends of a joint carry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ends<T> {
    /// Compression [N/m], positive; negative where the bond pulls.
    pub compression: [T; 2],
    /// Length that resists shear [m].
    pub length: [T; 2],
}

impl<T: Number> Ends<T> {
    /// The largest shear that an end resists [N/m]: friction on what presses and cohesion, less friction on what pulls.
    #[inline(always)]
    pub fn shear_strength(&self, end: usize, law: &Resistance) -> T {
        let strength = self.compression[end].times(law.friction) + self.length[end].times(law.cohesion);
        if strength.value() < 0.0 { T::of(0.0) } else { strength }
    }
}

/// Integrals over a face of unit length of the positive part of a linear function, and of one where it is positive, each
/// weighted by the share of an end: `1 - x` for the first, `x` for the second.
fn compressed<T: Number>(ends: [T; 2]) -> ([T; 2], [T; 2]) {
    let zero = T::of(0.0);
    let [a, b] = ends;
    match (a.value() >= 0.0, b.value() >= 0.0) {
        (true, true) => {
            let sixth = 1.0 / 6.0;
            ([(a.times(2.0) + b).times(sixth), (a + b.times(2.0)).times(sixth)], [T::of(0.5); 2])
        }
        (false, false) => ([zero; 2], [zero; 2]),
        (true, false) => one_end(a, b),
        (false, true) => {
            let (pressed, share) = one_end(b, a);
            ([pressed[1], pressed[0]], [share[1], share[0]])
        }
    }
}

/// The same where the function is positive at the first end alone.
fn one_end<T: Number>(near: T, far: T) -> ([T; 2], [T; 2]) {
    let part = near / (near - far);
    let square = part * part;
    let (half, sixth) = (square.times(0.5), square.times(1.0 / 6.0));
    ([near * (part.times(0.5) - sixth), near * sixth], [part - half, half])
}

/// Integral over a face of unit length of the square of the positive part of a linear function.
fn squares([a, b]: [f64; 2]) -> f64 {
    match (a >= 0.0, b >= 0.0) {
        (true, true) => (a * a + a * b + b * b) / 3.0,
        (false, false) => 0.0,
        (true, false) => a * a * a / (3.0 * (a - b)),
        (false, true) => b * b * b / (3.0 * (b - a)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn resistance(crushing: f64) -> Resistance {
        Resistance {
            normal: 2e9,
            shear: 1e9,
            friction: 0.6,
            cohesion: 0.0,
            crushing,
            tension: 0.0,
            fixed_length: None,
            least_length: 0.05,
        }
    }

    /// The same integrals by many strips.
    fn by_strips(law: &Resistance, overlap: [f64; 2], length: f64, bond: &Bond) -> Ends<f64> {
        let strips = 20_000;
        let mut ends = Ends { compression: [0.0; 2], length: [0.0; 2] };
        for k in 0..strips {
            let x = (k as f64 + 0.5) / strips as f64;
            let here = overlap[0] * (1.0 - x) + overlap[1] * x;
            let bonded = x >= bond.lost[0] && 1.0 - x >= bond.lost[1] && law.normal * here >= -law.tension;
            if here < 0.0 && !bonded {
                continue;
            }
            let pressure = (law.normal * here).min(law.crushing);
            for (end, share) in [1.0 - x, x].into_iter().enumerate() {
                ends.compression[end] += pressure * share * length / strips as f64;
                ends.length[end] += share * length / strips as f64;
            }
        }
        ends
    }

    #[test]
    fn closed_forms_are_the_sums_over_strips() {
        let bonds = [(0.0, Bond::GONE), (1e6, Bond::default()), (1e6, Bond { lost: [0.2, 0.1] }), (1e6, Bond::GONE)];
        for (crushing, (tension, bond)) in [f64::INFINITY, 1e6].into_iter().flat_map(|c| bonds.map(|bond| (c, bond))) {
            let law = Resistance { tension, ..resistance(crushing) };
            for overlap in [[1e-3, 2e-3], [1e-3, -2e-3], [-4e-4, 1e-3], [3e-4, 1e-4], [-1e-3, -1e-4], [2e-3, -1e-5]] {
                // What the law leaves of the bond here: from there on the way is one of no loss.
                let bond = law.left(overlap, &bond);
                let held = Resistance { tension: if tension > 0.0 { f64::INFINITY } else { 0.0 }, ..law };
                let energy = |o: [f64; 2]| held.energy(o, 0.7, &bond);
                let step = 1e-9;
                // The work of a small motion is what its forces do.
                for k in 0..2 {
                    let (mut more, mut less) = (overlap, overlap);
                    more[k] += step;
                    less[k] -= step;
                    let force = law.ends(ContactLength::Distributed, overlap, 0.7, &bond).compression[k];
                    let slope = (energy(more) - energy(less)) / (2.0 * step);
                    assert!((slope - force).abs() < 1e-4 * 1e6, "{overlap:?}: {slope} {force}");
                }
                let (exact, sum) =
                    (law.ends(ContactLength::Distributed, overlap, 0.7, &bond), by_strips(&law, overlap, 0.7, &bond));
                for k in 0..2 {
                    let (force, length) = (exact.compression[k] - sum.compression[k], exact.length[k] - sum.length[k]);
                    assert!(force.abs() < 1e-4 * 1e6 && length.abs() < 1e-4, "{overlap:?}: {exact:?} {sum:?}");
                }
            }
        }
    }

    #[test]
    fn a_bedded_face_presses_alike_whichever_way_it_is_taken() {
        let law = resistance(f64::INFINITY);
        for contact_length in [ContactLength::Fixed, ContactLength::Updated, ContactLength::Distributed] {
            let even = law.ends(contact_length, [1e-3; 2], 0.7, &Bond::default());
            let total: f64 = even.compression.iter().sum();
            assert!((total - 2e9 * 1e-3 * 0.7).abs() < 1e-6, "{contact_length:?}: {total}");
            let turned = law.ends(contact_length, [1e-3, -5e-4], 0.7, &Bond::default());
            let back = law.ends(contact_length, [-5e-4, 1e-3], 0.7, &Bond::default());
            assert_eq!([turned.compression[1], turned.compression[0]], back.compression, "{contact_length:?}");
        }
    }

    /// A crack never heals, no tension is beyond the strength, and a joint that is seen from its other side answers the same to the bit.
    #[test]
    fn a_bond_breaks_for_good_and_alike_from_either_side() {
        let law = Resistance { tension: 1e6, ..resistance(f64::INFINITY) };
        let mut bond = Bond::default();
        let mut lost = 0.0;
        for [a, b] in [[1e-4, -4e-4], [1e-4, -8e-4], [3e-4, -2e-4], [-6e-4, 3e-4], [-2e-4, -1e-4], [-6e-4, -6e-4]] {
            let left = law.left([a, b], &bond);
            let turned = law.left([b, a], &Bond { lost: [bond.lost[1], bond.lost[0]] });
            assert_eq!(left.lost, [turned.lost[1], turned.lost[0]]);
            let (one, two) = (
                law.ends(ContactLength::Distributed, [a, b], 0.7, &left),
                law.ends(ContactLength::Distributed, [b, a], 0.7, &turned),
            );
            assert_eq!(one.compression, [two.compression[1], two.compression[0]]);
            assert_eq!(one.length, [two.length[1], two.length[0]]);
            assert!(left.lost[0] >= bond.lost[0] && left.lost[1] >= bond.lost[1], "{left:?} {bond:?}");
            // At the ends of what is left the opening is at most what the strength allows.
            if left.holds() {
                for (k, x) in [left.lost[0], 1.0 - left.lost[1]].into_iter().enumerate() {
                    let opening = -(a * (1.0 - x) + b * x);
                    assert!(law.normal * opening <= law.tension * (1.0 + 1e-12), "end {k}: {opening}");
                }
            }
            bond = left;
            lost = f64::max(lost, bond.lost[0] + bond.lost[1]);
        }
        assert!(!bond.holds() && lost >= 1.0, "{bond:?}");
    }
}
