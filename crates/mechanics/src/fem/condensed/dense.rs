//! Small dense systems, factorised again and again.

use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::lu::partial_pivoting::{factor, solve};
use faer::perm::PermRef;
use faer::traits::RealField;
use faer::{Conj, MatMut, MatRef, Par};
use std::ops::{Add, Mul, SubAssign};

/// Numbers with which a system is kept.
pub(super) trait Digits:
    RealField + Copy + Default + Add<Output = Self> + Mul<Output = Self> + SubAssign
{
    /// As near to the number as it comes.
    fn of(value: f64) -> Self;
    fn whole(self) -> f64;
}

impl Digits for f32 {
    #[inline(always)]
    fn of(value: f64) -> f32 {
        value as f32
    }

    #[inline(always)]
    fn whole(self) -> f64 {
        f64::from(self)
    }
}

impl Digits for f64 {
    #[inline(always)]
    fn of(value: f64) -> f64 {
        value
    }

    #[inline(always)]
    fn whole(self) -> f64 {
        self
    }
}

/// A square system and its factors (`P A = L U`), which take its place.
#[derive(Default)]
pub(super) struct Dense<D> {
    size: usize,
    /// The transpose of the system by columns, that is the system by rows.
    values: Vec<D>,
    forward: Vec<usize>,
    backward: Vec<usize>,
    right: Vec<D>,
    memory: Option<MemBuffer>,
}

impl<D: Digits> Dense<D> {
    /// Begins with one on the diagonal and nothing elsewhere; gives the entries by rows.
    pub fn unit(&mut self, size: usize) -> &mut [D] {
        self.size = size;
        self.values.clear();
        self.values.resize(size * size, D::default());
        (0..size).for_each(|i| self.values[i * size + i] = D::of(1.0));
        &mut self.values
    }

    pub fn factorise(&mut self) {
        let size = self.size;
        self.forward.resize(size, 0);
        self.backward.resize(size, 0);
        let need = factor::lu_in_place_scratch::<usize, D>(size, size, Par::Seq, Default::default());
        let stack = stack(&mut self.memory, need);
        let (forward, backward) = (&mut self.forward[..], &mut self.backward[..]);
        let values = MatMut::from_column_major_slice_mut(&mut self.values, size, size);
        factor::lu_in_place(values, forward, backward, Par::Seq, stack, Default::default());
    }

    /// Solves in place for right-hand sides one after the other.
    pub fn solve(&mut self, right: &mut [f64]) {
        let size = self.size;
        if size == 0 {
            return;
        }
        let count = right.len() / size;
        self.right.clear();
        self.right.extend(right.iter().map(|x| D::of(*x)));
        let need = solve::solve_transpose_in_place_scratch::<usize, D>(size, count, Par::Seq);
        let stack = stack(&mut self.memory, need);
        let factors = MatRef::from_column_major_slice(&self.values, size, size);
        let sides = MatMut::from_column_major_slice_mut(&mut self.right, size, count);
        let order = PermRef::new_checked(&self.forward, &self.backward, size);
        solve::solve_transpose_in_place_with_conj(factors, factors, order, Conj::No, sides, Par::Seq, stack);
        right.iter_mut().zip(&self.right).for_each(|(x, solved)| *x = solved.whole());
    }
}

/// Memory for so much, which stays for the next time.
fn stack(memory: &mut Option<MemBuffer>, need: StackReq) -> &mut MemStack {
    if memory.as_ref().is_none_or(|memory| memory.len() < need.unaligned_bytes_required()) {
        *memory = None;
    }
    MemStack::new(memory.get_or_insert_with(|| MemBuffer::new(need)))
}
