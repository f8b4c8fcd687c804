//! Units of records: from the number in a cell to SI and back. Nowhere else is a unit converted.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

/// What a channel measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Dimension {
    /// Time [s].
    Time,
    /// Displacement, opening [m].
    Length,
    /// Strain [-].
    Strain,
    /// Stress [Pa].
    Stress,
    /// Force [N].
    Force,
    /// Rotation [rad].
    Angle,
    /// Speed [m/s].
    Speed,
    /// Acceleration [m/s^2].
    Acceleration,
    /// Difference of temperature [K].
    Temperature,
}

/// A unit that cells may be written in; in files it is its symbol.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(into = "&'static str")]
pub struct Unit {
    /// As written in headings.
    pub symbol: &'static str,
    /// What is measured in it.
    pub quantity: Dimension,
    /// How many of it one SI unit is; an integer wherever it can be, so that cells lose no digit.
    pub per_si: f64,
}

impl From<Unit> for &'static str {
    fn from(unit: Unit) -> &'static str {
        unit.symbol
    }
}

impl<'de> Deserialize<'de> for Unit {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Unit, D::Error> {
        let symbol = String::deserialize(from)?;
        let known = UNITS.iter().find(|unit| unit.symbol == symbol);
        known.copied().ok_or_else(|| D::Error::custom(format!("there is no unit {symbol}")))
    }
}

const fn unit(symbol: &'static str, quantity: Dimension, per_si: f64) -> Unit {
    Unit { symbol, quantity, per_si }
}

/// Every unit that is read; the first of each quantity and size is the one that is written.
pub const UNITS: &[Unit] = &[
    unit("s", Dimension::Time, 1.0),
    unit("sec", Dimension::Time, 1.0),
    unit("ms", Dimension::Time, 1e3),
    unit("min", Dimension::Time, 1.0 / 60.0),
    unit("h", Dimension::Time, 1.0 / 3600.0),
    unit("d", Dimension::Time, 1.0 / 86_400.0),
    unit("mm", Dimension::Length, 1e3),
    unit("m", Dimension::Length, 1.0),
    unit("cm", Dimension::Length, 1e2),
    unit("um", Dimension::Length, 1e6),
    unit("µm", Dimension::Length, 1e6),
    unit("μm", Dimension::Length, 1e6),
    unit("microstrain", Dimension::Strain, 1e6),
    unit("micro-strain", Dimension::Strain, 1e6),
    unit("µε", Dimension::Strain, 1e6),
    unit("με", Dimension::Strain, 1e6),
    unit("ue", Dimension::Strain, 1e6),
    unit("µm/m", Dimension::Strain, 1e6),
    unit("μm/m", Dimension::Strain, 1e6),
    unit("um/m", Dimension::Strain, 1e6),
    unit("mm/m", Dimension::Strain, 1e3),
    unit("m/m", Dimension::Strain, 1.0),
    unit("-", Dimension::Strain, 1.0),
    unit("MPa", Dimension::Stress, 1e-6),
    unit("kPa", Dimension::Stress, 1e-3),
    unit("Pa", Dimension::Stress, 1.0),
    unit("kN", Dimension::Force, 1e-3),
    unit("N", Dimension::Force, 1.0),
    unit("mrad", Dimension::Angle, 1e3),
    unit("rad", Dimension::Angle, 1.0),
    unit("deg", Dimension::Angle, 180.0 / std::f64::consts::PI),
    unit("km/h", Dimension::Speed, 3.6),
    unit("kmph", Dimension::Speed, 3.6),
    unit("m/s", Dimension::Speed, 1.0),
    unit("mm/s", Dimension::Speed, 1e3),
    unit("m/s2", Dimension::Acceleration, 1.0),
    unit("m/s^2", Dimension::Acceleration, 1.0),
    unit("g", Dimension::Acceleration, 1.0 / 9.806_65),
    unit("K", Dimension::Temperature, 1.0),
    unit("degC", Dimension::Temperature, 1.0),
    unit("°C", Dimension::Temperature, 1.0),
    unit("Deg C", Dimension::Temperature, 1.0),
];

impl Unit {
    /// The unit of that symbol. Capitals count, for MPa is not mPa; but Sec and MM are nothing else.
    pub fn named(symbol: &str) -> Option<Unit> {
        let symbol = symbol.trim();
        let exact = UNITS.iter().find(|unit| unit.symbol == symbol);
        // Where capitals are all that differs and no two units differ by capitals alone, the meaning is plain.
        let folded = || {
            let mut alike = UNITS.iter().filter(|unit| unit.symbol.to_lowercase() == symbol.to_lowercase());
            alike.next().filter(|_| alike.next().is_none() && !symbol.starts_with('m') && !symbol.starts_with('M'))
        };
        exact.or_else(folded).copied()
    }

    /// The unit in which a quantity is written where none is asked for: mm, microstrain, s, km/h.
    pub fn usual(quantity: Dimension) -> Unit {
        UNITS.iter().copied().find(|unit| unit.quantity == quantity).unwrap_or(UNITS[0])
    }

    /// A number in this unit as SI.
    pub fn to_si(&self, number: f64) -> f64 {
        number / self.per_si
    }

    /// An SI value in this unit.
    pub fn of_si(&self, value: f64) -> f64 {
        value * self.per_si
    }

    /// A number in words, four digits: "0.2700 mm".
    pub(crate) fn words(&self, value: f64) -> String {
        let number = self.of_si(value);
        let digits = if number == 0.0 || !number.is_finite() {
            2
        } else {
            (3 - number.abs().log10().floor() as i64).clamp(0, 9) as usize
        };
        format!("{number:.digits$} {}", self.symbol)
    }
}

/// Symbols that are read, for messages: "s, ms, mm, …".
pub(crate) fn symbols() -> String {
    let ascii = UNITS.iter().filter(|unit| unit.symbol.is_ascii());
    ascii.map(|unit| unit.symbol).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_mean_one_thing() {
        for (k, one) in UNITS.iter().enumerate() {
            assert!(UNITS[..k].iter().all(|other| other.symbol != one.symbol), "{} twice", one.symbol);
            assert_eq!(Unit::named(one.symbol), Some(*one));
        }
        assert_eq!(Unit::named("mPa"), None);
        assert_eq!(Unit::named(" S ").map(|unit| unit.symbol), Some("s"));
        assert_eq!(Unit::named("furlong"), None);
    }

    #[test]
    fn a_cell_keeps_its_digits_in_si() {
        let mm = Unit::named("mm").unwrap();
        assert_eq!(mm.to_si(0.27), 0.27 / 1000.0);
        let strain = Unit::usual(Dimension::Strain);
        assert_eq!(strain.of_si(strain.to_si(22.1)).to_string(), "22.1");
        assert_eq!(mm.words(-2.7e-4), "-0.2700 mm");
    }
}
