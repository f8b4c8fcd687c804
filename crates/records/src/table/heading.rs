//! Headings of columns: "crown displacement @ upstream [mm]", "time (s)", "crown_displacement_mm".

use crate::{Dimension, UNITS, Unit};

/// A heading, read.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Heading {
    /// Name of the channel.
    pub name: String,
    /// Line across the barrel; empty where none is named.
    pub line: String,
    /// Unit as it stands there.
    pub symbol: Option<String>,
}

/// Names under which a clock goes.
const CLOCKS: &str = "time, t, elapsed time, elapsed, elapsed seconds, relative time, absolute time, scan time, x value, \
    timestamp, time stamp, datetime, date time, date/time, date&time, date & time, date and time, zeit, \
    uhrzeit, zeitstempel, datum/zeit, datum zeit, datum/uhrzeit, datum uhrzeit, temps, heure, horodatage, \
    date heure, date/heure, tempo, ora, hora, fecha hora, fecha/hora";
/// Names of a column of dates beside one of times.
const DATES: &str = "date, datum, fecha";
/// Names of a column of thousandths beside stamps of whole seconds.
const THOUSANDTHS: &str = "ms, msec, millisecond, milliseconds";
/// Names of columns that no sensor fills: what is counted, and what somebody remarked.
const NO_SENSOR: &str =
    "record, recnum, record number, rn, no., no, nr, nr., number, index, sample, scan, comment, kommentar";

impl Heading {
    /// Reads a heading.
    pub(super) fn of(text: &str) -> Heading {
        let shown = findings::visible::one_line(text.trim());
        let text = findings::visible::unguarded(&shown);
        let (name, symbol) = bracketed(text, '[', ']', |_| true)
            .or_else(|| bracketed(text, '(', ')', |symbol| Unit::named(symbol).is_some()))
            .or_else(|| suffixed(text))
            .unwrap_or((text, None));
        // A name that begins with the sign names no line.
        let (name, line) = name.split_once('@').filter(|(name, _)| !name.is_empty()).unwrap_or((name, ""));
        Heading { name: name.trim().to_owned(), line: line.trim().to_owned(), symbol }
    }

    /// Whether it heads the clock. "Time  1 - default sample rate [s]" does, for no sensor measures seconds.
    pub(super) fn is_clock(&self) -> bool {
        let name = self.plain();
        let unit = self.symbol.as_deref().and_then(Unit::named);
        let is_time = unit.is_some_and(|unit| unit.quantity == Dimension::Time);
        let begins = || ["time ", "zeit ", "temps "].iter().any(|word| name.starts_with(word));
        self.line.is_empty() && ((is_among(CLOCKS, &name) && (unit.is_none() || is_time)) || (is_time && begins()))
    }

    /// Whether it heads a column of dates.
    pub(super) fn is_date(&self) -> bool {
        self.is_of(DATES)
    }

    /// Whether it heads thousandths of a second.
    pub(super) fn is_thousandths(&self) -> bool {
        is_among(THOUSANDTHS, &self.plain()) && self.symbol.as_deref().is_none_or(|symbol| symbol == "ms")
    }

    /// Whether no sensor fills its column.
    pub(super) fn is_no_sensor(&self) -> bool {
        self.is_of(NO_SENSOR)
    }

    fn is_of(&self, names: &str) -> bool {
        let unit = self.symbol.as_deref().filter(|symbol| *symbol != "-").and_then(Unit::named);
        self.line.is_empty() && unit.is_none() && is_among(names, &self.plain())
    }

    /// The name without capitals and underscores, and without a format or a zone: "Time (hh:mm:ss)", "Timestamp (UTC)".
    fn plain(&self) -> String {
        let name = self.name.to_lowercase().replace('_', " ");
        let of_format = |inside: &str| {
            matches!(inside, "utc" | "gmt" | "local" | "local time")
                || inside.chars().all(|c| "dhmsyf:./- t".contains(c))
        };
        match name.strip_suffix(')').and_then(|name| name.rsplit_once('(')) {
            Some((name, inside)) if of_format(inside) => name.trim().to_owned(),
            _ => name,
        }
    }
}

/// Whether a name is one of these, which commas divide.
fn is_among(names: &str, name: &str) -> bool {
    names.split(", ").any(|known| known == name)
}

fn bracketed(text: &str, open: char, close: char, fits: fn(&str) -> bool) -> Option<(&str, Option<String>)> {
    let inner = text.strip_suffix(close)?;
    let at = inner.rfind(open)?;
    let symbol = inner[at + open.len_utf8()..].trim();
    fits(symbol).then(|| (inner[..at].trim(), Some(symbol.to_owned())))
}

/// "crown_displacement_mm": the ending of tables that programs write, where capitals are lost.
fn suffixed(text: &str) -> Option<(&str, Option<String>)> {
    let (name, ending) = text.rsplit_once('_')?;
    // "strain_h" is horizontal and "strain_d" diagonal rather than hours and days.
    let fits = |unit: &&Unit| unit.symbol.is_ascii() && !matches!(unit.symbol, "h" | "d");
    let unit = UNITS.iter().filter(fits).find(|unit| unit.symbol.to_lowercase() == ending)?;
    (!name.is_empty()).then(|| (name, Some(unit.symbol.to_owned())))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(text: &str) -> (String, String, Option<String>) {
        let heading = Heading::of(text);
        (heading.name, heading.line, heading.symbol)
    }

    #[test]
    fn headings_name_channel_line_and_unit() {
        let some = |symbol: &str| Some(symbol.to_owned());
        assert_eq!(parts("crown displacement [mm]"), ("crown displacement".into(), String::new(), some("mm")));
        assert_eq!(parts(" crown @ upstream (mm) "), ("crown".into(), "upstream".into(), some("mm")));
        assert_eq!(parts("stress_x_mpa"), ("stress_x".into(), String::new(), some("MPa")));
        assert_eq!(parts("crown (upstream)"), ("crown (upstream)".into(), String::new(), None));
        assert_eq!(parts("crown [furlong]"), ("crown".into(), String::new(), some("furlong")));
        assert!(Heading::of("time_s").is_clock() && Heading::of("Time [ms]").is_clock() && Heading::of("t").is_clock());
        assert!(!Heading::of("t [mm]").is_clock() && !Heading::of("tilt [s]").is_clock());
    }
}
