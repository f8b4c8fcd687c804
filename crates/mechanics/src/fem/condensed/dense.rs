//! Small dense systems, factorised again and again in the same memory.

use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::lu::partial_pivoting::{factor, solve};
use faer::perm::PermRef;
use faer::traits::RealField;
use faer::{Conj, MatMut, MatRef, Par};
use std::ops::{Add, Mul, SubAssign};

/// The floating-point type in which a system and its factors are stored.
pub(super) trait Precision:
    RealField + Copy + Default + Into<f64> + Add<Output = Self> + Mul<Output = Self> + SubAssign
{
}

impl Precision for f32 {}
impl Precision for f64 {}

/// A square matrix `A` and then, in its place, its factors: `P A = L U`.
#[derive(Default)]
pub(super) struct Dense<D> {
    size: usize,
    /// The transpose of `A` by columns, that is `A` by rows.
    values: Vec<D>,
    /// The permutation `P`, and its inverse.
    row_order: Vec<usize>,
    inverse_order: Vec<usize>,
    /// Right-hand sides in the precision of the factors.
    scratch: Vec<D>,
    memory: Option<MemBuffer>,
}

impl<D: Precision> Dense<D> {
    /// Sets `A` to the identity of a given size; gives its entries by rows for the caller to add to.
    pub(super) fn set_identity(&mut self, size: usize) -> &mut [D] {
        self.size = size;
        self.values.clear();
        self.values.resize(size * size, D::default());
        (0..size).for_each(|i| self.values[i * size + i] = D::from_f64_impl(1.0));
        &mut self.values
    }

    /// Factorises `A` in place, with partial pivoting.
    pub(super) fn factorise(&mut self) {
        let size = self.size;
        self.row_order.resize(size, 0);
        self.inverse_order.resize(size, 0);
        let requirement = factor::lu_in_place_scratch::<usize, D>(size, size, Par::Seq, Default::default());
        let stack = reserve(&mut self.memory, requirement);
        let (row_order, inverse_order) = (&mut self.row_order[..], &mut self.inverse_order[..]);
        let values = MatMut::from_column_major_slice_mut(&mut self.values, size, size);
        factor::lu_in_place(values, row_order, inverse_order, Par::Seq, stack, Default::default());
    }

    /// Solves `A x = right` in place, for one or more right-hand sides that follow one another.
    pub(super) fn solve(&mut self, right: &mut [f64]) {
        let size = self.size;
        if size == 0 {
            return;
        }
        let count = right.len() / size;
        self.scratch.clear();
        self.scratch.extend(right.iter().map(|x| D::from_f64_impl(*x)));
        let requirement = solve::solve_transpose_in_place_scratch::<usize, D>(size, count, Par::Seq);
        let stack = reserve(&mut self.memory, requirement);
        let factors = MatRef::from_column_major_slice(&self.values, size, size);
        let sides = MatMut::from_column_major_slice_mut(&mut self.scratch, size, count);
        let order = PermRef::new_checked(&self.row_order, &self.inverse_order, size);
        solve::solve_transpose_in_place_with_conj(factors, factors, order, Conj::No, sides, Par::Seq, stack);
        right.iter_mut().zip(&self.scratch).for_each(|(x, solved)| *x = (*solved).into());
    }
}

/// Gives scratch memory of the required size, which is kept for the next call.
fn reserve(memory: &mut Option<MemBuffer>, requirement: StackReq) -> &mut MemStack {
    if memory.as_ref().is_none_or(|memory| memory.len() < requirement.unaligned_bytes_required()) {
        *memory = None;
    }
    MemStack::new(memory.get_or_insert_with(|| MemBuffer::new(requirement)))
}
