//! The clock of a table: numbers in a unit, or time stamps, from which seconds since the first one are made.

use super::dialect::SAMPLE;
use super::dialect::Written;
use super::number::{Cell, cell};
use super::rows::Body;
use super::stamp::{Date, Order, Stamp, stamp};
use crate::Unit;
use std::borrow::Cow;

const NANO: i64 = 1_000_000_000;
const DAY: i64 = 86_400 * NANO;

/// How times are read.
#[derive(Debug, Clone)]
pub(super) enum Clock {
    /// Numbers in a unit, times a factor.
    Numbers { index: usize, factor: f64, unit: Unit },
    /// Stamps.
    Stamps(Stamps),
}

impl Clock {
    /// Index of its column.
    pub(super) fn column(&self) -> usize {
        match self {
            Clock::Numbers { index, .. } => *index,
            Clock::Stamps(stamps) => stamps.parts.time,
        }
    }

    /// The smallest step that times with so many decimals show [s].
    pub(super) fn step(&self, decimals: usize) -> f64 {
        let last = 1.0 / 10_f64.powi(decimals.min(15) as i32);
        match self {
            Clock::Numbers { factor, unit, .. } => unit.to_si(factor * last),
            Clock::Stamps(_) => last,
        }
    }
}

/// Columns from which a stamp is put together.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parts {
    /// The stamp, or its time of day.
    pub time: usize,
    /// The date, where it stands in a column of its own.
    pub date: Option<usize>,
    /// Thousandths of the second, likewise.
    pub thousandths: Option<usize>,
}

/// A clock of stamps.
#[derive(Debug, Clone)]
pub(super) struct Stamps {
    pub parts: Parts,
    /// Order of the numbers of its dates.
    pub order: Order,
    /// The first one, as it is written.
    pub first: String,
}

/// Why stamps are not read.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Unsure {
    /// A date that may be two.
    pub date: String,
    pub orders: Vec<Order>,
}

impl Parts {
    /// The stamp of a row.
    fn of(&self, cells: &[Cow<str>]) -> Option<Stamp> {
        let mut found = stamp(cells.get(self.time)?)?;
        if let Some(date) = self.date.filter(|_| found.date.is_none()) {
            found.date = Some(stamp(cells.get(date)?)?.date?);
        }
        if let Some(column) = self.thousandths.filter(|_| found.decimals == 0) {
            let Cell::Number(number, _) = cell(cells.get(column)?, false) else { return None };
            found.time = found.time.map(|time| time + (number * 1e6).round() as i64);
            found.decimals = 3;
        }
        // A date alone is its midnight, unless the time of day has a column of its own.
        let is_whole = found.time.is_some() || (found.date.is_some() && self.date.is_none());
        is_whole.then_some(found)
    }

    fn words(&self, cells: &[Cow<str>]) -> String {
        let columns = self.date.into_iter().chain([self.time]);
        columns.filter_map(|column| cells.get(column)).map(|cell| cell.trim()).collect::<Vec<_>>().join(" ")
    }
}

impl Stamps {
    /// The stamps of these rows, if they are: more of them are stamps than not. The order of the numbers in their dates is the only one
    /// in which all are dates, or in which the date goes on from day to day; on a single day it does not matter.
    pub(super) fn seen(parts: Parts, body: &Body) -> Option<Result<Stamps, Unsure>> {
        let (mut stamped, mut others, mut first) = (0_usize, 0_usize, None);
        for cells in body.cells().take(SAMPLE) {
            match parts.of(&cells) {
                Some(stamp) => {
                    first = first.or_else(|| Some((stamp, parts.words(&cells))));
                    stamped += 1;
                }
                None => others += 1,
            }
        }
        let (stamp, words) = first.filter(|_| stamped > others)?;
        let stamps = |order| Stamps { parts, order, first: words.clone() };
        let Some(date) = stamp.date else { return Some(Ok(stamps(Order::YearMonthDay))) };
        let open: Vec<Order> = Order::ALL.into_iter().filter(|order| date.fits(*order)).collect();
        if let [order] = open[..] {
            return Some(Ok(stamps(order)));
        }
        let mut dates: Vec<Date> = body.cells().filter_map(|cells| parts.of(&cells)?.date).collect();
        dates.dedup();
        let fits = |order: &Order| dates.iter().all(|date| date.fits(*order));
        let open: Vec<Order> = open.into_iter().filter(fits).collect();
        let goes_on = |order: &Order| {
            let days: Vec<i64> = dates.iter().filter_map(|date| date.days(*order)).collect();
            days.windows(2).all(|pair| pair[1] == pair[0] + 1)
        };
        let daily: Vec<Order> = open.iter().copied().filter(goes_on).collect();
        let chosen = match (&open[..], &daily[..]) {
            ([order], _) | (_, [order]) => Some(*order),
            ([order, ..], _) if dates.len() == 1 => Some(*order),
            _ => None,
        };
        Some(chosen.map(stamps).ok_or(Unsure { date: words, orders: open }))
    }
}

/// Reads times row by row.
pub(super) struct Reader<'a> {
    clock: &'a Clock,
    written: Written,
    /// First and last moment [ns].
    first: Option<i64>,
    last: i64,
    /// Whether the first stamp has a zone: a stamp that differs in this is none of the same clock.
    zoned: bool,
    /// Full periods of a clock without a date [ns].
    turned: i64,
}

impl<'a> Reader<'a> {
    pub(super) fn new(clock: &'a Clock, written: Written) -> Reader<'a> {
        Reader { clock, written, first: None, last: 0, zoned: false, turned: 0 }
    }

    /// Time of a row [s], with its decimals; none where it is no time.
    pub(super) fn time(&mut self, cells: &[Cow<str>]) -> Option<(f64, Option<usize>)> {
        let stamps = match self.clock {
            Clock::Numbers { index, factor, unit } => {
                let Cell::Number(number, decimals) = cell(&cells[*index], self.written.decimal_comma) else {
                    return None;
                };
                let time = unit.to_si(number * factor);
                return time.is_finite().then_some((time, decimals));
            }
            Clock::Stamps(stamps) => stamps,
        };
        let stamp = stamps.parts.of(cells)?;
        if self.first.is_some() && stamp.ahead.is_some() != self.zoned {
            return None;
        }
        let mut moment = stamp.time.unwrap_or(0) - NANO * stamp.ahead.unwrap_or(0);
        match stamp.date {
            Some(date) => moment += DAY * date.days(stamps.order)?,
            None => {
                let period = NANO * stamp.period;
                moment += self.turned;
                // Past midnight: back by more than half a turn.
                if self.first.is_some() && moment < self.last - period / 2 {
                    self.turned += period;
                    moment += period;
                }
            }
        }
        self.zoned = stamp.ahead.is_some();
        self.last = moment;
        let first = *self.first.get_or_insert(moment);
        Some(((moment - first) as f64 / NANO as f64, Some(stamp.decimals)))
    }
}
