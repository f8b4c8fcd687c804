//! Columns of results as NumPy arrays that look into the memory of the result: nothing is copied, nothing can be written, and the array
//! keeps the result alive. The only `unsafe` code of the module stands here.

#![allow(unsafe_code)]

use ndarray::{ArrayView1, ArrayView2, ShapeBuilder};
use numpy::{Element, PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use std::mem::{align_of, size_of};

/// A field of a row that a column can be made of: one number, or several that lie side by side.
pub(crate) trait Cell: 'static {
    /// One number of it.
    type Number: Element + Copy;
    /// How many there are; none where the field is a number itself.
    const WIDTH: Option<usize>;
}

macro_rules! cells { ($($Number:ty),*) => { $(
    impl Cell for $Number {
        type Number = $Number;
        const WIDTH: Option<usize> = None;
    }
    impl<const N: usize> Cell for [$Number; N] {
        type Number = $Number;
        const WIDTH: Option<usize> = Some(N);
    }
)* } }

cells!(f64, u64, usize, bool);

/// One field of all rows, as an array of one or two dimensions. `rows` must belong to `owner`, which never changes.
pub(crate) fn column<'py, T, C: Cell>(
    owner: &Bound<'py, PyAny>,
    rows: &[T],
    field: fn(&T) -> &C,
) -> PyResult<Bound<'py, PyAny>> {
    let stride = size_of::<T>() / size_of::<C::Number>();
    // Rows are as far apart as whole numbers, so that a stride can be told in them.
    assert!(size_of::<T>().is_multiple_of(size_of::<C::Number>()) && align_of::<T>() >= align_of::<C::Number>());
    let start = match rows.first() {
        Some(first) => {
            let offset = std::ptr::from_ref(field(first)).addr() - std::ptr::from_ref(first).addr();
            assert!(offset + size_of::<C>() <= size_of::<T>());
            // SAFETY: the field lies within the row, as was just seen.
            unsafe { rows.as_ptr().cast::<u8>().add(offset).cast::<C::Number>() }
        }
        None => std::ptr::NonNull::<C::Number>::dangling().as_ptr().cast_const(),
    };
    let container = owner.clone();
    match C::WIDTH {
        // SAFETY: every number that is reached this way is a field of a row of `rows`, all of which are initialised and properly
        // aligned. They live as long as `owner`, whose classes are frozen and hold their results behind `Arc`, and which the array
        // holds as its base.
        None => unsafe {
            let view = ArrayView1::from_shape_ptr((rows.len(),).strides((stride,)), start);
            let array = PyArray1::borrow_from_array(&view, container);
            Ok(array.try_readwrite()?.make_nonwriteable().as_any().clone())
        },
        Some(width) => unsafe {
            let view = ArrayView2::from_shape_ptr((rows.len(), width).strides((stride, 1)), start);
            let array = PyArray2::borrow_from_array(&view, container);
            Ok(array.try_readwrite()?.make_nonwriteable().as_any().clone())
        },
    }
}

/// A list of numbers or of points, as an array.
pub(crate) fn whole<'py, C: Cell>(owner: &Bound<'py, PyAny>, rows: &[C]) -> PyResult<Bound<'py, PyAny>> {
    column(owner, rows, |row| row)
}
