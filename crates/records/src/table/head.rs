//! The headings of a table: one line above the numbers, two where units stand below the names, and the heads of loggers.

use super::dialect::{self, SAMPLE};
use super::heading::Heading;
use super::mapping::ReadOptions;
use super::number::{Cell, cell};
use super::plan;
use super::stamp::stamp;
use crate::Unit;

/// What stands above the rows.
pub(super) struct Head {
    /// Line of the headings; 0 where there is none.
    pub line: usize,
    pub headings: Vec<Heading>,
    /// First line that may hold data.
    pub first_row: usize,
}

/// Lines of a table as far as headings are looked for, cut into cells.
struct Sample(Vec<(usize, Vec<String>)>);

impl Sample {
    /// Cells without those that are empty at the end.
    fn trimmed(&self, at: usize) -> &[String] {
        let cells = &self.0[at].1;
        let end = cells.iter().rposition(|cell| !cell.is_empty()).map_or(1, |last| last + 1);
        &cells[..end.min(cells.len())]
    }

    fn headings(&self, at: usize) -> Vec<Heading> {
        self.trimmed(at).iter().map(|cell| Heading::of(cell)).collect()
    }

    fn first_cell(&self, at: usize) -> &str {
        self.0.get(at).and_then(|(_, cells)| cells.first()).map_or("", String::as_str)
    }
}

/// Finds the headings among lines that are neither blank nor comments.
pub(super) fn head<'a>(
    candidates: impl Iterator<Item = (usize, &'a str)>,
    options: &ReadOptions,
    separator: char,
) -> Head {
    let cells = |line: &str| dialect::fields(line, separator).iter().map(|cell| cell.trim().to_owned()).collect();
    let sample = Sample(candidates.take(SAMPLE).map(|(line, text)| (line, cells(text))).collect());
    if !options.mapping.headed {
        let first = sample.0.first();
        let numbered = (1..=first.map_or(0, |(_, cells)| cells.len())).map(|k| Heading::of(&format!("column {k}")));
        return Head { line: 0, headings: numbered.collect(), first_row: first.map_or(1, |(line, _)| *line) };
    }
    if let Some(head) = campbell(&sample).or_else(|| labview(&sample)) {
        return head;
    }
    // "Time;02:59:54" among the lines above a table tells when it was made.
    let is_headed = |at: &usize| {
        plan::clock(&sample.headings(*at), &options.mapping).is_some()
            && !sample.0[*at].1.iter().any(|cell| stamp(cell).is_some())
    };
    let Some(at) = (0..sample.0.len()).find(is_headed) else {
        let line = sample.0.first().map_or(1, |(line, _)| *line);
        return Head { line, headings: sample.headings(0), first_row: line + 1 };
    };
    with_units_below(&sample, at)
}

/// Some loggers write the units on a line of their own.
fn with_units_below(sample: &Sample, at: usize) -> Head {
    let line = sample.0[at].0;
    let mut headings = sample.headings(at);
    let head = |headings, last: usize| Head { line, headings, first_row: last + 1 };
    let Some((units_line, units)) = sample.0.get(at + 1) else { return head(headings, line) };
    // A hyphen is a unit, but also a word for nothing.
    let known = |symbol: &&String| symbol.as_str() != "-" && Unit::named(symbol).is_some();
    let is_number = |symbol: &str| [true, false].iter().any(|comma| matches!(cell(symbol, *comma), Cell::Number(..)));
    let is_data = |symbol: &String| is_number(symbol) || stamp(symbol).is_some();
    let named = units.iter().filter(|symbol| !symbol.is_empty()).count();
    let wanted = headings.iter().any(|heading| heading.symbol.is_none()) && units.len() >= headings.len();
    if !wanted || 2 * units.iter().filter(known).count() < named.max(1) || units.iter().any(is_data) {
        return head(headings, line);
    }
    take_units(&mut headings, units);
    head(headings, *units_line)
}

fn take_units(headings: &mut [Heading], units: &[String]) {
    for (heading, symbol) in headings.iter_mut().zip(units) {
        if heading.symbol.is_none() && !symbol.is_empty() {
            heading.symbol = Some(symbol.clone());
        }
    }
}

/// Files of Campbell Scientific's loggers: station, names, units, and how each value was made (LoggerNet manual, appendix B); TOACI1 has the
/// first two alone.
fn campbell(sample: &Sample) -> Option<Head> {
    let kind = sample.first_cell(0);
    if !matches!(kind, "TOA5" | "TOACI1") || sample.0.len() < 2 {
        return None;
    }
    let mut headings = sample.headings(1);
    let mut last = sample.0[1].0;
    if kind == "TOA5" {
        for (at, (line, cells)) in sample.0.iter().enumerate().skip(2).take(2) {
            if stamp(sample.first_cell(at)).is_some() {
                break;
            }
            if at == 2 {
                take_units(&mut headings, cells);
            }
            last = *line;
        }
    }
    Some(Head { line: sample.0[1].0, headings, first_row: last + 1 })
}

/// Text files of LabVIEW (NI, "Specification for the LabVIEW measurement file", 2020): times in seconds under X_Value, units in a line above.
fn labview(sample: &Sample) -> Option<Head> {
    if !sample.first_cell(0).starts_with("LabVIEW Measurement") {
        return None;
    }
    let at = (0..sample.0.len()).find(|at| sample.first_cell(*at) == "X_Value")?;
    let mut headings = sample.headings(at);
    if headings.last().is_some_and(|heading| heading.name == "Comment") {
        headings.pop();
    }
    headings[0].symbol = Some("s".to_owned());
    if let Some(units) = (0..at).rev().find(|at| sample.first_cell(*at) == "Y_Unit_Label") {
        take_units(&mut headings, &sample.0[units].1);
    }
    Some(Head { line: sample.0[at].0, headings, first_row: sample.0[at].0 + 1 })
}
