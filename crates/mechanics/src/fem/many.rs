//! Solutions for many right-hand sides at a time with a factor that a library has made.
//!
//! The library keeps right-hand sides as columns, so that each entry of the factor meets numbers that lie a whole vector apart. Here
//! those of one equation lie side by side: an entry is read once and meets all of them in the processor's registers, and each of these numbers is
//! loaded once for four equations. With 64,136 equations and a factor of 4.2 million entries 32 right-hand sides take 10 ms and 8 take
//! 4.8 ms on one core (22 and 14 ms while each number was loaded for one equation alone); 32 that are all but empty, of whose solutions a few are wanted,
//! take 2.8 ms.

use faer::sparse::linalg::cholesky::supernodal::{SupernodalLltRef, SymbolicSupernodalCholesky};
use pulp::{Simd, WithSimd, bytemuck};
use std::array::from_fn;
use std::hint::black_box;

/// Right-hand sides of a block: as many as needed, and no more than so many.
pub(super) const WIDTHS: [usize; 3] = [8, 16, WIDEST];
pub(super) const WIDEST: usize = 32;

/// Solves `L L^T x = right` in place: `x` has a number for each of `width` right-hand sides, one of [`WIDTHS`], and after them those of the
/// next equation in the order of elimination. Of supernodes that are not among the `wanted`, [`reach`], nothing is found.
pub(super) fn solve(
    symbolic: &SymbolicSupernodalCholesky<u32>,
    values: &[f64],
    width: usize,
    x: &mut [f64],
    wanted: Option<&[bool]>,
) {
    let factor = SupernodalLltRef::new(symbolic, values);
    pulp::Arch::new().dispatch(Work { factor, width, x, wanted });
}

/// Marks supernodes that have to be gone through backward for the solution at some places of the order of elimination, too: theirs, and those that were
/// eliminated after them and are coupled with them.
pub(super) fn reach(
    symbolic: &SymbolicSupernodalCholesky<u32>,
    wanted: &mut Vec<bool>,
    places: impl Iterator<Item = u32>,
) {
    let begin = symbolic.supernode_begin();
    let node = |place: u32| begin.partition_point(|first| *first <= place) - 1;
    wanted.resize(symbolic.n_supernodes(), false);
    places.for_each(|place| wanted[node(place)] = true);
    for index in 0..wanted.len() {
        // All others that it is coupled with are among those of the first one's.
        if let (true, Some(&next)) = (wanted[index], symbolic.supernode(index).pattern().first()) {
            wanted[node(next)] = true;
        }
    }
}

struct Work<'a> {
    factor: SupernodalLltRef<'a, u32, f64>,
    width: usize,
    x: &'a mut [f64],
    wanted: Option<&'a [bool]>,
}

impl WithSimd for Work<'_> {
    type Output = ();

    /// As many right-hand sides at a time as leave registers for four equations: 32, 8 or 4 of them.
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let vectors = self.width / S::F64_LANES;
        match vectors {
            1 => self.go::<S, 1>(simd),
            _ if S::REGISTER_COUNT >= 32 && vectors.is_multiple_of(4) => self.go::<S, 4>(simd),
            _ => self.go::<S, 2>(simd),
        }
    }
}

impl Work<'_> {
    /// With `V` registers for the right-hand sides of one equation.
    #[inline(always)]
    fn go<S: Simd, const V: usize>(self, simd: S) {
        let shares = self.width / S::F64_LANES / V;
        let x = S::as_mut_simd_f64s(self.x).0.as_chunks_mut::<V>().0;
        let nodes = self.factor.symbolic().n_supernodes();
        let node = |index| Node::new(simd, shares, self.factor, index);
        for index in 0..nodes {
            let node = node(index);
            node.forward(&mut x[node.start * shares..]);
        }
        for index in (0..nodes).rev().filter(|&index| self.wanted.is_none_or(|wanted| wanted[index])) {
            let node = node(index);
            node.backward(&mut x[node.start * shares..]);
        }
    }
}

/// Columns of the factor whose entries stand in the same rows. Places count from the first one's.
struct Node<'a, S> {
    simd: S,
    /// Parts that the right-hand sides are taken in.
    shares: usize,
    start: usize,
    size: usize,
    /// Rows of each column: as many as there are columns, and those below.
    rows: usize,
    below: &'a [u32],
    values: &'a [f64],
}

impl<'a, S: Simd> Node<'a, S> {
    #[inline(always)]
    fn new(simd: S, shares: usize, factor: SupernodalLltRef<'a, u32, f64>, index: usize) -> Node<'a, S> {
        let symbolic = factor.symbolic();
        let (node, ends) = (symbolic.supernode(index), &symbolic.col_ptr_for_val()[index..]);
        let size = symbolic.supernode_end()[index] as usize - node.start();
        let (below, values) = (node.pattern(), &factor.values()[ends[0] as usize..ends[1] as usize]);
        Node { simd, shares, start: node.start(), size, rows: size + below.len(), below, values }
    }

    /// `L y = right`. Passed over where no right-hand side reaches it.
    #[inline(always)]
    fn forward<const V: usize>(&self, x: &mut [[S::f64s; V]]) {
        let own: &[f64] = bytemuck::cast_slice(x[..self.size * self.shares].as_flattened());
        // Zeros but for the sign: whole registers at a time, as a test that ends early is not done.
        if own.iter().fold(0, |all, value| all | (value.to_bits() << 1)) == 0 {
            return;
        }
        Self::fetch(self.values.iter());
        for share in 0..self.shares {
            for (start, end) in [(0, self.size), (self.size, self.rows)] {
                for first in (start..end).step_by(4) {
                    match end - first {
                        1 => self.forward_rows::<1, V>(first, share, x),
                        2 => self.forward_rows::<2, V>(first, share, x),
                        3 => self.forward_rows::<3, V>(first, share, x),
                        _ => self.forward_rows::<4, V>(first, share, x),
                    }
                }
            }
        }
    }

    /// `L^T x = y`.
    #[inline(always)]
    fn backward<const V: usize>(&self, x: &mut [[S::f64s; V]]) {
        Self::fetch(self.values.iter().rev());
        for share in 0..self.shares {
            for first in (0..self.size).step_by(4).rev() {
                match self.size - first {
                    1 => self.backward_columns::<1, V>(first, share, x),
                    2 => self.backward_columns::<2, V>(first, share, x),
                    3 => self.backward_columns::<3, V>(first, share, x),
                    _ => self.backward_columns::<4, V>(first, share, x),
                }
            }
        }
    }

    /// Takes from `R` rows what the columns before them put there: each solution is loaded once for all of them.
    #[inline(always)]
    fn forward_rows<const R: usize, const V: usize>(&self, first: usize, share: usize, x: &mut [[S::f64s; V]]) {
        let places: [usize; R] = from_fn(|r| self.place(first + r, share));
        let mut sums = places.map(|place| x[place]);
        for j in 0..first.min(self.size) {
            let other = x[j * self.shares + share];
            let entries = &self.column(j)[first..first + R];
            for r in 0..R {
                self.less(&mut sums[r], entries[r], &other);
            }
        }
        if first < self.size {
            for r in 0..R {
                let entries = &self.column(first + r)[first..first + R];
                self.divide(&mut sums[r], entries[r]);
                let other = sums[r];
                for later in r + 1..R {
                    self.less(&mut sums[later], entries[later], &other);
                }
            }
        }
        for r in 0..R {
            x[places[r]] = sums[r];
        }
    }

    /// Solves for `R` columns: each solution in the rows after them is loaded once for all of them.
    #[inline(always)]
    fn backward_columns<const R: usize, const V: usize>(&self, first: usize, share: usize, x: &mut [[S::f64s; V]]) {
        let places: [usize; R] = from_fn(|r| self.place(first + r, share));
        let columns: [&[f64]; R] = from_fn(|r| self.column(first + r));
        let mut sums = places.map(|place| x[place]);
        for (i, &row) in (self.size..self.rows).zip(self.below) {
            let other = x[(row as usize - self.start) * self.shares + share];
            for r in 0..R {
                self.less(&mut sums[r], columns[r][i], &other);
            }
        }
        for i in first + R..self.size {
            let other = x[i * self.shares + share];
            for r in 0..R {
                self.less(&mut sums[r], columns[r][i], &other);
            }
        }
        for r in (0..R).rev() {
            for later in r + 1..R {
                let other = sums[later];
                self.less(&mut sums[r], columns[r][first + later], &other);
            }
            self.divide(&mut sums[r], columns[r][first + r]);
        }
        for r in 0..R {
            x[places[r]] = sums[r];
        }
    }

    #[inline(always)]
    fn column(&self, j: usize) -> &'a [f64] {
        &self.values[j * self.rows..][..self.rows]
    }

    /// Where a share of the right-hand sides of a row stands.
    #[inline(always)]
    fn place(&self, row: usize, share: usize) -> usize {
        let equation = if row < self.size { row } else { self.below[row - self.size] as usize - self.start };
        equation * self.shares + share
    }

    /// Reads a number of each cache line in the order in which they lie in memory, so that the processor goes ahead of it from one supernode into
    /// the next: a factor that is larger than its caches comes in twice as fast as in the order in which the entries are needed.
    #[inline(always)]
    fn fetch(values: impl Iterator<Item = &'a f64>) {
        black_box(values.step_by(8).fold(0, |all, value| all | value.to_bits()));
    }

    /// `sums - entry * others`.
    #[inline(always)]
    fn less<const V: usize>(&self, sums: &mut [S::f64s; V], entry: f64, others: &[S::f64s; V]) {
        let entry = self.simd.splat_f64s(entry);
        for v in 0..V {
            sums[v] = self.simd.negate_mul_add_e_f64s(entry, others[v], sums[v]);
        }
    }

    #[inline(always)]
    fn divide<const V: usize>(&self, sums: &mut [S::f64s; V], pivot: f64) {
        let inverse = self.simd.splat_f64s(1.0 / pivot);
        for v in 0..V {
            sums[v] = self.simd.mul_f64s(sums[v], inverse);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::sparse::linalg::cholesky::{
        CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering, factorize_symbolic_cholesky,
    };
    use faer::sparse::linalg::{SupernodalThreshold, SymbolicSupernodalParams};
    use faer::sparse::{SparseColMat, Triplet};
    use faer::{Par, Side};

    /// A membrane of so many by so many nodes: four times each less its neighbours, and a little more on the diagonal.
    fn membrane(across: usize) -> SparseColMat<u32, f64> {
        let n = across * across;
        let mut entries = Vec::new();
        for i in 0..n {
            entries.push(Triplet::new(i as u32, i as u32, 4.0 + 0.01 * i as f64));
            if (i + 1) % across != 0 {
                entries.push(Triplet::new(i as u32 + 1, i as u32, -1.0));
            }
            if i + across < n {
                entries.push(Triplet::new((i + across) as u32, i as u32, -1.0));
            }
        }
        SparseColMat::try_new_from_triplets(n, n, &entries).unwrap()
    }

    fn symbolic(matrix: &SparseColMat<u32, f64>) -> SymbolicCholesky<u32> {
        let parameters = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            supernodal_params: SymbolicSupernodalParams { relax: Some(&[(4, 1.0), (16, 0.8)]) },
            ..CholeskySymbolicParams::default()
        };
        factorize_symbolic_cholesky(matrix.symbolic(), Side::Lower, SymmetricOrdering::Amd, parameters).unwrap()
    }

    fn values(symbolic: &SymbolicCholesky<u32>, matrix: &SparseColMat<u32, f64>) -> Vec<f64> {
        let mut values = vec![0.0; symbolic.len_val()];
        let need = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        let mut memory = faer::dyn_stack::MemBuffer::new(need);
        let (plain, stack) = (Default::default(), faer::dyn_stack::MemStack::new(&mut memory));
        let matrix = matrix.as_ref();
        let more = Default::default();
        symbolic.factorize_numeric_llt(&mut values, matrix, Side::Lower, plain, Par::Seq, stack, more).unwrap();
        values
    }

    #[test]
    fn every_width_and_processor_solves_the_system() {
        // Numbers of columns and of rows below them that are left over by fours.
        let mut left_over = [[false; 4]; 2];
        for across in [9, 14] {
            let matrix = membrane(across);
            let symbolic = symbolic(&matrix);
            let SymbolicCholeskyRaw::Supernodal(nodes) = symbolic.raw() else { panic!("no supernodes") };
            let values = values(&symbolic, &matrix);
            for index in 0..nodes.n_supernodes() {
                let node = SupernodalLltRef::new(nodes, &values).supernode(index);
                left_over[0][node.val().ncols() % 4] = true;
                left_over[1][node.pattern().len() % 4] = true;
            }
            for width in WIDTHS {
                solves(&matrix, nodes, &values, symbolic.perm().unwrap().arrays().1, width);
            }
        }
        assert_eq!(left_over, [[true; 4]; 2]);
    }

    fn solves(
        matrix: &SparseColMat<u32, f64>,
        nodes: &SymbolicSupernodalCholesky<u32>,
        values: &[f64],
        place: &[u32],
        width: usize,
    ) {
        let n = matrix.nrows();
        // A right-hand side that is all but empty, so that supernodes are passed over in an empty block, and full ones.
        let alone = |k: usize| f64::from(u8::from(k / width == 40));
        let full = |k: usize| if k.is_multiple_of(width) { alone(k) } else { ((7 * k) % 13) as f64 - 6.0 };
        let few = [3_u32, 17, 40];
        let mut wanted = Vec::new();
        few.into_iter().for_each(|place| reach(nodes, &mut wanted, std::iter::once(place)));
        for right in [(0..n * width).map(alone).collect::<Vec<f64>>(), (0..n * width).map(full).collect()] {
            let mut wide = right.clone();
            solve(nodes, values, width, &mut wide, None);
            for lane in 0..width {
                let mut left: Vec<f64> = (0..n).map(|i| right[place[i] as usize * width + lane]).collect();
                for entry in matrix.triplet_iter() {
                    let (i, j, value) = (entry.row, entry.col, *entry.val);
                    left[i] -= value * wide[place[j] as usize * width + lane];
                    if i != j {
                        left[j] -= value * wide[place[i] as usize * width + lane];
                    }
                }
                // Rounding: some tens of operations on numbers up to 6.
                assert!(left.iter().all(|left| left.abs() < 1e-13), "width {width}, lane {lane}: {left:?}");
            }
            // The solution in a few places alone, with the same bits; elsewhere some of it is not found.
            let mut part = right.clone();
            solve(nodes, values, width, &mut part, Some(&wanted));
            for place in few.map(|place| place as usize * width) {
                assert_eq!(part[place..place + width], wide[place..place + width], "width {width}");
            }
            assert!(part != wide && wanted.iter().any(|wanted| !wanted));
            let factor = SupernodalLltRef::new(nodes, values);
            let mut narrow = right.clone();
            Work { factor, width, x: &mut narrow, wanted: None }.with_simd(pulp::Scalar);
            assert!(wide.iter().zip(&narrow).all(|(a, b)| (a - b).abs() < 1e-14), "width {width}");
            // Whatever the width of registers, the same bits where numbers are multiplied and added at once.
            #[cfg(target_arch = "x86_64")]
            if let Some(v3) = pulp::x86::V3::try_new() {
                let mut narrow = right.clone();
                Simd::vectorize(v3, Work { factor, width, x: &mut narrow, wanted: None });
                assert_eq!(narrow, wide, "width {width}");
            }
        }
    }
}
