//! The formats others rely on: JSON objects and CSV tables. Keys carry their unit, a meaning that stands never changes.
//! `extrados.NAME/1` is the schema of the object of the command NAME, which adds what only it knows: its own warnings, the
//! wall clock and the threads.

pub(crate) mod assess;
mod calibration;
mod particles;
mod passage;
mod shapes;
mod tables;
pub(crate) mod update;
mod validation;
pub(crate) mod vary;
mod vehicles;

pub use assess::{checks_table, with_sentences};
pub use calibration::{calibration_curves, calibration_moduli};
pub use particles::{particle_contacts, particles};
pub use passage::{channels_table, influence_table, joint_states, passage_log, thrust_lines};
pub use shapes::{schema_of_rules, schema_of_vehicles};
pub use tables::{blocks, contacts, hinges, path, sweep_table, thrust_line};
pub use update::{histories_table, samples_table, sweeps_table, told};
pub use validation::{record, validation_table};
pub use vary::{collapse_numbers, run_from_record, run_record, vary_table};
pub use vehicles::{vehicle_envelope_table, vehicle_sections_table, vehicles_table};

use findings::visible::is_hidden;
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

pub(crate) use object;
use row;

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

/// A text as spreadsheets read it, never as a formula.
impl Cell for str {
    fn write(&self, to: &mut Vec<String>) {
        to.push(findings::visible::cell(self));
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
        to.write_str(&findings::visible::quoted_cell(self.0))
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
pub(crate) fn list<T>(of: impl IntoIterator<Item = T>, one: impl FnMut(T) -> Object) -> Vec<Object> {
    of.into_iter().map(one).collect()
}

/// A number of an object by its key, or how many a list has; none where there is neither.
pub fn number(object: &Object, key: &str) -> Option<f64> {
    match object.get(key)? {
        Value::Array(list) => Some(list.len() as f64),
        value => value.as_f64(),
    }
}

/// Any object as JSON text, with a newline at its end. Characters that act instead of being seen stand as their numbers: it is the same
/// object to every reader, and does nothing to a terminal.
pub fn json<T: Serialize>(object: &T) -> String {
    let text = serde_json::to_string_pretty(object).expect("numbers and strings always have a JSON form");
    let mut out = String::with_capacity(text.len() + 1);
    for character in text.chars() {
        if is_hidden(character) && character != '\n' {
            let mut units = [0; 2];
            character.encode_utf16(&mut units).iter().for_each(|unit| out += &format!("\\u{unit:04x}"));
        } else {
            out.push(character);
        }
    }
    out.push('\n');
    out
}

/// N/m in kN/m, or N in kN.
pub(crate) fn kilo(value: f64) -> f64 {
    value / 1e3
}

/// Text, where there is some.
pub(crate) fn said(text: &str) -> Option<&str> {
    (!text.is_empty()).then_some(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_object_holds_nothing_that_acts_and_is_the_same_to_its_readers() {
        let object = serde_json::json!({ "name": "a\u{202e}b\u{9b}\u{1b}\u{7f}橋" });
        let text = json(&object);
        assert!(!text.chars().any(|one| is_hidden(one) && one != '\n'), "{text:?}");
        assert_eq!(serde_json::from_str::<Value>(&text).unwrap(), object);
    }
}
