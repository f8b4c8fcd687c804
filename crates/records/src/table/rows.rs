//! Rows of numbers: the body of the table.

use super::clock::{Clock, Reader};
use super::dialect::{Written, fields, fields_into};
use super::faults::{Faults, Kind};
use super::number::{Cell, cell};
use super::plan::Plan;
use super::text::{is_blank, is_comment, lines};
use crate::{Finding, Place, Recording};
use findings::Severity;
use std::borrow::Cow;

const TEXT: Kind = Kind {
    code: "R020",
    what: "text in place of a number",
    then: "the sample is missing",
    help: "write a number, or leave the cell empty where there was none",
};
const NOT_FINITE: Kind = Kind {
    code: "R021",
    what: "NaN or infinite",
    then: "the sample is missing",
    help: "see why the logger could not measure there",
};
const EMPTY: Kind = Kind { code: "R022", what: "empty cell", then: "the sample is missing", help: "" };
const FEW: Kind = Kind {
    code: "R023",
    what: "row with too few cells",
    then: "it cannot be said which are there, so the row is left out",
    help: "complete the row, or take it out",
};
const MANY: Kind = Kind {
    code: "R024",
    what: "row with too many cells",
    then: "it cannot be said which belong where, so the row is left out",
    help: "where a comma both separates cells and marks decimals, separate cells by semicolons",
};
const NO_TIME: Kind = Kind {
    code: "R025",
    what: "row whose time is no number",
    then: "the row is left out",
    help: "write the time as a number in the unit of its heading",
};
const NO_STAMP: Kind = Kind {
    what: "row whose time is no stamp like those of the other rows",
    help: "write its date and time like those of the other rows",
    ..NO_TIME
};
const COMMENT: Kind = Kind { code: "R026", what: "comment amid the data", then: "it is no row", help: "" };

/// Where the rows stand, and how they are written.
#[derive(Clone, Copy)]
pub(super) struct Body<'a> {
    pub text: &'a str,
    /// First line that may hold a row.
    pub first_row: usize,
    pub written: Written,
}

impl<'a> Body<'a> {
    /// Lines that are not blank.
    fn lines(&self) -> impl Iterator<Item = (usize, &'a str)> + use<'a> {
        lines(self.text).skip(self.first_row.saturating_sub(1)).filter(|(_, line)| !is_blank(line))
    }

    /// Cells of every line that is no comment.
    pub(super) fn cells(&self) -> impl Iterator<Item = Vec<Cow<'a, str>>> + use<'a> {
        let separator = self.written.separator;
        self.lines().filter(|(_, line)| !is_comment(line)).map(move |(_, line)| fields(line, separator))
    }
}

/// Decimals of one column: fewest and most.
#[derive(Debug, Clone, Copy, Default)]
struct Decimals {
    range: Option<[usize; 2]>,
    exponents: bool,
}

impl Decimals {
    fn add(&mut self, decimals: Option<usize>) {
        match decimals {
            Some(n) => self.range = Some(self.range.map_or([n; 2], |[low, high]| [low.min(n), high.max(n)])),
            None => self.exponents = true,
        }
    }

    fn most(&self) -> Option<usize> {
        if self.exponents { None } else { Some(self.range.map_or(0, |[_, high]| high)) }
    }
}

/// The run with every row that could be taken.
pub(super) fn read(body: &Body, plan: Plan, run: Recording, findings: &mut Vec<Finding>) -> Recording {
    let Body { text, written, .. } = *body;
    let mut clock = Reader::new(&plan.clock, written);
    let no_time = if matches!(plan.clock, Clock::Stamps(_)) { NO_STAMP } else { NO_TIME };
    let time_column = plan.clock.column();
    let mut run = Recording { channels: plan.channels, ..run };
    let (mut faults, mut last) = (Faults::default(), Vec::new());
    let mut decimals = vec![Decimals::default(); run.channels.len()];
    let mut time_decimals = Decimals::default();
    let mut cells: Vec<Cow<str>> = Vec::new();
    let last_line = lines(text).filter(|(_, line)| !is_blank(line)).last().map_or(0, |(number, _)| number);
    let ended = text.ends_with(['\n', '\r']);
    for (row, (number, line)) in body.lines().enumerate() {
        if is_comment(line) {
            faults.add(COMMENT, 0, [row, number], None, line.trim());
            continue;
        }
        fields_into(line, written.separator, &mut cells);
        while cells.len() > plan.width && cells.last().is_some_and(|cell| cell.trim().is_empty()) {
            cells.pop();
        }
        let is_last = number == last_line;
        if cells.len() < plan.width && is_last {
            last.push(cut(&run, number, line, "has too few cells; it breaks off and is left out"));
            continue;
        }
        if cells.len() != plan.width {
            let kind = if cells.len() < plan.width { FEW } else { MANY };
            faults.add(kind, 0, [row, number], None, line.trim());
            continue;
        }
        if is_last && !ended && shortened(&cells, &run, &decimals, written) {
            let what = "has no end and fewer decimals than all others; it breaks off and is left out";
            last.push(cut(&run, number, line, what));
            continue;
        }
        let Some((time, digits)) = clock.time(&cells) else {
            faults.add(no_time, time_column + 1, [row, number], None, &cells[time_column]);
            continue;
        };
        time_decimals.add(digits);
        run.times.push(time);
        run.lines.push(u32::try_from(number).unwrap_or(u32::MAX));
        for ((channel, factor), decimals) in run.channels.iter_mut().zip(&plan.factors).zip(&mut decimals) {
            let text = &cells[channel.column - 1];
            let kind = match cell(text, written.decimal_comma) {
                Cell::Number(value, digits) => {
                    let value = channel.unit.to_si(value * factor);
                    if value.is_finite() {
                        decimals.add(digits);
                        channel.values.push(value);
                        continue;
                    }
                    NOT_FINITE
                }
                Cell::Empty => EMPTY,
                Cell::NotFinite => NOT_FINITE,
                Cell::Text => TEXT,
            };
            channel.values.push(f64::NAN);
            faults.add(kind, channel.column, [row, number], Some(time), text.trim());
        }
        if is_last && !ended {
            let message = "the last line has no end; it is complete as far as its cells tell, and is kept";
            let place = Place { time: Some(time), ..at_line(&run, number) };
            last.push(Finding::new(Severity::Note, "R027", place, message, "see whether its last number is whole"));
        }
    }
    run.channels.iter_mut().zip(&decimals).for_each(|(channel, decimals)| channel.decimals = decimals.most());
    run.time_step_shown = time_decimals.most().map_or(0.0, |decimals| plan.clock.step(decimals));
    findings.extend(faults.finish(&run).chain(last));
    run
}

/// Whether the last cell has fewer decimals than every other of its column, all of which have the same number.
fn shortened(cells: &[Cow<str>], run: &Recording, decimals: &[Decimals], written: Written) -> bool {
    let Some(k) = run.channels.iter().position(|channel| channel.column == cells.len()) else { return false };
    let Some(text) = cells.last() else { return false };
    match (cell(text, written.decimal_comma), decimals[k].range) {
        (Cell::Number(_, Some(digits)), Some([low, high])) => low == high && digits < low,
        (Cell::Number(..), _) => false,
        // "-" or "" at the very end is what is left of a number.
        _ => true,
    }
}

fn at_line(run: &Recording, number: usize) -> Place {
    Place { run: run.name.clone(), lines: Some([number; 2]), ..Place::default() }
}

fn cut(run: &Recording, number: usize, line: &str, what: &str) -> Finding {
    let start: String = line.trim().chars().take(24).collect();
    let message = format!("the last line (`{start}`) {what}");
    let help = "see whether the logger stopped before the train had left";
    Finding::new(Severity::Warning, "R028", at_line(run, number), message, help)
}
