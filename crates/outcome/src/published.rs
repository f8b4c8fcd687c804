//! The formats others rely on: JSON objects and CSV tables. Keys carry their unit, a meaning that stands never changes.
//! `extrados.NAME/1` is the schema of the object of the command NAME, which adds what only it knows: its own warnings, the
//! wall clock and the threads.

mod assess;
mod calibration;
mod collapse;
mod particles;
mod passage;
mod shapes;
mod sweep;
mod tables;
mod update;
mod validation;
mod vary;
mod vehicles;

pub use assess::{assessment, checks_table};
pub use calibration::{calibration, calibration_curves, calibration_moduli};
pub use collapse::{collapse, strip};
pub use particles::{particle_contacts, particles};
pub use passage::{channels_table, influence_table, joint_states, passage, passage_log, thrust_lines};
pub use shapes::{schema_of_rules, schema_of_vehicles};
pub use sweep::sweep;
pub use tables::{blocks, contacts, hinges, path, sweep_table, thrust_line};
pub use update::{histories_table, samples_table, sweeps_table, told, update};
pub use validation::{record, validation, validation_table};
pub use vary::{collapse_numbers, run_from_record, run_record, vary, vary_table};
pub use vehicles::{vehicle_envelope_table, vehicle_sections_table, vehicle_sweep, vehicles_table};

use crate::warning::Warning;
use serde::Serialize;
use serde_json::Value;

/// A JSON object, its keys in the order in which they were written.
pub type Object = serde_json::Map<String, Value>;

/// An [`Object`], each key written once: `key: value`; `key?: option`, left out where there is nothing; `..object`, whose keys
/// stand here, none where there is no object.
macro_rules! object {
    (@ $to:ident) => {};
    (@ $to:ident .. $group:expr, $($rest:tt)*) => {
        $to.extend($group.into_iter().flatten());
        object!(@ $to $($rest)*);
    };
    (@ $to:ident $key:ident ? : $value:expr, $($rest:tt)*) => {
        if let Some(value) = &$value {
            $to.insert(stringify!($key).to_owned(), serde_json::json!(value));
        }
        object!(@ $to $($rest)*);
    };
    (@ $to:ident $key:ident : $value:expr, $($rest:tt)*) => {
        $to.insert(stringify!($key).to_owned(), serde_json::json!($value));
        object!(@ $to $($rest)*);
    };
    ($($entries:tt)*) => {{
        let mut to = crate::published::Object::new();
        object!(@ to $($entries)*);
        to
    }};
}

/// A row at the end of a CSV table, cell by cell: a list is as many cells, and nothing an empty one.
macro_rules! row {
    ($to:expr, $($cell:expr),+ $(,)?) => {{
        let cells: &[&dyn crate::published::Cell] = &[$(&$cell),+];
        crate::published::write_row($to, cells);
    }};
}

use {object, row};

/// What stands in cells of a CSV table.
trait Cell {
    fn write(&self, to: &mut Vec<String>);
}

macro_rules! numbers { ($($Number:ty),*) => { $(impl Cell for $Number {
    fn write(&self, to: &mut Vec<String>) {
        to.push(self.to_string());
    }
})* } }

numbers!(f64, u32, u64, usize, bool, Quoted<'_>);

/// A text as spreadsheets read it (RFC 4180): in quotes where it must be.
impl Cell for str {
    fn write(&self, to: &mut Vec<String>) {
        to.push(match self.contains(['"', ',', '\n', '\r']) {
            true => Quoted(self).to_string(),
            false => self.to_owned(),
        });
    }
}

impl Cell for String {
    fn write(&self, to: &mut Vec<String>) {
        self.as_str().write(to);
    }
}

impl<T: Cell + ?Sized> Cell for &T {
    fn write(&self, to: &mut Vec<String>) {
        (**self).write(to);
    }
}

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

impl<T: Cell> Cell for Vec<T> {
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
struct Quoted<'a>(&'a str);

impl std::fmt::Display for Quoted<'_> {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(to, "\"{}\"", self.0.replace('"', "\"\""))
    }
}

fn write_row(to: &mut String, cells: &[&dyn Cell]) {
    let mut texts = Vec::new();
    cells.iter().for_each(|cell| cell.write(&mut texts));
    *to += &texts.join(",");
    to.push('\n');
}

/// As many cells, or empty ones.
fn each<T: Copy, const N: usize>(all: Option<[T; N]>) -> [Option<T>; N] {
    std::array::from_fn(|k| all.map(|all| all[k]))
}

/// Numbers from 1, as people count axles and spans.
fn from_one(numbers: Option<[usize; 2]>) -> Option<[usize; 2]> {
    numbers.map(|numbers| numbers.map(|k| k + 1))
}

/// One object for each.
fn list<T>(of: impl IntoIterator<Item = T>, one: impl FnMut(T) -> Object) -> Vec<Object> {
    of.into_iter().map(one).collect()
}

/// Warnings of an analysis.
fn warnings(of: &[Warning]) -> Vec<Object> {
    list(of, |warning| object! { code: warning.code, message: warning.message, })
}

/// Any object as JSON text, with a newline at its end.
pub fn json<T: Serialize>(object: &T) -> String {
    let mut text = serde_json::to_string_pretty(object).expect("numbers and strings always have a JSON form");
    text.push('\n');
    text
}

/// N/m in kN/m, or N in kN.
fn kilo(value: f64) -> f64 {
    value / 1e3
}

/// Text, where there is some.
fn said(text: &str) -> Option<&str> {
    (!text.is_empty()).then_some(text)
}
