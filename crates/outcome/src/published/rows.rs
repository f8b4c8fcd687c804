//! Rows of CSV tables.

/// A row at the end of a CSV table, cell by cell: a list is as many cells, and nothing an empty one.
macro_rules! row {
    ($to:expr, $($cell:expr),+ $(,)?) => {{
        let cells: &[&dyn crate::published::rows::Cell] = &[$(&$cell),+];
        crate::published::rows::write_row($to, cells);
    }};
}

pub(super) use row;

/// What stands in cells of a CSV table.
pub(super) trait Cell {
    fn write(&self, to: &mut Vec<String>);
}

macro_rules! numbers { ($($Number:ty),*) => { $(impl Cell for $Number {
    fn write(&self, to: &mut Vec<String>) {
        to.push(self.to_string());
    }
})* } }

numbers!(f64, u32, u64, usize, bool, Quoted<'_>);

/// A text as spreadsheets read it, never as a formula.
impl Cell for str {
    fn write(&self, to: &mut Vec<String>) {
        to.push(findings::visible::cell(self));
    }
}

/// What holds another cell, or several, is written as that.
macro_rules! holds { ($([$($of:tt)*] $Holder:ty),*) => { $(impl<$($of)*> Cell for $Holder {
    fn write(&self, to: &mut Vec<String>) {
        (**self).write(to);
    }
})* } }

holds!([T: Cell + ?Sized] &T, [T: Cell] Vec<T>, [] String);

impl<T: Cell> Cell for [T] {
    fn write(&self, to: &mut Vec<String>) {
        self.iter().for_each(|cell| cell.write(to));
    }
}

impl<T: Cell, const N: usize> Cell for [T; N] {
    fn write(&self, to: &mut Vec<String>) {
        self.as_slice().write(to);
    }
}

impl<T: Cell> Cell for Option<T> {
    fn write(&self, to: &mut Vec<String>) {
        match self {
            Some(cell) => cell.write(to),
            None => to.push(String::new()),
        }
    }
}

/// A text that stands in quotes whatever it is.
pub(super) struct Quoted<'a>(pub(super) &'a str);

impl std::fmt::Display for Quoted<'_> {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        to.write_str(&findings::visible::quoted_cell(self.0))
    }
}

pub(super) fn write_row(to: &mut String, cells: &[&dyn Cell]) {
    let mut texts = Vec::new();
    cells.iter().for_each(|cell| cell.write(&mut texts));
    *to += &texts.join(",");
    to.push('\n');
}

/// As many cells, or empty ones.
pub(super) fn each<T: Copy, const N: usize>(all: Option<[T; N]>) -> [Option<T>; N] {
    std::array::from_fn(|k| all.map(|all| all[k]))
}

/// Numbers from 1, as people count axles and spans.
pub(super) fn from_one(numbers: Option<[usize; 2]>) -> Option<[usize; 2]> {
    numbers.map(|numbers| numbers.map(|k| k + 1))
}
