//! Time stamps as loggers write them: "2026-10-25T02:59:54.005Z", "25.10.2026 02:59:54,005", "10/25/2026 2:59:54.005 AM", "25-Oct-2026 02:59:54",
//! "02:59:54.005". ISO 8601-1 (2019) for the first; the calendar is that of Gregory.

use std::borrow::Cow;

/// Seconds of a day.
const DAY: i64 = 86_400;
/// Parts of a second.
const NANO: i64 = 1_000_000_000;

/// In which order the numbers of a date stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    YearMonthDay,
    DayMonthYear,
    MonthDayYear,
}

impl Order {
    pub(super) const ALL: [Order; 3] = [Order::YearMonthDay, Order::DayMonthYear, Order::MonthDayYear];

    /// In words, as a heading would say it.
    pub(super) fn words(self) -> &'static str {
        match self {
            Order::YearMonthDay => "year, month, day",
            Order::DayMonthYear => "day, month, year",
            Order::MonthDayYear => "month, day, year",
        }
    }
}

/// A date as it is written: its three numbers, and the orders in which they are one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Date {
    numbers: [u32; 3],
    orders: [bool; 3],
}

impl Date {
    /// Whether it is a date in this order.
    pub(super) fn fits(&self, order: Order) -> bool {
        self.orders[order as usize]
    }

    /// Days since the first of January 1970.
    pub(super) fn days(&self, order: Order) -> Option<i64> {
        if !self.fits(order) {
            return None;
        }
        let [a, b, c] = self.numbers;
        let (year, month, day) = match order {
            Order::YearMonthDay => (a, b, c),
            Order::DayMonthYear => (c, b, a),
            Order::MonthDayYear => (c, a, b),
        };
        // Two digits are years of this century.
        days(if year < 100 { 2000 + year } else { year }, month, day)
    }
}

/// A stamp as it is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Stamp {
    /// Its date; a time of day alone has none.
    pub date: Option<Date>,
    /// Time of day [ns]; none of a date alone.
    pub time: Option<i64>,
    /// By how much its clock is ahead of universal time [s], where it says so.
    pub ahead: Option<i64>,
    /// Decimals of its seconds.
    pub decimals: usize,
    /// After how much time the clock begins anew where there is no date [s]: a day; an hour where only minutes and seconds are shown.
    pub period: i64,
}

/// Reads a cell as a stamp, in brackets or behind the name of a weekday too.
pub(super) fn stamp(text: &str) -> Option<Stamp> {
    let text = text.trim();
    let text = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')).unwrap_or(text);
    let text = without_weekday(text);
    // A number is no stamp, and commonest.
    if text.len() < 5 || !text.contains([':', '/', '-', '.', 'T']) {
        return None;
    }
    let text = &without_accents(text);
    if !text.is_ascii() {
        return None;
    }
    let (date, rest) = match split(text) {
        (Some(date), rest) => (Some(written_date(date)?), rest),
        (None, rest) => (None, rest),
    };
    let rest = &with_colons(rest.trim());
    if rest.is_empty() {
        return date.map(|date| Stamp { date: Some(date), time: None, ahead: None, decimals: 0, period: DAY });
    }
    let (clock, ahead) = zone(rest)?;
    let (time, decimals, period) = time_of_day(clock)?;
    if period < DAY && (date.is_some() || ahead.is_some()) {
        return None;
    }
    Some(Stamp { date, time: Some(time), ahead, decimals, period })
}

const WEEKDAYS: [&str; 7] = ["mon", "tue", "wed", "thu", "fri", "sat", "sun"];

/// "Sun, 25 Oct 2026" without its weekday.
fn without_weekday(text: &str) -> &str {
    let letters = text.bytes().take_while(u8::is_ascii_alphabetic).count();
    let (first, rest) = text.split_at(letters);
    let is_weekday = letters >= 3 && WEEKDAYS.iter().any(|day| first.to_ascii_lowercase().starts_with(day));
    if is_weekday { rest.trim_start_matches(['.', ',', ' ']) } else { text }
}

/// The date, and what follows it.
fn split(text: &str) -> (Option<&str>, &str) {
    let colon = text.find(':').unwrap_or(text.len());
    // "20261025T025954" has no colon at all; "Oct" has a T of its own.
    let is_digit = |at: usize| text.as_bytes().get(at).is_some_and(u8::is_ascii_digit);
    let letter = text.find(['T', 't']).filter(|at| *at > 0 && is_digit(at - 1) && is_digit(at + 1));
    if let Some(at) = letter {
        return (Some(&text[..at]), &text[at + 1..]);
    }
    // "2026-10-25_22-59-50", as names of files have it, has no colon either.
    if colon == text.len()
        && let Some(at) = text.rfind(['_', ' '])
        && has_dashes(&text[at + 1..])
    {
        return (Some(&text[..at]), &text[at + 1..]);
    }
    // The last blank before the hours; the date itself may have blanks.
    match text[..colon].trim_end().rfind([' ', '_']) {
        Some(at) if colon < text.len() => (Some(text[..at].trim_end_matches([',', ' '])), &text[at + 1..]),
        _ if colon < text.len() => (None, text),
        _ => (Some(text), ""),
    }
}

/// "25. März 2026" and "3 août 2026" without the accents of their months.
fn without_accents(text: &str) -> Cow<'_, str> {
    let plain = |letter: char| match letter {
        'ä' | 'Ä' => 'a',
        'é' | 'É' => 'e',
        'û' | 'Û' => 'u',
        other => other,
    };
    if text.is_ascii() { text.into() } else { text.chars().map(plain).collect::<String>().into() }
}

/// Whether a time of day begins with hours, minutes and seconds between dashes: "22-59-50".
fn has_dashes(clock: &str) -> bool {
    let pattern = |(at, byte): (usize, &u8)| if at % 3 == 2 { *byte == b'-' } else { byte.is_ascii_digit() };
    clock.len() >= 8 && clock.as_bytes()[..8].iter().enumerate().all(pattern)
}

/// Such a time with colons, as all others have them.
fn with_colons(clock: &str) -> Cow<'_, str> {
    match has_dashes(clock) {
        true => format!("{}:{}:{}", &clock[..2], &clock[3..5], &clock[6..]).into(),
        false => clock.into(),
    }
}

/// First letters of each month: in English, and where German, French, Italian, Spanish and Portuguese write others.
const MONTHS: &str = "jan gen ene, feb fev, mar mrz, apr avr abr, may mai mag, jun juin giu, jul juil lug, aug aou ago, sep set, oct okt ott, \
                      nov, dec dez dic";

fn written_date(text: &str) -> Option<Date> {
    let all = |order: Order| Order::ALL.map(|other| other == order);
    if text.len() == 8 && text.bytes().all(|byte| byte.is_ascii_digit()) {
        let numbers = [&text[..4], &text[4..6], &text[6..]].map(|part| part.parse().unwrap_or(0));
        return checked(numbers, all(Order::YearMonthDay));
    }
    if let Some(numbers) = ordinal(text).or_else(|| of_week(text)) {
        return checked(numbers, all(Order::YearMonthDay));
    }
    let mark = text.chars().find(|c| matches!(c, '-' | '/' | '.' | ' '))?;
    let parts: Vec<&str> = text.split([mark, ' ', ',']).map(str::trim).filter(|part| !part.is_empty()).collect();
    let &[a, b, c] = &parts[..] else { return None };
    let month = |part: &str| {
        let part = part.to_lowercase();
        let of = |names: &str| names.split(' ').any(|name| part.starts_with(name));
        MONTHS.split(", ").position(of).and_then(|at| u32::try_from(at + 1).ok())
    };
    let number = |part: &str| digits(part).filter(|_| part.len() <= 4);
    if let Some(month) = month(b) {
        let order = if a.len() == 4 { Order::YearMonthDay } else { Order::DayMonthYear };
        return checked([number(a)?, month, number(c)?], all(order));
    }
    if let Some(month) = month(a) {
        return checked([month, number(b)?, number(c)?], all(Order::MonthDayYear));
    }
    let numbers = [number(a)?, number(b)?, number(c)?];
    let orders = match (a.len(), c.len(), mark) {
        (4, ..) => all(Order::YearMonthDay),
        // Points mark the dates of Europe, whose day stands first.
        (_, 4, '.') | (_, 2, '.') => all(Order::DayMonthYear),
        (_, 4, _) => [false, true, true],
        (2, 2, _) => [true; 3],
        (1, 2, _) => [false, true, true],
        _ => return None,
    };
    checked(numbers, orders)
}

/// Digits alone.
fn digits(text: &str) -> Option<u32> {
    text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse().ok())?
}

/// "2026-298": the day of a year (ISO 8601-1, 5.2.3).
fn ordinal(text: &str) -> Option<[u32; 3]> {
    let (year, day) = text.split_once('-').filter(|(year, day)| (year.len(), day.len()) == (4, 3))?;
    let (year, day) = (digits(year)?, digits(day)?);
    let found = date_of(days(year, 1, 1)? + i64::from(day) - 1)?;
    (day > 0 && found[0] == year).then_some(found)
}

/// "2026-W43-7" and "2026W437": the day of a week, the first of which has the year's first Thursday (ISO 8601-1, 5.2.4).
fn of_week(text: &str) -> Option<[u32; 3]> {
    let (year, rest) =
        text.split_once(['W', 'w']).map(|(year, rest)| (year.trim_end_matches('-'), rest.replace('-', "")))?;
    if (year.len(), rest.len()) != (4, 3) {
        return None;
    }
    let (week, day) = (digits(&rest[..2])?, digits(&rest[2..])?);
    // The fourth of January is in the first week; the first of January 1970 was a Thursday.
    let fourth = days(digits(year)?, 1, 4)?;
    let monday = fourth - (fourth + 3).rem_euclid(7);
    ((1..=53).contains(&week) && (1..=7).contains(&day))
        .then(|| date_of(monday + 7 * i64::from(week - 1) + i64::from(day) - 1))?
}

/// Year, month and day of a count of days since the first of January 1970 (Hinnant, as [`days`]).
fn date_of(count: i64) -> Option<[u32; 3]> {
    let shifted = count + 719_468;
    let (era, of_era) = (shifted.div_euclid(146_097), shifted.rem_euclid(146_097));
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = era * 400 + year + i64::from(month <= 2);
    Some([u32::try_from(year).ok()?, u32::try_from(month).ok()?, u32::try_from(day).ok()?])
}

/// A date that is one in some order, with those in which it is none taken out.
fn checked(numbers: [u32; 3], orders: [bool; 3]) -> Option<Date> {
    let mut date = Date { numbers, orders };
    for order in Order::ALL {
        date.orders[order as usize] = date.days(order).is_some();
    }
    date.orders.contains(&true).then_some(date)
}

/// Days from the first of January 1970 to a date (Hinnant, chrono-compatible low-level date algorithms, 2021).
fn days(year: u32, month: u32, day: u32) -> Option<i64> {
    let leap = year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    let length = match month {
        2 => 28 + u32::from(leap),
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => return None,
    };
    if !(1..=length).contains(&day) || !(1900..2200).contains(&year) {
        return None;
    }
    let (year, month, day) = (i64::from(year) - i64::from(month <= 2), i64::from(month), i64::from(day));
    let (era, of_era) = (year.div_euclid(400), year.rem_euclid(400));
    let of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    Some(era * 146_097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719_468)
}

/// The clock without what it says of its zone, and by how much that is ahead of universal time [s].
fn zone(text: &str) -> Option<(&str, Option<i64>)> {
    for end in ["Z", "z", " UTC", " GMT", "UTC", "GMT"] {
        if let Some(clock) = text.strip_suffix(end) {
            return Some((clock.trim_end(), Some(0)));
        }
    }
    let Some(at) = text.rfind(['+', '-']) else { return Some((text, None)) };
    let digits: String = text[at + 1..].chars().filter(|c| *c != ':').collect();
    let number = |part: &str| part.parse::<i64>().ok();
    let (hours, minutes) = match digits.len() {
        2 => (number(&digits)?, 0),
        4 => (number(&digits[..2])?, number(&digits[2..])?),
        _ => return None,
    };
    if hours > 14 || minutes > 59 {
        return None;
    }
    let size = 3600 * hours + 60 * minutes;
    Some((text[..at].trim_end(), Some(if text[at..].starts_with('-') { -size } else { size })))
}

/// Time of day [ns], decimals of the seconds, and when it begins anew [s].
fn time_of_day(text: &str) -> Option<(i64, usize, i64)> {
    let lower = text.to_ascii_lowercase();
    let (clock, half) = match (lower.strip_suffix("am"), lower.strip_suffix("pm")) {
        (Some(clock), _) => (clock.trim_end(), Some(0)),
        (_, Some(clock)) => (clock.trim_end(), Some(12)),
        _ => (lower.as_str(), None),
    };
    let (whole, fraction) = clock.split_once(['.', ',']).unwrap_or((clock, ""));
    let mut parts: Vec<&str> = whole.split(':').collect();
    let mut fraction = fraction;
    // "02:59:54:005": thousandths after a colon.
    if parts.len() == 4 && fraction.is_empty() && parts[3].len() == 3 {
        fraction = parts.pop().unwrap_or("");
    }
    // "025954" of the basic format.
    if parts.len() == 1 && whole.len() == 6 && whole.is_ascii() {
        parts = vec![&whole[..2], &whole[2..4], &whole[4..]];
    }
    let numbers: Option<Vec<i64>> =
        parts.iter().map(|part| digits(part).filter(|_| matches!(part.len(), 1 | 2)).map(i64::from)).collect();
    let numbers = numbers?;
    if !fraction.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let (hours, minutes, seconds, period) = match numbers[..] {
        [hours, minutes, seconds] => (hours, minutes, seconds, DAY),
        // "59:54.0", as spreadsheets show times: a fraction follows seconds and nothing else.
        [minutes, seconds] if !fraction.is_empty() && half.is_none() => (0, minutes, seconds, 3600),
        // ISO 8601 with minutes alone.
        [hours, minutes] if fraction.is_empty() => (hours, minutes, 0, DAY),
        _ => return None,
    };
    let hours = match half {
        Some(half) if (1..=12).contains(&hours) => hours % 12 + half,
        Some(_) => return None,
        None => hours,
    };
    // Midnight may be hour 24, and a leap second is the sixtieth.
    if hours > 24 || (hours == 24 && minutes + seconds > 0) || minutes > 59 || seconds > 60 {
        return None;
    }
    let digits: String = fraction.chars().chain(std::iter::repeat('0')).take(9).collect();
    let nanos = digits.parse::<i64>().ok()?;
    Some(((3600 * hours + 60 * minutes + seconds) * NANO + nanos, fraction.len().min(9), period))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Seconds since 1970 of a stamp that can be read in one order.
    fn seconds(text: &str) -> f64 {
        let stamp = stamp(text).unwrap_or_else(|| panic!("{text}"));
        let date = stamp.date.unwrap();
        let orders: Vec<Order> = Order::ALL.into_iter().filter(|order| date.fits(*order)).collect();
        assert_eq!(orders.len(), 1, "{text}: {orders:?}");
        let whole = DAY * date.days(orders[0]).unwrap() - stamp.ahead.unwrap_or(0);
        whole as f64 + stamp.time.unwrap_or(0) as f64 / NANO as f64
    }

    #[test]
    fn one_moment_in_many_spellings() {
        // date -u -d "2026-10-25 02:59:54.005" +%s.%N
        for text in [
            "2026-10-25 02:59:54.005",
            "2026-10-25T02:59:54.005Z",
            "2026-10-25T02:59:54,005",
            "2026-10-25T04:59:54.005+02:00",
            "2026-10-24T21:59:54.005-05",
            "20261025T025954.005Z",
            "2026/10/25 02:59:54.005",
            "25.10.2026 02:59:54,005",
            "25.10.26 02:59:54,005",
            "25/10/2026 02:59:54.005",
            "10/25/2026 2:59:54.005 AM",
            "25-Oct-2026 02:59:54.005",
            "25 October 2026, 02:59:54.005",
            "Oct 25, 2026 02:59:54.005",
            "2026-10-25 02:59:54:005",
            "2026-10-25 02:59:54.005 UTC",
            "2026-298T02:59:54.005Z",
            "2026-W43-7T02:59:54.005",
            "2026W437T025954.005",
            "[2026-10-25 02:59:54.005]",
            "Sun Oct 25, 2026 02:59:54.005",
            "Sunday, 25 October 2026 02:59:54.005",
            "25. Okt. 2026 02:59:54,005",
            "25 ottobre 2026 02:59:54.005",
            "2026-10-25_02-59-54.005",
            "2026-10-25 02-59-54.005",
        ] {
            assert_eq!(seconds(text), 1_792_897_194.005, "{text}");
        }
        assert_eq!(seconds("25. März 2026 02:59:54"), seconds("2026-03-25 02:59:54"));
        assert_eq!(seconds("3 août 2026 02:59:54"), seconds("2026-08-03 02:59:54"));
        assert_eq!(seconds("2024-02-29 24:00:00"), seconds("2024-03-01 00:00:00"));
        assert_eq!(seconds("2026-10-25T12:59:54 PM"), seconds("2026-10-25T12:59:54"));
    }

    #[test]
    fn times_of_day_have_no_date() {
        let of = |text: &str| stamp(text).map(|stamp| (stamp.date.is_some(), stamp.time, stamp.decimals, stamp.period));
        let at = 10_794 * NANO;
        assert_eq!(of("02:59:54.005"), Some((false, Some(at + 5_000_000), 3, DAY)));
        assert_eq!(of("2:59:54"), Some((false, Some(at), 0, DAY)));
        assert_eq!(of("59:54.5"), Some((false, Some(3594 * NANO + NANO / 2), 1, 3600)));
        assert_eq!(of("25.10.2026").map(|(date, time, ..)| (date, time)), Some((true, None)));
    }

    #[test]
    fn what_is_no_stamp_is_none() {
        for text in [
            "0.005",
            "-0.30",
            "1e-3",
            "12345.678",
            "1.234.5678",
            "noon",
            "",
            "31/02/2026 00:00:00",
            "2026-13-01",
            "25:00:00",
            "12:61:00",
            "13:00:00 PM",
            "2026-10-25 02:59:54+99:00",
            "1:2:3:4",
            "59:54",
            "12-14-16-18",
            "2026-366 00:00:00",
            "2026-000 00:00:00",
            "2026-W54-1 00:00:00",
        ] {
            let found = stamp(text);
            // Hours and minutes are a time of day.
            assert!(found.is_none() || text == "59:54", "{text}: {found:?}");
        }
        assert_eq!(stamp("59:54"), None);
    }

    #[test]
    fn orders_that_a_date_leaves_open() {
        let fits = |text: &str| Order::ALL.map(|order| stamp(text).unwrap().date.unwrap().fits(order));
        assert_eq!(fits("09/10/2026 02:59:54"), [false, true, true]);
        assert_eq!(fits("25/10/2026 02:59:54"), [false, true, false]);
        assert_eq!(fits("26/10/11 02:59:54"), [true, true, false]);
        assert_eq!(fits("2026/10/11 02:59:54"), [true, false, false]);
    }
}
