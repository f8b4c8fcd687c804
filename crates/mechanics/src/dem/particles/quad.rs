//! Four numbers at a time: rows of memory to columns of arithmetic and back.

use super::chunk::{larger, smaller};
use std::array::from_fn;

/// Four numbers as the processor holds them. Every implementation gives the same bits.
pub(super) trait Quad: Copy {
    /// Four numbers.
    type Row: Copy;
    /// From memory.
    fn row(self, numbers: [f64; 4]) -> Self::Row;
    /// To memory.
    fn numbers(self, row: Self::Row) -> [f64; 4];
    /// `a + b`.
    fn sum(self, a: Self::Row, b: Self::Row) -> Self::Row;
    /// `a - b`.
    fn difference(self, a: Self::Row, b: Self::Row) -> Self::Row;
    /// `a * b`.
    fn product(self, a: Self::Row, b: Self::Row) -> Self::Row;
    /// `a / b`.
    fn quotient(self, a: Self::Row, b: Self::Row) -> Self::Row;
    /// Square roots.
    fn root(self, a: Self::Row) -> Self::Row;
    /// The larger; the second where one is no number.
    fn larger(self, a: Self::Row, b: Self::Row) -> Self::Row;
    /// The smaller; the second where one is no number.
    fn smaller(self, a: Self::Row, b: Self::Row) -> Self::Row;
    /// `value` where `sign` is positive, nothing elsewhere.
    fn where_positive(self, sign: Self::Row, value: Self::Row) -> Self::Row;
    /// Four times the same.
    #[inline(always)]
    fn splat(self, number: f64) -> Self::Row {
        self.row([number; 4])
    }
    /// Rows become columns.
    fn transpose(self, rows: [Self::Row; 4]) -> [Self::Row; 4];
}

/// Operations on two rows: the name of each, what the processor, the rows are called, and what comes of them.
macro_rules! operations {
    ($($name:ident = |$quad:ident, $a:ident, $b:ident| $result:expr;)+) => {$(
        #[inline(always)]
        fn $name(self, $a: Self::Row, $b: Self::Row) -> Self::Row {
            let $quad = self;
            $result
        }
    )+};
}

/// For every processor.
#[derive(Clone, Copy)]
pub(super) struct Plain;

impl Quad for Plain {
    type Row = [f64; 4];
    #[inline(always)]
    fn row(self, numbers: [f64; 4]) -> [f64; 4] {
        numbers
    }
    #[inline(always)]
    fn numbers(self, row: [f64; 4]) -> [f64; 4] {
        row
    }
    operations! {
        sum = |_quad, a, b| from_fn(|k| a[k] + b[k]);
        difference = |_quad, a, b| from_fn(|k| a[k] - b[k]);
        product = |_quad, a, b| from_fn(|k| a[k] * b[k]);
        quotient = |_quad, a, b| from_fn(|k| a[k] / b[k]);
        larger = |_quad, a, b| from_fn(|k| larger(a[k], b[k]));
        smaller = |_quad, a, b| from_fn(|k| smaller(a[k], b[k]));
        where_positive = |_quad, sign, value| from_fn(|k| if sign[k] > 0.0 { value[k] } else { 0.0 });
    }
    #[inline(always)]
    fn root(self, a: [f64; 4]) -> [f64; 4] {
        a.map(f64::sqrt)
    }
    #[inline(always)]
    fn transpose(self, rows: [[f64; 4]; 4]) -> [[f64; 4]; 4] {
        from_fn(|i| from_fn(|k| rows[k][i]))
    }
}

#[cfg(target_arch = "x86_64")]
impl Quad for pulp::x86::V3 {
    type Row = pulp::f64x4;
    #[inline(always)]
    fn row(self, numbers: [f64; 4]) -> pulp::f64x4 {
        pulp::cast(numbers)
    }
    #[inline(always)]
    fn numbers(self, row: pulp::f64x4) -> [f64; 4] {
        pulp::cast(row)
    }
    operations! {
        sum = |v3, a, b| v3.add_f64x4(a, b);
        difference = |v3, a, b| v3.sub_f64x4(a, b);
        product = |v3, a, b| v3.mul_f64x4(a, b);
        quotient = |v3, a, b| v3.div_f64x4(a, b);
        larger = |v3, a, b| v3.max_f64x4(a, b);
        smaller = |v3, a, b| v3.min_f64x4(a, b);
    }
    #[inline(always)]
    fn root(self, a: pulp::f64x4) -> pulp::f64x4 {
        self.sqrt_f64x4(a)
    }
    #[inline(always)]
    fn where_positive(self, sign: pulp::f64x4, value: pulp::f64x4) -> pulp::f64x4 {
        let nothing = self.splat_f64x4(0.0);
        self.select_f64x4(self.cmp_lt_f64x4(nothing, sign), value, nothing)
    }
    #[inline(always)]
    fn transpose(self, rows: [pulp::f64x4; 4]) -> [pulp::f64x4; 4] {
        let [a, b, c, d] = rows.map(pulp::cast);
        let avx = self.avx;
        let (ab0, ab1) = (avx._mm256_unpacklo_pd(a, b), avx._mm256_unpackhi_pd(a, b));
        let (cd0, cd1) = (avx._mm256_unpacklo_pd(c, d), avx._mm256_unpackhi_pd(c, d));
        [
            avx._mm256_permute2f128_pd::<0x20>(ab0, cd0),
            avx._mm256_permute2f128_pd::<0x20>(ab1, cd1),
            avx._mm256_permute2f128_pd::<0x31>(ab0, cd0),
            avx._mm256_permute2f128_pd::<0x31>(ab1, cd1),
        ]
        .map(pulp::cast)
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
    work.work(Plain)
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::*;

    /// What every step of the arithmetic gives on rows of such numbers, as bits.
    fn all<Q: Quad>(quad: Q, numbers: [[f64; 4]; 4]) -> Vec<u64> {
        let [a, b, c, d] = numbers.map(|row| quad.row(row));
        let mut rows =
            vec![quad.sum(a, b), quad.difference(a, b), quad.product(a, b), quad.quotient(a, b), quad.root(c)];
        rows.extend([quad.larger(a, b), quad.smaller(a, b), quad.where_positive(a, b), quad.splat(numbers[3][1])]);
        rows.extend(quad.transpose([a, b, c, d]));
        rows.into_iter().flat_map(|row| quad.numbers(row)).map(f64::to_bits).collect()
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
            for (plain, wide) in all(Plain, numbers).into_iter().zip(all(v3, numbers)) {
                let none = f64::from_bits(plain).is_nan() && f64::from_bits(wide).is_nan();
                assert!(plain == wide || none, "{numbers:?}: {plain:x} {wide:x}");
                seen += usize::from(!none);
            }
        }
        assert!(seen > 1000, "{seen} numbers compared");
        let rows = std::array::from_fn(|r| std::array::from_fn(|c| (10 * r + c) as f64));
        let columns = Plain.transpose(rows);
        assert_eq!(columns[2], [2.0, 12.0, 22.0, 32.0]);
    }
}
