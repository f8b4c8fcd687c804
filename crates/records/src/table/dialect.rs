//! How a table is written: what stands between its cells, and the decimal mark.

use super::number::{Cell, cell};
use std::borrow::Cow;

/// Lines that are looked at for headings, separators and decimal marks.
pub(super) const SAMPLE: usize = 200;

/// What the caller knows of how the table is written; the rest is seen from its first lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Dialect {
    /// What stands between cells: ';', ',' or a tab.
    pub separator: Option<char>,
    /// Whether decimals stand after a comma.
    pub decimal_comma: Option<bool>,
}

/// How the table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Written {
    pub separator: char,
    pub decimal_comma: bool,
}

/// Sees from some lines how they are written. A semicolon or a tab in at least half of the lines separates, otherwise a comma;
/// decimals stand after a comma where more cells can be read so.
pub(super) fn seen(sample: &[&str], known: Dialect) -> Written {
    // What stands within quotation marks separates nothing.
    let has = |line: &str, mark: char| line.split('"').step_by(2).any(|outside| outside.contains(mark));
    let in_half = |mark: char| 2 * sample.iter().filter(|line| has(line, mark)).count() >= sample.len().max(1);
    let separator = known
        .separator
        .filter(char::is_ascii)
        .unwrap_or_else(|| [';', '\t'].into_iter().find(|mark| in_half(*mark)).unwrap_or(','));
    let count = |comma: bool| {
        let cells = sample.iter().flat_map(|line| fields(line, separator));
        cells.filter(|text| matches!(cell(text, comma), Cell::Number(..))).count()
    };
    let decimal_comma = known.decimal_comma.unwrap_or_else(|| separator != ',' && count(true) > count(false));
    Written { separator, decimal_comma }
}

/// The cells of one line. Every line stands for itself, so that a stray quotation mark cannot swallow the lines that follow it.
pub(super) fn fields(line: &str, separator: char) -> Vec<Cow<'_, str>> {
    let mut cells = Vec::new();
    fields_into(line, separator, &mut cells);
    cells
}

/// The same into a buffer.
pub(super) fn fields_into<'a>(line: &'a str, separator: char, cells: &mut Vec<Cow<'a, str>>) {
    cells.clear();
    if !line.contains('"') {
        cells.extend(line.split(separator).map(Cow::Borrowed));
        return;
    }
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .delimiter(u8::try_from(separator).unwrap_or(b','))
        .from_reader(line.as_bytes());
    let mut record = csv::StringRecord::new();
    match reader.read_record(&mut record) {
        Ok(true) => cells.extend(record.iter().map(|cell| Cow::Owned(cell.to_owned()))),
        _ => cells.push(Cow::Borrowed(line)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn separators_and_decimal_marks_are_seen() {
        let known = Dialect::default();
        assert_eq!(seen(&["t,a", "0.1,0.2"], known), Written { separator: ',', decimal_comma: false });
        assert_eq!(seen(&["t;a", "0,1;0,2"], known), Written { separator: ';', decimal_comma: true });
        assert_eq!(seen(&["t\ta", "0.1\t0.2"], known), Written { separator: '\t', decimal_comma: false });
        assert_eq!(seen(&[], known), Written { separator: ',', decimal_comma: false });
        assert_eq!(fields("\"a, b\",2", ','), ["a, b", "2"]);
        assert_eq!(fields("\"a, b", ','), ["a, b"]);
    }
}
