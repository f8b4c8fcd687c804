//! Solutions for many right-hand sides at a time with a factor that a library has made.
//!
//! The library keeps right-hand sides as columns, so that each entry of the factor meets numbers that lie a whole vector apart. Here
//! those of one equation lie side by side: an entry is read once and meets all of them in the processor's registers. With 53,498 equations and
//! 3.3 million entries 248 right-hand sides take 0.28 s, copies in and out included, where the library takes 0.39 s (one core, beside other
//! programs); where the library keeps single columns (13,614 equations) it goes through them one after the other, and an evaluation for updating fell
//! from 1.02 s to 0.42 s.

use faer::sparse::linalg::cholesky::supernodal::{SupernodalLltRef, SymbolicSupernodalCholesky};

/// Right-hand sides of a narrow and of a wide block.
pub(super) const WIDTHS: [usize; 2] = [8, 32];

/// Solves `L L^T x = right` in place: `x` has a number for each of `width` right-hand sides, one of [`WIDTHS`], and after them those of the
/// next equation in the order of elimination. Of supernodes that are not among the `wanted`, [`reached`], nothing is found.
pub(super) fn solve(
    symbolic: &SymbolicSupernodalCholesky<u32>,
    values: &[f64],
    width: usize,
    x: &mut [f64],
    wanted: Option<&[bool]>,
) {
    let factor = SupernodalLltRef::new(symbolic, values);
    if width == WIDTHS[0] {
        solve_lanes::<{ WIDTHS[0] }>(factor, x.as_chunks_mut().0, wanted);
    } else {
        solve_lanes::<{ WIDTHS[1] }>(factor, x.as_chunks_mut().0, wanted);
    }
}

/// Supernodes that have to be gone through backward for the solution at some places of the order of elimination: theirs, and those that were eliminated
/// after them and are coupled with them.
pub(super) fn reached(symbolic: &SymbolicSupernodalCholesky<u32>, places: impl Iterator<Item = u32>) -> Vec<bool> {
    let begin = symbolic.supernode_begin();
    let node = |place: u32| begin.partition_point(|first| *first <= place) - 1;
    let mut wanted = vec![false; symbolic.n_supernodes()];
    places.for_each(|place| wanted[node(place)] = true);
    for index in 0..wanted.len() {
        // All others that it is coupled with are among those of the first one's.
        if let (true, Some(&next)) = (wanted[index], symbolic.supernode(index).pattern().first()) {
            wanted[node(next)] = true;
        }
    }
    wanted
}

fn solve_lanes<const W: usize>(factor: SupernodalLltRef<'_, u32, f64>, x: &mut [[f64; W]], wanted: Option<&[bool]>) {
    let mut work = Work { factor, x, wanted };
    #[cfg(target_arch = "x86_64")]
    if let Some(v4) = pulp::x86::V4::try_new() {
        return v4.vectorize(Fused(work));
    } else if let Some(v3) = pulp::x86::V3::try_new() {
        return v3.vectorize(Fused(work));
    }
    work.forward::<false>();
    work.backward::<false>();
}

struct Work<'a, const W: usize> {
    factor: SupernodalLltRef<'a, u32, f64>,
    x: &'a mut [[f64; W]],
    wanted: Option<&'a [bool]>,
}

/// The work on a processor that multiplies and adds at once.
#[cfg(target_arch = "x86_64")]
struct Fused<'a, const W: usize>(Work<'a, W>);

#[cfg(target_arch = "x86_64")]
impl<const W: usize> pulp::NullaryFnOnce for Fused<'_, W> {
    type Output = ();
    #[inline(always)]
    fn call(self) {
        let mut work = self.0;
        work.forward::<true>();
        work.backward::<true>();
    }
}

/// `sums - entry * others`.
#[inline(always)]
fn less<const FUSED: bool, const W: usize>(sums: &mut [f64; W], entry: f64, others: &[f64; W]) {
    for lane in 0..W {
        sums[lane] = if FUSED { others[lane].mul_add(-entry, sums[lane]) } else { sums[lane] - entry * others[lane] };
    }
}

impl<const W: usize> Work<'_, W> {
    /// `L y = right`. Supernodes that no right-hand side reaches are passed over.
    #[inline(always)]
    fn forward<const FUSED: bool>(&mut self) {
        for index in 0..self.factor.symbolic().n_supernodes() {
            let node = self.factor.supernode(index);
            let (start, matrix, pattern) = (node.start(), node.val(), node.pattern());
            let size = matrix.ncols();
            let (before, below) = self.x.split_at_mut(start + size);
            let own = &mut before[start..];
            if own.iter().flatten().all(|value| *value == 0.0) {
                continue;
            }
            for i in 0..size {
                let (above, rest) = own.split_at_mut(i);
                let mut sums = rest[0];
                for (j, other) in above.iter().enumerate() {
                    less::<FUSED, W>(&mut sums, matrix[(i, j)], other);
                }
                let pivot = matrix[(i, i)];
                rest[0] = sums;
                rest[0].iter_mut().for_each(|value| *value /= pivot);
            }
            for (k, &row) in pattern.iter().enumerate() {
                let place = &mut below[row as usize - start - size];
                let mut sums = *place;
                for (j, other) in own.iter().enumerate() {
                    less::<FUSED, W>(&mut sums, matrix[(size + k, j)], other);
                }
                *place = sums;
            }
        }
    }

    /// `L^T x = y`.
    #[inline(always)]
    fn backward<const FUSED: bool>(&mut self) {
        for index in (0..self.factor.symbolic().n_supernodes()).rev() {
            if self.wanted.is_some_and(|wanted| !wanted[index]) {
                continue;
            }
            let node = self.factor.supernode(index);
            let (start, matrix, pattern) = (node.start(), node.val(), node.pattern());
            let size = matrix.ncols();
            let (before, below) = self.x.split_at_mut(start + size);
            let own = &mut before[start..];
            for j in (0..size).rev() {
                let (mine, later) = own.split_at_mut(j + 1);
                let mut sums = mine[j];
                let column = matrix.col(j);
                for (k, &row) in pattern.iter().enumerate() {
                    less::<FUSED, W>(&mut sums, column[size + k], &below[row as usize - start - size]);
                }
                for (i, other) in later.iter().enumerate() {
                    less::<FUSED, W>(&mut sums, column[j + 1 + i], other);
                }
                let pivot = column[j];
                mine[j] = sums;
                mine[j].iter_mut().for_each(|value| *value /= pivot);
            }
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

    const ACROSS: usize = 9;

    /// A membrane of 9 by 9 nodes: four times each less its neighbours, and a little more on the diagonal.
    fn membrane() -> SparseColMat<u32, f64> {
        let mut entries = Vec::new();
        for i in 0..ACROSS * ACROSS {
            entries.push(Triplet::new(i as u32, i as u32, 4.0 + 0.01 * i as f64));
            if (i + 1) % ACROSS != 0 {
                entries.push(Triplet::new(i as u32 + 1, i as u32, -1.0));
            }
            if i + ACROSS < ACROSS * ACROSS {
                entries.push(Triplet::new((i + ACROSS) as u32, i as u32, -1.0));
            }
        }
        SparseColMat::try_new_from_triplets(ACROSS * ACROSS, ACROSS * ACROSS, &entries).unwrap()
    }

    fn symbolic(matrix: &SparseColMat<u32, f64>) -> SymbolicCholesky<u32> {
        let parameters = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            supernodal_params: SymbolicSupernodalParams { relax: Some(&[(4, 1.0), (16, 0.8)]) },
            ..CholeskySymbolicParams::default()
        };
        factorize_symbolic_cholesky(matrix.symbolic(), Side::Lower, SymmetricOrdering::Amd, parameters).unwrap()
    }

    #[test]
    fn every_width_and_processor_solves_the_system() {
        let matrix = membrane();
        let symbolic = symbolic(&matrix);
        let SymbolicCholeskyRaw::Supernodal(nodes) = symbolic.raw() else { panic!("no supernodes") };
        let mut values = vec![0.0; symbolic.len_val()];
        let need = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        let mut memory = faer::dyn_stack::MemBuffer::new(need);
        let stack = faer::dyn_stack::MemStack::new(&mut memory);
        let plain = Default::default();
        symbolic
            .factorize_numeric_llt(
                &mut values,
                matrix.as_ref(),
                Side::Lower,
                plain,
                Par::Seq,
                stack,
                Default::default(),
            )
            .unwrap();
        let n = ACROSS * ACROSS;
        let place = symbolic.perm().unwrap().arrays().1;
        for width in WIDTHS {
            // A right-hand side that is all but empty, so that supernodes are passed over, and full ones.
            let right: Vec<f64> = (0..n * width)
                .map(
                    |k| if k % width == 0 { f64::from(u8::from(k / width == 40)) } else { ((7 * k) % 13) as f64 - 6.0 },
                )
                .collect();
            let mut wide = right.clone();
            solve(nodes, &values, width, &mut wide, None);
            let mut narrow = right.clone();
            if width == WIDTHS[0] {
                let factor = SupernodalLltRef::new(nodes, &values);
                let mut work = Work { factor, x: narrow.as_chunks_mut::<8>().0, wanted: None };
                work.forward::<false>();
                work.backward::<false>();
            }
            for lane in 0..width {
                let mut left: Vec<f64> = (0..n).map(|i| right[place[i] as usize * width + lane]).collect();
                for entry in matrix.triplet_iter() {
                    let (i, j, value) = (entry.row, entry.col, *entry.val);
                    left[i] -= value * wide[place[j] as usize * width + lane];
                    if i != j {
                        left[j] -= value * wide[place[i] as usize * width + lane];
                    }
                }
                assert!(left.iter().all(|left| left.abs() < 1e-13), "width {width}, lane {lane}: {left:?}");
            }
            // The solution in a few places alone, with the same bits; elsewhere some of it is not found.
            let few = [3_u32, 17, 40];
            let wanted = reached(nodes, few.into_iter());
            let mut part = right.clone();
            solve(nodes, &values, width, &mut part, Some(&wanted));
            for place in few.map(|place| place as usize * width) {
                assert_eq!(part[place..place + width], wide[place..place + width], "width {width}");
            }
            assert!(part != wide && wanted.iter().any(|wanted| !wanted));
            if width == WIDTHS[0] {
                assert!(wide.iter().zip(&narrow).all(|(a, b)| (a - b).abs() < 1e-14));
            }
        }
    }
}
