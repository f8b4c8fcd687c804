//! Four numbers at a time: rows of memory to columns of arithmetic and back.

use super::chunk::{larger, smaller};
use pulp::{Scalar256b, Simd, cast, f64x4};
use std::array::from_fn;

/// A processor that holds four numbers at a time. Every implementation gives the same bits.
pub(super) trait Quad: Simd<f64s = f64x4> {
    /// The larger; the second where one is no number.
    fn larger(self, a: f64x4, b: f64x4) -> f64x4;
    /// The smaller; the second where one is no number.
    fn smaller(self, a: f64x4, b: f64x4) -> f64x4;
    /// Rows become columns.
    fn transpose(self, rows: [f64x4; 4]) -> [f64x4; 4];
    /// `value` where `sign` is positive, nothing elsewhere.
    #[inline(always)]
    fn where_positive(self, sign: f64x4, value: f64x4) -> f64x4 {
        let nothing = self.splat_f64s(0.0);
        self.select_f64s(self.less_than_f64s(nothing, sign), value, nothing)
    }
}

/// For every processor.
impl Quad for Scalar256b {
    #[inline(always)]
    fn larger(self, a: f64x4, b: f64x4) -> f64x4 {
        let [a, b]: [[f64; 4]; 2] = [a, b].map(cast);
        cast::<[f64; 4], f64x4>(from_fn(|k| larger(a[k], b[k])))
    }
    #[inline(always)]
    fn smaller(self, a: f64x4, b: f64x4) -> f64x4 {
        let [a, b]: [[f64; 4]; 2] = [a, b].map(cast);
        cast::<[f64; 4], f64x4>(from_fn(|k| smaller(a[k], b[k])))
    }
    #[inline(always)]
    fn transpose(self, rows: [f64x4; 4]) -> [f64x4; 4] {
        let rows: [[f64; 4]; 4] = rows.map(cast);
        from_fn(|i| cast::<[f64; 4], f64x4>(from_fn(|k| rows[k][i])))
    }
}

#[cfg(target_arch = "x86_64")]
impl Quad for pulp::x86::V3 {
    #[inline(always)]
    fn larger(self, a: f64x4, b: f64x4) -> f64x4 {
        self.max_f64x4(a, b)
    }
    #[inline(always)]
    fn smaller(self, a: f64x4, b: f64x4) -> f64x4 {
        self.min_f64x4(a, b)
    }
    #[inline(always)]
    fn transpose(self, rows: [f64x4; 4]) -> [f64x4; 4] {
        let [a, b, c, d] = rows.map(cast);
        let avx = self.avx;
        let (ab0, ab1) = (avx._mm256_unpacklo_pd(a, b), avx._mm256_unpackhi_pd(a, b));
        let (cd0, cd1) = (avx._mm256_unpacklo_pd(c, d), avx._mm256_unpackhi_pd(c, d));
        [
            avx._mm256_permute2f128_pd::<0x20>(ab0, cd0),
            avx._mm256_permute2f128_pd::<0x20>(ab1, cd1),
            avx._mm256_permute2f128_pd::<0x31>(ab0, cd0),
            avx._mm256_permute2f128_pd::<0x31>(ab1, cd1),
        ]
        .map(cast)
    }
}

/// Work that is written for any four numbers.
pub(super) trait ByFours {
    /// What comes of it.
    type Output;
    /// Does it.
    fn work<Q: Quad>(self, quad: Q) -> Self::Output;
}

/// Does the work with the widest four numbers that this processor has.
#[inline(always)]
pub(super) fn by_fours<W: ByFours>(work: W) -> W::Output {
    #[cfg(target_arch = "x86_64")]
    if let Some(v3) = pulp::x86::V3::try_new() {
        struct WithV3<W>(pulp::x86::V3, W);
        impl<W: ByFours> pulp::NullaryFnOnce for WithV3<W> {
            type Output = W::Output;
            #[inline(always)]
            fn call(self) -> W::Output {
                self.1.work(self.0)
            }
        }
        return v3.vectorize(WithV3(v3, work));
    }
    work.work(Scalar256b)
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::*;

    /// What every step of the arithmetic gives on rows of such numbers, as bits.
    fn all<Q: Quad>(quad: Q, numbers: [[f64; 4]; 4]) -> Vec<u64> {
        let [a, b, c, d] = numbers.map(cast::<[f64; 4], f64x4>);
        let mut rows = vec![quad.add_f64s(a, b), quad.sub_f64s(a, b), quad.mul_f64s(a, b), quad.div_f64s(a, b)];
        rows.extend([quad.sqrt_f64s(c), quad.larger(a, b), quad.smaller(a, b), quad.where_positive(a, b)]);
        rows.push(quad.splat_f64s(numbers[3][1]));
        rows.extend(quad.transpose([a, b, c, d]));
        rows.into_iter().flat_map(cast::<f64x4, [f64; 4]>).map(f64::to_bits).collect()
    }

    /// A processor with wide vectors and one without give the same bits: also of zeros with a sign, of what is infinite, and of what is
    /// no number. (The bits of a number that is none may differ where both operands are none; such runs have broken anyway.)
    #[test]
    fn wide_vectors_give_the_bits_of_plain_numbers() {
        let Some(v3) = pulp::x86::V3::try_new() else { return };
        let odd = [0.0, -0.0, 1.0, -1.5, 1e-310, f64::INFINITY, f64::NAN, 0.1, 3e200, -7e-9];
        let mut seen = 0;
        for k in 0..odd.len().pow(2) {
            let at = |i: usize| odd[(k / odd.len().pow((i % 2) as u32) + 3 * (i / 2)) % odd.len()];
            let numbers: [[f64; 4]; 4] = std::array::from_fn(|r| std::array::from_fn(|c| at(4 * r + c)));
            for (plain, wide) in all(Scalar256b, numbers).into_iter().zip(all(v3, numbers)) {
                let none = f64::from_bits(plain).is_nan() && f64::from_bits(wide).is_nan();
                assert!(plain == wide || none, "{numbers:?}: {plain:x} {wide:x}");
                seen += usize::from(!none);
            }
        }
        assert!(seen > 1000, "{seen} numbers compared");
        let rows = std::array::from_fn(|r| pulp::f64x4(r as f64, (10 + r) as f64, (20 + r) as f64, (30 + r) as f64));
        assert_eq!(Scalar256b.transpose(rows)[2], pulp::f64x4(20.0, 21.0, 22.0, 23.0));
    }
}
