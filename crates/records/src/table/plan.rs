//! From headings and mapping to what is done with each column.

use super::clock::{Clock, Parts, Stamps, Unsure};
use super::head::Head;
use super::heading::Heading;
use super::mapping::{Column, Mapping, Others, Source};
use super::number::{Cell, cell};
use super::rows::Body;
use crate::series::title;
use crate::unit::symbols;
use crate::{Channel, Dimension, Finding, Place, Unit};
use findings::Severity;

/// What is read of every row.
#[derive(Debug, Clone)]
pub(super) struct Plan {
    /// Cells of a complete row.
    pub width: usize,
    pub clock: Clock,
    pub channels: Vec<Channel>,
    /// Factor on the cells of each channel, sign and calibration.
    pub factors: Vec<f64>,
}

struct Planner<'a> {
    run: &'a str,
    line: usize,
    findings: &'a mut Vec<Finding>,
}

impl Planner<'_> {
    fn add(&mut self, severity: Severity, code: &'static str, column: Option<usize>, message: String, help: &str) {
        let lines = (self.line > 0).then_some([self.line; 2]);
        let place = Place { run: self.run.to_owned(), lines, column, ..Place::default() };
        self.findings.push(Finding::new(severity, code, place, message, help));
    }

    /// Dates that may be read in two ways, with two lengths of the record.
    fn unsure(&mut self, index: usize, unsure: &Unsure) {
        let orders: Vec<&str> = unsure.orders.iter().map(|order| order.words()).collect();
        let message = match orders[..] {
            [] => format!("the dates, first `{}`, are not all of one order", unsure.date),
            _ => format!("`{}` may be {}, and the rows do not tell which", unsure.date, orders.join(" or ")),
        };
        self.add(
            Severity::Error,
            "R007",
            Some(index + 1),
            message,
            "write dates as 2026-10-25, or give each day a file of its own",
        );
    }

    /// A clock of numbers, if its unit is one of time.
    fn numbers(&mut self, index: usize, symbol: Option<&str>, mapping: &Mapping, body: &Body) -> Option<Clock> {
        let Some(symbol) = symbol else {
            let first = body.cells().find_map(|cells| match cell(cells.get(index)?, body.written.decimal_comma) {
                Cell::Number(number, _) => Some(number),
                _ => None,
            });
            let (what, help) = first.map_or(UNREAD, unitless);
            self.add(Severity::Error, "R011", Some(index + 1), format!("the clock has no unit{what}"), help);
            return None;
        };
        let unit = self.unit(index, "time", Some(symbol))?;
        if unit.quantity != Dimension::Time {
            let message = format!("the clock is in {}, which is no unit of time", unit.symbol);
            self.add(Severity::Error, "R010", Some(index + 1), message, "name the column of the clock in the mapping");
            return None;
        }
        let factor = mapping.time.as_ref().map_or(1.0, |column| column.sign * column.scale);
        if !(factor > 0.0 && factor.is_finite()) {
            let message = "sign and scale of the clock make no positive factor".to_owned();
            self.add(Severity::Error, "R014", Some(index + 1), message, "leave them at 1");
            return None;
        }
        Some(Clock::Numbers { index, factor, unit })
    }

    /// The unit of a column, if one is stated and known.
    fn unit(&mut self, index: usize, name: &str, symbol: Option<&str>) -> Option<Unit> {
        let Some(symbol) = symbol else {
            let message = format!("`{name}` has no unit; the column is not read");
            self.add(
                Severity::Error,
                "R011",
                Some(index + 1),
                message,
                "write it into the heading: \"crown displacement [mm]\"",
            );
            return None;
        };
        let unit = Unit::named(symbol);
        if unit.is_none() {
            let message = format!("`{name}` is in `{symbol}`, which is no known unit; the column is not read");
            let help = format!("write one of {}", symbols());
            self.add(Severity::Error, "R012", Some(index + 1), message, &help);
        }
        unit
    }
}

/// What is read of every row, or None where there is no clock. Everything that is left out is named.
pub(super) fn plan(
    head: &Head,
    body: &Body,
    mapping: &Mapping,
    run: &str,
    findings: &mut Vec<Finding>,
) -> Option<Plan> {
    let mut planner = Planner { run, line: head.line, findings };
    let mapped = placed(&mut planner, &head.headings, mapping);
    let clock = clock(&head.headings, mapping);
    let Some((time_index, symbol)) = clock else {
        let seen: Vec<&str> = head.headings.iter().map(|heading| heading.name.as_str()).take(12).collect();
        let message = format!("no column is the clock; the headings are: {}", seen.join(", "));
        planner.add(Severity::Error, "R010", None, message, "head it \"time [s]\", or name it in the mapping");
        return None;
    };
    let parts = parts(&head.headings, mapping, time_index);
    let clock = match Stamps::seen(parts, body) {
        Some(Ok(stamps)) => {
            let message = format!("the clock is of time stamps: times are seconds from the first, {}", stamps.first);
            planner.add(Severity::Note, "R006", Some(time_index + 1), message, "");
            Clock::Stamps(stamps)
        }
        Some(Err(unsure)) => {
            planner.unsure(time_index, &unsure);
            return None;
        }
        None => planner.numbers(time_index, symbol.as_deref(), mapping, body)?,
    };
    let of_clock = |index: usize| match &clock {
        Clock::Stamps(Stamps { parts, .. }) => [Some(parts.time), parts.date, parts.thousandths].contains(&Some(index)),
        Clock::Numbers { index: own, .. } => *own == index,
    };
    let (channels, factors) = columns(&mut planner, &head.headings, mapping, &mapped, of_clock);
    if channels.is_empty() {
        let message = "no column is a channel that can be read".to_owned();
        planner.add(Severity::Error, "R010", None, message, "head every channel with its name and unit");
        return None;
    }
    Some(Plan { width: head.headings.len(), clock, channels, factors })
}

/// Columns that a stamp may be put together from: date, time and thousandths may stand apart.
fn parts(headings: &[Heading], mapping: &Mapping, time: usize) -> Parts {
    let beside = |is: fn(&Heading) -> bool| {
        let free = mapping.time.is_none() && !headings[time].is_date();
        headings.iter().position(is).filter(|at| free && *at != time)
    };
    Parts { time, date: beside(Heading::is_date), thousandths: beside(Heading::is_thousandths) }
}

/// What is said of a clock in which no cell is a number or a stamp that is known.
const UNREAD: (&str, &str) = (
    "; its stamps are in no form that is known",
    "write them as 2026-10-25T02:59:54.005, or head seconds \"time [s]\"",
);

/// What numbers of a clock without a unit look like, and what to write.
fn unitless(first: f64) -> (&'static str, &'static str) {
    match first {
        // From 2000 to 2100.
        36_526.0..73_050.0 => {
            ("; its numbers look like days of a spreadsheet", "head it \"time [d]\" where they are days")
        }
        946_684_800.0..4_102_444_800.0 => {
            ("; its numbers look like seconds since 1970", "head it \"time [s]\" where they are seconds")
        }
        946_684_800e3..4_102_444_800e3 => {
            ("; its numbers look like milliseconds since 1970", "head it \"time [ms]\" where they are milliseconds")
        }
        // Years 1900 to 2200.
        19_000_101_000_000.0..22_000_101_000_000.0 => (
            "; its numbers look like year, month, day, hours, minutes and seconds in one",
            "write them as 20261025T025954.005",
        ),
        _ => ("", "write it into the heading: \"time [s]\""),
    }
}

/// For each column the entry of the mapping that speaks of it.
fn placed<'a>(planner: &mut Planner, headings: &[Heading], mapping: &'a Mapping) -> Vec<Option<&'a Column>> {
    let mut mapped: Vec<Option<&Column>> = vec![None; headings.len()];
    for column in &mapping.channels {
        let problem = match found(headings, &column.source) {
            _ if !(column.sign.abs() == 1.0 && column.scale.is_finite() && column.scale != 0.0) => {
                format!("`{}` needs a sign of 1 or -1 and a scale other than 0", column.name)
            }
            Some(index) if mapped[index].is_none() => {
                mapped[index] = Some(column);
                continue;
            }
            Some(index) => format!("column {} is mapped twice; the first counts", index + 1),
            None => format!("the mapping names {}, which is not in the table", words(&column.source)),
        };
        let names: Vec<&str> = headings.iter().map(|heading| heading.name.as_str()).take(12).collect();
        planner.add(Severity::Error, "R014", None, problem, &format!("columns are: {}", names.join(", ")));
    }
    mapped
}

fn words(source: &Source) -> String {
    match source {
        Source::Heading(text) => format!("`{text}`"),
        Source::Number(number) => format!("column {number}"),
    }
}

fn found(headings: &[Heading], source: &Source) -> Option<usize> {
    match source {
        Source::Number(number) => number.checked_sub(1).filter(|index| *index < headings.len()),
        Source::Heading(text) => {
            let wanted = Heading::of(text);
            let exact = headings.iter().position(|heading| *heading == wanted);
            let named = || headings.iter().position(|one| one.name == wanted.name && one.line == wanted.line);
            exact.or_else(named)
        }
    }
}

/// Index and unit of the clock.
pub(super) fn clock(headings: &[Heading], mapping: &Mapping) -> Option<(usize, Option<String>)> {
    let index = match &mapping.time {
        Some(column) => found(headings, &column.source)?,
        None => headings.iter().position(Heading::is_clock).or_else(|| headings.iter().position(Heading::is_date))?,
    };
    let stated = mapping.time.as_ref().and_then(|column| column.unit.clone());
    Some((index, stated.or_else(|| headings[index].symbol.clone())))
}

fn columns(
    planner: &mut Planner,
    headings: &[Heading],
    mapping: &Mapping,
    mapped: &[Option<&Column>],
    of_clock: impl Fn(usize) -> bool,
) -> (Vec<Channel>, Vec<f64>) {
    let (mut channels, mut factors) = (Vec::<Channel>::new(), Vec::new());
    for (index, heading) in headings.iter().enumerate().filter(|(index, _)| !of_clock(*index)) {
        let said = mapped[index];
        if said.is_none() && mapping.others == Others::PassOver {
            let message = format!("`{}` is not in the mapping and is passed over", heading.name);
            planner.add(Severity::Note, "R015", Some(index + 1), message, "");
            continue;
        }
        if said.is_none() && (heading.is_no_sensor() || heading.is_date()) {
            let message = format!("`{}` is no channel of a sensor and is passed over", heading.name);
            planner.add(Severity::Note, "R016", Some(index + 1), message, "");
            continue;
        }
        let name = said.map(|column| &column.name).filter(|name| !name.is_empty()).unwrap_or(&heading.name).clone();
        let line = said.and_then(|column| column.line.clone()).unwrap_or_else(|| heading.line.clone());
        let symbol = said.and_then(|column| column.unit.clone()).or_else(|| heading.symbol.clone());
        let Some(unit) = planner.unit(index, &name, symbol.as_deref()) else { continue };
        let twice = channels.iter().find(|other| other.name == name && other.line == line);
        let left_out = twice.map(|first| format!("R013: column {} has the same name and line", first.column));
        if left_out.is_some() {
            let message = format!("`{}` stands above two columns; this one is left out", title(&name, &line));
            planner.add(
                Severity::Error,
                "R013",
                Some(index + 1),
                message,
                "give each sensor a name or line of its own",
            );
        }
        factors.push(said.map_or(1.0, |column| column.sign * column.scale));
        channels.push(Channel { name, line, unit, column: index + 1, values: Vec::new(), decimals: Some(0), left_out });
    }
    (channels, factors)
}
