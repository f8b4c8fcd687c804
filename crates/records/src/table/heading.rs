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
const CLOCKS: [&str; 8] = ["time", "t", "elapsed time", "elapsed", "timestamp", "zeit", "temps", "tempo"];

impl Heading {
    /// Reads a heading.
    pub fn of(text: &str) -> Heading {
        let text = text.trim();
        let (name, symbol) = bracketed(text, '[', ']', |_| true)
            .or_else(|| bracketed(text, '(', ')', |symbol| Unit::named(symbol).is_some()))
            .or_else(|| suffixed(text))
            .unwrap_or((text, None));
        let (name, line) = name.split_once('@').unwrap_or((name, ""));
        Heading { name: name.trim().to_owned(), line: line.trim().to_owned(), symbol }
    }

    /// Whether it heads the clock.
    pub fn is_clock(&self) -> bool {
        let name = self.name.to_lowercase();
        self.line.is_empty()
            && CLOCKS.contains(&name.as_str())
            && self
                .symbol
                .as_deref()
                .is_none_or(|symbol| Unit::named(symbol).is_none_or(|unit| unit.quantity == Dimension::Time))
    }
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
    let unit = UNITS.iter().find(|unit| unit.symbol.to_lowercase() == ending && unit.symbol.is_ascii())?;
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
